//! The time and the memory that a growth needs, estimated before it begins.
//!
//! ```text
//! seconds = Σ updates ÷ speed  +  px of the canvas · layers · RULER · painting  +  px of the picture · painting
//! finish  = px of the picture, at least of the canvas · finish
//! ```
//!
//! The engine gives the expected cell updates. Their speed, and that of painting a px, are measured on this machine, on a canvas of
//! the same texture that is no larger than `TRIAL`: marks keep their size, so that both are representative.

use std::time::Duration;

use crate::document::Document;
use crate::export::png;
use crate::synth::growth::Snapshot;
use crate::synth::kind::{Request, Work};
use crate::synth::layer::{LayerKind, LayerPlan};
use crate::synth::memory;
use crate::synth::options::{Clock, Machine};
use crate::synth::render::painting::Painting;
pub use crate::synth::time::in_words;
use crate::synth::training::Training;

/// px of the largest canvas that speeds are measured on.
const TRIAL: f64 = 600.0 * 600.0;
/// Duration of a measurement of the speed of steps: long enough for all threads to start.
const DURATION: Duration = Duration::from_millis(40);
/// Sides of the picture that is painted to measure the time of a px.
const PAINTED: [usize; 2] = [256, 256];
/// The time of measuring a pattern ÷ the time of painting it. Not tuned by itself: with it, the estimates for four examples of
/// 2000² to 6000² px are 0.5 to 1 times the actual time, lowest where spots are sparse.
const RULER: f64 = 1.0;

/// A document to be grown, and the size of its canvas and picture.
pub struct Task<'a> {
    /// The document.
    pub document: &'a Document,
    /// The canvas that is asked for, px.
    pub size: [u32; 2],
    /// The name of the document in messages, such as its path.
    pub source: &'a str,
    /// px along a side of the picture for one of the canvas.
    pub scale: u32,
    /// The machine on which it grows.
    pub machine: Machine,
}

impl Task<'_> {
    /// px of the canvas, and of the picture.
    #[must_use]
    pub fn px(&self) -> [f64; 2] {
        let canvas = f64::from(self.size[0]) * f64::from(self.size[1]);
        [canvas, canvas * f64::from(self.scale) * f64::from(self.scale)]
    }
}

/// The time and the memory that a growth needs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Needs {
    /// Time on this machine at its current load, without the finish, s.
    pub seconds: f64,
    /// Time of the finish of one picture, s; 0 without a finish.
    pub finish: f64,
    /// Bytes of memory.
    pub bytes: f64,
}

impl Needs {
    /// Estimates one growth. `None` if it cannot be planned, or does not fit into memory; the growth itself gives the reason.
    #[must_use]
    pub fn estimate(task: &Task, training: &Training) -> Option<Self> {
        let mut needs = Self { seconds: 0.0, finish: 0.0, bytes: 0.0 };
        let mut beneath: Option<LayerPlan> = None;
        for index in 0..task.document.layers.len() {
            let plan = needs.add_layer(task, index, training, beneath.as_ref())?;
            beneath = Some(plan);
        }
        Some(needs)
    }

    /// Adds what layer `index` needs, above the plan `beneath`. Returns its plan.
    fn add_layer(
        &mut self,
        task: &Task,
        index: usize,
        training: &Training,
        beneath: Option<&LayerPlan>,
    ) -> Option<LayerPlan> {
        let Task { document, source, machine: Machine { memory: free, clock }, .. } = *task;
        let (size, [canvas, picture]) = (task.size.map(f64::from), task.px());
        let scales = LayerKind::of(document, index).scales();
        let times = if scales { (canvas / TRIAL).max(1.0) } else { 1.0 };
        let trial = size.map(|side| (side / times.sqrt()).max(1.0));
        let beneath = beneath.map(LayerPlan::own);
        let request = Request { document, index, source, size: trial, training, memory: free, beneath };
        let plan = LayerPlan::read(&request).ok()?;
        let whole = plan.planned().grid.size.map(|cells| (cells as f64 * times.sqrt()).round() as usize);
        let bytes = plan.bytes(size, whole);
        memory::fits(bytes, size, whole, free).ok()?;
        self.bytes = self.bytes.max(bytes);
        let trial = plan.trial(document.layer_seed(index))?;
        self.seconds += times * seconds(trial.work, clock);
        let look = Snapshot { beneath: &[], growing: trial.look.seen() };
        self.seconds += painted(document, &look, clock) * (canvas * RULER + picture);
        if index + 1 == document.layers.len() {
            self.finish = finished(document, &look, clock) * canvas.max(picture);
        }
        Some(plan)
    }
}

/// Seconds that some work takes.
fn seconds(work: Work, clock: Clock) -> f64 {
    let (units, mut part) = match work {
        Work::Seconds(seconds) => return seconds,
        Work::Units { units, part } => (units, part),
    };
    part();
    let (started, mut done) = (clock(), 0.0);
    while clock() - started < DURATION {
        done += part();
    }
    units * (clock() - started).as_secs_f64() / f64::max(done, 1.0)
}

/// Seconds of painting and encoding a px.
fn painted(document: &Document, look: &Snapshot, clock: Clock) -> f64 {
    // Once for the whole texture: pattern and colours of the layer.
    let painting = Painting::growing(document, look, PAINTED);
    let started = clock();
    let rgb = painting.rgb();
    // Discarded: only the time counts.
    let _ = png::rgb8(std::io::sink(), PAINTED, None, &rgb);
    (clock() - started).as_secs_f64() / (PAINTED[0] * PAINTED[1]) as f64
}

/// Seconds of the finish of `document` for a px; 0 if it has none.
fn finished(document: &Document, look: &Snapshot, clock: Clock) -> f64 {
    let size = look.growing.canvas.map(|side| (side.round() as usize).max(1));
    let painting = Painting::growing(document, look, size).with_finish(document);
    if !painting.has_finish() {
        return 0.0;
    }
    let started = clock();
    // Discarded: only the time counts.
    let _ = painting.rgb();
    (clock() - started).as_secs_f64() / (size[0] * size[1]) as f64
}
