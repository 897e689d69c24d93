use super::*;
use crate::surface::Mesh;
use crate::surface::test_meshes::{cylinder, even_plate, plate, sphere, torus};
use crate::surface::vector::{dot, plus, times};

/// The angle between two axial directions, degrees.
fn apart(a: f64, b: f64) -> f64 {
    let off = (a - b).rem_euclid(180.0);
    off.min(180.0 - off)
}

fn index_sum(directions: &Directions) -> f64 {
    directions.singularities.iter().map(|singularity| singularity.index).sum()
}

#[test]
fn without_strokes_directions_run_along() {
    let bodies = [(plate([12, 9], 1.0), [0.3, 0.2, 1.0]), (cylinder([40, 20], 3.0, 8.0), [0.0, 0.0, 1.0])];
    for (mesh, along) in bodies {
        let surface = Surface::new(mesh, along);
        let found = directions(&surface, &[], 0.01);
        assert!(found.degrees.iter().all(|degrees| apart(*degrees, 0.0) < 3.0));
        assert!(found.singularities.is_empty());
        let least = found.coherence.iter().copied().fold(1.0, f64::min);
        assert!(least > 0.95, "{least}");
    }
}

#[test]
fn given_directions_are_held_with_smooth_transitions() {
    let surface = Surface::new(even_plate([40.0, 10.0], 1.0), [1.0, 0.0, 0.0]);
    let rows = [1.0, 3.0, 5.0, 7.0, 9.0];
    let given: Vec<_> = rows
        .iter()
        .flat_map(|y| [([0.5, *y, 0.0], 10.0), ([39.5, *y, 0.0], 70.0)])
        .map(|(at, degrees)| (surface.closest(at), degrees, 1.0))
        .collect();
    let found = directions(&surface, &given, 0.0);
    for (place, degrees, _) in &given {
        assert!(apart(found.degrees[surface.vertex_of(*place)], *degrees) < 2.0);
    }
    // Between them the angle changes steadily, like the argument along the line from one z to the other.
    for vertex in 0..surface.cells() {
        let x = surface.mesh.positions[vertex][0];
        let share = (x - 0.5) / 39.0;
        let ([a, b], [c, d]) = (
            [20.0f64, 140.0].map(f64::to_radians).map(f64::cos),
            [20.0f64, 140.0].map(f64::to_radians).map(f64::sin),
        );
        let expected = 0.5 * atan2(c + share * (d - c), a + share * (b - a)).to_degrees();
        let off = apart(found.degrees[vertex], expected);
        assert!(off < 4.0 || !(0.02..0.98).contains(&share), "{x}: {} {expected}", found.degrees[vertex]);
    }
    assert!(found.singularities.is_empty());
}

#[test]
fn a_stroke_is_followed_near_it_and_along_far_away() {
    let surface = Surface::new(even_plate([60.0, 60.0], 1.0), [1.0, 0.0, 0.0]);
    let given: Vec<_> =
        (0..10).map(|k| (surface.closest([25.0 + f64::from(k), 30.0, 0.0]), 40.0, 1.0)).collect();
    let found = directions(&surface, &given, 0.04);
    let at = |x: f64, y: f64| found.degrees[surface.vertex_of(surface.closest([x, y, 0.0]))];
    assert!(apart(at(30.0, 30.0), 40.0) < 1.0 && apart(at(30.0, 55.0), 0.0) < 3.0);
    let between = apart(at(30.0, 36.0), 0.0);
    assert!((4.0..36.0).contains(&between), "{between}");
}

#[test]
fn indices_add_up_to_the_euler_characteristic_and_coherence_falls_to_0_there() {
    for (mesh, euler) in [(sphere(20, 10.0), 2.0), (torus([80, 36], [10.0, 4.0]), 0.0)] {
        let surface = Surface::new(mesh, [0.0, 0.2, 1.0]);
        let mut given = Vec::new();
        for k in 0..9 {
            let at = surface.closest([
                12.0 * libm::cos(f64::from(k)),
                12.0 * libm::sin(f64::from(k)),
                f64::from(k) - 4.0,
            ]);
            given.push((at, 37.0 * f64::from(k), 1.0));
        }
        let found = directions(&surface, &given, 1e-3);
        assert!((index_sum(&found) - euler).abs() < 1e-9, "{}", index_sum(&found));
        assert!(euler == 0.0 || !found.singularities.is_empty());
        for singularity in &found.singularities {
            let corners = surface.mesh.faces[singularity.place.face as usize];
            assert!(corners.iter().all(|vertex| found.coherence[*vertex as usize] < 0.6), "{singularity:?}");
        }
        let high = found.coherence.iter().filter(|coherence| **coherence > 0.95).count();
        assert!(2 * high > surface.cells(), "{high}");
    }
}

/// Directions as vectors in space.
fn vectors(surface: &Surface, found: &Directions) -> Vec<[f64; 3]> {
    let of = |vertex: usize| {
        let (sin, cos) = libm::sincos(found.degrees[vertex].to_radians());
        let [x, y] = surface.frame(vertex);
        plus(times(x, cos), times(y, sin))
    };
    (0..surface.cells()).map(of).collect()
}

#[test]
fn directions_do_not_depend_on_the_frames() {
    let mesh = sphere(22, 10.0);
    let surfaces = [[0.0, 0.0, 1.0], [1.0, 0.5, 0.0]].map(|along| Surface::new(mesh.clone(), along));
    let found = surfaces.each_ref().map(|surface| {
        let given: Vec<_> = (0..12)
            .map(|k| {
                let place = surface.closest([
                    9.0 * libm::cos(0.3 * f64::from(k)),
                    9.0 * libm::sin(0.3 * f64::from(k)),
                    2.0,
                ]);
                let [x, y] = surface.frame(surface.vertex_of(place));
                let degrees = atan2(y[2], x[2]).to_degrees() + 30.0;
                (place, degrees, 1.0)
            })
            .collect();
        vectors(surface, &directions(surface, &given, 0.0))
    });
    let off = found[0].iter().zip(&found[1]).filter(|(a, b)| dot(**a, **b).abs() < 0.99).count();
    assert!(off * 50 < mesh.positions.len(), "{off}");
}

#[test]
fn more_unknowns_than_are_solved_at_once_give_the_same_field() {
    let surface = Surface::new(torus([120, 60], [10.0, 4.0]), [0.0, 0.0, 1.0]);
    let mut matrix = connection(&surface);
    matrix.hold(7, [0.6, 0.8], 100.0);
    matrix.hold(4_000, [-1.0, 0.0], 100.0);
    (0..surface.cells()).for_each(|vertex| matrix.hold(vertex, [1.0, 0.0], 1e-3));
    let plain = matrix.solve(vec![[0.0; 2]; surface.cells()]);
    let found = coarse::solve(&matrix);
    let off = plain.iter().zip(&found).map(|(a, b)| (a[0] - b[0]).abs().max((a[1] - b[1]).abs()));
    assert!(off.fold(0.0, f64::max) < 1e-4);
}

#[test]
fn any_given_directions_give_a_finite_field() {
    let surface = Surface::new(sphere(3, 1.0), [0.0; 3]);
    let bad = [
        (surface.center(0), f64::NAN, 1.0),
        (surface.center(3), 10.0, -5.0),
        (surface.center(2), 1.0, f64::NAN),
    ];
    let found = directions(&surface, &bad, f64::NAN);
    assert!(found.degrees.iter().all(|degrees| (0.0..180.0).contains(degrees)));
    assert!(directions(&Surface::new(Mesh::default(), [1.0; 3]), &[], 1.0).degrees.is_empty());
}
