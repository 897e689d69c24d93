//! Work on a separate thread, as a value: the work sends messages, reports progress, can be paused, and is cancelled
//! when the value is dropped.
//!
//! A newer task replaces an older one by assignment: dropping the older one cancels it, and its later messages are not
//! received. [`Tasks`] starts tasks; a thread that cannot be started is an error of [`Tasks::start`].

use std::fmt;
use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{self, Receiver, Sender, TryRecvError};
use std::time::Duration;

use crate::machine::clock::Instant;
use crate::machine::memory::give_back;
use crate::machine::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use crate::machine::threads::{self, JoinHandle};

/// What a thread runs.
pub type Body = Box<dyn FnOnce() + Send>;
/// How a thread with a name is started: by the system, unless a test replaces it.
#[derive(Clone, Copy)]
pub struct Spawn(pub fn(&'static str, Body) -> io::Result<JoinHandle<()>>);

impl Default for Spawn {
    fn default() -> Self {
        Self(threads::start)
    }
}

/// A thread that could not be started.
#[derive(Debug, thiserror::Error)]
#[error("the system could not start a thread for {task}: {source}; close other programs and try again")]
pub struct StartError {
    /// What the thread was for.
    pub task: &'static str,
    /// What the system reported.
    source: io::Error,
}

/// Starts tasks.
#[derive(Clone)]
pub struct Tasks {
    wake: Arc<dyn Fn() + Send + Sync>,
    spawn: Spawn,
}

impl fmt::Debug for Tasks {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Tasks").finish_non_exhaustive()
    }
}

impl Default for Tasks {
    /// Tasks whose messages call no function.
    fn default() -> Self {
        Self::new(|| {})
    }
}

impl Tasks {
    /// Tasks that call `wake` after each message and at their end.
    #[must_use]
    pub fn new(wake: impl Fn() + Send + Sync + 'static) -> Self {
        Self { wake: Arc::new(wake), spawn: Spawn::default() }
    }

    /// These tasks, with threads that `spawn` starts.
    #[must_use]
    pub fn with_spawn(self, spawn: Spawn) -> Self {
        Self { spawn, ..self }
    }

    /// Runs `work` on a new thread. `name` names the thread and says in an error what it was for.
    ///
    /// # Errors
    /// Where the system has no thread left.
    pub fn start<T: Send + 'static>(
        &self,
        name: &'static str,
        work: impl FnOnce(&Worker<T>) + Send + 'static,
    ) -> Result<Task<T>, StartError> {
        let state = Arc::new(State::default());
        let (send, messages) = mpsc::channel();
        let worker = Worker { state: Arc::clone(&state), send: Some(send), wake: Arc::clone(&self.wake) };
        let run = move || {
            work(&worker);
            let is_cancelled = worker.is_cancelled();
            drop(worker);
            // After a cancelled task, another one often follows at once and needs the memory.
            if !is_cancelled {
                give_back();
            }
        };
        let thread = (self.spawn.0)(name, Box::new(run));
        let thread = thread.map_err(|source| StartError { task: name, source })?;
        Ok(Task { state, messages, thread: Some(thread), ended: false })
    }
}

#[derive(Default)]
struct State {
    cancelled: AtomicBool,
    /// The share of the work that is done, as the bits of an `f64`.
    progress: AtomicU64,
    paused: Mutex<bool>,
    changed: Condvar,
}

impl State {
    fn paused(&self) -> MutexGuard<'_, bool> {
        self.paused.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Acquire)
    }
}

/// Work on a separate thread, which sends messages of type `T`. Dropping it cancels the work, without waiting for its
/// end.
pub struct Task<T> {
    state: Arc<State>,
    messages: Receiver<T>,
    thread: Option<JoinHandle<()>>,
    ended: bool,
}

impl<T> Task<T> {
    /// The next message, if there is one; never waits.
    pub fn poll(&mut self) -> Option<T> {
        match self.messages.try_recv() {
            Ok(message) => Some(message),
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => {
                self.ended = true;
                None
            }
        }
    }

    /// Whether the work is over and [`Self::poll`] has returned its last message.
    #[must_use]
    pub fn has_ended(&self) -> bool {
        self.ended
    }

    /// Whether the thread has ended; messages may still be unread.
    #[must_use]
    pub fn is_finished(&self) -> bool {
        self.thread.as_ref().is_none_or(JoinHandle::is_finished)
    }

    /// The share of the work that is done, 0..1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        f64::from_bits(self.state.progress.load(Ordering::Acquire))
    }

    /// Pauses the work at its next [`Worker::pause_point`], or continues it.
    pub fn pause(&self, paused: bool) {
        *self.state.paused() = paused;
        self.state.changed.notify_all();
    }

    /// Asks the work to end early. Messages that it sends after that are received.
    pub fn cancel(&self) {
        // Done under the lock, so that a worker cannot miss the cancellation between its check and its wait.
        let paused = self.state.paused();
        self.state.cancelled.store(true, Ordering::Release);
        drop(paused);
        self.state.changed.notify_all();
    }

    /// Whether it was cancelled.
    #[must_use]
    pub fn is_cancelled(&self) -> bool {
        self.state.is_cancelled()
    }

    /// Cancels the work; the returned value can wait for its end.
    #[must_use]
    pub fn into_ending(mut self) -> Ending {
        self.cancel();
        Ending(self.thread.take())
    }

    /// Waits for the end of the work; its messages can be received afterwards.
    pub fn wait(&mut self) {
        if let Some(thread) = self.thread.take() {
            // A panic has closed the channel, so the receiver knows that there is no result.
            drop(thread.join());
        }
    }

    /// Waits for the end of the work and returns the messages that were not received yet.
    pub fn join(mut self) -> Vec<T> {
        self.wait();
        self.messages.iter().collect()
    }
}

impl<T> Drop for Task<T> {
    fn drop(&mut self) {
        self.cancel();
    }
}

/// A cancelled task that may still run for a moment.
pub struct Ending(Option<JoinHandle<()>>);

impl Ending {
    /// Waits until it has ended.
    pub fn wait(self) {
        if let Some(thread) = self.0 {
            drop(thread.join());
        }
    }
}

/// The thread's side of a task.
pub struct Worker<T> {
    state: Arc<State>,
    /// The sender; `None` once it is dropped.
    send: Option<Sender<T>>,
    wake: Arc<dyn Fn() + Send + Sync>,
}

impl<T> Worker<T> {
    /// Sends a message and wakes the receiver.
    pub fn send(&self, message: T) {
        self.send_ahead(message);
        (self.wake)();
    }

    /// Sends a message that [`Self::send`] will follow soon; the receiver is not woken.
    pub fn send_ahead(&self, message: T) {
        if let Some(send) = &self.send {
            // An error means that the task was dropped, so that nobody needs the message.
            drop(send.send(message));
        }
    }

    /// Sets the share of the work that is done, 0..1.
    pub fn set_progress(&self, share: f64) {
        self.state.progress.store(share.to_bits(), Ordering::Release);
    }

    /// Whether the work shall end early.
    #[must_use]
    pub fn is_cancelled(&self) -> bool {
        self.state.is_cancelled()
    }

    /// Waits while the task is paused and not cancelled.
    pub fn pause_point(&self) {
        let paused = self.state.paused();
        drop(self.state.changed.wait_while(paused, |paused| *paused && !self.is_cancelled()));
    }

    /// Waits until the time `until`, or until the task is cancelled.
    pub fn sleep_until(&self, until: Instant) {
        let mut paused = self.state.paused();
        loop {
            let left = until.saturating_duration_since(Instant::now());
            if left.is_zero() || self.is_cancelled() {
                return;
            }
            let waited = self.state.changed.wait_timeout(paused, left.min(Duration::from_secs(60)));
            paused = waited.unwrap_or_else(PoisonError::into_inner).0;
        }
    }
}

impl<T> Drop for Worker<T> {
    /// Runs also where the work panics: the receiver is woken and finds that the task has ended.
    fn drop(&mut self) {
        self.send = None;
        (self.wake)();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn no_thread(_: &'static str, _: Body) -> io::Result<JoinHandle<()>> {
        Err(io::Error::new(io::ErrorKind::WouldBlock, "none left"))
    }

    /// Polls until the task sends a message or ends.
    fn next<T>(task: &mut Task<T>) -> Option<T> {
        loop {
            let message = task.poll();
            if message.is_some() || task.has_ended() {
                return message;
            }
            std::thread::yield_now();
        }
    }

    #[test]
    fn messages_come_in_order_and_then_the_task_has_ended() {
        let mut task = Tasks::default()
            .start("counting", |worker| {
                worker.set_progress(0.5);
                (0..3).for_each(|number| worker.send(number));
            })
            .unwrap();
        assert_eq!([next(&mut task), next(&mut task), next(&mut task)], [Some(0), Some(1), Some(2)]);
        assert_eq!((next(&mut task), task.has_ended(), task.progress()), (None, true, 0.5));
    }

    #[test]
    fn a_message_sent_ahead_arrives_with_the_next_one_and_does_not_wake_the_receiver() {
        let woken = Arc::new(AtomicU64::new(0));
        let count = Arc::clone(&woken);
        let tasks = Tasks::new(move || {
            count.fetch_add(1, Ordering::AcqRel);
        });
        let task = tasks.start("counting", |worker| {
            worker.send_ahead(0);
            worker.send(1);
        });
        assert_eq!(task.unwrap().join(), [0, 1]);
        // Once by the message and once by the end.
        assert_eq!(woken.load(Ordering::Acquire), 2);
    }

    #[test]
    fn a_dropped_task_is_cancelled() {
        let (tell, output) = mpsc::channel();
        let task = Tasks::default().start("waiting", move |worker: &Worker<()>| {
            worker.sleep_until(Instant::now() + Duration::from_secs(600));
            tell.send(worker.is_cancelled()).unwrap();
        });
        drop(task.unwrap());
        assert!(output.recv().unwrap());
    }

    #[test]
    fn a_task_that_is_joined_is_not_cancelled_and_all_its_messages_arrive() {
        let task = Tasks::default().start("saving", |worker| {
            // It would wait less if it were cancelled.
            worker.sleep_until(Instant::now() + Duration::from_millis(20));
            worker.send(worker.is_cancelled());
        });
        assert_eq!(task.unwrap().join(), [false]);
    }

    #[test]
    fn a_paused_task_goes_on_when_it_is_continued_or_cancelled() {
        for cancel in [false, true] {
            let (gate, opened) = mpsc::channel();
            let (wake, woken) = mpsc::channel();
            let tasks = Tasks::new(move || {
                let _ = wake.send(());
            });
            let task = tasks.start("pausing", move |worker| {
                opened.recv().unwrap();
                worker.pause_point();
                worker.send(());
            });
            let mut task = task.unwrap();
            task.pause(true);
            gate.send(()).unwrap();
            assert!(woken.recv_timeout(Duration::from_millis(20)).is_err());
            assert!(task.poll().is_none() && !task.has_ended());
            if cancel {
                task.cancel();
            } else {
                task.pause(false);
            }
            assert_eq!(next(&mut task), Some(()));
        }
    }

    #[test]
    fn a_panic_ends_the_task_without_a_message() {
        let woken = Arc::new(AtomicBool::new(false));
        let wake = Arc::clone(&woken);
        let tasks = Tasks::new(move || wake.store(true, Ordering::SeqCst));
        let mut task = tasks.start("failing", |_: &Worker<()>| panic!("on purpose")).unwrap();
        assert_eq!((next(&mut task), task.has_ended()), (None, true));
        assert!(task.join().is_empty() && woken.load(Ordering::SeqCst));
    }

    #[test]
    fn the_receiver_is_woken_at_each_message_and_at_the_end() {
        let woken = Arc::new(AtomicU64::new(0));
        let count = Arc::clone(&woken);
        let tasks = Tasks::new(move || {
            count.fetch_add(1, Ordering::SeqCst);
        });
        tasks.start("waking", |worker| worker.send(())).unwrap().join();
        assert_eq!(woken.load(Ordering::SeqCst), 2);
    }

    #[test]
    fn a_thread_that_does_not_start_is_an_error_that_names_the_task() {
        let started = Tasks::default().with_spawn(Spawn(no_thread)).start("growth", |_: &Worker<()>| {});
        let said = started.err().unwrap().to_string();
        assert!(said.contains("growth") && said.contains("none left"), "{said}");
    }
}
