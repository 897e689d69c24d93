//! Work on files that is finished even if the window closes meanwhile: dropping the value waits for the end of the
//! work.

use std::sync::Arc;

use super::task::{Task, Tasks, Worker};
use crate::machine::sync::{Mutex, PoisonError};
use crate::machine::threads::BEGINS_WHILE_WAITED_FOR;

/// The message where the work ended without a result.
const FAILED: &str = "an error in dapple; please report it";

/// Work that writes, renames or deletes files. Dropping it waits for its end.
pub struct Writing<T> {
    task: Option<Task<T>>,
    /// Does the work on the calling thread, unless a thread has started it.
    begin: Box<dyn Fn() -> Option<T> + Send>,
    /// The outcome where the calling thread has done the work.
    outcome: Option<T>,
}

impl<T: Send + 'static> Writing<T> {
    /// Does `work` on a separate thread. Where no thread can be started, the work is done before this returns: the
    /// window blocks, and nothing is lost.
    #[must_use]
    pub fn start(tasks: &Tasks, name: &'static str, work: impl FnOnce() -> T + Send + 'static) -> Self {
        // The system's error does not return the closure that it was to run.
        let work = Arc::new(Mutex::new(Some(work)));
        let take = |work: &Mutex<Option<_>>| work.lock().unwrap_or_else(PoisonError::into_inner).take();
        let shared = Arc::clone(&work);
        let task = tasks.start(name, move |worker: &Worker<T>| {
            if let Some(work) = take(&shared) {
                worker.send(work());
            }
        });
        let begin = Box::new(move || take(&work).map(|work| work()));
        let mut writing = Self { task: task.ok(), begin, outcome: None };
        if writing.task.is_none() {
            writing.outcome = (writing.begin)();
        }
        writing
    }

    /// The outcome, once it is over; never waits.
    pub fn poll(&mut self) -> Option<Result<T, &'static str>> {
        let Some(task) = &mut self.task else { return self.outcome.take().map(Ok) };
        let outcome = task.poll().map(Ok);
        let outcome = outcome.or_else(|| task.has_ended().then_some(Err(FAILED)))?;
        self.task = None;
        Some(outcome)
    }

    /// Waits for the end and returns the outcome, unless [`Self::poll`] has returned it.
    pub fn wait(mut self) -> Option<Result<T, &'static str>> {
        self.finish();
        self.poll()
    }
}

impl<T> Writing<T> {
    fn finish(&mut self) {
        let Some(task) = &mut self.task else { return };
        let begun_here = if BEGINS_WHILE_WAITED_FOR { None } else { (self.begin)() };
        if begun_here.is_some() {
            (self.task, self.outcome) = (None, begun_here);
        } else {
            task.wait();
        }
    }
}

impl<T> Drop for Writing<T> {
    fn drop(&mut self) {
        self.finish();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::editor::task::Spawn;
    use std::fs;
    use std::io;

    /// Tasks with threads, and without.
    fn both() -> [Tasks; 2] {
        [Tasks::default(), Tasks::default().with_spawn(Spawn(|_, _| Err(io::Error::other("none left"))))]
    }

    #[test]
    fn work_that_is_dropped_at_once_is_finished_with_a_thread_and_without() {
        let folder = tempfile::tempdir().unwrap();
        for (tasks, name) in both().iter().zip(["a", "b"]) {
            let file = folder.path().join(name);
            let to = file.clone();
            drop(Writing::start(tasks, "writing", move || fs::write(to, "all of it").unwrap()));
            assert_eq!(fs::read_to_string(&file).unwrap(), "all of it");
        }
    }

    #[test]
    fn the_outcome_comes_once() {
        for tasks in both() {
            let mut work = Writing::start(&tasks, "writing", || 7);
            work.finish();
            assert_eq!(work.poll(), Some(Ok(7)));
            assert_eq!(work.poll(), None);
            assert_eq!(Writing::start(&tasks, "writing", || 7).wait(), Some(Ok(7)));
        }
    }

    #[test]
    fn work_that_panics_is_an_error() {
        let work = Writing::start(&Tasks::default(), "failing", || -> u8 { panic!("on purpose") });
        assert_eq!(work.wait(), Some(Err(FAILED)));
    }
}
