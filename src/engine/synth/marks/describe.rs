//! The output of `check` for a layer of spots or stripes.

use std::fmt::Write;

use serde_json::{Value, json};

use crate::attributes::free::FreeMap;
use crate::attributes::{Attribute, Attributes, Polarity, Spread};
use crate::learn::Answer;
use crate::synth::kind::{Described, Request, in_words};
use crate::synth::marks::plan::raggedness::asked_raggedness;
use crate::synth::marks::plan::{Lookup, Start, Surroundings};
use crate::synth::marks::planned::{MarksPlan, looked_up};
use crate::synth::marks::report::expected_note;

/// A description of a layer that would grow, and for each region that has marks what was asked for and what is expected.
pub(super) fn described(plan: &MarksPlan, request: &Request, mut notes: Vec<String>) -> Described {
    let MarksPlan { lookup, options, .. } = plan;
    let raggedness = asked_raggedness(&lookup.map, options);
    notes.extend(looked_up(request.beneath).and_then(|beneath| lookup.expected_room(beneath)));
    // For lines around marks, or between them, only the width is used.
    if lookup.curve_kind().is_none() {
        notes.extend(lookup.map.free().map(FreeMap::remarks).unwrap_or_default());
    }
    notes.extend(crowded(lookup));
    notes.extend(
        raggedness
            .map(|raggedness| format!("its edges will be roughened to a raggedness of {raggedness:.2}")),
    );
    let layout = lookup.map.layout();
    let region = |(index, answer): (usize, &Answer)| {
        let place = layout.place(index);
        let of_region = lookup.map.region(place);
        let (marks, spread) = (of_region.marks, &of_region.spread);
        let notes = answer.notes.iter().map(ToString::to_string).chain(lookup.remarks[index].iter().cloned());
        (marks > 0).then(|| {
            let mut region = json!({"region": place, "marks": marks, "asked": asked(lookup, place),
                "spread": spread, "predicted": answer.predicted, "coverage": answer.coverage.to_string(),
                "notes": notes.collect::<Vec<_>>()});
            if let Some(raggedness) = raggedness {
                region["raggedness"] = json!(raggedness);
            }
            region
        })
    };
    let regions: Vec<Value> = lookup.answers.iter().enumerate().filter_map(region).collect();
    let json = json!({"system": lookup.system.name(), "inverted": lookup.polarity == Polarity::Negative,
        "cell": lookup.px_a_cell(), "grid": lookup.grid.size, "regions": regions, "notes": notes});
    Described::new(reach(lookup, request.index), notes, json)
}

/// The drawn spots that are too near to others of their layer.
fn crowded(plan: &Lookup) -> Option<String> {
    let Start::Free { spots, .. } = &plan.start else { return None };
    if spots.is_empty() {
        return None;
    }
    let alone = plan.clone().uncorrected().lay_out(Surroundings::default(), 0).ok()?;
    expected_note(&alone)
}

/// The attributes that are asked of a region as a whole.
fn asked(plan: &Lookup, place: [usize; 2]) -> Attributes {
    if plan.map.is_modulated() {
        plan.map.of_region(place)
    } else {
        plan.map.at(plan.map.layout().center(place))
    }
}

/// The layer that would be grown, and for each region what was asked for and what cannot be met, as text.
fn reach(plan: &Lookup, index: usize) -> String {
    let layout = plan.map.layout();
    let [nx, ny] = plan.grid.size;
    let mut text = format!(
        "layer {}: {}grown by {} on {nx} × {ny} cells of {:.2} px\n",
        index + 1,
        if plan.polarity == Polarity::Negative { "gaps between its stripes " } else { "" },
        plan.system.name(),
        plan.px_a_cell()
    );
    let mut empty = 0;
    for (region, answer) in plan.answers.iter().enumerate() {
        let [column, row] = layout.place(region);
        if plan.map.region([column, row]).marks == 0 {
            empty += 1;
            continue;
        }
        let wanted = asked(plan, [column, row]);
        // Writing to a String cannot fail.
        let varied = varied(&plan.map.region([column, row]).spread);
        let _ = writeln!(
            text,
            "  region [{column}, {row}]: {}{varied}; {}",
            in_words(&wanted, plan.curve_kind().is_some()),
            answer.coverage
        );
        for note in &answer.notes {
            let _ = writeln!(text, "    {note}");
        }
        for remark in &plan.remarks[region] {
            let _ = writeln!(text, "    {remark}");
        }
    }
    if empty > 0 {
        let _ = writeln!(text, "  regions without marks, which take their nearest neighbour's: {empty}");
    }
    text
}

/// The spread in words, such as `, varied: area by 0.12, angle by 8°`; empty if all marks are alike.
fn varied(spread: &Spread) -> String {
    let part = |(attribute, value): (Attribute, f64)| match attribute {
        Attribute::Angle => (value >= 0.05).then(|| format!("angle by {value:.1}°")),
        _ => (value >= 0.0005).then(|| format!("{attribute} by {value:.3}")),
    };
    let parts: Vec<String> = spread.named().into_iter().filter_map(part).collect();
    if parts.is_empty() { String::new() } else { format!(", varied: {}", parts.join(", ")) }
}
