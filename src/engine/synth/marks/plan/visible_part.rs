//! The part of a drawn spot inside the border of the canvas.

use crate::attributes::regions::RegionGrid;
use crate::marks::Ellipse;

/// The part of a drawn spot that lies on the canvas.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VisiblePart {
    /// Its centre of gravity, px.
    pub center: [f64; 2],
    /// Its area, px².
    pub area: f64,
}

impl VisiblePart {
    /// The part of an ellipse that lies on this canvas; the whole ellipse if no part does.
    #[must_use]
    pub fn new(ellipse: &Ellipse, layout: &RegionGrid) -> Self {
        const RINGS: usize = 12;
        const POINTS: usize = 48;
        let [s, c] = [libm::sin, libm::cos].map(|f| f(ellipse.angle.to_radians()));
        let point = |ring: usize, k: usize| {
            // Rings of equal area.
            let radius = ((ring as f64 + 0.5) / RINGS as f64).sqrt();
            let way = std::f64::consts::TAU * k as f64 / POINTS as f64;
            let [along, across] =
                [ellipse.radii[0] * radius * libm::cos(way), ellipse.radii[1] * radius * libm::sin(way)];
            [ellipse.center[0] + along * c - across * s, ellipse.center[1] + along * s + across * c]
        };
        let on = |point: &[f64; 2]| layout.bounds().contains(*point);
        let all = (0..RINGS).flat_map(|ring| (0..POINTS).map(move |k| (ring, k)));
        let inside: Vec<[f64; 2]> = all.map(|(ring, k)| point(ring, k)).filter(on).collect();
        if inside.is_empty() || inside.len() == RINGS * POINTS {
            return Self { center: ellipse.center, area: ellipse.area() };
        }
        let mean = |axis: usize| inside.iter().map(|point| point[axis]).sum::<f64>() / inside.len() as f64;
        let share = inside.len() as f64 / (RINGS * POINTS) as f64;
        Self { center: [mean(0), mean(1)], area: share * ellipse.area() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;

    fn visible(x: f64, edges: Edges) -> VisiblePart {
        let canvas = RegionGrid { size: [200.0, 100.0], grid: [1, 1], edges };
        VisiblePart::new(&Ellipse { center: [x, 50.0], radii: [12.0, 8.0], angle: 0.0 }, &canvas)
    }

    #[test]
    fn half_of_an_ellipse_with_its_centre_on_the_border_is_visible() {
        let half = visible(0.0, Edges::Closed);
        let area = std::f64::consts::PI * 12.0 * 8.0;
        assert!((half.area / area - 0.5).abs() < 0.03, "{half:?}");
        // The centroid of a half disc is 4 r ÷ 3 π from its diameter.
        let off = 4.0 * 12.0 / (3.0 * std::f64::consts::PI);
        assert!((half.center[0] - off).abs() < 0.4 && (half.center[1] - 50.0).abs() < 0.4, "{half:?}");
    }

    #[test]
    fn an_ellipse_that_no_closed_border_cuts_is_wholly_visible() {
        for (x, edges) in [(30.0, Edges::Closed), (0.0, Edges::Wrap)] {
            let all = visible(x, edges);
            assert_eq!(all.center, [x, 50.0]);
            assert!((all.area - std::f64::consts::PI * 96.0).abs() < 1e-9, "{all:?}");
        }
    }
}
