//! Delaunay edges between points, also on a tile.

use spade::{Point2, Triangulation, handles::UndirectedEdgeHandle};

use crate::grid::triangulation::{Corner, Margin, distinct, tame, triangulated};

/// A Delaunay edge between two of the points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    /// Indices of the points it joins; equal where a wrapped point neighbours its own copy.
    pub ends: [usize; 2],
    /// Length of the edge, px.
    pub length: f64,
    /// The point halfway, px; inside the tile where there is one.
    pub midpoint: [f64; 2],
    /// Whether it is part of the convex hull; never on a tile.
    pub hull: bool,
    /// Cosine of the larger of the angles opposite to it; 1 where no triangle is beside it.
    pub cos_opposite: f64,
}

type MeshEdge<'a> = UndirectedEdgeHandle<'a, Corner, (), (), ()>;

/// The Delaunay edges of `points` (px), each once; on a tile of `wrap` px those across its border too.
///
/// Of points that coincide only one is joined; points that are not finite are left out. Where more than three
/// points lie on one empty circle (a square lattice), one of the possible triangulations is taken.
#[must_use]
pub fn edges(points: &[[f64; 2]], wrap: Option<[f64; 2]>) -> Vec<Edge> {
    let places: Vec<[f64; 2]> = points.iter().map(|point| tame(folded(*point, wrap))).collect();
    match wrap {
        None => plain(&places),
        Some(tile) => wrapped(&places, tile),
    }
}

/// The place of a point on the tile, where there is one.
fn folded(point: [f64; 2], wrap: Option<[f64; 2]>) -> [f64; 2] {
    let Some(tile) = wrap else { return point };
    [0, 1].map(|axis| {
        let at = point[axis].rem_euclid(tile[axis]);
        // The remainder of a tiny negative number is rounded up to the side itself.
        if at >= tile[axis] { 0.0 } else { at }
    })
}

fn plain(places: &[[f64; 2]]) -> Vec<Edge> {
    let plane = Margin { size: [0.0; 2], wrap: [false; 2], width: 0.0 };
    let mesh = triangulated(plane.corners(places, &distinct(places)));
    let mut edges: Vec<Edge> = mesh.undirected_edges().map(measured).collect();
    edges.sort_by_key(|edge| edge.ends);
    edges
}

fn measured(edge: MeshEdge) -> Edge {
    let [a, b] = edge.vertices().map(|vertex| vertex.position());
    let [i, j] = edge.vertices().map(|vertex| vertex.data().point.map_or(0, |point| point as usize));
    let sides = [edge.as_directed(), edge.as_directed().rev()];
    let opposite = sides.into_iter().filter_map(|side| side.opposite_position());
    Edge {
        ends: [i.min(j), i.max(j)],
        length: a.distance_2(b).sqrt(),
        midpoint: [0.5 * (a.x + b.x), 0.5 * (a.y + b.y)],
        hull: edge.is_part_of_convex_hull(),
        cos_opposite: opposite.map(|apex| cos_at(apex, a, b)).fold(1.0, f64::min),
    }
}

/// Cosine of the angle at `apex` between the directions to `a` and `b`.
fn cos_at(apex: Point2<f64>, a: Point2<f64>, b: Point2<f64>) -> f64 {
    let dot = (a.x - apex.x) * (b.x - apex.x) + (a.y - apex.y) * (b.y - apex.y);
    dot / (apex.distance_2(a) * apex.distance_2(b)).sqrt()
}

/// Periodic Delaunay edges: of the tile's points and their copies in a margin around it.
///
/// The margin is wide enough once no circumcircle at an edge that counts reaches beyond it; a tile's diagonal
/// always is, since no empty circle's radius exceeds half of it.
fn wrapped(places: &[[f64; 2]], tile: [f64; 2]) -> Vec<Edge> {
    let sites = distinct(places);
    if sites.is_empty() || !tile.iter().all(|side| *side > 0.0 && side.is_finite()) {
        return Vec::new();
    }
    let mean_distance = (tile[0] * tile[1] / sites.len() as f64).sqrt();
    let surely = 1.01 * (tile[0] * tile[0] + tile[1] * tile[1]).sqrt();
    let copies =
        |margin: f64| sites.len() as f64 * tile.map(|side| 1.0 + 2.0 * margin / side).iter().product::<f64>();
    // Random points leave empty circles of some 2–3 mean distances at most, so four are nearly always enough.
    let mut margin = (4.0 * mean_distance).min(surely);
    loop {
        if let Some(edges) = wrapped_within(places, &sites, tile, margin, surely) {
            return edges;
        }
        if margin >= surely {
            return Vec::new();
        }
        // A long narrow tile has very many copies within its diagonal.
        margin = if copies(surely) > MANY_COPIES { (2.0 * margin).min(surely) } else { surely };
    }
}

/// From so many copies of points on they are laid in steps, as far as they are needed.
const MANY_COPIES: f64 = 1e5;

/// `None` where a margin below the `surely` sufficient one turns out too narrow.
fn wrapped_within(
    places: &[[f64; 2]],
    sites: &[u32],
    tile: [f64; 2],
    width: f64,
    surely: f64,
) -> Option<Vec<Edge>> {
    let margin = Margin { size: tile, wrap: [true; 2], width };
    let mesh = triangulated(margin.corners(places, sites));
    // Every edge has one copy whose midpoint is in a window of the tile's size. The window is shifted a little: midpoints on
    // its border could be lost or counted twice by rounding, and those of lattices often lie on the tile's border.
    let corner = [-0.001_877_31 * width, -0.001_331_79 * width];
    let mut edges = Vec::new();
    for edge in mesh.undirected_edges() {
        let mut found = Edge { hull: false, ..measured(edge) };
        let inside = |k: usize| found.midpoint[k] >= corner[k] && found.midpoint[k] < corner[k] + tile[k];
        if !(inside(0) && inside(1)) {
            continue;
        }
        for side in [edge.as_directed(), edge.as_directed().rev()] {
            let circle = side.face().as_inner()?.circumcircle();
            if width < surely && !margin.holds_circle(circle) {
                return None;
            }
        }
        found.midpoint = [found.midpoint[0].rem_euclid(tile[0]), found.midpoint[1].rem_euclid(tile[1])];
        edges.push(found);
    }
    edges.sort_by(|a, b| a.ends.cmp(&b.ends).then(a.length.total_cmp(&b.length)));
    Some(edges)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn copies_on_a_long_narrow_tile_that_are_laid_in_steps_are_enough() {
        let tile = [3000.0, 1.0];
        let number = |i: usize, step: f64| (0.5 + step * i as f64).fract();
        let points: Vec<[f64; 2]> =
            (0..25).map(|i| [3000.0 * number(i, 0.754_877_7), number(i, 0.569_840_3)]).collect();
        let surely = 3100.0;
        let all = wrapped_within(&points, &distinct(&points), tile, surely, surely).expect("wide enough");
        let found = edges(&points, Some(tile));
        assert_eq!(found.len(), 3 * points.len());
        for (found, expected) in found.iter().zip(&all) {
            assert!(found.ends == expected.ends && (found.length - expected.length).abs() < 1e-6);
        }
    }
}
