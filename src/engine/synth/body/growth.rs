//! The growth of a document on a model as a value: begun, advanced by a budget of vertex updates, completed or dropped.

use std::sync::Arc;

use crate::document::{Body, Document, DocumentError};
use crate::rd::{Operators, SurfaceGrowth, from_places};
use crate::surface::Surface;
use crate::synth::body::anchors::Asked;
use crate::synth::body::drawn_spacing::drawn_spacing;
use crate::synth::body::grown::GrownBody;
use crate::synth::body::laid::lay;
use crate::synth::body::needs;
use crate::synth::body::placed::Placed;
use crate::synth::body::plan::{self, BodyPlan};
use crate::synth::body::refusals::{self, system};
use crate::synth::body::remeshed::Remeshed;
use crate::synth::body::threshold::Levelled;
use crate::synth::error::{GrowError, LayerError};
use crate::synth::marks::grow::convergence::{ConvergenceMonitor, Verdict};
use crate::synth::options::Options;
use crate::synth::watch::Stage;

/// Vertex updates between two looks at whether the growth was cancelled: about 20 ms of one core.
const UPDATES: u64 = 3_000_000;

/// What a call of [`BodyGrowth::advance`] has done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BodyProgress {
    /// It still grows.
    Growing,
    /// The body has grown.
    Done,
}

/// The growth of a document on a model.
pub struct BodyGrowth<'a> {
    document: &'a Document,
    body: &'a Body,
    /// The bytes of the model's file; `None` of a built-in one.
    model: Option<&'a [u8]>,
    options: Options<'a>,
    /// Seconds of one core; see [`BodyGrowth::seconds`].
    seconds: Option<f64>,
    state: State,
}

/// What is done next.
enum State {
    /// The model and the sketch are read.
    Read,
    /// What the growth needs is compared with memory and time.
    Check(Box<(Placed, Asked)>),
    /// The model gets the cells on which spots grow.
    Remesh(Box<(Placed, Asked, Remeshed)>),
    /// What is wanted where, and parameters. The first surface is coarse, the second fine.
    Plan(Box<(Placed, Asked, [Surface; 2])>),
    /// Spots are laid.
    Lay(Box<(Placed, BodyPlan, Surface)>),
    /// They grow.
    Grow(Box<Growing>),
    /// They have grown.
    Level(Box<Growing>, bool),
    /// All is done.
    Done(Box<GrownBody>),
    /// It does not grow.
    Failed,
}

/// A pattern that grows.
struct Growing {
    placed: Placed,
    plan: BodyPlan,
    growth: SurfaceGrowth,
    monitor: ConvergenceMonitor,
    laid: usize,
}

impl<'a> BodyGrowth<'a> {
    /// Begins to grow a document that has a model. `model` are the bytes of its file.
    ///
    /// # Errors
    /// It has none, or asks for what does not grow on one.
    pub fn begin(
        document: &'a Document,
        model: Option<&'a [u8]>,
        options: &Options<'a>,
    ) -> Result<Self, DocumentError> {
        let body = refusals::check(document, options.source)?;
        Ok(Self { document, body, model, options: *options, seconds: None, state: State::Read })
    }

    /// Does about `budget` vertex updates of work, at least the least part of it.
    ///
    /// # Errors
    /// Why the document does not grow. The growth has then ended.
    pub fn advance(&mut self, budget: u64) -> Result<BodyProgress, GrowError> {
        let state = std::mem::replace(&mut self.state, State::Failed);
        let next = self.next(state, budget).map_err(|error| error.in_layer(self.options.source, 1))?;
        self.state = next;
        let done = matches!(self.state, State::Done(_) | State::Failed);
        Ok(if done { BodyProgress::Done } else { BodyProgress::Growing })
    }

    fn next(&mut self, state: State, budget: u64) -> Result<State, LayerError> {
        let Options { source, training, .. } = self.options;
        Ok(match state {
            State::Read => {
                let placed = Placed::read(self.body, self.model, source)?;
                let drawn = drawn_spacing(self.document, self.body, &placed, &self.options)?;
                let asked = Asked::read(self.document, self.body, &drawn, source, training)?;
                State::Check(Box::new((placed, asked)))
            }
            State::Check(read) => {
                let (placed, asked) = *read;
                let cell = plan::cell(&asked, training)?;
                needs::check(placed.mesh.area(), cell, &self.options)?;
                self.seconds = Some(needs::seconds(needs::vertices(placed.mesh.area(), cell)));
                let remeshed = Remeshed::begin(&placed, cell);
                State::Remesh(Box::new((placed, asked, remeshed)))
            }
            State::Remesh(mut remesh) => {
                if remesh.2.advance() {
                    return Ok(State::Remesh(remesh));
                }
                let (placed, asked, remeshed) = *remesh;
                State::Plan(Box::new((placed, asked, remeshed.surfaces(self.body))))
            }
            State::Plan(read) => {
                let (placed, asked, [coarse, fine]) = *read;
                let plan = BodyPlan::new(self.document, self.body, &asked, &placed, fine, training)?;
                State::Lay(Box::new((placed, plan, coarse)))
            }
            State::Lay(planned) => {
                let (placed, plan, coarse) = *planned;
                State::Grow(Box::new(self.lay(placed, plan, coarse)?))
            }
            State::Grow(growing) => grow(growing, budget),
            State::Level(growing, settled) => State::Done(Box::new(self.level(*growing, settled)?)),
            ended @ (State::Done(_) | State::Failed) => ended,
        })
    }

    /// Lays spots on the surface.
    fn lay(&self, placed: Placed, plan: BodyPlan, coarse: Surface) -> Result<Growing, LayerError> {
        let maps = &plan.maps;
        let places = lay(maps, coarse, self.document.layer_seed(0));
        let concentrations = from_places(system(), maps, &places, &|_| false);
        let surface = plan.surface();
        let operators = Operators::new(system(), &surface.mesh, surface.frames(), &maps.parameters);
        let growth = SurfaceGrowth::new(system(), maps, Arc::new(operators), &concentrations);
        let growth = growth.ok_or(LayerError::NoRoom)?;
        let unit = growth.steps_in(1.0) as f64;
        let monitor = ConvergenceMonitor::new(system(), unit, true, growth.marks());
        let laid = places.len();
        Ok(Growing { placed, plan, growth, monitor, laid })
    }

    /// Makes the pattern of what has grown.
    fn level(&self, growing: Growing, settled: bool) -> Result<GrownBody, LayerError> {
        let Growing { placed, plan, growth, laid, .. } = growing;
        let marks = growth.marks();
        if marks.iter().any(|mark| !mark.is_finite()) {
            return Err(LayerError::NoPattern);
        }
        let corrects = self.options.refine.unwrap_or(self.document.growth.refine);
        let levelled = Levelled::new(&plan, &marks, corrects);
        if levelled.measured.spots.is_empty() {
            return Err(LayerError::Blank { what: "nothing", advice: LayerError::MARKS });
        }
        let document = self.document.clone();
        Ok(GrownBody { document, placed, plan, levelled, laid, steps: growth.steps(), settled })
    }

    /// What is being done, and the share of it that is done, 0..1.
    #[must_use]
    pub fn progress(&self) -> (Stage, f64) {
        match &self.state {
            State::Read => (Stage::Plan, 0.0),
            State::Check(_) => (Stage::Plan, 0.05),
            State::Remesh(remesh) => (Stage::Plan, 0.1 + 0.5 * remesh.2.share()),
            State::Plan(_) => (Stage::Plan, 0.6),
            State::Lay(_) => (Stage::Plan, 0.8),
            State::Grow(growing) => {
                let expected = ConvergenceMonitor::expected(system(), growing.monitor.unit(), true);
                (Stage::Grow, (growing.growth.steps() as f64 / expected).min(1.0))
            }
            State::Level(..) => (Stage::Refine, 0.5),
            State::Done(_) | State::Failed => (Stage::Refine, 1.0),
        }
    }

    /// Seconds of one core that the growth takes, about; `None` before the model is read and found to fit into memory and time.
    #[must_use]
    pub fn seconds(&self) -> Option<f64> {
        self.seconds
    }

    /// What has grown; `None` while it still grows, and where it does not grow.
    #[must_use]
    pub fn complete(self) -> Option<GrownBody> {
        if let State::Done(grown) = self.state { Some(*grown) } else { None }
    }

    /// Grows until all is done, and tells the watch of the options in between.
    ///
    /// # Errors
    /// Why the document does not grow; or it was cancelled.
    pub fn run(mut self) -> Result<GrownBody, GrowError> {
        let watch = self.options.watch;
        rayon::scope(|_| {
            loop {
                let (stage, share) = self.progress();
                watch.step(stage, share)?;
                if self.advance(UPDATES)? == BodyProgress::Done {
                    return Ok::<(), GrowError>(());
                }
            }
        })?;
        Ok(self.complete().expect("it has grown"))
    }
}

/// Takes steps of about `budget` updates, no farther than to the next check whether the pattern has settled.
fn grow(mut growing: Box<Growing>, budget: u64) -> State {
    let vertices = growing.plan.maps.parameters.len();
    let Growing { growth, monitor, .. } = &mut *growing;
    let until_check = monitor.next_check().saturating_sub(growth.steps()).max(1);
    growth.advance((budget / vertices.max(1) as u64).clamp(1, until_check));
    if growth.steps() < monitor.next_check() {
        return State::Grow(growing);
    }
    let all = vec![true; vertices];
    let verdict = monitor.check(growth.steps(), |marks| growth.update_marks(marks, &all));
    match verdict {
        Verdict::Forming => State::Grow(growing),
        Verdict::Settled => State::Level(growing, true),
        Verdict::GivenUp => State::Level(growing, false),
    }
}
