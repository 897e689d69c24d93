use super::*;
use crate::grid::{Edges, Field};
use crate::measure::spots::{Spot, spots};
use crate::surface::test_meshes::{cylinder, even_plate, sphere, torus};
use crate::surface::{Mesh, prepare, remesh};

/// A bump of this width about a place, in space.
fn bump(surface: &Surface, centers: &[[f64; 3]], width: f64) -> Vec<f32> {
    let at = |position: &[f64; 3]| {
        let square = |center: &[f64; 3]| (0..3).map(|k| (position[k] - center[k]).powi(2)).sum::<f64>();
        centers.iter().map(|center| libm::exp(-0.5 * square(center) / (width * width))).fold(0.0, f64::max)
    };
    surface.mesh.positions.iter().map(|position| at(position) as f32).collect()
}

/// Upright ellipses on a plate, rotated by 30° clockwise seen from above.
fn ellipses(surface: &Surface, centers: &[[f64; 2]], [long, short]: [f64; 2]) -> Vec<f32> {
    let (sin, cos) = libm::sincos(30f64.to_radians());
    let at = |[x, y, _]: &[f64; 3]| {
        let of = |[cx, cy]: &[f64; 2]| {
            // The canvas' y points down, the plate's up.
            let (dx, dy) = (x - cx, -(y - cy));
            let (along, across) = (cos * dx + sin * dy, cos * dy - sin * dx);
            libm::exp(-0.5 * ((along / long).powi(2) + (across / short).powi(2)))
        };
        centers.iter().map(of).fold(0.0, f64::max) as f32
    };
    surface.mesh.positions.iter().map(at).collect()
}

fn half(values: &[f32]) -> Vec<f32> {
    vec![0.5; values.len()]
}

#[test]
fn on_a_flat_surface_spots_are_those_of_the_plane() {
    let centers = [[12.3, 14.1], [31.7, 12.2], [22.4, 28.9]];
    let radii = [2.6, 1.5];
    let plate = even_plate([44.0, 40.0], 1.0);
    let made = remesh(&prepare(&plate).expect("a plate").0, &|_| 1.0);
    for mesh in [plate, made] {
        let surface = Surface::new(mesh, [1.0, 0.0, 0.0]);
        let values = ellipses(&surface, &centers, radii);
        let found = surface_spots(&surface, &values, &half(&values));
        let field = Field::from_fn([44, 40], [1.0; 2], Edges::Closed, |[x, y]| {
            let y = 40.0 - y;
            let (sin, cos) = libm::sincos(30f64.to_radians());
            let of = |[cx, cy]: &[f64; 2]| {
                let (dx, dy) = (x - cx, -(y - cy));
                let (along, across) = (cos * dx + sin * dy, cos * dy - sin * dx);
                libm::exp(-0.5 * ((along / radii[0]).powi(2) + (across / radii[1]).powi(2)))
            };
            centers.iter().map(of).fold(0.0, f64::max) as f32
        });
        let flat = spots(&field, 0.5);
        assert_eq!((found.len(), flat.len()), (3, 3));
        for spot in &found {
            let [x, y, _] = surface.position(spot.place);
            let near = |flat: &&Spot| {
                (flat.ellipse.center[0] - x).abs() + (flat.ellipse.center[1] - (40.0 - y)).abs() < 0.5
            };
            let flat = flat.iter().find(near).expect("the same spot");
            assert!(
                (spot.area / flat.ellipse.area() - 1.0).abs() < 0.012,
                "{} {}",
                spot.area,
                flat.ellipse.area()
            );
            assert!((spot.aspect() - flat.ellipse.aspect()).abs() < 0.01, "{}", spot.aspect());
            let off = (spot.degrees - flat.ellipse.angle + 90.0).rem_euclid(180.0) - 90.0;
            assert!(off.abs() < 0.7 && spot.whole && spot.fill > 0.98, "{off} {}", spot.fill);
            let far = (flat.ellipse.center[0] - x).hypot(flat.ellipse.center[1] - (40.0 - y));
            assert!(far < 0.03, "{far}");
        }
    }
}

#[test]
fn a_cap_of_a_sphere_has_its_area_and_is_round() {
    let made = remesh(&sphere(40, 20.0), &|_| 1.0);
    let surface = Surface::new(made, [1.0, 0.0, 0.0]);
    let centers = [[20.0, 0.0, 0.0], [0.0, 14.142, 14.142], [-11.547, -11.547, 11.547]];
    let width = 4.0;
    let values = bump(&surface, &centers, width);
    let found = surface_spots(&surface, &values, &half(&values));
    assert_eq!(found.len(), 3);
    // Chords up to c: a cap of the area π c².
    let area = PI * 2.0 * std::f64::consts::LN_2 * width * width;
    for spot in &found {
        assert!((spot.area / area - 1.0).abs() < 0.004, "{} {area}", spot.area);
        assert!(spot.aspect() > 0.985 && spot.whole, "{}", spot.aspect());
        let at = surface.position(spot.place);
        let far =
            centers.iter().map(|center| (0..3).map(|k| (at[k] - center[k]).powi(2)).sum::<f64>().sqrt());
        assert!(far.fold(f64::INFINITY, f64::min) < 0.05);
        assert!(spot.vertices.iter().all(|vertex| values[*vertex as usize] > 0.5) && spot.peak > 0.9);
    }
}

#[test]
fn directions_of_ellipses_on_a_torus_are_read_in_the_frames() {
    let surface = Surface::new(torus([200, 80], [20.0, 8.0]), [0.0, 0.0, 1.0]);
    for (degrees, place) in
        [(20.0, [28.0, 0.0, 0.0]), (75.0, [0.0, 20.0 + 5.657, 5.657]), (130.0, [-12.0, 0.0, 0.0])]
    {
        let place = surface.closest(place);
        let mut values = vec![0.0f32; surface.mesh.positions.len()];
        let (sin, cos) = libm::sincos(f64::to_radians(degrees));
        let unit = surface.unit();
        for (cell, [x, y]) in surface.near(place, 30.0, 0..values.len()) {
            let (along, across) = (cos * x + sin * y, cos * y - sin * x);
            let square = (along * unit / 2.6).powi(2) + (across * unit / 1.3).powi(2);
            values[cell] = libm::exp(-0.5 * square) as f32;
        }
        let found = surface_spots(&surface, &values, &half(&values));
        assert_eq!(found.len(), 1);
        let off = (found[0].degrees - degrees + 90.0).rem_euclid(180.0) - 90.0;
        assert!(off.abs() < 1.0 && (found[0].aspect() - 0.5).abs() < 0.012, "{off} {}", found[0].aspect());
    }
}

#[test]
fn spots_that_touch_an_open_border_are_not_whole_and_specks_are_left_out() {
    let surface = Surface::new(cylinder([80, 40], 8.0, 25.0), [0.0, 0.0, 1.0]);
    let mut values = bump(&surface, &[[8.0, 0.0, 0.5], [-8.0, 0.0, 12.0], [0.0, 8.0, 24.0]], 2.0);
    values[20 * 80 + 20] = 0.8;
    let found = surface_spots(&surface, &values, &half(&values));
    assert_eq!(found.iter().filter(|spot| spot.whole).count(), 1);
    assert_eq!(found.len(), 3);
}

#[test]
fn the_threshold_may_differ_by_place_and_all_or_nothing_may_be_above_it() {
    let surface = Surface::new(sphere(30, 20.0), [1.0, 0.0, 0.0]);
    let values = bump(&surface, &[[20.0, 0.0, 0.0], [-20.0, 0.0, 0.0]], 4.0);
    let threshold: Vec<f32> =
        surface.mesh.positions.iter().map(|at| if at[0] > 0.0 { 0.3 } else { 0.7 }).collect();
    let found = surface_spots(&surface, &values, &threshold);
    let mut areas: Vec<f64> = found.iter().map(|spot| spot.area).collect();
    areas.sort_by(f64::total_cmp);
    let expected = [0.7f64, 0.3].map(|level| PI * -2.0 * level.ln() * 16.0);
    assert!(
        areas.len() == 2 && (0..2).all(|k| (areas[k] / expected[k] - 1.0).abs() < 0.02),
        "{areas:?} {expected:?}"
    );
    let all = surface_spots(&surface, &values, &vec![-1.0; values.len()]);
    assert!(all.len() == 1 && (all[0].area / surface.mesh.area() - 1.0).abs() < 1e-9 && all[0].whole);
    assert!(surface_spots(&surface, &values, &vec![2.0; values.len()]).is_empty());
    assert!(surface_spots(&Surface::new(Mesh::default(), [1.0; 3]), &[], &[]).is_empty());
}
