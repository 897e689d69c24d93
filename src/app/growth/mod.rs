//! Growth on another thread: a task grows the latest document; the window never waits for it.
//!
//! The task advances a [`crate::synth::Growth`], as `dapple grow` does: the settled picture is the one that
//! `dapple grow` writes.

mod job;
mod picture;
mod preview;

pub use picture::{Picture, image};

use std::sync::Arc;
use std::time::Duration;

use crate::document::{Document, MapKey};
use crate::editor::task::{Ending, StartError, Task, Tasks, Worker};
use crate::machine::clock::Instant;
use crate::synth::report::DrawnMark;
use crate::synth::{Grown, Stage};
use job::{AFTER_FIRST, FRAMES_BETWEEN, Job, Live, News, Shared};

/// The message where the growth panicked.
const FAULT: &str = "growing failed because of an error in dapple; please report the document. Your sketch is \
                     not lost: save it, or change it to grow it again";

/// The state of the growth.
#[derive(Clone, Debug, PartialEq)]
pub enum GrowthState {
    /// There is nothing to grow.
    Idle,
    /// A document is growing: the current stage, and the share of it that is done, 0..1.
    Growing(Stage, f64),
    /// The growth was stopped; the picture shows the pattern at that moment.
    Stopped,
    /// The texture has settled after this time.
    Settled(Duration),
    /// The document cannot be grown: why.
    Failed(String),
}

/// A grown document.
#[derive(Clone)]
pub struct Texture {
    /// The document, in its current colours.
    pub document: Arc<Document>,
    /// What has grown from it.
    pub grown: Arc<Grown>,
}

/// The window's side of the growth.
pub struct Growth {
    tasks: Tasks,
    shared: Arc<Shared>,
    task: Option<Task<News>>,
    live: Option<Arc<Live>>,
    /// The growth before this one. It was cancelled and may still run for a moment.
    ending: Option<Ending>,
    /// The painting of the settled texture in other colours or at another fineness, and the document it paints.
    painting: Option<(Arc<Document>, Task<Picture>)>,
    /// The next document, where it was grown elsewhere.
    known: Option<Arc<Grown>>,
    threads: Option<usize>,
    /// Number of growths so far.
    generation: u64,
    asked: Option<Document>,
    since: Instant,
    /// The state of the growth.
    pub state: GrowthState,
    /// The latest picture.
    pub picture: Option<Picture>,
    /// The settled texture; `None` until the current sketch has settled.
    pub texture: Option<Texture>,
    /// The drawn marks that find no room, by layer of the document that is growing, as far as that is known.
    pub left_out: Vec<Vec<DrawnMark>>,
    /// Time from the change to its first picture.
    pub first_picture: Option<Duration>,
    /// The number of the lowest layers of the settled texture that were not grown again.
    pub reused: usize,
    paused: bool,
}

impl Growth {
    /// Nothing grows yet. `tasks` starts the threads.
    #[must_use]
    pub fn new(tasks: Tasks) -> Self {
        Self {
            tasks,
            shared: Arc::default(),
            task: None,
            live: None,
            ending: None,
            painting: None,
            known: None,
            threads: None,
            generation: 0,
            asked: None,
            since: Instant::now(),
            state: GrowthState::Idle,
            picture: None,
            texture: None,
            left_out: Vec::new(),
            first_picture: None,
            reused: 0,
            paused: false,
        }
    }

    /// Takes fewer pictures of the growing texture where a frame of the window takes longer, seconds.
    pub fn set_pace(&self, frame: f32) {
        self.shared.set_pace(frame);
    }

    /// The time to the next frame that only an animation needs, while a texture grows: eight times the duration of a
    /// `frame` of the window, seconds, and not before the time in which most sketches settle is over.
    #[must_use]
    pub fn until_next_frame(&self, frame: f32) -> Duration {
        let usual = Duration::from_secs_f32(FRAMES_BETWEEN * frame);
        match self.first_picture {
            Some(first) if self.is_growing() => usual.max(self.left_after(first)),
            _ => usual,
        }
    }

    /// Whether a texture is growing that may settle soon. Other computations can wait until then.
    #[must_use]
    pub fn may_settle_soon(&self) -> bool {
        let is_early = |first| !self.left_after(first).is_zero();
        self.is_growing() && !self.paused && self.first_picture.is_none_or(is_early)
    }

    /// The rest of the time, after the `first` picture, in which most sketches settle.
    fn left_after(&self, first: Duration) -> Duration {
        (first + AFTER_FIRST).saturating_sub(self.since.elapsed())
    }

    /// Paints the settled picture with this many px for each px of the canvas, along a side. A magnified picture needs
    /// as many px as it has on the screen, so that edges stay sharp. Pictures of more than 2,048 px a side are not
    /// painted finer.
    pub fn set_fineness(&mut self, fineness: usize) {
        if self.shared.set_fineness(fineness) {
            self.paint();
        }
    }

    /// Sets the number of threads of the next growths; `None` = as many as there are cores. The texture does not depend
    /// on it.
    pub fn use_threads(&mut self, threads: Option<usize>) {
        self.threads = threads;
    }

    /// Grows `document` in place of the one that is growing, unless both have the same pattern. An empty document is
    /// not grown.
    pub fn grow(&mut self, document: &Document) {
        if document.layers.is_empty() {
            if self.asked.take().is_some() {
                self.cancel();
            }
            self.state = GrowthState::Idle;
            self.picture = None;
            return;
        }
        let needed = essence(document);
        if self.asked.as_ref().is_some_and(|asked| essence(asked) == needed) {
            self.recolour(document);
        } else {
            self.begin(document);
        }
    }

    /// Grows `document` from the beginning.
    fn begin(&mut self, document: &Document) {
        self.cancel();
        self.asked = Some(document.clone());
        self.since = Instant::now();
        self.first_picture = None;
        let document = Arc::new(document.clone());
        let live = Arc::new(Live::new(&document));
        let (known, shared) = (self.known.take(), Arc::clone(&self.shared));
        let job = Job { document, known, live: Arc::clone(&live), shared };
        self.state = match self.start(job) {
            Ok(task) => {
                (self.task, self.live) = (Some(task), Some(live));
                GrowthState::Growing(Stage::Plan, 0.0)
            }
            Err(error) => GrowthState::Failed(error.to_string()),
        };
    }

    fn start(&mut self, job: Job) -> Result<Task<News>, StartError> {
        let (ending, threads) = (self.ending.take(), self.threads);
        self.tasks.start("growth", move |worker| {
            // Two growths at the same time would slow each other down.
            if let Some(ending) = ending {
                ending.wait();
            }
            if !worker.is_cancelled() {
                job.shared.install(threads, || job.run(worker));
            }
        })
    }

    /// Shows the same pattern in the colours of `document`.
    fn recolour(&mut self, document: &Document) {
        if self.asked.as_ref() == Some(document) {
            return;
        }
        self.asked = Some(document.clone());
        let document = Arc::new(document.clone());
        if let Some(texture) = &mut self.texture {
            texture.document = document;
            self.paint();
        } else if let Some(live) = &self.live {
            live.colour(document);
        }
    }

    /// Paints the settled texture. Where it is being painted, it is painted again after that.
    fn paint(&mut self) {
        let Some(texture) = self.texture.clone().filter(|_| self.painting.is_none()) else { return };
        let document = Arc::clone(&texture.document);
        let (shared, threads) = (Arc::clone(&self.shared), self.threads);
        let fineness = shared.fineness();
        let work = {
            let texture = texture.clone();
            move |worker: &Worker<Picture>| {
                shared.install(threads, || worker.send(Picture::settled(&texture, fineness)));
            }
        };
        match self.tasks.start("painting", work) {
            Ok(task) => self.painting = Some((document, task)),
            // Where no thread can be started, the window blocks until the texture is painted.
            Err(_) => self.picture = Some(Picture::settled(&texture, fineness)),
        }
    }

    /// The number of growths so far; a change of colours is not a growth.
    #[must_use]
    pub fn generation(&self) -> u64 {
        self.generation
    }

    /// Grows the document again from the beginning.
    pub fn again(&mut self, document: &Document) {
        if !document.layers.is_empty() {
            self.begin(document);
        }
    }

    /// Sets the texture of the next document, which was `grown` elsewhere, so that it is not grown again.
    pub fn know(&mut self, grown: &Arc<Grown>) {
        self.known = Some(Arc::clone(grown));
    }

    /// Removes what has grown, because another document was opened.
    pub fn forget(&mut self) {
        self.cancel();
        self.asked = None;
        self.picture = None;
        self.state = GrowthState::Idle;
    }

    /// Whether the settled texture is being painted again.
    #[must_use]
    pub fn is_painting(&self) -> bool {
        self.painting.is_some()
    }

    /// Whether nothing was grown and nothing is growing.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.asked.is_none()
    }

    /// Stops the growth; the picture stays.
    pub fn stop(&mut self) {
        if self.is_growing() {
            self.cancel();
            self.state = GrowthState::Stopped;
        }
    }

    fn cancel(&mut self) {
        self.generation += 1;
        self.texture = None;
        self.left_out.clear();
        self.painting = None;
        self.paused = false;
        self.live = None;
        if let Some(task) = self.task.take() {
            self.ending = Some(task.into_ending());
        }
    }

    /// Whether the growth is paused.
    #[must_use]
    pub fn is_paused(&self) -> bool {
        self.paused
    }

    /// Whether something is growing, paused or not.
    #[must_use]
    pub fn is_growing(&self) -> bool {
        matches!(self.state, GrowthState::Growing(..))
    }

    /// Pauses the growth, or continues it.
    pub fn pause(&mut self, paused: bool) {
        self.paused = paused;
        if let Some(task) = &self.task {
            task.pause(paused);
        }
    }

    /// Receives the messages of the tasks; never blocks. Returns whether there is a new picture.
    pub fn listen(&mut self) -> bool {
        let mut is_new = false;
        while let Some(news) = self.task.as_mut().and_then(Task::poll) {
            is_new |= self.receive(news);
        }
        if self.task.as_ref().is_some_and(Task::has_ended) {
            (self.task, self.live) = (None, None);
            if self.is_growing() {
                self.state = GrowthState::Failed(FAULT.to_owned());
            }
        }
        if let (GrowthState::Growing(stage, share), Some(live)) = (&mut self.state, &self.live) {
            (*stage, *share) = live.progress();
        }
        is_new | self.listen_to_painting()
    }

    fn receive(&mut self, news: News) -> bool {
        match news {
            News::Picture(picture) => self.picture = Some(picture),
            News::LeftOut(left_out) => {
                self.left_out = left_out;
                return false;
            }
            News::Settled(texture, picture, reused) => {
                // Its colours may have been changed in the meantime.
                let changed = self.asked.as_ref().filter(|asked| **asked != *texture.document);
                let document = changed.map(|asked| Arc::new(asked.clone()));
                let is_current = document.is_none() && picture.fineness == self.shared.fineness();
                let document = document.unwrap_or_else(|| Arc::clone(&texture.document));
                self.texture = Some(Texture { document, ..texture });
                self.picture = Some(picture);
                self.reused = reused;
                self.state = GrowthState::Settled(self.since.elapsed());
                if !is_current {
                    self.paint();
                }
            }
            News::Failed(why) => {
                self.state = GrowthState::Failed(why);
                return false;
            }
        }
        self.first_picture.get_or_insert_with(|| self.since.elapsed());
        true
    }

    fn listen_to_painting(&mut self) -> bool {
        let Some((document, task)) = &mut self.painting else { return false };
        let picture = task.poll();
        if picture.is_none() && !task.has_ended() {
            return false;
        }
        let same_document =
            self.texture.as_ref().is_some_and(|texture| Arc::ptr_eq(&texture.document, document));
        let fineness = self.shared.fineness();
        let is_current = same_document && picture.as_ref().is_none_or(|picture| picture.fineness == fineness);
        self.painting = None;
        let is_new = picture.is_some();
        self.picture = picture.or(self.picture.take());
        if is_new && !is_current {
            self.paint();
        }
        is_new
    }
}

/// The part of the document on which what grows depends: the document without its names, colours, warp, finish and dots per inch.
pub(in crate::app) fn essence(document: &Document) -> Document {
    let mut essence = Document {
        name: String::new(),
        dpi: 300.0,
        starred: Vec::new(),
        warp: None,
        finish: None,
        ..document.clone()
    };
    for layer in &mut essence.layers {
        layer.name.clear();
        layer.colours = None;
        MapKey::ALL.into_iter().filter(|key| key.is_painted()).for_each(|key| layer.maps.set(key, None));
        layer.visible = true;
    }
    essence
}

#[cfg(test)]
mod tests;
