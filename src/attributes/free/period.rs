//! Strokes cut into short pieces, and the period that each piece wants: the distance to the strokes at its side.

use crate::grid::Bounds;
use crate::marks::{Path, PathSample};

/// Duty cycles (width ÷ period) that stripes can have.
pub const DUTIES: [f64; 2] = [0.18, 0.82];

/// The duty cycle of a stroke that stands alone.
const ALONE: f64 = 0.5;

/// Length of a piece, in widths.
const PIECE_WIDTHS: f64 = 1.0;

/// Fewest pieces of a stroke.
const FEWEST_PIECES: f64 = 4.0;

/// Most pieces of all strokes.
const MOST_PIECES: f64 = 2000.0;

/// Strokes side by side differ by less than about 20°: the first is sure, the second too much.
const TURNS: [f64; 2] = [16.0, 24.0];

/// Strokes side by side are less than about 6 widths apart: the first is sure, the second too far.
const DISTANCES: [f64; 2] = [5.75, 6.25];

/// Strokes side by side lie so over about half of the shorter: the first is too little, the second sure.
const OVERLAPS: [f64; 2] = [0.4, 0.6];

/// A stroke runs beside itself where the way along it is more than about 2.5 times the distance: the first is too short,
/// the second sure. Round a closed circle it is π/2.
const DETOURS: [f64; 2] = [2.0, 3.0];

/// A short straight piece of a stroke.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Piece {
    pub stroke: usize,
    /// px.
    pub middle: [f64; 2],
    /// From the middle to one of the ends, px.
    pub half: [f64; 2],
    /// Distance of the middle from the start of the stroke along it, px.
    pub along: f64,
    pub width: f64,
    /// (cos 2θ, sin 2θ) of the stroke's direction.
    pub direction: [f64; 2],
    /// Logarithm of the period wanted, px.
    pub log_period: f64,
}

impl Piece {
    pub fn length(&self) -> f64 {
        2.0 * (self.half[0] * self.half[0] + self.half[1] * self.half[1]).sqrt()
    }
}

/// All strokes in pieces.
pub(super) struct Pieces {
    pub pieces: Vec<Piece>,
}

impl Pieces {
    pub fn new(strokes: &[Path], bounds: Bounds) -> Self {
        let wanted: f64 = strokes.iter().map(|stroke| stroke.length() / (PIECE_WIDTHS * stroke.width)).sum();
        let longer = (wanted / MOST_PIECES).max(1.0);
        let cut = |(index, stroke)| cut(index, stroke, longer * PIECE_WIDTHS);
        let mut pieces: Vec<Piece> = strokes.iter().enumerate().flat_map(cut).collect();
        let found = neighbours(&pieces, &bounds);
        set_periods(&mut pieces, strokes.len(), &found);
        Self { pieces }
    }
}

/// A stroke in pieces of about this length, widths.
fn cut(index: usize, stroke: &Path, widths: f64) -> Vec<Piece> {
    let length = stroke.length();
    let count = (length / (widths * stroke.width)).round().clamp(FEWEST_PIECES, MOST_PIECES) as usize;
    let half = 0.5 * length / count as f64;
    let piece = |sample: PathSample| {
        let (s, c) = libm::sincos(sample.direction.to_radians());
        Piece {
            stroke: index,
            middle: sample.point,
            half: [half * c, half * s],
            along: sample.share * length,
            width: stroke.width,
            direction: [c * c - s * s, 2.0 * s * c],
            log_period: libm::log(stroke.width / ALONE),
        }
    };
    stroke.samples(count).into_iter().map(piece).collect()
}

/// The stroke that runs beside a piece, on one side of it.
#[derive(Clone, Copy)]
struct Neighbour {
    piece: usize,
    stroke: usize,
    /// px, across the piece.
    distance: f64,
    /// How surely it is one, 0..1.
    weight: f64,
}

/// The next strokes on both sides of each piece.
fn neighbours(pieces: &[Piece], bounds: &Bounds) -> Vec<Neighbour> {
    (0..pieces.len())
        .flat_map(|index| [-1.0, 1.0].map(|side| next_beside(pieces, bounds, index, side)))
        .flatten()
        .collect()
}

/// The nearest other stroke that a piece's normal on one side meets, if it runs side by side.
fn next_beside(pieces: &[Piece], bounds: &Bounds, index: usize, side: f64) -> Option<Neighbour> {
    let piece = &pieces[index];
    let scale = 2.0 * side / piece.length();
    let normal = [-scale * piece.half[1], scale * piece.half[0]];
    let mut next: Option<(f64, usize)> = None;
    for (other, it) in pieces.iter().enumerate() {
        if other == index {
            continue;
        }
        let way = bounds.shortest([0, 1].map(|axis| it.middle[axis] - piece.middle[axis]));
        let Some(distance) = meets(way, it.half, normal) else { continue };
        if next.is_none_or(|(nearest, _)| distance < nearest) {
            next = Some((distance, other));
        }
    }
    let (distance, other) = next?;
    let it = &pieces[other];
    let cosine = piece.direction[0] * it.direction[0] + piece.direction[1] * it.direction[1];
    let turn = 0.5 * libm::acos(cosine.clamp(-1.0, 1.0)).to_degrees();
    let widths = distance / (0.5 * (piece.width + it.width));
    let detour =
        if it.stroke == piece.stroke { (it.along - piece.along).abs() / distance } else { f64::INFINITY };
    let weight = falling(turn, TURNS) * falling(widths, DISTANCES) * (1.0 - falling(detour, DETOURS));
    (weight > 0.0).then_some(Neighbour { piece: index, stroke: it.stroke, distance, weight })
}

/// How far along the unit vector `ray` a piece is met whose middle is at `way`.
fn meets(way: [f64; 2], half: [f64; 2], ray: [f64; 2]) -> Option<f64> {
    let cross = |a: [f64; 2], b: [f64; 2]| a[0] * b[1] - a[1] * b[0];
    let parallel = cross(half, ray);
    if parallel.abs() <= 1e-12 {
        return None;
    }
    let t = -cross(way, ray) / parallel;
    if !(-1.0..1.0).contains(&t) {
        return None;
    }
    let distance = [0, 1].map(|axis| way[axis] + t * half[axis]);
    let distance = distance[0] * ray[0] + distance[1] * ray[1];
    (distance > 1e-9).then_some(distance)
}

/// 1 up to the first value, 0 from the second one on, linear between.
fn falling(value: f64, [sure, never]: [f64; 2]) -> f64 {
    ((never - value) / (never - sure)).clamp(0.0, 1.0)
}

/// Gives each piece the period that its own neighbours and those along its stroke want.
fn set_periods(pieces: &mut [Piece], strokes: usize, found: &[Neighbour]) {
    let mut lengths = vec![0.0; strokes];
    for piece in pieces.iter() {
        lengths[piece.stroke] += piece.length();
    }
    // Length of each stroke that lies beside each other one, by pair; the sides do not count twice.
    let mut beside = vec![0.0; strokes * strokes];
    for one in found {
        let piece = &pieces[one.piece];
        beside[piece.stroke * strokes + one.stroke] += one.weight * piece.length();
    }
    let overlap = |a: usize, b: usize| {
        let share = beside[a * strokes + b].max(beside[b * strokes + a]) / lengths[a].min(lengths[b]);
        1.0 - falling(share, OVERLAPS)
    };
    let mut wanted: Vec<Vec<(f64, f64, [f64; 2])>> = vec![Vec::new(); strokes];
    for one in found {
        let piece = &pieces[one.piece];
        let weight = one.weight * overlap(piece.stroke, one.stroke) * piece.length();
        wanted[piece.stroke].push((weight, libm::log(one.distance), piece.middle));
    }
    for piece in pieces.iter_mut() {
        let (mut sum, mut total, mut sure) = (0.0, 0.0, 0.0f64);
        for (weight, log, at) in &wanted[piece.stroke] {
            let middle = piece.middle;
            let square =
                (at[0] - middle[0]) * (at[0] - middle[0]) + (at[1] - middle[1]) * (at[1] - middle[1]);
            let near = 1.0 / (1.0 + square / (16.0 * piece.width * piece.width));
            sum += weight * near * near * log;
            total += weight * near * near;
            sure += weight;
        }
        if total > 0.0 {
            // Beside others over a quarter of it: that is meant.
            let meant = (4.0 * sure / lengths[piece.stroke]).min(1.0);
            let alone = libm::log(piece.width / ALONE);
            piece.log_period = meant * (sum / total) + (1.0 - meant) * alone;
        }
        let [least, most] = DUTIES.map(|duty| libm::log(piece.width / duty));
        piece.log_period = piece.log_period.clamp(most, least);
    }
}
