//! A path: a drawn stripe that may bend.

use super::{Line, axial};

/// A joint that turns by less than the first angle is part of a smooth curve, one that turns by more than the second is
/// a corner, degrees; between them the two blend.
const SMOOTH_TO_CORNER: [f64; 2] = [30.0, 60.0];

/// A polyline with a width, px: two points or more.
#[derive(Clone, Debug, PartialEq)]
pub struct Path {
    /// Its points in the order in which they were drawn, px; at least two.
    pub points: Vec<[f64; 2]>,
    /// Width of the stroke, px.
    pub width: f64,
}

/// A point on a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathSample {
    /// Where it is, px.
    pub point: [f64; 2],
    /// Direction of the path there, degrees in [0, 180).
    pub direction: f64,
    /// Its distance from the start along the path ÷ the length of the path, 0..1.
    pub share: f64,
}

impl From<Line> for Path {
    fn from(line: Line) -> Self {
        Self { points: vec![line.from, line.to], width: line.width }
    }
}

impl Path {
    /// Its straight pieces that have a length, in order.
    pub fn segments(&self) -> impl Iterator<Item = Line> + '_ {
        let line = |pair: &[[f64; 2]]| Line { from: pair[0], to: pair[1], width: self.width };
        self.points.windows(2).map(line).filter(|line| line.length() > 0.0)
    }

    /// Length along the path, px.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.segments().map(|segment| segment.length()).sum()
    }

    /// The point halfway along it; the region that holds it owns the path.
    #[must_use]
    pub fn center(&self) -> [f64; 2] {
        match self.points[..] {
            [from, to] => Line { from, to, width: self.width }.center(),
            _ => self.at(0.5).point,
        }
    }

    /// The point at a share 0..1 of its length, and its direction there.
    ///
    /// A smooth curve is drawn as a polyline; its direction turns evenly along each segment, as on the circle through
    /// each three points in a row. At a corner (a turn of 60° and more) it jumps.
    ///
    /// ```
    /// use dapple_engine::marks::Path;
    ///
    /// let bent = Path { points: vec![[0.0, 0.0], [30.0, 0.0], [30.0, 10.0]], width: 4.0 };
    /// let middle = bent.at(0.5);
    /// assert_eq!(middle.point, [20.0, 0.0]);
    /// ```
    #[must_use]
    pub fn at(&self, share: f64) -> PathSample {
        self.located(&[share.clamp(0.0, 1.0)])[0]
    }

    /// The middles of `count` pieces of equal length, in order: each stands for the same share of the path.
    #[must_use]
    pub fn samples(&self, count: usize) -> Vec<PathSample> {
        let shares: Vec<f64> = (0..count).map(|k| (k as f64 + 0.5) / count as f64).collect();
        self.located(&shares)
    }

    /// The samples at these shares of the length, which ascend.
    fn located(&self, shares: &[f64]) -> Vec<PathSample> {
        let segments: Vec<Line> = self.segments().collect();
        let total: f64 = segments.iter().map(Line::length).sum();
        let bends = bends(&segments);
        let mut walked = 0.0;
        let mut index = 0;
        let mut sample = |share: f64| {
            let Some(last) = segments.len().checked_sub(1) else {
                return PathSample { point: self.points[0], direction: 0.0, share };
            };
            while index < last && walked + segments[index].length() < share * total {
                walked += segments[index].length();
                index += 1;
            }
            let segment = segments[index];
            let length = segment.length();
            let along = (share * total - walked).clamp(0.0, length);
            let [at_start, at_end] = bends[index];
            PathSample {
                point: [0, 1].map(|axis| {
                    segment.from[axis] + along / length * (segment.to[axis] - segment.from[axis])
                }),
                direction: axial(segment.angle() + at_start.at(along) + at_end.at(length - along)),
                share,
            }
        };
        shares.iter().map(|share| sample(*share)).collect()
    }

    /// The places where it crosses itself, px, in order of the segments. Joints and pieces that run along each other are
    /// no crossings.
    #[must_use]
    pub fn crossings(&self) -> Vec<[f64; 2]> {
        let segments: Vec<Line> = self.segments().collect();
        let mut found = Vec::new();
        for (i, a) in segments.iter().enumerate() {
            let later = segments.iter().skip(i + 2);
            found.extend(later.filter_map(|b| crossing(a, b)));
        }
        // The start of a closed path is also its end.
        let ends = [self.points.first(), self.points.last()];
        found.retain(|point| ends[0] != ends[1] || Some(point) != ends[0]);
        found
    }

    /// The places where it crosses another path, px, in order of its segments.
    ///
    /// ```
    /// use dapple_engine::marks::Path;
    ///
    /// let across = Path { points: vec![[0.0, 10.0], [40.0, 10.0]], width: 3.0 };
    /// let down = Path { points: vec![[15.0, 0.0], [15.0, 30.0]], width: 3.0 };
    /// assert_eq!(across.crossings_with(&down), [[15.0, 10.0]]);
    /// ```
    #[must_use]
    pub fn crossings_with(&self, other: &Self) -> Vec<[f64; 2]> {
        let others: Vec<Line> = other.segments().collect();
        self.segments()
            .flat_map(|a| others.iter().filter_map(move |b| crossing(&a, b)).collect::<Vec<_>>())
            .collect()
    }

    /// The places where it crosses another path, as distances along both from their starts, px; in order of its segments.
    #[must_use]
    pub fn crossings_along(&self, other: &Self) -> Vec<[f64; 2]> {
        let others: Vec<(f64, Line)> = other.walked().collect();
        let mut found = Vec::new();
        for (walked, a) in self.walked() {
            for (other_walked, b) in &others {
                if let Some(at) = crossing(&a, b) {
                    let from =
                        |start: [f64; 2]| ((at[0] - start[0]).powi(2) + (at[1] - start[1]).powi(2)).sqrt();
                    found.push([walked + from(a.from), other_walked + from(b.from)]);
                }
            }
        }
        found
    }

    /// Its segments, each with the length of those before it, px.
    fn walked(&self) -> impl Iterator<Item = (f64, Line)> + '_ {
        self.segments().scan(0.0, |walked, segment| {
            let before = *walked;
            *walked += segment.length();
            Some((before, segment))
        })
    }

    /// Whether the boxes around two paths overlap.
    #[must_use]
    pub fn may_touch(&self, other: &Self) -> bool {
        let ([low, high], [other_low, other_high]) = (self.bounds(), other.bounds());
        (0..2).all(|axis| low[axis] <= other_high[axis] && other_low[axis] <= high[axis])
    }

    /// The path with the fewest of its points that departs nowhere by more than `tolerance` px from it (Douglas and
    /// Peucker, "Algorithms for the reduction of the number of points required to represent a digitized line",
    /// Cartographica 1973). The ends stay.
    #[must_use]
    pub fn simplified(&self, tolerance: f64) -> Self {
        let points = &self.points;
        let mut kept = vec![false; points.len()];
        let last = points.len().saturating_sub(1);
        let mut open = vec![[0, last]];
        for end in [0, last] {
            if let Some(kept) = kept.get_mut(end) {
                *kept = true;
            }
        }
        while let Some([from, to]) = open.pop() {
            let far = (from + 1..to)
                .map(|i| (i, distance_to_segment(points[i], [points[from], points[to]])))
                .fold(None, |most: Option<(usize, f64)>, one| {
                    Some(most.filter(|most| most.1 >= one.1).unwrap_or(one))
                });
            if let Some((middle, distance)) = far
                && distance > tolerance
            {
                kept[middle] = true;
                open.extend([[from, middle], [middle, to]]);
            }
        }
        let points = points.iter().zip(kept).filter(|(_, kept)| *kept).map(|(point, _)| *point).collect();
        Self { points, width: self.width }
    }

    /// Smallest and largest x and y of its points, px; without its width.
    #[must_use]
    pub fn bounds(&self) -> [[f64; 2]; 2] {
        let along = |axis: usize| self.points.iter().map(move |point| point[axis]);
        [
            [0, 1].map(|axis| along(axis).fold(f64::INFINITY, f64::min)),
            [0, 1].map(|axis| along(axis).fold(f64::NEG_INFINITY, f64::max)),
        ]
    }

    /// The path with each point replaced.
    #[must_use]
    pub fn with_points(&self, place: impl Fn([f64; 2]) -> [f64; 2]) -> Self {
        Self { points: self.points.iter().map(|point| place(*point)).collect(), width: self.width }
    }

    /// The path moved `by` px along x and y.
    #[must_use]
    pub fn shifted(&self, by: [f64; 2]) -> Self {
        self.with_points(|point| [point[0] + by[0], point[1] + by[1]])
    }
}

/// By how much the direction of the curve differs from that of a segment at one of its ends.
#[derive(Clone, Copy, Debug, Default)]
struct Bend {
    /// Degrees at the end itself.
    turn: f64,
    /// Distance from the end within which it falls to 0, px.
    reach: f64,
}

impl Bend {
    /// Degrees, at this distance (px) from the end.
    fn at(self, distance: f64) -> f64 {
        if distance < self.reach { self.turn * (1.0 - distance / self.reach) } else { 0.0 }
    }
}

/// The bends at the start and at the end of each segment.
fn bends(segments: &[Line]) -> Vec<[Bend; 2]> {
    let heading =
        |segment: &Line| libm::atan2(segment.to[1] - segment.from[1], segment.to[0] - segment.from[0]);
    // At each joint: within the segment before it, and within the one after it. On a circle a bend reaches to the middle of
    // the segment, and the turns are as the lengths; a long straight piece is bent only as far as its short neighbour is long.
    let joint = |pair: &[Line]| {
        let [before, after] = [pair[0].length(), pair[1].length()];
        let turned = (heading(&pair[1]) - heading(&pair[0])).to_degrees();
        let turned = (turned + 180.0).rem_euclid(360.0) - 180.0;
        let [smooth, corner] = SMOOTH_TO_CORNER;
        let curved = ((corner - turned.abs()) / (corner - smooth)).clamp(0.0, 1.0) * turned;
        let reach = [(0.5 * before).min(after), (0.5 * after).min(before)];
        reach.map(|own| Bend { turn: curved * own / (reach[0] + reach[1]), reach: own })
    };
    let joints: Vec<[Bend; 2]> = segments.windows(2).map(joint).collect();
    let back = |bend: Bend| Bend { turn: -bend.turn, ..bend };
    let bend = |(i, segment): (usize, &Line)| {
        let start = i.checked_sub(1).map(|before| back(joints[before][1]));
        let end = joints.get(i).map(|joint| joint[0]);
        // Towards a free end a curve turns on, unless the segment is a long straight piece.
        let free = |bend: Bend| {
            let share = (4.0 * bend.reach / segment.length() - 1.0).clamp(0.0, 1.0);
            Bend { turn: -share * bend.turn, reach: 0.5 * segment.length() }
        };
        [start.or(end.map(free)).unwrap_or_default(), end.or(start.map(free)).unwrap_or_default()]
    };
    segments.iter().enumerate().map(bend).collect()
}

/// Where two segments cross, px. The end of each does not count, its start does, so that a crossing at a joint is one.
fn crossing(a: &Line, b: &Line) -> Option<[f64; 2]> {
    let cross = |u: [f64; 2], v: [f64; 2]| u[0] * v[1] - u[1] * v[0];
    let minus = |u: [f64; 2], v: [f64; 2]| [u[0] - v[0], u[1] - v[1]];
    let (along_a, along_b, between) = (minus(a.to, a.from), minus(b.to, b.from), minus(b.from, a.from));
    let parallel = cross(along_a, along_b);
    if parallel.abs() <= 1e-12 * a.length() * b.length() {
        return None;
    }
    let t = cross(between, along_b) / parallel;
    let u = cross(between, along_a) / parallel;
    let inside = (0.0..1.0).contains(&t) && (0.0..1.0).contains(&u);
    inside.then(|| [0, 1].map(|axis| a.from[axis] + t * along_a[axis]))
}

/// Distance of a point from a straight segment, px.
///
/// ```
/// use dapple_engine::marks::distance_to_segment;
///
/// assert_eq!(distance_to_segment([5.0, 3.0], [[0.0, 0.0], [10.0, 0.0]]), 3.0);
/// assert_eq!(distance_to_segment([13.0, 4.0], [[0.0, 0.0], [10.0, 0.0]]), 5.0);
/// ```
#[must_use]
pub fn distance_to_segment(point: [f64; 2], [from, to]: [[f64; 2]; 2]) -> f64 {
    let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    let [x, y] = [point[0] - from[0], point[1] - from[1]];
    let length = dx * dx + dy * dy;
    let t = if length > 0.0 { ((x * dx + y * dy) / length).clamp(0.0, 1.0) } else { 0.0 };
    let [x, y] = [x - t * dx, y - t * dy];
    (x * x + y * y).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::marks::turn;

    fn path(points: &[[f64; 2]]) -> Path {
        Path { points: points.to_vec(), width: 4.0 }
    }

    fn circle(steps: usize) -> Path {
        let at = |k: usize| libm::sincos(std::f64::consts::PI * k as f64 / steps as f64);
        path(&(0..=steps).map(at).map(|(s, c)| [50.0 * c, 50.0 * s]).collect::<Vec<_>>())
    }

    #[test]
    fn a_path_of_two_points_is_its_line() {
        let line = Line { from: [3.0, 4.0], to: [9.0, -4.0], width: 2.0 };
        let path = Path::from(line);
        assert_eq!((path.length(), path.center()), (10.0, line.center()));
        assert!(path.samples(7).iter().all(|sample| sample.direction == line.angle()));
    }

    #[test]
    fn the_direction_along_a_polyline_round_a_circle_is_that_of_the_circle() {
        for sample in circle(9).samples(200) {
            let wanted = 180.0 * sample.share + 90.0;
            assert!(turn(sample.direction, wanted).abs() < 1e-6, "{sample:?}");
            let radius = (sample.point[0].powi(2) + sample.point[1].powi(2)).sqrt();
            assert!((49.0..50.0 + 1e-9).contains(&radius), "{sample:?}");
        }
    }

    #[test]
    fn a_corner_keeps_the_directions_of_its_two_arms() {
        let chevron = path(&[[0.0, 0.0], [40.0, 40.0], [80.0, 0.0]]);
        for sample in chevron.samples(20) {
            let wanted = if sample.share < 0.5 { 45.0 } else { 135.0 };
            assert!((sample.direction - wanted).abs() < 1e-9, "{sample:?}");
        }
        assert_eq!(chevron.center(), [40.0, 40.0]);
    }

    #[test]
    fn a_figure_of_eight_crosses_itself_once_and_a_closed_square_nowhere() {
        let eight = path(&[[0.0, 0.0], [20.0, 20.0], [20.0, 0.0], [0.0, 20.0]]);
        assert_eq!(eight.crossings(), [[10.0, 10.0]]);
        let square = path(&[[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0], [0.0, 0.0]]);
        assert!(square.crossings().is_empty(), "{:?}", square.crossings());
    }

    #[test]
    fn two_paths_that_cross_at_a_joint_cross_once() {
        let bent = path(&[[0.0, 0.0], [10.0, 0.0], [20.0, 5.0]]);
        let across = path(&[[10.0, -10.0], [10.0, 0.0], [10.0, 10.0]]);
        assert_eq!(bent.crossings_with(&across), [[10.0, 0.0]]);
        assert!(bent.crossings_with(&bent.shifted([0.0, 3.0])).is_empty());
    }

    #[test]
    fn simplifying_keeps_the_ends_and_the_corners_and_departs_no_farther_than_allowed() {
        let fine = circle(400);
        let few = fine.simplified(0.5);
        assert!(few.points.len() < 20, "{}", few.points.len());
        assert_eq!((few.points.first(), few.points.last()), (fine.points.first(), fine.points.last()));
        for point in &fine.points {
            let near = few
                .segments()
                .map(|s| distance_to_segment(*point, [s.from, s.to]))
                .fold(f64::INFINITY, f64::min);
            assert!(near <= 0.5, "{point:?}: {near}");
        }
        let corner = path(&[[0.0, 0.0], [5.0, 0.01], [10.0, 0.0], [10.0, 10.0]]);
        assert_eq!(corner.simplified(0.1).points, [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0]]);
    }
}
