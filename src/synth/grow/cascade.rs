//! Layer by layer: what earlier ones grew is frozen, and what comes next grows into what they left.

use crate::attributes::Attributes;
use crate::attributes::regions::RegionMap;
use crate::document::layer_rules::{Beneath, Combination};
use crate::document::{After, Document, Kind};
use crate::rd::Seeding;
use crate::synth::grow::engine::Engine;
use crate::synth::grow::layer::{GrowError, Grown, GrownLayer, grow_layer};
use crate::synth::grow::probe::When;
use crate::synth::memory;
use crate::synth::options::{Options, Settings};
use crate::synth::plan::around::{plan_lines, way};
use crate::synth::plan::inside::{is_replaced, plan_inside, too_large};
use crate::synth::plan::pinned_marks::keep;
use crate::synth::plan::{Plan, plan};
use crate::synth::plan::{obstacle_mask, sketch_targets};
use crate::synth::render::painting::Look;
use crate::synth::render::pattern::Pattern;
use crate::synth::training::Training;
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
    regrow_seen(document, options, before, &mut |_| {})
}

/// As [`regrow`], and calls `seen` every few milliseconds with the layer that grows. The result does not depend on it.
///
/// # Errors
/// See [`GrowError`].
pub fn regrow_seen(
    document: &Document,
    options: &Options,
    before: Option<&Grown>,
    seen: &mut dyn FnMut(&Look),
) -> Result<Grown, GrowError> {
    Cascade { document, options: *options, every: None }.grow(before, seen)
}

/// As [`grow()`], and calls `seen` each `every` of normalised time: at the same moments on any machine.
///
/// # Errors
/// See [`GrowError`].
pub fn grow_seen(
    document: &Document,
    options: &Options,
    every: f64,
    seen: &mut dyn FnMut(&Look),
) -> Result<Grown, GrowError> {
    Cascade { document, options: *options, every: Some(every) }.grow(None, seen)
}

/// How many of the lowest layers of `document` would grow as they have in `before`, and so are taken from there.
#[must_use]
pub fn unchanged(document: &Document, settings: Settings, before: &Grown) -> usize {
    let canvas = |of: &Document, settings: Settings| {
        (of.size, of.regions, of.edges, settings.size, settings.refine.unwrap_or(of.growth.refine))
    };
    if canvas(document, settings) != canvas(&before.document, before.settings) {
        return 0;
    }
    let pairs = document.layers.iter().zip(&before.document.layers).enumerate();
    let pairs = pairs.take(before.layers.len());
    let same = pairs.take_while(|(index, (new, old))| {
        let seed = document.layer_seed(*index) == before.document.layer_seed(*index);
        let marks = (new.system, new.after, &new.options, &new.strokes)
            == (old.system, old.after, &old.options, &old.strokes);
        // What is written of a layer names the one beneath.
        seed && marks && new.name == old.name
    });
    same.count()
}

/// What every layer of a document is grown with.
struct Cascade<'a> {
    document: &'a Document,
    options: Options<'a>,
    /// Normalised time from look to look; `None` = as suits those who wait.
    every: Option<f64>,
}

impl Cascade<'_> {
    /// Grows the layers that do not stand in `before`.
    fn grow(&self, before: Option<&Grown>, seen: &mut dyn FnMut(&Look)) -> Result<Grown, GrowError> {
        let Self { document, options, .. } = *self;
        let size = options.size.unwrap_or(document.size);
        let frozen = before.map_or(0, |before| unchanged(document, options.settings(), before));
        let mut layers: Vec<GrownLayer> = Vec::with_capacity(document.layers.len());
        layers.extend(before.iter().flat_map(|before| &before.layers[..frozen]).cloned());
        for index in frozen..document.layers.len() {
            let layer = self.layer(index, &layers, seen)?;
            layers.push(layer);
        }
        Ok(Grown { size, layers, document: document.clone(), settings: options.settings() })
    }

    /// Grows layer `index` into what those `beneath` left free.
    fn layer(
        &self,
        index: usize,
        beneath: &[GrownLayer],
        seen: &mut dyn FnMut(&Look),
    ) -> Result<GrownLayer, GrowError> {
        let mut seen = |plan: &Plan, engine: &Engine| seen(&Look { beneath, plan, engine });
        let Self { document, options, every } = *self;
        let Options { source, training, watch, .. } = options;
        let correct = options.refine.unwrap_or(document.growth.refine);
        let size = options.size.unwrap_or(document.size).map(f64::from);
        watch.step(Stage::Plan, 0.0)?;
        let map = sketch_targets::region_map(document, index, source)?.resized(size);
        let mut plan =
            planned(document, index, source, training, &map, beneath.last().map(|layer| &layer.plan))?;
        memory::check(plan.system, size, plan.grid)?;
        plan.seeding = document.layers[index].options.seeding;
        if correct && plan.seeding == Seeding::Noise {
            watch.step(Stage::Plan, 0.1)?;
            plan = plan.probed(training, When::Unsure, &watch)?;
        }
        if plan.places.is_some()
            && let Some(beneath) = beneath.last()
        {
            plan.place_inside(&beneath.measured);
        }
        placed_over(&mut plan, document, beneath);
        let striped = matches!(plan.map.at([0.0, 0.0]), Attributes::Stripes(_));
        if striped && plan.way.is_none() && !plan.taken.is_empty() {
            if !obstacle_mask::has_room(&plan) {
                return Err(GrowError::NoRoom { layer: index + 1 });
            }
            plan.taken = obstacle_mask::with_rim(&plan.taken, plan.grid, document.edges);
        }
        let free = plan.way.is_none() && plan.places.is_none();
        if free && (document.keeps(index) || plan.seeding == Seeding::Initiators) {
            keep(&mut plan, &sketch_targets::marks_on(document, index, source, size)?);
        }
        let keeping = [correct, options.concentrations];
        let seed = document.layer_seed(index);
        plan.lay_course(document.layers[index].options.broken, seed)
            .map_err(|reason| GrowError::Course { layer: index + 1, reason })?;
        let mut layer = grow_layer(plan, seed, index + 1, keeping, &watch, every, &mut seen)?;
        if let Some(found) = obstacle_mask::shaped(&layer.plan, &layer.measured)
            .filter(|_| correct && layer.plan.places.is_none())
        {
            layer = grow_layer(
                layer.plan.against(training, &found)?,
                seed,
                index + 1,
                keeping,
                &watch,
                every,
                &mut seen,
            )?;
        }
        if document.layers[index].after == After::Inside {
            layer.plan.tell_places(&layer.measured, &document.layers[index - 1].name);
        }
        Ok(layer)
    }
}

/// Takes from `plan` the cells that the marks of the layers `beneath` have, but for those that others replace.
pub fn placed_over(plan: &mut Plan, document: &Document, beneath: &[GrownLayer]) {
    let shown = beneath.iter().enumerate().filter(|(below, _)| !is_replaced(document, *below));
    let shown: Vec<Pattern> = shown.map(|(_, layer)| layer.pattern()).collect();
    if !shown.is_empty() {
        plan.taken = obstacle_mask::taken(&shown, plan.grid);
    }
}

/// Plans layer `index`, whose marks make `map`, above the layer with the plan `beneath`.
///
/// # Errors
/// What was drawn cannot be grown there, or its parameters cannot be looked up.
pub fn planned(
    document: &Document,
    index: usize,
    source: &str,
    training: &Training,
    map: &RegionMap,
    beneath: Option<&Plan>,
) -> Result<Plan, GrowError> {
    let layer = &document.layers[index];
    let below = match beneath {
        Some(plan) => Beneath::Grows(grown_kind(&plan.map)),
        None if index == 0 || layer.after == After::Inside => Beneath::Nothing,
        None => Beneath::Unknown,
    };
    let combination = Combination::new(layer, Some(grown_kind(map)), below);
    if let Some(problem) = combination.problem(&format!("layers[{index}]")) {
        return Err(problem.in_file(source).into());
    }
    if let Some(way) = way(layer.after) {
        return Ok(plan_lines(way, map.clone())?);
    }
    if let Some(beneath) = beneath.filter(|_| layer.after == After::Inside) {
        return match too_large(index, map, beneath) {
            Some(problem) => Err(problem.in_file(source).into()),
            None => Ok(plan_inside(training, map, beneath)?),
        };
    }
    let mut plan = plan(training, layer.choice(), map)?;
    plan.irregular = layer.options.irregular;
    Ok(plan)
}

/// The kind of marks that a layer with this map grows.
fn grown_kind(map: &RegionMap) -> Kind {
    match map.at([0.0, 0.0]) {
        Attributes::Spots(_) => Kind::Ellipse,
        Attributes::Stripes(_) => Kind::Line,
    }
}
