//! Threads in a browser: workers that share the program's memory. The page starts them; each takes one piece of work after the
//! other from a queue. Pools take workers for as long as they live.
//!
//! The page's own thread must not wait, and never enters a pool.

use std::cell::Cell;
use std::collections::VecDeque;
use std::hint::spin_loop;
use std::io;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, TryLockError};
use std::time::Duration;

pub use rayon::{ThreadPool, ThreadPoolBuildError};

type Work = Box<dyn FnOnce() + Send>;

static QUEUE: Mutex<VecDeque<Work>> = Mutex::new(VecDeque::new());
static FILLED: Condvar = Condvar::new();
/// Workers that wait for work.
static IDLE: AtomicUsize = AtomicUsize::new(0);
/// Whether workers may start.
static OPEN: AtomicBool = AtomicBool::new(false);
static CORES: AtomicUsize = AtomicUsize::new(1);
static PANICKED: AtomicBool = AtomicBool::new(false);
/// Whether a started thread begins to run while the window blocks: no, because the page may have to start a worker
/// first.
pub const BEGINS_WHILE_WAITED_FOR: bool = false;
/// The most threads of a pool. Each is a worker with its own stack.
const MOST: usize = 8;

thread_local! {
    static IS_WORKER: Cell<bool> = const { Cell::new(false) };
}

/// Whether this is the page's thread.
#[must_use]
pub fn is_page() -> bool {
    !IS_WORKER.get()
}

/// Records that a thread has panicked. It no longer exists, and the locks that it held stay locked.
pub fn note_panic() {
    PANICKED.store(true, Ordering::Release);
}

/// Panics if another thread has panicked, so that nothing waits for that thread for ever.
///
/// # Panics
/// If another thread has panicked.
pub fn fail_if_panicked() {
    assert!(!PANICKED.load(Ordering::Acquire), "another thread has failed");
}

/// The number of threads that this machine runs at once.
#[must_use]
pub fn cores() -> usize {
    CORES.load(Ordering::Relaxed)
}

/// Sets the number of threads that the machine runs at once.
pub fn set_cores(cores: usize) {
    CORES.store(cores.clamp(1, MOST), Ordering::Relaxed);
}

/// Lets workers start: the data that they need have arrived.
pub fn open() {
    OPEN.store(true, Ordering::Release);
    FILLED.notify_all();
}

fn queue() -> MutexGuard<'static, VecDeque<Work>> {
    loop {
        match QUEUE.try_lock() {
            Ok(queue) => return queue,
            Err(TryLockError::Poisoned(error)) => return error.into_inner(),
            Err(TryLockError::WouldBlock) => spin_loop(),
        }
    }
}

fn put(work: Work) {
    queue().push_back(work);
    FILLED.notify_one();
}

/// The number of workers that are needed in addition to the idle ones.
#[must_use]
pub fn wanted() -> usize {
    queue().len().saturating_sub(IDLE.load(Ordering::Acquire))
}

/// The loop of a worker: does one piece of work after the other, without end.
pub fn serve() {
    IS_WORKER.set(true);
    loop {
        let mut waiting = queue();
        IDLE.fetch_add(1, Ordering::AcqRel);
        let work = loop {
            let next = if OPEN.load(Ordering::Acquire) { waiting.pop_front() } else { None };
            if let Some(work) = next {
                break work;
            }
            waiting = FILLED.wait(waiting).unwrap_or_else(std::sync::PoisonError::into_inner);
        };
        IDLE.fetch_sub(1, Ordering::AcqRel);
        drop(waiting);
        work();
    }
}

fn builder(threads: usize) -> rayon::ThreadPoolBuilder {
    let threads = if threads == 0 { cores() } else { threads.min(MOST) };
    rayon::ThreadPoolBuilder::new().num_threads(threads)
}

/// Runs a thread of a pool on a worker.
#[expect(clippy::unnecessary_wraps, reason = "a pool asks whether its thread was started")]
fn run(thread: rayon::ThreadBuilder) -> io::Result<()> {
    put(Box::new(|| thread.run()));
    Ok(())
}

/// A pool of `threads` threads; 0 = as many as there are cores.
///
/// # Errors
/// Never: the page starts as many workers as are needed.
pub fn pool(threads: usize) -> Result<ThreadPool, ThreadPoolBuildError> {
    builder(threads).spawn_handler(run).build()
}

/// Runs `work` in a pool of `threads` threads. `None` = in the pool that all of the program shares.
pub fn with<T: Send>(threads: Option<usize>, work: impl FnOnce() -> T + Send) -> T {
    match threads.and_then(|threads| pool(threads).ok()) {
        Some(pool) => pool.install(work),
        None => work(),
    }
}

/// Makes the pool that all of the program shares, on a worker. Has no effect once that pool has been made.
pub fn set_shared(threads: usize) {
    put(Box::new(move || {
        // An error says that the pool exists already.
        let _ = builder(threads).spawn_handler(run).build_global();
    }));
}

/// A thread that was started.
#[derive(Debug)]
pub struct JoinHandle<T>(Arc<AtomicBool>, std::marker::PhantomData<T>);

impl<T> JoinHandle<T> {
    /// Whether the thread has ended.
    #[must_use]
    pub fn is_finished(&self) -> bool {
        self.0.load(Ordering::Acquire)
    }
}

impl JoinHandle<()> {
    /// Waits for the end of the thread. The page's thread, which cannot block, checks repeatedly.
    ///
    /// # Errors
    /// Never: a thread that panics ends the program.
    pub fn join(self) -> Result<(), Box<dyn std::any::Any + Send>> {
        while !self.is_finished() {
            fail_if_panicked();
            if is_page() { spin_loop() } else { sleep(Duration::from_millis(1)) }
        }
        Ok(())
    }
}

/// The number of this process: there is one.
#[must_use]
pub fn process() -> u32 {
    0
}

/// Starts a thread that runs `work`.
///
/// # Errors
/// Never: the page starts as many workers as are needed.
pub fn start(_: &str, work: impl FnOnce() + Send + 'static) -> io::Result<JoinHandle<()>> {
    let ended = Arc::new(AtomicBool::new(false));
    let end = Arc::clone(&ended);
    put(Box::new(move || {
        work();
        end.store(true, Ordering::Release);
    }));
    Ok(JoinHandle(ended, std::marker::PhantomData))
}

/// Stops this thread for `time`. Must not be called on the page's thread.
pub fn sleep(time: Duration) {
    std::thread::sleep(time);
}
