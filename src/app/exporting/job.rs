//! Work beside the window: it tells how far it is, can be given up, and says what came of it.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{self, Receiver};
use std::thread;

use crate::synth::{Stage, Watch};

/// Work that is being done. Dropped, it is given up.
pub struct Job<T> {
    done: Arc<AtomicU64>,
    cancelled: Arc<AtomicBool>,
    outcome: Receiver<Result<T, String>>,
}

impl<T: Send + 'static> Job<T> {
    /// Begins `work`, by so many `threads` (`None` = all cores). Writing makes up the last `writing` (0..1) of it. `wake`
    /// is called at the end.
    #[must_use]
    pub fn start(
        threads: Option<usize>,
        writing: f64,
        wake: impl FnOnce() + Send + 'static,
        work: impl FnOnce(&Watch) -> Result<T, String> + Send + 'static,
    ) -> Self {
        let (done, cancelled) = (Arc::new(AtomicU64::new(0)), Arc::new(AtomicBool::new(false)));
        let (tell, outcome) = mpsc::channel();
        let job = Self { done: Arc::clone(&done), cancelled: Arc::clone(&cancelled), outcome };
        thread::spawn(move || {
            let from = 1.0 - writing;
            let progress = |stage, share: f64| {
                let all = match stage {
                    Stage::Plan => 0.05 * share * from,
                    Stage::Grow => (0.05 + 0.85 * share) * from,
                    Stage::Refine => (0.9 + 0.1 * share) * from,
                    Stage::Write => from + writing * share,
                };
                done.store((1000.0 * all) as u64, Ordering::Relaxed);
            };
            let watch = Watch { progress: &progress, cancelled: &|| cancelled.load(Ordering::Relaxed) };
            let pool = threads.and_then(|n| rayon::ThreadPoolBuilder::new().num_threads(n).build().ok());
            let watch = &watch;
            // The window may have gone.
            let _ = tell.send(match pool {
                Some(pool) => pool.install(|| work(watch)),
                None => work(watch),
            });
            wake();
        });
        job
    }

    /// The share of it that is done, 0..1.
    #[must_use]
    pub fn progress(&self) -> f32 {
        self.done.load(Ordering::Relaxed) as f32 / 1000.0
    }

    /// Gives it up; nothing is left behind.
    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }

    /// Was it given up?
    #[must_use]
    pub fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }

    /// What came of it, once it is over.
    #[must_use]
    pub fn outcome(&self) -> Option<Result<T, String>> {
        match self.outcome.try_recv() {
            Ok(outcome) => Some(outcome),
            Err(mpsc::TryRecvError::Empty) => None,
            Err(mpsc::TryRecvError::Disconnected) => Some(Err("it ended before it was done".to_owned())),
        }
    }
}

impl<T> Drop for Job<T> {
    fn drop(&mut self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }
}
