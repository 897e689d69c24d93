//! Places, displacements and frames on surfaces of known geometry.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::test_meshes::{both, cylinder, even_plate, moebius, plate, shifted, slab, sphere, torus};
use super::vector::{cross, distance, dot, length, unit};
use super::*;
use crate::grid::{Domain, turned};

const ALONG: [f64; 3] = [1.0, 0.0, 0.0];

fn random_place(surface: &Surface, rng: &mut Pcg64Mcg) -> SurfacePoint {
    let cell = (rng.random::<f64>() * surface.cells() as f64) as usize;
    surface.place_in(cell, [rng.random(), rng.random()])
}

fn norm([x, y]: [f64; 2]) -> f64 {
    (x * x + y * y).sqrt()
}

/// Great circle distance.
fn arc(a: [f64; 3], b: [f64; 3], radius: f64) -> f64 {
    radius * libm::atan2(length(cross(a, b)), dot(a, b))
}

#[test]
fn a_flat_plate_is_as_flat_as_a_grid() {
    for mesh in [plate([20, 16], 1.5), even_plate([30.0, 24.0], 1.3)] {
        let surface = Surface::new(mesh, ALONG);
        let unit = surface.unit();
        let mut rng = Pcg64Mcg::seed_from_u64(1);
        for _ in 0..200 {
            let [from, to] = [0; 2].map(|_| random_place(&surface, &mut rng));
            let [a, b] = [from, to].map(|place| surface.position(place));
            // y points down on the canvas: seen from +z the second axis runs towards -y.
            let expected = [(b[0] - a[0]) / unit, -(b[1] - a[1]) / unit];
            let displacement = surface.displacement(from, to);
            assert!(
                norm([displacement[0] - expected[0], displacement[1] - expected[1]]) < 1e-9,
                "{displacement:?} {expected:?}"
            );
            let there = surface.position(surface.moved(from, displacement));
            assert!(distance(there, b) < 1e-9, "{there:?} {b:?}");
            assert!(surface.transport_angle(surface.cell_at(from), surface.cell_at(to)).abs() < 1e-9);
            let near: Vec<usize> =
                surface.near(from, 4.0, 0..surface.cells()).map(|(cell, _)| cell).collect();
            for cell in 0..surface.cells() {
                let far = distance(surface.position(surface.center(cell)), a) / unit;
                assert!(near.contains(&cell) == (far <= 4.0) || (far - 4.0).abs() < 1e-9);
            }
        }
    }
}

#[test]
fn the_axes_of_a_frame_turn_clockwise_seen_from_outside() {
    let surface = Surface::new(sphere(8, 2.0), [0.0, 0.0, 1.0]);
    for vertex in 0..surface.cells() {
        let ([x, y], normal) = (surface.frame(vertex), surface.normal(vertex));
        assert!(dot(cross(x, y), normal) < -0.999_999);
        let outward = unit(surface.mesh.positions[vertex]).expect("not the middle");
        assert!(dot(normal, outward) > 1.0 - 2e-4, "{}", dot(normal, outward));
        assert!(dot(x, [0.0, 0.0, 1.0]) >= 0.0 && dot(x, normal).abs() < 1e-12);
    }
}

#[test]
fn displacements_on_a_sphere_are_great_circles() {
    let surface = Surface::new(sphere(24, 10.0), ALONG);
    let unit = surface.unit();
    let mut rng = Pcg64Mcg::seed_from_u64(2);
    let (mut worst, mut worst_end) = (0.0f64, 0.0f64);
    for _ in 0..200 {
        let [from, to] = [0; 2].map(|_| random_place(&surface, &mut rng));
        let [a, b] = [from, to].map(|place| surface.position(place));
        let far = arc(a, b, 10.0) / unit;
        if !(0.5..20.0).contains(&far) {
            continue;
        }
        let displacement = surface.displacement(from, to);
        worst = worst.max((norm(displacement) / far - 1.0).abs());
        let end = surface.position(surface.moved(from, displacement));
        worst_end = worst_end.max(distance(end, b) / unit / far);
    }
    assert!(worst < 0.004 && worst_end < 0.012, "{worst} {worst_end}");
}

#[test]
fn displacements_round_a_tube_are_those_of_the_unrolled_sheet() {
    let surface = Surface::new(cylinder([60, 40], 3.0, 12.0), [0.0, 0.0, 1.0]);
    let side = 2.0 * 3.0 * (PI / 60.0).sin() * 60.0 / TAU;
    let unit = surface.unit();
    for (columns, rows) in [(5, 3), (20, 10), (29, 0), (0, 25), (12, 20)] {
        let [from, to] = [[0, 8], [columns, 8 + rows]].map(|[x, y]| surface.center(y * 60 + x));
        let far = norm([side * TAU * f64::from(columns as u32) / 60.0, f64::from(rows as u32) * 0.3]) / unit;
        let displacement = surface.displacement(from, to);
        assert!((norm(displacement) - far).abs() < 1e-9, "{columns} {rows}: {} {far}", norm(displacement));
        assert!(distance(surface.position(surface.moved(from, displacement)), surface.position(to)) < 1e-9);
        // Up is the first axis, and the tube has no curvature that rotates it.
        assert!((displacement[0] - f64::from(rows as u32) * 0.3 / unit).abs() < 1e-9);
        let turn = surface.transport_angle(8 * 60, (8 + rows) * 60 + columns);
        assert!((turn + 180.0).rem_euclid(360.0) - 180.0 < 1e-6, "{turn}");
    }
}

#[test]
fn a_walk_ends_at_a_border() {
    let surface = Surface::new(plate([10, 10], 1.0), ALONG);
    let from = surface.closest([5.2, 5.1, 0.0]);
    let there = surface.position(surface.moved(from, [300.0, 0.0]));
    assert!(distance(there, [10.0, 5.1, 0.0]) < 1e-9, "{there:?}");
    let corner = surface.closest([0.0; 3]);
    assert_eq!(surface.moved(corner, [-1.0, 0.5]), corner);
    for displacement in [[0.0; 2], [f64::NAN, 0.0], [f64::INFINITY, 1.0]] {
        assert_eq!(surface.moved(from, displacement), from);
    }
}

#[test]
fn nothing_is_near_through_a_thin_sheet_nor_on_another_part() {
    let sheet = slab([20.0, 20.0, 0.2], 1.0);
    let surface = Surface::new(sheet, ALONG);
    let place = surface.closest([0.0, 0.0, 0.1]);
    let near: Vec<usize> = surface.near(place, 8.0, 0..surface.cells()).map(|(cell, _)| cell).collect();
    assert!(near.len() > 50);
    assert!(near.iter().all(|cell| surface.mesh.positions[*cell][2] > 0.09));
    let below = surface.closest_facing([0.0, 0.0, 0.1], [0.0, 0.0, -1.0]);
    assert!(surface.position(below)[2] < -0.09);
    assert!((norm(surface.displacement(place, below)) * surface.unit() - 20.2).abs() < 0.5);
    let parts = both(&sphere(8, 2.0), &shifted(&sphere(8, 2.0), [4.1, 0.0, 0.0]));
    let surface = Surface::new(parts, ALONG);
    let place = surface.closest([2.0, 0.0, 0.0]);
    let half = surface.cells() / 2;
    let near = surface.near(place, 1e9, 0..surface.cells());
    assert!(near.map(|(cell, _)| cell / half).max() == Some(0));
    let other = surface.center(half + 3);
    assert!(norm(surface.displacement(place, other)) > 1e50);
    assert!(
        surface.distances(&(0..2 * half).map(|cell| cell == 0).collect::<Vec<_>>()).expect("known")[half]
            .is_infinite()
    );
}

#[test]
fn a_direction_transported_there_and_back_is_unchanged() {
    let surface = Surface::new(torus([80, 40], [10.0, 4.0]), [0.0, 0.0, 1.0]);
    let mut rng = Pcg64Mcg::seed_from_u64(3);
    for _ in 0..100 {
        let from = (rng.random::<f64>() * surface.cells() as f64) as usize;
        let near: Vec<(usize, [f64; 2])> =
            surface.near(surface.center(from), 6.0, 0..surface.cells()).collect();
        for (to, displacement) in near.into_iter().step_by(9).filter(|(to, _)| *to != from) {
            let there = turned(displacement, surface.transport_angle(from, to));
            let [x, y] = surface.displacement(surface.center(to), surface.center(from));
            let off = norm([there[0] + x, there[1] + y]) / norm(displacement);
            assert!(off < 0.06, "{from} {to}: {displacement:?} {there:?} {x} {y}");
            let round = surface.transport_angle(from, to) + surface.transport_angle(to, from);
            assert!(((round + 180.0).rem_euclid(360.0) - 180.0).abs() < 1e-6);
        }
    }
}

#[test]
fn places_are_uniform_and_lie_in_their_cells() {
    let surface = Surface::new(torus([30, 12], [10.0, 4.0]), ALONG);
    let mut rng = Pcg64Mcg::seed_from_u64(4);
    let areas: f64 = (0..surface.cells()).map(|cell| surface.area(cell)).sum();
    assert!((areas / surface.cells() as f64 - 1.0).abs() < 1e-12);
    let mut mean = [0.0; 3];
    for cell in 0..surface.cells() {
        assert_eq!(surface.cell_at(surface.center(cell)), cell);
        assert!(distance(surface.position(surface.center(cell)), surface.mesh.positions[cell]) == 0.0);
    }
    let cell = 37;
    for _ in 0..4_000 {
        let place = surface.place_in(cell, [rng.random(), rng.random()]);
        assert_eq!(surface.cell_at(place), cell);
        let at = surface.position(place);
        (0..3).for_each(|axis| mean[axis] += at[axis] / 4_000.0);
    }
    // The centre of the cell: in each face 11 of 18 parts towards the corner, and 7 of 36 towards each other corner.
    let mut expected = ([0.0; 3], 0.0);
    for face in
        (0..surface.mesh.faces.len()).filter(|face| surface.mesh.faces[*face].contains(&(cell as u32)))
    {
        let area = length(surface.mesh.area_vector(face));
        for vertex in surface.mesh.faces[face] {
            let share = if vertex as usize == cell { 22.0 } else { 7.0 } / 36.0;
            (0..3).for_each(|axis| {
                expected.0[axis] += area * share * surface.mesh.positions[vertex as usize][axis];
            });
        }
        expected.1 += area;
    }
    let off = distance(mean, expected.0.map(|sum| sum / expected.1));
    assert!(off < 0.06 * surface.unit(), "{off}");
}

#[test]
fn the_closest_place_and_its_position_agree() {
    let surface = Surface::new(sphere(16, 3.0), ALONG);
    let mut rng = Pcg64Mcg::seed_from_u64(5);
    for _ in 0..100 {
        let place = random_place(&surface, &mut rng);
        let at = surface.position(place);
        assert!(distance(surface.position(surface.closest(at)), at) < 1e-12);
        let shares = place.shares();
        assert!(shares.iter().all(|share| (0.0..=1.0).contains(share)));
        assert!((shares.iter().sum::<f64>() - 1.0).abs() < 1e-12);
    }
}

#[test]
fn distances_on_a_sphere_are_great_circles_and_fall_to_the_nearest_source() {
    let surface = Surface::new(sphere(24, 10.0), ALONG);
    let from = [[10.0, 0.0, 0.0], [0.0, 0.3, 10.0]].map(|at| surface.closest(at));
    let found = distances(&surface, &from);
    let sources = from.map(|place| surface.position(place));
    for (vertex, found) in found.iter().enumerate() {
        let exact = sources.map(|at| arc(at, surface.mesh.positions[vertex], 10.0));
        let exact = exact[0].min(exact[1]);
        assert!((found - exact).abs() < 0.006 * exact + 0.01, "{found} {exact}");
    }
    assert!(distances(&surface, &[]).iter().all(|distance| distance.is_infinite()));
}

#[test]
fn surfaces_of_any_kind_and_size_give_finite_results() {
    let one = Mesh { positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], faces: vec![[0, 1, 2]] };
    let strip = prepare(&moebius([40, 4], 3.0, 1.0)).expect("a strip").0;
    for mesh in [one, strip, sphere(1, 1.0), plate([1, 1], 1.0), Mesh::default()] {
        let surface = Surface::new(mesh, [0.0; 3]);
        let cells = surface.cells();
        for cell in 0..cells {
            let place = surface.place_in(cell, [0.3, 0.8]);
            let there = surface.moved(place, [1.5, -2.0]);
            assert!(surface.position(there).iter().all(|part| part.is_finite()));
            assert!(norm(surface.displacement(place, there)).is_finite());
            assert!(surface.transport_angle(cell, cells - 1).is_finite());
        }
    }
}

#[test]
fn a_frame_on_the_axis_has_another_first_axis() {
    let surface = Surface::new(sphere(4, 1.0), [0.0, 1.0, 0.0]);
    let of_none = Surface::new(sphere(4, 1.0), [0.0; 3]);
    for surface in [surface, of_none] {
        for vertex in 0..surface.cells() {
            let [x, y] = surface.frame(vertex);
            let angle = libm::atan2(length(cross(x, y)), dot(x, y));
            assert!((angle - FRAC_PI_2).abs() < 1e-9 && (length(x) - 1.0).abs() < 1e-9);
        }
    }
}
