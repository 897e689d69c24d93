//! Threads: how many the machine runs at once, pools of them, and single ones.

use std::io;
use std::thread;
use std::time::Duration;

pub use rayon::{ThreadPool, ThreadPoolBuildError};
pub use std::thread::JoinHandle;

/// Whether a started thread begins to run while the window blocks.
pub const BEGINS_WHILE_WAITED_FOR: bool = true;

/// The number of threads that this machine runs at once; 1 where the system does not report it.
#[must_use]
pub fn cores() -> usize {
    thread::available_parallelism().map_or(1, usize::from)
}

/// A pool of `threads` threads; 0 = as many as there are cores.
///
/// # Errors
/// Where the system does not have enough threads left.
pub fn pool(threads: usize) -> Result<ThreadPool, ThreadPoolBuildError> {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build()
}

/// Runs `work` in a pool of `threads` threads; in the pool that the whole program shares where `threads` is `None`, or
/// where there are no threads left.
pub fn with<T: Send>(threads: Option<usize>, work: impl FnOnce() -> T + Send) -> T {
    match threads.and_then(|threads| pool(threads).ok()) {
        Some(pool) => pool.install(work),
        None => work(),
    }
}

/// Runs `work` on so many threads at once, each with a pool of its own of one thread, and waits for all of them: for work of many
/// small parts that are done one by one.
///
/// # Errors
/// Where the system does not have enough threads left.
pub fn each(threads: usize, work: impl Fn() + Sync) -> Result<(), ThreadPoolBuildError> {
    let pools: Vec<ThreadPool> = (0..threads).map(|_| pool(1)).collect::<Result<_, _>>()?;
    thread::scope(|scope| {
        for pool in &pools {
            scope.spawn(|| pool.install(&work));
        }
    });
    Ok(())
}

/// Sets the number of threads of the pool that all of the program shares. Has no effect once that pool has been used.
pub fn set_shared(threads: usize) {
    // An error says that the pool exists already.
    let _ = rayon::ThreadPoolBuilder::new().num_threads(threads).build_global();
}

/// The number of this process.
#[must_use]
pub fn process() -> u32 {
    std::process::id()
}

/// Starts a thread that runs `work`.
///
/// # Errors
/// Where the system has no thread left.
pub fn start(name: &str, work: impl FnOnce() + Send + 'static) -> io::Result<JoinHandle<()>> {
    thread::Builder::new().name(name.to_owned()).spawn(work)
}

/// Stops this thread for `time`.
pub fn sleep(time: Duration) {
    thread::sleep(time);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn work_runs_in_the_requested_number_of_threads() {
        assert_eq!(with(Some(3), rayon::current_num_threads), 3);
        assert_eq!(with(None, rayon::current_num_threads), rayon::current_num_threads());
    }

    #[test]
    fn a_thread_has_its_name() {
        let thread = start("a test", || assert_eq!(thread::current().name(), Some("a test")));
        thread.unwrap().join().unwrap();
    }
}
