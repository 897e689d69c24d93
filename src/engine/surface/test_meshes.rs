//! Test bodies whose measures are known.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use super::mesh::Mesh;
use super::vector::{Vector, middle, plus, times, unit};

/// A grid of [nx, ny] vertices, with two triangles per square; `at` gives their positions. Rows or columns that are `joined` are
/// closed to rings.
pub fn sheet([nx, ny]: [usize; 2], joined: [bool; 2], at: impl Fn(f64, f64) -> Vector) -> Mesh {
    let [columns, rows] =
        [(nx, joined[0]), (ny, joined[1])].map(|(n, joined)| if joined { n } else { n + 1 });
    let index = |x: usize, y: usize| ((y % rows) * columns + x % columns) as u32;
    let positions = (0..rows * columns)
        .map(|i| at((i % columns) as f64 / nx as f64, (i / columns) as f64 / ny as f64))
        .collect();
    let squares = (0..nx * ny).map(|i| (i % nx, i / nx));
    let faces = squares.flat_map(|(x, y)| {
        let [a, b, c, d] = [index(x, y), index(x + 1, y), index(x + 1, y + 1), index(x, y + 1)];
        if (x + y) % 2 == 0 { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] }
    });
    Mesh { faces: faces.collect(), positions }
}

/// A flat plate in the plane z = 0, seen from +z, of squares of this side.
pub fn plate(squares: [usize; 2], side: f64) -> Mesh {
    let [width, height] = squares.map(|n| n as f64 * side);
    sheet(squares, [false; 2], |u, v| [u * width, v * height, 0.0])
}

/// A flat plate of nearly regular triangles with this side, of approximately this size.
pub fn even_plate([width, height]: [f64; 2], side: f64) -> Mesh {
    let rows = (height / (0.75f64.sqrt() * side)).round().max(1.0);
    let columns = (width / side).round().max(1.0);
    let (step, rise) = (width / columns, height / rows);
    let mut positions = Vec::new();
    let mut starts = Vec::new();
    for row in 0..=rows as usize {
        starts.push(positions.len() as u32);
        let y = row as f64 * rise;
        let odd = row % 2 == 1;
        let count = columns as usize + 1 + usize::from(odd);
        positions.extend((0..count).map(|k| {
            let x = if odd { (k as f64 - 0.5).clamp(0.0, columns) } else { k as f64 };
            [x * step, y, 0.0]
        }));
    }
    starts.push(positions.len() as u32);
    let mut faces = Vec::new();
    for row in 0..rows as usize {
        let odd = row % 2 == 1;
        let (long, short) = if odd { (row, row + 1) } else { (row + 1, row) };
        let (long, short) = (starts[long], starts[short]);
        for k in 0..=columns as u32 {
            let (a, b) = (long + k, long + k + 1);
            let c = short + k;
            faces.push(if odd { [a, b, c] } else { [b, a, c] });
            if k < columns as u32 {
                let d = short + k + 1;
                faces.push(if odd { [b, d, c] } else { [b, c, d] });
            }
        }
    }
    Mesh { positions, faces }
}

/// A sphere: an icosahedron, each edge of which is cut into `cuts` parts.
pub fn sphere(cuts: usize, radius: f64) -> Mesh {
    let g = 0.5 * (1.0 + 5.0f64.sqrt());
    let corners: [Vector; 12] = [
        [-1.0, g, 0.0],
        [1.0, g, 0.0],
        [-1.0, -g, 0.0],
        [1.0, -g, 0.0],
        [0.0, -1.0, g],
        [0.0, 1.0, g],
        [0.0, -1.0, -g],
        [0.0, 1.0, -g],
        [g, 0.0, -1.0],
        [g, 0.0, 1.0],
        [-g, 0.0, -1.0],
        [-g, 0.0, 1.0],
    ];
    let faces = [
        [0, 11, 5],
        [0, 5, 1],
        [0, 1, 7],
        [0, 7, 10],
        [0, 10, 11],
        [1, 5, 9],
        [5, 11, 4],
        [11, 10, 2],
        [10, 7, 6],
        [7, 1, 8],
        [3, 9, 4],
        [3, 4, 2],
        [3, 2, 6],
        [3, 6, 8],
        [3, 8, 9],
        [4, 9, 5],
        [2, 4, 11],
        [6, 2, 10],
        [8, 6, 7],
        [9, 8, 1],
    ];
    let mesh = cut(&Mesh { positions: corners.to_vec(), faces: faces.to_vec() }, cuts);
    let positions = mesh.positions.iter().map(|at| times(unit(*at).expect("no corner is 0"), radius));
    Mesh { positions: positions.collect(), faces: mesh.faces }
}

/// A sphere of rings about the z axis, as modelling programs make it: twice as many slices as rings meet at each pole.
pub fn ringed_sphere(rings: usize, radius: f64) -> Mesh {
    let slices = 2 * rings;
    let mut positions = vec![[0.0, 0.0, radius]];
    for (ring, slice) in (1..rings).flat_map(|ring| (0..slices).map(move |slice| (ring, slice))) {
        let [down, round] = [ring, slice].map(|i| i as f64 * std::f64::consts::PI / rings as f64);
        let out = radius * down.sin();
        positions.push([out * round.cos(), out * round.sin(), radius * down.cos()]);
    }
    let last = positions.len() as u32;
    positions.push([0.0, 0.0, -radius]);
    let at = |ring: usize, slice: usize| (1 + (ring - 1) * slices + slice % slices) as u32;
    let caps = (0..slices).flat_map(|slice| {
        [[0, at(1, slice), at(1, slice + 1)], [last, at(rings - 1, slice + 1), at(rings - 1, slice)]]
    });
    let squares = (1..rings - 1).flat_map(|ring| (0..slices).map(move |slice| (ring, slice)));
    let faces = squares.flat_map(|(ring, slice)| {
        let [a, b] = [at(ring, slice), at(ring + 1, slice)];
        let [c, d] = [at(ring + 1, slice + 1), at(ring, slice + 1)];
        [[a, b, c], [a, c, d]]
    });
    Mesh { faces: caps.chain(faces).collect(), positions }
}

/// A cube about the origin, each side of which is cut into `cuts` parts.
pub fn cube(cuts: usize, side: f64) -> Mesh {
    let h = 0.5 * side;
    let positions: Vec<Vector> =
        (0..8).map(|i| [0, 1, 2].map(|axis| if i >> axis & 1 == 1 { h } else { -h })).collect();
    let squares = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let faces = squares.iter().flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]]).collect();
    cut(&Mesh { positions, faces }, cuts)
}

/// Every face cut into `cuts`² ones.
pub fn cut(mesh: &Mesh, cuts: usize) -> Mesh {
    let mut known: BTreeMap<[i64; 3], u32> = BTreeMap::new();
    let mut positions = Vec::new();
    let scale = 1e7 / mesh.size();
    let mut vertex = |at: Vector| {
        *known.entry(at.map(|part| (part * scale).round() as i64)).or_insert_with(|| {
            positions.push(at);
            positions.len() as u32 - 1
        })
    };
    let mut faces = Vec::new();
    for face in 0..mesh.faces.len() {
        let [a, b, c] = mesh.corners(face);
        let n = cuts as f64;
        let mut at = |i: usize, j: usize| {
            let [u, v] = [i, j].map(|k| k as f64 / n);
            vertex(plus(plus(times(a, 1.0 - u - v), times(b, u)), times(c, v)))
        };
        for j in 0..cuts {
            for i in 0..cuts - j {
                faces.push([at(i, j), at(i + 1, j), at(i, j + 1)]);
                if i + j + 1 < cuts {
                    faces.push([at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
                }
            }
        }
    }
    Mesh { positions, faces }
}

/// A torus about the z axis.
pub fn torus(cells: [usize; 2], [wide, thin]: [f64; 2]) -> Mesh {
    sheet(cells, [true; 2], |u, v| {
        let ((sin, cos), (rise, out)) = (libm::sincos(u * TAU), libm::sincos(v * TAU));
        let from_axis = wide + thin * out;
        [from_axis * cos, from_axis * sin, thin * rise]
    })
}

/// An open cylinder about the z axis.
pub fn cylinder(cells: [usize; 2], radius: f64, height: f64) -> Mesh {
    sheet(cells, [true, false], |u, v| {
        let (sin, cos) = libm::sincos(u * TAU);
        [radius * cos, radius * sin, v * height]
    })
}

/// A strip whose ends are joined after half a turn: no winding of its faces fits.
pub fn moebius(cells: [usize; 2], radius: f64, width: f64) -> Mesh {
    sheet(cells, [false; 2], |u, v| {
        let ((sin, cos), (up, out)) = (libm::sincos(u * TAU), libm::sincos(u * 0.5 * TAU));
        let (off, out) = ((v - 0.5) * width, out);
        let from_axis = radius + off * out;
        [from_axis * cos, from_axis * sin, off * up]
    })
}

/// A box with these sides about the origin, with two triangles per square, of about the side `edge`.
pub fn slab(sides: [f64; 3], edge: f64) -> Mesh {
    let cuts = (sides.iter().copied().fold(0.0, f64::max) / edge).ceil().max(1.0);
    let cube = cube(cuts as usize, 1.0);
    let positions = cube.positions.iter().map(|at| [0, 1, 2].map(|axis| at[axis] * sides[axis]));
    Mesh { positions: positions.collect(), faces: cube.faces }
}

/// Both meshes as one, without joining them.
pub fn both(a: &Mesh, b: &Mesh) -> Mesh {
    let shift = a.positions.len() as u32;
    let moved = b.faces.iter().map(|face| face.map(|vertex| vertex + shift));
    Mesh {
        positions: a.positions.iter().chain(&b.positions).copied().collect(),
        faces: a.faces.iter().copied().chain(moved).collect(),
    }
}

/// The mesh, shifted.
pub fn shifted(mesh: &Mesh, by: Vector) -> Mesh {
    Mesh { positions: mesh.positions.iter().map(|at| plus(*at, by)).collect(), faces: mesh.faces.clone() }
}

/// The mesh, scaled about the origin.
pub fn scaled(mesh: &Mesh, by: f64) -> Mesh {
    Mesh { positions: mesh.positions.iter().map(|at| times(*at, by)).collect(), faces: mesh.faces.clone() }
}

/// The mesh with separate vertices for each face.
pub fn soup(mesh: &Mesh) -> Mesh {
    let positions: Vec<Vector> = (0..mesh.faces.len()).flat_map(|face| mesh.corners(face)).collect();
    let faces = (0..mesh.faces.len() as u32).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect();
    Mesh { positions, faces }
}

/// The centre of a face.
pub fn centre(mesh: &Mesh, face: usize) -> Vector {
    let [a, b, c] = mesh.corners(face);
    plus(times(middle(a, b), 2.0 / 3.0), times(c, 1.0 / 3.0))
}
