//! The work of the growth thread: it grows one document once, and sends pictures while the texture grows.

use std::sync::Arc;
use std::sync::atomic::{AtomicU32, AtomicUsize, Ordering};
use std::time::Duration;

use super::preview::preview;
use super::{Picture, Texture, essence};
use crate::document::Document;
use crate::editor::task::Worker;
use crate::machine::clock::Instant;
use crate::machine::free_memory;
use crate::machine::sync::{Mutex, PoisonError};
use crate::machine::threads::{self, ThreadPool};
use crate::synth::report::DrawnMark;
use crate::synth::{
    Cancelled, GrowError, Grown, GrownLayer, Growth, LayerPlan, Options, Progress, Settings, Stage, Training,
    UPDATES, unchanged,
};

/// Limits of the time between two pictures of a growth, ms: the shortest and the longest.
const BETWEEN_PICTURES: [u32; 2] = [60, 600];
/// While a texture grows: the time between two of its pictures, and between two frames that only an animation needs, as
/// a multiple of the time that one frame takes. With a software renderer a frame uses two cores for 12 ms at 1280 ×
/// 800. With this factor such frames take at most an eighth of the time.
pub(super) const FRAMES_BETWEEN: f32 = 8.0;
/// The time from the first picture of a growth to the second one, and to the next frame that only an animation needs.
/// Most sketches have settled by then. With two cores and a software renderer, each frame in between would take some 20
/// ms of processor time from the growth.
pub(super) const AFTER_FIRST: Duration = Duration::from_millis(300);

/// What a growth sends.
pub(super) enum News {
    /// The pattern so far.
    Picture(Picture),
    /// The texture has settled. The number is that of its lowest layers that were taken from an earlier growth.
    Settled(Texture, Picture, usize),
    /// The drawn marks for which there is no room, by layer of the document, as far as that is known.
    LeftOut(Vec<Vec<DrawnMark>>),
    /// The document cannot be grown: why.
    Failed(String),
}

/// What all growths of a window share.
#[derive(Default)]
pub(super) struct Shared {
    training: Training,
    /// The newest growth, as far as it came: layers that did not change are taken from there.
    reusable: Mutex<Option<Arc<Grown>>>,
    /// The thread pool of the last growth and its number of threads.
    pool: Mutex<Option<(usize, Arc<ThreadPool>)>>,
    /// Least time between two pictures, ms.
    between: AtomicU32,
    /// px of a settled picture for each px of the canvas, along a side; 0 = 1.
    fineness: AtomicUsize,
}

impl Shared {
    /// Sets the time between two pictures: longer where a `frame` of the window takes longer, seconds.
    pub(super) fn set_pace(&self, frame: f32) {
        let [least, most] = BETWEEN_PICTURES;
        let between = (1e3 * FRAMES_BETWEEN * frame) as u32;
        self.between.store(between.clamp(least, most), Ordering::Relaxed);
    }

    /// Sets the fineness of settled pictures: this many px for each px of the canvas, along a side. Returns whether the
    /// fineness is new.
    pub(super) fn set_fineness(&self, fineness: usize) -> bool {
        self.fineness.swap(fineness.max(1), Ordering::Relaxed) != fineness.max(1)
    }

    /// px of a settled picture for each px of the canvas, along a side.
    pub(super) fn fineness(&self) -> usize {
        self.fineness.load(Ordering::Relaxed).max(1)
    }

    /// Least time between two pictures.
    fn between(&self) -> Duration {
        let between = self.between.load(Ordering::Relaxed).max(BETWEEN_PICTURES[0]);
        Duration::from_millis(u64::from(between))
    }

    /// Runs `work` with `threads` threads; `None` = as many as there are cores. The window
    /// needs little of them: on two cores 95 % of its frames took at most 8.5 ms with a software renderer.
    pub(super) fn install(&self, threads: Option<usize>, work: impl FnOnce() + Send) {
        match self.pool(threads) {
            Some(pool) => pool.install(work),
            // Where no own threads can be started, uses those that the whole program shares.
            None => work(),
        }
    }

    fn pool(&self, threads: Option<usize>) -> Option<Arc<ThreadPool>> {
        let threads = threads.unwrap_or_else(threads::cores);
        let mut pool = self.pool.lock().unwrap_or_else(PoisonError::into_inner);
        if pool.as_ref().is_none_or(|(size, _)| *size != threads) {
            let built = threads::pool(threads).ok()?;
            *pool = Some((threads, Arc::new(built)));
        }
        pool.as_ref().map(|(_, pool)| Arc::clone(pool))
    }

    fn reusable(&self) -> Option<Arc<Grown>> {
        self.reusable.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    fn set_reusable(&self, grown: Arc<Grown>) {
        *self.reusable.lock().unwrap_or_else(PoisonError::into_inner) = Some(grown);
    }

    /// Keeps the layers of `document` that have grown so far. If the document changes while the next layer grows, they
    /// need not grow again.
    fn keep_layers(&self, document: &Document, layers: &[GrownLayer]) {
        let mut document = document.clone();
        document.layers.truncate(layers.len());
        let grown =
            Grown { size: document.size, layers: layers.to_vec(), document, settings: Settings::default() };
        self.set_reusable(Arc::new(grown));
    }
}

/// What the window and a growth share while it runs.
pub(super) struct Live {
    /// The document in the colours in which it is shown; they may change during the growth.
    coloured: Mutex<Arc<Document>>,
    progress: Mutex<(Stage, f64)>,
}

impl Live {
    pub(super) fn new(document: &Arc<Document>) -> Self {
        Self { coloured: Mutex::new(Arc::clone(document)), progress: Mutex::new((Stage::Plan, 0.0)) }
    }

    /// Shows the growth in the colours of `document` from now on.
    pub(super) fn colour(&self, document: Arc<Document>) {
        *self.coloured.lock().unwrap_or_else(PoisonError::into_inner) = document;
    }

    fn coloured(&self) -> Arc<Document> {
        Arc::clone(&self.coloured.lock().unwrap_or_else(PoisonError::into_inner))
    }

    /// The current stage and the share of it that is done, 0..1.
    pub(super) fn progress(&self) -> (Stage, f64) {
        *self.progress.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn set_progress(&self, stage: Stage, share: f64) {
        *self.progress.lock().unwrap_or_else(PoisonError::into_inner) = (stage, share);
    }
}

/// One growth.
pub(super) struct Job {
    pub(super) document: Arc<Document>,
    /// A texture of this document that was already grown elsewhere.
    pub(super) known: Option<Arc<Grown>>,
    pub(super) live: Arc<Live>,
    pub(super) shared: Arc<Shared>,
}

impl Job {
    /// Grows the document and sends the results.
    pub(super) fn run(&self, worker: &Worker<News>) {
        let document = &self.document;
        let known = self.known.clone().filter(|known| essence(&known.document) == essence(document));
        let is_known = known.is_some();
        let before = known.or_else(|| self.shared.reusable());
        let reused = before.as_ref().map_or(0, |before| unchanged(document, Settings::default(), before));
        let beneath = before.as_ref().map_or(&[][..], |before| &before.layers[..reused]);
        let first = if is_known { None } else { preview(document, &self.shared.training, beneath) };
        let planned = first.filter(|_| !worker.is_cancelled()).map(|(picture, plan)| {
            worker.send(News::Picture(picture));
            plan
        });
        match self.grow(worker, before.as_deref(), reused, planned) {
            Ok(grown) => self.send_settled(worker, grown, reused),
            Err(GrowError::Cancelled(_)) => {}
            Err(error) => worker.send(News::Failed(error.to_string())),
        }
    }

    /// Grows the document. The plan of the first layer that grows may be `known`; then a picture of it has already been
    /// sent.
    fn grow(
        &self,
        worker: &Worker<News>,
        before: Option<&Grown>,
        reused: usize,
        known: Option<LayerPlan>,
    ) -> Result<Grown, GrowError> {
        let mut next = known.as_ref().map(|_| Instant::now() + AFTER_FIRST);
        let training = &self.shared.training;
        let memory = Some(free_memory());
        let options = Options { source: "the sketch", training, memory, ..Options::default() };
        let mut growth = Growth::begin(&self.document, &options, before);
        if let Some(plan) = known {
            growth = growth.planned(plan);
        }
        let mut done = reused;
        let mut planned = 0;
        loop {
            let (stage, share) = growth.progress();
            self.live.set_progress(stage, share);
            worker.pause_point();
            if worker.is_cancelled() {
                return Err(Cancelled.into());
            }
            match growth.advance(UPDATES)? {
                Progress::Done => break,
                Progress::Growing { seen: false } => continue,
                Progress::Growing { seen: true } => {}
            }
            let Some(look) = growth.snapshot() else { continue };
            if look.beneath.len() >= planned {
                planned = look.beneath.len() + 1;
                worker.send_ahead(News::LeftOut(growth.left_out()));
            }
            if look.beneath.len() > done {
                done = look.beneath.len();
                self.shared.keep_layers(&self.document, look.beneath);
            }
            if next.is_none_or(|next| next <= Instant::now()) && !worker.is_cancelled() {
                worker.send(News::Picture(Picture::growing(&self.live.coloured(), &look)));
                let between = if next.is_none() { AFTER_FIRST } else { self.shared.between() };
                next = Some(Instant::now() + between);
            }
        }
        Ok(growth.complete().expect("all layers have grown"))
    }

    fn send_settled(&self, worker: &Worker<News>, grown: Grown, reused: usize) {
        let texture = Texture { document: self.live.coloured(), grown: Arc::new(grown) };
        self.shared.set_reusable(Arc::clone(&texture.grown));
        let picture = Picture::settled(&texture, self.shared.fineness());
        worker.send(News::Settled(texture, picture, reused));
    }
}
