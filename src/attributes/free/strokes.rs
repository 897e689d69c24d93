//! What free lines want anywhere on the canvas.

use super::kernel::for_images;
use super::nodes::{Nodes, layout_with};
use super::period::{Piece, Pieces};
use crate::attributes::regions::RegionGrid;
use crate::attributes::{Stripes, axial_mean};
use crate::grid::{Bounds, Edges};
use crate::marks::{Path, axial};

/// Softening of the distance to a stroke, in its widths.
const SOFT_WIDTHS: f64 = 0.75;

/// Least softening, share of the root of the canvas' area.
const SOFT_SHARE: f64 = 0.008;

/// Nodes for planning along the longer side.
const PLANNED_NODES: usize = 48;

/// Nodes along the longer side.
const NODES: usize = 128;

/// Attributes of strokes at nodes over the canvas.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct StrokeMap {
    /// Log width, log period, mean double-angle vector (its length 0..1 is the coherence).
    values: Nodes<4>,
    own: Vec<Stripes>,
    pub mean: Stripes,
}

impl StrokeMap {
    /// The map of at least one stroke.
    pub fn new(strokes: &[Path], canvas: &RegionGrid) -> Option<Self> {
        let measured = Stripes::measure(strokes)?;
        let bounds = canvas.bounds();
        let pieces = Pieces::new(strokes, bounds);
        let softening =
            |width: f64| (SOFT_WIDTHS * width).max(SOFT_SHARE * (canvas.size[0] * canvas.size[1]).sqrt());
        let is_line = strokes.len() == 1 && strokes[0].points.len() == 2;
        let layout = layout_with(canvas, if is_line { 1 } else { NODES });
        let values = Nodes::sampled(layout, |point| mean_at(&pieces.pieces, &bounds, &softening, point));
        let own = (0..strokes.len()).map(|stroke| own(&pieces.pieces, stroke)).collect();
        let (mut period, mut length) = (0.0, 0.0);
        for piece in &pieces.pieces {
            period += piece.length() * piece.log_period;
            length += piece.length();
        }
        let mean = Stripes { wavelength: Some(libm::exp(period / length)), ..measured };
        Some(Self { values, own, mean })
    }

    /// A grid of nodes that resolves widths and periods; directions vary faster.
    pub fn nodes(&self) -> RegionGrid {
        let canvas = self.values.layout;
        let finest = canvas.grid[0].max(canvas.grid[1]);
        layout_with(&canvas, PLANNED_NODES.min(finest))
    }

    pub fn at(&self, point: [f64; 2]) -> Stripes {
        let [width, period, c, s] = self.values.at(point);
        Stripes {
            width: libm::exp(width),
            angle: axial(0.5 * libm::atan2(s, c).to_degrees()),
            wavelength: Some(libm::exp(period)),
        }
    }

    /// The mean double-angle vector at a point.
    pub fn direction_at(&self, point: [f64; 2]) -> [f64; 2] {
        let [_, _, c, s] = self.values.at(point);
        [c, s]
    }

    pub fn own(&self, mark: usize) -> Stripes {
        self.own[mark]
    }

    pub fn resized(&self, size: [f64; 2]) -> Self {
        Self { values: self.values.resized(size), ..self.clone() }
    }

    /// The same with this width ÷ period everywhere.
    pub fn set_duty(&mut self, duty: f64) {
        let log = libm::log(duty);
        self.values.change(|[width, period, ..]| *period = *width - log);
        for stripes in self.own.iter_mut().chain([&mut self.mean]) {
            stripes.wavelength = Some(stripes.width / duty);
        }
    }
}

/// Means over the pieces at a point, each with the weight ∫ ds ÷ (d² + softening²)^(3/2).
///
/// A stroke in the middle of which the point lies has by far the most weight, so that the map agrees with every stroke
/// along it; all means stay within the range of the values.
fn mean_at(pieces: &[Piece], bounds: &Bounds, softening: &impl Fn(f64) -> f64, point: [f64; 2]) -> [f64; 4] {
    let mut sum = [0.0; 4];
    let mut total = 0.0;
    for piece in pieces {
        let weight = weight_at(piece, bounds, softening(piece.width), point);
        let values = [libm::log(piece.width), piece.log_period, piece.direction[0], piece.direction[1]];
        total += weight;
        for (sum, value) in sum.iter_mut().zip(values) {
            *sum += weight * value;
        }
    }
    sum.map(|sum| sum / total)
}

fn weight_at(piece: &Piece, bounds: &Bounds, softening: f64, point: [f64; 2]) -> f64 {
    let way = bounds.shortest([0, 1].map(|axis| piece.middle[axis] - point[axis]));
    if bounds.edges == Edges::Closed {
        return weight_of(way, piece.half, softening);
    }
    // Images count less and less up to this distance: none comes or goes at once.
    let farthest = bounds.size[0] * bounds.size[0] + bounds.size[1] * bounds.size[1];
    let mut sum = 0.0;
    for_images(bounds, way, farthest.sqrt(), |way| {
        let near = 1.0 - (way[0] * way[0] + way[1] * way[1]) / farthest;
        sum += near * near * weight_of(way, piece.half, softening);
    });
    sum
}

/// ∫ ds ÷ (d² + softening²)^(3/2) along a straight piece of half length and direction `half`, the middle of which is
/// `way` from the point.
fn weight_of(way: [f64; 2], half: [f64; 2], softening: f64) -> f64 {
    let half_length = (half[0] * half[0] + half[1] * half[1]).sqrt();
    let along = (way[0] * half[0] + way[1] * half[1]) / half_length;
    let across = (way[0] * half[1] - way[1] * half[0]) / half_length;
    let square = across * across + softening * softening;
    let end = |at: f64| at / (at * at + square).sqrt();
    (end(along + half_length) - end(along - half_length)) / square
}

/// The attributes of one stroke.
fn own(pieces: &[Piece], stroke: usize) -> Stripes {
    let of_it = || pieces.iter().filter(|piece| piece.stroke == stroke);
    let length: f64 = of_it().map(Piece::length).sum();
    let period: f64 = of_it().map(|piece| piece.length() * piece.log_period).sum();
    let direction = |piece: &Piece| {
        (0.5 * libm::atan2(piece.direction[1], piece.direction[0]).to_degrees(), piece.length())
    };
    Stripes {
        width: of_it().map(|piece| piece.width).fold(0.0, f64::max),
        angle: axial_mean(of_it().map(direction)).map_or(0.0, |(angle, _)| angle),
        wavelength: Some(libm::exp(period / length)),
    }
}
