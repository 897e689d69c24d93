//! Grows one document after the other on a separate thread, for small pictures of what a sketch can become, while the sketch
//! itself is not growing.

use std::panic::{self, AssertUnwindSafe};
use std::sync::Arc;

use egui::ColorImage;

use crate::document::Document;
use crate::editor::sketch_part::part;
use crate::editor::task::{StartError, Task, Tasks, Worker};
use crate::machine::{free_memory, threads};
use crate::synth::render::painting::Painting;
use crate::synth::{GrowError, Grown, Growth, Options, Stage, Training, Watch};

/// The longest side of a small picture, px: two px for each point on the screen.
const LONGEST: u32 = 184;

/// A document to grow.
pub struct Job {
    /// The id under which its picture is sent.
    pub id: u64,
    /// The layer about which a part of the sketch is grown; `None` for all of it.
    pub about: Option<usize>,
    /// Its document.
    pub document: Document,
    /// A texture that has already grown: of this document, so that it is only painted, or of another one, whose layers
    /// are reused.
    pub known: Option<Arc<Grown>>,
    /// Whether `known` was grown from this document, except for its colours.
    pub grown: bool,
}

/// What the thread sends.
pub enum News {
    /// A job has begun.
    Begun(u64),
    /// A job has ended.
    Done { id: u64, outcome: Result<(Arc<Grown>, Arc<ColorImage>), String> },
}

/// Starts growing `jobs`, one after the other.
///
/// # Errors
/// Where no thread can be started.
pub fn start(
    name: &'static str,
    jobs: Vec<Job>,
    training: &Arc<Training>,
    tasks: &Tasks,
) -> Result<Task<News>, StartError> {
    let training = Arc::clone(training);
    tasks.start(name, move |worker| Growing { worker, training: &training }.run(&jobs))
}

struct Growing<'a> {
    worker: &'a Worker<News>,
    training: &'a Training,
}

impl Growing<'_> {
    fn run(&self, jobs: &[Job]) {
        // Half of the cores, so that the window has the others.
        let pool = threads::pool((threads::cores() / 2).max(1));
        for job in jobs {
            self.worker.send(News::Begun(job.id));
            // A panic in one growth does not stop the others.
            let work = || panic::catch_unwind(AssertUnwindSafe(|| self.work(job)));
            let worked = match &pool {
                Ok(pool) => pool.install(work),
                Err(_) => work(),
            };
            let outcome = match worked {
                Ok(Ok(grown)) => Ok(grown),
                Ok(Err(GrowError::Cancelled(_))) => return,
                Ok(Err(error)) => Err(error.to_string()),
                Err(_) => {
                    Err("growing failed because of an error in dapple; please report the document".to_owned())
                }
            };
            self.worker.send(News::Done { id: job.id, outcome });
        }
    }

    fn work(&self, job: &Job) -> Result<(Arc<Grown>, Arc<ColorImage>), GrowError> {
        let progress = |stage, share: f64| {
            self.worker.set_progress(match stage {
                Stage::Plan => 0.05 * share,
                Stage::Grow => 0.05 + 0.85 * share,
                Stage::Refine | Stage::Write => 0.9 + 0.1 * share,
            });
        };
        let cancelled = || self.worker.is_cancelled();
        let watch = Watch { progress: &progress, cancelled: &cancelled };
        watch.step(Stage::Plan, 0.0)?;
        let part = job.about.map(|layer| part(&job.document, layer));
        let document = part.as_ref().unwrap_or(&job.document);
        let grown = match &job.known {
            Some(known) if job.grown => Arc::clone(known),
            known => {
                let options = Options {
                    source: "the sketch",
                    training: self.training,
                    memory: Some(free_memory()),
                    watch,
                    ..Options::default()
                };
                Arc::new(Growth::begin(document, &options, known.as_deref()).run()?)
            }
        };
        let image = Arc::new(small(document, &grown));
        Ok((grown, image))
    }
}

/// A small picture of a grown document.
#[must_use]
pub fn small(document: &Document, grown: &Grown) -> ColorImage {
    let longest = grown.size[0].max(grown.size[1]).max(1);
    let size = grown.size.map(|side| (side * LONGEST.min(longest) / longest).max(1) as usize);
    ColorImage::from_rgb(size, &Painting::sized(document, grown, size).rgb())
}
