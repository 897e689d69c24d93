//! Numbers at the centres of a grid of nodes, and anywhere between them.

use rayon::prelude::*;

use crate::attributes::regions::RegionGrid;

/// `N` numbers a node, bilinear between the nodes.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Nodes<const N: usize> {
    pub layout: RegionGrid,
    values: Vec<[f64; N]>,
}

impl<const N: usize> Nodes<N> {
    /// The numbers that `value` has at the nodes' centres, px.
    pub fn sampled(layout: RegionGrid, value: impl Fn([f64; 2]) -> [f64; N] + Sync) -> Self {
        let at = |index: usize| value(layout.center(layout.place(index)));
        Self { layout, values: (0..layout.len()).into_par_iter().map(at).collect() }
    }

    /// The numbers at a point, px.
    pub fn at(&self, point: [f64; 2]) -> [f64; N] {
        let mut sum = [0.0; N];
        for (index, weight) in self.layout.corners(point) {
            for (sum, value) in sum.iter_mut().zip(&self.values[index]) {
                *sum += weight * value;
            }
        }
        sum
    }

    /// The numbers that `of` gives for those of each node.
    pub fn map<const M: usize>(&self, of: impl Fn(&[f64; N]) -> [f64; M]) -> Nodes<M> {
        Nodes { layout: self.layout, values: self.values.iter().map(of).collect() }
    }

    /// Changes the numbers of every node.
    pub fn change(&mut self, change: impl FnMut(&mut [f64; N])) {
        self.values.iter_mut().for_each(change);
    }

    /// Changes the numbers of every node by those that `others`, of the same layout, has there.
    pub fn change_with<const M: usize>(
        &mut self,
        others: &Nodes<M>,
        mut change: impl FnMut(&mut [f64; N], &[f64; M]),
    ) {
        self.values.iter_mut().zip(&others.values).for_each(|(value, other)| change(value, other));
    }

    /// These numbers over a canvas of another size, px.
    pub fn resized(&self, size: [f64; 2]) -> Self {
        Self { layout: RegionGrid { size, ..self.layout }, values: self.values.clone() }
    }
}

/// The grid of square nodes over a canvas, `most` along its longer side.
pub(super) fn layout_with(canvas: &RegionGrid, most: usize) -> RegionGrid {
    let longer = canvas.size[0].max(canvas.size[1]);
    let grid = canvas.size.map(|side| ((most as f64 * side / longer).round() as usize).max(1));
    RegionGrid { grid, ..*canvas }
}
