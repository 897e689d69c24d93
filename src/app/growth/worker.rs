//! The thread that grows: the latest order wins.

use std::panic::{self, AssertUnwindSafe};
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::mpsc::{self, Receiver, Sender};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use super::preview::preview;
use super::{Picture, Texture, essence};
use crate::document::Document;
use crate::synth::render::painting::Look;
use crate::synth::{
    GrowError, Grown, GrownLayer, Options, Settings, Stage, Training, Watch, regrow_seen, unchanged,
};

/// Pictures of a growth come no faster than this.
const BETWEEN_PICTURES: Duration = Duration::from_millis(60);

/// What the thread tells, and of which order.
pub(super) struct News {
    pub(super) generation: u64,
    pub(super) what: What,
}

pub(super) enum What {
    /// How it looks by now.
    Picture(Picture),
    /// It has settled; so many of its lowest layers were taken over from what had grown before.
    Settled(Texture, Picture, usize),
    /// It cannot be grown.
    Failed(String),
}

/// What the thread is asked for.
pub(super) struct Orders {
    next: Mutex<Next>,
    called: Condvar,
    /// The order that counts; others are given up.
    generation: AtomicU64,
    paused: AtomicBool,
    /// 0 = as many as there are cores, but for one.
    threads: AtomicUsize,
    /// What has grown elsewhere of the document that comes next.
    known: Mutex<Option<Arc<Grown>>>,
    /// Generation (upper 32 bits), stage and share (per 65,535) of what is being done.
    progress: AtomicU64,
    /// In whose colours the order that grows is seen, where they are others by now.
    colours: Mutex<Option<(u64, Arc<Document>)>>,
}

#[derive(Default)]
struct Next {
    job: Option<Job>,
    end: bool,
}

enum Job {
    Grow(u64, Document),
    Paint(u64, Texture),
}

impl Orders {
    fn order(&self, job: Option<Job>) {
        let mut next = self.next.lock().unwrap_or_else(PoisonError::into_inner);
        next.job = job;
        drop(next);
        self.called.notify_all();
    }

    pub(super) fn grow(&self, generation: u64, document: &Document) {
        self.generation.store(generation, Ordering::Release);
        self.order(Some(Job::Grow(generation, document.clone())));
    }

    pub(super) fn paint(&self, generation: u64, texture: Texture) {
        self.order(Some(Job::Paint(generation, texture)));
    }

    /// From now on the growth of order `generation` is seen in the colours of `document`; it goes on.
    pub(super) fn colour(&self, generation: u64, document: &Document) {
        let colours = Some((generation, Arc::new(document.clone())));
        *self.colours.lock().unwrap_or_else(PoisonError::into_inner) = colours;
    }

    /// `document`, or the same in the colours that were asked for since.
    fn coloured(&self, generation: u64, document: &Arc<Document>) -> Arc<Document> {
        let colours = self.colours.lock().unwrap_or_else(PoisonError::into_inner);
        let newer = colours.as_ref().filter(|(of, _)| *of == generation);
        Arc::clone(newer.map_or(document, |(_, newer)| newer))
    }

    pub(super) fn cancel(&self, generation: u64) {
        self.generation.store(generation, Ordering::Release);
        self.order(None);
    }

    pub(super) fn pause(&self, paused: bool) {
        self.paused.store(paused, Ordering::Release);
        // The lock makes sure that nobody falls asleep between its look and our call.
        drop(self.next.lock());
        self.called.notify_all();
    }

    pub(super) fn use_threads(&self, threads: Option<usize>) {
        self.threads.store(threads.unwrap_or(0), Ordering::Relaxed);
    }

    pub(super) fn know(&self, grown: &Arc<Grown>) {
        *self.known.lock().unwrap_or_else(PoisonError::into_inner) = Some(Arc::clone(grown));
    }

    pub(super) fn end(&self) {
        self.next.lock().unwrap_or_else(PoisonError::into_inner).end = true;
        self.cancel(u64::MAX);
        self.pause(false);
    }

    /// How far order `generation` is.
    pub(super) fn progress(&self, generation: u64) -> Option<(Stage, f64)> {
        let told = self.progress.load(Ordering::Acquire);
        let stage = [Stage::Plan, Stage::Grow, Stage::Refine, Stage::Write];
        let of = (told >> 32) == (generation & 0xffff_ffff);
        of.then(|| (stage[(told >> 16 & 3) as usize], (told & 0xffff) as f64 / 65_535.0))
    }

    fn tell(&self, generation: u64, stage: Stage, share: f64) {
        let stage = match stage {
            Stage::Plan => 0,
            Stage::Grow => 1,
            Stage::Refine => 2,
            Stage::Write => 3,
        };
        let share = (share.clamp(0.0, 1.0) * 65_535.0) as u64;
        self.progress.store((generation & 0xffff_ffff) << 32 | stage << 16 | share, Ordering::Release);
    }

    fn is_over(&self, generation: u64) -> bool {
        self.generation.load(Ordering::Acquire) != generation
    }

    /// Sleeps while it is paused.
    fn wait_while_paused(&self, generation: u64) {
        let paused = || self.paused.load(Ordering::Acquire) && !self.is_over(generation);
        if paused() {
            let next = self.next.lock().unwrap_or_else(PoisonError::into_inner);
            drop(self.called.wait_while(next, |next| paused() && !next.end));
        }
    }

    /// Sleeps until there is something to do; `None` = go home.
    fn next(&self) -> Option<Job> {
        let next = self.next.lock().unwrap_or_else(PoisonError::into_inner);
        let waited = self.called.wait_while(next, |next| next.job.is_none() && !next.end);
        let mut next = waited.unwrap_or_else(PoisonError::into_inner);
        if next.end { None } else { next.job.take() }
    }
}

/// Starts the thread.
pub(super) fn start(wake: impl Fn() + Send + Sync + 'static) -> (Arc<Orders>, Receiver<News>) {
    let orders = Arc::new(Orders {
        next: Mutex::default(),
        called: Condvar::new(),
        generation: AtomicU64::new(0),
        paused: AtomicBool::new(false),
        threads: AtomicUsize::new(0),
        known: Mutex::default(),
        progress: AtomicU64::new(u64::MAX),
        colours: Mutex::default(),
    });
    let (tell, news) = mpsc::channel();
    let worker = Worker {
        orders: Arc::clone(&orders),
        tell,
        wake: Box::new(wake),
        training: Training::default(),
        before: Mutex::default(),
    };
    let started = thread::Builder::new().name("growth".to_owned()).spawn(move || worker.run());
    // Without a thread nothing grows; the program still draws and saves.
    drop(started);
    (orders, news)
}

struct Worker {
    orders: Arc<Orders>,
    tell: Sender<News>,
    wake: Box<dyn Fn() + Send + Sync>,
    training: Training,
    /// What settled last: layers that were not changed are taken from there.
    before: Mutex<Option<Arc<Grown>>>,
}

impl Worker {
    fn run(&self) {
        let cores = thread::available_parallelism().map_or(1, usize::from);
        let mut pool = None;
        while let Some(job) = self.orders.next() {
            // A core is left to the window, unless it is said how many.
            let threads = match self.orders.threads.load(Ordering::Relaxed) {
                0 => cores.saturating_sub(1).max(1),
                threads => threads,
            };
            if pool.as_ref().is_none_or(|(size, _)| *size != threads) {
                pool = Some((threads, rayon::ThreadPoolBuilder::new().num_threads(threads).build()));
            }
            match &pool {
                Some((_, Ok(pool))) => pool.install(|| self.work(job)),
                _ => self.work(job),
            }
        }
    }

    fn work(&self, job: Job) {
        match job {
            Job::Grow(generation, document) => self.grow(generation, document),
            Job::Paint(generation, texture) => {
                let picture = Picture::settled(&texture);
                self.say(generation, What::Picture(picture));
            }
        }
    }

    fn say(&self, generation: u64, what: What) {
        // The window may have gone.
        let _ = self.tell.send(News { generation, what });
        (self.wake)();
    }

    fn grow(&self, generation: u64, document: Document) {
        let orders = &self.orders;
        let document = Arc::new(document);
        let progress = |stage, share| {
            orders.tell(generation, stage, share);
            orders.wait_while_paused(generation);
        };
        let watch = Watch { progress: &progress, cancelled: &|| orders.is_over(generation) };
        let known = orders.known.lock().unwrap_or_else(PoisonError::into_inner).take();
        let known = known.filter(|known| essence(&known.document) == essence(&document));
        let is_known = known.is_some();
        let before = known.or_else(|| self.before.lock().unwrap_or_else(PoisonError::into_inner).clone());
        let kept = before.as_ref().map_or(0, |before| unchanged(&document, Settings::default(), before));
        let mut done = kept;
        let mut shown: Option<Instant> = None;
        let beneath = before.as_ref().map_or(&[][..], |before| &before.layers[..kept]);
        let first = if is_known { None } else { preview(&document, &self.training, beneath) };
        if let Some(picture) = first.filter(|_| !orders.is_over(generation)) {
            self.say(generation, What::Picture(picture));
        }
        let mut seen = |look: &Look| {
            if look.beneath.len() > done {
                done = look.beneath.len();
                self.remember(&document, look.beneath);
            }
            if shown.is_none_or(|shown| shown.elapsed() >= BETWEEN_PICTURES) && !orders.is_over(generation) {
                self.say(
                    generation,
                    What::Picture(Picture::growing(&orders.coloured(generation, &document), look)),
                );
                shown = Some(Instant::now());
            }
        };
        let mut grown = || {
            let options =
                Options { source: "the sketch", training: &self.training, watch, ..Options::default() };
            regrow_seen(&document, &options, before.as_deref(), &mut seen)
        };
        // A fault in growing must not take the sketch along.
        let Ok(grown) = panic::catch_unwind(AssertUnwindSafe(&mut grown)) else {
            let why = "growing it failed inside dapple; please report the document. The sketch is not harmed: \
                       save it, or change it and it is grown anew";
            self.say(generation, What::Failed(why.to_owned()));
            return;
        };
        match grown {
            Ok(grown) => self.settled(generation, &document, grown, kept),
            Err(GrowError::Cancelled(_)) => {}
            Err(error) => self.say(generation, What::Failed(error.to_string())),
        }
    }

    fn settled(&self, generation: u64, document: &Arc<Document>, grown: Grown, kept: usize) {
        let document = self.orders.coloured(generation, document);
        let texture = Texture { document, grown: Arc::new(grown) };
        *self.before.lock().unwrap_or_else(PoisonError::into_inner) = Some(Arc::clone(&texture.grown));
        let picture = Picture::settled(&texture);
        self.say(generation, What::Settled(texture, picture, kept));
    }

    /// Keeps the layers of `document` that have grown so far: should it be changed while the next one grows, they need
    /// not grow again.
    fn remember(&self, document: &Document, layers: &[GrownLayer]) {
        let mut document = document.clone();
        document.layers.truncate(layers.len());
        let grown =
            Grown { size: document.size, layers: layers.to_vec(), document, settings: Settings::default() };
        *self.before.lock().unwrap_or_else(PoisonError::into_inner) = Some(Arc::new(grown));
    }
}
