//! The operations of every kind of layer.
//!
//! ```text
//!  document ──read──▶ Plan ──begin──▶ Growth ──advance…──▶ ──complete──▶ Grown
//!                     bytes, seconds,  seen, progress                     pattern, report
//!                     trial, describe, preview
//! ```
//!
//! A kind is a folder of this room with one implementation of [`Kind`], and one line in the list of [`crate::synth::layer`].

mod described;
mod trial;

pub use described::{Described, in_words};
pub use trial::{Trial, Work};

use std::any::Any;

use crate::attributes::system::Description;
use crate::document::Document;
use crate::grid::{Field, Grid};
use crate::synth::error::LayerError;
use crate::synth::passes::PassSet;
use crate::synth::pattern::{AreaPattern, LayerPattern};
use crate::synth::report::{DrawnMark, LayerReport};
use crate::synth::training::Training;
use crate::synth::watch::Stage;

/// Number of moments of a film in which the points of a layer appear. In a usual film more than half of the frames show a new one.
pub const FILM_STAGES: usize = 48;

/// A layer to be planned.
#[derive(Clone, Copy)]
pub struct Request<'a> {
    /// The document.
    pub document: &'a Document,
    /// The index of the layer.
    pub index: usize,
    /// The name of the document in messages, such as its path.
    pub source: &'a str,
    /// The canvas that is grown, px.
    pub size: [f64; 2],
    /// Training sets in which parameters are looked up.
    pub training: &'a Training,
    /// Bytes of memory that may be used; `None` = no limit.
    pub memory: Option<f64>,
    /// The layer beneath, of any kind: its plan, or the grown layer.
    pub beneath: Option<&'a dyn Any>,
}

/// Settings for the growth of a layer.
#[derive(Clone, Copy)]
pub struct Setting<'a> {
    /// Seed of all random numbers.
    pub seed: u64,
    /// The name of the document in messages, such as its path.
    pub source: &'a str,
    /// Training sets in which parameters are looked up.
    pub training: &'a Training,
    /// Bytes of memory that may be used; `None` = no limit.
    pub memory: Option<f64>,
    /// Whether the pattern is corrected.
    pub corrects: bool,
    /// Passes that are left out.
    pub without: PassSet,
    /// Whether the concentrations of all chemicals are kept.
    pub concentrations: bool,
    /// Whether the growth is filmed: points then appear one after the other.
    pub filmed: bool,
}

/// The grown layers beneath a layer.
pub struct Beneath<'a> {
    /// The document.
    pub document: &'a Document,
    /// The layers beneath, the lowest first.
    pub layers: Vec<&'a dyn GrownBeneath>,
}

/// A grown layer beneath another one, in the form that every kind of layer can use.
pub trait GrownBeneath: Sync {
    /// Its pattern.
    fn pattern(&self) -> LayerPattern<'_>;

    /// Cells along x and y of the grid that it grew on.
    fn grid(&self) -> [usize; 2];

    /// The grown layer, for a layer that tests whether it is of its own kind.
    fn grown(&self) -> &dyn Any;
}

/// The result of a call of [`Kind::advance`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Advanced {
    /// The work, in cell updates; planning and measuring count about as much as they take.
    pub updates: u64,
    /// Whether the picture has changed.
    pub seen: bool,
    /// Whether the layer can be completed.
    pub done: bool,
}

impl Advanced {
    /// Work that does not change the picture.
    #[must_use]
    pub fn by(updates: usize) -> Self {
        Self { updates: updates as u64, ..Self::default() }
    }

    /// Steps that change the picture.
    #[must_use]
    pub fn seen(updates: u64) -> Self {
        Self { updates, seen: true, done: false }
    }

    /// Work that completes the layer.
    #[must_use]
    pub fn done(updates: usize) -> Self {
        Self { updates: updates as u64, seen: false, done: true }
    }
}

/// A layer at one moment of its growth.
pub struct Seen<'a> {
    /// Steps that it has taken; fewer than before if it has begun again.
    pub steps: u64,
    /// Cells along x and y of the current grid.
    pub grid: [usize; 2],
    /// Width and height of the canvas, px.
    pub canvas: [f64; 2],
    /// Makes its pattern.
    pub pattern: Box<dyn Fn() -> LayerPattern<'a> + 'a>,
}

impl<'a> Seen<'a> {
    /// A field that is above ½ inside areas, after this number of steps.
    #[must_use]
    pub fn of_areas(steps: u64, field: &'a Field) -> Self {
        Self {
            steps,
            grid: [field.width, field.height],
            canvas: field.extent(),
            pattern: Box::new(move || Box::new(AreaPattern::new(field))),
        }
    }
}

/// The common part of the plans of all kinds of layers.
#[derive(Clone, Copy)]
pub struct Planned {
    /// The system that grows the layer.
    pub system: &'static Description,
    /// The grid over the canvas, px.
    pub grid: Grid,
}

/// The end of a growth, in the common form of all kinds of layers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Ending {
    /// Steps taken; none for kinds without reactions.
    pub steps: u64,
    /// Whether the pattern settled within its time.
    pub settled: bool,
}

/// A kind of layer.
pub trait Kind {
    /// The plan of the growth. It does not change during the growth.
    type Plan: Clone + Send + Sync + 'static;
    /// A layer that grows.
    type Growth<'a>: Send;
    /// The type of a grown layer.
    type Grown: Clone + Send + Sync + 'static;

    /// Whether a smaller canvas of the same texture takes the same time a px, so that a growth can be timed there.
    const SCALES: bool = true;

    /// Whether layer `index` of `document` is of this kind.
    fn takes(document: &Document, index: usize) -> bool;

    /// Plans a layer. Because of memory only a layer that is too large to be planned is refused; see [`Kind::bytes`].
    ///
    /// # Errors
    /// It cannot be grown: file, place, value, what is allowed; or a training set cannot be read.
    fn read(request: &Request) -> Result<Self::Plan, LayerError>;

    /// The common part of a plan.
    fn planned(plan: &Self::Plan) -> Planned;

    /// Whether the layer grows as planned, independently of the layers beneath it.
    fn is_final(_plan: &Self::Plan) -> bool {
        true
    }

    /// Bytes of memory that it needs on a grid of this number of cells for a canvas of `size` px.
    fn bytes(plan: &Self::Plan, size: [f64; 2], grid: [usize; 2]) -> f64;

    /// Seconds that it takes on one core, by laws; equal on all machines.
    fn seconds(plan: &Self::Plan) -> f64;

    /// A part of the growth for measuring its speed, with the amount of work; `None` if there is no room to begin.
    fn trial(plan: &Self::Plan, seed: u64) -> Option<Trial>;

    /// The output of `check` for a plan; `notes` are those of every kind of layer, such as that it does not fit into memory.
    fn describe(plan: &Self::Plan, request: &Request, notes: Vec<String>) -> Described;

    /// A rough first picture of the growth above the layers `beneath`, available at once; `None` if the growth shows its own
    /// picture as soon.
    fn preview(_plan: &Self::Plan, _beneath: &Beneath, _seed: u64) -> Option<Box<dyn Previewed>> {
        None
    }

    /// The reason why no film can show how such a layer becomes another one; `None` if one can.
    fn no_morph(document: &Document, index: usize) -> Option<String>;

    /// Begins the growth above the grown layers `beneath`.
    ///
    /// # Errors
    /// There is no room.
    fn begin<'a>(
        plan: Self::Plan,
        beneath: &Beneath,
        setting: Setting<'a>,
    ) -> Result<Self::Growth<'a>, LayerError>;

    /// Does about `budget` cell updates of work, at least the smallest part of it. The result does not depend on the budgets.
    ///
    /// # Errors
    /// Why the layer does not grow.
    fn advance(growth: &mut Self::Growth<'_>, budget: u64) -> Result<Advanced, LayerError>;

    /// The current stage of the work, and the share of it that is done, 0..1.
    fn progress(growth: &Self::Growth<'_>) -> (Stage, f64);

    /// Cell updates of `time` of normalised time on the current grid; 1, the smallest part of the work, while the layer is planned
    /// or measured.
    fn updates_in(growth: &Self::Growth<'_>, time: f64) -> u64;

    /// The current state of the layer; `None` while it is planned or measured.
    fn seen<'s>(growth: &'s Self::Growth<'_>) -> Option<Seen<'s>>;

    /// The drawn marks without room, as far as they are known.
    fn left_out(_growth: &Self::Growth<'_>) -> Vec<DrawnMark> {
        Vec::new()
    }

    /// The grown layer; `None` before [`Advanced::done`].
    fn complete(growth: Self::Growth<'_>) -> Option<Self::Grown>;

    /// The common part of the plan from which it grew.
    fn planned_of(grown: &Self::Grown) -> Planned;

    /// The way in which the growth ended.
    fn ending(grown: &Self::Grown) -> Ending;

    /// The pattern at any size, without the parts that pass under stripes that it crosses.
    fn pattern(grown: &Self::Grown) -> LayerPattern<'_>;

    /// For each drawn mark, how it has grown.
    fn drawn(_grown: &Self::Grown) -> Vec<DrawnMark> {
        Vec::new()
    }

    /// The drawn marks that found no room.
    fn left_out_of(_grown: &Self::Grown) -> Vec<DrawnMark> {
        Vec::new()
    }

    /// Fills in the particulars of this kind in the report of layer `index`, which holds the drawn marks already.
    fn report(grown: &Self::Grown, document: &Document, index: usize, report: &mut LayerReport);

    /// The advice for a layer with nothing but marks (`full`), or with none.
    fn advice(_grown: &Self::Grown, _full: bool) -> &'static str {
        LayerError::MARKS
    }

    /// The concentration of each chemical by its letter, where they were kept.
    fn chemicals(_grown: &Self::Grown) -> Vec<(String, Field)> {
        Vec::new()
    }
}

/// A rough picture of a layer before it grows.
pub trait Previewed: Send {
    /// The picture.
    fn seen(&self) -> Seen<'_>;
}

/// A field that is above ½ inside areas.
impl Previewed for Field {
    fn seen(&self) -> Seen<'_> {
        Seen::of_areas(0, self)
    }
}
