//! How far a question lies from what was learnt, and where the nearest reachable one is.

use super::local::Local;
use super::point::Point;

/// How far a question lies from what was learnt.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Coverage {
    /// Among the rows.
    Inside,
    /// Just beyond them: good to a few per cent.
    Edge,
    /// Beyond them; the answer is that for the nearest question within.
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

/// Beyond a limit by this much is still inside: ln units, 1.5 %, what a measurement cannot tell
/// (facts: the noise floor of a region's area is 2.4 %, and a round grown spot measures 0.99, not 1).
const SLACK: f64 = 0.015;
/// Beyond a limit by this much is its edge: ln units, 5 %, the error still called good.
const MARGIN: f64 = 0.05;
/// Runs may lie this one-sided ([`Line::one_sided`](super::line::Line::one_sided)) about a question inside. Of rows left out and asked of
/// the others 97 % are below, those above stand in the corners; a tenth of the set's width beyond a face
/// reads 15 to 40.
const INSIDE: f64 = 10.0;
/// √(one-sided − 1) about a row, as a rule.
const OF_A_ROW: f64 = 1.5;
/// And this one-sided at the edge.
const EDGE: f64 = 20.0;

/// The span that one coordinate has in a set, and the words for leaving it.
pub(super) struct Limit {
    /// The attribute.
    pub what: &'static str,
    /// What its numbers are followed by in a sentence.
    pub unit: &'static str,
    /// What the set's row with the lowest and the highest coordinate is called.
    pub called: [&'static str; 2],
    /// Lowest and highest coordinate.
    pub span: [f64; 2],
    /// Coordinate → attribute.
    pub shown: fn(f64) -> f64,
}

impl Limit {
    /// The span of `coordinates`.
    pub fn of(
        what: &'static str,
        unit: &'static str,
        called: [&'static str; 2],
        shown: fn(f64) -> f64,
        coordinates: impl Iterator<Item = f64>,
    ) -> Self {
        let span = coordinates.fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], x| [l.min(x), h.max(x)]);
        Self { what, unit, called, span, shown }
    }
}

/// What has been found out about a question so far.
pub(super) struct Judgement {
    pub coverage: Coverage,
    pub notes: Vec<String>,
}

impl Judgement {
    pub fn new() -> Self {
        Self { coverage: Coverage::Inside, notes: Vec::new() }
    }

    /// Lowers the coverage for a coordinate that is `beyond` its limit by so much; whether it did.
    pub fn beyond(&mut self, beyond: f64) -> bool {
        let coverage = match beyond {
            b if b <= SLACK => Coverage::Inside,
            b if b <= MARGIN => Coverage::Edge,
            _ => Coverage::Outside,
        };
        self.coverage = self.coverage.max(coverage);
        coverage != Coverage::Inside
    }

    /// `value` within `limit`, with a note where that made a difference.
    pub fn clamp(&mut self, limit: &Limit, value: f64) -> f64 {
        let [low, high] = limit.span;
        let within = value.clamp(low, high);
        if self.beyond((value - within).abs()) {
            let (asked, reached) = ((limit.shown)(value), (limit.shown)(within));
            let [what, unit, called] = [limit.what, limit.unit, limit.called[usize::from(value > high)]];
            let side = if asked > reached { "more" } else { "less" };
            let [asked, reached] = [brief(asked), brief(reached)];
            self.notes.push(format!(
                "{what} {asked}{unit} is {side} than {reached}, the {called} this set holds; nearest {reached}"
            ));
        }
        within
    }

    /// The answer at `at`, which is moved towards its nearest row where the rows lie to one side of it, until
    /// it is inside. `called` says in words what is answered for.
    pub fn within(&mut self, local: &Local, at: &mut Point, called: impl Fn(&[f64]) -> String) -> Point {
        let line = local.line(at, None);
        let one_sided = line.one_sided();
        let Some(row) = local.nearest(at, None).filter(|_| one_sided > INSIDE) else {
            return local.clamped(line.value());
        };
        self.coverage = self.coverage.max(if one_sided <= EDGE { Coverage::Edge } else { Coverage::Outside });
        let question = *at;
        let between =
            |share: f64| Point::of(row.at.iter().zip(question.iter()).map(|(x, q)| x + (q - x) * share));
        // The distance of the question from its neighbours' mean in their spread is √(one-sided − 1), which grows
        // almost evenly along the way: three looks at where it would reach the limit if it did.
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
        self.notes.push(format!(
            "the runs of this set lie to one side of the question ({}; inside is up to {INSIDE}); answered for {}",
            brief(one_sided),
            called(at)
        ));
        local.clamped(line.value())
    }
}

/// A number in a sentence: three significant digits.
pub(super) fn brief(value: f64) -> String {
    let rounded: f64 = format!("{value:.2e}").parse().unwrap_or(value);
    if (1e-4..1e7).contains(&rounded.abs()) || rounded == 0.0 {
        rounded.to_string()
    } else {
        format!("{rounded:e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const AREA: Limit = Limit {
        what: "area",
        unit: " cells",
        called: ["smallest", "largest"],
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
    fn a_limit_is_named_with_its_numbers() {
        let mut judgement = Judgement::new();
        judgement.clamp(&AREA, libm::log(0.5));
        judgement.clamp(&AREA, libm::log(20.0));
        assert_eq!(
            judgement.notes[0],
            "area 0.5 cells is less than 1, the smallest this set holds; nearest 1"
        );
        assert_eq!(
            judgement.notes[1],
            "area 20 cells is more than 7.39, the largest this set holds; nearest 7.39"
        );
    }

    #[test]
    fn numbers_in_sentences_are_short() {
        let seen: Vec<String> = [0.0, 1.0, 0.123_456, 12_345.0, 1e300, 3e-9].map(brief).into();
        assert_eq!(seen, ["0", "1", "0.123", "12300", "1e300", "3e-9"]);
    }
}
