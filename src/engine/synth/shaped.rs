//! The shapes that a grown layer gets after its growth: stripes whose width varies along them, and ragged edges of the stripes that
//! are not grown by a system of spots and stripes (that one makes them itself, and measures them by region).
//!
//! What the report says of a layer was measured before.

use crate::attributes::{Attributes, Stripes};
use crate::document::{LayerOptions, RaggedChoice};
use crate::grid::{Domain, Field};
use crate::measure::{Regions, widths};
use crate::points::level::share_above;
use crate::points::roughened::Roughening;
use crate::points::stripe_variation::{StripeVariation, varied};
use crate::points::stripe_widths::{StripeWidths, depths};
use crate::synth::edge_search::EdgeSearch;
use crate::synth::marks::plan::raggedness::excess;
use crate::synth::pattern::{self, EDGE, PatternRows};

/// Cells in half of the mean width of a stripe: pointed tips need 6, the finest lobes of ragged edges 12.
const CELLS: [f64; 2] = [6.0, 12.0];
/// Memory of a px of the canvas, bytes: depths, directions, two fields of noise, widths, and their copies while they are blurred.
const BYTES: f64 = 100.0;
/// Combined with the layer's seed, so that shapes have random numbers of their own.
const SEED: u64 = 0x7661_7279_696E_6731;

/// The shapes that the stripes of a layer get.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shapes {
    variation: StripeVariation,
    /// σ of the edges; 0 = as they grow.
    ragged: f64,
}

impl Shapes {
    /// The shapes that these options ask for; `None` where there are none. `ragged`: whether its edges are made ragged here.
    #[must_use]
    pub fn of(options: &LayerOptions, ragged: bool) -> Option<Self> {
        let variation = StripeVariation { vary: options.vary, double: options.double };
        let ragged = match options.ragged {
            RaggedChoice::Given(sigma) if ragged => sigma,
            _ => 0.0,
        };
        (!variation.is_none() || ragged > 0.0).then_some(Self { variation, ragged })
    }

    /// Bytes of memory that they need on a canvas of `size` px.
    #[must_use]
    pub fn bytes(size: [f64; 2]) -> f64 {
        BYTES * size[0] * size[1]
    }

    /// The `pattern` of a grown layer with these shapes.
    #[must_use]
    pub fn applied(&self, pattern: &dyn PatternRows, seed: u64) -> Field {
        let grid = pattern.grid();
        let coarse = pattern.field(grid[0], grid[1]);
        // 2 × area ÷ contour, in cells, as the mean width of a stripe.
        let width = 2.0 * share_above(&coarse, EDGE) * coarse.values.len() as f64 / contour(&coarse).max(1.0);
        let by = (2.0 * CELLS[usize::from(self.ragged > 0.0)] / width).max(1.0);
        let stripes = pattern::finer(pattern, &coarse, by);
        let stripes = if self.ragged > 0.0 { roughened(stripes, self.ragged, seed ^ SEED) } else { stripes };
        varied(&stripes, &self.variation, seed ^ SEED)
    }
}

/// The length of the edges, in cells: of steps along a direction that all are equally frequent, π ÷ 4 is the length.
fn contour(field: &Field) -> f64 {
    let above = |x: usize, y: usize| field.get(x as isize, y as isize) >= EDGE;
    let differ = |x: usize, y: usize| {
        let here = above(x, y);
        f64::from(u8::from(here != above(x + 1, y))) + f64::from(u8::from(here != above(x, y + 1)))
    };
    let steps: f64 = (0..field.height).map(|y| (0..field.width).map(|x| differ(x, y)).sum::<f64>()).sum();
    steps * std::f64::consts::FRAC_PI_4
}

/// The `stripes` with edges of this σ.
fn roughened(stripes: Field, sigma: f64, seed: u64) -> Field {
    let Some(depths) = depths(&stripes) else { return stripes };
    let grid = stripes.grid();
    let found = StripeWidths::new(&depths, &grid);
    let width = 2.0 * found.mean[0];
    let asked =
        excess(&Attributes::Stripes(Stripes { width, wavelength: Some(found.period()), angle: 0.0 }), sigma);
    if asked <= 0.0 {
        return stripes;
    }
    let canvas = grid.bounds_px();
    let radius = |at: [f64; 2]| {
        let cell = grid.cell_at(grid.to_cells(canvas.inside(at)));
        let [half, gap] = [0, 1].map(|side| f64::from(found.halves[side][cell]));
        // The gaps of wide stripes limit how far edges can move.
        half.min(gap.max(0.3 * half)).max(grid.px_a_cell())
    };
    let roughening = Roughening::new(&stripes, &radius, seed);
    let mut search = EdgeSearch::new(asked);
    loop {
        let rough = roughening.by(&stripes, &radius, search.amount() as f32);
        // (contour ÷ contour before)²: width is 2 × area ÷ contour, and the area does not change.
        let [before, after] = [&stripes, &rough].map(|field| widths(field, EDGE, Regions::ONE)[0]);
        let raggedness = before.zip(after).map_or(1.0, |(before, after)| (before / after).powi(2));
        if !search.tried(rough, raggedness - 1.0) {
            return search.best().unwrap_or(stripes);
        }
    }
}
