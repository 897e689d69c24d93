//! What has grown, brought to the canvas: 0 = ground, ½ = a mark's edge, 1 = the middle of a mark.

use rayon::prelude::*;
use std::ops::Range;

use super::plan::Plan;
use crate::field::resample::Spline;
use crate::field::{Edges, Field};

/// A layer's grown concentration and the level that makes an edge of it.
pub struct Pattern<'a> {
    plan: &'a Plan,
    spline: Spline,
    /// What the level is multiplied by, by region.
    pub correction: Vec<f64>,
}

/// Levels beyond these cut a spot at its foot or its tip, where noise and not the spot decides.
const LEVELS: [f64; 2] = [0.15, 0.8];

impl<'a> Pattern<'a> {
    /// `marks` is the concentration as a share of the local peak, on the plan's grid.
    #[must_use]
    pub fn new(plan: &'a Plan, marks: &Field) -> Self {
        let regions = plan.map.layout().len();
        Self { plan, spline: Spline::new(marks), correction: vec![1.0; regions] }
    }

    /// The level at a point of the canvas, px.
    #[must_use]
    pub fn level(&self, point: [f64; 2]) -> f64 {
        let corners = self.plan.map.layout().corners(point);
        let correction: f64 = corners.iter().map(|&(i, weight)| weight * self.correction[i]).sum();
        (self.plan.lattice.at(point).level * correction).clamp(LEVELS[0], LEVELS[1])
    }

    /// Rows `rows` of the pattern at `width` × `height` px over the whole canvas.
    #[must_use]
    pub fn rows(&self, rows: Range<usize>, width: usize, height: usize) -> Vec<f32> {
        let first = rows.start;
        let mut values = self.spline.rows(rows, width, height);
        let size = self.plan.map.layout().size;
        let uniform = self.correction.len() == 1 && self.plan.lattice.nodes.len() == 1;
        let everywhere = self.level([0.0, 0.0]);
        values.par_chunks_mut(width).enumerate().for_each(|(y, row)| {
            let y = (first + y) as f64 + 0.5;
            for (x, value) in row.iter_mut().enumerate() {
                let level = if uniform {
                    everywhere
                } else {
                    self.level([(x as f64 + 0.5) * size[0] / width as f64, y * size[1] / height as f64])
                };
                *value = share(*value, level as f32);
            }
        });
        values
    }

    /// The whole pattern at `width` × `height` px.
    #[must_use]
    pub fn field(&self, width: usize, height: usize) -> Field {
        let size = self.plan.map.layout().size;
        let edges: Edges = self.plan.map.layout().edges;
        let cell = [size[0] / width as f64, size[1] / height as f64];
        Field { width, height, cell, edges, values: self.rows(0..height, width, height) }
    }
}

/// u → the pattern: the smooth monotone map of 0..1 onto itself that takes `level` to ½,
/// p = u(1 − l)/(u(1 − l) + l(1 − u)).
fn share(u: f32, level: f32) -> f32 {
    let u = u.clamp(0.0, 1.0);
    let up = u * (1.0 - level);
    up / (up + level * (1.0 - u))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_level_becomes_one_half_and_the_ends_stay() {
        for level in [0.2, 0.5, 0.75] {
            assert!((share(level, level) - 0.5).abs() < 1e-6);
            assert_eq!([share(0.0, level), share(1.0, level)], [0.0, 1.0]);
            assert_eq!([share(-0.1, level), share(1.3, level)], [0.0, 1.0]);
        }
    }

    #[test]
    fn the_pattern_rises_with_the_concentration() {
        for level in [0.2, 0.5, 0.75] {
            let p: Vec<f32> = (0..=100).map(|i| share(i as f32 / 100.0, level)).collect();
            assert!(p.windows(2).all(|w| w[0] < w[1]));
        }
    }
}
