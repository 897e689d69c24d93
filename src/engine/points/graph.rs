//! The graph over points, on a canvas or on a surface, as far as labels and patches need it.

use super::delaunay::{Axis, Delaunay};

/// Points and the edges to their Delaunay neighbours.
pub trait PointGraph {
    /// The number of points.
    fn count(&self) -> usize;

    /// The edges of a point, in order round it.
    fn axes(&self, point: usize) -> &[Axis];

    /// Area of a point's Voronoi cell, px².
    fn area(&self, point: usize) -> f64;

    /// For each edge between two neighbours of a point, the point on its other side, with the clearance of that edge.
    fn opposite(&self, point: usize) -> impl Iterator<Item = (usize, f64)>;

    /// The displacement, px, from point `from` to the end of an axis of point `at`, in the frame of `from`, where that to `at` is given.
    fn onward(&self, from: usize, at: usize, displacement: [f64; 2], axis: &Axis) -> [f64; 2];

    /// The shortest displacement from a point to another, px, in the frame of the first.
    fn way(&self, from: usize, to: usize) -> [f64; 2];

    /// The neighbours of a point.
    fn neighbours(&self, point: usize) -> impl Iterator<Item = usize> {
        self.axes(point).iter().filter_map(|axis| axis.to).map(|to| to as usize)
    }
}

impl PointGraph for Delaunay {
    fn count(&self) -> usize {
        self.points.len()
    }

    fn axes(&self, point: usize) -> &[Axis] {
        self.axes(point)
    }

    fn area(&self, point: usize) -> f64 {
        self.area(point)
    }

    fn opposite(&self, point: usize) -> impl Iterator<Item = (usize, f64)> {
        self.opposite(point)
    }

    fn onward(&self, _: usize, _: usize, [x, y]: [f64; 2], axis: &Axis) -> [f64; 2] {
        [x + axis.displacement[0], y + axis.displacement[1]]
    }

    fn way(&self, from: usize, to: usize) -> [f64; 2] {
        let [from, to] = [from, to].map(|point| self.points[point]);
        self.extent.shortest([to[0] - from[0], to[1] - from[1]])
    }
}
