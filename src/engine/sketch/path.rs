//! A stroke as an evenly spaced path, independent of the pen's speed.

use super::hull::distance;

/// Points a diameter along the path: a circle gets some 125. Finer steps would follow the jitter of the pen
/// around small marks, coarser ones cut the tips of thin ellipses.
const FINENESS: f64 = 40.0;

/// The most steps of a path; a longer scribble has longer steps.
const MOST_STEPS: f64 = 400.0;

/// Rounds of (¼, ½, ¼) that smooth a path: a Gaussian of some 4 % of the diameter, so that a mark of 8 px
/// drawn with half a px of jitter still turns steadily.
const ROUNDS: usize = 6;

/// The heading at a point is the direction from the point this many steps before to the point as many steps after.
const REACH: usize = 2;

/// A stroke, evenly spaced.
#[derive(Clone, Debug)]
pub(super) struct Path {
    /// Points on the stroke, in equal steps along it: what marks are fitted to.
    pub(super) points: Vec<[f64; 2]>,
    /// The points, smoothed: used to tell a closed stroke from an open one.
    smooth: Vec<[f64; 2]>,
    /// Of the smooth path from its first point to each: length, px.
    length: Vec<f64>,
    /// Twice the area swept by the ray from the first point, signed, px².
    swept: Vec<f64>,
    /// How far it has turned, signed, turns of 360°.
    turned: Vec<f64>,
}

impl Path {
    /// The path of a stroke with this diameter, px; there must be one.
    pub(super) fn new(points: &[[f64; 2]], diameter: f64) -> Self {
        let points = even(&thinned(points, diameter / FINENESS), diameter / FINENESS, MOST_STEPS);
        let mut smooth = points.clone();
        for _ in 0..ROUNDS {
            smooth = smoothed(&smooth);
        }
        let mut path = Self { points, smooth, length: vec![0.0], swept: vec![0.0], turned: vec![0.0] };
        path.accumulate();
        path
    }

    /// Number of points.
    pub(super) fn len(&self) -> usize {
        self.smooth.len()
    }

    /// Length from point `i` to point `j` along the smooth path, px.
    pub(super) fn length(&self, i: usize, j: usize) -> f64 {
        self.length[j] - self.length[i]
    }

    /// Distance between the points `i` and `j` of the smooth path, px.
    pub(super) fn gap(&self, i: usize, j: usize) -> f64 {
        distance(self.smooth[i], self.smooth[j])
    }

    /// Area between the smooth path from `i` to `j` and the chord, each round counted, px².
    pub(super) fn area(&self, i: usize, j: usize) -> f64 {
        let [a, b, o] = [self.smooth[i], self.smooth[j], self.smooth[0]];
        let back = cross(minus(b, o), minus(a, o));
        (0.5 * (self.swept[j] - self.swept[i] + back)).abs()
    }

    /// The net turning of the smooth path from `i` to `j`, turns of 360°.
    pub(super) fn turns(&self, i: usize, j: usize) -> f64 {
        (self.turned[j] - self.turned[i]).abs()
    }

    fn accumulate(&mut self) {
        let (o, mut length, mut swept, mut turned) = (self.smooth[0], 0.0, 0.0, 0.0);
        let mut heading = None;
        for (i, pair) in self.smooth.windows(2).enumerate() {
            length += distance(pair[0], pair[1]);
            swept += cross(minus(pair[0], o), minus(pair[1], o));
            self.length.push(length);
            self.swept.push(swept);
            // Heading at point i + 1; near the ends, which are not smoothed, it is taken as steady.
            if let (Some(back), Some(&ahead)) = ((i + 1).checked_sub(REACH), self.smooth.get(i + 1 + REACH)) {
                let now = minus(ahead, self.smooth[back]);
                let before = heading.replace(now).unwrap_or(now);
                turned += libm::atan2(cross(before, now), dot(before, now)) / std::f64::consts::TAU;
            }
            self.turned.push(turned);
        }
    }
}

fn minus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// The points that lie at least `step` from the one kept before, and the last one: the jitter of a pen that rests or
/// moves slowly is left out.
fn thinned(points: &[[f64; 2]], step: f64) -> Vec<[f64; 2]> {
    let mut kept: Vec<[f64; 2]> = Vec::new();
    for &point in points {
        if kept.last().is_none_or(|&last| distance(last, point) >= step) {
            kept.push(point);
        }
    }
    // The end itself is always kept.
    if let Some(&end) = points.last()
        && kept.last() != Some(&end)
    {
        if kept.len() > 1 {
            kept.pop();
        }
        kept.push(end);
    }
    kept
}

/// Points in at most `most` equal steps of about `step` along the polyline, from end to end.
pub(super) fn even(points: &[[f64; 2]], step: f64, most: f64) -> Vec<[f64; 2]> {
    let total: f64 = points.windows(2).map(|pair| distance(pair[0], pair[1])).sum();
    let steps = (total / step).round().clamp(1.0, most);
    let step = total / steps;
    let mut even = vec![points[0]];
    let mut walked = 0.0;
    for pair in points.windows(2) {
        let length = distance(pair[0], pair[1]);
        // Half a step is left for the end itself.
        while even.len() as f64 * step <= walked + length && (even.len() as f64) < steps - 0.5 {
            let t = (even.len() as f64 * step - walked) / length;
            even.push([0, 1].map(|axis| pair[0][axis] + t * (pair[1][axis] - pair[0][axis])));
        }
        walked += length;
    }
    even.extend(points.last().filter(|_| points.len() > 1));
    even
}

/// Each point moved to (¼, ½, ¼) of its neighbours and itself; the ends stay.
pub(super) fn smoothed(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut smooth = points.to_vec();
    for (point, three) in smooth[1..].iter_mut().zip(points.windows(3)) {
        *point = [0, 1].map(|axis| 0.25 * (three[0][axis] + three[2][axis]) + 0.5 * three[1][axis]);
    }
    smooth
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_is_evenly_spaced_at_any_speed_of_the_pen() {
        // Slow at first, then in one leap, round a corner.
        let mut points: Vec<_> = (0..200).map(|i| [f64::from(i) * 0.05, 0.0]).collect();
        points.extend([[30.0, 0.0], [30.0, 40.0]]);
        let even = even(&thinned(&points, 1.25), 1.25, MOST_STEPS);
        assert_eq!(even.len(), 57);
        assert_eq!((even[0], even[56]), ([0.0, 0.0], [30.0, 40.0]));
        for pair in even.windows(2) {
            assert!((distance(pair[0], pair[1]) - 1.25).abs() < 1e-9, "{pair:?}");
        }
    }

    #[test]
    fn a_square_has_its_length_area_and_turning() {
        let path =
            Path::new(&[[5.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0], [0.0, 0.0], [5.0, 0.0]], 14.1);
        let end = path.len() - 1;
        // Smoothing rounds the corners off.
        assert!((38.0..40.0).contains(&path.length(0, end)));
        assert!((98.0..100.0).contains(&path.area(0, end)));
        // From halfway along a side all round; the headings of the last steps are not seen.
        assert!((path.turns(0, end) - 1.0).abs() < 0.01);
        assert!(path.gap(0, end) < 1e-12);
    }

    #[test]
    fn two_points_are_a_path() {
        let path = Path::new(&[[0.0, 0.0], [3.0, 4.0]], 5.0);
        assert!((path.length(0, path.len() - 1) - 5.0).abs() < 1e-12);
        assert_eq!(path.points.len(), 41);
    }
}
