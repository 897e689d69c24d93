//! Growing and writing on another thread, with one common progress.

use crate::editor::task::{Task, Tasks, Worker};
use crate::machine::threads;
use crate::synth::{Stage, Watch};

/// Work that is being done on another thread. Dropping the job cancels the work.
pub struct Job<T> {
    task: Option<Task<Result<T, String>>>,
    /// Why no thread could be started.
    error: Option<String>,
}

impl<T: Send + 'static> Job<T> {
    /// Starts `work` with this number of threads (`None` = all cores). Writing takes the last part, `writing` (0..1),
    /// of the progress.
    #[must_use]
    pub fn start(
        tasks: &Tasks,
        threads: Option<usize>,
        writing: f64,
        work: impl FnOnce(&Watch) -> Result<T, String> + Send + 'static,
    ) -> Self {
        let task = tasks.start("exporting", move |worker: &Worker<_>| {
            let from = 1.0 - writing;
            let progress = |stage, share: f64| {
                worker.set_progress(match stage {
                    Stage::Plan => 0.05 * share * from,
                    Stage::Grow => (0.05 + 0.85 * share) * from,
                    Stage::Refine => (0.9 + 0.1 * share) * from,
                    Stage::Write => from + writing * share,
                });
            };
            let watch = Watch { progress: &progress, cancelled: &|| worker.is_cancelled() };
            worker.send(threads::with(threads, || work(&watch)));
        });
        match task {
            Ok(task) => Self { task: Some(task), error: None },
            Err(error) => Self { task: None, error: Some(error.to_string()) },
        }
    }

    /// The share of the work that is done, 0..1.
    #[must_use]
    pub fn progress(&self) -> f32 {
        self.task.as_ref().map_or(0.0, Task::progress) as f32
    }

    /// Cancels the work; no files are left.
    pub fn cancel(&self) {
        if let Some(task) = &self.task {
            task.cancel();
        }
    }

    /// Whether it was cancelled.
    #[must_use]
    pub fn is_cancelled(&self) -> bool {
        self.task.as_ref().is_some_and(Task::is_cancelled)
    }

    /// The result of the work, once it has ended; never blocks.
    pub fn outcome(&mut self) -> Option<Result<T, String>> {
        let Some(task) = &mut self.task else { return self.error.take().map(Err) };
        let outcome = task.poll();
        if outcome.is_none() && task.has_ended() {
            return Some(Err("an error in dapple; please report the document".to_owned()));
        }
        outcome
    }
}
