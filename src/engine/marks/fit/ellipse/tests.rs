use proptest::prelude::*;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::*;
use crate::marks::turn;

/// `n` points on a piece of the outline, evenly in the parameter from `start` over `arc` degrees.
fn outline(ellipse: &Ellipse, n: usize, start: f64, arc: f64) -> Vec<[f64; 2]> {
    let (s, c) = ellipse.angle.to_radians().sin_cos();
    (0..n)
        .map(|i| {
            let (y, x) = (start + arc * i as f64 / (n - 1) as f64).to_radians().sin_cos();
            let (x, y) = (ellipse.radii[0] * x, ellipse.radii[1] * y);
            [ellipse.center[0] + c * x - s * y, ellipse.center[1] + s * x + c * y]
        })
        .collect()
}

fn ellipses(least_aspect: f64) -> impl Strategy<Value = Ellipse> {
    (-3000.0..3000.0f64, -3000.0..3000.0f64, 2.0..200.0f64, least_aspect..1.0f64, 0.0..180.0f64).prop_map(
        |(x, y, major, aspect, angle)| Ellipse { center: [x, y], radii: [major, major * aspect], angle },
    )
}

/// Largest difference of the numbers of two ellipses, lengths as a share of the major radius and angles
/// as the share of it that the tips are off by.
fn difference(got: &Ellipse, want: &Ellipse) -> f64 {
    let length = want.radii[0].max(want.radii[1]);
    let (dx, dy) = (got.center[0] - want.center[0], got.center[1] - want.center[1]);
    let area = (got.area() - want.area()) / (length * length);
    let aspect = got.aspect() - want.aspect();
    let turned = turn(got.major_angle(), want.major_angle()).to_radians() * (1.0 - want.aspect());
    [dx / length, dy / length, area, aspect, turned].into_iter().fold(0.0, |most, part| part.abs().max(most))
}

proptest! {
    #[test]
    fn points_of_an_ellipse_give_that_ellipse(want in ellipses(0.1), n in 5usize..80) {
        let got = ellipse(&outline(&want, n + 1, 17.0, 360.0)).unwrap();
        prop_assert!(difference(&got, &want) < 1e-6, "{got:?}");
        prop_assert!(got.radii[0] >= got.radii[1]);
    }

    #[test]
    fn a_piece_of_200_degrees_is_enough(want in ellipses(0.1), start in 0.0..360.0f64) {
        let got = ellipse(&outline(&want, 40, start, 200.0)).unwrap();
        prop_assert!(difference(&got, &want) < 1e-5, "{got:?}");
    }

    #[test]
    fn noise_of_a_fiftieth_of_the_minor_radius_hardly_matters(want in ellipses(0.2), seed: u64) {
        let mut rng = Pcg64Mcg::seed_from_u64(seed);
        let noise = 0.02 * want.radii[1];
        let mut points = outline(&want, 120, 0.0, 360.0);
        for point in &mut points {
            *point = point.map(|x| x + rng.random_range(-noise..noise));
        }
        let got = ellipse(&points).unwrap();
        prop_assert!(difference(&got, &want) < 0.06, "{got:?}");
        prop_assert!((got.area() / want.area() - 1.0).abs() < 0.03, "{got:?}");
    }

    #[test]
    fn whatever_the_points_the_answer_is_an_ellipse_or_none(
        points in prop::collection::vec(prop::array::uniform2(prop_oneof![
            4 => (-5i32..5).prop_map(f64::from),
            4 => -100.0..100.0f64,
            1 => prop::num::f64::ANY,
        ]), 0..12),
    ) {
        if let Some(got) = ellipse(&points) {
            prop_assert!(got.radii.iter().all(|r| r.is_finite() && *r > 0.0), "{got:?}");
            prop_assert!(got.center.iter().all(|x| x.is_finite()) && (0.0..180.0).contains(&got.angle));
        }
    }
}

#[test]
fn five_points_of_a_circle_give_the_circle() {
    let got = ellipse(&[[3.0, 0.0], [-3.0, 0.0], [0.0, 3.0], [0.0, -3.0], [1.8, 2.4]]).unwrap();
    assert!(
        difference(&got, &Ellipse { center: [0.0, 0.0], radii: [3.0, 3.0], angle: 0.0 }) < 1e-9,
        "{got:?}"
    );
}

#[test]
fn points_that_determine_no_ellipse_give_none() {
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    assert_eq!(ellipse(&[]), None);
    assert_eq!(ellipse(&square), None);
    assert_eq!(ellipse(&[square, square].concat()), None, "four different points");
    assert_eq!(ellipse(&[[2.5, 7.1]; 20]), None, "one point");
    let line: Vec<_> = (0..20).map(|i| [1000.1 + 0.3 * f64::from(i), 500.7 - 0.1 * f64::from(i)]).collect();
    assert_eq!(ellipse(&line), None, "a line");
    let mut circle = outline(&Ellipse { center: [0.0; 2], radii: [1.0; 2], angle: 0.0 }, 9, 0.0, 360.0);
    circle[3][1] = f64::NAN;
    assert_eq!(ellipse(&circle), None, "not a number");
}

#[test]
fn a_rectangle_s_second_moments_give_the_ellipse_that_has_them() {
    let got = ellipse_from_moments([1.0, 2.0], [3.0, 0.0, 12.0]).unwrap();
    assert_eq!(got, Ellipse { center: [1.0, 2.0], radii: [48f64.sqrt(), 12f64.sqrt()], angle: 90.0 });
    assert_eq!(ellipse_from_moments([0.0; 2], [1.0, 1.0, 1.0]), None);
    assert_eq!(ellipse_from_moments([0.0; 2], [0.0; 3]), None);
    assert_eq!(ellipse_from_moments([0.0; 2], [f64::NAN, 0.0, 1.0]), None);
}
