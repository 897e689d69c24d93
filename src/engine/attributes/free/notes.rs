//! What of the strokes cannot be as it was drawn, and where.

use std::fmt;

use crate::attributes::periods::{PeriodRules, Piece, Wanted};
use crate::attributes::{Polarity, Stripes};
use crate::marks::{Path, turn};

/// Notes that are told one by one.
const MOST: usize = 4;

/// Strokes that cross at a smaller angle than this agree, degrees.
const AGREES: f64 = 20.0;

/// A stroke departs from the field if at least this share of it does.
const DEPARTING: f64 = 0.2;

/// A duty this near to one half grows in either polarity.
const NEAR_HALF: f64 = 0.08;

/// Something that cannot be as it was drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Note {
    /// Two strokes, or one with itself, cross: one place has one direction.
    Crossing {
        /// The marks, in the order in which they were drawn; equal where one crosses itself.
        marks: [usize; 2],
        /// Where they cross, px.
        place: [f64; 2],
        /// Angle between the two there, degrees in 0..90.
        angle: f64,
    },
    /// The direction of the field departs from a stroke, because strokes near it want others.
    Departure {
        /// The mark.
        mark: usize,
        /// Where it departs most, px.
        place: [f64; 2],
        /// By how much there, degrees in 0..90.
        angle: f64,
        /// Share of the stroke's length along which it departs by 20° and more, 0..1.
        share: f64,
    },
    /// Strokes side by side are nearer or farther than stripes of their width can be: the width is kept.
    Period {
        /// The marks, the smaller index first; equal where one runs beside itself.
        marks: [usize; 2],
        /// The place at which it is surest that they run side by side, px.
        place: [f64; 2],
        /// Mean distance drawn, px.
        drawn: f64,
        /// Mean period taken, px.
        taken: f64,
    },
    /// A stroke asks for stripes that cover less than half of their period, and the layer for more in the mean, or the other
    /// way round: a layer grows one of the two.
    Duty {
        /// The mark.
        mark: usize,
        /// Halfway along it, px.
        place: [f64; 2],
        /// Width ÷ period of the stroke.
        drawn: f64,
        /// Its mean over the canvas.
        mean: f64,
    },
}

impl fmt::Display for Note {
    /// What cannot be as drawn, where, and what to do; lengths in px.
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let [x, y] = self.place();
        write!(f, "at [{x:.0}, {y:.0}] {}", self.in_words(&|px| format!("{px:.0} px")))
    }
}

impl Note {
    /// Where it is, px.
    #[must_use]
    pub fn place(&self) -> [f64; 2] {
        match self {
            Self::Crossing { place, .. }
            | Self::Departure { place, .. }
            | Self::Period { place, .. }
            | Self::Duty { place, .. } => *place,
        }
    }

    /// What cannot be as drawn, and what to do, without the place and without a full stop; `length` writes a length, px.
    #[must_use]
    pub fn in_words(&self, length: &dyn Fn(f64) -> String) -> String {
        match self {
            Self::Crossing { angle, .. } => format!(
                "lines cross at {angle:.0}°: stripes have one direction at each place; use two layers"
            ),
            Self::Departure { angle, .. } => format!(
                "the stripes turn away from the drawn line by {angle:.0}°: lines near it have other directions; leave more \
                 room between them, or use two layers"
            ),
            Self::Period { drawn, taken, .. } => {
                let (limit, remedy) = if drawn < taken {
                    ("at least", "farther apart, or thinner")
                } else {
                    ("at most", "nearer together, or wider")
                };
                format!(
                    "lines are {} apart, and stripes of their width can be {limit} {} apart: draw them {remedy}",
                    length(*drawn),
                    length(*taken)
                )
            }
            Self::Duty { drawn, mean, .. } => format!(
                "this line asks for stripes that cover {:.0} % of the area, and those of its layer cover {:.0} %: a layer \
                 grows stripes that cover either less than half or more than half; draw it on a layer of its own",
                100.0 * drawn,
                100.0 * mean
            ),
        }
    }
}

/// The notes as sentences without a full stop, at most [`MOST`] of them; the others are counted. Crossings are left out: they are
/// told without a map.
pub(super) fn sentences(notes: &[Note]) -> Vec<String> {
    let notes: Vec<&Note> = notes.iter().filter(|note| !matches!(note, Note::Crossing { .. })).collect();
    let mut sentences: Vec<String> = notes.iter().take(MOST).map(ToString::to_string).collect();
    let more = notes.len().saturating_sub(MOST);
    if more > 0 {
        sentences.push(format!("{more} more places are like these"));
    }
    sentences
}

impl Note {
    /// This note with its place replaced by `to` of it.
    pub(super) fn moved(self, to: impl Fn([f64; 2]) -> [f64; 2]) -> Self {
        match self {
            Self::Crossing { marks, place, angle } => Self::Crossing { marks, place: to(place), angle },
            Self::Departure { mark, place, angle, share } => {
                Self::Departure { mark, place: to(place), angle, share }
            }
            Self::Period { marks, place, drawn, taken } => {
                Self::Period { marks, place: to(place), drawn, taken }
            }
            Self::Duty { mark, place, drawn, mean } => Self::Duty { mark, place: to(place), drawn, mean },
        }
    }

    /// Whether it is about a period.
    pub(super) fn is_of_period(&self) -> bool {
        matches!(self, Self::Period { .. } | Self::Duty { .. })
    }
}

/// The strokes with these attributes of their own that ask for another polarity than the `mean` duty has.
pub(super) fn excluded(strokes: &[Path], own: &[Stripes], mean: f64) -> impl Iterator<Item = Note> {
    let polarity = Polarity::of_duty(mean);
    let note = move |(mark, (stroke, own)): (usize, (&Path, &Stripes))| {
        let drawn = own.duty();
        let clearly = (drawn - 0.5).abs() > NEAR_HALF && polarity.excludes(drawn);
        clearly.then(|| Note::Duty { mark, place: stroke.center(), drawn, mean })
    };
    strokes.iter().zip(own).enumerate().filter_map(note)
}

/// All notes on a sketch: crossings, departures from the directions of the field (degrees at a point, px), periods, each by
/// marks.
pub(super) fn notes(
    strokes: &[Path],
    pieces: &[Piece],
    (wanted, rules): (&[Wanted], &PeriodRules),
    field: &dyn Fn([f64; 2]) -> f64,
) -> Vec<Note> {
    let mut notes = crossings(strokes, pieces);
    notes.extend((0..strokes.len()).filter_map(|stroke| departure(stroke, pieces, field)));
    notes.extend(periods(strokes.len(), wanted, rules));
    notes
}

/// The crossings at which directions disagree.
fn crossings(strokes: &[Path], pieces: &[Piece]) -> Vec<Note> {
    let mut found = Vec::new();
    for (a, stroke) in strokes.iter().enumerate() {
        let mut note = |marks, place| {
            let angle = angle_at(pieces, marks, place);
            if angle >= AGREES {
                found.push(Note::Crossing { marks, place, angle });
            }
        };
        stroke.crossings().into_iter().for_each(|place| note([a; 2], place));
        for (b, other) in strokes.iter().enumerate().skip(a + 1) {
            stroke.crossings_with(other).into_iter().for_each(|place| note([a, b], place));
        }
    }
    found
}

/// Angle between the pieces nearest to a crossing, degrees; of one stroke, the largest between pieces about it.
fn angle_at(pieces: &[Piece], marks: [usize; 2], place: [f64; 2]) -> f64 {
    let distance = |piece: &Piece| {
        let [x, y] = [piece.middle[0] - place[0], piece.middle[1] - place[1]];
        (x * x + y * y).sqrt()
    };
    let of = |mark: usize| pieces.iter().filter(move |piece| piece.stroke == mark);
    let nearest = |mark: usize| of(mark).min_by(|a, b| distance(a).total_cmp(&distance(b)));
    let Some(first) = nearest(marks[0]) else { return 0.0 };
    let between = |other: &Piece| turn(degrees(other), degrees(first)).abs();
    if marks[0] == marks[1] {
        let about = of(marks[0]).filter(|piece| distance(piece) <= first.length());
        return about.map(between).fold(0.0, f64::max);
    }
    nearest(marks[1]).map_or(0.0, between)
}

fn degrees(piece: &Piece) -> f64 {
    0.5 * libm::atan2(piece.direction[1], piece.direction[0]).to_degrees()
}

/// Where the field departs from a stroke.
fn departure(stroke: usize, pieces: &[Piece], field: &dyn Fn([f64; 2]) -> f64) -> Option<Note> {
    let (mut most, mut departing, mut count) = ((0.0, [0.0; 2]), 0.0, 0.0);
    for piece in pieces.iter().filter(|piece| piece.stroke == stroke) {
        let angle = turn(field(piece.middle), degrees(piece)).abs();
        count += 1.0;
        departing += if angle >= AGREES { 1.0 } else { 0.0 };
        if angle > most.0 {
            most = (angle, piece.middle);
        }
    }
    let ((angle, place), share) = (most, departing / count);
    (share >= DEPARTING).then_some(Note::Departure { mark: stroke, place, angle, share })
}

/// By pair of strokes, the distances that stripes cannot have.
fn periods(strokes: usize, wanted: &[Wanted], rules: &PeriodRules) -> Vec<Note> {
    /// Sums over a pair: weight, log distance, log period taken, and the surest place.
    #[derive(Clone, Copy, Default)]
    struct Pair {
        weight: f64,
        drawn: f64,
        taken: f64,
        surest: f64,
        place: [f64; 2],
    }
    let mut pairs = vec![Pair::default(); strokes * strokes];
    for one in wanted.iter().filter(|one| (one.possible(rules) - one.log_period).abs() > 1e-9) {
        let [a, b] = one.strokes;
        let pair = &mut pairs[a.min(b) * strokes + a.max(b)];
        pair.weight += one.weight;
        pair.drawn += one.weight * one.log_period;
        pair.taken += one.weight * one.possible(rules);
        if one.weight > pair.surest {
            (pair.surest, pair.place) = (one.weight, one.middle);
        }
    }
    let note = |(index, pair): (usize, &Pair)| {
        (pair.surest > 0.5).then(|| Note::Period {
            marks: [index / strokes, index % strokes],
            place: pair.place,
            drawn: libm::exp(pair.drawn / pair.weight),
            taken: libm::exp(pair.taken / pair.weight),
        })
    };
    pairs.iter().enumerate().filter_map(note).collect()
}
