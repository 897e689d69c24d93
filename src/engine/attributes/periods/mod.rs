//! The period that strokes want: the distance of those that lie side by side.

mod grouped;
mod pieces;

use crate::grid::Bounds;
use crate::marks::Path;

pub(in crate::attributes) use grouped::grouped_periods;
pub(in crate::attributes) use pieces::{Piece, pieces};

/// Which periods strokes can want.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PeriodRules {
    /// Duty cycles (width ÷ period) that are possible.
    pub duties: [f64; 2],
    /// The duty cycle of a stroke that stands alone.
    pub alone: f64,
    /// How many widths apart strokes side by side are at most: up to the first surely, at the second no longer.
    pub distances: [f64; 2],
}

impl PeriodRules {
    /// The rules for stripes: `facts.md` says which duties grow.
    pub const STRIPES: Self = Self { duties: [0.18, 0.82], alone: 0.5, distances: [6.0, 8.0] };

    /// Of the threads of a weave, which cover the share `alone` where they are not drawn side by side. Threads a tenth as wide
    /// as they are apart are the thinnest; more than half of the canvas no direction can cover beside another.
    #[must_use]
    pub const fn threads(alone: f64) -> Self {
        Self { duties: [0.1, 0.5], alone, distances: [10.0, 13.0] }
    }

    /// The rules for lines of pair stripes, of one direction only: they may cover more than half.
    pub const PAIR_STRIPES: Self = Self { distances: [10.0, 13.0], ..Self::STRIPES };

    /// The log period nearest to this one that strokes of this log width can have.
    pub(in crate::attributes) fn possible(&self, log_period: f64, log_width: f64) -> f64 {
        let [least, most] = self.duties;
        log_period.clamp(log_width - libm::log(most), log_width - libm::log(least))
    }
}

/// Strokes side by side differ by less than about 20°: the first is sure, the second too much.
const TURNS: [f64; 2] = [18.0, 24.0];

/// Strokes side by side lie so over about half of the shorter: the first is too little, the second sure.
const OVERLAPS: [f64; 2] = [0.3, 0.6];

/// A stroke runs beside itself where the path along it is more than about 2.5 times the distance: the first is too short, the
/// second sure. Round a closed circle it is π/2.
const DETOURS: [f64; 2] = [2.0, 3.0];

/// Share of a stroke beside others from which on its distance to them is surely meant.
const MEANT: f64 = 0.8;

/// A piece is met up to so many half lengths from its middle: on the outside of a bend pieces do not touch.
const MET: f64 = 1.2;

/// Where a period is wanted, and which: halfway between two strokes, or at one that stands alone.
#[derive(Clone, Copy, Debug)]
pub(in crate::attributes) struct Wanted {
    /// The place, px: halfway between the strokes.
    pub middle: [f64; 2],
    /// From the middle along the strokes, px.
    pub half: [f64; 2],
    /// How surely, 0..1.
    pub weight: f64,
    /// How surely the strokes lie beside each other, however far apart, 0..1; of one that stands alone, how surely it lies beside
    /// others that are too far away for their distance to be meant.
    pub beside: f64,
    /// Whether it is the distance of strokes side by side, not the period of one that stands alone.
    pub is_measured: bool,
    /// Log of the distance of the strokes, or of the period of one that stands alone, px.
    pub log_period: f64,
    /// Mean width of the strokes, px.
    pub width: f64,
    /// The strokes; equal of one that stands alone.
    pub strokes: [usize; 2],
}

/// The periods wanted by strokes that are cut in `pieces`.
pub(in crate::attributes) fn wanted_periods(
    strokes: &[Path],
    pieces: &[Piece],
    bounds: &Bounds,
    rules: &PeriodRules,
) -> Vec<Wanted> {
    let lengths: Vec<f64> = strokes.iter().map(Path::length).collect();
    let ends = Ends { lengths: &lengths, closed: strokes.iter().map(is_closed).collect() };
    let mut between = Vec::new();
    for piece in pieces {
        for side in [-1.0, 1.0] {
            beside(piece, side, pieces, (bounds, rules), &ends, &mut between);
        }
    }
    // Length of each stroke that lies beside each other one.
    let count = strokes.len();
    let mut lying = vec![0.0; count * count];
    for one in &between {
        lying[one.strokes[0] * count + one.strokes[1]] += one.beside * one.length();
    }
    let (mut accompanied, mut meant) = (vec![0.0; count], vec![0.0; count]);
    for one in &mut between {
        let [a, b] = one.strokes;
        let share = lying[a * count + b].max(lying[b * count + a]) / lengths[a].min(lengths[b]);
        let overlap = 1.0 - falling(share, OVERLAPS);
        one.weight *= overlap;
        one.beside *= overlap;
        accompanied[a] += one.beside * one.length() / (MEANT * lengths[a]);
        meant[a] += one.weight * one.length() / (MEANT * lengths[a]);
    }
    let alone = |piece: &Piece| Wanted {
        middle: piece.middle,
        half: piece.half,
        weight: (1.0 - meant[piece.stroke]).max(0.0),
        beside: (accompanied[piece.stroke].min(1.0) - meant[piece.stroke]).max(0.0),
        is_measured: false,
        log_period: libm::log(piece.width / rules.alone),
        width: piece.width,
        strokes: [piece.stroke; 2],
    };
    let alone = pieces.iter().map(alone);
    between.into_iter().chain(alone).filter(|wanted| wanted.weight > 0.0).collect()
}

impl Wanted {
    /// Length of the stroke, px.
    pub fn length(&self) -> f64 {
        2.0 * (self.half[0] * self.half[0] + self.half[1] * self.half[1]).sqrt()
    }

    /// The nearest log period that strokes of this width can have.
    pub fn possible(&self, rules: &PeriodRules) -> f64 {
        rules.possible(self.log_period, libm::log(self.width))
    }
}

/// What is known of the ends of the strokes.
struct Ends<'a> {
    lengths: &'a [f64],
    closed: Vec<bool>,
}

impl Ends<'_> {
    /// How surely a stroke is met at this distance along it, px: less and less over one width from its ends.
    fn sureness(&self, stroke: usize, along: f64, width: f64) -> f64 {
        if self.closed[stroke] {
            return 1.0;
        }
        (along.min(self.lengths[stroke] - along) / width).clamp(0.0, 1.0)
    }
}

/// Whether a path ends where it starts.
fn is_closed(path: &Path) -> bool {
    match path.points[..] {
        [first, _, .., last] => {
            let [x, y] = [first[0] - last[0], first[1] - last[1]];
            (x * x + y * y).sqrt() < 0.5 * path.width
        }
        _ => false,
    }
}

/// Adds the strokes that the normal of a piece meets on one side, as far as they run side by side with it and none is
/// between.
fn beside(
    piece: &Piece,
    side: f64,
    pieces: &[Piece],
    (bounds, rules): (&Bounds, &PeriodRules),
    ends: &Ends,
    between: &mut Vec<Wanted>,
) {
    let scale = 2.0 * side / piece.length();
    let normal = [-scale * piece.half[1], scale * piece.half[0]];
    let mut met: Vec<(f64, f64, &Piece)> = Vec::new();
    for it in pieces {
        let reach = rules.distances[1] * 0.5 * (piece.width + it.width) + 0.5 * it.length();
        let displacement = bounds.shortest([0, 1].map(|axis| it.middle[axis] - piece.middle[axis]));
        if displacement[0].abs().max(displacement[1].abs()) > reach || std::ptr::eq(it, piece) {
            continue;
        }
        if let Some((distance, t)) = meets(displacement, it.half, normal) {
            let along = it.along + 0.5 * t * it.length();
            met.push((distance, ends.sureness(it.stroke, along, it.width), it));
        }
    }
    met.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut left = 1.0;
    for (distance, sure, it) in met {
        let beside = left * sure * side_by_side(piece, it, distance);
        let width = 0.5 * (piece.width + it.width);
        let weight = beside * falling(distance / width, rules.distances);
        if weight > 0.0 {
            let middle = [0, 1].map(|axis| piece.middle[axis] + 0.5 * distance * normal[axis]);
            between.push(Wanted {
                middle: bounds.inside(middle),
                half: piece.half,
                weight,
                beside,
                is_measured: true,
                log_period: libm::log(distance),
                width,
                strokes: [piece.stroke, it.stroke],
            });
        }
        left *= 1.0 - sure;
    }
}

/// How surely two pieces at this distance (px) belong to strokes side by side, however far apart, 0..1.
fn side_by_side(a: &Piece, b: &Piece, distance: f64) -> f64 {
    let cosine = a.direction[0] * b.direction[0] + a.direction[1] * b.direction[1];
    let turn = 0.5 * libm::acos(cosine.clamp(-1.0, 1.0)).to_degrees();
    let detour = if a.stroke == b.stroke { (a.along - b.along).abs() / distance } else { f64::INFINITY };
    falling(turn, TURNS) * (1.0 - falling(detour, DETOURS))
}

/// How far along the unit vector `ray` (px), and where on it (−1..1), a piece is met whose middle is at `displacement`.
fn meets(displacement: [f64; 2], half: [f64; 2], ray: [f64; 2]) -> Option<(f64, f64)> {
    let cross = |a: [f64; 2], b: [f64; 2]| a[0] * b[1] - a[1] * b[0];
    let parallel = cross(half, ray);
    if parallel.abs() <= 1e-12 {
        return None;
    }
    let t = -cross(displacement, ray) / parallel;
    let at = [0, 1].map(|axis| displacement[axis] + t * half[axis]);
    let distance = at[0] * ray[0] + at[1] * ray[1];
    (t.abs() <= MET && distance > 1e-6).then_some((distance, t))
}

/// 1 up to the first value, 0 from the second one on, linear between.
fn falling(value: f64, [sure, never]: [f64; 2]) -> f64 {
    ((never - value) / (never - sure)).clamp(0.0, 1.0)
}
