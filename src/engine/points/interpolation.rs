//! Values at points → field: partition of unity parametrics (PUPs).
//!
//! With the axes αᵢⱼ from a point cᵢ to its Delaunay neighbours and the axis length L, at a place u:
//!
//! ```text
//! p   = clamp((u − cᵢ)·αᵢⱼ ÷ (L·|αᵢⱼ|²), 0, 1)          the projection
//! A(p) = (1 − p)²·(1 + 2p)                              axial weight, eq. 1
//! Wᵢ  = Πⱼ A(p)                                          eq. 2
//! T   = Σᵢ Tᵢ·Wᵢ ÷ Σᵢ Wᵢ                                 eq. 3
//! Wᵢ′ = Wᵢ^(1 − K) for K ≥ 0, else Wᵢ^(1 ÷ (1 + K)),    eq. 4
//!       K = ε·(u − cᵢ)·vᵢ ÷ |u − cᵢ|
//! ```
//!
//! Wᵢ is above 0 where p < 1 for all axes: in the Voronoi cell of cᵢ (p < ½ at L = 1) scaled by 2L about cᵢ. The cells cover the
//! plane exactly once, so each place lies in 4L² supports on average, whatever the number of points.
//!
//! Along a row of px each p is linear, and the px inside a support are one run. Only these are computed: the ends of the run need
//! one division for each axis and row, and the axes that point away from the whole run are left out.
//!
//! Rows are computed in bands on all threads. Each band adds the points up in order, so that the result is the same to the last bit
//! for any number of threads and bands. Images of a point beyond a border that wraps are added like points, so that tiles have no
//! seam.

use std::ops::Range;

use rayon::prelude::*;

use super::delaunay::Delaunay;
use crate::grid::{Field, Grid, exp, ln};

/// Settings of the interpolation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weights<'a> {
    /// L, the length of the axes in edges, [`Weights::SHORTEST`]–[`Weights::LONGEST`]. At 1 the field has the exact values at the
    /// points; larger lengths smooth it.
    pub length: f64,
    /// Directions in which points shift their weight.
    pub orientation: Option<Orientation<'a>>,
}

/// The shift of eq. 4.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orientation<'a> {
    /// ε, 0–1. Share of px whose label changes under the paper's rule of the highest weight: 3 % at .1, 15–20 % at .5, 37–44 % at
    /// .9.
    pub strength: f64,
    /// vᵢ: for each point the component in the plane of a unit vector. [0, 0] shifts nothing.
    pub directions: &'a [[f64; 2]],
}

impl Default for Weights<'_> {
    fn default() -> Self {
        Self { length: 1.0, orientation: None }
    }
}

impl Weights<'_> {
    /// At ½ the supports touch but do not overlap; below, some places have no weight.
    pub const SHORTEST: f64 = 0.6;
    /// The time grows with L²: at 4 there are sixty-four supports for each px.
    pub const LONGEST: f64 = 4.0;
}

/// Rows in a band, the same for any number of threads.
const BAND: usize = 16;

/// The interpolated field of `values`, one for each point of `graph`, on `grid`, whose canvas is the graph's extent.
///
/// If there are no points, the field is 0. Missing values are 0.
#[must_use]
pub fn interpolate(graph: &Delaunay, values: &[f32], grid: &Grid, weights: &Weights) -> Field {
    Interpolator::new(graph, grid, weights).field(values)
}

/// Interpolation of several sets of values at the same points.
pub struct Interpolator<'a>(Supports<'a>);

impl<'a> Interpolator<'a> {
    /// Prepares the interpolation between the points of `graph` on `grid`, whose canvas is the graph's extent; see
    /// [`interpolate`].
    #[must_use]
    pub fn new(graph: &'a Delaunay, grid: &'a Grid, weights: &Weights<'a>) -> Self {
        Self(Supports::new(graph, grid, weights))
    }

    /// The field of these values.
    #[must_use]
    pub fn field(&self, values: &[f32]) -> Field {
        let grid = self.0.grid;
        let mut out = vec![0.0f32; grid.size[0] * grid.size[1]];
        let bands = out.par_chunks_mut(BAND * grid.size[0]).enumerate();
        bands.for_each(|(band, sums)| self.interpolate_band(band, sums, values));
        Field::new(grid, out)
    }

    /// Replaces the values of `field` by the field of `values`, if the previous values differ only at the points marked in
    /// `changed`.
    pub fn update(&self, field: &mut Field, values: &[f32], changed: &[bool]) {
        let bands = field.values.par_chunks_mut(BAND * self.0.grid.size[0]).zip(&self.0.bands).enumerate();
        let is_changed = |image: &Image| changed.get(image.point as usize).is_some_and(|changed| *changed);
        bands.filter(|(_, (_, images))| images.iter().any(is_changed)).for_each(|(band, (sums, _))| {
            sums.fill(0.0);
            self.interpolate_band(band, sums, values);
        });
    }

    /// Adds the rows of a band to `sums`, which must be 0 before.
    fn interpolate_band(&self, band: usize, sums: &mut [f32], values: &[f32]) {
        let nx = self.0.grid.size[0];
        let mut totals = vec![0.0f32; sums.len()];
        let rows = band * BAND..(band * BAND + sums.len() / nx);
        self.0.each_run(rows.clone(), |point, row, run, weights| {
            let value = values.get(point).copied().unwrap_or(0.0);
            let start = (row - rows.start) * nx;
            let cells = start + run.start..start + run.end;
            let sums = sums[cells.clone()].iter_mut().zip(&mut totals[cells]);
            for ((sum, total), weight) in sums.zip(weights) {
                *sum += weight * value;
                *total += weight;
            }
        });
        for (sum, total) in sums.iter_mut().zip(&totals) {
            *sum = if *total > 0.0 { *sum / total } else { 0.0 };
        }
    }
}

/// The point of the highest weight at each cell of `grid`, by row; [`NOBODY`] if there are no points. If weights are equal, the
/// first point.
///
/// These are the paper's cells: similar to Voronoi cells, with bent borders.
#[must_use]
pub fn highest_weight(graph: &Delaunay, grid: &Grid, weights: &Weights) -> Vec<u32> {
    let supports = Supports::new(graph, grid, weights);
    let [nx, ny] = grid.size;
    let mut out = vec![NOBODY; nx * ny];
    out.par_chunks_mut(BAND * nx).enumerate().for_each(|(band, owners)| {
        let mut highest = vec![0.0f32; owners.len()];
        let rows = band * BAND..(band * BAND + owners.len() / nx);
        supports.each_run(rows.clone(), |point, row, run, weights| {
            let start = (row - rows.start) * nx;
            let cells = start + run.start..start + run.end;
            for ((owner, highest), weight) in
                owners[cells.clone()].iter_mut().zip(&mut highest[cells]).zip(weights)
            {
                if *weight > *highest {
                    (*owner, *highest) = (point as u32, *weight);
                }
            }
        });
    });
    out
}

/// Index that means "no point".
pub const NOBODY: u32 = u32::MAX;

/// A point, or an image of a point, whose support meets rows of the grid.
#[derive(Clone, Copy)]
struct Image {
    point: u32,
    /// Centre, px.
    at: [f64; 2],
}

/// The supports of the points, by band of rows.
struct Supports<'a> {
    graph: &'a Delaunay,
    grid: &'a Grid,
    length: f64,
    orientation: Option<Orientation<'a>>,
    bands: Vec<Vec<Image>>,
}

impl<'a> Supports<'a> {
    fn new(graph: &'a Delaunay, grid: &'a Grid, weights: &Weights<'a>) -> Self {
        let length = weights.length.clamp(Weights::SHORTEST, Weights::LONGEST);
        let extent = &graph.extent;
        let rows = grid.size[1];
        let mut bands = vec![Vec::new(); rows.div_ceil(BAND)];
        for (point, center) in graph.points.iter().enumerate() {
            let cell = graph.cell(point);
            if cell.is_empty() {
                continue;
            }
            let [mut low, mut high] = [*center; 2];
            for corner in cell {
                low = [0, 1].map(|axis| low[axis].min(center[axis] + 2.0 * length * corner[axis]));
                high = [0, 1].map(|axis| high[axis].max(center[axis] + 2.0 * length * corner[axis]));
            }
            for shift in extent.images(low, high, [[0.0; 2], extent.size]) {
                let at = [center[0] + shift[0], center[1] + shift[1]];
                let first = rows_from(low[1] + shift[1], grid).min(rows);
                let end = rows_from(high[1] + shift[1], grid).min(rows);
                if first < end {
                    let image = Image { point: point as u32, at };
                    bands[first / BAND..end.div_ceil(BAND)].iter_mut().for_each(|band| band.push(image));
                }
            }
        }
        Self { graph, grid, length, orientation: weights.orientation, bands }
    }

    /// Calls `each(point, row, run of columns, weights)` for the `rows` of a band, point by point.
    fn each_run(&self, rows: Range<usize>, mut each: impl FnMut(usize, usize, Range<usize>, &[f32])) {
        let mut weights = vec![0.0f32; self.grid.size[0]];
        let mut slopes = Vec::new();
        for image in &self.bands[rows.start / BAND] {
            let point = image.point as usize;
            slopes.clear();
            slopes.extend(self.graph.axes(point).iter().map(|axis| {
                let square =
                    axis.displacement[0] * axis.displacement[0] + axis.displacement[1] * axis.displacement[1];
                axis.displacement.map(|displacement| displacement / (self.length * square))
            }));
            for row in rows.clone() {
                let y = (row as f64 + 0.5) * self.grid.cell[1] - image.at[1];
                let Some(run) = self.run(&slopes, image.at[0], y) else { continue };
                let x = (run.start as f64 + 0.5) * self.grid.cell[0] - image.at[0];
                let weights = &mut weights[..run.len()];
                self.weigh(&slopes, [x, y], weights);
                if let Some(orientation) = &self.orientation {
                    let direction = orientation.directions.get(point).copied().unwrap_or_default();
                    self.shift(orientation.strength, direction, [x, y], weights);
                }
                each(point, row, run, weights);
            }
        }
    }

    /// The columns of a row, `y` px below the centre at `x`, that lie in the support.
    fn run(&self, slopes: &[[f64; 2]], x: f64, y: f64) -> Option<Range<usize>> {
        let [mut low, mut high] = [f64::NEG_INFINITY, f64::INFINITY];
        for [across, down] in slopes {
            // across·dx + down·y < 1
            let left = 1.0 - down * y;
            if *across > 0.0 {
                high = high.min(left / across);
            } else if *across < 0.0 {
                low = low.max(left / across);
            } else if left <= 0.0 {
                return None;
            }
        }
        let cell = self.grid.cell[0];
        let column = |dx: f64| ((x + dx) / cell - 0.5).ceil().clamp(0.0, self.grid.size[0] as f64) as usize;
        let run = column(low)..column(high);
        (run.start < run.end).then_some(run)
    }

    /// The weights, eq. 2, of successive px from [x, y] (relative to the centre) on.
    fn weigh(&self, slopes: &[[f64; 2]], [x, y]: [f64; 2], weights: &mut [f32]) {
        let cell = self.grid.cell[0];
        weights.fill(1.0);
        for [across, down] in slopes {
            let first = across * x + down * y;
            let step = across * cell;
            if first.max(first + step * (weights.len() - 1) as f64) <= 0.0 {
                continue;
            }
            let (first, step) = (first as f32, step as f32);
            for (k, weight) in weights.iter_mut().enumerate() {
                // A run has fewer px than 2²⁴, which f32 counts exactly.
                let p = (first + step * k as i32 as f32).clamp(0.0, 1.0);
                let rest = 1.0 - p;
                *weight *= rest * rest * (1.0 + 2.0 * p);
            }
        }
    }

    /// The shift of the weights, eq. 4.
    fn shift(&self, strength: f64, direction: [f64; 2], [x, y]: [f64; 2], weights: &mut [f32]) {
        if direction == [0.0; 2] {
            return;
        }
        for (k, weight) in weights.iter_mut().enumerate() {
            let dx = x + k as f64 * self.grid.cell[0];
            *weight = shifted(*weight, strength, direction, [dx, y]);
        }
    }
}

/// W′ of equation 4, of a weight at a displacement from its point, which shifts it by ε = `strength` along the unit vector `direction`.
#[must_use]
pub fn shifted(weight: f32, strength: f64, direction: [f64; 2], [dx, dy]: [f64; 2]) -> f32 {
    let away = (dx * dx + dy * dy).sqrt();
    if weight <= 0.0 || away <= 0.0 {
        return weight;
    }
    let turned = strength * (dx * direction[0] + dy * direction[1]) / away;
    // At K = −1 the exponent is infinite: 1 ÷ .001 also reduces any weight below 1 to nearly 0.
    let exponent = if turned >= 0.0 { 1.0 - turned } else { 1.0 / (1.0 + turned).max(1e-3) };
    exp(exponent * ln(f64::from(weight))) as f32
}

/// The first row whose cells' centres lie at `y` px or beyond.
fn rows_from(y: f64, grid: &Grid) -> usize {
    (y / grid.cell[1] - 0.5).ceil().max(0.0) as usize
}

#[cfg(test)]
mod tests;
