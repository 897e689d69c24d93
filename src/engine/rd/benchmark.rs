//! Cases that `dapple bench` and the benches step: each system with tensors of different aspect.

use crate::grid::{Domain, Edges};
use crate::rd::{Growth, ParameterField, Parameters, System};
use std::f64::consts::TAU;

/// A system and the anisotropy of its diffusion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Case {
    /// The system.
    pub system: System,
    /// Minor ÷ major axis of the tensor: 1 = isotropic; below 1, its direction varies over the grid.
    pub stretch: f32,
}

/// Concentrations of a seamless pattern of 256 × 256 cells.
#[derive(Clone, Debug)]
pub struct Start(Vec<Vec<f32>>);

/// Cells along each side of a [`Start`]: quick to grow (0.1 s), and a divisor of the usual sizes.
const SIDE: usize = 256;
/// Steps of a [`Start`]: after them the noise has decayed, but the pattern has not settled.
const STEPS: u64 = 64;

impl Case {
    /// All cases.
    pub const ALL: [Self; 9] = {
        let [a, b, c] = [System::TURING_SPOTS, System::MEINHARDT_SPOTS, System::MEINHARDT_STRIPES];
        [
            Self::new(a, 1.0),
            Self::new(a, 0.5),
            Self::new(a, 0.3),
            Self::new(b, 1.0),
            Self::new(b, 0.5),
            Self::new(b, 0.3),
            Self::new(c, 1.0),
            Self::new(c, 0.5),
            Self::new(c, 0.3),
        ]
    };

    /// The name of the case, such as `turing-spots/isotropic` or `meinhardt-stripes/aspect-0.5`.
    #[must_use]
    pub fn name(&self) -> String {
        format!("{}/{}", self.system.name(), self.diffusion())
    }

    /// `isotropic`, or `aspect-` and the stretch.
    #[must_use]
    pub fn diffusion(&self) -> String {
        if self.stretch < 1.0 { format!("aspect-{}", self.stretch) } else { "isotropic".to_owned() }
    }

    /// Parameters with usual rates (`docs/facts.md` A, B, C: spots of about 40 cells, wavelengths of 13). The direction of the
    /// tensor varies seamlessly over all directions.
    #[must_use]
    pub fn maps(&self, size: usize) -> ParameterField {
        let rate = self.system.definition().usual_rate;
        let parameters = Parameters { rate, ratio: 20.0, stretch: self.stretch, direction: 0.0, pitch: 1.0 };
        let mut maps = ParameterField::uniform([size, size], Edges::Wrap, parameters);
        if self.stretch < 1.0 {
            for (cell, parameters) in maps.parameters.iter_mut().enumerate() {
                let [x, y] = [cell % size, cell / size].map(|at| at as f64 / size as f64);
                parameters.direction = (180.0 * x + 90.0 * libm::sin(TAU * y)) as f32;
            }
        }
        maps
    }

    /// A developing pattern.
    #[must_use]
    pub fn start(&self) -> Start {
        let round = Self { stretch: 1.0, ..*self };
        let mut growth = Growth::new(self.system, &round.maps(SIDE), 1);
        growth.advance(STEPS);
        Start(growth.concentrations())
    }

    /// A growth on `maps` by Euler steps that continues from `start`, tiled as often as needed. `None` if `start` belongs to
    /// another system.
    #[must_use]
    pub fn growth(&self, start: &Start, maps: &ParameterField) -> Option<Growth> {
        let tiled = |cells: &Vec<f32>| {
            let cell = |at: usize| {
                let [column, row] = maps.domain.position(at);
                cells[(row % SIDE) * SIDE + column % SIDE]
            };
            (0..maps.domain.cells()).map(cell).collect()
        };
        let concentrations: Vec<Vec<f32>> = start.0.iter().map(tiled).collect();
        Some(Growth::resumed(self.system, maps, concentrations)?.with_stages(1))
    }

    const fn new(system: System, stretch: f32) -> Self {
        Self { system, stretch }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_direction_occurs_and_there_is_no_seam() {
        let case = Case { system: System::TURING_SPOTS, stretch: 0.5 };
        let maps = case.maps(90);
        let mut seen = [false; 18];
        for (cell, p) in maps.parameters.iter().enumerate() {
            seen[(p.direction.rem_euclid(180.0) / 10.0) as usize % 18] = true;
            let below = &maps.parameters[(cell + 90) % (90 * 90)];
            let turn = (p.direction - below.direction).rem_euclid(180.0);
            assert!(turn.min(180.0 - turn) < 10.0, "{cell}: {turn}");
        }
        assert_eq!(seen, [true; 18]);
    }

    #[test]
    fn a_start_fits_grids_of_any_size_and_only_its_own_system() {
        let [spots, stripes] = [Case::ALL[0], Case::ALL[8]];
        let start = spots.start();
        let growth = spots.growth(&start, &spots.maps(300)).expect("two chemicals");
        let cells = &growth.concentrations()[0];
        assert_eq!(cells.len(), 300 * 300);
        assert_eq!(cells[5 * 300 + 7], cells[(5 + SIDE) * 300 + 7 + SIDE]);
        assert!(stripes.growth(&start, &stripes.maps(16)).is_none());
    }
}
