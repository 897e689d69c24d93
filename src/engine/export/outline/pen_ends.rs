//! The distance from an outline at which the strokes of a pen with round ends stop, so that together they have the area of the
//! shape.

/// A pen that draws parallel strokes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PenEnds {
    /// Width of the pen, px.
    pub pen: f64,
    /// Distance of the strokes, px.
    pub spacing: f64,
}

/// Number of places across a stroke at which its reach is computed: with 16 the sides of neighbours count a fourth too much.
const PLACES: usize = 100;
/// The largest slope of an outline that is used: at larger slopes the outline runs along the strokes.
const STEEPEST: f64 = 50.0;
/// Length of a dot ÷ width of the pen: programs leave out strokes without any length.
const DOT: f64 = 0.02;

impl PenEnds {
    /// The drawn section of a `part` of a line within a shape whose outline has these slopes at its ends. `None` if the pen would
    /// draw more than twice the area of the part.
    pub fn drawn(&self, part: [f64; 2], slopes: [f64; 2]) -> Option<[f64; 2]> {
        let [before, after] = slopes.map(|slope| self.reach(slope));
        let drawn = [part[0] + before, part[1] - after];
        if drawn[0] < drawn[1] {
            return Some(drawn);
        }
        (2.0 * (part[1] - part[0]) > before + after).then(|| self.dot(part))
    }

    /// A dot in the middle of a part.
    pub fn dot(&self, [from, to]: [f64; 2]) -> [f64; 2] {
        let (middle, half) = (0.5 * (from + to), 0.5 * (DOT * self.pen).min(to - from));
        [middle - half, middle + half]
    }

    /// The mean distance, px, across a stroke by which strokes reach beyond the centre of the pen at their end, if each stroke ends
    /// `slope` spacings later than the previous one: its own round end, or the side of a neighbour that covers it.
    fn reach(&self, slope: f64) -> f64 {
        let (radius, step) = (0.5 * self.pen, slope.abs().min(STEEPEST) * self.spacing);
        let width = self.spacing.min(self.pen);
        let neighbours = (self.pen / self.spacing).min(100.0) as i32 + 1;
        let at = |place: usize| {
            let across = width * ((place as f64 + 0.5) / PLACES as f64 - 0.5);
            let reach = |neighbour: i32| {
                let off = across - f64::from(neighbour) * self.spacing;
                let square = radius * radius - off * off;
                (square >= 0.0).then(|| f64::from(neighbour) * step + square.sqrt())
            };
            (-neighbours..=neighbours).filter_map(reach).fold(0.0, f64::max)
        };
        (0..PLACES).map(at).sum::<f64>() / PLACES as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lone_stroke_stops_where_its_round_end_has_the_area_of_a_flat_one() {
        let ends = PenEnds { pen: 2.0, spacing: 5.0 };
        let [from, to] = ends.drawn([0.0, 10.0], [0.0, 0.0]).unwrap();
        let quarter = std::f64::consts::FRAC_PI_4;
        assert!((from - quarter).abs() < 0.01 && (to - 10.0 + quarter).abs() < 0.01, "{from} {to}");
    }

    #[test]
    fn slanting_outlines_are_covered_by_neighbours_and_strokes_stop_earlier() {
        let ends = PenEnds { pen: 0.3, spacing: 0.25 };
        assert!(ends.reach(1.0) > 1.1 * ends.reach(0.0));
        assert_eq!(ends.reach(1.0), ends.reach(-1.0));
    }

    #[test]
    fn a_pen_without_width_draws_all_of_a_part() {
        let ends = PenEnds { pen: 0.0, spacing: 0.25 };
        assert_eq!(ends.drawn([1.0, 4.0], [0.5, -3.0]), Some([1.0, 4.0]));
    }

    #[test]
    fn parts_shorter_than_half_of_the_ends_are_left_out_and_longer_ones_are_dots() {
        let ends = PenEnds { pen: 1.0, spacing: 1.0 };
        assert_eq!(ends.drawn([0.0, 0.3], [0.0, 0.0]), None);
        let [from, to] = ends.drawn([0.0, 0.6], [0.0, 0.0]).unwrap();
        assert!((from + to - 0.6).abs() < 1e-9 && to - from < 0.05, "{from} {to}");
    }
}
