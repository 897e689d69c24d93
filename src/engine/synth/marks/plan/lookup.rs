//! Attributes in px → parameters in cells: questions to the training sets.

use std::sync::Arc;

use crate::attributes::{Attributes, Spots};
use crate::learn::{InCells, Note};
use crate::rd::System;
use crate::synth::error::PlanError;
use crate::synth::marks::plan::answers::Answers;
use crate::synth::marks::plan::asked::Asked;
use crate::synth::marks::plan::cell_size::{FREE_DENSITY, cell_for, exact_cell};
use crate::synth::training::Training;

/// Looks up attributes (px) for a grid of so many px a cell.
pub(super) type Ask<'f, 'a> = &'f (dyn Fn(&Attributes, f64) -> Result<Asked<'a>, PlanError> + Sync + 'f);

/// Looks up attributes (px) for a grid of `cell` px a cell. Spots sparser than any that their system packs by itself begin farther apart,
/// if they can.
///
/// # Errors
/// The training set cannot be read, or does not take such attributes.
pub fn ask<'a>(
    training: &'a Training,
    system: System,
    wanted: &Attributes,
    cell: f64,
) -> Result<Asked<'a>, PlanError> {
    Answers::new(training).ask(system, wanted, cell)
}

/// Looks up spots at given places: as spots that stand alone where these are far enough apart. `room` is the share of
/// the spacing, 0..1, that is left to them in the direction in which the places suit their shape least.
///
/// # Errors
/// The training set cannot be read, or does not take such attributes.
pub fn ask_placed<'a>(
    training: &'a Training,
    system: System,
    wanted: &Attributes,
    room: f64,
    cell: f64,
) -> Result<Asked<'a>, PlanError> {
    let exact = exact_cell(system, wanted, cell);
    let (set, asked) = (training.set(system)?, InCells::from_px(*wanted, exact));
    let mut found = match set.ask_apart(&asked, room)? {
        Some(found) => found,
        None => set.ask(&asked)?,
    };
    found.notes.0.retain(|note| !matches!(note, Note::Apart { .. }));
    Ok(Asked::new(set, Arc::new(found), [exact, cell]))
}

/// The spacing of such spots, px, where it is left to the system.
#[must_use]
pub fn free_spacing(training: &Training, system: System, spots: &Spots) -> f64 {
    let free = Attributes::Spots(Spots { spacing: None, ..*spots });
    // Where any spacing can be grown, spots are evenest at the smallest ratio.
    let given = if system.description().free_spacing {
        None
    } else {
        ask(training, system, &free, cell_for(system, &free)).ok()
    };
    match given.map(|asked| asked.predict().predicted) {
        Some(Attributes::Spots(Spots { spacing: Some(spacing), .. })) => spacing,
        _ => (spots.area / FREE_DENSITY).sqrt(),
    }
}
