//! Layer by layer: the marks of earlier layers are frozen, and each later one grows into the space that they left.

mod other_kinds;

use std::sync::Arc;

use crate::document::{After, Document, Layer};
use crate::grid::Field;
use crate::rd::Seeding;
use crate::synth::grow::engine::Engine;
use crate::synth::grow::layer::{GrowError, Grown, GrownLayer, GrownMarks};
use crate::synth::grow::local_separation::remeasured;
use crate::synth::grow::merged_spots::MergedSpots;
use crate::synth::grow::obstacles::{bias, obstacles};
use crate::synth::grow::passing::{crossed_marks, crosses};
use crate::synth::grow::pattern::{EDGE, Pattern};
use crate::synth::grow::pinned_correction::{PinnedCorrection, Rounds};
use crate::synth::grow::probe::{When, correct};
use crate::synth::grow::ragged::ragged;
use crate::synth::grow::refine::{Measured, refine};
use crate::synth::grow::settle::settle_seen;
use crate::synth::grow::snapshot::Snapshot;
use crate::synth::memory;
use crate::synth::options::{Options, Settings};
use crate::synth::phases::{Phase, during};
use crate::synth::plan::layer_lookup::Start;
use crate::synth::plan::offset::Offset;
use crate::synth::plan::raggedness::asked_raggedness;
use crate::synth::plan::{Corrected, Lookup, Plan, Surroundings, Targets};
use crate::synth::watch::Stage;

/// Grows `document`.
///
/// # Errors
/// See [`GrowError`].
pub fn grow(document: &Document, options: &Options) -> Result<Grown, GrowError> {
    regrow(document, options, None)
}

/// Grows `document`, and takes from `before` the lowest layers that have not changed since. The result is that of
/// [`grow()`]. `before` must have been grown from the same training sets.
///
/// # Errors
/// See [`GrowError`].
pub fn regrow(document: &Document, options: &Options, before: Option<&Grown>) -> Result<Grown, GrowError> {
    // On a thread of the pool. From outside, each parallel part would wake two threads and let this one wait.
    rayon::scope(|_| regrow_seen(document, options, before, None, &mut |_| {}))
}

/// As [`regrow`], and calls `seen` every few milliseconds with the layer that grows. The result does not depend on it. What was
/// looked up for the lowest layer that grows may be `known`.
///
/// # Errors
/// See [`GrowError`].
pub fn regrow_seen(
    document: &Document,
    options: &Options,
    before: Option<&Grown>,
    known: Option<Lookup>,
    seen: &mut dyn FnMut(&Snapshot),
) -> Result<Grown, GrowError> {
    Cascade { document, options: *options, every: None }.grow(before, known, seen)
}

/// As [`grow()`], and calls `seen` each `every` of normalised time: at the same moments on any machine.
///
/// # Errors
/// See [`GrowError`].
pub fn grow_seen(
    document: &Document,
    options: &Options,
    every: f64,
    seen: &mut dyn FnMut(&Snapshot),
) -> Result<Grown, GrowError> {
    Cascade { document, options: *options, every: Some(every) }.grow(None, None, seen)
}

/// How many of the lowest layers of `document` would grow as they have in `before`, and so are taken from there. Names and
/// colours do not matter.
#[must_use]
pub fn unchanged(document: &Document, settings: Settings, before: &Grown) -> usize {
    let canvas = |of: &Document, settings: Settings| {
        (of.size, of.regions, of.edges, settings.size, settings.refine.unwrap_or(of.growth.refine))
    };
    let lacks_concentrations = settings.concentrations && !before.settings.concentrations;
    if lacks_concentrations || canvas(document, settings) != canvas(&before.document, before.settings) {
        return 0;
    }
    let pairs = document.layers.iter().zip(&before.document.layers).enumerate();
    let pairs = pairs.take(before.layers.len());
    let same = pairs.take_while(|(index, (new, old))| {
        let seed = document.layer_seed(*index) == before.document.layer_seed(*index);
        let marks = (new.system, new.after, &new.options, &new.strokes, &new.tone, &new.points)
            == (old.system, old.after, &old.options, &old.strokes, &old.tone, &old.points);
        seed && marks && new.maps.growing().eq(old.maps.growing())
    });
    same.count()
}

/// The growth of a document.
struct Cascade<'a> {
    document: &'a Document,
    options: Options<'a>,
    /// Normalised time between two snapshots; `None` = a few milliseconds of wall time.
    every: Option<f64>,
}

impl Cascade<'_> {
    /// Grows the layers that do not stand in `before`. What was looked up for the lowest of them may be `known`.
    fn grow(
        &self,
        before: Option<&Grown>,
        mut known: Option<Lookup>,
        seen: &mut dyn FnMut(&Snapshot),
    ) -> Result<Grown, GrowError> {
        let Self { document, options, .. } = *self;
        let size = options.size.unwrap_or(document.size);
        let frozen = before.map_or(0, |before| unchanged(document, options.settings(), before));
        let mut looked_up = Vec::new();
        if frozen == 0 && document.layers.len() > 1 {
            looked_up = during(Phase::LookUp, || self.look_up_all())?;
        }
        let mut layers: Vec<GrownLayer> = Vec::with_capacity(document.layers.len());
        layers.extend(before.iter().flat_map(|before| &before.layers[..frozen]).cloned());
        for index in frozen..document.layers.len() {
            let known = known.take().or_else(|| looked_up.get_mut(index).and_then(Option::take));
            let layer = self.layer(index, known, &layers, seen)?;
            layers.push(layer);
        }
        Ok(Grown { size, layers, document: document.clone(), settings: options.settings() })
    }

    /// Looks up every layer, so that one that cannot be grown is refused before the first one grows. Returns what is found for
    /// those that do not depend on the growth of the one beneath.
    fn look_up_all(&self) -> Result<Vec<Option<Lookup>>, GrowError> {
        let layers = &self.document.layers;
        let mut found: Vec<Option<Lookup>> = Vec::with_capacity(layers.len());
        for (index, layer) in layers.iter().enumerate() {
            let below = found.last().and_then(Option::as_ref);
            found.push(if self.plan_of_other_kind(index, layer)? {
                None
            } else {
                Some(self.look_up(index, below)?)
            });
        }
        let is_final = |layer: &Layer| layer.after != After::Inside;
        Ok(found.into_iter().zip(layers).map(|(lookup, layer)| lookup.filter(|_| is_final(layer))).collect())
    }

    /// Looks up layer `index`, which grows above `below`.
    fn look_up(&self, index: usize, below: Option<&Lookup>) -> Result<Lookup, GrowError> {
        let Options { source, training, .. } = self.options;
        let size = self.options.size.unwrap_or(self.document.size).map(f64::from);
        let lookup = Targets::read(self.document, index, source, size, below)?.look_up(training)?;
        memory::check(lookup.system, size, lookup.grid.size, self.options.memory)?;
        Ok(lookup)
    }

    /// Grows layer `index` into the space that those `beneath` left free. What was looked up for it may be `known`.
    fn layer(
        &self,
        index: usize,
        known: Option<Lookup>,
        beneath: &[GrownLayer],
        seen: &mut dyn FnMut(&Snapshot),
    ) -> Result<GrownLayer, GrowError> {
        let Self { document, options, .. } = *self;
        if let Some(layer) = self.layer_of_other_kind(index, beneath, seen) {
            return layer;
        }
        let Options { training, watch, .. } = options;
        let below = beneath.last().and_then(GrownLayer::marks);
        watch.step(Stage::Plan, 0.0)?;
        let look_up = || self.look_up(index, below.map(|layer| &layer.plan.lookup));
        let lookup = known.map_or_else(|| during(Phase::LookUp, look_up), Ok)?;
        let (obstacles, crossed) = during(Phase::LayOut, || {
            let passes = |layer: &GrownLayer| crosses(&lookup, layer);
            let obstacles = obstacles(document, beneath, lookup.grid.size, &passes);
            (obstacles, crossed_marks(document, beneath, &lookup).map(Arc::new))
        });
        let spots = below.map_or(&[][..], |layer| layer.measured.spots());
        let seed = document.layer_seed(index);
        let corrected = during(Phase::Probe, || self.corrected(lookup))?;
        let surroundings = Surroundings { obstacles, spots };
        let plan = during(Phase::LayOut, || corrected.lay_out(surroundings, seed));
        let plan = plan.map_err(|error| GrowError::laying_out(index + 1, error))?;
        let mut seen = |plan: &Plan, engine: &Engine| seen(&Snapshot::of_marks(beneath, plan, engine));
        let layer = self.grow_layer(plan, index, &mut seen)?;
        let layer = match self.bias(&layer) {
            None => layer,
            Some(bias) => self.grow_layer(layer.plan.less(training, &bias)?, index, &mut seen)?,
        };
        let layer = match asked_raggedness(&layer.plan.lookup.map, &document.layers[index].options) {
            None => layer,
            Some(asked) => during(Phase::Measure, || ragged(layer, asked, seed, &watch))?,
        };
        Ok(GrownLayer::Marks(Box::new(GrownMarks { crossed, ..layer })))
    }

    /// Is the pattern corrected?
    fn corrects(&self) -> bool {
        self.options.refine.unwrap_or(self.document.growth.refine)
    }

    /// Corrects the looked-up parameters by probes, where that is asked for.
    fn corrected(&self, lookup: Lookup) -> Result<Corrected, GrowError> {
        let Options { training, watch, .. } = self.options;
        if !self.corrects() || lookup.seeding != Seeding::Noise || is_corrected_spot_by_spot(&lookup) {
            return Ok(lookup.uncorrected());
        }
        watch.step(Stage::Plan, 0.1)?;
        Ok(correct(lookup, training, When::Unsure, &watch)?)
    }

    /// How the layers beneath have turned and stretched the spots of `layer`, where that is corrected.
    fn bias(&self, layer: &GrownMarks) -> Option<Vec<Offset>> {
        let correctable = self.corrects() && layer.plan.places().is_none();
        if correctable { bias(&layer.plan, &layer.measured) } else { None }
    }

    /// Separates spots that have grown together, where they are few. Returns what is `measured` then, and those that are still
    /// merged.
    fn separated(
        &self,
        plan: &Plan,
        pattern: &Pattern,
        rounds: &mut Rounds,
        engine: &mut Engine,
        marks: &mut Field,
        mut measured: Measured,
    ) -> Result<(Measured, MergedSpots), GrowError> {
        loop {
            let merged = during(Phase::Measure, || engine.merged(plan, measured.spots()));
            let parts = if self.corrects() { engine.parts_about(&merged) } else { None };
            let Some(parts) = parts.filter(|_| rounds.separate(&merged)) else {
                return Ok((measured, merged));
            };
            engine.separate_in(&parts, plan, &merged, &self.options.watch)?;
            measured = during(Phase::Measure, || remeasured(plan, pattern, &parts, engine, marks, measured));
        }
    }

    /// Grows layer `index` as planned.
    fn grow_layer(
        &self,
        mut plan: Plan,
        index: usize,
        seen: &mut dyn FnMut(&Plan, &Engine),
    ) -> Result<GrownMarks, GrowError> {
        let Self { document, options, every } = *self;
        let watch = options.watch;
        let layer = index + 1;
        watch.step(Stage::Plan, 0.5)?;
        let mut engine = during(Phase::LayOut, || Engine::new(&plan, document.layer_seed(index)));
        if !engine.can_start() {
            return Err(GrowError::NoRoom { layer });
        }
        watch.step(Stage::Plan, 1.0)?;
        let canvas = plan.lookup.map.layout().size.map(|side| side as usize);
        let mut rounds = Rounds::default();
        let mut best: Option<(f64, GrownMarks)> = None;
        // Of the last round: what has grown on hardly needs other levels.
        let mut levels: Option<Vec<f64>> = None;
        loop {
            let settled = settle_seen(&mut engine, every, &watch, &mut |engine| seen(&plan, engine))?;
            let mut marks = plan.levelled(engine.marks());
            if !marks.values.iter().all(|value| value.is_finite()) {
                return Err(GrowError::NoPattern { layer });
            }
            let mut pattern = Pattern::new(&plan.lookup, &marks);
            pattern.correction = levels.take().unwrap_or(pattern.correction);
            let measured =
                during(Phase::Measure, || refine(&plan, &mut pattern, canvas, self.corrects(), &watch))?;
            let (measured, merged) =
                self.separated(&plan, &pattern, &mut rounds, &mut engine, &mut marks, measured)?;
            let nothing = during(Phase::Measure, || blank(&plan, &pattern));
            let Pattern { correction, own: own_levels, .. } = pattern;
            levels = Some(correction.clone());
            let found = during(Phase::Measure, || PinnedCorrection::new(&plan, measured.spots()));
            let error =
                if nothing.is_some() { f64::INFINITY } else { error_of(&plan, &measured, &found, &merged) };
            if best.as_ref().is_none_or(|(least, _)| error < *least) {
                let concentrations =
                    if options.concentrations { engine.concentrations() } else { Vec::new() };
                let (plan, steps) = (plan.clone(), engine.steps());
                let grown = GrownMarks {
                    plan,
                    steps,
                    settled,
                    correction,
                    own_levels,
                    measured,
                    marks,
                    concentrations,
                    ragged: None,
                    crossed: None,
                };
                best = Some((error, grown));
            }
            if self.corrects() && engine.grow_on_corrected(&mut plan, &mut rounds, &found, &merged) {
                continue;
            }
            return match (best, nothing) {
                (Some((error, grown)), _) if error.is_finite() => {
                    Ok(GrownMarks { steps: engine.steps(), ..grown })
                }
                (_, what) => Err(GrowError::Blank { layer, what: what.unwrap_or("no marks") }),
            };
        }
    }
}

/// How far what is `measured` is from what was drawn. A mark that is missing is worse than one that differs as much as one can: it
/// counts twice. A lost one is in the error once already.
fn error_of(plan: &Plan, measured: &Measured, found: &PinnedCorrection, merged: &MergedSpots) -> f64 {
    let told = measured.merged_spots(plan).count();
    let merged = told.max(merged.surplus.len() + merged.crowded.len());
    let missing = found.lost.len() + 2 * (plan.left_out().len() + merged);
    found.error + missing as f64
}

/// Whether wanted attributes differ from place to place, and drawn spots are measured and corrected one by one, or maps vary them: a probe of
/// the mean would tell little, and can cost more than the canvas.
fn is_corrected_spot_by_spot(lookup: &Lookup) -> bool {
    let has_drawn_spots = matches!(&lookup.start, Start::Free { spots, .. } if !spots.is_empty());
    lookup.map.is_free() && has_drawn_spots || lookup.map.is_modulated()
}

/// What a layer is instead of a pattern where it has no marks, or nothing but marks; `None` of a pattern.
fn blank(plan: &Plan, pattern: &Pattern) -> Option<&'static str> {
    let [nx, ny] = plan.lookup.grid.size;
    let (mut marks, mut ground) = (false, false);
    for first in (0..ny).step_by(SEEN_AT_ONCE) {
        let rows = first..ny.min(first + SEEN_AT_ONCE);
        for (cell, value) in (first * nx..).zip(pattern.rows(rows, nx, ny)) {
            let free = !plan.obstacles.get(cell).is_some_and(|taken| *taken);
            marks |= free && value >= EDGE;
            ground |= free && value < EDGE;
        }
        // Mostly soon.
        if marks && ground {
            return None;
        }
    }
    match (marks, ground) {
        (false, _) => Some("no marks"),
        (true, false) if plan.obstacles.is_empty() => Some("marks without any ground between them"),
        _ => None,
    }
}

/// Rows that are looked at together.
const SEEN_AT_ONCE: usize = 64;
