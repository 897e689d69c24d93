//! Triangulation of implicit bodies (functions that are negative inside) by surface nets (Gibson 1998), with a vertex for each
//! sheet in a cell (Nielson 2004).

use rayon::prelude::*;

use super::super::mesh::Mesh;
use super::super::model::{Corner, Face, Model, Part};
use super::bars::dot;
use super::sheets::{Sheets, edge, edges};
use crate::grid::UnionFind;

/// Samples along the side of a block that is skipped as a whole if its middle is far from the surface.
const BLOCK: usize = 4;
/// Rounds in which vertices are moved apart and back onto the surface.
const ROUNDS: usize = 3;
/// Shifts of the lattice, in cells, that are tried until no edge has more than two faces.
const SHIFTS: [f64; 4] = [0.0, 0.3, 0.6, 0.85];

/// Values on a regular lattice.
struct Lattice {
    low: [f64; 3],
    cell: f64,
    counts: [usize; 3],
    values: Vec<f64>,
}

impl Lattice {
    fn sampled(field: &(impl Fn([f64; 3]) -> f64 + Sync), [low, high]: [[f64; 3]; 2], cell: f64) -> Self {
        let counts: [usize; 3] = [0, 1, 2].map(|axis| ((high[axis] - low[axis]) / cell).ceil() as usize + 2);
        let place = |at: [usize; 3]| [0, 1, 2].map(|axis| low[axis] + cell * at[axis] as f64);
        let layer = counts[0] * counts[1];
        let mut values = vec![0.0; layer * counts[2]];
        values.par_chunks_mut(layer * BLOCK).enumerate().for_each(|(slab, values)| {
            let z = slab * BLOCK..(slab * BLOCK + values.len() / layer);
            for y in (0..counts[1]).step_by(BLOCK) {
                for x in (0..counts[0]).step_by(BLOCK) {
                    let half = 0.5 * (BLOCK - 1) as f64 * cell;
                    let middle = place([x, y, z.start]).map(|at| at + half);
                    let far = field(middle);
                    // The slope of the function may be up to 1.5.
                    let is_far = far.abs() > 1.5 * half * 3.0_f64.sqrt() + cell;
                    for k in z.clone() {
                        for j in y..(y + BLOCK).min(counts[1]) {
                            for i in x..(x + BLOCK).min(counts[0]) {
                                values[(k - z.start) * layer + j * counts[0] + i] =
                                    if is_far { far } else { field(place([i, j, k])) };
                            }
                        }
                    }
                }
            }
        });
        Self { low, cell, counts, values }
    }

    fn index(&self, [x, y, z]: [usize; 3]) -> usize {
        (z * self.counts[1] + y) * self.counts[0] + x
    }

    /// The sheets of the surface in a cell: for each edge of the cell the number of the sheet that crosses it.
    fn sheets(&self, cell: [usize; 3]) -> Sheets {
        let mut inside = [false; 8];
        for (corner, inside) in inside.iter_mut().enumerate() {
            *inside = self.values[self.index([0, 1, 2].map(|axis| cell[axis] + (corner >> axis & 1)))] < 0.0;
        }
        Sheets::new(inside)
    }

    /// The mean of the places where a sheet crosses the edges of a cell.
    fn middle(&self, cell: [usize; 3], sheets: &Sheets, sheet: u8) -> [f64; 3] {
        let mut sum = [0.0; 3];
        let mut count = 0.0;
        for (axis, corner) in edges().filter(|(axis, corner)| sheets.of_edge[edge(*axis, *corner)] == sheet) {
            let value = |corner: usize| {
                self.values[self.index([0, 1, 2].map(|axis| cell[axis] + (corner >> axis & 1)))]
            };
            let [a, b] = [value(corner), value(corner | 1 << axis)];
            let mut at = [0, 1, 2].map(|axis| (corner >> axis & 1) as f64);
            at[axis] = a / (a - b);
            sum = [0, 1, 2].map(|axis| sum[axis] + at[axis]);
            count += 1.0;
        }
        [0, 1, 2].map(|axis| self.low[axis] + self.cell * (cell[axis] as f64 + sum[axis] / count))
    }

    /// A vertex for each sheet in each cell, a square around each edge of the lattice that the surface crosses.
    fn net(&self) -> Mesh {
        let mut mesh = Mesh::default();
        // By cell: its first vertex.
        let mut vertices = vec![u32::MAX; self.values.len()];
        let [nx, ny, nz] = self.counts;
        for (z, y, x) in triples([nz - 1, ny - 1, nx - 1]) {
            let sheets = self.sheets([x, y, z]);
            vertices[self.index([x, y, z])] = mesh.positions.len() as u32;
            mesh.positions.extend((0..sheets.count).map(|sheet| self.middle([x, y, z], &sheets, sheet)));
        }
        for (z, y, x) in triples([nz - 1, ny - 1, nx - 1]) {
            let at = [x, y, z];
            for axis in 0..3 {
                let mut next = at;
                next[axis] += 1;
                let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
                let [is_in, is_next_in] = [at, next].map(|at| self.values[self.index(at)] < 0.0);
                if is_in == is_next_in || at[u] == 0 || at[v] == 0 {
                    continue;
                }
                let vertex = |[back_u, back_v]: [usize; 2]| {
                    let mut cell = at;
                    cell[u] -= back_u;
                    cell[v] -= back_v;
                    let sheet = self.sheets(cell).of_edge[edge(axis, back_u << u | back_v << v)];
                    vertices[self.index(cell)] + u32::from(sheet)
                };
                let square = [[1, 1], [0, 1], [0, 0], [1, 0]].map(vertex);
                push_square(
                    &mut mesh,
                    if is_in { square } else { [square[3], square[2], square[1], square[0]] },
                );
            }
        }
        mesh
    }
}

fn triples([a, b, c]: [usize; 3]) -> impl Iterator<Item = (usize, usize, usize)> {
    (0..a).flat_map(move |i| (0..b).flat_map(move |j| (0..c).map(move |k| (i, j, k))))
}

/// Two triangles, cut along the shorter diagonal.
fn push_square(mesh: &mut Mesh, [a, b, c, d]: [u32; 4]) {
    let length = |from: u32, to: u32| {
        let [from, to] = [from, to].map(|vertex| mesh.positions[vertex as usize]);
        let way: [f64; 3] = [0, 1, 2].map(|axis| to[axis] - from[axis]);
        dot(way, way)
    };
    let triangles =
        if length(a, c) <= length(b, d) { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] };
    mesh.faces.extend(triangles);
}

/// The triangles of the surface where a function is 0; it is positive outside. Its slope should be about 1. The box `bounds` must
/// contain the body; `cell` is the approximate length of the edges.
fn mesh(field: &(impl Fn([f64; 3]) -> f64 + Sync), bounds: [[f64; 3]; 2], cell: f64) -> Mesh {
    let mut nets = SHIFTS.into_iter().map(|shift| {
        let shifted = [bounds[0].map(|low| low - shift * cell), bounds[1]];
        Lattice::sampled(field, shifted, cell).net()
    });
    // If two pairs of sheets meet in neighbouring cells, an edge has four faces: a shifted lattice avoids it.
    let mut mesh = largest(&nets.find(is_manifold).unwrap_or_default());
    let mut neighbours: Vec<Vec<u32>> = vec![Vec::new(); mesh.positions.len()];
    for [a, b, c] in &mesh.faces {
        for (from, to) in [(a, b), (b, c), (c, a)] {
            neighbours[*from as usize].push(*to);
        }
    }
    for _ in 0..ROUNDS {
        let before = &mesh.positions;
        mesh.positions = (0..before.len())
            .into_par_iter()
            .map(|vertex| {
                let around = &neighbours[vertex];
                let mean = |axis| {
                    around.iter().map(|other| before[*other as usize][axis]).sum::<f64>()
                        / around.len() as f64
                };
                let place: [f64; 3] = [0, 1, 2].map(|axis| 0.5 * (before[vertex][axis] + mean(axis)));
                onto(field, place, cell)
            })
            .collect();
    }
    mesh
}

/// The largest connected part, without cavities and fragments.
fn largest(mesh: &Mesh) -> Mesh {
    // By vertex: the lowest vertex that it is connected with.
    let mut united = UnionFind::new(mesh.positions.len());
    for [a, b, c] in &mesh.faces {
        united.join(*a, *b, [0, 0]);
        united.join(*a, *c, [0, 0]);
    }
    let roots: Vec<usize> =
        (0..mesh.positions.len()).map(|vertex| united.find(vertex as u32).0 as usize).collect();
    let mut counts = vec![0_usize; roots.len()];
    roots.iter().for_each(|root| counts[*root] += 1);
    let most = (0..counts.len()).max_by_key(|root| counts[*root]);
    let mut kept = Mesh::default();
    let mut vertices = vec![u32::MAX; roots.len()];
    for (vertex, position) in
        mesh.positions.iter().enumerate().filter(|(vertex, _)| Some(roots[*vertex]) == most)
    {
        vertices[vertex] = kept.positions.len() as u32;
        kept.positions.push(*position);
    }
    let faces = mesh.faces.iter().filter(|face| vertices[face[0] as usize] != u32::MAX);
    kept.faces = faces.map(|face| face.map(|vertex| vertices[vertex as usize])).collect();
    kept
}

/// Whether every edge has at most one face on either side.
fn is_manifold(mesh: &Mesh) -> bool {
    let edges = mesh.faces.iter().flat_map(|[a, b, c]| [[*a, *b], [*b, *c], [*c, *a]]);
    let mut edges: Vec<[u32; 2]> = edges.collect();
    edges.sort_unstable();
    edges.windows(2).all(|pair| pair[0] != pair[1])
}

/// A Newton step toward the surface, at most half a cell long.
fn onto(field: &impl Fn([f64; 3]) -> f64, place: [f64; 3], cell: f64) -> [f64; 3] {
    // Slope and value from the corners of a tetrahedron.
    const CORNERS: [[f64; 3]; 4] = [[1.0, -1.0, -1.0], [-1.0, -1.0, 1.0], [-1.0, 1.0, -1.0], [1.0, 1.0, 1.0]];
    let step = 0.01 * cell;
    let values = CORNERS.map(|corner| field([0, 1, 2].map(|axis| place[axis] + step * corner[axis])));
    let value = values.iter().sum::<f64>() / 4.0;
    let slope: [f64; 3] =
        [0, 1, 2].map(|axis| (0..4).map(|at| values[at] * CORNERS[at][axis]).sum::<f64>() / (4.0 * step));
    let steepness = dot(slope, slope).sqrt().max(1e-3);
    let way = (value / steepness).clamp(-0.5 * cell, 0.5 * cell);
    [0, 1, 2].map(|axis| place[axis] - way * slope[axis] / steepness)
}

/// The surface of [`mesh`] as a model of one part, without texture coordinates.
pub fn model(field: &(impl Fn([f64; 3]) -> f64 + Sync), bounds: [[f64; 3]; 2], cell: f64) -> Model {
    let mesh = mesh(field, bounds, cell);
    let faces = mesh.faces.iter().map(|face| Face { corners: face.map(Corner::from), part: 0 });
    Model {
        faces: faces.collect(),
        positions: mesh.positions,
        parts: vec![Part::default()],
        ..Model::default()
    }
}
