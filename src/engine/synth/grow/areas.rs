//! What has grown on layers of patches and cells.

use std::ops::Range;

use crate::grid::resample::Spline;
use crate::grid::{Edges, Field};
use crate::measure::{Spot, SpotErrors};
use crate::synth::plan::areas::AreaPlan;

/// Grown patches or cells.
#[derive(Clone)]
pub struct GrownAreas {
    /// How they were planned.
    pub plan: AreaPlan,
    /// 0..1, areas above ½, on the grid.
    pub field: Field,
    /// How many that were laid on the canvas have less than nine tenths of their area.
    pub cramped: usize,
    /// Steps taken; none by patches.
    pub steps: u64,
    /// Mean width of the lines between cells, px; `None` of patches.
    pub gap: Option<f64>,
    /// How many of the laid cells have an area of their own, and how many were laid; `None` of patches.
    pub own_cells: Option<[usize; 2]>,
    /// All of them, cut ones too.
    pub spots: Vec<Spot>,
    /// Errors by region.
    pub errors: Vec<SpotErrors>,
    /// The mean raggedness that was asked for at the whole ones of each region, and their own; `None` without any.
    pub raggedness: Vec<Option<[f64; 2]>>,
}

impl GrownAreas {
    /// The pattern at any size.
    #[must_use]
    pub fn pattern(&self) -> AreaPattern {
        AreaPattern::new(&self.field)
    }
}

/// The pattern of areas at any size.
pub struct AreaPattern {
    grid: [usize; 2],
    extent: [f64; 2],
    edges: Edges,
    surface: Spline,
}

impl AreaPattern {
    /// The pattern of a field that is above ½ in areas.
    #[must_use]
    pub fn new(field: &Field) -> Self {
        Self {
            grid: [field.width, field.height],
            extent: field.extent(),
            edges: field.edges,
            surface: Spline::new(field),
        }
    }

    /// Cells along x and y of the grid that they grew on.
    #[must_use]
    pub fn grid(&self) -> [usize; 2] {
        self.grid
    }

    /// Rows `rows` at `width` × `height` px over the whole canvas.
    #[must_use]
    pub fn rows(&self, rows: Range<usize>, width: usize, height: usize) -> Vec<f32> {
        let mut values = self.surface.rows(rows, width, height);
        // The spline overshoots where the field reaches 0 and 1.
        values.iter_mut().for_each(|value| *value = value.clamp(0.0, 1.0));
        values
    }

    /// The whole pattern at `width` × `height` px.
    #[must_use]
    pub fn field(&self, width: usize, height: usize) -> Field {
        let cell = [self.extent[0] / width as f64, self.extent[1] / height as f64];
        Field { width, height, cell, edges: self.edges, values: self.rows(0..height, width, height) }
    }
}
