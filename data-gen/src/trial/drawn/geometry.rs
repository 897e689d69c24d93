//! Outlines of ellipses, and distances between them.

use std::f64::consts::TAU;

use dapple_engine::marks::Ellipse;

/// Points of an outline: with these, the gap between two outlines is exact to 1 % of their size.
const POINTS: u32 = 72;

/// `point` turned about the origin `by` radians.
pub fn turned([x, y]: [f64; 2], by: f64) -> [f64; 2] {
    let (c, s) = (libm::cos(by), libm::sin(by));
    [c * x - s * y, s * x + c * y]
}

/// Distance of two points.
pub fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    libm::hypot(a[0] - b[0], a[1] - b[1])
}

/// The mean radius √(r₁r₂) of an ellipse.
pub fn radius(ellipse: &Ellipse) -> f64 {
    (ellipse.radii[0] * ellipse.radii[1]).sqrt()
}

/// Points on the outline.
pub fn outline(ellipse: &Ellipse) -> Vec<[f64; 2]> {
    let point = |k: u32| {
        let t = TAU * f64::from(k) / f64::from(POINTS);
        let [x, y] = turned(
            [ellipse.radii[0] * libm::cos(t), ellipse.radii[1] * libm::sin(t)],
            ellipse.angle.to_radians(),
        );
        [ellipse.center[0] + x, ellipse.center[1] + y]
    };
    (0..POINTS).map(point).collect()
}

/// Whether a point is inside.
pub fn contains(ellipse: &Ellipse, point: [f64; 2]) -> bool {
    let from = [point[0] - ellipse.center[0], point[1] - ellipse.center[1]];
    let [x, y] = turned(from, -ellipse.angle.to_radians());
    let [x, y] = [x / ellipse.radii[0], y / ellipse.radii[1]];
    x * x + y * y <= 1.0
}

/// Whether the gap between the outlines of two ellipses is more than a quarter of the mean of their diameters 2√(r₁r₂).
pub fn well_apart(a: &Ellipse, b: &Ellipse) -> bool {
    let least = 0.25 * (radius(a) + radius(b));
    let reach = a.radii[0].max(a.radii[1]) + b.radii[0].max(b.radii[1]) + least;
    if distance(a.center, b.center) > reach {
        return true;
    }
    let (of_a, of_b) = (outline(a), outline(b));
    let nested = contains(a, b.center) || contains(b, a.center);
    let crossing = of_a.iter().any(|point| contains(b, *point));
    !nested && !crossing && of_a.iter().all(|p| of_b.iter().all(|q| distance(*p, *q) >= least))
}

/// The part of an ellipse that is on a canvas of `size` px: its share of the area and its centre.
pub fn visible(ellipse: &Ellipse, size: [f64; 2]) -> (f64, [f64; 2]) {
    const STEPS: i32 = 40;
    let (mut inside, mut all, mut sum) = (0.0, 0.0, [0.0; 2]);
    for row in -STEPS..=STEPS {
        for column in -STEPS..=STEPS {
            let [x, y] = [column, row].map(|k| f64::from(k) / f64::from(STEPS));
            if x * x + y * y > 1.0 {
                continue;
            }
            let [x, y] = turned([x * ellipse.radii[0], y * ellipse.radii[1]], ellipse.angle.to_radians());
            let point = [ellipse.center[0] + x, ellipse.center[1] + y];
            all += 1.0;
            if (0..2).all(|axis| (0.0..=size[axis]).contains(&point[axis])) {
                inside += 1.0;
                sum = [sum[0] + point[0], sum[1] + point[1]];
            }
        }
    }
    if inside == all || inside == 0.0 {
        return (inside / all, ellipse.center);
    }
    (inside / all, sum.map(|sum| sum / inside))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn disc(x: f64, radius: f64) -> Ellipse {
        Ellipse { center: [x, 0.0], radii: [radius; 2], angle: 0.0 }
    }

    #[test]
    fn discs_are_well_apart_from_a_quarter_of_their_mean_diameter_on() {
        let apart = |gap: f64| well_apart(&disc(0.0, 10.0), &disc(10.0 + gap + 6.0, 6.0));
        assert!(!apart(3.8) && apart(4.2));
        assert!(!well_apart(&disc(0.0, 50.0), &disc(1.0, 3.0)), "one inside the other");
    }

    #[test]
    fn half_of_a_disc_on_the_border_is_visible_with_its_centre_inside() {
        let (share, center) = visible(&disc(0.0, 10.0), [100.0, 100.0]);
        // A quarter in the corner (0, 0): its centroid is 4r ÷ 3π from both axes.
        assert!((share - 0.25).abs() < 0.02);
        assert!(center.iter().all(|x| (x - 40.0 / (3.0 * std::f64::consts::PI)).abs() < 0.15), "{center:?}");
        let inside = Ellipse { center: [50.0, 50.0], radii: [9.0, 3.0], angle: 20.0 };
        assert_eq!(visible(&inside, [100.0, 100.0]), (1.0, [50.0, 50.0]));
    }
}
