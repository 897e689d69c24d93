//! What free lines and paths want anywhere on the canvas.

use super::kernel::for_images;
use super::nodes::{Nodes, layout_with};
use super::notes::{Note, excluded, notes};
use crate::attributes::periods::{PeriodRules, Piece, Wanted, pieces, wanted_periods};
use crate::attributes::regions::RegionGrid;
use crate::attributes::{Stripes, axial_mean};
use crate::grid::{Bounds, Edges};
use crate::marks::{Path, axial};

/// Softening of the distance to a stroke, in its widths.
const SOFT_WIDTHS: f64 = 1.0;

/// Softening of the distance to the middle between two strokes, in their widths.
const SOFT_PERIOD: f64 = 0.5;

/// Least softening, share of the root of the canvas' area.
const SOFT_SHARE: f64 = 0.012;

/// Nodes for planning along the longer side.
const PLANNED_NODES: usize = 48;

/// Nodes along the longer side: of directions and widths, and of periods.
const NODES: [usize; 2] = [96, 48];

/// Cosine of twice the angle between pieces that count as one straight piece: 0.04°.
const STRAIGHT: f64 = 1.0 - 1e-6;

/// Attributes of strokes at nodes over the canvas.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct StrokeMap {
    /// Log width, mean double-angle vector (its length 0..1 is the coherence).
    values: Nodes<3>,
    /// Log period.
    periods: Nodes<1>,
    /// Width ÷ period, where it is given.
    duty: Option<f64>,
    rules: PeriodRules,
    own: Vec<Stripes>,
    pub mean: Stripes,
    pub notes: Vec<Note>,
}

impl StrokeMap {
    /// The map of at least one stroke.
    pub fn new(strokes: &[Path], canvas: &RegionGrid, rules: PeriodRules) -> Option<Self> {
        let measured = Stripes::measure(strokes)?;
        let bounds = canvas.bounds();
        let pieces = pieces(strokes);
        let wanted = wanted_periods(strokes, &pieces, &bounds, &rules);
        let sources = Sources::new(&pieces, &wanted, bounds, &rules);
        let is_line = strokes.len() == 1 && strokes[0].points.len() == 2;
        let layout = |most| layout_with(canvas, if is_line { 1 } else { most });
        let values = Nodes::sampled(layout(NODES[0]), |point| sources.mean_of(&sources.strokes, point));
        let periods = Nodes::sampled(layout(NODES[1]), |point| sources.mean_of(&sources.periods, point));
        let (own, notes_of) = (Vec::new(), Vec::new());
        let mut map = Self { values, periods, duty: None, rules, own, mean: measured, notes: notes_of };
        map.own = (0..strokes.len()).map(|stroke| map.own_of(&pieces, stroke)).collect();
        let (mut sum, mut total) = (0.0, 0.0);
        for (stroke, own) in strokes.iter().zip(&map.own) {
            sum += stroke.length() * own.wavelength.map_or(0.0, libm::log);
            total += stroke.length();
        }
        map.mean.wavelength = Some(libm::exp(sum / total));
        let mut notes = notes(strokes, &pieces, (&wanted, &rules), &|point| map.at(point).angle);
        notes.extend(excluded(strokes, &map.own, map.mean_duty()));
        map.notes = notes;
        Some(map)
    }

    /// A grid of nodes that resolves widths and periods; directions vary faster.
    pub fn nodes(&self) -> RegionGrid {
        let canvas = self.values.layout;
        let finest = canvas.grid[0].max(canvas.grid[1]);
        layout_with(&canvas, PLANNED_NODES.min(finest))
    }

    /// Width ÷ period, its mean over the canvas.
    fn mean_duty(&self) -> f64 {
        let nodes = self.nodes();
        let duties = (0..nodes.len()).map(|index| self.at(nodes.center(nodes.place(index))).duty());
        duties.sum::<f64>() / nodes.len() as f64
    }

    pub fn at(&self, point: [f64; 2]) -> Stripes {
        let [width, c, s] = self.values.at(point);
        Stripes {
            width: libm::exp(width),
            angle: axial(0.5 * libm::atan2(s, c).to_degrees()),
            wavelength: Some(libm::exp(self.log_period(point, width))),
        }
    }

    fn log_period(&self, point: [f64; 2], log_width: f64) -> f64 {
        match self.duty {
            Some(duty) => log_width - libm::log(duty),
            None => self.rules.possible(self.periods.at(point)[0], log_width),
        }
    }

    /// The mean double-angle vector at a point.
    pub fn direction_at(&self, point: [f64; 2]) -> [f64; 2] {
        let [_, c, s] = self.values.at(point);
        [c, s]
    }

    pub fn own(&self, mark: usize) -> Stripes {
        self.own[mark]
    }

    pub fn resized(&self, size: [f64; 2]) -> Self {
        let place =
            |place: [f64; 2]| [0, 1].map(|axis| place[axis] * size[axis] / self.values.layout.size[axis]);
        let notes = self.notes.iter().map(|note| note.moved(place)).collect();
        let (values, periods) = (self.values.resized(size), self.periods.resized(size));
        Self { values, periods, notes, ..self.clone() }
    }

    /// Sets the ratio width ÷ period everywhere.
    pub fn set_duty(&mut self, duty: f64) {
        self.duty = Some(duty);
        for stripes in self.own.iter_mut().chain([&mut self.mean]) {
            stripes.wavelength = Some(stripes.width / duty);
        }
        self.notes.retain(|note| !note.is_of_period());
    }

    /// The attributes of one stroke, with the mean of the period along it.
    fn own_of(&self, pieces: &[Piece], stroke: usize) -> Stripes {
        let of_it = || pieces.iter().filter(|piece| piece.stroke == stroke);
        let direction = |piece: &Piece| {
            (0.5 * libm::atan2(piece.direction[1], piece.direction[0]).to_degrees(), piece.length())
        };
        let (mut sum, mut total) = (0.0, 0.0);
        for piece in of_it() {
            sum += self.log_period(piece.middle, libm::log(piece.width));
            total += 1.0;
        }
        Stripes {
            width: of_it().map(|piece| piece.width).fold(0.0, f64::max),
            angle: axial_mean(of_it().map(direction)).map_or(0.0, |(angle, _)| angle),
            wavelength: Some(libm::exp(sum / total)),
        }
    }
}

/// A straight segment with values that counts with the weight ∫ ds ÷ (d² + softening²)^(3/2).
///
/// A stroke in the middle of which a point lies has by far the most weight, so that the map agrees with every stroke
/// along it; all means stay within the range of the values.
struct Source<const N: usize> {
    middle: [f64; 2],
    half: [f64; 2],
    half_length: f64,
    softening_squared: f64,
    weight: f64,
    values: [f64; N],
}

impl<const N: usize> Source<N> {
    fn new(middle: [f64; 2], half: [f64; 2], weight: f64, softening: f64, values: [f64; N]) -> Self {
        let half_length = (half[0] * half[0] + half[1] * half[1]).sqrt();
        Self { middle, half, half_length, softening_squared: softening * softening, weight, values }
    }

    /// Its weight at a point at `displacement` from its middle.
    fn weight_at(&self, displacement: [f64; 2]) -> f64 {
        let along = (displacement[0] * self.half[0] + displacement[1] * self.half[1]) / self.half_length;
        let across = (displacement[0] * self.half[1] - displacement[1] * self.half[0]) / self.half_length;
        let square = across * across + self.softening_squared;
        let end = |at: f64| at / (at * at + square).sqrt();
        self.weight * (end(along + self.half_length) - end(along - self.half_length)) / square
    }
}

/// All that the values at a point are means of.
struct Sources {
    bounds: Bounds,
    /// Images of a source on a tile count less and less up to this distance, px: none comes or goes at once.
    farthest: f64,
    /// Log width and double-angle vector.
    strokes: Vec<Source<3>>,
    /// Log period.
    periods: Vec<Source<1>>,
}

impl Sources {
    fn new(pieces: &[Piece], wanted: &[Wanted], bounds: Bounds, rules: &PeriodRules) -> Self {
        let [width, height] = bounds.size;
        let least = SOFT_SHARE * (width * height).sqrt();
        let stroke = |pieces: &[Piece]| {
            let piece = joined(pieces);
            let values = [libm::log(piece.width), piece.direction[0], piece.direction[1]];
            Source::new(piece.middle, piece.half, 1.0, least.max(SOFT_WIDTHS * piece.width), values)
        };
        let period = |wanted: &Wanted| {
            let softening = least.max(SOFT_PERIOD * wanted.width);
            Source::new(wanted.middle, wanted.half, wanted.weight, softening, [wanted.possible(rules)])
        };
        Self {
            bounds,
            farthest: (width * width + height * height).sqrt(),
            strokes: pieces.chunk_by(go_on_straight).map(stroke).collect(),
            periods: wanted.iter().map(period).collect(),
        }
    }

    /// The mean of the values at a point.
    fn mean_of<const N: usize>(&self, sources: &[Source<N>], point: [f64; 2]) -> [f64; N] {
        let mut sum = [0.0; N];
        let mut total = 0.0;
        for source in sources {
            let weight = self.weight_of(source, point);
            total += weight;
            for (sum, value) in sum.iter_mut().zip(source.values) {
                *sum += weight * value;
            }
        }
        sum.map(|sum| sum / total)
    }

    fn weight_of<const N: usize>(&self, source: &Source<N>, point: [f64; 2]) -> f64 {
        let displacement = self.bounds.shortest([0, 1].map(|axis| source.middle[axis] - point[axis]));
        if self.bounds.edges == Edges::Closed {
            return source.weight_at(displacement);
        }
        let mut sum = 0.0;
        for_images(&self.bounds, displacement, self.farthest, |displacement| {
            let near = 1.0
                - (displacement[0] * displacement[0] + displacement[1] * displacement[1])
                    / (self.farthest * self.farthest);
            sum += near * near * source.weight_at(displacement);
        });
        sum
    }
}

/// Whether the second piece goes on from the first in the same direction.
fn go_on_straight(a: &Piece, b: &Piece) -> bool {
    let cosine = a.direction[0] * b.direction[0] + a.direction[1] * b.direction[1];
    a.stroke == b.stroke && cosine > STRAIGHT
}

/// One piece for several of one length that follow each other straight.
fn joined(pieces: &[Piece]) -> Piece {
    let (first, last) = (pieces[0], pieces[pieces.len() - 1]);
    let middle = [0, 1].map(|axis| 0.5 * (first.middle[axis] + last.middle[axis]));
    Piece { middle, half: first.half.map(|half| half * pieces.len() as f64), ..first }
}
