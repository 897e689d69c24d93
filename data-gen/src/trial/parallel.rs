//! Work on many documents in parallel, each grown by one thread.

use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use indicatif::{ProgressBar, ProgressStyle};

/// The number of threads to use: the given number, or one for each core.
pub fn threads(asked: Option<u16>) -> usize {
    let cores = || std::thread::available_parallelism().map_or(1, usize::from);
    asked.map_or_else(cores, usize::from)
}

/// The results of `work` for each of `tasks`, in their order. `name` gives the name of a task in the progress bar.
///
/// Each thread grows whole documents, since grids are too small for several threads to share one. The results do not depend
/// on their number.
///
/// # Errors
/// The first error of `work`, in the order of the tasks.
pub fn each<T: Sync, R: Send>(
    tasks: &[T],
    threads: usize,
    name: impl Fn(&T) -> String + Sync,
    work: impl Fn(&T) -> Result<R, String> + Sync,
) -> Result<Vec<R>, String> {
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len}  {elapsed} elapsed, {eta} left  {msg}");
    let bar = ProgressBar::new(tasks.len() as u64)
        .with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    let next = AtomicUsize::new(0);
    let found: Mutex<Vec<(usize, Result<R, String>)>> = Mutex::new(Vec::new());
    let run = || -> Result<(), String> {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
        let pool = pool.map_err(|error| format!("cannot start a thread: {error}"))?;
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            let Some(task) = tasks.get(index) else { return Ok(()) };
            let result = pool.install(|| work(task));
            bar.inc(1);
            bar.set_message(name(task));
            found.lock().map_err(|_| "a thread has panicked")?.push((index, result));
        }
    };
    std::thread::scope(|scope| {
        let threads: Vec<_> = (0..threads.min(tasks.len())).map(|_| scope.spawn(run)).collect();
        threads.into_iter().try_for_each(|thread| thread.join().map_err(|_| "a thread has panicked")?)
    })?;
    bar.finish_and_clear();
    let mut found = found.into_inner().map_err(|_| "a thread has panicked")?;
    found.sort_by_key(|(index, _)| *index);
    found.into_iter().map(|(_, result)| result).collect()
}
