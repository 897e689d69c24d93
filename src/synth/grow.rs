//! Growing a document.

use super::engine::Engine;
use super::memory::TooLarge;
use super::painting::Look;
use super::pattern::Pattern;
use super::plan::{Plan, PlanError, plan};
use super::probe::{ProbeError, When};
use super::recipe::{Document, DocumentError, Problem};
use super::refine::{Measured, refine};
use super::settle::settle_seen;
use super::training::Training;
use super::watch::{Cancelled, Stage, Watch};
use super::{drawn, memory};
use crate::field::Field;

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
    grow_seen(document, source, training, options, watch, &mut |_| {})
}

/// The same for somebody who wants to have a look now and then, every few milliseconds; what comes out does not
/// depend on it.
///
/// # Errors
/// See [`GrowError`].
pub fn grow_seen(
    document: &Document,
    source: &str,
    training: &Training,
    options: Options,
    watch: &Watch,
    seen: &mut dyn FnMut(&Look),
) -> Result<Grown, GrowError> {
    if document.layers.len() > 1 {
        let found = format!("{} layers", document.layers.len());
        return Err(Problem::new("layers", found, "one layer; growing on top of others is not built yet")
            .in_file(source)
            .into());
    }
    let size = options.size.unwrap_or(document.size);
    let correct = options.refine.unwrap_or(document.growth.refine);
    let mut layers = Vec::with_capacity(document.layers.len());
    for index in 0..document.layers.len() {
        watch.step(Stage::Plan, 0.0)?;
        let map = drawn::region_map(document, index, source)?.resized(size.map(f64::from));
        let mut plan = plan(training, document.layers[index].system, &map)?;
        memory::check(plan.system, size.map(f64::from), plan.grid)?;
        if correct {
            watch.step(Stage::Plan, 0.1)?;
            plan = plan.probed(training, When::Unsure, watch)?;
        }
        let mut seen = |plan: &Plan, engine: &Engine| seen(&Look { beneath: &layers, plan, engine });
        let layer = grow_layer(plan, document.layer_seed(index), index + 1, correct, watch, &mut seen)?;
        layers.push(layer);
    }
    Ok(Grown { size, layers })
}

fn grow_layer(
    plan: Plan,
    seed: u64,
    layer: usize,
    correct: bool,
    watch: &Watch,
    seen: &mut dyn FnMut(&Plan, &Engine),
) -> Result<GrownLayer, GrowError> {
    watch.step(Stage::Plan, 0.5)?;
    let mut engine = Engine::new(&plan, seed);
    watch.step(Stage::Plan, 1.0)?;
    let settled = settle_seen(&mut engine, watch, &mut |engine| seen(&plan, engine))?;
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
