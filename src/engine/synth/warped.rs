//! Patterns that are bent by the curl of a noise (R. Bridson, J. Houriham, M. Nordenstam, "Curl-noise for procedural fluid flow",
//! SIGGRAPH 2007).
//!
//! ```text
//! p′(x) = p(x + u(x)),   u = (∂ψ/∂y, −∂ψ/∂x),   ψ = noise
//! ```
//!
//! u has no divergence, so that small displacements keep areas. The level at which a mark ends is found again, so that a layer covers as
//! much as before also with larger ones. All layers of a document have one u: marks keep their places relative to each other.

use std::ops::Range;
use std::sync::Arc;

use rayon::prelude::*;

use crate::document::{Document, Warp};
use crate::grid::{Edges, Field, Grid};
use crate::points::level::share_above;
use crate::points::noise::Noise;
use crate::synth::drawn::maps;
use crate::synth::pattern::{EDGE, LayerPattern, PatternRows, share};

/// Nodes of the displacement for the size of the noise.
const A_SIZE: f64 = 8.0;
/// Most nodes along the longer side.
const MOST_NODES: f64 = 1_024.0;
/// The longer side of the pattern on which levels are found, px.
const LEVELLED: f64 = 768.0;
/// Halvings of the interval of levels.
const HALVINGS: usize = 20;
/// Combined with the document's seed, so that the warp has random numbers of its own.
const SEED: u64 = 0x7761_7270_6375_726C;

/// The displacement of a document at each place of its canvas.
#[derive(Debug)]
pub struct Displacement {
    /// Width and height of the canvas, px.
    canvas: [f64; 2],
    edges: Edges,
    /// The displacement at the centres of the cells, px of the canvas.
    nodes: [Field; 2],
    /// The largest one along y, px of the canvas.
    highest: f64,
}

impl Displacement {
    /// The displacement of `document` on a canvas of `size` px; `None` without a warp.
    #[must_use]
    pub fn of(document: &Document, size: [f64; 2]) -> Option<Self> {
        let warp = document.warp.filter(|warp| warp.by > 0.0)?;
        let most = (size[0].max(size[1]) / warp.size * A_SIZE).ceil().clamp(2.0, MOST_NODES);
        let nodes = maps::nodes(document.edges, size, most as usize);
        let cell = [0, 1].map(|axis| size[axis] / nodes.grid[axis] as f64);
        let grid = Grid { size: nodes.grid, cell, edges: document.edges };
        Some(Self::curl(&warp, &grid, document.seed))
    }

    fn curl(Warp { size, by }: &Warp, grid: &Grid, seed: u64) -> Self {
        let radius = size.max(grid.px_a_cell());
        let noise = Noise { radius, octaves: 1, fold: false, seed: seed ^ SEED }.field(grid);
        let [width, height] = grid.size;
        let slope = |axis: usize| {
            let at = |px: usize| {
                let (x, y) = ((px % width) as isize, (px / width) as isize);
                let (dx, dy) = if axis == 0 { (1, 0) } else { (0, 1) };
                (noise.get(x + dx, y + dy) - noise.get(x - dx, y - dy)) / (2.0 * grid.cell[axis] as f32)
            };
            (0..width * height).map(at).collect::<Vec<f32>>()
        };
        let [along_x, along_y] = [slope(0), slope(1)];
        let squares = along_x.iter().chain(&along_y).map(|slope| f64::from(slope * slope)).sum::<f64>();
        let rms = (squares / along_x.len() as f64).sqrt();
        let factor = if rms > 0.0 { (by / rms) as f32 } else { 0.0 };
        let field = |slopes: Vec<f32>, factor: f32| {
            Field::new(grid, slopes.into_iter().map(|slope| factor * slope).collect())
        };
        let nodes = [field(along_y, factor), field(along_x, -factor)];
        let highest = nodes[1].values.iter().fold(0.0_f32, |most, by| most.max(by.abs()));
        Self { canvas: grid.bounds_px().size, edges: grid.edges, nodes, highest: f64::from(highest) }
    }

    /// The displacement at a point, px of the canvas.
    #[inline]
    fn at(&self, point: [f64; 2]) -> [f32; 2] {
        let [columns, rows] = &self.nodes;
        let place = [0, 1].map(|axis| point[axis] / columns.cell[axis] - 0.5);
        let base = place.map(f64::floor);
        let [u, v] = [0, 1].map(|axis| (place[axis] - base[axis]) as f32);
        let (x, y) = (base[0] as isize, base[1] as isize);
        [columns, rows].map(|field| {
            let upper = field.get(x, y) + u * (field.get(x + 1, y) - field.get(x, y));
            let lower = field.get(x, y + 1) + u * (field.get(x + 1, y + 1) - field.get(x, y + 1));
            upper + v * (lower - upper)
        })
    }
}

/// The patterns of the layers of `document` on a canvas of `size` px, bent by its warp.
#[must_use]
pub fn warped<'a>(
    document: &Document,
    size: [f64; 2],
    patterns: Vec<LayerPattern<'a>>,
) -> Vec<LayerPattern<'a>> {
    let Some(displacement) = Displacement::of(document, size).map(Arc::new) else { return patterns };
    let one = |pattern| Box::new(Warped::new(pattern, displacement.clone())) as LayerPattern<'a>;
    patterns.into_iter().map(one).collect()
}

/// A bent pattern.
struct Warped<'a> {
    inner: LayerPattern<'a>,
    displacement: Arc<Displacement>,
    /// The value of the bent pattern that becomes ½.
    level: f32,
}

impl<'a> Warped<'a> {
    fn new(inner: LayerPattern<'a>, displacement: Arc<Displacement>) -> Self {
        let canvas = displacement.canvas;
        let reduced = (LEVELLED / canvas[0].max(canvas[1])).min(1.0);
        let [width, height] = canvas.map(|side| ((side * reduced).round() as usize).max(1));
        let wanted = share_above(&inner.field(width, height), EDGE);
        let mut warped = Self { inner, displacement, level: EDGE };
        let bent = warped.bent_field(width, height);
        // The share falls as the level rises.
        let mut levels = [0.3_f32, 0.7];
        for _ in 0..HALVINGS {
            let middle = 0.5 * (levels[0] + levels[1]);
            let above = share_above(&bent, middle) > wanted;
            levels[usize::from(!above)] = middle;
        }
        if wanted > 0.0 && wanted < 1.0 {
            warped.level = 0.5 * (levels[0] + levels[1]);
        }
        warped
    }

    /// The bent pattern before its level is found.
    fn bent_field(&self, width: usize, height: usize) -> Field {
        let canvas = self.displacement.canvas;
        let cell = [canvas[0] / width as f64, canvas[1] / height as f64];
        let values = self.bent(0..height, width, height);
        Field { width, height, cell, edges: self.displacement.edges, values }
    }

    /// Rows of the bent pattern before its level is found.
    fn bent(&self, rows: Range<usize>, width: usize, height: usize) -> Vec<f32> {
        let Displacement { canvas, edges, highest, .. } = &*self.displacement;
        let scale = [width as f64 / canvas[0], height as f64 / canvas[1]];
        // Two more for the interpolation.
        let margin = (highest * scale[1]).ceil() as isize + 2;
        let first = rows.start as isize - margin;
        let source = self.inner_rows(first..rows.end as isize + margin, width, height);
        let mut out = vec![0.0; width * rows.len()];
        out.par_chunks_mut(width.max(1)).enumerate().for_each(|(row, line)| {
            let y = (rows.start + row) as f64 + 0.5;
            for (x, value) in line.iter_mut().enumerate() {
                let by = self.displacement.at([(x as f64 + 0.5) / scale[0], y / scale[1]]);
                let place = [
                    x as f64 + f64::from(by[0]) * scale[0],
                    y - 0.5 - first as f64 + f64::from(by[1]) * scale[1],
                ];
                *value = cubic(&source, width, *edges, place);
            }
        });
        out
    }

    /// Rows of the pattern that is not bent; those beyond the border are the rows that lie there.
    fn inner_rows(&self, rows: Range<isize>, width: usize, height: usize) -> Vec<f32> {
        let edges = self.displacement.edges;
        let index = |row: isize| edges.index(row, height);
        let mut values = Vec::with_capacity(width * rows.len());
        let mut row = rows.start;
        while row < rows.end {
            // As many rows as follow each other in the pattern.
            let begin = index(row);
            let mut count = 1;
            while row + count < rows.end && index(row + count) == begin + count as usize {
                count += 1;
            }
            values.extend(self.inner.rows(begin..begin + count as usize, width, height));
            row += count;
        }
        values
    }
}

impl PatternRows for Warped<'_> {
    fn grid(&self) -> [usize; 2] {
        self.inner.grid()
    }

    fn has_corners(&self) -> bool {
        true
    }

    fn rows(&self, rows: Range<usize>, width: usize, height: usize) -> Vec<f32> {
        let mut values = self.bent(rows, width, height);
        values.iter_mut().for_each(|value| *value = share(*value, self.level));
        values
    }

    fn field(&self, width: usize, height: usize) -> Field {
        let bent = self.bent_field(width, height);
        let values = bent.values.iter().map(|value| share(*value, self.level)).collect();
        Field { values, ..bent }
    }
}

/// The value at a place among rows of px, by cubic convolution (R. Keys, 1981, a = −½).
#[inline]
fn cubic(source: &[f32], width: usize, edges: Edges, [x, y]: [f64; 2]) -> f32 {
    let base = [x.floor(), y.floor()];
    let weights = [(x - base[0]) as f32, (y - base[1]) as f32].map(|t| {
        let (t2, t3) = (t * t, t * t * t);
        [
            -0.5 * t3 + t2 - 0.5 * t,
            1.5 * t3 - 2.5 * t2 + 1.0,
            -1.5 * t3 + 2.0 * t2 + 0.5 * t,
            0.5 * t3 - 0.5 * t2,
        ]
    });
    let rows = source.len() / width.max(1);
    let columns = [-1, 0, 1, 2].map(|by| edges.index(base[0] as isize + by, width));
    let mut sum = 0.0;
    for (k, down) in weights[1].iter().enumerate() {
        let row = (base[1] as isize + k as isize - 1).clamp(0, rows as isize - 1) as usize * width;
        let across = columns.iter().zip(&weights[0]).map(|(column, across)| across * source[row + column]);
        sum += down * across.sum::<f32>();
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synth::pattern::AreaPattern;

    /// Discs of different radii on a tile.
    fn discs() -> Field {
        let centres = [[30.0, 30.0, 14.0], [90.0, 40.0, 9.0], [50.0, 90.0, 11.0], [110.0, 105.0, 7.0]];
        Field::from_fn([128, 128], [1.0; 2], Edges::Wrap, |[x, y]| {
            let inside = centres.map(|[cx, cy, r]| r - f64::hypot(x - cx, y - cy));
            (0.5 + 0.1 * inside.into_iter().fold(f64::MIN, f64::max)).clamp(0.0, 1.0) as f32
        })
    }

    fn document(size: f64, by: f64) -> Document {
        Document { warp: Some(Warp { size, by }), edges: Edges::Wrap, ..Document::new([128, 128]) }
    }

    fn bent(document: &Document) -> LayerPattern<'static> {
        let pattern: Vec<LayerPattern> = vec![Box::new(AreaPattern::new(&discs()))];
        warped(document, [128.0; 2], pattern).remove(0)
    }

    #[test]
    fn a_warp_moves_places_by_what_is_asked_and_keeps_the_covered_share() {
        let before = share_above(&discs(), EDGE);
        for (size, by) in [(30.0, 2.0), (60.0, 6.0), (15.0, 3.0)] {
            let document = document(size, by);
            let displacement = Displacement::of(&document, [128.0; 2]).unwrap();
            let squares = |field: &Field| field.values.iter().map(|by| f64::from(by * by)).sum::<f64>();
            let [x, y] = &displacement.nodes;
            let rms = ((squares(x) + squares(y)) / x.values.len() as f64).sqrt();
            assert!((rms - by).abs() < 1e-3 * by, "{rms} {by}");
            let after = bent(&document).field(128, 128);
            assert!(after.values != discs().values);
            let share = share_above(&after, EDGE);
            assert!((share / before - 1.0).abs() < 2e-3, "{size} {by}: {before} {share}");
        }
    }

    #[test]
    fn rows_are_those_of_the_whole_pattern_at_any_size() {
        let pattern = bent(&document(40.0, 5.0));
        for [width, height] in [[128, 128], [64, 96], [256, 256]] {
            let whole = pattern.field(width, height).values;
            for rows in [0..7, 40..41, height - 5..height] {
                assert_eq!(
                    pattern.rows(rows.clone(), width, height),
                    whole[rows.start * width..rows.end * width]
                );
            }
        }
    }

    #[test]
    fn a_warped_tile_has_no_seam() {
        let field = bent(&document(40.0, 5.0)).field(128, 128);
        let step = |x: isize, y: isize| (field.get(x + 1, y) - field.get(x, y)).abs();
        let largest = |x: isize| (0..128).map(|y| step(x, y)).fold(0.0, f32::max);
        let inside = (0..127).map(largest).fold(0.0, f32::max);
        assert!(largest(127) <= inside, "{} {inside}", largest(127));
    }

    #[test]
    fn without_a_warp_patterns_stay() {
        let document = document(40.0, 0.0);
        assert!(Displacement::of(&document, [128.0; 2]).is_none());
        assert_eq!(bent(&document).field(128, 128), AreaPattern::new(&discs()).field(128, 128));
    }
}
