//! CPU time of a thread.

use std::sync::LazyLock;
use std::time::{Duration, Instant};

/// Measures the CPU time of this thread from its creation on; where the system does not report it, the time on the
/// clock.
pub struct Stopwatch {
    cpu: Option<f64>,
    clock: Instant,
}

impl Stopwatch {
    /// Starts now.
    pub fn start() -> Self {
        Self { cpu: thread_seconds(), clock: Instant::now() }
    }

    /// Seconds since the start.
    pub fn seconds(&self) -> f64 {
        let cpu = thread_seconds().zip(self.cpu).map(|(now, then)| now - then);
        cpu.unwrap_or_else(|| self.clock.elapsed().as_secs_f64())
    }
}

/// CPU time of this thread so far; where the system does not report it, the time on the clock.
pub fn time() -> Duration {
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    thread_seconds().map_or_else(|| START.elapsed(), Duration::from_secs_f64)
}

/// CPU seconds of this thread so far: on Linux the first number of its `schedstat`, in nanoseconds.
fn thread_seconds() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    let nanoseconds: f64 = text.split_whitespace().next()?.parse().ok()?;
    Some(nanoseconds * 1e-9)
}
