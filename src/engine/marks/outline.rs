//! Closed polygons: the ellipse with the same moments, and how badly they cross themselves.

use super::{Ellipse, Moments, axial};

/// The ellipse with the area, the centre, and of its second moments the aspect and the direction of a closed polygon, px; the last
/// corner is joined to the first. `None` where it encloses no area.
///
/// ```
/// use dapple_engine::marks::ellipse_of_outline;
///
/// let square = [[0.0, 0.0], [20.0, 0.0], [20.0, 20.0], [0.0, 20.0]];
/// let disc = ellipse_of_outline(&square).unwrap();
/// assert!((disc.area() - 400.0).abs() < 1e-6);
/// assert_eq!(disc.center, [10.0, 10.0]);
/// ```
#[must_use]
pub fn ellipse_of_outline(corners: &[[f64; 2]]) -> Option<Ellipse> {
    let first = *corners.first()?;
    // About its first corner: far from the origin differences of large sums would lose digits.
    let near: Vec<[f64; 2]> = corners.iter().map(|[x, y]| [x - first[0], y - first[1]]).collect();
    let moments = Moments::polygon(&near);
    let (center, [xx, xy, yy]) = moments.central();
    let (mean, apart) = (0.5 * (xx + yy), (0.25 * (xx - yy) * (xx - yy) + xy * xy).sqrt());
    let aspect = ((mean - apart) / (mean + apart)).sqrt();
    if !(moments.area != 0.0 && aspect > 0.0) {
        return None;
    }
    let angle = axial(0.5 * libm::atan2(2.0 * xy, xx - yy).to_degrees());
    let center = [0, 1].map(|axis| first[axis] + center[axis]);
    let ellipse = Ellipse::from_area(center, moments.area.abs(), aspect, angle);
    let is_sound =
        ellipse.radii.iter().chain(&ellipse.center).all(|number| number.is_finite() && *number != 0.0);
    is_sound.then_some(ellipse)
}

/// The largest loop that the crossings of a closed polygon with itself cut off, and where the crossing is, px: each crossing cuts it
/// into two loops, of which the smaller has this share of the areas of both, 0..½. `None` where it does not cross itself.
#[must_use]
pub fn largest_loop(corners: &[[f64; 2]]) -> Option<(f64, [f64; 2])> {
    let count = corners.len();
    let side = |k: usize| [corners[k], corners[(k + 1) % count]];
    // Twice the area between the origin and the first k sides.
    let mut swept = vec![0.0; count + 1];
    for k in 0..count {
        let [a, b] = side(k);
        swept[k + 1] = swept[k] + cross(a, b);
    }
    let span = |k: usize| {
        let [a, b] = side(k);
        [a[0].min(b[0]), a[0].max(b[0])]
    };
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|a, b| span(*a)[0].total_cmp(&span(*b)[0]).then(a.cmp(b)));
    let mut largest: Option<(f64, [f64; 2])> = None;
    for (place, &one) in order.iter().enumerate() {
        let end = span(one)[1];
        for &other in order[place + 1..].iter().take_while(|other| span(**other)[0] <= end) {
            let (i, j) = (one.min(other), one.max(other));
            let Some(at) = crossing(side(i), side(j)) else { continue };
            let inner = cross(at, corners[(i + 1) % count]) + swept[j] - swept[i + 1] + cross(corners[j], at);
            let loops = [inner.abs(), (swept[count] - inner).abs()];
            let share = loops[0].min(loops[1]) / (loops[0] + loops[1]).max(f64::MIN_POSITIVE);
            if largest.is_none_or(|(before, _)| share > before) {
                largest = Some((share, at));
            }
        }
    }
    largest
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// Where two segments cross, neither at its end.
fn crossing([a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]) -> Option<[f64; 2]> {
    let along = [b[0] - a[0], b[1] - a[1]];
    let other = [d[0] - c[0], d[1] - c[1]];
    let way = [c[0] - a[0], c[1] - a[1]];
    let area = cross(along, other);
    let (t, u) = (cross(way, other) / area, cross(way, along) / area);
    let inside = |share: f64| share > 0.0 && share < 1.0;
    (inside(t) && inside(u)).then(|| [a[0] + t * along[0], a[1] + t * along[1]])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_outline_has_the_ellipse_of_its_moments_wherever_it_lies_and_however_it_runs() {
        let drawn = Ellipse { center: [3000.0, 2000.0], radii: [30.0, 12.0], angle: 40.0 };
        let (s, c) = libm::sincos(drawn.angle.to_radians());
        let at = |k: usize| {
            let (v, u) = libm::sincos(std::f64::consts::TAU * k as f64 / 720.0);
            let [x, y] = [drawn.radii[0] * u, drawn.radii[1] * v];
            [drawn.center[0] + c * x - s * y, drawn.center[1] + s * x + c * y]
        };
        let mut corners: Vec<[f64; 2]> = (0..720).map(at).collect();
        for _ in 0..2 {
            let found = ellipse_of_outline(&corners).expect("an area");
            assert!((found.area() / drawn.area() - 1.0).abs() < 1e-4, "{found:?}");
            assert!((found.aspect() - 0.4).abs() < 1e-4 && (found.angle - 40.0).abs() < 1e-3, "{found:?}");
            assert!((0..2).all(|axis| (found.center[axis] - drawn.center[axis]).abs() < 1e-6), "{found:?}");
            corners.reverse();
        }
        let flat = [[0.0, 0.0], [5.0, 5.0], [10.0, 10.0]];
        assert_eq!((ellipse_of_outline(&flat), ellipse_of_outline(&[])), (None, None));
    }

    #[test]
    fn a_figure_of_eight_is_two_loops_and_a_crossed_end_a_small_one() {
        let square = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]];
        assert_eq!(largest_loop(&square), None);
        // Two triangles, one twice as wide and as high as the other: their areas are 1 : 4.
        let bow = [[-10.0, -5.0], [-10.0, 5.0], [20.0, -10.0], [20.0, 10.0]];
        let (share, [x, y]) = largest_loop(&bow).expect("a crossing");
        assert!((share - 0.2).abs() < 1e-12 && x.abs() < 1e-12 && y.abs() < 1e-12, "{share} {x} {y}");
        // The hand went a little too far before it closed the outline.
        let closed = [[0.0, 0.0], [20.0, 0.0], [20.0, 20.0], [0.0, 20.0], [0.5, -0.5], [1.0, -0.5]];
        let (share, _) = largest_loop(&closed).expect("a crossing");
        assert!(share < 0.01, "{share}");
    }
}
