//! The growth of a document on a model as a value: begun, advanced by a budget of vertex updates, completed or dropped.

use std::sync::Arc;

use crate::document::{After, Body, Document, DocumentError, RaggedChoice};
use crate::rd::{Operators, SurfaceGrowth};
use crate::surface::Surface;
use crate::synth::body::asked::Asked;
use crate::synth::body::begin::{Initial, begin};
use crate::synth::body::beneath::{covering, obstacles, raise_beside_obstacles};
use crate::synth::body::curves::widths;
use crate::synth::body::drawn_spacing::drawn_spacing;
use crate::synth::body::grown::GrownBody;
use crate::synth::body::layer::BodyLayer;
use crate::synth::body::needs;
use crate::synth::body::pair_stripes::{GrownPairStripes, PairStripesGrowth};
use crate::synth::body::placed::Placed;
use crate::synth::body::plan::{self, BodyPlan};
use crate::synth::body::ragged::roughened;
use crate::synth::body::refusals;
use crate::synth::body::remeshed::Remeshed;
use crate::synth::body::threshold::Levelled;
use crate::synth::error::{GrowError, LayerError};
use crate::synth::marks::grow::convergence::{ConvergenceMonitor, Verdict};
use crate::synth::options::Options;
use crate::synth::report::PointsReport;
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
    Check(Box<Model>),
    /// The model gets the cells on which the next layer grows.
    Remesh(Box<Model>, Box<Remeshed>),
    /// What is wanted where, and parameters. The first surface is coarse, the second fine.
    Plan(Box<Model>, Box<[Surface; 2]>),
    /// The layer gets its initial concentrations.
    Begin(Box<Model>, Box<BodyPlan>, Box<Surface>),
    /// It grows.
    Grow(Box<Model>, Box<Growing>),
    /// Stripes with tips grow.
    Pair(Box<Model>, Box<PairStripesGrowth>),
    /// It has grown.
    Level(Box<Model>, Box<Growing>, bool),
    /// All is done.
    Done(Box<GrownBody>),
    /// It does not grow.
    Failed,
}

/// The model, what is asked for on it, and what has grown.
struct Model {
    placed: Placed,
    /// One a layer.
    asked: Vec<Asked>,
    /// px a cell, one a layer.
    cells: Vec<f64>,
    layers: Vec<BodyLayer>,
}

/// A pattern that grows.
struct Growing {
    plan: BodyPlan,
    growth: SurfaceGrowth,
    monitor: ConvergenceMonitor,
    laid: usize,
}

/// A pattern that has formed.
struct Formed {
    plan: BodyPlan,
    /// How much of a mark each vertex shows.
    marks: Vec<f32>,
    laid: usize,
    points: Option<PointsReport>,
    steps: u64,
    settled: bool,
}

impl Formed {
    /// Marks that have formed by themselves and settled.
    fn new(plan: BodyPlan, marks: Vec<f32>, steps: u64) -> Self {
        Self { plan, marks, laid: 0, points: None, steps, settled: true }
    }
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
        let layer = 1 + state.layer();
        let next = self.next(state, budget).map_err(|error| error.in_layer(self.options.source, layer))?;
        self.state = next;
        let done = matches!(self.state, State::Done(_) | State::Failed);
        Ok(if done { BodyProgress::Done } else { BodyProgress::Growing })
    }

    fn next(&mut self, state: State, budget: u64) -> Result<State, LayerError> {
        Ok(match state {
            State::Read => State::Check(Box::new(self.read()?)),
            State::Check(model) => {
                let area = model.placed.mesh.area();
                let finish = self.document.finish.as_ref().map(|finishing| finishing.finish);
                needs::check(area, &model.cells, finish, &self.options)?;
                self.seconds = Some(needs::seconds(needs::vertices(area, &model.cells)));
                remesh(model)
            }
            State::Remesh(model, mut remeshed) => {
                if remeshed.advance() {
                    return Ok(State::Remesh(model, remeshed));
                }
                State::Plan(model, Box::new(remeshed.surfaces(self.body)))
            }
            State::Plan(model, surfaces) => {
                let [coarse, fine] = *surfaces;
                let plan = self.plan(&model, fine)?;
                State::Begin(model, Box::new(plan), Box::new(coarse))
            }
            State::Begin(model, plan, coarse) => self.begin_layer(model, *plan, &coarse)?,
            State::Grow(model, growing) => grow(model, growing, budget),
            State::Pair(model, mut stripes) => {
                if !stripes.advance(budget)? {
                    return Ok(State::Pair(model, stripes));
                }
                let GrownPairStripes { plan, marks, steps } =
                    stripes.complete().ok_or(LayerError::NoPattern)?;
                self.next_layer(model, Formed::new(plan, marks, steps))?
            }
            State::Level(model, growing, settled) => {
                let Growing { plan, growth, laid, .. } = *growing;
                let (marks, steps) = (growth.marks(), growth.steps());
                let formed = Formed { laid, settled, ..Formed::new(plan, marks, steps) };
                self.next_layer(model, formed)?
            }
            ended @ (State::Done(_) | State::Failed) => ended,
        })
    }

    /// Reads the model, and what each layer asks for.
    fn read(&self) -> Result<Model, LayerError> {
        let Options { source, training, .. } = self.options;
        let placed = Placed::read(self.body, self.model, source)?.with_coordinates(self.document, source)?;
        let asked = asked_of_all(self.document, self.body, &placed, &self.options)?;
        let cells =
            asked.iter().map(|asked| plan::cell(self.document, asked, training)).collect::<Result<_, _>>()?;
        Ok(Model { placed, asked, cells, layers: Vec::new() })
    }

    /// Plans the next layer on its surface.
    fn plan(&self, model: &Model, surface: Surface) -> Result<BodyPlan, LayerError> {
        let asked = &model.asked[model.layers.len()];
        let training = self.options.training;
        let plan = BodyPlan::new(self.document, self.body, asked, &model.placed, surface, training)?;
        let covering = covering(self.document, &model.layers);
        let taken = obstacles(covering, plan.surface(), &asked.choice);
        plan.among(self.document, taken)
    }

    /// Begins to grow a planned layer. One of areas is then formed.
    fn begin_layer(
        &self,
        model: Box<Model>,
        mut plan: BodyPlan,
        coarse: &Surface,
    ) -> Result<State, LayerError> {
        if let Some(form) = model.asked[model.layers.len()].pair.clone() {
            let corrects = self.corrects();
            let stripes = PairStripesGrowth::begin(self.document, &model.placed, plan, form, corrects)?;
            return Ok(State::Pair(model, Box::new(stripes)));
        }
        let Initial { mut concentrations, laid, points } =
            begin(self.document, &model.placed, &mut plan, coarse, &model.layers)?;
        if plan.choice.areas.is_some() {
            let marks = concentrations.swap_remove(0);
            return self.next_layer(model, Formed { laid, points, ..Formed::new(plan, marks, 0) });
        }
        let system = plan.choice.system;
        let irregular = self.document.layers[plan.layer].options.irregular;
        plan.maps = plan.maps.with_decay_noise(system, irregular, self.document.layer_seed(plan.layer));
        let surface = plan.surface();
        let operators = Operators::new(system, &surface.mesh, surface.frames(), &plan.maps.parameters);
        let growth = SurfaceGrowth::new(system, &plan.maps, Arc::new(operators), &concentrations);
        let growth = growth.ok_or(LayerError::NoRoom)?;
        let unit = growth.steps_in(1.0) as f64;
        let monitor = ConvergenceMonitor::new(system, unit, true, growth.marks());
        Ok(State::Grow(model, Box::new(Growing { plan, growth, monitor, laid })))
    }

    /// Adds what has formed to the layers, and goes on to the next one, if there is one.
    fn next_layer(&self, mut model: Box<Model>, formed: Formed) -> Result<State, LayerError> {
        model.layers.push(self.level(formed)?);
        if model.layers.len() < model.asked.len() {
            return Ok(remesh(model));
        }
        let Model { placed, layers, .. } = *model;
        Ok(State::Done(Box::new(GrownBody { document: self.document.clone(), placed, layers })))
    }

    /// Makes the pattern of what has formed.
    fn level(&self, formed: Formed) -> Result<BodyLayer, LayerError> {
        let Formed { mut plan, mut marks, laid, points, steps, settled } = formed;
        if marks.iter().any(|mark| !mark.is_finite()) {
            return Err(LayerError::NoPattern);
        }
        raise_beside_obstacles(&plan, &mut marks);
        if let Some(curves) = &plan.curves {
            let width = widths(&plan.wanted).into_iter().fold(f64::INFINITY, f64::min);
            marks = curves.levelled(plan.surface(), &marks, width);
        }
        // The share of points is right already.
        let corrects = self.corrects() && points.is_none();
        let mut levelled = Levelled::new(&plan, &marks, corrects);
        if let (RaggedChoice::Given(sigma), None) =
            (self.document.layers[plan.layer].options.ragged, plan.choice.areas)
        {
            let seed = self.document.layer_seed(plan.layer);
            levelled = roughened(&mut plan, levelled, sigma, seed, corrects);
        }
        let measured = &levelled.measured;
        let is_bare =
            measured.spots.is_empty() && measured.stripes.iter().all(|stripes| stripes.contour == 0.0);
        if is_bare && points.is_none() {
            return Err(LayerError::Blank { what: "nothing", advice: LayerError::MARKS });
        }
        Ok(BodyLayer { plan, levelled, laid, points, steps, settled })
    }

    /// Whether levels are corrected.
    fn corrects(&self) -> bool {
        self.options.refine.unwrap_or(self.document.growth.refine)
    }

    /// What is being done, and the share of it that is done, 0..1.
    #[must_use]
    pub fn progress(&self) -> (Stage, f64) {
        // Within the layer, and the layers before it.
        let within = |model: &Model, stage: Stage, share: f64| {
            let layers = model.asked.len().max(1) as f64;
            (stage, (model.layers.len() as f64 + share) / layers)
        };
        match &self.state {
            State::Read => (Stage::Plan, 0.0),
            State::Check(model) => within(model, Stage::Plan, 0.0),
            State::Remesh(model, remeshed) => within(model, Stage::Plan, 0.25 * remeshed.share()),
            State::Plan(model, _) => within(model, Stage::Plan, 0.25),
            State::Begin(model, ..) => within(model, Stage::Plan, 0.4),
            State::Grow(model, growing) => {
                let (system, unit) = (growing.plan.choice.system, growing.monitor.unit());
                let expected = ConvergenceMonitor::expected(system, unit, true);
                let share = (growing.growth.steps() as f64 / expected).min(1.0);
                within(model, Stage::Grow, 0.5 + 0.45 * share)
            }
            State::Pair(model, stripes) => within(model, Stage::Grow, 0.5 + 0.45 * stripes.share()),
            State::Level(model, ..) => within(model, Stage::Refine, 0.95),
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

impl State {
    /// The index of the layer that is worked on.
    fn layer(&self) -> usize {
        match self {
            Self::Read | Self::Done(_) | Self::Failed => 0,
            Self::Check(model) | Self::Remesh(model, _) | Self::Plan(model, _) => model.layers.len(),
            Self::Begin(model, ..) | Self::Grow(model, _) | Self::Level(model, ..) => model.layers.len(),
            Self::Pair(model, _) => model.layers.len(),
        }
    }
}

/// What each layer of a document asks for on a model.
///
/// # Errors
/// Why one of them cannot be read.
pub fn asked_of_all(
    document: &Document,
    body: &Body,
    placed: &Placed,
    options: &Options,
) -> Result<Vec<Asked>, LayerError> {
    let mut all: Vec<Asked> = Vec::new();
    for index in 0..document.layers.len() {
        let drawn = drawn_spacing(document, index, body, placed, options)?;
        let asked = Asked::read(document, index, body, &drawn, options.source, options.training)?;
        all.push(match all.last() {
            Some(outer) if document.layers[index].after == After::Inside => asked.spaced_as(outer),
            _ => asked,
        });
    }
    Ok(all)
}

/// Begins to give the model the cells of the next layer.
fn remesh(model: Box<Model>) -> State {
    let remeshed = Remeshed::begin(&model.placed, model.cells[model.layers.len()]);
    State::Remesh(model, Box::new(remeshed))
}

/// Takes steps of about `budget` updates, no farther than to the next check whether the pattern has settled.
fn grow(model: Box<Model>, mut growing: Box<Growing>, budget: u64) -> State {
    let vertices = growing.plan.maps.parameters.len();
    let Growing { growth, monitor, .. } = &mut *growing;
    let until_check = monitor.next_check().saturating_sub(growth.steps()).max(1);
    growth.advance((budget / vertices.max(1) as u64).clamp(1, until_check));
    if growth.steps() < monitor.next_check() {
        return State::Grow(model, growing);
    }
    let all = vec![true; vertices];
    let verdict = monitor.check(growth.steps(), |marks| growth.update_marks(marks, &all));
    match verdict {
        Verdict::Forming => State::Grow(model, growing),
        Verdict::Settled => State::Level(model, growing, true),
        Verdict::GivenUp => State::Level(model, growing, false),
    }
}
