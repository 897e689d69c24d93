//! The shapes that a grown layer gets after its growth: stripes whose width varies along them.
//!
//! What the report says of a layer was measured before.

use crate::document::LayerOptions;
use crate::grid::Field;
use crate::points::level::share_above;
use crate::points::stripe_variation::{StripeVariation, varied};
use crate::synth::pattern::{EDGE, PatternRows};

/// Cells in half of the mean width of a stripe, so that its tips are pointed.
const CELLS: f64 = 6.0;
/// Memory of a px of the canvas, bytes: depths, directions, two fields of noise, widths, and their copies while they are blurred.
const BYTES: f64 = 100.0;
/// Combined with the layer's seed, so that shapes have random numbers of their own.
const SEED: u64 = 0x7661_7279_696E_6731;

/// How these options vary the width of stripes; `None` where they do not.
fn variation(options: &LayerOptions) -> Option<StripeVariation> {
    let LayerOptions { vary, double, .. } = *options;
    let variation = StripeVariation { vary, double };
    (!variation.is_none()).then_some(variation)
}

/// Bytes of memory that the shapes of a layer with these options need on a canvas of `size` px.
#[must_use]
pub fn bytes(options: &LayerOptions, size: [f64; 2]) -> f64 {
    variation(options).map_or(0.0, |_| BYTES * size[0] * size[1])
}

/// The `pattern` of a grown layer with the shapes of its `options`; `None` where it stays.
#[must_use]
pub fn shaped(pattern: &dyn PatternRows, options: &LayerOptions, seed: u64) -> Option<Field> {
    let by = variation(options)?;
    let grid = pattern.grid();
    let coarse = pattern.field(grid[0], grid[1]);
    // 2 × area ÷ contour, in cells, as the mean width of a stripe.
    let width = 2.0 * share_above(&coarse, EDGE) * coarse.values.len() as f64 / contour(&coarse).max(1.0);
    let finer = (2.0 * CELLS / width).max(1.0);
    let extent = coarse.extent();
    let size = [0, 1].map(|axis| {
        let px = extent[axis].round() as usize;
        ((grid[axis] as f64 * finer).ceil() as usize).clamp(grid[axis], grid[axis].max(px))
    });
    Some(varied(&pattern.field(size[0], size[1]), &by, seed ^ SEED))
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
