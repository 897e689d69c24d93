//! Grown layers of patches and cells.

use crate::grid::Field;
use crate::measure::{Spot, SpotErrors};
use crate::synth::areas::plan::AreaPlan;
use crate::synth::pattern::AreaPattern;

/// Number of laid cells that have an area of their own.
#[derive(Clone, Copy, Debug, Default)]
pub struct OwnPolygons {
    /// Number of cells that have an area of their own.
    pub own: usize,
    /// Number of cells that were laid.
    pub laid: usize,
}

/// Grown patches or cells.
#[derive(Clone)]
pub struct GrownAreas {
    /// The plan from which they grew.
    pub plan: AreaPlan,
    /// 0..1, areas above ½, on the grid. Of rosettes it is the pattern of their outlines, which is measured.
    pub field: Field,
    /// The pattern of rosettes, which is shown; `None` where areas are solid.
    pub rosettes: Option<Field>,
    /// Number of areas laid on the canvas that got less than nine tenths of their area.
    pub cramped: usize,
    /// Steps taken; none for patches.
    pub steps: u64,
    /// Mean width of the lines between cells, px; `None` for patches.
    pub gap: Option<f64>,
    /// Number of laid cells that have an area of their own; `None` for patches.
    pub own_polygons: Option<OwnPolygons>,
    /// All grown areas, also those cut by the border.
    pub spots: Vec<Spot>,
    /// Errors by region.
    pub errors: Vec<SpotErrors>,
    /// By region: the mean raggedness that was asked for at its whole areas, and their actual mean; `None` for a region without
    /// any.
    pub raggedness: Vec<Option<[f64; 2]>>,
}

impl GrownAreas {
    /// The pattern at any size.
    #[must_use]
    pub fn pattern(&self) -> AreaPattern {
        AreaPattern::new(self.shown())
    }

    /// The field that is shown.
    #[must_use]
    pub fn shown(&self) -> &Field {
        self.rosettes.as_ref().unwrap_or(&self.field)
    }
}
