//! Clocks: moments, and the time since one, such as the first call.

use std::sync::OnceLock;
use std::time::Duration;

pub use web_time::{Instant, SystemTime, UNIX_EPOCH};

/// The time since the first call.
#[must_use]
pub fn elapsed() -> Duration {
    static FIRST: OnceLock<Instant> = OnceLock::new();
    FIRST.get_or_init(Instant::now).elapsed()
}

/// CPU time of this thread since its start. Where the system does not report it, the time on the clock since the first
/// call.
#[cfg(unix)]
#[must_use]
pub fn cpu_time() -> Duration {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
    Duration::new(u64::try_from(time.tv_sec).unwrap_or(0), u32::try_from(time.tv_nsec).unwrap_or(0))
}

/// CPU time of this thread since its start. Where the system does not report it, the time on the clock since the first
/// call.
#[cfg(not(unix))]
#[must_use]
pub fn cpu_time() -> Duration {
    elapsed()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_thread_that_works_takes_cpu_time() {
        let (started, began) = (cpu_time(), elapsed());
        while cpu_time().saturating_sub(started) < Duration::from_millis(1) {}
        assert!(elapsed() > began);
    }
}
