//! Delaunay edges between points, also on a tile (spade).

use spade::{DelaunayTriangulation, HasPosition, Point2, Triangulation, handles::UndirectedEdgeHandle};

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

/// A point of the triangulation with its index.
struct Site {
    position: Point2<f64>,
    index: usize,
}

impl HasPosition for Site {
    type Scalar = f64;

    fn position(&self) -> Point2<f64> {
        self.position
    }
}

type Mesh = DelaunayTriangulation<Site>;
type MeshEdge<'a> = UndirectedEdgeHandle<'a, Site, (), (), ()>;

/// The Delaunay edges of `points` (px), each once; on a tile of `wrap` px those across its border too.
///
/// Of points that coincide only one is joined; points that are not finite are left out. Where more than three
/// points lie on one empty circle (a square lattice), one of the possible triangulations is taken.
#[must_use]
pub fn edges(points: &[[f64; 2]], wrap: Option<[f64; 2]>) -> Vec<Edge> {
    let sites = distinct(points, wrap);
    match wrap {
        None => plain(sites),
        Some(tile) => wrapped(&sites, tile),
    }
}

/// The points' places, without repetitions, in their order; folded into the tile.
fn distinct(points: &[[f64; 2]], wrap: Option<[f64; 2]>) -> Vec<([f64; 2], usize)> {
    // spade takes no coordinates closer to 0 than 2⁻¹⁴² and none over 2²⁰¹; px are nowhere near either.
    let tame = |x: f64| if x.abs() < 1e-30 { 0.0 } else { x };
    let fold = |x: f64, side: f64| if x.rem_euclid(side) < side { x.rem_euclid(side) } else { 0.0 };
    let place = |p: [f64; 2]| match wrap {
        Some(tile) => [tame(fold(p[0], tile[0])), tame(fold(p[1], tile[1]))],
        None => p.map(tame),
    };
    let kept = points.iter().enumerate().filter(|(_, p)| p.iter().all(|x| x.abs() < 1e30));
    let mut sites: Vec<_> = kept.map(|(index, p)| (place(*p), index)).collect();
    sites.sort_by(|(a, i), (b, j)| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])).then(i.cmp(j)));
    sites.dedup_by(|(a, _), (b, _)| a == b);
    sites.sort_by_key(|(_, index)| *index);
    sites
}

fn triangulate(sites: Vec<Site>) -> Mesh {
    Mesh::bulk_load_stable(sites).unwrap_or_default()
}

fn plain(sites: Vec<([f64; 2], usize)>) -> Vec<Edge> {
    let sites = sites.into_iter().map(|([x, y], index)| Site { position: Point2::new(x, y), index });
    let mesh = triangulate(sites.collect());
    let mut edges: Vec<Edge> = mesh.undirected_edges().map(measured).collect();
    edges.sort_by_key(|edge| edge.ends);
    edges
}

fn measured(edge: MeshEdge) -> Edge {
    let [a, b] = edge.vertices().map(|vertex| vertex.position());
    let [i, j] = edge.vertices().map(|vertex| vertex.data().index);
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
fn wrapped(sites: &[([f64; 2], usize)], tile: [f64; 2]) -> Vec<Edge> {
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
        if let Some(edges) = wrapped_within(sites, tile, margin, surely) {
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
    sites: &[([f64; 2], usize)],
    tile: [f64; 2],
    margin: f64,
    surely: f64,
) -> Option<Vec<Edge>> {
    let copies = [(margin / tile[0]).ceil() as i32 + 1, (margin / tile[1]).ceil() as i32 + 1];
    let near = |p: f64, side: f64| p >= -margin && p <= side + margin;
    let mut all = Vec::new();
    for down in -copies[1]..=copies[1] {
        for across in -copies[0]..=copies[0] {
            let shift = [f64::from(across) * tile[0], f64::from(down) * tile[1]];
            for &([x, y], index) in sites {
                let (x, y) = (x + shift[0], y + shift[1]);
                if near(x, tile[0]) && near(y, tile[1]) {
                    all.push(Site { position: Point2::new(x, y), index });
                }
            }
        }
    }
    let mesh = triangulate(all);
    // Every edge has one copy whose midpoint is in a window of the tile's size. The window is shifted a little: midpoints on
    // its border could be lost or counted twice by rounding, and those of lattices often lie on the tile's border.
    let corner = [-0.001_877_31 * margin, -0.001_331_79 * margin];
    let mut edges = Vec::new();
    for edge in mesh.undirected_edges() {
        let mut found = Edge { hull: false, ..measured(edge) };
        let inside = |k: usize| found.midpoint[k] >= corner[k] && found.midpoint[k] < corner[k] + tile[k];
        if !(inside(0) && inside(1)) {
            continue;
        }
        for side in [edge.as_directed(), edge.as_directed().rev()] {
            let (center, square) = side.face().as_inner()?.circumcircle();
            let radius = square.sqrt();
            let held = |p: f64, side: f64| near(p - radius, side) && near(p + radius, side);
            if margin < surely && !(held(center.x, tile[0]) && held(center.y, tile[1])) {
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
        let all = wrapped_within(&distinct(&points, Some(tile)), tile, surely, surely).expect("wide enough");
        let found = edges(&points, Some(tile));
        assert_eq!(found.len(), 3 * points.len());
        for (found, expected) in found.iter().zip(&all) {
            assert!(found.ends == expected.ends && (found.length - expected.length).abs() < 1e-6);
        }
    }
}
