//! The distance by which the colours of a finish may move, so that marks keep their area and their number.
//!
//! Local thickness T: the radius of the largest disc that covers a place and stays within its own mark or its own ground
//! (T. Hildebrand, P. Rüegsegger, "A new method for the model-independent assessment of thickness in three-dimensional images",
//! J. Microscopy 185, 1997). A colour moves by at most [`SHARE`]·T of the thinner side of the nearest edge: then a mark
//! keeps its core, and two marks do not meet.

use super::noise::floor;
use crate::grid::{Edges, Grid, distance};

/// The share of the local radius by which a hair may carry the colour at its root.
pub const SHARE: f32 = 0.6;

/// Thickness and distance to the nearest edge at each px of the canvas.
#[derive(Clone, Debug)]
pub struct Reach {
    size: [usize; 2],
    edges: Edges,
    /// Local radius of the thinner side of the nearest edge, px; at most that of `of`.
    radius: Vec<f32>,
    /// Distance to the nearest px with another label, px.
    distance: Vec<f32>,
    /// That label.
    other: Vec<u8>,
}

impl Reach {
    /// The reach for the `labels` of a canvas; radii above `most` px count as that.
    #[must_use]
    pub fn of(labels: &[u8], size: [usize; 2], edges: Edges, most: f32) -> Self {
        let grid = Grid::unit(size, edges);
        let mut distance = vec![f32::INFINITY; labels.len()];
        let mut nearest: Vec<u32> = (0..labels.len() as u32).collect();
        let mut present = [false; 256];
        labels.iter().for_each(|label| present[usize::from(*label)] = true);
        for label in (0..=255_u8).filter(|label| present[usize::from(*label)]) {
            let other: Vec<bool> = labels.iter().map(|found| *found != label).collect();
            let Some(offsets) = distance::nearest(&other, &grid) else { continue };
            for (px, offset) in offsets.iter().enumerate().filter(|(px, _)| !other[*px]) {
                // From the middle of a px to the edge of the next one.
                distance[px] = distance::length(*offset, &grid) as f32 - 0.5;
                nearest[px] = moved(px, *offset, size, edges) as u32;
            }
        }
        let own = thickness(&distance, size, edges, most);
        let radius = (0..labels.len()).map(|px| own[px].min(own[nearest[px] as usize])).collect();
        let other = nearest.iter().map(|px| labels[*px as usize]).collect();
        Self { size, edges, radius, distance, other }
    }

    /// The px of the canvas that holds `point`, which may lie beyond its border.
    #[inline]
    fn px(&self, point: [f32; 2]) -> usize {
        let [x, y] = [0, 1].map(|axis| self.edges.index(floor(point[axis]) as isize, self.size[axis]));
        y * self.size[0] + x
    }

    /// The label of the nearest px that has another label than that at `point`, px of the canvas.
    #[must_use]
    pub fn label_beside(&self, point: [f32; 2]) -> u8 {
        self.other[self.px(point)]
    }

    /// By how many px the colour at `point` (px of the canvas) may move, if it is wanted to move by at most `wanted` px.
    #[inline]
    #[must_use]
    pub fn at(&self, point: [f32; 2], wanted: f32) -> f32 {
        let px = self.px(point);
        if self.distance[px] > wanted { wanted } else { wanted.min(SHARE * self.radius[px]) }
    }

    /// Local radius of the thinner side of the nearest edge at each px, px.
    #[must_use]
    pub fn radius(&self) -> &[f32] {
        &self.radius
    }
}

/// The px that is `offset` from `px`.
fn moved(px: usize, [columns, rows]: [i32; 2], [width, height]: [usize; 2], edges: Edges) -> usize {
    let x = edges.index((px % width) as isize + columns as isize, width);
    let y = edges.index((px / width) as isize + rows as isize, height);
    y * width + x
}

/// Local thickness by the discs around the middle lines, where no neighbour has a disc that holds that of the px.
fn thickness(distance: &[f32], [width, height]: [usize; 2], edges: Edges, most: f32) -> Vec<f32> {
    /// A neighbour's disc nearly holds that of the px if its radius is larger by this share of their distance.
    const RISE: f32 = 0.85;
    let mut thick: Vec<f32> = distance.iter().map(|distance| distance.min(most)).collect();
    for px in 0..distance.len() {
        let radius = distance[px].min(most);
        let (x, y) = ((px % width) as isize, (px / width) as isize);
        let mut is_ridge = true;
        let mut is_inside = radius >= most;
        for (dx, dy) in [(-1, 0), (1, 0), (0, -1), (0, 1), (-1, -1), (1, -1), (-1, 1), (1, 1)] {
            let near = edges.index(y + dy, height) * width + edges.index(x + dx, width);
            let apart = if dx != 0 && dy != 0 { std::f32::consts::SQRT_2 } else { 1.0 };
            is_ridge &= distance[near] < distance[px] + RISE * apart;
            is_inside &= distance[near] >= most;
        }
        // Within a wide place all discs have the radius `most`: those at its border are enough.
        if (radius < most && !is_ridge) || is_inside {
            continue;
        }
        let rows = radius.floor() as isize;
        for dy in -rows..=rows {
            let half = (radius * radius - (dy * dy) as f32).max(0.0).sqrt() as isize;
            let row = &mut thick[edges.index(y + dy, height) * width..][..width];
            if x >= half && x + half < width as isize {
                let row = &mut row[(x - half) as usize..=(x + half) as usize];
                row.iter_mut().for_each(|thick| *thick = if *thick < radius { radius } else { *thick });
            } else {
                for dx in -half..=half {
                    let thick = &mut row[edges.index(x + dx, width)];
                    *thick = thick.max(radius);
                }
            }
        }
    }
    thick
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A disc of radius 9 and a stripe of width 6 on a tile of 64 × 48 px.
    fn labels() -> Vec<u8> {
        let disc = |x: f32, y: f32| (x - 20.0).powi(2) + (y - 16.0).powi(2) < 81.0;
        let stripe = |y: f32| (36.0..42.0).contains(&y);
        let px = |i: usize| [(i % 64) as f32 + 0.5, (i / 64) as f32 + 0.5];
        (0..64 * 48).map(|i| u8::from(disc(px(i)[0], px(i)[1]) || stripe(px(i)[1]))).collect()
    }

    #[test]
    fn the_radius_is_that_of_the_nearest_mark() {
        let reach = Reach::of(&labels(), [64, 48], Edges::Wrap, 20.0);
        let radius = |x: usize, y: usize| reach.radius()[y * 64 + x];
        for (x, y) in [(20, 16), (14, 16), (26, 20)] {
            assert!((radius(x, y) - 8.6).abs() < 0.8, "{x} {y}: {}", radius(x, y));
        }
        for (x, y) in [(50, 38), (50, 41), (50, 44), (5, 34)] {
            assert!((radius(x, y) - 2.6).abs() < 0.6, "{x} {y}: {}", radius(x, y));
        }
    }

    #[test]
    fn colours_move_far_only_where_no_edge_is_near() {
        let reach = Reach::of(&labels(), [64, 48], Edges::Wrap, 20.0);
        assert_eq!(reach.at([50.5, 20.5], 10.0), 10.0);
        assert!(reach.at([50.5, 33.5], 10.0) < 2.0);
    }
}
