//! One drawn mark: what was drawn and what grew of it.

use egui::{Grid, RichText, Ui, vec2};

use super::detail::{listed, number};
use super::{error, named, sign};
use crate::app::result::Verdict;
use crate::attributes::{Attribute, Attributes};
use crate::editor::units::Ruler;
use crate::marks::turn;
use crate::synth::report::DrawnMark;

/// Above this aspect the direction of a spot is not judged.
const ROUND: f64 = 0.85;

/// Shows what became of a mark, below a `title`.
pub fn mark_result(ui: &mut Ui, ruler: Ruler, title: &str, drawn: &DrawnMark) {
    let verdict = verdict(drawn);
    ui.horizontal(|ui| {
        sign(ui, verdict);
        ui.strong(title);
        ui.weak(if drawn.there { verdict.name() } else { "did not grow" });
    });
    if let Some(reason) = drawn.reason {
        ui.label(RichText::new(format!("Not as drawn: {reason}.")).small().weak());
    }
    let differences = differences(drawn);
    if !differences.is_empty() {
        Grid::new("drawn mark").num_columns(4).min_col_width(14.0).spacing(vec2(9.0, 5.0)).show(ui, |ui| {
            for (head, help) in [
                ("", ""),
                ("asked", "What you drew"),
                ("grown", "What was measured in the grown texture"),
                ("error", "By how much they differ"),
            ] {
                ui.label(RichText::new(head).small().weak()).on_hover_text(help);
            }
            ui.end_row();
            for Difference { attribute, asked, got, off } in differences {
                let (name, help) = named(attribute);
                ui.label(name).on_hover_text(help);
                ui.label(number(ruler, attribute, asked));
                ui.label(number(ruler, attribute, got));
                ui.label(error(attribute, off));
                ui.end_row();
            }
        });
    }
    if let Some(text) = place(drawn) {
        ui.label(RichText::new(text).small().weak());
    }
}

/// How well a mark grew: not at all, or as its worst attribute.
fn verdict(drawn: &DrawnMark) -> Verdict {
    if !drawn.there || drawn.reason.is_some() {
        return Verdict::Missed;
    }
    let differences = differences(drawn);
    let each = differences.iter().filter_map(|one| Verdict::for_error(one.attribute, one.off));
    each.max().unwrap_or(Verdict::Unknown)
}

struct Difference {
    attribute: Attribute,
    asked: f64,
    got: f64,
    /// How far the mark is off, in the units of [`crate::synth::report::RegionReport::error`].
    off: f64,
}

/// What differs between a mark as it was drawn and as it grew; the direction of a round spot is left out.
fn differences(drawn: &DrawnMark) -> Vec<Difference> {
    let (Some(asked), Some(got)) = (&drawn.asked, &drawn.got) else { return Vec::new() };
    let (asked, got) = (listed(asked, true), listed(got, true));
    let is_round = asked.iter().any(|(attribute, value)| *attribute == Attribute::Aspect && *value > ROUND);
    let pairs = asked
        .into_iter()
        .zip(got)
        .filter(|((attribute, _), _)| !(is_round && *attribute == Attribute::Angle));
    let difference = |((attribute, asked), (_, got)): ((Attribute, f64), (Attribute, f64))| {
        let off = match attribute {
            Attribute::Aspect => got - asked,
            Attribute::Angle => turn(got, asked),
            _ => got / asked - 1.0,
        };
        Difference { attribute, asked, got, off }
    };
    pairs.map(difference).collect()
}

/// How far a spot is from its place, or how much of a line lies in stripes.
fn place(drawn: &DrawnMark) -> Option<String> {
    let off = drawn.off?;
    Some(if let Some(Attributes::Spots(_)) = drawn.asked {
        format!("Its centre is {:.0} % of its radius away from where you drew it.", 100.0 * off)
    } else {
        format!("{:.0} % of it lies in a stripe.", 100.0 * (1.0 - off))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::attributes::Spots;

    fn spot(area: f64, aspect: f64, angle: f64) -> Attributes {
        Attributes::Spots(Spots { area, aspect, angle, spacing: None })
    }

    fn drawn(asked: Attributes, got: Option<Attributes>) -> DrawnMark {
        DrawnMark {
            mark: 0,
            there: got.is_some(),
            off: got.map(|_| 0.1),
            asked: Some(asked),
            got,
            reason: None,
            place: [0.0; 2],
        }
    }

    #[test]
    fn a_mark_is_judged_by_its_worst_attribute() {
        let asked = spot(400.0, 0.5, 178.0);
        for (got, expected) in [
            (spot(408.0, 0.52, 1.0), Verdict::Met),
            (spot(430.0, 0.5, 178.0), Verdict::Near),
            (spot(400.0, 0.5, 150.0), Verdict::Missed),
        ] {
            assert_eq!(verdict(&drawn(asked, Some(got))), expected, "{got:?}");
        }
        assert_eq!(verdict(&drawn(asked, None)), Verdict::Missed);
        let half = DrawnMark { reason: Some("it is half grown"), ..drawn(asked, Some(asked)) };
        assert_eq!(verdict(&half), Verdict::Missed);
        let unmeasured = DrawnMark { there: true, ..drawn(asked, None) };
        assert_eq!(verdict(&unmeasured), Verdict::Unknown, "a tick needs a measurement");
        // The direction of a round spot means nothing.
        assert_eq!(verdict(&drawn(spot(400.0, 0.95, 0.0), Some(spot(400.0, 0.95, 90.0)))), Verdict::Met);
    }
}
