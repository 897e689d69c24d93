//! Ragged edges of spots and stripes: the grown pattern is roughened until it has the raggedness that is asked for.

use std::sync::Arc;

use crate::attributes::Attributes;
use crate::grid::Field;
use crate::measure::{Regions, spot_raggedness_at, widths};
use crate::points::roughened::Roughening;
use crate::synth::edge_search::EdgeSearch;
use crate::synth::marks::GrownMarks;
use crate::synth::marks::grow::measured::measured;
use crate::synth::marks::grow::ragged_edges::Ragged;
use crate::synth::marks::plan::Plan;
use crate::synth::pattern::EDGE;

/// Cells in the radius of the smallest marks, so that the finest lobes of the noise have four.
const CELLS: f64 = 12.0;
/// Most cells of that grid, as a multiple of the canvas' px: finer lobes cannot be seen.
const MOST: f64 = 1.0;
/// Combined with the layer's seed, so that the noise of the edges has random numbers of its own.
pub const SEED: u64 = 0x7261_6767_6564_3A31;

/// A layer whose edges are being made ragged.
pub struct RaggedSearch {
    layer: GrownMarks,
    /// The raggedness that is asked for.
    asked: f64,
    smooth: Field,
    roughening: Roughening,
    search: EdgeSearch<Field>,
}

impl RaggedSearch {
    /// Prepares the noise of the edges of `layer`, which are to have this raggedness.
    #[must_use]
    pub fn new(layer: GrownMarks, asked: f64, seed: u64) -> Self {
        let plan = &layer.plan;
        let [width, height] = finer(plan);
        let smooth = layer.whole_pattern().field(width, height);
        let radius = |at: [f64; 2]| radius(&plan.lookup.map.at(at));
        let roughening = Roughening::new(&smooth, &radius, seed ^ SEED);
        Self { layer, asked, smooth, roughening, search: EdgeSearch::new(asked - 1.0) }
    }

    /// The share of the tries that are done, 0..1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        self.search.progress()
    }

    /// Cells that a try measures.
    #[must_use]
    pub fn cells(&self) -> usize {
        self.smooth.values.len()
    }

    /// Tries another amplitude. Returns whether there may be a better one.
    pub fn advance(&mut self) -> bool {
        let plan = &self.layer.plan;
        let radius = |at: [f64; 2]| radius(&plan.lookup.map.at(at));
        let rough = self.roughening.by(&self.smooth, &radius, self.search.amount() as f32);
        let excess = mean(plan, &self.smooth, &rough).map_or(0.0, |got| got - 1.0);
        self.search.tried(rough, excess)
    }

    /// The layer with the best edges, measured anew.
    #[must_use]
    pub fn complete(self) -> GrownMarks {
        let Self { layer, asked, smooth, search, .. } = self;
        let plan = &layer.plan;
        let Some(rough) = search.best() else { return layer };
        let got = by_region(plan, &smooth, &rough);
        let added = rough.values.iter().zip(&smooth.values).map(|(rough, smooth)| rough - smooth).collect();
        let added = Field::new(&smooth.grid(), added);
        // Ragged stripes have the width of smooth ones of equal area, which has been measured.
        let found = if plan.lookup.system.is_striped() {
            None
        } else {
            Some(measured(plan, layer.corrections.least_area(), &rough))
        };
        let ragged = Some(Arc::new(Ragged { added, asked, got }));
        let measured = found.unwrap_or_else(|| layer.measured.clone());
        GrownMarks { ragged, measured, ..layer }
    }
}

/// Half of the width of marks, px.
fn radius(wanted: &Attributes) -> f64 {
    match wanted {
        Attributes::Spots(spots) => (spots.area / std::f64::consts::PI).sqrt(),
        Attributes::Stripes(stripes) => {
            let period = stripes.wavelength.unwrap_or(2.0 * stripes.width);
            // The gaps of wide stripes limit how far edges can move.
            0.5 * stripes.width.min((period - stripes.width).max(0.3 * stripes.width))
        }
    }
}

/// Cells along x and y that show the finest lobes of the smallest marks.
fn finer(plan: &Plan) -> [usize; 2] {
    let (layout, grid) = (plan.lookup.map.layout(), plan.lookup.grid.size);
    let least = plan.lookup.map.samples().iter().map(radius).fold(f64::INFINITY, f64::min);
    [0, 1].map(|axis| {
        let wanted = (layout.size[axis] * CELLS / least).ceil() as usize;
        wanted.clamp(grid[axis], grid[axis].max((MOST * layout.size[axis]) as usize))
    })
}

/// The raggedness of the layer: for spots the mean of the whole ones; for stripes (contour ÷ contour before)².
fn mean(plan: &Plan, smooth: &Field, rough: &Field) -> Option<f64> {
    let found: Vec<f64> = if plan.lookup.system.is_striped() {
        stripes(smooth, rough, Regions::ONE).into_iter().flatten().collect()
    } else {
        spot_raggedness_at(rough, EDGE).into_iter().map(|(_, raggedness)| raggedness).collect()
    };
    (!found.is_empty()).then(|| found.iter().sum::<f64>() / found.len() as f64)
}

/// The raggedness of each region.
fn by_region(plan: &Plan, smooth: &Field, rough: &Field) -> Vec<Option<f64>> {
    let layout = plan.lookup.map.layout();
    let regions = Regions::Grid(layout);
    if plan.lookup.system.is_striped() {
        return stripes(smooth, rough, regions);
    }
    let mut sums = vec![[0.0; 2]; layout.len()];
    for (center, raggedness) in spot_raggedness_at(rough, EDGE) {
        let [count, sum] = &mut sums[regions.of(center)];
        (*count, *sum) = (*count + 1.0, *sum + raggedness);
    }
    sums.into_iter().map(|[count, sum]| (count > 0.0).then(|| sum / count)).collect()
}

/// (contour ÷ contour before)² by region: width is 2 × area ÷ contour, and the area does not change.
fn stripes(smooth: &Field, rough: &Field, regions: Regions) -> Vec<Option<f64>> {
    let [before, after] = [smooth, rough].map(|field| widths(field, EDGE, regions));
    let ratio = |(before, after): (Option<f64>, Option<f64>)| Some((before? / after?).powi(2));
    before.into_iter().zip(after).map(ratio).collect()
}
