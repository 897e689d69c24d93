//! What has grown on layers of patches and cells.

use crate::grid::Field;
use crate::measure::{Spot, SpotErrors};
use crate::synth::areas::plan::AreaPlan;
use crate::synth::pattern::AreaPattern;

/// How many cells have an area of their own.
#[derive(Clone, Copy, Debug, Default)]
pub struct OwnPolygons {
    /// So many have.
    pub own: usize,
    /// So many were laid.
    pub laid: usize,
}

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
    /// How many of the laid cells have an area of their own; `None` of patches.
    pub own_polygons: Option<OwnPolygons>,
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
