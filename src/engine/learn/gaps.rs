//! Answers about lines, converted to the stripes that are the gaps between them.

use super::note::Quantity;
use super::stripe_regression::DUTY_LIMITS;
use super::{Answer, Note};
use crate::attributes::{Attribute, Attributes};

impl Answer {
    /// This answer for the stripes between the lines: their width, duty and predictions. Parameters stay those of the lines.
    /// Spots have no gaps.
    #[must_use]
    pub fn of_gaps(mut self) -> Self {
        let (Attributes::Stripes(nearest), Attributes::Stripes(lines)) = (self.nearest, self.predicted)
        else {
            return self;
        };
        let stripes = lines.gaps();
        if let Some((_, [low, high])) = self.interval.iter_mut().find(|(of, _)| *of == Attribute::Width) {
            // With an equal period, gaps are narrower by as much as lines are wider.
            [*low, *high] = [*high, *low].map(|end| (stripes.width + lines.width - end).max(0.0));
        }
        let notes = of_gaps(self.notes);
        let [nearest, predicted] = [nearest.gaps(), stripes].map(Attributes::Stripes);
        Self { nearest, predicted, notes, ..self }
    }
}

/// Notes about lines, converted to the stripes between them.
#[must_use]
pub fn of_gaps(notes: Vec<Note>) -> Vec<Note> {
    notes.into_iter().map(note_of_gaps).collect()
}

fn note_of_gaps(note: Note) -> Note {
    match note {
        Note::Beyond { asked, reached, called } => {
            let [least, most] = DUTY_LIMITS;
            let called = match called {
                called if called == least => most,
                called if called == most => least,
                called => called,
            };
            let one = |quantity: Quantity| match quantity.attribute {
                Attribute::Duty => Quantity { value: 1.0 - quantity.value, ..quantity },
                Attribute::Width => Quantity { attribute: Attribute::Gap, ..quantity },
                _ => quantity,
            };
            Note::Beyond { asked: one(asked), reached: one(reached), called }
        }
        Note::Together { asked, reached } => {
            Note::Together { asked: together(asked), reached: together(reached) }
        }
        other => other,
    }
}

/// Width and duty of the gaps from those of the lines.
fn together(lines: Vec<Quantity>) -> Vec<Quantity> {
    let duty =
        lines.iter().find(|quantity| quantity.attribute == Attribute::Duty).map_or(0.5, |duty| duty.value);
    let one = |quantity: Quantity| match quantity.attribute {
        Attribute::Duty => Quantity { value: 1.0 - duty, ..quantity },
        Attribute::Width => Quantity { value: quantity.value * (1.0 - duty) / duty, ..quantity },
        _ => quantity,
    };
    lines.into_iter().map(one).collect()
}

#[cfg(test)]
mod tests {
    use crate::attributes::{Attribute, Attributes, Polarity, Stripes};
    use crate::learn::laws::{EXACT, LINES, lines};
    use crate::learn::{Answer, Coverage, InCells, TrainingSet};

    /// The answer about stripes 10 wide at this duty, whose gaps are the lines.
    fn asked(duty: f64) -> (Stripes, Answer) {
        let set = TrainingSet::from_rows(&LINES, lines(400, EXACT)).unwrap();
        let stripes = Stripes { width: 10.0, angle: 30.0, wavelength: Some(10.0 / duty) };
        let lines = Polarity::Negative.lines(&Attributes::Stripes(stripes));
        (stripes, set.ask(&InCells(lines)).unwrap().predict(&set).0.of_gaps())
    }

    fn stripes(attributes: Attributes) -> Stripes {
        match attributes {
            Attributes::Stripes(stripes) => stripes,
            Attributes::Spots(spots) => panic!("{spots:?}"),
        }
    }

    #[test]
    fn an_answer_about_lines_predicts_the_stripes_between_them() {
        let (wanted, answer) = asked(0.65);
        assert_eq!(answer.coverage, Coverage::Inside, "{:?}", answer.notes);
        let (predicted, nearest) = (stripes(answer.predicted), stripes(answer.nearest));
        assert!((predicted.width / wanted.width - 1.0).abs() < 0.02, "{predicted:?}");
        assert!((predicted.duty() - 0.65).abs() < 0.01, "{predicted:?}");
        assert!((nearest.width - wanted.width).abs() < 1e-9, "{nearest:?}");
        let (_, [low, high]) = answer.interval.iter().find(|(of, _)| *of == Attribute::Width).unwrap();
        assert!(*low <= predicted.width && predicted.width <= *high && *low > 9.0, "{low} {high}");
    }

    #[test]
    fn a_note_on_a_duty_that_is_not_reached_is_about_the_stripes() {
        let (_, answer) = asked(0.95);
        assert_eq!(answer.coverage, Coverage::Outside);
        let note =
            answer.notes.iter().map(ToString::to_string).find(|note| note.starts_with("duty")).unwrap();
        assert!(
            note.starts_with(
                "duty 0.95 is a larger share of the period than stripes can cover, which is at most 0."
            ),
            "{note}"
        );
        let (_, answer) = asked(0.45);
        assert_eq!(
            answer.coverage,
            Coverage::Inside,
            "half of the period at the same width: {:?}",
            answer.notes
        );
    }
}
