//! Stripes: width and wavelength from areas and contour lengths, direction from the structure tensor.

use super::directions::Directions;
use crate::grid::Field;
use crate::measure::marching_squares::parts;
use crate::measure::node_mask::{self, Squares, mask};
use crate::measure::regions::Regions;
use crate::measure::supersampled_grid::SupersampledGrid;

/// Statistics of the stripes of a field.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StripeStatistics {
    /// 2 × area ÷ contour length, px; without the contour along the frame.
    pub width: f64,
    /// Coherence-weighted axial mean of the direction along the stripes, degrees in [0, 180).
    pub angle: f64,
    /// Resultant length of the local directions, 0..1: 1 = straight parallel stripes.
    pub alignment: f64,
    /// Mean coherence of the structure tensor, 0..1: 1 = each place has one clear direction.
    pub coherence: f64,
    /// 2 × canvas area ÷ contour length, px: for parallel stripes the distance from one to the next.
    pub wavelength: f64,
    /// Share of the canvas that is above the level, 0..1.
    pub share: f64,
}

/// Area above a level and length of the contour without the frame, in a square or a region.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Tally {
    /// Area above the level, px².
    pub area: f64,
    /// Length of its contour, px.
    pub contour: f64,
}

impl Tally {
    /// Mean width, px: 2 × area ÷ contour length; `None` without a contour.
    #[must_use]
    pub fn width(&self) -> Option<f64> {
        (self.contour > 0.0).then(|| 2.0 * self.area / self.contour)
    }
}

/// Statistics of the stripes above `level`; `None` if no contour is found.
#[must_use]
pub fn stripes(field: &Field, level: f32) -> Option<StripeStatistics> {
    let [tally] = tallies(field, level, Regions::ONE)[..] else { return None };
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

/// Mean width (px) of the areas above `level` in each of the `regions`; `None` if a region has no contour.
#[must_use]
pub fn widths(field: &Field, level: f32, regions: Regions) -> Vec<Option<f64>> {
    tallies(field, level, regions).iter().map(Tally::width).collect()
}

/// Area (px²) above `level` in each of the `regions`.
#[must_use]
pub fn areas(field: &Field, level: f32, regions: Regions) -> Vec<f64> {
    let tallies = tallied(field, level, regions, FACTOR as usize);
    tallies.iter().map(|tally| tally.area).collect()
}

/// Nodes across a stripe with which widths are accurate to 0.1 % (`tests/ruler`).
const ACROSS: f64 = 12.0;
/// Most nodes per cell along each side: enough for stripes of four cells.
const FACTOR: f64 = 3.0;

/// Area above `level` and contour length in each of the `regions`.
#[must_use]
pub fn tallies(field: &Field, level: f32, regions: Regions) -> Vec<Tally> {
    let coarse = tallied(field, level, regions, 1);
    let (area, contour) = coarse.iter().fold((0.0, 0.0), |sum, one| (sum.0 + one.area, sum.1 + one.contour));
    let across = 2.0 * area / contour / (field.cell[0] * field.cell[1]).sqrt();
    let factor = (ACROSS / across).ceil().clamp(1.0, FACTOR) as usize;
    if factor == 1 { coarse } else { tallied(field, level, regions, factor) }
}

/// Area above `level` and contour length in each of the `regions`, on `factor` nodes per cell.
fn tallied(field: &Field, level: f32, regions: Regions, factor: usize) -> Vec<Tally> {
    let nodes = SupersampledGrid::new(field, factor);
    let n = nodes.xs.len();
    let centers = nodes.xs.windows(2).map(|xs| 0.5 * (xs[0] + xs[1]));
    let regions_at = regions.at(centers.collect());
    let bands = nodes.bands(|ys, values, _| {
        let mut tallies = vec![Tally::default(); regions.count()];
        let (mut masks, mut rows) = ([Vec::new(), Vec::new()], values.chunks_exact(n));
        let Some(mut above) = rows.next() else { return tallies };
        mask(above, level, &mut masks[0]);
        for (ys, below) in ys.windows(2).zip(rows) {
            mask(below, level, &mut masks[1]);
            let of_rows = [&masks[0][..], &masks[1]];
            let region = regions_at.row(0.5 * (ys[0] + ys[1]));
            strip(&nodes.xs, [ys[0], ys[1]], [above, below], of_rows, level, &region, &mut tallies);
            above = below;
            masks.swap(0, 1);
        }
        tallies
    });
    let mut tallies = vec![Tally::default(); regions.count()];
    for band in bands {
        for (tally, more) in tallies.iter_mut().zip(band) {
            tally.area += more.area;
            tally.contour += more.contour;
        }
    }
    tallies
}

/// Adds the area and contour length of each square of a strip to the tally of its `region`. `masks` are those of its two
/// rows.
fn strip(
    xs: &[f64],
    [top, bottom]: [f64; 2],
    [above, below]: [&[f32]; 2],
    masks: [&[u64]; 2],
    level: f32,
    region: &impl Fn(usize) -> usize,
    tallies: &mut [Tally],
) {
    let height = bottom - top;
    node_mask::squares(masks[0], masks[1], xs.len(), |squares| match squares {
        Squares::Full(squares) => {
            let mut first = squares.start;
            while first < squares.end {
                let own = region(first);
                let after = (first + 1..squares.end).find(|i| region(*i) != own).unwrap_or(squares.end);
                tallies[own].area += (xs[after] - xs[first]) * height;
                first = after;
            }
        }
        Squares::Cut(i) => {
            let v = [above[i], above[i + 1], below[i + 1], below[i]];
            let v = v.map(|v| f64::from(v) - f64::from(level));
            let tally = &mut tallies[region(i)];
            parts([xs[i], top], [xs[i + 1] - xs[i], height], v, |part| {
                tally.area += part.moments.area;
                tally.contour += part.contour;
            });
        }
    });
}
