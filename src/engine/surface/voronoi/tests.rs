//! Relaxed points on small surfaces.

use super::{RelaxedPoints, WeightedSum, random_points, voronoi_laplacian};
use crate::grid::Domain;
use crate::surface::test_meshes::sphere;
use crate::surface::{Surface, remesh};

/// A sphere of radius 1 with about as many cells as `points`.
fn ball(points: usize) -> Surface {
    let mesh = sphere(24, 1.0);
    let edge = (mesh.area() / points as f64 * 2.0 / 3.0_f64.sqrt()).sqrt();
    Surface::new(remesh(&mesh, &|_| edge), [0.0, 0.0, 1.0])
}

/// The distance of each point from its nearest neighbour, relative to that in a hexagonal lattice: mean and coefficient of
/// variation.
fn nearest(surface: &Surface, points: &RelaxedPoints) -> [f64; 2] {
    let lattice = (surface.mesh.area() / points.places.len() as f64 * 2.0 / 3.0_f64.sqrt()).sqrt();
    let near = super::near::Near::new(surface, &points.places);
    let one = |index: usize| {
        let around = near.around(index, points.radius);
        around.iter().map(|(_, [x, y])| (x * x + y * y).sqrt() / lattice).fold(f64::INFINITY, f64::min)
    };
    let all: Vec<f64> = (0..points.places.len()).map(one).collect();
    let mean = all.iter().sum::<f64>() / all.len() as f64;
    let square = all.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / all.len() as f64;
    [mean, square.sqrt() / mean]
}

#[test]
fn repulsion_spreads_random_points_evenly() {
    let surface = ball(600);
    let [[before, _], [after, varies]] =
        [0, 40].map(|iterations| nearest(&surface, &RelaxedPoints::new(&surface, 600, iterations, 1)));
    assert!(before < 0.55 && after > 0.8 && varies < 0.1, "{before} {after} {varies}");
}

#[test]
fn random_points_have_the_same_density_everywhere() {
    let surface = ball(600);
    let upper = random_points(&surface, 4000, 2);
    let upper = upper.iter().filter(|place| surface.position(**place)[2] > 0.5).count();
    // A quarter of a sphere lies above z = ½.
    assert!(upper.abs_diff(1000) < 100, "{upper}");
}

#[test]
fn coefficients_sum_up_to_four_and_neighbours_know_each_other() {
    let surface = ball(400);
    let points = RelaxedPoints::new(&surface, 400, 40, 3);
    let laplacian = voronoi_laplacian(&surface, &points);
    let (mut one_way, mut entries) = (0, 0);
    for row in 0..400 {
        let of = |row: usize| laplacian.starts[row] as usize..laplacian.starts[row + 1] as usize;
        let sum: f64 = laplacian.weights[of(row)].iter().sum();
        assert!((sum - 4.0).abs() < 1e-9, "{sum}");
        for column in &laplacian.columns[of(row)] {
            entries += 1;
            let back = &laplacian.columns[of(*column as usize)];
            one_way += usize::from(back.binary_search(&(row as u32)).is_err());
        }
    }
    // The tangent planes differ, so that short edges may exist in only one of two.
    assert!((5.5..6.5).contains(&(f64::from(entries) / 400.0)), "{entries}");
    assert!(f64::from(one_way as u32) < 0.03 * f64::from(entries), "{one_way} of {entries}");
}

#[test]
fn a_weighted_sum_keeps_one_value_and_lies_between_others() {
    let surface = ball(300);
    let points = RelaxedPoints::new(&surface, 300, 20, 4);
    let sums = WeightedSum::new(&surface, &points);
    let places: Vec<_> = (0..surface.cells()).map(|cell| surface.center(cell)).collect();
    assert!(places.iter().all(|place| sums.at(*place, &[0.25; 300]) == Some(0.25)));
    let heights: Vec<f32> = points.places.iter().map(|place| surface.position(*place)[2] as f32).collect();
    for place in &places {
        let (found, height) =
            (sums.at(*place, &heights).expect("points are near"), surface.position(*place)[2]);
        assert!((f64::from(found) - height).abs() < 0.15, "{found} at {height}");
    }
}
