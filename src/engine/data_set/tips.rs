//! Where stripes end and fork: the ends and forks of the skeleton of the pattern.

use super::skeleton::Skeleton;
use crate::synth::pattern::{EDGE, PatternRows};

/// Samples a px along each side.
const FINER: usize = 2;
/// A line of the skeleton that is shorter than so many radii of the stripe at its fork is a bump of the edge.
const SPUR: f64 = 1.6;
/// Forks that are nearer to each other than so many radii are one.
const ONE_FORK: f64 = 1.5;
/// Directions are taken from a sample so many radii away.
const REACH: f64 = 3.0;
/// Tips nearer to the border than so many radii may be cut stripes, and are left out.
const MARGIN: f64 = 2.5;

/// The kinds of tips.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TipKind {
    /// A stripe ends.
    End,
    /// A stripe divides into two.
    Fork,
}

impl TipKind {
    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::End => "end",
            Self::Fork => "fork",
        }
    }
}

/// A place where a stripe ends or forks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tip {
    /// Which of both.
    pub kind: TipKind,
    /// Its place on the middle line of the stripe, px; of an end on its outline.
    pub at: [f64; 2],
    /// Degrees in [0, 360) from +x towards +y: the way in which the stripe ends, or in which the fork opens.
    pub angle: f64,
}

/// The ends and forks of a pattern on a canvas of `side` px, from top to bottom.
pub(super) fn tips(pattern: &dyn PatternRows, side: usize) -> Vec<Tip> {
    let fine = pattern.field(FINER * side, FINER * side);
    let mask: Vec<bool> = fine.values.iter().map(|value| *value >= EDGE).collect();
    let mut skeleton = Skeleton::new(&mask, FINER * side);
    prune(&mut skeleton);
    let on: Vec<usize> = (0..skeleton.on.len()).filter(|index| skeleton.on[*index]).collect();
    let ends = on.iter().filter(|index| skeleton.neighbours(**index).count() == 1);
    let ends = ends.filter_map(|index| end(&skeleton, *index));
    let forks = forks(&skeleton, &on).into_iter().filter_map(|index| fork(&skeleton, index));
    let mut all: Vec<Tip> = ends.chain(forks).filter(|tip| is_inside(&skeleton, tip)).collect();
    all.iter_mut().for_each(|tip| tip.at = tip.at.map(|along| along / FINER as f64));
    all.sort_by(|a, b| a.at[1].total_cmp(&b.at[1]).then(a.at[0].total_cmp(&b.at[0])));
    all
}

/// Removes lines from an end to a fork that are bumps of the edge.
fn prune(skeleton: &mut Skeleton) {
    loop {
        let ends: Vec<usize> = (0..skeleton.on.len())
            .filter(|index| skeleton.on[*index] && skeleton.neighbours(*index).count() == 1)
            .collect();
        let mut removed = false;
        for end in ends {
            let line = line_from(skeleton, end, usize::MAX);
            let Some(last) = line.last().filter(|last| skeleton.branches(**last) >= 3) else { continue };
            if (line.len() as f64) < SPUR * f64::from(skeleton.radius[*last]) {
                line[..line.len() - 1].iter().for_each(|index| skeleton.on[*index] = false);
                removed = true;
            }
        }
        if !removed {
            return;
        }
    }
}

/// The samples from one on, away from where `line_from` came, to the next fork or end, or until there are `most`.
fn line_from(skeleton: &Skeleton, start: usize, most: usize) -> Vec<usize> {
    let mut line = vec![start];
    while line.len() < most {
        let here = line[line.len() - 1];
        if line.len() > 1 && skeleton.branches(here) >= 3 {
            break;
        }
        let seen = &line[line.len().saturating_sub(4)..];
        let Some(next) = skeleton.neighbours(here).find(|next| !seen.contains(next)) else { break };
        line.push(next);
    }
    line
}

/// Degrees of the direction from one place to another.
fn direction(from: [f64; 2], to: [f64; 2]) -> f64 {
    libm::atan2(to[1] - from[1], to[0] - from[0]).to_degrees().rem_euclid(360.0)
}

/// The end of a stripe; `None` for a dot.
fn end(skeleton: &Skeleton, index: usize) -> Option<Tip> {
    let radius = f64::from(skeleton.radius[index]);
    let line = line_from(skeleton, index, (REACH * radius).ceil() as usize);
    let widest = line.iter().map(|index| skeleton.radius[*index]).fold(0.0, f32::max);
    if (line.len() as f64) < f64::from(widest) {
        return None;
    }
    let [tip, within] = [index, *line.last()?].map(|index| skeleton.place(index));
    let angle = direction(within, tip);
    let (s, c) = libm::sincos(angle.to_radians());
    Some(Tip { kind: TipKind::End, at: [tip[0] + radius * c, tip[1] + radius * s], angle })
}

/// One sample of each fork: the first of those that are close together.
fn forks(skeleton: &Skeleton, on: &[usize]) -> Vec<usize> {
    let mut forks: Vec<usize> = Vec::new();
    for index in on.iter().copied().filter(|index| skeleton.branches(*index) >= 3) {
        let at = skeleton.place(index);
        let near = ONE_FORK * f64::from(skeleton.radius[index]);
        let is_near = |other: &usize| {
            let other = skeleton.place(*other);
            libm::hypot(at[0] - other[0], at[1] - other[1]) < near
        };
        if !forks.iter().any(is_near) {
            forks.push(index);
        }
    }
    forks
}

/// A fork; the two of its three lines between which the angle is smallest are those into which it opens.
fn fork(skeleton: &Skeleton, index: usize) -> Option<Tip> {
    let at = skeleton.place(index);
    let reach = REACH * f64::from(skeleton.radius[index]);
    // Where the lines cross a ring about the fork.
    let ways = crossings(skeleton, index, reach);
    let [a, b] = closest(&ways)?;
    let turn = (b - a + 180.0).rem_euclid(360.0) - 180.0;
    Some(Tip { kind: TipKind::Fork, at, angle: (a + 0.5 * turn).rem_euclid(360.0) })
}

/// Directions, degrees, of the places at which lines from a sample are first `reach` away.
fn crossings(skeleton: &Skeleton, start: usize, reach: f64) -> Vec<f64> {
    let at = skeleton.place(start);
    let (mut seen, mut next) = (vec![start], vec![start]);
    let mut ways = Vec::new();
    while let Some(here) = next.pop() {
        let to = skeleton.place(here);
        if libm::hypot(to[0] - at[0], to[1] - at[1]) >= reach {
            ways.push(direction(at, to));
            continue;
        }
        for other in skeleton.neighbours(here).filter(|other| !seen.contains(other)).collect::<Vec<_>>() {
            seen.push(other);
            next.push(other);
        }
    }
    ways
}

/// The two directions with the smallest angle between them.
fn closest(ways: &[f64]) -> Option<[f64; 2]> {
    let pairs = ways.iter().enumerate().flat_map(|(k, a)| ways[k + 1..].iter().map(move |b| [*a, *b]));
    let between = |[a, b]: &[f64; 2]| ((b - a + 180.0).rem_euclid(360.0) - 180.0).abs();
    // Neighbouring samples of one line may both reach the ring.
    pairs.filter(|pair| between(pair) > 10.0).min_by(|a, b| between(a).total_cmp(&between(b)))
}

fn is_inside(skeleton: &Skeleton, tip: &Tip) -> bool {
    let side = (skeleton.width - 2) as f64;
    // At the tip itself the stripe has no width: the widest place nearby counts.
    let near = |[x, y]: [i32; 2]| {
        let to = [tip.at[0] + f64::from(x), tip.at[1] + f64::from(y)];
        f64::from(skeleton.radius[skeleton.at(to)])
    };
    let around = (-6..=6).flat_map(|y| (-6..=6).map(move |x| [x, y]));
    let margin = MARGIN * around.map(near).fold(0.0, f64::max);
    tip.at.iter().all(|along| (margin..side - margin).contains(along))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Edges, Field};
    use crate::synth::pattern::AreaPattern;

    /// The distance from a point to a piece of a line.
    fn apart([x, y]: [f64; 2], [a, b]: [[f64; 2]; 2]) -> f64 {
        let d = [b[0] - a[0], b[1] - a[1]];
        let t = ((x - a[0]) * d[0] + (y - a[1]) * d[1]) / (d[0] * d[0] + d[1] * d[1]);
        let t = t.clamp(0.0, 1.0);
        libm::hypot(x - a[0] - t * d[0], y - a[1] - t * d[1])
    }

    #[test]
    fn the_ends_and_the_fork_of_a_drawn_y_are_found_with_their_angles() {
        let pieces =
            [[[40.0, 64.0], [70.0, 64.0]], [[70.0, 64.0], [96.0, 46.0]], [[70.0, 64.0], [96.0, 82.0]]];
        let y = Field::from_fn([128, 128], [1.0, 1.0], Edges::Closed, |at| {
            let near = pieces.iter().map(|piece| apart(at, *piece)).fold(f64::MAX, f64::min);
            (0.5 + 0.25 * (4.0 - near)).clamp(0.0, 1.0) as f32
        });
        let found = tips(&AreaPattern::new(&y), 128);
        let expected = [
            (TipKind::End, [99.3, 43.7], 325.3),
            (TipKind::Fork, [72.0, 64.0], 0.0),
            (TipKind::End, [36.0, 64.0], 180.0),
            (TipKind::End, [99.3, 84.3], 34.7),
        ];
        assert_eq!(found.len(), 4, "{found:?}");
        for (kind, at, angle) in expected {
            let near = |tip: &&Tip| {
                let turn = (tip.angle - angle + 180.0_f64).rem_euclid(360.0) - 180.0;
                let moved = libm::hypot(tip.at[0] - at[0], tip.at[1] - at[1]);
                tip.kind == kind && moved < 2.5 && turn.abs() < 10.0
            };
            assert!(found.iter().any(|tip| near(&tip)), "{kind:?} at {at:?}: {found:?}");
        }
    }

    #[test]
    fn a_dot_and_a_stripe_across_the_canvas_have_no_tips() {
        let dot = Field::from_fn([64, 64], [1.0, 1.0], Edges::Closed, |[x, y]| {
            (0.5 + 0.25 * (7.0 - libm::hypot(x - 32.0, y - 32.0))).clamp(0.0, 1.0) as f32
        });
        let stripe = Field::from_fn([64, 64], [1.0, 1.0], Edges::Closed, |[x, y]| {
            (0.5 + 0.25 * (4.0 - (y - 20.0 - 0.3 * x).abs())).clamp(0.0, 1.0) as f32
        });
        assert_eq!(tips(&AreaPattern::new(&dot), 64), []);
        assert_eq!(tips(&AreaPattern::new(&stripe), 64), []);
    }
}
