//! Long work: on a thread of its own, without the lock of the interpreter, while this thread waits for signals and reports progress.

use dapple::{Stage, Watch};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::RecvTimeoutError;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// How often signals are looked for and progress is reported.
const STEP: Duration = Duration::from_millis(30);
/// How long work that is cancelled is waited for.
const PATIENCE: Duration = Duration::from_millis(200);

/// Runs `work`. Ctrl-C, or an exception of `progress(stage, share)`, cancels it and is raised.
pub fn watched<T: Send>(
    py: Python<'_>,
    progress: Option<Py<PyAny>>,
    work: impl FnOnce(&Watch) -> T + Send,
) -> PyResult<T> {
    let cancelled = AtomicBool::new(false);
    let seen: Mutex<Option<(Stage, f64)>> = Mutex::new(None);
    let (result, done): (Mutex<Option<T>>, Condvar) = (Mutex::new(None), Condvar::new());
    let ended = AtomicBool::new(false);
    let outcome = std::thread::scope(|scope| {
        scope.spawn(|| {
            let _end = End(&ended, &done);
            let watch = Watch {
                progress: &|stage, share| *locked(&seen) = Some((stage, share)),
                cancelled: &|| cancelled.load(Ordering::Relaxed),
            };
            *locked(&result) = Some(work(&watch));
        });
        let mut raised = None;
        while !ended.load(Ordering::Acquire) {
            py.detach(|| {
                let waiting = locked(&result);
                drop(done.wait_timeout_while(waiting, STEP, |_| !ended.load(Ordering::Acquire)));
            });
            if raised.is_none() {
                raised = py.check_signals().and_then(|()| report(py, progress.as_ref(), &seen)).err();
                cancelled.store(raised.is_some(), Ordering::Relaxed);
            }
        }
        raised
    });
    match (outcome, locked(&result).take()) {
        (Some(raised), _) => Err(raised),
        (None, Some(value)) => Ok(value),
        (None, None) => Err(PyRuntimeError::new_err("the work has stopped without a result")),
    }
}

/// Runs `work` on a thread that can outlive the call. Ctrl-C, or an exception of `progress(stage, share)`, cancels it and is raised
/// soon after. A step that takes seconds and does not check for cancelling is left to end by itself.
pub fn abandoned<T: Send + 'static>(
    py: Python<'_>,
    progress: Option<Py<PyAny>>,
    work: impl FnOnce(&Watch) -> T + Send + 'static,
) -> PyResult<T> {
    let (send, ended) = std::sync::mpsc::channel();
    let cancelled = Arc::new(AtomicBool::new(false));
    let seen: Arc<Mutex<Option<(Stage, f64)>>> = Arc::default();
    let (cancelled_too, seen_too) = (cancelled.clone(), seen.clone());
    std::thread::spawn(move || {
        let watch = Watch {
            progress: &|stage, share| *locked(&seen_too) = Some((stage, share)),
            cancelled: &|| cancelled_too.load(Ordering::Relaxed),
        };
        // Where nobody waits any more, the result is dropped.
        drop(send.send(work(&watch)));
    });
    // A receiver is not for several threads at once, which the lock says.
    let ended = Mutex::new(ended);
    let wait = |time| py.detach(|| locked(&ended).recv_timeout(time));
    loop {
        let outcome = wait(STEP);
        let raised = py.check_signals().and_then(|()| report(py, progress.as_ref(), &seen)).err();
        match (outcome, raised) {
            (Err(RecvTimeoutError::Timeout), None) => {}
            (Ok(value), None) => return Ok(value),
            (Err(RecvTimeoutError::Disconnected), None) => {
                return Err(PyRuntimeError::new_err("the work has stopped without a result"));
            }
            (outcome, Some(raised)) => {
                cancelled.store(true, Ordering::Relaxed);
                if matches!(outcome, Err(RecvTimeoutError::Timeout)) {
                    drop(wait(PATIENCE));
                }
                return Err(raised);
            }
        }
    }
}

/// Says that the work has ended, also where it panics.
struct End<'a>(&'a AtomicBool, &'a Condvar);

impl Drop for End<'_> {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Release);
        self.1.notify_all();
    }
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Calls `progress` with what is new.
fn report(py: Python<'_>, progress: Option<&Py<PyAny>>, seen: &Mutex<Option<(Stage, f64)>>) -> PyResult<()> {
    let (Some(progress), Some((stage, share))) = (progress, locked(seen).take()) else { return Ok(()) };
    let name = match stage {
        Stage::Plan => "plan",
        Stage::Grow => "grow",
        Stage::Refine => "refine",
        Stage::Write => "write",
    };
    progress.call1(py, (name, share)).map(drop)
}
