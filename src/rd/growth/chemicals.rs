//! The concentrations of a growth.

use crate::rd::maps::Maps;
use crate::rd::plane::{Plane, RowLayout};
use crate::rd::systems::turing_spots;

/// Each chemical twice: as it is, and room for the next step.
#[derive(Clone, Debug)]
pub(super) enum Chemicals {
    /// Two.
    Two(Box<[[Plane; 2]; 2]>),
    /// Two, and the decay of each cell.
    Three(Box<[[Plane; 3]; 2]>),
    /// Five.
    Five(Box<[[Plane; 5]; 2]>),
}

impl Chemicals {
    /// How many there are, with what is kept beside them.
    pub(super) fn count(&self) -> usize {
        match self {
            Self::Two(_) => 2,
            Self::Three(_) => 3,
            Self::Five(_) => 5,
        }
    }

    /// Two.
    pub(super) fn two(planes: [Plane; 2]) -> Self {
        Self::Two(Box::new([planes.clone(), planes]))
    }

    /// These two of Turing's with the decay that `maps` gives each cell.
    pub(super) fn with_decay([a, b]: [Plane; 2], maps: &Maps, grid: RowLayout) -> Self {
        let mut decay = Plane::flat(grid, turing_spots::BETA);
        for (y, row) in maps.decay_noise.chunks_exact(maps.grid.size[0]).enumerate() {
            let row: Vec<f32> = row.iter().map(|off| turing_spots::BETA + off).collect();
            decay.set_row(y, &row);
        }
        let planes = [a, b, decay];
        Self::Three(Box::new([planes.clone(), planes]))
    }

    /// Five.
    pub(super) fn five(planes: [Plane; 5]) -> Self {
        Self::Five(Box::new([planes.clone(), planes]))
    }
}
