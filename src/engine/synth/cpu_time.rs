//! The CPU time of a thread.

use std::time::Duration;

/// CPU time of this thread since its start; where the system does not tell, the time on the clock since the first call.
#[cfg(unix)]
#[must_use]
pub fn of_this_thread() -> Duration {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
    Duration::new(u64::try_from(time.tv_sec).unwrap_or(0), u32::try_from(time.tv_nsec).unwrap_or(0))
}

/// CPU time of this thread since its start; where the system does not tell, the time on the clock since the first call.
#[cfg(not(unix))]
#[must_use]
pub fn of_this_thread() -> Duration {
    static FIRST: std::sync::OnceLock<std::time::Instant> = std::sync::OnceLock::new();
    FIRST.get_or_init(std::time::Instant::now).elapsed()
}
