//! Shapes → parallel strokes that fill them.

use super::Shape;
use super::path::{Path, Piece};
use std::collections::BTreeMap;

/// Parallel strokes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hatch {
    /// Distance between them, px; above 0.
    pub spacing: f64,
    /// Their direction, degrees from x towards y.
    pub angle: f64,
}

impl Hatch {
    /// Finer than this, px, it would be a filled area.
    pub const FINEST: f64 = 0.1;

    /// The nearest to it that goes on across the seams of a tile of `size` px: with s the spacing and α the angle, the
    /// lines y cos α − x sin α = (k + ½)s come back to themselves where m = width·sin α/s and n = height·cos α/s are whole.
    /// The spacing changes by about s/(2·side) at most, and the angle by as many radians.
    #[must_use]
    pub fn seamless(self, [width, height]: [f64; 2]) -> Self {
        let radians = self.angle.to_radians();
        let exact = [width * libm::sin(radians), height * libm::cos(radians)].map(|side| side / self.spacing);
        let mut whole = exact.map(f64::round);
        if whole == [0.0, 0.0] {
            // One line a tile is the fewest.
            let larger = usize::from(exact[1].abs() >= exact[0].abs());
            whole[larger] = 1.0_f64.copysign(exact[larger]);
        }
        let [a, b] = [whole[0] / width, whole[1] / height];
        Self { spacing: 1.0 / (a * a + b * b).sqrt(), angle: libm::atan2(a, b).to_degrees() }
    }
}

/// Strokes shorter than this share of their distance would be dots.
const SHORTEST: f64 = 0.05;
/// Halvings with which a crossing is found: to 2⁻⁴⁰ of a piece.
const HALVINGS: usize = 40;

/// The strokes of a shape: what lies in it of the lines that stand `spacing` apart, counted from the canvas' corner, so
/// that those of all shapes lie in line. They end on the Beziers themselves.
#[must_use]
pub fn hatch(shape: &Shape, hatch: Hatch) -> Vec<Path> {
    let (sin, cos) = (libm::sin(hatch.angle.to_radians()), libm::cos(hatch.angle.to_radians()));
    // Turned so that the lines lie along u, at v = (k + ½)·spacing.
    let turned = |[x, y]: [f64; 2]| [x * cos + y * sin, y * cos - x * sin];
    let mut crossings: BTreeMap<i64, Vec<f64>> = BTreeMap::new();
    for (start, piece) in shape.paths().flat_map(Path::steps) {
        let start = turned(start);
        let piece = match piece {
            Piece::Line(end) => Piece::Line(turned(end)),
            Piece::Cubic(points) => Piece::Cubic(points.map(turned)),
        };
        cross(start, &piece, hatch.spacing, &mut crossings);
    }
    let mut strokes = Vec::new();
    for (line, mut along) in crossings {
        along.sort_by(f64::total_cmp);
        let v = (line as f64 + 0.5) * hatch.spacing;
        let back = |u: f64| [u * cos - v * sin, u * sin + v * cos];
        for pair in along.chunks_exact(2).filter(|pair| pair[1] - pair[0] > SHORTEST * hatch.spacing) {
            strokes.push(Path::stroke(back(pair[0]), back(pair[1])));
        }
    }
    strokes
}

/// Where a piece crosses the lines. It is parted where it turns back across them; each part crosses a line once if its
/// ends lie on different sides, and an end on the line itself counts as above: so each line is crossed an even number
/// of times, whatever touches it.
fn cross(start: [f64; 2], piece: &Piece, spacing: f64, crossings: &mut BTreeMap<i64, Vec<f64>>) {
    let mut parts = vec![0.0];
    if let Piece::Cubic([a, b, end]) = piece {
        parts.extend(turns([start[1], a[1], b[1], end[1]]));
    }
    parts.push(1.0);
    let point = |t: f64| match t {
        0.0 => start,
        1.0 => piece.end(),
        t => piece.at(start, t),
    };
    for pair in parts.windows(2) {
        let (low, high) = (point(pair[0]), point(pair[1]));
        let first = |v: f64| (v / spacing - 0.5).ceil() as i64;
        let (from, to) = (first(low[1]), first(high[1]));
        for line in from.min(to)..from.max(to) {
            let v = (line as f64 + 0.5) * spacing;
            let u = at_height(point, [pair[0], pair[1]], low[1] < high[1], v);
            crossings.entry(line).or_default().push(u);
        }
    }
}

/// The parameters, ascending, at which a cubic with these heights turns up or down: B′(t) = 0.
fn turns([p0, p1, p2, p3]: [f64; 4]) -> Vec<f64> {
    let (a, b, c) = (p3 - p0 + 3.0 * (p1 - p2), 2.0 * (p0 - 2.0 * p1 + p2), p1 - p0);
    let root = (b * b - 4.0 * a * c).max(0.0).sqrt();
    // Without the difference of nearly equal numbers (Numerical Recipes, § 5.6).
    let q = -0.5 * (b + if b < 0.0 { -root } else { root });
    let mut turns = [q / a, c / q].to_vec();
    turns.retain(|t| *t > 0.0 && *t < 1.0);
    turns.sort_by(f64::total_cmp);
    turns.dedup();
    turns
}

/// How far along the lines the piece reaches height `v` between two parameters.
fn at_height(point: impl Fn(f64) -> [f64; 2], [mut low, mut high]: [f64; 2], rises: bool, v: f64) -> f64 {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if (point(middle)[1] < v) == rises {
            low = middle;
        } else {
            high = middle;
        }
    }
    point(0.5 * (low + high))[0]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export::outline::path::distance;

    fn ring(corners: &[[f64; 2]]) -> Path {
        let pieces = corners[1..].iter().chain(&corners[..1]).map(|corner| Piece::Line(*corner));
        Path { start: corners[0], pieces: pieces.collect(), closed: true }
    }

    #[test]
    fn a_square_with_a_hole_is_hatched_around_it() {
        let outer = ring(&[[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]]);
        let hole = ring(&[[4.0, 4.0], [4.0, 6.0], [6.0, 6.0], [6.0, 4.0]]);
        let strokes = hatch(&Shape { outer, holes: vec![hole] }, Hatch { spacing: 1.0, angle: 0.0 });
        assert_eq!(strokes.len(), 12);
        assert_eq!(strokes[0], Path::stroke([0.0, 0.5], [10.0, 0.5]));
        let ends = [[4.0, 4.5], [6.0, 4.5]];
        assert!(strokes.contains(&Path::stroke([0.0, 4.5], ends[0])));
        assert!(strokes.contains(&Path::stroke(ends[1], [10.0, 4.5])));
    }

    #[test]
    fn a_seamless_hatch_is_near_the_one_asked_for_and_comes_back_to_itself() {
        let size = [200.0, 130.0];
        for asked in [(1.0, 0.0), (1.3, 45.0), (0.7, -100.0), (3.0, 90.0), (3.0, 359.0), (2.2, 178.0)] {
            let asked = Hatch { spacing: asked.0, angle: asked.1 };
            let found = asked.seamless(size);
            let [sin, cos] = [found.angle.to_radians().sin(), found.angle.to_radians().cos()];
            for lines in [size[0] * sin / found.spacing, size[1] * cos / found.spacing] {
                assert!((lines - lines.round()).abs() < 1e-9, "{asked:?} {found:?}");
            }
            let turned = (found.angle - asked.angle + 180.0).rem_euclid(360.0) - 180.0;
            let most = asked.spacing / size[1];
            assert!((found.spacing / asked.spacing - 1.0).abs() < most, "{asked:?} {found:?}");
            assert!(turned.abs().to_radians() < most, "{asked:?} {found:?}");
        }
        // Wider than the tile.
        let one = Hatch { spacing: 900.0, angle: 90.0 }.seamless(size);
        assert!((one.spacing - 200.0).abs() < 1e-9 && (one.angle - 90.0).abs() < 1e-9, "{one:?}");
    }

    #[test]
    fn lines_through_corners_and_along_sides_leave_nothing_out() {
        // Sides lie on lines, and lines go through the corners.
        let outer = ring(&[[0.5, 0.5], [5.5, 0.5], [5.5, 5.5], [3.0, 2.5], [0.5, 5.5]]);
        for angle in [0.0, 45.0, 90.0, 180.0, 270.0, -1e6] {
            let area: f64 = outer.area();
            let strokes =
                hatch(&Shape { outer: outer.clone(), holes: vec![] }, Hatch { spacing: 0.01, angle });
            let covered: f64 = strokes.iter().map(|path| distance(path.start, path.end()) * 0.01).sum();
            assert!((covered / area - 1.0).abs() < 0.01, "{angle}: {covered} of {area}");
        }
    }

    #[test]
    fn strokes_end_on_the_curve() {
        let k = 5.522_847_5;
        let pieces = [
            [[10.0, k], [k, 10.0], [0.0, 10.0]],
            [[-k, 10.0], [-10.0, k], [-10.0, 0.0]],
            [[-10.0, -k], [-k, -10.0], [0.0, -10.0]],
            [[k, -10.0], [10.0, -k], [10.0, 0.0]],
        ];
        let outer = Path { start: [10.0, 0.0], pieces: pieces.map(Piece::Cubic).to_vec(), closed: true };
        let strokes = hatch(&Shape { outer, holes: vec![] }, Hatch { spacing: 0.7, angle: 33.0 });
        assert_eq!(strokes.len(), 28);
        for stroke in strokes {
            for end in [stroke.start, stroke.end()] {
                assert!((distance(end, [0.0, 0.0]) - 10.0).abs() < 0.003, "{end:?}");
            }
        }
    }
}
