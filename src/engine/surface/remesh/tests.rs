use super::*;
use crate::surface::adjacency::{Adjacency, NONE};
use crate::surface::prepare;
use crate::surface::test_meshes::{
    both, cube, cylinder, moebius, plate, ringed_sphere, scaled, shifted, slab, soup, sphere, torus,
};
use crate::surface::vector::{cross, distance, dot, length, minus};

/// The least angle, degrees.
fn least_angle(mesh: &Mesh) -> f64 {
    let angles = (0..mesh.faces.len()).flat_map(|face| {
        let [a, b, c] = mesh.corners(face);
        [[a, b, c], [b, c, a], [c, a, b]].map(|[apex, a, b]| {
            let (a, b) = (minus(a, apex), minus(b, apex));
            libm::atan2(length(cross(a, b)), dot(a, b)).to_degrees()
        })
    });
    angles.fold(180.0, f64::min)
}

/// Number of border edges, and V − E + F; all fans are complete.
fn counts(mesh: &Mesh) -> (usize, i64) {
    let adjacency = Adjacency::new(mesh.positions.len(), &mesh.faces);
    let fans: usize = (0..mesh.positions.len()).map(|vertex| adjacency.fan(vertex).count()).sum();
    assert_eq!(fans, 3 * mesh.faces.len());
    let open = adjacency.twins.iter().filter(|twin| **twin == NONE).count();
    let edges = (3 * mesh.faces.len() + open) / 2;
    (open, mesh.positions.len() as i64 - edges as i64 + mesh.faces.len() as i64)
}

/// Mean area of cells, as a share of √3 ÷ 2 of the square of a length.
fn cell_area(mesh: &Mesh, edge: f64) -> f64 {
    mesh.area() / mesh.positions.len() as f64 / (0.75f64.sqrt() * edge * edge)
}

fn prepared(mesh: &Mesh) -> Mesh {
    prepare(mesh).expect("some faces are left").0
}

#[test]
fn triangles_become_even_and_the_area_stays() {
    let bodies = [
        ("sphere", sphere(60, 10.0), 0.6, 2, 32.0),
        ("coarse sphere", sphere(12, 10.0), 0.7, 2, 30.0),
        ("torus", torus([90, 40], [10.0, 4.0]), 0.6, 0, 32.0),
        ("cube", cube(1, 12.0), 0.5, 2, 25.0),
        ("slab", slab([20.0, 10.0, 2.0], 20.0), 0.5, 2, 25.0),
    ];
    for (name, mesh, edge, euler, angle) in bodies {
        let made = remesh(&mesh, &|_| edge);
        assert_eq!(counts(&made), (0, euler), "{name}");
        assert!(least_angle(&made) > angle, "{name}: {}", least_angle(&made));
        let area = made.area() / mesh.area() - 1.0;
        assert!(area.abs() < 0.004, "{name}: area {area}");
        let cells = cell_area(&made, edge);
        assert!((cells - 1.0).abs() < 0.07, "{name}: cells {cells}");
    }
}

#[test]
fn the_slivers_at_the_poles_of_a_sphere_do_not_turn_over() {
    for (rings, edge) in [(60, 0.52), (100, 0.52), (100, 0.25)] {
        let mesh = ringed_sphere(rings, 10.0);
        let made = remesh(&mesh, &|_| edge);
        assert_eq!(counts(&made), (0, 2));
        assert!(least_angle(&made) > 25.0, "{rings} rings: {}", least_angle(&made));
        let area = made.area() / mesh.area() - 1.0;
        assert!(area.abs() < 0.005, "{rings} rings: area {area}");
        let is_outside = |face: usize| dot(made.corners(face)[0], made.area_vector(face)) > 0.0;
        assert!((0..made.faces.len()).all(is_outside), "{rings} rings");
    }
}

#[test]
fn corners_and_sharp_edges_of_a_cube_stay() {
    let made = remesh(&cube(3, 2.0), &|_| 0.13);
    for corner in 0..8 {
        let at = [0, 1, 2].map(|axis| if corner >> axis & 1 == 1 { 1.0 } else { -1.0 });
        assert!(made.positions.contains(&at));
    }
    assert!((made.area() - 24.0).abs() < 1e-9 && (made.volume() - 8.0).abs() < 1e-9);
}

#[test]
fn open_borders_stay() {
    let plate = plate([4, 3], 2.5);
    let made = remesh(&plate, &|_| 0.4);
    assert!((made.area() - 75.0).abs() < 1e-9 && counts(&made).1 == 1);
    assert!(least_angle(&made) > 28.0, "{}", least_angle(&made));
    let tube = cylinder([60, 10], 3.0, 8.0);
    let made = remesh(&tube, &|_| 0.5);
    let (open, euler) = counts(&made);
    assert_eq!(euler, 0);
    assert!((0.75..1.3).contains(&(open as f64 * 0.5 / (2.0 * 6.0 * std::f64::consts::PI))), "{open}");
    assert!((made.area() / tube.area() - 1.0).abs() < 0.004);
    let rims = made.positions.iter().filter(|at| at[2] == 0.0 || at[2] == 8.0).count();
    assert_eq!(rims, open);
}

#[test]
fn edge_lengths_follow_the_place() {
    let mesh = sphere(40, 10.0);
    let made = remesh(&mesh, &|[x, _, _]| 0.5 + 0.05 * (x + 10.0));
    let [mut near, mut far] = [(0.0, 0); 2];
    for [a, b, _] in &made.faces {
        let [a, b] = [a, b].map(|vertex| made.positions[*vertex as usize]);
        let sum = if a[0] < -8.0 {
            &mut near
        } else if a[0] > 8.0 {
            &mut far
        } else {
            continue;
        };
        *sum = (sum.0 + distance(a, b), sum.1 + 1);
    }
    let ratio = far.0 / far.1 as f64 / (near.0 / near.1 as f64);
    assert!((2.1..2.8).contains(&ratio), "{ratio}");
    assert!(least_angle(&made) > 27.0, "{}", least_angle(&made));
}

#[test]
fn the_same_surface_gives_the_same_triangles_wherever_it_is_worked_on() {
    let mesh = torus([60, 30], [10.0, 4.0]);
    let made = remesh(&mesh, &|_| 0.8);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a pool");
    assert_eq!(pool.install(|| remesh(&mesh, &|_| 0.8)), made);
}

#[test]
fn bad_meshes_become_even() {
    let long_faces = |mesh: &Mesh| Mesh {
        positions: mesh.positions.iter().map(|[x, y, z]| [x * 1e2, *y, *z]).collect(),
        faces: mesh.faces.clone(),
    };
    let mut slivers = cube(6, 6.0);
    slivers.positions.iter_mut().for_each(|at| {
        if at[0].abs() < 1.5 && at[0] > 0.0 {
            at[0] = 6e-4;
        }
    });
    let cases = [
        ("soup", soup(&cube(5, 6.0)), 0.5),
        ("slivers", slivers, 0.5),
        ("two parts", both(&sphere(8, 3.0), &shifted(&sphere(8, 3.0), [7.0, 0.0, 0.0])), 0.5),
        ("small", scaled(&sphere(8, 1.0), 1e-7), 1e-8),
        ("large and far", shifted(&scaled(&sphere(8, 1.0), 1e6), [1e7; 3]), 1e5),
        ("one-sided", moebius([40, 3], 4.0, 2.0), 0.3),
        ("much too fine", sphere(60, 1.0), 0.2),
        ("a needle", prepared(&long_faces(&cube(4, 1.0))), 0.4),
    ];
    for (name, mesh, edge) in cases {
        let mesh = prepared(&mesh);
        let (before, made) = (counts(&mesh), remesh(&mesh, &|_| edge));
        assert_eq!((counts(&made).1, counts(&made).0 == 0), (before.1, before.0 == 0), "{name}");
        assert!(least_angle(&made) > 20.0, "{name}: {}", least_angle(&made));
        assert!((made.area() / mesh.area() - 1.0).abs() < 0.03, "{name}: {}", made.area() / mesh.area());
    }
}

#[test]
fn the_smallest_meshes_stay_meshes() {
    let one = Mesh { positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], faces: vec![[0, 1, 2]] };
    // The coarse mesh has at most two triangles, and each is cut into four.
    assert!(remesh(&one, &|_| 50.0).faces.len() <= 8);
    assert!(remesh(&one, &|_| 0.1).faces.len() > 50);
    assert!((remesh(&one, &|_| 0.1).area() - 0.5).abs() < 1e-12);
    for edge in [f64::NAN, f64::INFINITY, 1e9] {
        let made = remesh(&sphere(4, 1.0), &|_| edge);
        assert!(made.faces.len() >= 4 && counts(&made) == (0, 2), "{edge}");
    }
}

#[test]
fn a_thin_sheet_stays_two_sheets() {
    let sheet = slab([10.0, 10.0, 0.02], 10.0);
    let made = remesh(&sheet, &|_| 0.5);
    assert_eq!(counts(&made), (0, 2));
    assert!((made.area() / sheet.area() - 1.0).abs() < 0.01);
    assert!(made.positions.iter().all(|at| (at[2].abs() - 0.01).abs() < 1e-9));
}
