//! Growing one alternative after the other on a thread of its own, while nothing else grows.

use std::panic::{self, AssertUnwindSafe};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{self, Receiver, Sender};
use std::thread;

use egui::{ColorImage, Context};

use crate::document::Document;
use crate::synth::render::painting::Painting;
use crate::synth::{GrowError, Grown, Options, Stage, Training, Watch, regrow};

/// The longest side of a small picture, px: twice the points it has on the screen.
const LONGEST: u32 = 184;

/// What is to be grown.
pub(super) struct Job {
    /// Whose picture it is.
    pub id: u64,
    /// What grows.
    pub document: Document,
    /// What is known of it: all of it, then it is only painted, or layers of another one.
    pub known: Option<Arc<Grown>>,
    /// Has `known` grown from this document, but for its colours?
    pub grown: bool,
}

/// What came of a job.
pub(super) struct News {
    pub id: u64,
    pub outcome: Result<(Arc<Grown>, Arc<ColorImage>), String>,
}

/// What is being grown.
pub(super) struct Series {
    pub news: Receiver<News>,
    progress: Arc<AtomicU64>,
    cancelled: Arc<AtomicBool>,
}

impl Drop for Series {
    fn drop(&mut self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }
}

impl Series {
    /// Begins.
    pub fn begin(jobs: Vec<Job>, training: &Arc<Training>, ctx: &Context) -> Self {
        let (tell, news) = mpsc::channel();
        let (progress, cancelled) = (Arc::new(AtomicU64::new(0)), Arc::new(AtomicBool::new(false)));
        let series = Self { news, progress: Arc::clone(&progress), cancelled: Arc::clone(&cancelled) };
        let worker = Worker { tell, progress, cancelled, training: Arc::clone(training), ctx: ctx.clone() };
        // Without a thread there are no alternatives; all else works.
        drop(thread::Builder::new().name("alternatives".to_owned()).spawn(move || worker.run(jobs)));
        series
    }

    /// What is being grown, and the share of it that is done, 0..1.
    pub fn progress(&self) -> (u64, f32) {
        let told = self.progress.load(Ordering::Relaxed);
        (told >> 16, (told & 0xffff) as f32 / 65_535.0)
    }
}

struct Worker {
    tell: Sender<News>,
    progress: Arc<AtomicU64>,
    cancelled: Arc<AtomicBool>,
    training: Arc<Training>,
    ctx: Context,
}

impl Worker {
    fn run(&self, jobs: Vec<Job>) {
        // Half of the cores: the window has the others.
        let cores = thread::available_parallelism().map_or(1, usize::from);
        let pool = rayon::ThreadPoolBuilder::new().num_threads((cores / 2).max(1)).build();
        for job in jobs {
            let work = || panic::catch_unwind(AssertUnwindSafe(|| self.work(&job)));
            let worked = match &pool {
                Ok(pool) => pool.install(work),
                Err(_) => work(),
            };
            let outcome = match worked {
                Ok(Ok(grown)) => Ok(grown),
                Ok(Err(GrowError::Cancelled(_))) => return,
                Ok(Err(error)) => Err(error.to_string()),
                Err(_) => Err("growing it failed inside dapple; please report the document".to_owned()),
            };
            // The window may want others by now.
            let _ = self.tell.send(News { id: job.id, outcome });
            self.ctx.request_repaint();
        }
    }

    fn work(&self, job: &Job) -> Result<(Arc<Grown>, Arc<ColorImage>), GrowError> {
        let progress = |stage, share: f64| {
            let all = match stage {
                Stage::Plan => 0.05 * share,
                Stage::Grow => 0.05 + 0.85 * share,
                Stage::Refine | Stage::Write => 0.9 + 0.1 * share,
            };
            self.progress.store(job.id << 16 | (65_535.0 * all) as u64, Ordering::Relaxed);
        };
        let cancelled = || self.cancelled.load(Ordering::Relaxed);
        let watch = Watch { progress: &progress, cancelled: &cancelled };
        watch.step(Stage::Plan, 0.0)?;
        let grown = match &job.known {
            Some(known) if job.grown => Arc::clone(known),
            known => {
                let options =
                    Options { source: "the sketch", training: &self.training, watch, ..Options::default() };
                Arc::new(regrow(&job.document, &options, known.as_deref())?)
            }
        };
        let image = Arc::new(small(&job.document, &grown));
        Ok((grown, image))
    }
}

/// A small picture of what `document` has `grown`.
#[must_use]
pub fn small(document: &Document, grown: &Grown) -> ColorImage {
    let longest = grown.size[0].max(grown.size[1]).max(1);
    let size = grown.size.map(|side| (side * LONGEST.min(longest) / longest).max(1) as usize);
    ColorImage::from_rgb(size, &Painting::sized(document, grown, size).rgb())
}
