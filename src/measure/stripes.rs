//! Stripes: width and wavelength from areas and contour lengths, direction from the structure tensor.

use super::directions::Directions;
use crate::grid::Field;
use crate::measure::marching_squares::parts;
use crate::measure::supersampled_grid::SupersampledGrid;

/// What the stripes of a field look like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StripeStatistics {
    /// 2 × area ÷ contour length, px; the contour along the frame left out.
    pub width: f64,
    /// Coherence-weighted axial mean of the direction along the stripes, degrees in [0, 180).
    pub angle: f64,
    /// Resultant length of the local directions, 0..1: 1 = straight parallel stripes.
    pub alignment: f64,
    /// Mean coherence of the structure tensor, 0..1: 1 = each place has one clear direction.
    pub coherence: f64,
    /// 2 × canvas area ÷ contour length, px: of parallel stripes the distance from one to the next.
    pub wavelength: f64,
    /// Share of the canvas that is above the level, 0..1.
    pub share: f64,
}

/// Area and contour length of a square or a region.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Tally {
    pub(super) area: f64,
    pub(super) contour: f64,
}

/// Statistics of the stripes above `level`; `None` where no contour is found.
#[must_use]
pub fn stripes(field: &Field, level: f32) -> Option<StripeStatistics> {
    let [tally] = tallies(field, level, 1, |_| 0)[..] else { return None };
    let [width, height] = field.extent();
    let canvas = width * height;
    if tally.contour <= 0.0 {
        return None;
    }
    let wavelength = wavelength(field, tally.contour);
    let directions = Directions::measure(field, wavelength);
    let (angle, alignment) = directions.mean()?;
    Some(StripeStatistics {
        width: 2.0 * tally.area / tally.contour,
        angle,
        alignment,
        coherence: directions.coherence(),
        wavelength,
        share: tally.area / canvas,
    })
}

/// Wavelength of stripes with this contour length, px.
pub(super) fn wavelength(field: &Field, contour: f64) -> f64 {
    let [width, height] = field.extent();
    2.0 * width * height / contour
}

/// Mean width (px) of what is above `level` in each of `regions` regions: 2 × area ÷ contour length within it,
/// without the frame; `None` where a region has no contour. `region_of` takes px and must answer below `regions`.
#[must_use]
pub fn widths(
    field: &Field,
    level: f32,
    regions: usize,
    region_of: impl Fn([f64; 2]) -> usize + Sync,
) -> Vec<Option<f64>> {
    let tallies = tallies(field, level, regions, region_of);
    tallies.iter().map(|tally| (tally.contour > 0.0).then(|| 2.0 * tally.area / tally.contour)).collect()
}

/// Nodes across a stripe: with so many, widths are exact to 0.1 % (`tests/ruler.rs`).
const ACROSS: f64 = 12.0;
/// Nodes a cell each way at most: they are enough for stripes of four cells.
const FACTOR: f64 = 3.0;

/// Area above the level and contour length by region, px² and px.
pub(super) fn tallies(
    field: &Field,
    level: f32,
    regions: usize,
    region_of: impl Fn([f64; 2]) -> usize + Sync,
) -> Vec<Tally> {
    let [coarse] = tallied(field, level, 1, |_| 0, 1)[..] else { return Vec::new() };
    let across = 2.0 * coarse.area / coarse.contour / (field.cell[0] * field.cell[1]).sqrt();
    let factor = (ACROSS / across).ceil().clamp(1.0, FACTOR) as usize;
    tallied(field, level, regions, region_of, factor)
}

/// The same on `factor` nodes a cell.
fn tallied(
    field: &Field,
    level: f32,
    regions: usize,
    region_of: impl Fn([f64; 2]) -> usize + Sync,
    factor: usize,
) -> Vec<Tally> {
    let nodes = SupersampledGrid::new(field, factor);
    let n = nodes.xs.len();
    let bands = nodes.bands(|ys, values, _| {
        let mut tallies = vec![Tally::default(); regions];
        for (ys, rows) in ys.windows(2).zip(values.chunks_exact(n).collect::<Vec<_>>().windows(2)) {
            strip(&nodes.xs, [ys[0], ys[1]], [rows[0], rows[1]], level, |place, area, contour| {
                let tally = &mut tallies[region_of(place)];
                tally.area += area;
                tally.contour += contour;
            });
        }
        tallies
    });
    let mut tallies = vec![Tally::default(); regions];
    for band in bands {
        for (tally, more) in tallies.iter_mut().zip(band) {
            tally.area += more.area;
            tally.contour += more.contour;
        }
    }
    tallies
}

/// [`LOOKED_AT`] if that many values from `first` on are not above the level, else 0.
fn outside(values: &[f32], first: usize, level: f32) -> usize {
    let Some(block) = values[first..].first_chunk::<LOOKED_AT>() else { return 0 };
    // Without a branch, so that all are compared at once.
    if block.iter().fold(true, |outside, value| outside & (*value <= level)) { LOOKED_AT } else { 0 }
}

/// Values that are compared at once.
const LOOKED_AT: usize = 16;

/// Calls `found` with the centre, area and contour length of each square of a strip that is not all outside.
fn strip(
    xs: &[f64],
    [top, bottom]: [f64; 2],
    [above, below]: [&[f32]; 2],
    level: f32,
    mut found: impl FnMut([f64; 2], f64, f64),
) {
    let (center, height) = (0.5 * (top + bottom), bottom - top);
    let mut i = 0;
    while i + 1 < xs.len() {
        let outside = outside(above, i, level).min(outside(below, i, level));
        if outside > 1 {
            i += outside - 1;
            continue;
        }
        let x = [xs[i], xs[i + 1]];
        let v = [above[i], above[i + 1], below[i + 1], below[i]];
        i += 1;
        let inside = v.iter().filter(|v| **v > level).count();
        let place = [0.5 * (x[0] + x[1]), center];
        if inside == 4 {
            found(place, (x[1] - x[0]) * height, 0.0);
        } else if inside > 0 {
            let v = v.map(|v| f64::from(v) - f64::from(level));
            parts([x[0], top], [x[1] - x[0], height], v, |part| {
                found(place, part.moments.area, part.contour);
            });
        }
    }
}
