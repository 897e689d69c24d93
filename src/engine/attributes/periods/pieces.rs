//! Strokes cut into short straight pieces.

use crate::marks::{Path, PathSample};

/// Length of a piece, in widths.
const PIECE_WIDTHS: f64 = 1.0;

/// Fewest pieces of a stroke.
const FEWEST_PIECES: f64 = 4.0;

/// About so many pieces all strokes together have at most.
const MOST_PIECES: f64 = 2000.0;

/// A short straight piece of a stroke.
#[derive(Clone, Copy, Debug)]
pub(in crate::attributes) struct Piece {
    /// Index of the stroke.
    pub stroke: usize,
    /// The point halfway along it, px.
    pub middle: [f64; 2],
    /// From the middle to the end, px.
    pub half: [f64; 2],
    /// Distance of the middle from the start of the stroke along it, px.
    pub along: f64,
    /// Width of the stroke, px.
    pub width: f64,
    /// (cos 2θ, sin 2θ) of the stroke's direction.
    pub direction: [f64; 2],
}

impl Piece {
    /// Length of the piece, px.
    pub fn length(&self) -> f64 {
        2.0 * (self.half[0] * self.half[0] + self.half[1] * self.half[1]).sqrt()
    }
}

/// All strokes in pieces, in their order.
pub(in crate::attributes) fn pieces(strokes: &[Path]) -> Vec<Piece> {
    let wanted: f64 = strokes.iter().map(|stroke| stroke.length() / (PIECE_WIDTHS * stroke.width)).sum();
    let longer = (wanted / MOST_PIECES).max(1.0);
    let cut = |(index, stroke)| cut(index, stroke, longer * PIECE_WIDTHS);
    strokes.iter().enumerate().flat_map(cut).collect()
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
        }
    };
    stroke.samples(count).into_iter().map(piece).collect()
}
