//! Attributes in px → parameters in cells: the size of a cell, and questions to the training sets.

use crate::attributes::{Attributes, Spots, Stripes};
use crate::learn::{Answer, Found, Note, Parameters};
use crate::rd::System;
use crate::synth::error::PlanError;
use crate::synth::training::Training;

/// Smallest cell, px: finer patterns could not be seen on the canvas.
const FINEST: f64 = 0.35;
/// area ÷ spacing² of spots whose spacing is free: what Meinhardt's system packs at its smallest ratio (0.124–0.126 at
/// aspects from 0.4 to 1), where its spots are evenest.
const FREE_DENSITY: f64 = 0.122;

/// Spots that are sparser than what can be reached by less than this share count as reached.
const TOLERANCE: f64 = 0.02;
/// From this pitch on spots on a canvas with sparse ones stand alone, at the level of single spots.
pub(super) const ALONE: f64 = 1.7;

/// Looks up attributes (px) for a grid of so many px a cell.
pub(super) type Ask<'a> = &'a (dyn Fn(&Attributes, f64) -> Result<Answer, PlanError> + Sync);

/// What grows attributes, without what it is predicted to grow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    /// Parameters in cells.
    pub parameters: Parameters,
    /// How many times farther apart than the system's own distance marks begin.
    pub pitch: f64,
}

impl Setting {
    /// That of an answer.
    #[must_use]
    pub fn of(answer: &Answer) -> Self {
        Self { parameters: answer.parameters, pitch: answer.pitch }
    }

    /// One about cells of `exact` px for a grid of `cell` px a cell.
    pub(super) fn on_grid(mut self, cell: f64, exact: f64) -> Self {
        self.parameters.rate = rate_on_grid(self.parameters.rate, cell, exact);
        self
    }
}

/// Looks up what grows attributes (px) on a grid of so many px a cell.
pub(super) type AskSetting<'a> = &'a (dyn Fn(&Attributes, f64) -> Result<Setting, PlanError> + Sync);

/// px a cell that suits these attributes: on it the smallest mark has the cells that `system` needs.
#[must_use]
pub fn cell_for(system: System, wanted: &Attributes) -> f64 {
    let [own, asked] = system.definition().resolution.planned;
    let cell = match wanted {
        Attributes::Stripes(Stripes { width, wavelength: None, .. }) => width / own,
        Attributes::Stripes(line) => line.width / asked,
        Attributes::Spots(spots) => {
            // Denser spots are read at a lower level, and so are larger than the peak that must be resolved.
            let dense = spots.spacing.map_or(1.0, |s| (spots.area / (s * s) / FREE_DENSITY).clamp(1.0, 2.0));
            (spots.area / dense / asked).sqrt()
        }
    };
    cell.max(FINEST)
}

/// px a cell of the coarsest grid, no finer than `cell`, on which the size of such marks in cells makes no difference to
/// `system`.
#[must_use]
pub fn exact_cell(system: System, wanted: &Attributes, cell: f64) -> f64 {
    let [own, asked] = system.definition().resolution.exact;
    cell.max(match wanted {
        Attributes::Spots(spots) => (spots.area / asked).sqrt(),
        Attributes::Stripes(Stripes { width, wavelength: None, .. }) => width / own,
        Attributes::Stripes(line) => line.width / asked,
    })
}

/// Looks up attributes (px) for a grid of `cell` px a cell. The answer's attributes are px, its parameters
/// those of the grid. Spots sparser than any that their system packs by itself begin farther apart, if they can.
///
/// # Errors
/// The training set cannot be read, or does not take such attributes.
pub fn ask(training: &Training, system: System, wanted: &Attributes, cell: f64) -> Result<Answer, PlanError> {
    let exact = exact_cell(system, wanted, cell);
    Ok(on_grid(ask_in_cells(training, system, &wanted.scaled(1.0 / exact))?, cell, exact))
}

/// As [`ask`], without what is predicted to grow.
///
/// # Errors
/// As [`ask`].
pub fn find(training: &Training, system: System, wanted: &Attributes, cell: f64) -> Result<Found, PlanError> {
    let exact = exact_cell(system, wanted, cell);
    let mut found = find_in_cells(training, system, &wanted.scaled(1.0 / exact))?;
    found.parameters.rate = rate_on_grid(found.parameters.rate, cell, exact);
    Ok(found.in_px(exact))
}

/// Looks up attributes in cells, on a grid where the size of the marks makes no difference.
pub(super) fn ask_in_cells(
    training: &Training,
    system: System,
    asked: &Attributes,
) -> Result<Answer, PlanError> {
    let set = training.set(system)?;
    let answer = set.ask(asked)?;
    let apart = if is_sparser(asked, &answer.nearest) { set.ask_apart(asked, 1.0)? } else { None };
    Ok(apart.unwrap_or(answer))
}

/// As [`ask_in_cells`], without what is predicted to grow.
pub(super) fn find_in_cells(
    training: &Training,
    system: System,
    asked: &Attributes,
) -> Result<Found, PlanError> {
    let set = training.set(system)?;
    let found = set.find(asked)?;
    let apart = if is_sparser(asked, &found.nearest) { set.ask_apart(asked, 1.0)? } else { None };
    Ok(apart.map_or(found, Found::from))
}

/// As [`ask`], for spots at given places: as spots that stand alone where these are far enough apart. `room` is the share of
/// the spacing, 0..1, that is left to them in the direction in which the places suit their shape least.
///
/// # Errors
/// As [`ask`].
pub fn ask_placed(
    training: &Training,
    system: System,
    wanted: &Attributes,
    room: f64,
    cell: f64,
) -> Result<Answer, PlanError> {
    let exact = exact_cell(system, wanted, cell);
    let (set, asked) = (training.set(system)?, wanted.scaled(1.0 / exact));
    let mut answer = match set.ask_apart(&asked, room)? {
        Some(answer) => answer,
        None => set.ask(&asked)?,
    };
    answer.notes.retain(|note| !matches!(note, Note::Apart { .. }));
    Ok(on_grid(answer, cell, exact))
}

/// An answer about cells of `exact` px for a grid of `cell` px a cell.
pub(super) fn on_grid(mut answer: Answer, cell: f64, exact: f64) -> Answer {
    answer.parameters.rate = rate_on_grid(answer.parameters.rate, cell, exact);
    answer.in_px(exact)
}

/// The rate of a grid of `cell` px a cell, from that about cells of `exact` px.
fn rate_on_grid(rate: f64, cell: f64, exact: f64) -> f64 {
    let shrink = cell / exact;
    rate * (shrink * shrink)
}

/// Is what is asked sparser than what is reached?
fn is_sparser(asked: &Attributes, reached: &Attributes) -> bool {
    let packing = |attributes: &Attributes| match attributes {
        Attributes::Spots(Spots { area, spacing: Some(spacing), .. }) => Some(area / (spacing * spacing)),
        _ => None,
    };
    packing(asked).zip(packing(reached)).is_some_and(|(asked, reached)| asked < (1.0 - TOLERANCE) * reached)
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
    match given.map(|answer| answer.predicted) {
        Some(Attributes::Spots(Spots { spacing: Some(spacing), .. })) => spacing,
        _ => (spots.area / FREE_DENSITY).sqrt(),
    }
}
