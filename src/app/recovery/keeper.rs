//! The thread that keeps: the latest document wins, and the window never waits for the disk.

use std::path::{Path, PathBuf};
use std::sync::mpsc::{self, Receiver, Sender};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use super::slot::{Kept, Lost, Slot};

/// What changes without a pause is written no oftener than this. With what a slow disk takes it is well below the five
/// seconds that are promised.
const BETWEEN: Duration = Duration::from_millis(1500);

/// What the thread tells.
#[derive(Debug)]
pub enum News {
    /// It is on the disk; writing it took so long.
    Kept(Duration),
    /// It could not be kept: why.
    Failed(String),
}

enum Job {
    Keep(Box<Kept>),
    Clear,
}

#[derive(Default)]
struct Next {
    job: Option<Job>,
    /// What is in the next document too, and need not be kept twice.
    settled: Vec<Lost>,
    end: bool,
}

#[derive(Default)]
struct Orders {
    next: Mutex<Next>,
    called: Condvar,
}

impl Orders {
    fn next(&self) -> MutexGuard<'_, Next> {
        self.next.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The window's side of it.
pub struct Keeper {
    orders: Arc<Orders>,
    thread: Option<JoinHandle<()>>,
    news: Receiver<News>,
}

impl Keeper {
    /// Starts the thread; it keeps in `folder` and calls `wake` when there is something to tell. `None` where the
    /// system has no thread left.
    #[must_use]
    pub fn start(folder: &Path, wake: impl Fn() + Send + 'static) -> Option<Self> {
        let orders = Arc::new(Orders::default());
        let (tell, news) = mpsc::channel();
        let worker = Worker {
            orders: Arc::clone(&orders),
            folder: folder.to_owned(),
            slot: None,
            tell,
            wake: Box::new(wake),
        };
        let thread = thread::Builder::new().name("recovery".to_owned()).spawn(move || worker.run()).ok()?;
        Some(Self { orders, thread: Some(thread), news })
    }

    /// Keeps this document instead of the last one. What was lost and is in it is forgotten once it is on the disk.
    pub fn keep(&self, kept: Kept, settled: Vec<Lost>) {
        self.order(Job::Keep(Box::new(kept)), settled);
    }

    /// There is nothing to keep any more.
    pub fn clear(&self) {
        self.order(Job::Clear, Vec::new());
    }

    fn order(&self, job: Job, settled: Vec<Lost>) {
        let mut next = self.orders.next();
        next.job = Some(job);
        next.settled.extend(settled);
        drop(next);
        self.orders.called.notify_all();
    }

    /// What the thread has to tell; never waits.
    #[must_use]
    pub fn news(&self) -> Option<News> {
        self.news.try_recv().ok()
    }
}

impl Drop for Keeper {
    /// What was not written yet is, before the thread goes.
    fn drop(&mut self) {
        self.orders.next().end = true;
        self.orders.called.notify_all();
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

struct Worker {
    orders: Arc<Orders>,
    folder: PathBuf,
    slot: Option<Slot>,
    tell: Sender<News>,
    wake: Box<dyn Fn() + Send>,
}

impl Worker {
    fn run(mut self) {
        let mut written: Option<Instant> = None;
        let orders = Arc::clone(&self.orders);
        loop {
            let next = orders.next();
            let waited = orders.called.wait_while(next, |next| next.job.is_none() && !next.end);
            let next = waited.unwrap_or_else(PoisonError::into_inner);
            let rest = written.map_or(Duration::ZERO, |written| BETWEEN.saturating_sub(written.elapsed()));
            // To forget is never too soon.
            let patient = |next: &mut Next| matches!(next.job, Some(Job::Keep(_))) && !next.end;
            let waited = orders.called.wait_timeout_while(next, rest, patient);
            let (mut next, _) = waited.unwrap_or_else(PoisonError::into_inner);
            let (job, settled) = (next.job.take(), std::mem::take(&mut next.settled));
            let end = next.end && job.is_none();
            drop(next);
            match job {
                Some(Job::Keep(kept)) => {
                    self.keep(&kept, settled);
                    written = Some(Instant::now());
                }
                Some(Job::Clear) => self.clear(settled),
                None => {}
            }
            if end {
                return;
            }
        }
    }

    fn keep(&mut self, kept: &Kept, settled: Vec<Lost>) {
        let began = Instant::now();
        match self.write(kept) {
            Ok(()) => {
                forget(settled);
                self.say(News::Kept(began.elapsed()));
            }
            Err(why) => {
                // They are still all there is; the next document that can be written holds them too.
                self.orders.next().settled.extend(settled);
                self.say(News::Failed(why));
            }
        }
    }

    fn write(&mut self, kept: &Kept) -> Result<(), String> {
        let slot = match &self.slot {
            Some(slot) => slot,
            None => {
                let slot = Slot::new(&self.folder);
                let slot = slot.map_err(|error| format!("'{}': {error}", self.folder.display()))?;
                self.slot.insert(slot)
            }
        };
        slot.write(kept).map_err(|error| error.to_string())
    }

    fn clear(&mut self, settled: Vec<Lost>) {
        forget(settled);
        if let Some(Err(error)) = self.slot.as_ref().map(Slot::clear) {
            self.say(News::Failed(format!("'{}': {error}", self.folder.display())));
        }
    }

    fn say(&self, news: News) {
        // The window may have gone.
        let _ = self.tell.send(news);
        (self.wake)();
    }
}

fn forget(settled: Vec<Lost>) {
    for lost in settled {
        // What cannot be removed is offered again: better twice than never.
        let _ = lost.remove();
    }
}
