//! Values of the maps of a layer that its system cannot grow.

use rayon::prelude::*;

use crate::synth::drawn::maps::nodes;
use crate::synth::error::PlanError;
use crate::synth::marks::plan::layer_lookup::{Lookup, notes_of_marks};
use crate::synth::training::Training;

/// Number of places along the longer side at which the values of the maps are looked up for [`beyond`].
const ASKED: usize = 16;

/// A note for each region where the maps ask for values that cannot be grown, so that the nearest ones are grown.
pub(super) fn beyond(lookup: &Lookup, training: &Training) -> Result<Vec<Option<String>>, PlanError> {
    let layout = lookup.map.layout();
    let places = nodes(layout.edges, layout.size, ASKED);
    let (cell, answers) = (lookup.px_a_cell(), lookup.answers_of(training));
    let noted = |index: usize| {
        let point = places.center(places.place(index));
        let lines = lookup.polarity.lines(&lookup.map.at(point));
        let notes = notes_of_marks(lookup.polarity, &answers.ask(lookup.system, &lines, cell)?);
        let note = notes.iter().find(|note| note.is_beyond()).map(ToString::to_string);
        Ok((layout.index(layout.region_of(point)), note))
    };
    let noted = (0..places.len()).into_par_iter().map(noted).collect::<Result<Vec<_>, PlanError>>()?;
    let asking = if lookup.map.metric().is_some() { "the surface asks" } else { "the maps ask" };
    let of_region = |region: usize| {
        let here: Vec<_> = noted.iter().filter(|(at, _)| *at == region).map(|(_, note)| note).collect();
        let notes: Vec<&String> = here.iter().copied().flatten().collect();
        let share = 100.0 * notes.len() as f64 / here.len() as f64;
        let first = notes.first()?;
        Some(format!(
            "on {share:.0} % of it {asking} for what cannot be grown, and the nearest grows: {first}"
        ))
    };
    Ok((0..layout.len()).map(of_region).collect())
}
