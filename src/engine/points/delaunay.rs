//! The graph over points: the Delaunay neighbours of each point in order round it, and its Voronoi cell.
//!
//! Along an axis that wraps, copies of the points are added beyond the border. Along an axis that does not wrap, a circle of guards
//! far away closes the cells of the outermost points, so that the values there continue outwards unchanged: guards have no value.

use spade::{Triangulation, handles::FixedVertexHandle};

use super::extent::Extent;
use crate::grid::triangulation::{Corner, Margin, Mesh, distinct, tame, triangulated};

/// The edge from a point to a neighbour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// From the point to the neighbour or its nearest image, px.
    pub displacement: [f64; 2],
    /// The neighbour; `None` for a guard.
    pub to: Option<u32>,
    /// The smaller of the cotangents of the two angles opposite to the edge. Above 0, the straight line between the ends stays in
    /// the cells of these two points (an edge of the Gabriel graph). The higher the value, the farther away are the points at the
    /// sides of the edge.
    pub clearance: f64,
}

/// The Delaunay graph of points and their Voronoi cells.
#[derive(Clone, Debug)]
pub struct Delaunay {
    /// The rectangle in which the points lie.
    pub extent: Extent,
    /// The points, px, folded into the extent along the axes that wrap.
    pub points: Vec<[f64; 2]>,
    /// For each point, the range of its axes.
    starts: Vec<u32>,
    axes: Vec<Axis>,
    /// The corner of the cell after each axis, relative to the point, px.
    corners: Vec<[f64; 2]>,
}

/// Number of guards round points that do not wrap. Fewer would leave long triangles at the outermost points.
const GUARDS: usize = 16;
/// Distance of the guards from the middle, in diagonals of the extent: then every place of the extent is nearer to a point than to
/// a guard.
const GUARDED: f64 = 4.0;

impl Delaunay {
    /// The graph of `points`, px. If points coincide, only the first one has neighbours. Points with coordinates that are not
    /// finite have none.
    ///
    /// ```
    /// use dapple_engine::points::delaunay::Delaunay;
    /// use dapple_engine::points::extent::Extent;
    ///
    /// let extent = Extent { size: [30.0, 10.0], wrap: [false, false] };
    /// let graph = Delaunay::new(&[[5.0, 5.0], [15.0, 4.0], [25.0, 5.0]], extent);
    /// assert!(graph.neighbours(1).count() >= 2);
    /// ```
    #[must_use]
    pub fn new(points: &[[f64; 2]], extent: Extent) -> Self {
        let points: Vec<[f64; 2]> = points.iter().map(|at| tame(extent.folded(*at))).collect();
        let sites = distinct(&points);
        let longest = extent.size[0].max(extent.size[1]);
        // Poisson discs leave empty circles of at most 1.2 mean distances, random points of 2–3.
        let mean = (extent.size[0] * extent.size[1] / sites.len().max(1) as f64).sqrt();
        let mut margin = (3.0 * mean).min(1.5 * longest);
        loop {
            let mesh = guarded(&points, &sites, &extent, margin);
            // With one point and its copies, the radius of the empty circles is at most .71 of the longer side.
            let surely = margin >= 1.5 * longest;
            if let Some(graph) =
                Self::read(&mesh, &points, extent, if surely { f64::INFINITY } else { margin })
            {
                return graph;
            }
            margin = (2.0 * margin).min(1.5 * longest);
        }
    }

    /// The graph of a triangulation; `None` if the circumcircle of a triangle reaches beyond the `margin` that holds copies.
    fn read(mesh: &Mesh, points: &[[f64; 2]], extent: Extent, margin: f64) -> Option<Self> {
        let margin = Margin { size: extent.size, wrap: extent.wrap, width: margin };
        let mut own: Vec<Option<FixedVertexHandle>> = vec![None; points.len()];
        for vertex in mesh.vertices() {
            if let Corner { point: Some(index), own: true, .. } = vertex.data() {
                own[*index as usize] = Some(vertex.fix());
            }
        }
        let (mut starts, mut axes, mut corners) = (vec![0], Vec::new(), Vec::new());
        for (at, vertex) in points.iter().zip(own) {
            let first = corners.len();
            for edge in vertex.iter().flat_map(|vertex| mesh.vertex(*vertex).out_edges()) {
                // The face at the left of an edge lies between it and the next one: edges go counterclockwise.
                let Some(face) = edge.face().as_inner() else { continue };
                let circle = face.circumcircle();
                if !margin.holds_circle(circle) {
                    return None;
                }
                let center = circle.0;
                let to = edge.to();
                let displacement = [to.position().x - at[0], to.position().y - at[1]];
                axes.push(Axis { displacement, to: to.data().point, clearance: 0.0 });
                corners.push([center.x - at[0], center.y - at[1]]);
            }
            let count = corners.len() - first;
            for k in 0..count {
                let sides = [corners[first + k], corners[first + (k + count - 1) % count]];
                let axis = &mut axes[first + k];
                // The circumcentre is half an edge times the cotangent of the opposite angle away from the edge.
                let square =
                    axis.displacement[0] * axis.displacement[0] + axis.displacement[1] * axis.displacement[1];
                let [after, before] = sides.map(|corner| {
                    2.0 * (axis.displacement[0] * corner[1] - axis.displacement[1] * corner[0]) / square
                });
                axis.clearance = after.min(-before);
            }
            starts.push(axes.len() as u32);
        }
        Some(Self { extent, points: points.to_vec(), starts, axes, corners })
    }

    /// The edges of a point, in order round it.
    #[must_use]
    pub fn axes(&self, point: usize) -> &[Axis] {
        &self.axes[self.starts[point] as usize..self.starts[point + 1] as usize]
    }

    /// The corners of a point's Voronoi cell in order round it, relative to the point, px.
    #[must_use]
    pub fn cell(&self, point: usize) -> &[[f64; 2]] {
        &self.corners[self.starts[point] as usize..self.starts[point + 1] as usize]
    }

    /// The neighbours of a point, without guards; if a copy of a point is a neighbour, the index of the point itself.
    pub fn neighbours(&self, point: usize) -> impl Iterator<Item = usize> {
        self.axes(point).iter().filter_map(|axis| axis.to).map(|to| to as usize)
    }

    /// For each edge between two neighbours of a point, the point on its other side, with the clearance of that edge.
    pub fn opposite(&self, point: usize) -> impl Iterator<Item = (usize, f64)> {
        let axes = self.axes(point);
        (0..axes.len()).filter_map(move |k| {
            let (one, next) = (&axes[k], &axes[(k + 1) % axes.len()]);
            // In the order round the neighbour, this edge comes after the opposite point and before the point itself.
            let ring = self.axes(one.to? as usize);
            let displacement =
                [next.displacement[0] - one.displacement[0], next.displacement[1] - one.displacement[1]];
            let same = |axis: &Axis| {
                axis.to == next.to
                    && (0..2)
                        .all(|k| (axis.displacement[k] - displacement[k]).abs() < 0.1 * self.extent.size[k])
            };
            let edge = ring.iter().position(same)?;
            let before = &ring[(edge + ring.len() - 1) % ring.len()];
            Some((before.to? as usize, ring[edge].clearance))
        })
    }

    /// Area of a point's Voronoi cell, px²; 0 for points without neighbours.
    #[must_use]
    pub fn area(&self, point: usize) -> f64 {
        area(self.cell(point))
    }

    /// Area, px², of the part of a point's cell that lies on the extent. Along an axis that wraps, the whole cell counts.
    #[must_use]
    pub fn area_inside(&self, point: usize) -> f64 {
        let at = self.points[point];
        let cell: Vec<[f64; 2]> =
            self.cell(point).iter().map(|corner| [at[0] + corner[0], at[1] + corner[1]]).collect();
        area(&clipped(cell, &self.extent))
    }
}

/// Area of a polygon, px².
///
/// ```
/// use dapple_engine::points::delaunay::area;
///
/// assert_eq!(area(&[[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]]), 12.0);
/// ```
#[must_use]
pub fn area(corners: &[[f64; 2]]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    0.5 * corners.iter().zip(next).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum::<f64>().abs()
}

/// The part of a polygon that lies on the extent, cut at the borders that do not wrap (Sutherland and Hodgman). The parts of a
/// concave polygon may be joined along the border, which does not change the area.
#[must_use]
pub fn clipped(mut corners: Vec<[f64; 2]>, extent: &Extent) -> Vec<[f64; 2]> {
    for axis in (0..2).filter(|axis| !extent.wrap[*axis]) {
        for (sign, limit) in [(1.0, 0.0), (-1.0, -extent.size[axis])] {
            let depth = |at: [f64; 2]| sign * at[axis] - limit;
            let mut kept = Vec::with_capacity(corners.len() + 2);
            for (k, at) in corners.iter().enumerate() {
                let next = corners[(k + 1) % corners.len()];
                let (here, there) = (depth(*at), depth(next));
                if here >= 0.0 {
                    kept.push(*at);
                }
                if (here >= 0.0) != (there >= 0.0) {
                    let t = here / (here - there);
                    kept.push([0, 1].map(|axis| at[axis] + t * (next[axis] - at[axis])));
                }
            }
            corners = kept;
        }
    }
    corners
}

/// The triangulation of the points of `sites`, their copies up to `margin` px beyond the borders that wrap, and the guards.
fn guarded(points: &[[f64; 2]], sites: &[u32], extent: &Extent, margin: f64) -> Mesh {
    let [mut low, mut high] = [[0.0; 2], extent.size];
    for index in sites {
        let at = points[*index as usize];
        low = [0, 1].map(|axis| at[axis].min(low[axis]));
        high = [0, 1].map(|axis| at[axis].max(high[axis]));
    }
    let beyond = [0, 1].map(|axis| if extent.wrap[axis] { margin } else { 0.0 });
    let window = [[low[0] - beyond[0], low[1] - beyond[1]], [high[0] + beyond[0], high[1] + beyond[1]]];
    let framed = Margin { size: extent.size, wrap: extent.wrap, width: margin };
    let mut all = framed.corners(points, sites);
    if !extent.wrap.iter().all(|wrap| *wrap) {
        let reach = GUARDED * libm::hypot(window[1][0] - window[0][0], window[1][1] - window[0][1]);
        let middle = [0, 1].map(|axis| 0.5 * (window[0][axis] + window[1][axis]));
        for k in 0..GUARDS {
            // Rotated a little: guards and points of a lattice on a common circle would be an ambiguous case.
            let (s, c) = libm::sincos(std::f64::consts::TAU * (k as f64 + 0.137) / GUARDS as f64);
            all.push(Corner::guard([middle[0] + reach * c, middle[1] + reach * s]));
        }
    }
    triangulated(all)
}

#[cfg(test)]
mod tests;
