//! What every kind of layer can do.
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

/// Moments of a film in which the points of a layer appear: more than half of the frames of a usual film show one each.
pub const FILM_STAGES: usize = 48;

/// A layer to be planned.
#[derive(Clone, Copy)]
pub struct Request<'a> {
    /// The document.
    pub document: &'a Document,
    /// The index of the layer.
    pub index: usize,
    /// What messages call the document, such as its path.
    pub source: &'a str,
    /// The canvas that is grown, px.
    pub size: [f64; 2],
    /// Where parameters are looked up.
    pub training: &'a Training,
    /// Bytes of memory that may be used; `None` = no limit.
    pub memory: Option<f64>,
    /// The layer beneath, of whatever kind: its plan, or what has grown from it.
    pub beneath: Option<&'a dyn Any>,
}

/// How a layer is grown.
#[derive(Clone, Copy)]
pub struct Setting<'a> {
    /// Seed of all that is random.
    pub seed: u64,
    /// What messages call the document, such as its path.
    pub source: &'a str,
    /// Where parameters are looked up.
    pub training: &'a Training,
    /// Bytes of memory that may be used; `None` = no limit.
    pub memory: Option<f64>,
    /// Whether what grows is corrected.
    pub corrects: bool,
    /// Passes that are left out.
    pub without: PassSet,
    /// Whether the concentrations of all chemicals are kept.
    pub concentrations: bool,
    /// Whether the growth is filmed: points then appear one after the other.
    pub filmed: bool,
}

/// What has grown beneath a layer.
pub struct Beneath<'a> {
    /// The document.
    pub document: &'a Document,
    /// The layers beneath, the lowest first.
    pub layers: Vec<&'a dyn GrownBeneath>,
}

/// A layer that has grown beneath another one, as any kind of layer sees it.
pub trait GrownBeneath: Sync {
    /// Its pattern.
    fn pattern(&self) -> LayerPattern<'_>;

    /// Cells along x and y of the grid that it grew on.
    fn grid(&self) -> [usize; 2];

    /// What has grown, for a layer that asks whether it is of its own kind.
    fn grown(&self) -> &dyn Any;
}

/// What a call of [`Kind::advance`] has done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Advanced {
    /// The work, in cell updates; planning and measuring count about as much as they take.
    pub updates: u64,
    /// Whether there is something new to see.
    pub seen: bool,
    /// Whether the layer can be completed.
    pub done: bool,
}

impl Advanced {
    /// Work after which nothing new is to be seen.
    #[must_use]
    pub fn by(updates: usize) -> Self {
        Self { updates: updates as u64, ..Self::default() }
    }

    /// Steps after which there is something new to see.
    #[must_use]
    pub fn seen(updates: u64) -> Self {
        Self { updates, seen: true, done: false }
    }

    /// Work after which the layer can be completed.
    #[must_use]
    pub fn done(updates: usize) -> Self {
        Self { updates: updates as u64, seen: false, done: true }
    }
}

/// A layer at one moment of its growth.
pub struct Seen<'a> {
    /// Steps that it has taken. Fewer than before: it has begun again.
    pub steps: u64,
    /// Cells along x and y of the current grid.
    pub grid: [usize; 2],
    /// Width and height of the canvas, px.
    pub canvas: [f64; 2],
    /// Makes its pattern.
    pub pattern: Box<dyn Fn() -> LayerPattern<'a> + 'a>,
}

impl<'a> Seen<'a> {
    /// A field that is above ½ in areas, after so many steps.
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

/// A plan, as any kind of layer has it.
#[derive(Clone, Copy)]
pub struct Planned {
    /// The system that grows the layer.
    pub system: &'static Description,
    /// The grid over the canvas, px.
    pub grid: Grid,
}

/// The end of a growth, as any kind of layer has it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Ending {
    /// Steps taken; none where nothing reacts.
    pub steps: u64,
    /// Whether the pattern settled within its time.
    pub settled: bool,
}

/// A kind of layer.
pub trait Kind {
    /// What will be grown. It does not change while it grows.
    type Plan: Clone + Send + Sync + 'static;
    /// A layer that grows.
    type Growth<'a>: Send;
    /// What has grown.
    type Grown: Clone + Send + Sync + 'static;

    /// Whether a smaller canvas of the same texture takes the same time a px, so that a growth can be timed there.
    const SCALES: bool = true;

    /// Whether layer `index` of `document` is of this kind.
    fn takes(document: &Document, index: usize) -> bool;

    /// Plans a layer. Only what is too large to be planned is refused because of its memory; see [`Kind::bytes`].
    ///
    /// # Errors
    /// It cannot be grown: file, place, value, what is allowed; or a training set cannot be read.
    fn read(request: &Request) -> Result<Self::Plan, LayerError>;

    /// What all plans have.
    fn planned(plan: &Self::Plan) -> Planned;

    /// Whether it grows as planned whatever grows beneath it.
    fn is_final(_plan: &Self::Plan) -> bool {
        true
    }

    /// Bytes of memory that it needs on a grid of so many cells for a canvas of `size` px.
    fn bytes(plan: &Self::Plan, size: [f64; 2], grid: [usize; 2]) -> f64;

    /// Seconds that it takes on one core, by laws: the same on every machine.
    fn seconds(plan: &Self::Plan) -> f64;

    /// Something to measure the time of: how much work it is, and a part of it. `None` where there is no room to begin.
    fn trial(plan: &Self::Plan, seed: u64) -> Option<Trial>;

    /// What `check` says of a plan; `notes` are those of every kind of layer, such as that it does not fit into memory.
    fn describe(plan: &Self::Plan, request: &Request, notes: Vec<String>) -> Described;

    /// A rough first picture, at once, of what grows above the layers `beneath`; `None` where the growth shows its own as soon.
    fn preview(_plan: &Self::Plan, _beneath: &Beneath, _seed: u64) -> Option<Box<dyn Previewed>> {
        None
    }

    /// Why no film can show how such a layer becomes another one; `None` where one can.
    fn no_morph(document: &Document, index: usize) -> Option<String>;

    /// Begins to grow above what has grown `beneath`.
    ///
    /// # Errors
    /// There is no room.
    fn begin<'a>(
        plan: Self::Plan,
        beneath: &Beneath,
        setting: Setting<'a>,
    ) -> Result<Self::Growth<'a>, LayerError>;

    /// Does about `budget` cell updates of work, at least the least part of it. The result does not depend on the budgets.
    ///
    /// # Errors
    /// Why the layer does not grow.
    fn advance(growth: &mut Self::Growth<'_>, budget: u64) -> Result<Advanced, LayerError>;

    /// What is being done, and the share of it that is done, 0..1.
    fn progress(growth: &Self::Growth<'_>) -> (Stage, f64);

    /// Cell updates of `time` of normalised time, as the layer grows now; 1, the least part of the work, while it is planned or
    /// measured.
    fn updates_in(growth: &Self::Growth<'_>, time: f64) -> u64;

    /// The layer as it is now; `None` while it is planned or measured.
    fn seen<'s>(growth: &'s Self::Growth<'_>) -> Option<Seen<'s>>;

    /// The drawn marks that find no room, as far as that is known.
    fn left_out(_growth: &Self::Growth<'_>) -> Vec<DrawnMark> {
        Vec::new()
    }

    /// What has grown; `None` before [`Advanced::done`].
    fn complete(growth: Self::Growth<'_>) -> Option<Self::Grown>;

    /// What the plan that it grew from has as all plans have.
    fn planned_of(grown: &Self::Grown) -> Planned;

    /// How the growth ended.
    fn ending(grown: &Self::Grown) -> Ending;

    /// The pattern at any size, without what passes under stripes that it crosses.
    fn pattern(grown: &Self::Grown) -> LayerPattern<'_>;

    /// What became of each drawn mark.
    fn drawn(_grown: &Self::Grown) -> Vec<DrawnMark> {
        Vec::new()
    }

    /// The drawn marks that found no room.
    fn left_out_of(_grown: &Self::Grown) -> Vec<DrawnMark> {
        Vec::new()
    }

    /// Fills in what is particular to this kind in the report of layer `index`, whose drawn marks stand in it already.
    fn report(grown: &Self::Grown, document: &Document, index: usize, report: &mut LayerReport);

    /// What to change where there is nothing but marks (`full`), or none.
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
    /// What is to be seen.
    fn seen(&self) -> Seen<'_>;
}

/// A field that is above ½ in areas.
impl Previewed for Field {
    fn seen(&self) -> Seen<'_> {
        Seen::of_areas(0, self)
    }
}
