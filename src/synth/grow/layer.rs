//! Growing a document.

use crate::document::{Document, DocumentError};
use crate::grid::Field;
use crate::synth::grow::convergence::settle_every;
use crate::synth::grow::engine::Engine;
use crate::synth::grow::probe::ProbeError;
use crate::synth::grow::refine::{Measured, refine};
use crate::synth::memory::TooLarge;
use crate::synth::options::Settings;
use crate::synth::plan::offset_curves::CourseError;
use crate::synth::plan::{Plan, PlanError};
use crate::synth::render::pattern::Pattern;
use crate::synth::watch::{Cancelled, Stage, Watch};

impl From<ProbeError> for GrowError {
    fn from(error: ProbeError) -> Self {
        match error {
            ProbeError::Plan(error) => Self::Plan(error),
            ProbeError::Cancelled(cancelled) => Self::Cancelled(cancelled),
        }
    }
}

/// A grown layer.
#[derive(Clone)]
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
    /// The concentrations of each chemical on the grid, where the [`Options`](crate::synth::Options) asked for them.
    pub concentrations: Vec<Vec<f32>>,
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
    /// What it was grown from.
    pub document: Document,
    /// And how.
    pub settings: Settings,
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
    /// Rings or a web find nothing to go round, or no room.
    #[error("layer {layer} cannot be grown: {reason}")]
    Course {
        /// 1 = the lowest.
        layer: usize,
        /// Why.
        reason: CourseError,
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

/// Grows layer number `layer` of a document as planned, seen each `every` of normalised time; what has grown is corrected
/// or not, concentrations kept or not.
pub(crate) fn grow_layer(
    plan: Plan,
    seed: u64,
    layer: usize,
    [correct, concentrations]: [bool; 2],
    watch: &Watch,
    every: Option<f64>,
    seen: &mut dyn FnMut(&Plan, &Engine),
) -> Result<GrownLayer, GrowError> {
    watch.step(Stage::Plan, 0.5)?;
    let mut engine = Engine::new(&plan, seed);
    if !engine.begins() {
        return Err(GrowError::NoRoom { layer });
    }
    watch.step(Stage::Plan, 1.0)?;
    let settled = settle_every(&mut engine, every, watch, &mut |engine| seen(&plan, engine))?;
    let marks = plan.levelled(engine.marks());
    if !marks.values.iter().all(|value| value.is_finite()) {
        return Err(GrowError::NoPattern { layer });
    }
    let steps = engine.steps();
    let concentrations = if concentrations { engine.concentrations() } else { Vec::new() };
    drop(engine);
    let canvas = plan.map.layout().size.map(|side| side as usize);
    let mut pattern = Pattern::new(&plan, &marks);
    let measured = refine(&plan, &mut pattern, canvas, correct, watch)?;
    let correction = pattern.correction;
    Ok(GrownLayer { plan, steps, settled, correction, measured, marks, concentrations })
}
