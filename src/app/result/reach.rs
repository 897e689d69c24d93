//! Changes of the sketch of a region that cannot be grown, to the most similar one that can.

mod described;
mod sketch;
mod spaced;

use crate::attributes::{AttributeMap, Attributes};
use crate::document::Document;
use crate::marks::Mark;
use crate::synth::Training;
use crate::synth::marks::plan::{Lookup, Targets};
use described::described;
use sketch::{Farther, Sketch};

/// Number of attempts; each goes farther beyond the limit than the one before.
const TRIES: i32 = 10;
/// How much farther each attempt goes, as a share of the whole change.
const FARTHER: f64 = 0.15;
/// For marks that are too close: how much farther apart each attempt moves them, as a share of the least possible
/// distance.
const APART: f64 = 0.01;

/// A change of the sketch after which a region can be reached.
#[derive(Clone, Debug, PartialEq)]
pub struct Reach {
    /// Indices of strokes in the layer, and the marks that replace them.
    pub marks: Vec<(usize, Mark)>,
    /// The new duty of the layer, where it changes.
    pub duty: Option<f64>,
    /// What changes, in words.
    pub text: String,
}

/// The change after which region `index` of layer `layer` of `document`, planned in `plans`, can be reached; `None` where
/// it can be reached already, or where none was found.
#[must_use]
pub fn reach(
    training: &Training,
    document: &Document,
    plans: &[Option<&Lookup>],
    layer: usize,
    index: usize,
) -> Option<Reach> {
    let mut document = document.clone();
    let beneath = layer.checked_sub(1).and_then(|below| plans[below]);
    let first = plans[layer]?;
    let place = source(&first.map, index)?;
    let index = first.map.layout().index(place);
    let mut asked = asked_in(first, place);
    let mut answer = first.answers[index].clone();
    let from = Sketch::of_region(&document, layer, first.map.layout(), place)?;
    for attempt in 0..TRIES {
        if answer.notes.iter().all(|note| !note.is_beyond()) {
            let to = Sketch::of_region(&document, layer, first.map.layout(), place)?;
            return (attempt > 0).then(|| change(&from, to));
        }
        let sketch = Sketch::of_region(&document, layer, first.map.layout(), place)?;
        let farther = 1.0 + FARTHER * f64::from(attempt);
        // Some systems have only one spacing, and beyond it the error grows again.
        let free = first.system.description().free_spacing;
        let apart = if free { 1.0 + APART * f64::from(attempt) } else { 1.0 };
        let by = Farther { change: farther, apart };
        sketch.toward(&asked, &answer, by, first.map.layout(), place)?.write(&mut document, layer);
        let size = document.size.map(f64::from);
        let plan = Targets::read(&document, layer, "", size, beneath).ok()?.look_up(training).ok()?;
        asked = asked_in(&plan, place);
        answer = plan.answers[index].clone();
    }
    None
}

fn asked_in(plan: &Lookup, place: [usize; 2]) -> Attributes {
    plan.map.at(plan.map.layout().center(place))
}

/// The region whose marks set the attributes of region `index`: the region itself, or the nearest one with marks.
fn source(map: &AttributeMap, index: usize) -> Option<[usize; 2]> {
    let layout = map.layout();
    let holds = |index: usize| map.region(layout.place(index)).own.is_some();
    let own = if holds(index) { Some(index) } else { layout.nearest(layout.place(index), holds) };
    own.map(|index| layout.place(index))
}

/// The change between two sketches of a region.
fn change(from: &Sketch, to: Sketch) -> Reach {
    let text = described(from, &to);
    let duty = to.duty.given().filter(|_| to.duty != from.duty);
    Reach { marks: to.marks, duty, text }
}

#[cfg(test)]
mod tests;
