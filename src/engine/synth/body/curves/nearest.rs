//! The vertex of a set that is nearest to each vertex along the surface.

use crate::grid::{Domain, UnionFind};
use crate::surface::Surface;

/// The way to a set of vertices.
pub struct Nearest {
    /// The distance of each vertex, px; infinite where no way leads there.
    pub distance: Vec<f64>,
    /// The vertex of the set that is nearest to it; itself where no way leads there.
    pub to: Vec<u32>,
}

impl Nearest {
    /// The ways to the vertices that are `set`; `None` without any.
    #[must_use]
    pub fn new(surface: &Surface, set: &[bool]) -> Option<Self> {
        if !set.contains(&true) {
            return None;
        }
        let distance: Vec<f64> = surface.distances(set)?.iter().map(|away| away * surface.unit()).collect();
        let mut order: Vec<u32> = (0..distance.len() as u32).collect();
        order.sort_by(|a, b| distance[*a as usize].total_cmp(&distance[*b as usize]).then(a.cmp(b)));
        let mut to: Vec<u32> = (0..distance.len() as u32).collect();
        let mut is_known: Vec<bool> = set.to_vec();
        for vertex in order.into_iter().map(|vertex| vertex as usize) {
            if set[vertex] || !distance[vertex].is_finite() {
                continue;
            }
            // Down the steepest way: through the neighbour from which the rest of the way is shortest.
            let through = |other: &usize| distance[*other] + apart(surface, vertex, *other);
            let known = surface.ring(vertex).filter(|other| is_known[*other]);
            if let Some(next) = known.min_by(|a, b| through(a).total_cmp(&through(b)).then(a.cmp(b))) {
                to[vertex] = to[next];
                is_known[vertex] = true;
            }
        }
        Some(Self { distance, to })
    }
}

/// The straight distance between two vertices, px.
#[must_use]
pub fn apart(surface: &Surface, a: usize, b: usize) -> f64 {
    let [a, b] = [a, b].map(|vertex| surface.mesh.positions[vertex]);
    (0..3).map(|i| (a[i] - b[i]) * (a[i] - b[i])).sum::<f64>().sqrt()
}

/// The connected parts of the vertices that are `set`.
#[must_use]
pub fn parts(surface: &Surface, set: &[bool]) -> UnionFind {
    let mut parts = UnionFind::new(set.len());
    for face in &surface.mesh.faces {
        for k in 0..3 {
            let (a, b) = (face[k], face[(k + 1) % 3]);
            if set[a as usize] && set[b as usize] {
                parts.join(a, b, [0, 0]);
            }
        }
    }
    parts
}

/// The vertices beside which another one is nearest to another part: those in the middle between two marks.
#[must_use]
pub fn between(surface: &Surface, nearest: &Nearest, parts: &UnionFind) -> Vec<bool> {
    let part = |vertex: usize| parts.root(nearest.to[vertex]).0;
    let is_between = |vertex: usize| {
        let own = part(vertex);
        nearest.distance[vertex].is_finite() && surface.ring(vertex).any(|other| part(other) != own)
    };
    (0..nearest.to.len()).map(is_between).collect()
}
