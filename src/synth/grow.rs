//! Growing a document.

use super::beneath::taken;
use super::engine::Engine;
use super::keep::keep;
use super::memory::TooLarge;
use super::pattern::Pattern;
use super::plan::{Plan, PlanError, plan};
use super::probe::{ProbeError, When};
use super::recipe::{After, Document, DocumentError, Problem};
use super::refine::{Measured, refine};
use super::settle::settle;
use super::training::Training;
use super::watch::{Cancelled, Stage, Watch};
use super::{drawn, memory};
use crate::field::Field;
use crate::rd::Seeding;

impl From<ProbeError> for GrowError {
    fn from(error: ProbeError) -> Self {
        match error {
            ProbeError::Plan(error) => Self::Plan(error),
            ProbeError::Cancelled(cancelled) => Self::Cancelled(cancelled),
        }
    }
}

/// How to grow a document, beyond what stands in it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Options {
    /// Canvas, px; `None` = the document's. The region layout stretches, features keep their size.
    pub size: Option<[u32; 2]>,
    /// Whether to correct what has grown; `None` = as the document says.
    pub refine: Option<bool>,
}

/// A grown layer.
pub struct GrownLayer {
    /// What was planned.
    pub plan: Plan,
    /// Steps taken.
    pub steps: u64,
    /// Whether the pattern came to rest within the time it was given.
    pub settled: bool,
    /// What the looked-up levels were multiplied by, by region.
    pub correction: Vec<f64>,
    /// What was measured at the canvas' size, by region.
    pub measured: Measured,
    /// The concentration that shows the marks as a share of the local peak, on the grid.
    pub marks: Field,
}

impl GrownLayer {
    /// The pattern at any size.
    #[must_use]
    pub fn pattern(&self) -> Pattern<'_> {
        let mut pattern = Pattern::new(&self.plan, &self.marks);
        pattern.correction.clone_from(&self.correction);
        pattern
    }
}

/// A grown texture.
pub struct Grown {
    /// Canvas, px.
    pub size: [u32; 2],
    /// Its layers, the lowest first.
    pub layers: Vec<GrownLayer>,
}

/// Why a document was not grown.
#[derive(Debug, thiserror::Error)]
pub enum GrowError {
    /// What was drawn cannot be grown.
    #[error(transparent)]
    Document(#[from] DocumentError),
    /// Its parameters could not be looked up.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// It does not fit into memory.
    #[error(transparent)]
    TooLarge(#[from] TooLarge),
    /// It was asked to stop.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// The marks beneath leave no place for any of its own.
    #[error(
        "layer {layer} finds no room: none of its marks fits between those of the layers beneath; draw smaller ones, or those beneath farther apart"
    )]
    NoRoom {
        /// 1 = the lowest.
        layer: usize,
    },
    /// The pattern left the range in which its system works.
    #[error(
        "layer {layer} grew no pattern: its concentrations are not finite; try another seed or larger marks"
    )]
    NoPattern {
        /// 1 = the lowest.
        layer: usize,
    },
}

/// Grows `document` (named `source` in messages).
///
/// # Errors
/// See [`GrowError`].
pub fn grow(
    document: &Document,
    source: &str,
    training: &Training,
    options: Options,
    watch: &Watch,
) -> Result<Grown, GrowError> {
    for (index, layer) in document.layers.iter().enumerate().skip(1) {
        if layer.after != After::Between {
            let place = format!("layers[{index}].after");
            let allowed = "\"between\"; the other ways to meet the marks beneath are not built yet";
            let found = format!("\"{}\"", layer.after.name());
            return Err(Problem::new(place, found, allowed).in_file(source).into());
        }
    }
    let size = options.size.unwrap_or(document.size);
    let correct = options.refine.unwrap_or(document.growth.refine);
    let mut layers: Vec<GrownLayer> = Vec::with_capacity(document.layers.len());
    for index in 0..document.layers.len() {
        watch.step(Stage::Plan, 0.0)?;
        let map = drawn::region_map(document, index, source)?.resized(size.map(f64::from));
        let mut plan = plan(training, document.layers[index].system, &map)?;
        memory::check(plan.system, size.map(f64::from), plan.grid)?;
        plan.seeding = document.layers[index].options.seeding;
        if correct && plan.seeding == Seeding::Noise {
            watch.step(Stage::Plan, 0.1)?;
            plan = plan.probed(training, When::Unsure, watch)?;
        }
        if index > 0 {
            let beneath: Vec<Pattern> = layers.iter().map(GrownLayer::pattern).collect();
            plan.taken = taken(&beneath, plan.grid);
        }
        if document.keeps(index) || plan.seeding == Seeding::Initiators {
            let marks = drawn::marks_on(document, index, source, size.map(f64::from))?;
            keep(&mut plan, &marks);
        }
        layers.push(grow_layer(plan, document.layer_seed(index), index + 1, correct, watch)?);
    }
    Ok(Grown { size, layers })
}

fn grow_layer(
    plan: Plan,
    seed: u64,
    layer: usize,
    correct: bool,
    watch: &Watch,
) -> Result<GrownLayer, GrowError> {
    watch.step(Stage::Plan, 0.5)?;
    let mut engine = Engine::new(&plan, seed);
    if !engine.begins() {
        return Err(GrowError::NoRoom { layer });
    }
    watch.step(Stage::Plan, 1.0)?;
    let settled = settle(&mut engine, watch)?;
    let marks = engine.marks();
    if !marks.values.iter().all(|value| value.is_finite()) {
        return Err(GrowError::NoPattern { layer });
    }
    let steps = engine.steps();
    drop(engine);
    let canvas = plan.map.layout().size.map(|side| side as usize);
    let mut pattern = Pattern::new(&plan, &marks);
    let measured = refine(&plan, &mut pattern, canvas, correct, watch)?;
    let correction = pattern.correction;
    Ok(GrownLayer { plan, steps, settled, correction, measured, marks })
}
