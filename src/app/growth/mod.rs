//! Growth beside the window: a thread grows the latest document, the window is told and never waits.
//!
//! The thread runs [`crate::synth::regrow_seen`], as `dapple grow` does, and so the picture that has settled is the one
//! that `dapple grow` writes.

mod picture;
mod preview;
mod worker;

pub use picture::Picture;

use std::sync::Arc;
use std::sync::mpsc::Receiver;
use std::time::{Duration, Instant};

use crate::document::Document;
use crate::synth::{Grown, Stage};
use worker::{News, Orders};

/// How far a growth is.
#[derive(Clone, Debug, PartialEq)]
pub enum Phase {
    /// There is nothing to grow.
    Idle,
    /// It grows: what is being done, and the share of it that is done.
    Growing(Stage, f64),
    /// It was stopped; what is seen is how far it came.
    Stopped,
    /// It has settled after so long.
    Settled(Duration),
    /// It cannot be grown: why.
    Failed(String),
}

/// What has grown from a document.
#[derive(Clone)]
pub struct Texture {
    /// What was grown.
    pub document: Arc<Document>,
    /// What came of it.
    pub grown: Arc<Grown>,
}

/// The window's side of the growth.
pub struct Growth {
    orders: Arc<Orders>,
    news: Receiver<News>,
    /// Counts what was asked for.
    generation: u64,
    asked: Option<Document>,
    since: Instant,
    /// How far it is.
    pub phase: Phase,
    /// The latest picture.
    pub picture: Option<Picture>,
    /// What has settled; `None` while the sketch is another one.
    pub texture: Option<Texture>,
    /// Time from the change to the first picture of it.
    pub first_picture: Option<Duration>,
    /// How many of the lowest layers of what has settled were not grown again.
    pub kept: usize,
    paused: bool,
}

impl Growth {
    /// Starts the thread. It calls `wake` when there is something to be seen.
    #[must_use]
    pub fn new(wake: impl Fn() + Send + Sync + 'static) -> Self {
        let (orders, news) = worker::start(wake);
        Self {
            orders,
            news,
            generation: 0,
            asked: None,
            since: Instant::now(),
            phase: Phase::Idle,
            picture: None,
            texture: None,
            first_picture: None,
            kept: 0,
            paused: false,
        }
    }

    /// By how many threads it grows from the next time on; `None` = as many as there are cores, but for one. What
    /// grows is the same.
    pub fn use_threads(&self, threads: Option<usize>) {
        self.orders.use_threads(threads);
    }

    /// Grows `document` instead of what is growing, unless that is the same; empty ones are not grown.
    pub fn grow(&mut self, document: &Document) {
        if document.layers.is_empty() {
            if self.asked.take().is_some() {
                self.cancel();
            }
            self.phase = Phase::Idle;
            self.picture = None;
            return;
        }
        let needed = essence(document);
        if self.asked.as_ref().is_some_and(|asked| essence(asked) == needed) {
            self.repaint(document);
        } else {
            self.begin(document);
        }
    }

    /// Grows `document` again from the beginning.
    fn begin(&mut self, document: &Document) {
        self.generation += 1;
        self.asked = Some(document.clone());
        self.since = Instant::now();
        self.first_picture = None;
        self.texture = None;
        self.phase = Phase::Growing(Stage::Plan, 0.0);
        self.pause(false);
        self.orders.grow(self.generation, document);
    }

    /// The same pattern in other colours.
    fn repaint(&mut self, document: &Document) {
        if self.asked.as_ref() == Some(document) {
            return;
        }
        self.asked = Some(document.clone());
        if let Some(texture) = &mut self.texture {
            texture.document = Arc::new(document.clone());
            self.orders.paint(self.generation, texture.clone());
        } else {
            self.orders.colour(self.generation, document);
        }
    }

    /// Counts growths: one in other colours is the same one.
    #[must_use]
    pub fn generation(&self) -> u64 {
        self.generation
    }

    /// Grows it again, whatever is there.
    pub fn again(&mut self, document: &Document) {
        if !document.layers.is_empty() {
            self.begin(document);
        }
    }

    /// Tells what has grown already of the document that comes next: what is the same need not be grown again.
    pub fn know(&self, grown: &Arc<Grown>) {
        self.orders.know(grown);
    }

    /// Another document comes: what is there does not belong to it.
    pub fn forget(&mut self) {
        self.cancel();
        self.asked = None;
        self.picture = None;
        self.phase = Phase::Idle;
    }

    /// Is there nothing that has grown or grows?
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.asked.is_none()
    }

    /// Stops; what is there stays.
    pub fn stop(&mut self) {
        if matches!(self.phase, Phase::Growing(..)) {
            self.cancel();
            self.phase = Phase::Stopped;
        }
    }

    fn cancel(&mut self) {
        self.generation += 1;
        self.texture = None;
        self.pause(false);
        self.orders.cancel(self.generation);
    }

    /// Is it paused?
    #[must_use]
    pub fn is_paused(&self) -> bool {
        self.paused
    }

    /// Is something growing, paused or not?
    #[must_use]
    pub fn is_growing(&self) -> bool {
        matches!(self.phase, Phase::Growing(..))
    }

    /// Pauses, or goes on.
    pub fn pause(&mut self, paused: bool) {
        self.paused = paused;
        self.orders.pause(paused);
    }

    /// Takes in what the thread has to tell; never waits. Gives whether there is another picture.
    pub fn listen(&mut self) -> bool {
        let mut another = false;
        while let Ok(news) = self.news.try_recv() {
            if news.generation != self.generation {
                continue;
            }
            match news.what {
                worker::What::Picture(picture) => {
                    self.first_picture.get_or_insert_with(|| self.since.elapsed());
                    self.picture = Some(picture);
                    another = true;
                }
                worker::What::Settled(texture, picture, kept) => {
                    self.kept = kept;
                    self.first_picture.get_or_insert_with(|| self.since.elapsed());
                    self.texture = Some(texture);
                    self.picture = Some(picture);
                    self.phase = Phase::Settled(self.since.elapsed());
                    another = true;
                    // Its colours may have been changed in the meantime.
                    if let Some(asked) = self.asked.take() {
                        self.repaint_late(asked);
                    }
                }
                worker::What::Failed(why) => self.phase = Phase::Failed(why),
            }
        }
        if let (Phase::Growing(stage, share), Some((now, done))) =
            (&mut self.phase, self.orders.progress(self.generation))
        {
            (*stage, *share) = (now, done);
        }
        another
    }

    fn repaint_late(&mut self, asked: Document) {
        let same = self.texture.as_ref().is_none_or(|texture| *texture.document == asked);
        self.asked = Some(asked.clone());
        if let (false, Some(texture)) = (same, &mut self.texture) {
            texture.document = Arc::new(asked);
            self.orders.paint(self.generation, texture.clone());
        }
    }
}

impl Drop for Growth {
    fn drop(&mut self) {
        self.orders.end();
    }
}

/// What the pattern depends on: the document without its names, colours and dots an inch.
pub(in crate::app) fn essence(document: &Document) -> Document {
    let mut essence = Document { name: String::new(), dpi: 300.0, ..document.clone() };
    for layer in &mut essence.layers {
        layer.name.clear();
        layer.colours = None;
        layer.visible = true;
    }
    essence
}
