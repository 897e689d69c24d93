//! Lines that cross → groups of one direction at each place.
//!
//! Two lines belong to different groups where they cross at 30° or more, or lie so near to each other that they have different directions
//! in one place. Of all others those that are nearest and most alike come together first, until no two groups are left that may.

use crate::grid::Bounds;
use crate::marks::{Line, Path, PathSample, turn};

/// Lines that cross at this angle or more have different directions, degrees.
pub const CROSSING: f64 = 30.0;
/// Lines whose directions differ by less, degrees, have the same: five directions are 36° apart.
pub const SAME: f64 = 20.0;
/// Points of a line that are compared.
const POINTS: usize = 12;
/// Lines nearer than this share of the canvas' diagonal all count alike.
const NEAR: f64 = 0.05;
/// Lines that do not cross have different directions in one place where they are nearer than so many widths and differ there by more
/// than so many degrees: neighbouring rays of a star of eight do not.
const BESIDE: (f64, f64) = (3.0, 50.0);

/// The indices of the lines of each group, in the order of the first line of each.
#[must_use]
pub fn direction_groups(lines: &[Path], bounds: &Bounds) -> Vec<Vec<usize>> {
    let samples: Vec<Vec<PathSample>> = lines.iter().map(|line| line.samples(POINTS)).collect();
    let mut group_of: Vec<usize> = (0..lines.len()).collect();
    let mut apart = vec![false; lines.len() * lines.len()];
    let mut pairs = Vec::new();
    for b in 0..lines.len() {
        for a in 0..b {
            match likeness(&lines[a], &lines[b], [&samples[a], &samples[b]], bounds) {
                Some(likeness) => pairs.push((likeness, a, b)),
                None => {
                    apart[a * lines.len() + b] = true;
                    apart[b * lines.len() + a] = true;
                }
            }
        }
    }
    pairs.sort_by(|one, other| other.0.total_cmp(&one.0).then((one.1, one.2).cmp(&(other.1, other.2))));
    let count = lines.len();
    for (_, a, b) in pairs {
        let (one, other) = (group_of[a], group_of[b]);
        if one == other || apart[one * count + other] {
            continue;
        }
        group_of.iter_mut().filter(|group| **group == other).for_each(|group| *group = one);
        // A line that may not be with one part of a group may not be with the whole group.
        for line in 0..count {
            let both = apart[one * count + line] || apart[other * count + line];
            apart[one * count + line] = both;
            apart[line * count + one] = both;
        }
    }
    let members = |group: usize| (0..lines.len()).filter(|line| group_of[*line] == group).collect();
    let mut groups: Vec<Vec<usize>> =
        (0..lines.len()).map(members).filter(|group: &Vec<_>| !group.is_empty()).collect();
    groups.sort();
    groups
}

/// The indices of the lines of each direction, wherever they lie, in the order of their directions. Two lines have the same direction
/// where no two neighbours between them differ by 20° or more.
#[must_use]
pub fn directions_of(lines: &[Path]) -> Vec<Vec<usize>> {
    let mut order: Vec<(f64, usize)> =
        lines.iter().enumerate().map(|(index, line)| (line.at(0.5).direction, index)).collect();
    order.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let mut groups: Vec<Vec<usize>> = Vec::new();
    let mut before = f64::NEG_INFINITY;
    for (angle, index) in &order {
        match groups.last_mut().filter(|_| angle - before < SAME) {
            Some(group) => group.push(*index),
            None => groups.push(vec![*index]),
        }
        before = *angle;
    }
    // 179° and 1° are neighbours.
    let across = order.first().zip(order.last()).is_some_and(|(first, last)| first.0 + 180.0 - last.0 < SAME);
    if across && groups.len() > 1 {
        let last = groups.pop().unwrap_or_default();
        groups[0].extend(last);
    }
    groups.iter_mut().for_each(|group| group.sort_unstable());
    groups
}

/// How alike two lines are: cos of twice the angle between them where they are nearest, less the farther apart they are; `None` where
/// they have different directions in one place.
fn likeness(a: &Path, b: &Path, samples: [&[PathSample]; 2], bounds: &Bounds) -> Option<f64> {
    if crossing_angle(a, b) >= CROSSING {
        return None;
    }
    let [width, height] = bounds.size;
    let near = NEAR * (width * width + height * height).sqrt();
    let (distance, turn) = nearest(samples[0], samples[1], bounds);
    if distance < BESIDE.0 * 0.5 * (a.width + b.width) && turn.abs() > BESIDE.1 {
        return None;
    }
    // From 2 for parallel lines at one place to 0.
    Some((1.0 + libm::cos(2.0 * turn.to_radians())) * near * near / (distance * distance + near * near))
}

/// The largest angle at which two lines cross, degrees; 0 where they do not.
#[must_use]
pub fn crossing_angle(a: &Path, b: &Path) -> f64 {
    let mut largest: f64 = 0.0;
    for first in a.segments() {
        for second in b.segments().filter(|second| meet(&first, second)) {
            largest = largest.max(turn(first.angle(), second.angle()).abs());
        }
    }
    largest
}

/// Whether each of two straight lines has its ends on both sides of the other.
fn meet(a: &Line, b: &Line) -> bool {
    let side = |line: &Line, point: [f64; 2]| {
        let along = [line.to[0] - line.from[0], line.to[1] - line.from[1]];
        along[0] * (point[1] - line.from[1]) - along[1] * (point[0] - line.from[0])
    };
    side(a, b.from) * side(a, b.to) < 0.0 && side(b, a.from) * side(b, a.to) < 0.0
}

/// The distance (px) of two lines, and how far their directions differ there, degrees.
fn nearest(a: &[PathSample], b: &[PathSample], bounds: &Bounds) -> (f64, f64) {
    let mut least = (f64::INFINITY, 0.0);
    for one in a {
        for other in b {
            let [x, y] = bounds.shortest([0, 1].map(|axis| other.point[axis] - one.point[axis]));
            let distance = (x * x + y * y).sqrt();
            if distance < least.0 {
                least = (distance, turn(one.direction, other.direction));
            }
        }
    }
    least
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;
    use std::f64::consts::TAU;

    const CANVAS: Bounds = Bounds { size: [400.0, 300.0], edges: Edges::Closed };

    fn line(from: [f64; 2], to: [f64; 2]) -> Path {
        Path { points: vec![from, to], width: 6.0 }
    }

    /// A line through the middle with this direction, degrees.
    fn turned(angle: f64) -> Path {
        let (s, c) = angle.to_radians().sin_cos();
        line([200.0 - 50.0 * c, 150.0 - 50.0 * s], [200.0 + 50.0 * c, 150.0 + 50.0 * s])
    }

    #[test]
    fn directions_are_the_same_across_180_degrees_and_along_a_row_of_small_turns() {
        let lines = [178.0, 90.0, 3.0, 98.0, -6.0].map(turned);
        assert_eq!(directions_of(&lines), [vec![0, 2, 4], vec![1, 3]]);
        let row = [10.0, 28.0, 46.0, 80.0].map(turned);
        assert_eq!(directions_of(&row), [vec![0, 1, 2], vec![3]]);
        let both_ways = [turned(30.0), turned(210.0)];
        assert_eq!(directions_of(&both_ways), [vec![0, 1]]);
    }

    #[test]
    fn a_grid_of_lines_has_two_directions_and_wavy_ones_too() {
        let wave = |y: f64| {
            let points =
                (0..=40).map(|i| f64::from(i) * 10.0).map(|x| [x, y + 25.0 * (TAU * x / 400.0).sin()]);
            Path { points: points.collect(), width: 6.0 }
        };
        let lines = [
            wave(80.0),
            line([100.0, 10.0], [110.0, 290.0]),
            wave(120.0),
            line([200.0, 20.0], [190.0, 280.0]),
            wave(200.0),
        ];
        assert_eq!(direction_groups(&lines, &CANVAS), [vec![0, 2, 4], vec![1, 3]]);
    }

    #[test]
    fn three_directions_are_told_apart_and_parallel_lines_have_one() {
        let star: Vec<Path> = [0.0f64, 60.0, 120.0]
            .iter()
            .flat_map(|angle| {
                let (s, c) = angle.to_radians().sin_cos();
                [-40.0, 40.0].map(|off| {
                    let at = |along: f64| [200.0 + along * c - off * s, 150.0 + along * s + off * c];
                    line(at(-120.0), at(120.0))
                })
            })
            .collect();
        assert_eq!(direction_groups(&star, &CANVAS), [vec![0, 1], vec![2, 3], vec![4, 5]]);
        let parallel: Vec<Path> =
            (0..6).map(|i| 40.0 * f64::from(i)).map(|y| line([20.0, y], [380.0, y + 30.0])).collect();
        assert_eq!(direction_groups(&parallel, &CANVAS).len(), 1);
    }

    #[test]
    fn rays_and_the_rings_that_they_cross_are_two_directions_though_each_turns_all_round() {
        let at = |radius: f64, angle: f64| [200.0 + radius * angle.cos(), 150.0 + radius * angle.sin()];
        let rays =
            (0..16).map(|i| TAU * f64::from(i) / 16.0).map(|angle| line(at(30.0, angle), at(140.0, angle)));
        let ring = |radius: f64| {
            let points = (0..=60).map(|i| at(radius, TAU * f64::from(i) / 60.0)).collect();
            Path { points, width: 6.0 }
        };
        let lines: Vec<Path> = rays.chain([50.0, 90.0, 125.0].map(ring)).collect();
        let groups = direction_groups(&lines, &CANVAS);
        assert_eq!(groups, [(0..16).collect(), vec![16, 17, 18]]);
    }
}
