//! What the export will be, made before it is asked for: the same files, written into a folder of the system's for
//! passing things and read back. Where all of it was made, the export copies those files.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use egui::{ColorImage, Context};

use super::What;
use super::job::Job;
use super::order::{Order, Pending};
use super::sight::Sight;
use crate::document::Document;
use crate::export::TemporaryFolder;
use crate::export::material::name;
use crate::export::motion::Film;
use crate::synth::estimate::{Needs, Task};
use crate::synth::{Grown, Training, Watch};

/// Px that a preview has at most; a larger picture is seen smaller.
const MOST: f64 = 4.2e6;
/// Px of the longer side of outlines.
const DRAWN: usize = 1024;
/// Px of a canvas whose outlines are not looked for unasked.
const LARGE: f64 = 1.7e7;

/// What was made.
pub struct Made {
    /// Of what.
    pub order: Order,
    /// Is it all of the export, or a smaller picture of it?
    pub whole: bool,
    /// What is seen of it.
    pub sight: Sight,
    /// What is to be told of it.
    pub told: Option<String>,
    /// Bytes of its files.
    pub bytes: u64,
    /// What has grown; a film keeps nothing.
    pub grown: Option<Arc<Grown>>,
    /// Its files, in order.
    pub files: Vec<PathBuf>,
    /// What its film is like.
    pub film: Option<Film>,
    /// Where the files lie; they go with it.
    _folder: TemporaryFolder,
}

/// What is made, and what was.
#[derive(Default)]
pub struct Preview {
    job: Option<(Order, Job<Made>)>,
    made: Option<Arc<Made>>,
    /// What could not be made, and why.
    failed: Option<(Order, String)>,
    needs: Option<(Document, Option<Needs>)>,
    asking: Option<(Document, Job<Option<Needs>>)>,
}

impl Preview {
    /// Follows the choices: makes what is made at once, and reckons what the rest takes.
    pub fn follow(
        &mut self,
        ctx: &Context,
        order: &Order,
        settled: Option<&Arc<Grown>>,
        threads: Option<usize>,
    ) {
        self.listen();
        if self.job.as_ref().is_some_and(|(of, _)| of != order) {
            self.job = None;
        }
        if !self.is_of(order) && self.is_quick(order, settled) {
            self.make(ctx, order, settled, threads);
        }
        let grown = self.sized(order);
        let known = self.needs.as_ref().is_some_and(|(of, _)| *of == grown)
            || self.asking.as_ref().is_some_and(|(of, _)| *of == grown);
        if !known && !self.is_ready(order, settled) {
            let (wake, document, size) = (ctx.clone(), order.document.clone(), grown.size);
            let scale = order.choices.size.scale;
            let work = move |_: &Watch| {
                let task = Task { document: &document, size, source: "the sketch", scale };
                Ok(Needs::of(&task, Training::built_in()))
            };
            self.asking = Some((grown, Job::start(threads, 0.0, move || wake.request_repaint(), work)));
        }
    }

    fn sized(&self, order: &Order) -> Document {
        Document { size: order.options().size.unwrap_or(order.document.size), ..order.document.clone() }
    }

    fn listen(&mut self) {
        if let Some((of, outcome)) =
            self.job.as_ref().and_then(|(of, job)| Some((of.clone(), job.outcome()?)))
        {
            let given_up = self.job.take().is_some_and(|(_, job)| job.is_cancelled());
            match outcome {
                Ok(made) => (self.made, self.failed) = (Some(Arc::new(made)), None),
                Err(_) if given_up => {}
                Err(why) => self.failed = Some((of, why)),
            }
        }
        if let Some((of, needs)) =
            self.asking.as_ref().and_then(|(of, job)| Some((of.clone(), job.outcome()?)))
        {
            (self.needs, self.asking) = (Some((of, needs.ok().flatten())), None);
        }
    }

    /// Is it made, being made, or known not to be possible?
    fn is_of(&self, order: &Order) -> bool {
        self.job.is_some() || self.of(order).is_some() || self.failure(order).is_some()
    }

    /// What was made of this order.
    #[must_use]
    pub fn of(&self, order: &Order) -> Option<&Arc<Made>> {
        self.made.as_ref().filter(|made| made.order == *order)
    }

    /// Why nothing could be made of this order.
    #[must_use]
    pub fn failure(&self, order: &Order) -> Option<&str> {
        self.failed.as_ref().filter(|(of, _)| of == order).map(|(_, why)| why.as_str())
    }

    /// What was made last, of whatever order.
    #[must_use]
    pub fn latest(&self) -> Option<&Arc<Made>> {
        self.made.as_ref()
    }

    /// Has it grown already?
    #[must_use]
    pub fn is_ready(&self, order: &Order, settled: Option<&Arc<Grown>>) -> bool {
        !order.is_film() && self.grown(order, settled).is_some()
    }

    /// What has grown already for this order.
    #[must_use]
    pub fn grown(&self, order: &Order, settled: Option<&Arc<Grown>>) -> Option<Arc<Grown>> {
        let here = self.made.as_ref().and_then(|made| made.grown.as_ref());
        here.into_iter().chain(settled).find(|grown| order.takes(grown)).cloned()
    }

    fn is_quick(&self, order: &Order, settled: Option<&Arc<Grown>>) -> bool {
        let [width, height] = order.size().map(|side| side as f64);
        let drawn = order.choices.what == What::Outlines;
        self.is_ready(order, settled) && !(drawn && width * height > LARGE)
    }

    /// Makes it.
    pub fn make(
        &mut self,
        ctx: &Context,
        order: &Order,
        settled: Option<&Arc<Grown>>,
        threads: Option<usize>,
    ) {
        let grown = self.grown(order, settled);
        let writing = match (order.is_film(), grown.is_some()) {
            (true, _) => 0.5,
            (false, true) => 1.0,
            (false, false) => 0.1,
        };
        let (wake, work) = (ctx.clone(), order.clone());
        let job = Job::start(
            threads,
            writing,
            move || wake.request_repaint(),
            move |watch| made(work, grown.as_ref(), watch),
        );
        self.failed = None;
        self.job = Some((order.clone(), job));
    }

    /// Gives up what is being made.
    pub fn stop(&mut self) {
        if let Some((_, job)) = &self.job {
            job.cancel();
        }
    }

    /// How far it is, where something is being made.
    #[must_use]
    pub fn progress(&self) -> Option<f32> {
        self.job.as_ref().map(|(_, job)| job.progress())
    }

    /// What growing for this order takes; `None` where it is not known, or cannot be planned.
    #[must_use]
    pub fn needs(&self, order: &Order) -> Option<Needs> {
        let grown = self.sized(order);
        self.needs.as_ref().filter(|(of, _)| *of == grown).and_then(|(_, needs)| *needs)
    }
}

/// Writes it for the eye.
fn made(order: Order, grown: Option<&Arc<Grown>>, watch: &Watch) -> Result<Made, String> {
    let folder = TemporaryFolder::new().map_err(|error| format!("no preview can be kept: {error}"))?;
    let grown = if order.is_film() { None } else { Some(order.grow(grown, watch)?) };
    let size = seen(&order);
    let file = match order.choices.ending() {
        Some(ending) => folder.path().join(name(&order.title)).with_extension(ending),
        None => folder.path().join("folder"),
    };
    let written = order.write(grown.as_deref(), &file, size, watch)?;
    let film = if let Pending::Film(_, film) = &written.pending { Some(film.clone()) } else { None };
    written.pending.keep()?;
    let files = if file.is_dir() { listed(&file)? } else { vec![file] };
    let bytes = files.iter().filter_map(|file| fs::metadata(file).ok()).map(|file| file.len()).sum();
    let seconds = film.as_ref().map_or(0.0, |film| 1.0 / f64::from(film.fps));
    let sight = match &written.drawing {
        Some(drawing) => Sight::Pictures(vec![(String::new(), drawing.picture(DRAWN))]),
        None => Sight::of(&order, &files, seconds)?,
    };
    let whole = size == order.size() || film.is_some() || written.drawing.is_some();
    Ok(Made { whole, sight, told: written.told, bytes, grown, files, film, order, _folder: folder })
}

/// The size at which pictures are made for the eye.
fn seen(order: &Order) -> [usize; 2] {
    let size = order.size();
    let px = size[0] as f64 * size[1] as f64;
    let smaller = (MOST / px).sqrt().min(1.0);
    if smaller < 1.0 { size.map(|side| ((side as f64 * smaller) as usize).max(1)) } else { size }
}

fn listed(folder: &Path) -> Result<Vec<PathBuf>, String> {
    let files = fs::read_dir(folder).map_err(|error| error.to_string())?;
    let mut files: Vec<PathBuf> = files.flatten().map(|file| file.path()).collect();
    files.sort();
    Ok(files)
}

impl Made {
    /// Its pictures; none where it is a film.
    #[must_use]
    pub fn pictures(&self) -> &[(String, ColorImage)] {
        if let Sight::Pictures(pictures) = &self.sight { pictures } else { &[] }
    }

    /// Its frames; none where it is no film.
    #[must_use]
    pub fn frames(&self) -> &[(ColorImage, f64)] {
        if let Sight::Film(frames) = &self.sight { frames } else { &[] }
    }
}
