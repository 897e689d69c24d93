use super::*;
use crate::surface::adjacency::{Adjacency, NONE};
use crate::surface::test_meshes::{both, cube, cylinder, moebius, plate, scaled, shifted, soup, sphere};

/// Number of parts, number of border edges, and V − E + F of a manifold.
fn counts(mesh: &Mesh) -> (usize, usize, i64) {
    let adjacency = Adjacency::new(mesh.positions.len(), &mesh.faces);
    let fans: usize = (0..mesh.positions.len()).map(|vertex| adjacency.fan(vertex).count()).sum();
    assert_eq!(fans, 3 * mesh.faces.len(), "all faces at a vertex are one fan");
    let open = adjacency.twins.iter().filter(|twin| **twin == NONE).count();
    let edges = (3 * mesh.faces.len() + open) / 2;
    let mut seen = vec![false; mesh.faces.len()];
    let mut parts = 0;
    for first in 0..mesh.faces.len() {
        let mut stack = vec![first];
        parts += usize::from(!seen[first]);
        while let Some(face) = stack.pop() {
            if !std::mem::replace(&mut seen[face], true) {
                let beyond = adjacency.twins[3 * face..3 * face + 3].iter();
                stack.extend(beyond.filter(|twin| **twin != NONE).map(|twin| *twin as usize / 3));
            }
        }
    }
    (parts, open, mesh.positions.len() as i64 - edges as i64 + mesh.faces.len() as i64)
}

fn prepared(mesh: &Mesh) -> (Mesh, Repairs) {
    prepare(mesh).expect("some faces are left")
}

#[test]
fn a_sound_mesh_stays_as_it_is() {
    let mesh = sphere(5, 3.0);
    assert_eq!(prepared(&mesh), (mesh, Repairs::default()));
}

#[test]
fn triangles_with_vertices_of_their_own_are_welded() {
    let (mesh, repairs) = prepared(&soup(&cube(4, 1.0)));
    assert_eq!(counts(&mesh), (1, 0, 2));
    assert_eq!((repairs.welded, repairs.notes().len()), (3 * 192 - 98, 0));
    // Rounded to six digits as in a file.
    let mut rough = soup(&sphere(8, 1.0));
    rough.positions.iter_mut().flatten().for_each(|part| *part = (*part * 1e6).round() * 1e-6);
    assert_eq!(counts(&prepared(&rough).0), (1, 0, 2));
}

#[test]
fn windings_are_flooded_and_the_outside_is_outside() {
    let mut mesh = sphere(6, 1.0);
    let volume = mesh.volume();
    mesh.faces.iter_mut().for_each(|face| face.swap(0, 1));
    let (turned, repairs) = prepared(&mesh);
    assert!((turned.volume() - volume).abs() < 1e-12 && repairs.turned == mesh.faces.len());
    mesh.faces.iter_mut().step_by(3).for_each(|face| face.swap(1, 2));
    assert!((prepared(&mesh).0.volume() - volume).abs() < 1e-12);
    // An open part keeps the side of most of its faces.
    let mut open = cylinder([24, 6], 1.0, 2.0);
    open.faces.iter_mut().step_by(3).for_each(|face| face.swap(1, 2));
    let (open, repairs) = prepared(&open);
    let is_outward = |face| {
        let [x, y, _] = crate::surface::test_meshes::centre(&open, face);
        let [nx, ny, _] = open.area_vector(face);
        x * nx + y * ny > 0.0
    };
    assert!((0..open.faces.len()).all(is_outward));
    assert_eq!((repairs.turned, counts(&open)), (96, (1, 48, 0)));
}

#[test]
fn two_parts_stay_apart_and_each_points_outwards() {
    let mut inward = shifted(&cube(2, 1.0), [3.0, 0.0, 0.0]);
    inward.faces.iter_mut().for_each(|face| face.swap(0, 1));
    let (mesh, _) = prepared(&both(&cube(2, 1.0), &inward));
    assert_eq!(counts(&mesh), (2, 0, 4));
    assert!((mesh.volume() - 2.0).abs() < 1e-12);
    // Cubes that touch along an edge share its four faces' vertices.
    let (mesh, repairs) = prepared(&both(&cube(2, 1.0), &shifted(&cube(2, 1.0), [1.0, 1.0, 0.0])));
    assert_eq!((repairs.crowded, counts(&mesh).1), (2, 0));
    assert!((mesh.volume() - 2.0).abs() < 1e-12);
}

#[test]
fn a_fin_is_taken_off_the_body_it_stands_on() {
    let mut mesh = cube(2, 1.0);
    let top = mesh.positions.iter().position(|at| *at == [0.0, 0.0, 0.5]).expect("in the middle");
    let side = mesh.positions.iter().position(|at| *at == [0.5, 0.0, 0.5]).expect("halfway");
    mesh.positions.push([0.2, 0.0, 1.0]);
    mesh.faces.push([top as u32, side as u32, mesh.positions.len() as u32 - 1]);
    let (mesh, repairs) = prepared(&mesh);
    assert_eq!((repairs.crowded, counts(&mesh)), (1, (2, 3, 3)));
}

#[test]
fn faces_that_meet_in_a_vertex_only_are_taken_apart() {
    let mesh = both(&cube(1, 1.0), &shifted(&cube(1, 1.0), [1.0; 3]));
    let (mesh, repairs) = prepared(&mesh);
    assert_eq!((repairs.pinched, counts(&mesh)), (1, (2, 0, 4)));
}

#[test]
fn a_moebius_strip_is_cut_across_once() {
    let (mesh, repairs) = prepared(&moebius([40, 4], 2.0, 1.0));
    // The rest is a strip with two sides: one part, one border, like a disc.
    assert_eq!((counts(&mesh).0, counts(&mesh).2), (1, 1));
    assert!((4..=9).contains(&repairs.cut), "{repairs:?}");
    assert_eq!(repairs.notes().len(), 2, "cut, and turned over");
}

#[test]
fn faces_that_are_there_twice_in_whatever_winding_are_dropped() {
    let mut mesh = sphere(3, 1.0);
    let sound = mesh.clone();
    let doubled: Vec<[u32; 3]> = mesh.faces.iter().step_by(4).map(|[a, b, c]| [*c, *b, *a]).collect();
    mesh.faces.extend(&doubled);
    let (mesh, repairs) = prepared(&mesh);
    assert_eq!((mesh, repairs.doubled), (sound, doubled.len()));
}

#[test]
fn faces_without_area_leave_no_crack() {
    let mut mesh = plate([2, 2], 1.0);
    // A corner in the middle of an edge of the face below it, and a face of no height between them.
    mesh.positions.push([0.5, 0.5, 0.0]);
    let middle = mesh.positions.len() as u32 - 1;
    let [a, b, c] = mesh.faces[0];
    assert_eq!([a, b, c].map(|v| mesh.positions[v as usize]), [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]]);
    mesh.faces[0] = [a, b, middle];
    mesh.faces.extend([[b, c, middle], [a, middle, c]]);
    let (mesh, repairs) = prepared(&mesh);
    assert_eq!((repairs.flat, counts(&mesh)), (1, (1, 8, 1)));
    assert!((mesh.area() - 4.0).abs() < 1e-12);
}

#[test]
fn positions_that_are_not_finite_and_unused_vertices_are_dropped() {
    let mut mesh = sphere(3, 1.0);
    let sound = mesh.clone();
    mesh.positions.extend([[f64::NAN, 0.0, 0.0], [0.0, f64::INFINITY, 0.0], [50.0; 3]]);
    let first = sound.positions.len() as u32;
    mesh.faces.extend([[0, 1, first], [first + 1, 2, 3], [0, 1, 4_000]]);
    let (mesh, repairs) = prepared(&mesh);
    assert_eq!((mesh, repairs.unreal, repairs.notes().len()), (sound, 3, 1));
}

#[test]
fn size_and_place_do_not_matter() {
    for (size, offset) in [(1e-7, 0.0), (1e6, 1e7), (1e-120, 0.0), (1e120, 0.0)] {
        let mesh = shifted(&scaled(&soup(&sphere(6, 1.0)), size), [offset; 3]);
        assert_eq!(counts(&prepared(&mesh).0), (1, 0, 2), "{size}");
    }
}

#[test]
fn one_triangle_is_a_mesh_and_nothing_is_none() {
    let one = Mesh { positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], faces: vec![[0, 1, 2]] };
    assert_eq!(prepared(&one).0, one);
    assert_eq!(prepare(&Mesh::default()), Err(SurfaceError::Empty));
    let nothing = [
        Mesh { faces: vec![[0, 1, 1]], ..one.clone() },
        Mesh { faces: vec![[0, 1, 7]], ..one.clone() },
        Mesh { positions: vec![[0.0; 3], [1.0; 3], [2.0; 3]], ..one.clone() },
        Mesh { positions: vec![[f64::NAN; 3]; 3], ..one.clone() },
        Mesh { positions: vec![[5.0; 3]; 3], ..one },
    ];
    for mesh in nothing {
        let error = prepare(&mesh).expect_err("nothing is left");
        assert_eq!(error, SurfaceError::NoArea { faces: 1 });
    }
}
