//! Total least squares line.

use super::covariance;
use crate::marks::Line;

/// The straight line of the least squared distances to `points` (px), as long as their extent along it.
///
/// It runs through the mean of the points in the direction θ of their largest variance,
/// tan 2θ = 2·cxy / (cxx − cyy), and ends where the outermost points project to; `from` is the end nearer to
/// the first point. `width` (px) is that of the line. `None` where the points have no extent or are not
/// finite numbers.
#[must_use]
pub fn line(points: &[[f64; 2]], width: f64) -> Option<Line> {
    let (mean, [cxx, cxy, cyy]) = covariance(points)?;
    let theta = 0.5 * libm::atan2(2.0 * cxy, cxx - cyy);
    let direction = [libm::cos(theta), libm::sin(theta)];
    let along = |[x, y]: &[f64; 2]| (x - mean[0]) * direction[0] + (y - mean[1]) * direction[1];
    let (low, high) = points.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), point| {
        (low.min(along(point)), high.max(along(point)))
    });
    if !(high - low).is_normal() {
        return None;
    }
    let at = |t: f64| [mean[0] + t * direction[0], mean[1] + t * direction[1]];
    let first = along(&points[0]);
    let (start, end) = if high - first < first - low { (high, low) } else { (low, high) };
    let line = Line { from: at(start), to: at(end), width };
    (line.length() > 0.0 && line.length().is_finite()).then_some(line)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::marks::turn;
    use proptest::prelude::*;

    #[test]
    fn points_on_a_line_give_its_ends_in_order() {
        let line = line(&[[7.0, 4.0], [5.0, 3.0], [1.0, 1.0], [3.0, 2.0]], 6.0).unwrap();
        for (got, want) in [(line.from, [7.0, 4.0]), (line.to, [1.0, 1.0])] {
            assert!((got[0] - want[0]).abs() < 1e-12 && (got[1] - want[1]).abs() < 1e-12, "{line:?}");
        }
        assert_eq!(line.width, 6.0);
    }

    #[test]
    fn distances_are_measured_across_the_line_and_not_along_y() {
        // A cross of arms 2 (upright) and 1: ordinary regression of y on x would lie flat.
        let line = line(&[[0.0, -2.0], [0.0, 2.0], [-1.0, 0.0], [1.0, 0.0]], 1.0).unwrap();
        assert_eq!(line.angle(), 90.0);
        assert_eq!(line.length(), 4.0);
    }

    #[test]
    fn points_without_extent_give_no_line() {
        assert_eq!(line(&[], 1.0), None);
        assert_eq!(line(&[[3.0, 4.0]], 1.0), None);
        assert_eq!(line(&[[3.1, 4.7]; 7], 1.0), None);
        assert_eq!(line(&[[0.0, 0.0], [f64::NAN, 1.0]], 1.0), None);
        assert_eq!(line(&[[0.0, 0.0], [f64::INFINITY, 1.0]], 1.0), None);
        assert_eq!(line(&[[-1e300, 0.0], [1e300, 1.0]], 1.0), None);
    }

    proptest! {
        #[test]
        fn the_line_turns_and_moves_with_its_points(
            angle in 0.0..180.0f64, x in -1e3..1e3f64, y in -1e3..1e3f64, length in 1.0..500.0f64,
        ) {
            // Two rows of points, as far on this side as on that.
            let (c, s) = (angle.to_radians().cos(), angle.to_radians().sin());
            let points: Vec<_> = (0..40).map(|i| {
                let t = (f64::from(i / 2) / 19.0 - 0.5) * length;
                let across = 0.1 * length * f64::from([1, -1][i as usize % 2]);
                [x + t * c - across * s, y + t * s + across * c]
            }).collect();
            let line = line(&points, 2.0).unwrap();
            prop_assert!(turn(line.angle(), angle).abs() < 1e-6, "{line:?}");
            prop_assert!((line.length() / length - 1.0).abs() < 1e-9);
        }
    }
}
