//! The width of blotches: dots, worms and intermediate shapes.

use std::f64::consts::PI;

use crate::grid::Field;
use crate::measure::spots::{Spot, spots};

/// The mean width of the regions above `level`, weighted by their areas, px; `None` if there are none.
///
/// The width of a region is that of the stadium (a rectangle with a half circle at each end) with its area A and contour P, w = (P
/// − √(P² − 4πA)) ÷ π: for a disc the diameter, for a long worm 2A ÷ P. Discs come out up to 3 % too narrow, since the root is
/// sensitive to a contour that is too long by a thousandth. For a region that is cut by the frame it is 2A ÷ P.
#[must_use]
pub fn blotch_width(field: &Field, level: f32) -> Option<f64> {
    let (mut sum, mut areas) = (0.0, 0.0);
    for spot in spots(field, level).iter().filter(|spot| spot.contour > 0.0) {
        let area = PI * spot.ellipse.radii[0] * spot.ellipse.radii[1];
        sum += area * width(spot, area);
        areas += area;
    }
    (areas > 0.0).then(|| sum / areas)
}

fn width(spot: &Spot, area: f64) -> f64 {
    let contour = spot.contour;
    if !spot.whole {
        return 2.0 * area / contour;
    }
    // For a disc the radicand is 0; noise may make it negative.
    (contour - (contour * contour - 4.0 * PI * area).max(0.0).sqrt()) / PI
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Bounds, Edges, Grid};
    use crate::marks::distance_to_segment;

    /// 1 within half of `width` of a line from (`from`, 50) to (`to`, 50) px.
    fn stadium(from: f64, to: f64, width: f64) -> Field {
        let size = [100.0; 2];
        let grid = Grid { size: [200; 2], cell: [0.5; 2], edges: Edges::Closed };
        assert_eq!(grid.bounds_px(), Bounds { size, edges: Edges::Closed });
        let value = |cell: usize| {
            let away = distance_to_segment(grid.center_px(cell), [[from, 50.0], [to, 50.0]]);
            (0.5 + 0.5 * (0.5 * width - away)).clamp(0.0, 1.0) as f32
        };
        Field::new(&grid, (0..200 * 200).map(value).collect())
    }

    #[test]
    fn discs_stadiums_and_bars_across_the_canvas_have_their_width() {
        for (from, to) in [(50.0, 50.0), (45.0, 55.0), (20.0, 80.0), (-20.0, 120.0)] {
            for width in [6.0, 10.0, 15.0] {
                let got = blotch_width(&stadium(from, to, width), 0.5).expect("a blotch");
                assert!((got / width - 1.0).abs() < 0.03, "{from} to {to}, {width}: {got}");
            }
        }
    }

    #[test]
    fn an_empty_field_has_no_width() {
        assert_eq!(blotch_width(&stadium(50.0, 50.0, -4.0), 0.5), None);
    }
}
