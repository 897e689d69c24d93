//! Remeshing as a value: it is begun, advanced round by round, and completed or dropped.

use super::features::Original;
use super::half_edges::HalfEdges;
use super::{collapse, flip, order, relax, split, subdivide};
use crate::surface::mesh::Mesh;
use crate::surface::morton;

/// Ratio of the edge lengths of the coarse and the fine mesh. The coarse mesh is made even, and then each of its triangles is cut
/// into four. Compared with rounds on the fine mesh this takes half of the time, and a twentieth of the vertices do not have six
/// neighbours instead of a fifth.
const COARSER: f64 = 2.0;
/// Rounds of splits, collapses, flips and moves on the coarse mesh. With 5 the least angle of 12,000 vertices is 3° smaller, with
/// 12 there is no difference.
const ROUNDS: usize = 8;
/// Rounds of flips towards larger angles and of moves on the fine mesh.
const LAST_ROUNDS: usize = 3;
/// Mean area of cells of the mesh made for a wanted length of 1, before the lengths are corrected for it, as a share of that of a
/// regular triangulation with this edge. Measured on spheres, a torus and a cube.
const AREA_SHARE: f64 = 1.03;
/// Bounds of wanted lengths, in sizes of the mesh.
const LENGTHS: [f64; 2] = [1e-4, 1.0];

/// The next work of [`Remeshing::advance`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Next {
    Collapse,
    Split,
    /// Remaining rounds on the coarse mesh.
    Rounds(usize),
    Subdivide,
    /// Remaining rounds on the fine mesh.
    LastRounds(usize),
    Nothing,
}

/// A mesh during its remeshing.
pub struct Remeshing {
    made: HalfEdges,
    /// The coarse mesh, once it is even.
    coarse: Mesh,
    original: Original,
    /// The size of the mesh.
    size: f64,
    next: Next,
}

impl Remeshing {
    /// Begins with a mesh that [`prepare`](crate::surface::prepare()) returned; see [`remesh`](super::remesh()).
    #[must_use]
    pub fn new(mesh: &Mesh, edge: &(impl Fn([f64; 3]) -> f64 + Sync)) -> Self {
        let size = mesh.size();
        let mut made = HalfEdges::new(mesh, &wanted(size, COARSER, edge));
        let original = Original::new(mesh, &mut made);
        Self { made, coarse: Mesh::default(), original, size, next: Next::Collapse }
    }

    /// Does one round; `edge` gives the length that edges should have at a place, and must not have changed. Returns whether there
    /// is more to do.
    pub fn advance(&mut self, edge: &(impl Fn([f64; 3]) -> f64 + Sync)) -> bool {
        let Self { made, coarse, original, size, next } = self;
        let [coarser, fine] = [COARSER, 1.0].map(|coarser| wanted(*size, coarser, edge));
        *next = match *next {
            Next::Collapse => {
                collapse::collapse_short(made, &coarser);
                Next::Split
            }
            Next::Split => {
                let is_split = split::split_long(made, &coarser);
                *made = order::ordered(made);
                if is_split {
                    flip::towards_larger_angles(made);
                    Next::Split
                } else {
                    Next::Rounds(ROUNDS)
                }
            }
            Next::Rounds(0) => Next::Subdivide,
            Next::Rounds(left) => {
                split::split_long(made, &coarser);
                collapse::collapse_short(made, &coarser);
                flip::towards_even_valence(made);
                relax::relax(made, original, &coarser);
                Next::Rounds(left - 1)
            }
            Next::Subdivide => {
                *coarse = made.to_mesh();
                *made = order::ordered(&subdivide::subdivided(made, &fine));
                Next::LastRounds(LAST_ROUNDS)
            }
            Next::LastRounds(left) => {
                flip::towards_larger_angles(made);
                if left > 0 {
                    relax::relax(made, original, &fine);
                    Next::LastRounds(left - 1)
                } else {
                    Next::Nothing
                }
            }
            Next::Nothing => Next::Nothing,
        };
        *next != Next::Nothing
    }

    /// The share of the rounds that is done, 0..1, weighted by their time.
    #[must_use]
    pub fn share(&self) -> f64 {
        let of = |left: usize, all: usize| (all - left) as f64 / all as f64;
        match self.next {
            Next::Collapse | Next::Split => 0.0,
            Next::Rounds(left) => 0.4 * of(left, ROUNDS),
            Next::Subdivide => 0.4,
            Next::LastRounds(left) => 0.5 + 0.5 * of(left, LAST_ROUNDS),
            Next::Nothing => 1.0,
        }
    }

    /// The current mesh, and before it the one with edges twice as long, which has no faces until it is even.
    #[must_use]
    pub fn into_meshes(self) -> [Mesh; 2] {
        [&self.coarse, &self.made.to_mesh()].map(morton::ordered)
    }
}

/// The lengths of `edge` within bounds, for a mesh of this size whose edges are `coarser` times as long.
fn wanted(
    size: f64,
    coarser: f64,
    edge: &(impl Fn([f64; 3]) -> f64 + Sync),
) -> impl Fn([f64; 3]) -> f64 + Sync {
    let scale = coarser * (1.0 / AREA_SHARE).sqrt();
    move |at: [f64; 3]| {
        let length = edge(at) * scale / size;
        size * if length.is_nan() { 1.0 } else { length.clamp(LENGTHS[0], LENGTHS[1]) }
    }
}
