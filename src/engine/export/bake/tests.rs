//! Whole textures: their seams, their normals, and that threads change nothing.

use std::collections::{BTreeMap, VecDeque};

use super::*;
use crate::export::body::vector::{Vector, dot, minus, plus, unit};
use crate::surface::model::Corner;
use crate::surface::test_meshes::even_plate;
use crate::surface::{Model, Surface, built_in, prepare, read_model};

/// px of the animal of the seams: spots 40 px apart are a twentieth of its length apart.
const PX: f64 = 900.0;

/// Spots all over space, 40 px apart, 0 to 1.
fn spots(at: Vector) -> f32 {
    let mean = at.iter().map(|part| libm::cos(std::f64::consts::TAU * part / 40.0)).sum::<f64>() / 3.0;
    libm::pow(0.5 + 0.5 * mean, 3.0) as f32
}

/// The model cut into pieces of at most `most` triangles that face about the same side, each flat in a square of its own.
fn cut_into_pieces(model: &Model, most: usize) -> Model {
    let mesh = model.mesh(&[]).expect("a mesh");
    let mut beside: BTreeMap<[u32; 2], Vec<usize>> = BTreeMap::new();
    let sides = |face: [u32; 3]| [[face[0], face[1]], [face[1], face[2]], [face[2], face[0]]];
    for (index, face) in mesh.faces.iter().enumerate() {
        sides(*face).iter().for_each(|[a, b]| beside.entry([*a.min(b), *a.max(b)]).or_default().push(index));
    }
    let mut pieces: Vec<Vec<usize>> = Vec::new();
    let mut is_taken = vec![false; mesh.faces.len()];
    for first in 0..mesh.faces.len() {
        let (mut piece, mut next) = (Vec::new(), VecDeque::from([first]));
        let normal = unit(mesh.area_vector(first));
        while let Some(face) = next.pop_front().filter(|_| piece.len() < most) {
            if is_taken[face] || dot(unit(mesh.area_vector(face)), normal) < 0.6 {
                continue;
            }
            is_taken[face] = true;
            piece.push(face);
            for [a, b] in sides(mesh.faces[face]) {
                next.extend(&beside[&[a.min(b), a.max(b)]]);
            }
        }
        pieces.extend((!piece.is_empty()).then_some(piece));
    }
    let columns = (pieces.len() as f64).sqrt().ceil();
    let mut flat = Model { uvs: Vec::new(), ..model.clone() };
    let laid: Vec<Vec<[[f64; 2]; 3]>> = pieces.iter().map(|piece| on_plane(&mesh, piece)).collect();
    let reach = laid.iter().flatten().flatten().flatten().copied().fold(0.0, f64::max);
    // Two texels of 1024 stay free around each piece.
    let (cell, free) = (1.0 / columns, 2.0 / 1_024.0);
    for (index, (piece, uvs)) in pieces.iter().zip(&laid).enumerate() {
        let corner = [index % columns as usize, index / columns as usize].map(|at| at as f64 * cell + free);
        for (face, uvs) in piece.iter().zip(uvs) {
            for (at, uv) in uvs.iter().enumerate() {
                flat.uvs.push([0, 1].map(|axis| corner[axis] + (cell - 2.0 * free) * uv[axis] / reach));
                let uv = Some(flat.uvs.len() as u32 - 1);
                flat.faces[*face].corners[at] = Corner { uv, ..flat.faces[*face].corners[at] };
            }
        }
    }
    flat
}

/// Triangles projected on the plane of the first, with their least coordinates at 0.
fn on_plane(mesh: &crate::surface::Mesh, piece: &[usize]) -> Vec<[[f64; 2]; 3]> {
    let [a, b, _] = mesh.corners(piece[0]);
    let (right, normal) = (unit(minus(b, a)), unit(mesh.area_vector(piece[0])));
    let up = crate::export::body::vector::cross(normal, right);
    let flat: Vec<[[f64; 2]; 3]> = piece
        .iter()
        .map(|face| mesh.corners(*face).map(|at| [dot(minus(at, a), right), dot(minus(at, a), up)]))
        .collect();
    let least = [0, 1].map(|i| flat.iter().flatten().map(|at| at[i]).fold(f64::INFINITY, f64::min));
    flat.into_iter().map(|face| face.map(|at| [at[0] - least[0], at[1] - least[1]])).collect()
}

/// A value of a picture between four texels, as graphics cards read it.
fn read(values: &[f32], side: usize, [u, v]: [f64; 2]) -> f64 {
    let along = |share: f64| {
        let at = share * side as f64 - 0.5;
        let index = |off: f64| (at.floor() + off).clamp(0.0, (side - 1) as f64) as usize;
        ([index(0.0), index(1.0)], at - at.floor())
    };
    let ((columns, x), (rows, y)) = (along(u), along(1.0 - v));
    let texel = |c: usize, r: usize| f64::from(values[rows[r] * side + columns[c]]);
    let row = |r: usize| (1.0 - x) * texel(0, r) + x * texel(1, r);
    (1.0 - y) * row(0) + y * row(1)
}

/// The sides of seams: the texture coordinates of both ends, on both sides.
fn seams(atlas: &Atlas) -> Vec<[[[f64; 2]; 2]; 2]> {
    let mut sides: BTreeMap<[[u64; 3]; 2], Vec<[[f64; 2]; 2]>> = BTreeMap::new();
    for (face, vertices) in atlas.mesh.faces.iter().enumerate() {
        for side in (0..3).filter(|side| atlas.is_rim[face][*side]) {
            let ends = [side, (side + 1) % 3].map(|corner| vertices[corner] as usize);
            let [a, b] = ends.map(|end| atlas.mesh.positions[end].map(f64::to_bits));
            let [from, to] = ends.map(|end| atlas.uvs[end]);
            let (key, uvs) = if a < b { ([a, b], [from, to]) } else { ([b, a], [to, from]) };
            sides.entry(key).or_default().push(uvs);
        }
    }
    sides.into_values().filter_map(|sides| <[_; 2]>::try_from(sides).ok()).collect()
}

/// Median and 95 % of the mismatch over the seams, as a share of the peak.
fn mismatch(atlas: &Atlas, values: &[f32], side: usize) -> [f64; 2] {
    let peak = values.iter().copied().fold(0.0, f32::max);
    let mut found: Vec<f64> = Vec::new();
    for [here, there] in seams(atlas) {
        for share in [0.125, 0.375, 0.625, 0.875] {
            let at = |[a, b]: [[f64; 2]; 2]| [0, 1].map(|i| a[i] + share * (b[i] - a[i]));
            found
                .push((read(values, side, at(here)) - read(values, side, at(there))).abs() / f64::from(peak));
        }
    }
    found.sort_by(f64::total_cmp);
    [found[found.len() / 2], found[found.len() * 95 / 100]]
}

#[test]
fn both_sides_of_the_seams_of_hundreds_of_pieces_show_the_same() {
    let animal = built_in("animal").expect("a body");
    let atlas = own(&cut_into_pieces(&animal, 80), &|_| true).expect("coordinates");
    assert!(atlas.charts >= 500, "{}", atlas.charts);
    let whole = animal.mesh(&[]).expect("a mesh");
    let scale = PX / whole.size();
    let to_px = |at: Vector| at.map(|part| scale * part);
    let positions = whole.positions.iter().map(|at| to_px(*at)).collect();
    let (mesh, _) = prepare(&crate::surface::Mesh { positions, faces: whole.faces }).expect("a surface");
    let surface = Surface::new(mesh, [1.0, 0.0, 0.0]);
    let pattern: Vec<f32> = surface.mesh.positions.iter().map(|at| spots(*at)).collect();
    let open = vec![1.0; pattern.len()];
    let baked = |gutter: usize| {
        let texels = Texels::new(&atlas, [1_024; 2], gutter);
        let baker = Baker::new(&atlas, texels, &surface, &to_px, &[&pattern], open.clone());
        baker.rows(0..1_024).values.swap_remove(0)
    };
    let [median, most] = mismatch(&atlas, &baked(4), 1_024);
    println!("{} charts: mismatch over seams, median {median:.5}, 95 % {most:.5} of the peak", atlas.charts);
    assert!(median < 0.001 && most < 0.01, "{median} {most}");
    let [_, without] = mismatch(&atlas, &baked(0), 1_024);
    println!("without a gutter, 95 % {without:.5}");
    assert!(without > 10.0 * most, "{without}");
}

/// A square of side 1 with the whole picture on it, seen from +z; the picture is mirrored if `is_mirrored`.
fn square(is_mirrored: bool) -> Atlas {
    let u = if is_mirrored { [1, 0] } else { [0, 1] };
    let uvs = format!("vt {0} 0\nvt {1} 0\nvt {1} 1\nvt {0} 1\n", u[0], u[1]);
    let text = format!("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n{uvs}f 1/1 2/2 3/3 4/4\n");
    own(&read_model(text.as_bytes(), "a.obj").expect("a model"), &|_| true).expect("coordinates")
}

#[test]
fn a_slope_makes_the_normals_of_its_gradient_in_the_directions_of_the_texture() {
    let surface = Surface::new(even_plate([100.0; 2], 5.0), [1.0, 0.0, 0.0]);
    // Rising by 50 to the right, and by 25 upwards.
    let rising: Vec<f32> =
        surface.mesh.positions.iter().map(|at| (0.01 * at[0] + 0.005 * at[1]) as f32).collect();
    for is_mirrored in [false, true] {
        let atlas = square(is_mirrored);
        let open = vec![0.75; rising.len()];
        let texels = Texels::new(&atlas, [32; 2], 2);
        let baker = Baker::new(&atlas, texels, &surface, &|at| at.map(|part| 100.0 * part), &[&rising], open);
        let baked = baker.rows(8..24);
        let normals = baked.normals(&[vec![50.0; 16 * 32]], &[]);
        let length = (0.25_f32 + 0.0625 + 1.0).sqrt();
        let right = if is_mirrored { 0.5 } else { -0.5 };
        for (texel, normal) in normals.iter().enumerate().filter(|(texel, _)| (4..28).contains(&(texel % 32)))
        {
            let expected = [right, -0.25, 1.0].map(|part| part / length);
            assert!((0..3).all(|i| (normal[i] - expected[i]).abs() < 1e-4), "{texel}: {normal:?}");
            assert!((baked.open[texel] - 0.75).abs() < 1e-6);
        }
        // The picture begins above: row 8 is at y = 100 · (1 − 8.5/32).
        let x = (10.5 / 32.0_f64) * 100.0;
        let x = if is_mirrored { 100.0 - x } else { x };
        let expected = 0.01 * x + 0.005 * 100.0 * (1.0 - 8.5 / 32.0);
        assert!((f64::from(baked.values[0][10]) - expected).abs() < 1e-4);
    }
}

#[test]
fn a_shader_that_reads_the_normals_finds_those_of_the_relief_on_a_ball() {
    let ball = built_in("sphere").expect("a body");
    let atlas = own(&ball, &|_| true).expect("coordinates");
    let (mesh, _) = prepare(&ball.mesh(&[]).expect("a mesh")).expect("a surface");
    let surface = Surface::new(mesh, [1.0, 0.0, 0.0]);
    let height = |at: Vector| 0.2 * at[1];
    let values: Vec<f32> = surface.mesh.positions.iter().map(|at| height(*at) as f32).collect();
    let open = vec![1.0; values.len()];
    let size = [256, 128];
    let baker = Baker::new(&atlas, Texels::new(&atlas, size, 2), &surface, &|at| at, &[&values], open);
    let normals = baker.rows(0..128).normals(&[vec![1.0; 256 * 128]], &[]);
    let mut worst: f64 = 0.0;
    for face in 0..atlas.mesh.faces.len() {
        // The middle of each triangle, as a shader sees it.
        let vertices = atlas.mesh.faces[face].map(|vertex| vertex as usize);
        let mean = |of: &dyn Fn(usize) -> Vector| {
            vertices.iter().fold([0.0; 3], |sum, vertex| plus(sum, 1.0 / 3.0, of(*vertex)))
        };
        let place = mean(&|vertex| atlas.mesh.positions[vertex]);
        if place[1].abs() > 0.8 {
            continue;
        }
        let [u, v] = [0, 1].map(|i| vertices.iter().map(|vertex| atlas.uvs[*vertex][i] / 3.0).sum::<f64>());
        let texel = (((1.0 - v) * 128.0) as usize).min(127) * 256 + ((u * 256.0) as usize).min(255);
        let normal = mean(&|vertex| atlas.normals[vertex]);
        let tangent = mean(&|vertex| {
            let [x, y, z, _] = atlas.tangents[vertex].map(f64::from);
            [x, y, z]
        });
        let sign = f64::from(atlas.tangents[vertices[0]][3]);
        let bitangent = crate::export::body::vector::cross(normal, tangent).map(|part| sign * part);
        let [x, y, z] = normals[texel].map(f64::from);
        let seen = unit(plus(plus(normal.map(|part| z * part), x, tangent), y, bitangent));
        // −∇h, tangential: 0.2 downwards.
        let up = unit(place);
        let slope = plus([0.0, 0.2, 0.0], -0.2 * up[1], up);
        worst = worst.max(1.0 - dot(seen, unit(minus(up, slope))));
    }
    // 2.6 degrees: a texel is 1.4 wide.
    assert!(worst < 1e-3, "{worst}");
}

#[test]
fn a_texture_has_the_same_bits_on_any_number_of_threads() {
    let cube = built_in("cube").expect("a body");
    let baked = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| {
            let atlas = own(&cube, &|_| true).expect("coordinates");
            let (mesh, _) = prepare(&cube.mesh(&[]).expect("a mesh")).expect("a surface");
            let surface = Surface::new(mesh, [1.0, 0.0, 0.0]);
            let values: Vec<f32> =
                surface.mesh.positions.iter().map(|at| spots(at.map(|x| 30.0 * x))).collect();
            let open = openness(&surface, &values, 0.3);
            let baker =
                Baker::new(&atlas, Texels::new(&atlas, [96; 2], 3), &surface, &|at| at, &[&values], open);
            let baked = baker.rows(0..96);
            let normals = baked.normals(&[vec![0.1; 96 * 96]], &[]);
            (baked.values, baked.open, normals)
        })
    };
    assert_eq!(baked(1), baked(3));
    let one = automatic(&cube, &|_| true).expect("coordinates");
    let pool = rayon::ThreadPoolBuilder::new().num_threads(3).build().expect("threads");
    let three = pool.install(|| automatic(&cube, &|_| true).expect("coordinates"));
    assert_eq!((one.uvs, one.tangents), (three.uvs, three.tangents));
}
