//! The amount of free memory, and giving it back.

use sysinfo::{MemoryRefreshKind, ProcessRefreshKind, ProcessesToUpdate, RefreshKind};

/// Bytes of memory that this process can still get: the free memory of the machine, or what the limits of the process
/// leave.
#[must_use]
pub fn free_memory() -> f64 {
    own_limit().map_or_else(of_machine, |left| left.min(of_machine()))
}

/// Address space that each thread reserves in addition to what it uses, bytes: its stack, and its own heap.
#[cfg(unix)]
const A_THREAD: f64 = 72e6;

/// Bytes that the limit of the address space (`ulimit -v`) leaves; `None` without such a limit.
#[cfg(unix)]
fn own_limit() -> Option<f64> {
    use rustix::process::{Resource, getrlimit};
    let limit = getrlimit(Resource::As).current?;
    // The first number is the address space in use, in pages.
    let used = std::fs::read_to_string("/proc/self/statm").ok();
    let pages = used.and_then(|text| text.split_whitespace().next()?.parse::<f64>().ok()).unwrap_or(0.0);
    let threads = rayon::current_num_threads() as f64;
    let reserved = pages * rustix::param::page_size() as f64 + threads * A_THREAD;
    Some((limit as f64 - reserved).max(0.0))
}

/// Such limits are known on Unix only.
#[cfg(not(unix))]
fn own_limit() -> Option<f64> {
    None
}

/// Bytes of memory that are free in the control group of this process (a container, `systemd-run -p MemoryMax=`).
fn of_group() -> Option<f64> {
    let own = sysinfo::get_current_pid().ok()?;
    let mut machine = sysinfo::System::new_with_specifics(RefreshKind::nothing()).ok()?;
    machine.refresh_processes_specifics(
        ProcessesToUpdate::Some(&[own]),
        false,
        ProcessRefreshKind::nothing(),
    );
    Some(machine.process(own)?.cgroup_limits()?.free_memory as f64)
}

/// Bytes of memory that are free on this machine, or in the control group of this process.
fn of_machine() -> f64 {
    /// The value that is assumed where the system does not report it.
    const ASSUMED: f64 = 8e9;
    let memory = RefreshKind::nothing().with_memory(MemoryRefreshKind::nothing().with_ram());
    let machine = sysinfo::System::new_with_specifics(memory);
    let free = machine.map_or(0, |machine| machine.available_memory());
    let bytes = if free > 0 { free as f64 } else { ASSUMED };
    of_group().map_or(bytes, |group| bytes.min(group))
}

/// Gives memory that is not used any more back to the system. The allocator of glibc keeps what was freed between pieces that are
/// still used: after many growths more than half of what a window takes. Others give it back by themselves.
#[cfg(all(target_os = "linux", target_env = "gnu"))]
pub fn give_back() {
    // SAFETY: `malloc_trim` may be called at any time and by any thread; it moves nothing that is in use.
    unsafe { libc::malloc_trim(0) };
}

/// Does nothing: the allocator of this system gives memory back by itself.
#[cfg(not(all(target_os = "linux", target_env = "gnu")))]
pub fn give_back() {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_machine_that_runs_this_test_has_free_memory() {
        assert!((1e6..1e14).contains(&free_memory()), "{}", free_memory());
    }

    #[cfg(all(target_os = "linux", target_env = "gnu"))]
    #[test]
    fn memory_that_was_freed_between_used_pieces_is_given_back() {
        let resident = || {
            let text = std::fs::read_to_string("/proc/self/statm").unwrap();
            let pages: f64 = text.split_whitespace().nth(1).unwrap().parse().unwrap();
            pages * rustix::param::page_size() as f64
        };
        // Below the size from which the allocator asks the system for each piece.
        let mut pieces: Vec<Vec<u8>> = (0..2000).map(|k| vec![k as u8; 60_000]).collect();
        let last = pieces.pop();
        drop(pieces);
        let before = resident();
        give_back();
        assert!(before - resident() > 60e6, "{before} {}", resident());
        drop(last);
    }
}
