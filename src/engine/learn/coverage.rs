//! Whether a question lies within the range of the rows, and the nearest question that does.

use super::local::Local;
use super::note::{Note, Quantity};
use crate::attributes::Attribute;
use crate::learn::small_vector::SmallVector;

/// Whether a question lies within the range of the rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Coverage {
    /// Within the rows.
    Inside,
    /// Just beyond them: accurate to a few per cent.
    Edge,
    /// Beyond them; the answer is the one to the nearest question within.
    Outside,
}

impl std::fmt::Display for Coverage {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Inside => "inside",
            Self::Edge => "edge",
            Self::Outside => "outside",
        })
    }
}

/// Up to this much beyond a limit a question still counts as inside: ln units, 1.5 %, below the error of a measurement
/// (`facts.md`: the noise floor of a region's area is 2.4 %, and a round grown spot measures 0.99, not 1).
const SLACK: f64 = 0.015;
/// Up to this much beyond a limit a question counts as at the edge: ln units, 5 %, an acceptable error.
const MARGIN: f64 = 0.05;
/// The largest one-sidedness ([`Line::one_sided`](crate::learn::weighted_line::Line::one_sided)) of the rows around a question
/// inside. When rows are left out and predicted from the others, 97 % are below this and those above are in corners; a tenth of the
/// set's width beyond a face it is 15 to 40.
const INSIDE: f64 = 10.0;
/// The usual √(one-sidedness − 1) at the place of a row.
const OF_A_ROW: f64 = 1.5;
/// The largest one-sidedness at the edge.
const EDGE: f64 = 20.0;

/// The range of one coordinate in a set, and descriptions of its ends.
pub(super) struct Limit {
    /// The attribute.
    pub what: Attribute,
    /// The lowest and the highest coordinate in words.
    pub called: [&'static str; 2],
    /// Lowest and highest coordinate.
    pub span: [f64; 2],
    /// Coordinate → attribute.
    pub shown: fn(f64) -> f64,
}

impl Limit {
    /// The span of `coordinates`.
    pub fn new(
        what: Attribute,
        called: [&'static str; 2],
        shown: fn(f64) -> f64,
        coordinates: impl Iterator<Item = f64>,
    ) -> Self {
        let span = coordinates.fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], x| [l.min(x), h.max(x)]);
        Self { what, called, span, shown }
    }
}

/// The coverage of a question and the notes about it.
pub(super) struct Judgement {
    pub coverage: Coverage,
    pub notes: Vec<Note>,
}

impl Judgement {
    pub fn new() -> Self {
        Self { coverage: Coverage::Inside, notes: Vec::new() }
    }

    /// Lowers the coverage for a coordinate that is `beyond` its limit by this much; returns whether it did.
    pub fn beyond(&mut self, beyond: f64) -> bool {
        let coverage = match beyond {
            b if b <= SLACK => Coverage::Inside,
            b if b <= MARGIN => Coverage::Edge,
            _ => Coverage::Outside,
        };
        self.coverage = self.coverage.max(coverage);
        coverage != Coverage::Inside
    }

    /// Clamps `value` to `limit`, with a note if it was outside.
    pub fn clamp(&mut self, limit: &Limit, value: f64) -> f64 {
        let [low, high] = limit.span;
        let within = value.clamp(low, high);
        if self.beyond((value - within).abs()) {
            let [asked, reached] = [value, within].map(|x| Quantity::new(limit.what, (limit.shown)(x)));
            self.notes.push(Note::Beyond { asked, reached, called: limit.called[usize::from(value > high)] });
        }
        within
    }

    /// The answer at `at`. If the rows lie to one side of it, `at` is first moved towards the nearest row until it is
    /// inside. `called` converts a place to named quantities for notes.
    pub fn within(
        &mut self,
        local: &Local,
        at: &mut SmallVector,
        called: impl Fn(&SmallVector) -> Vec<Quantity>,
    ) -> SmallVector {
        let line = local.line(at, None);
        let one_sided = line.one_sided();
        // Most questions are inside, and need no nearest row.
        let nearest = if one_sided > INSIDE { local.nearest(at, None) } else { None };
        let Some(row) = nearest else { return local.clamped(line.value()) };
        self.coverage = self.coverage.max(if one_sided <= EDGE { Coverage::Edge } else { Coverage::Outside });
        let question = *at;
        let between = |share: f64| {
            SmallVector::new(row.at.iter().zip(question.iter()).map(|(x, q)| x + (q - x) * share))
        };
        // The distance of the question from its neighbours' mean ÷ their spread is √(one-sidedness − 1). It increases almost
        // linearly along the line, so that three steps of linear interpolation find where it reaches the limit.
        let off = |one_sided: f64| (one_sided - 1.0).max(0.0).sqrt() - (INSIDE - 1.0_f64).sqrt();
        let (mut inside, mut outside) = ((0.0, OF_A_ROW - (INSIDE - 1.0_f64).sqrt()), (1.0, off(one_sided)));
        let mut reached = None;
        for _ in 0..3 {
            let share = inside.0 - inside.1 * (outside.0 - inside.0) / (outside.1 - inside.1);
            let line = local.line(&between(share), None);
            let off = off(line.one_sided());
            if off <= 0.0 {
                inside = (share, off);
                reached = Some(line);
            } else {
                outside = (share, off);
            }
        }
        *at = between(inside.0);
        let line = reached.unwrap_or_else(|| local.line(at, None));
        self.notes.push(Note::Together { asked: called(&question), reached: called(at) });
        local.clamped(line.value())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::learn::InCells;

    const AREA: Limit = Limit {
        what: Attribute::Area,
        called: ["too small: the smallest possible is", "too large: the largest possible is"],
        span: [0.0, 2.0],
        shown: libm::exp,
    };

    #[test]
    fn beyond_a_limit_is_inside_then_edge_then_outside() {
        for (value, coverage) in [
            (1.0, Coverage::Inside),
            (2.01, Coverage::Inside),
            (2.04, Coverage::Edge),
            (2.1, Coverage::Outside),
        ] {
            let mut judgement = Judgement::new();
            assert_eq!(judgement.clamp(&AREA, value), value.min(2.0));
            assert_eq!(judgement.coverage, coverage);
            assert_eq!(judgement.notes.is_empty(), coverage == Coverage::Inside);
        }
    }

    #[test]
    fn a_note_names_the_limit_with_its_numbers() {
        let mut judgement = Judgement::new();
        judgement.clamp(&AREA, libm::log(0.5));
        judgement.clamp(&AREA, libm::log(20.0));
        let notes: Vec<String> = judgement.notes.into_iter().map(|note| InCells(note).to_string()).collect();
        assert_eq!(
            notes[0],
            "area 0.5 cells is too small: the smallest possible is 1 cells, which grows instead"
        );
        assert_eq!(
            notes[1],
            "area 20 cells is too large: the largest possible is 7.39 cells, which grows instead"
        );
    }
}
