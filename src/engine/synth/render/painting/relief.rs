//! The relief of a painting: its height, normals, roughness and occlusion.

use std::ops::Range;

use crate::export::maps::{Height, Surface, normals, openness, shares};
use crate::grid::Edges;
use crate::synth::render::painting::Painting;
use crate::synth::watch::Watch;

/// Distance, in heights of the relief, at which a mark still shades its surroundings: it takes 6 % of the sky's light there.
const REACH: f64 = 4.0;
/// The largest radius of occlusion, px.
const FARTHEST: usize = 96;

/// Some rows of a relief, one value a px.
pub(super) struct Relief {
    /// The lowest and the highest height that is possible, px of the picture.
    pub range: [f64; 2],
    /// Height above the ground, px of the picture.
    pub heights: Vec<f32>,
    /// x to the right, y up, z out of the picture.
    pub normals: Vec<[f32; 3]>,
    /// 0 = mirror, 1 = chalk.
    pub roughness: Vec<f32>,
    /// The share of the sky that is visible.
    pub open: Vec<f32>,
}

/// Distance to which marks of `layers` layers shade their surroundings, px; heights of `surface` are in px of the picture.
pub(super) fn radius(surface: &Surface, layers: usize) -> usize {
    let [low, high] = surface.range(layers);
    ((REACH * (high - low)).ceil() as usize).clamp(1, FARTHEST)
}

impl Painting<'_> {
    /// The relief of `rows` with a `surface` whose heights are in px of the picture. The result has no meaning once `watch` is
    /// cancelled.
    pub(super) fn relief(
        &self,
        rows: Range<usize>,
        surface: &Surface,
        edges: Edges,
        watch: &Watch,
    ) -> Relief {
        let width = self.size[0];
        let radius = radius(surface, self.layers.len());
        let mut shared = self.patterns(rows.clone(), radius, edges);
        shares(&mut shared);
        let mut heights = match shared.is_empty() {
            true => vec![0.0; width * (rows.len() + 2 * radius)],
            false => surface.height(&shared),
        };
        let raised = self.raise(&mut heights, rows.clone(), radius, edges);
        let height = Height::new(&heights, width, radius, edges);
        let inner = radius * width..(radius + rows.len()) * width;
        let roughness = match shared.is_empty() {
            true => vec![surface.roughness.first().copied().unwrap_or(1.0) as f32; inner.len()],
            false => surface.roughness(&shared)[inner.clone()].to_vec(),
        };
        let roughness = match self.finished() {
            None => roughness,
            Some(finished) => {
                let px = rows.start * width..rows.end * width;
                finished.surfels[px].iter().map(|surfel| surfel.roughness).collect()
            }
        };
        let [low, high] = surface.range(shared.len());
        Relief {
            range: [low + raised[0], high + raised[1]],
            normals: normals(&height),
            open: openness(&height, radius, watch.cancelled),
            heights: heights[inner].to_vec(),
            roughness,
        }
    }

    /// Adds the heights of the finish to those of `rows`, with `rim` rows above and below; returns the lowest and the highest of
    /// them, px of the picture.
    fn raise(&self, heights: &mut [f32], rows: Range<usize>, rim: usize, edges: Edges) -> [f64; 2] {
        let Some(finished) = self.finished() else { return [0.0; 2] };
        let ([width, height], scale) = (self.size, self.px_a_px());
        let beyond = rows.start as isize - rim as isize..(rows.end + rim) as isize;
        for (row, y) in heights.chunks_exact_mut(width).zip(beyond) {
            let surfels = &finished.surfels[edges.index(y, height) * width..];
            row.iter_mut().zip(surfels).for_each(|(height, surfel)| *height += scale * surfel.height);
        }
        finished.heights.map(|height| f64::from(scale * height))
    }

    /// The pattern of each shown layer in rows `rows`, plus `rim` rows above and below.
    fn patterns(&self, rows: Range<usize>, rim: usize, edges: Edges) -> Vec<Vec<f32>> {
        let [width, height] = self.size;
        let shown: Vec<_> = self
            .layers
            .iter()
            .zip(&self.visible)
            .filter(|(_, visible)| **visible)
            .map(|(layer, _)| layer)
            .collect();
        let mut patterns: Vec<Vec<f32>> = vec![Vec::new(); shown.len()];
        let beyond = rows.start as isize - rim as isize..(rows.end + rim) as isize;
        let wanted: Vec<usize> = beyond.map(|y| edges.index(y, height)).collect();
        // Consecutive rows are computed together.
        for run in wanted.chunk_by(|a, b| a + 1 == *b) {
            let run = run[0]..run[run.len() - 1] + 1;
            for (pattern, layer) in patterns.iter_mut().zip(&shown) {
                pattern.extend(layer.rows(run.clone(), width, height));
            }
        }
        patterns
    }
}
