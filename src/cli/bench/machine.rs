//! What this machine is, and how busy.

use crate::rd::Solver;
use std::fs::read_to_string;

/// The machine that was measured.
#[derive(Clone, Debug)]
pub struct Machine {
    /// The processor's name, or its kind where the system does not tell.
    pub processor: String,
    /// Cores that this program may use.
    pub cores: usize,
    /// The widest vectors that the fast solver uses here: `avx512`, `avx2`, `neon` or `baseline`; `plain` where it was told
    /// to use the plain solver.
    pub instructions: &'static str,
}

impl Machine {
    /// This one.
    pub fn here() -> Self {
        let cores = std::thread::available_parallelism().map_or(1, usize::from);
        Self { processor: processor(), cores, instructions: Solver::chosen().name() }
    }
}

fn processor() -> String {
    let listed = read_to_string("/proc/cpuinfo").unwrap_or_default();
    let named = listed.lines().find_map(|line| line.strip_prefix("model name")?.split_once(':'));
    named.map_or_else(|| std::env::consts::ARCH.to_owned(), |(_, name)| name.trim().to_owned())
}

/// Processes that ran or waited to run, averaged over the last minute; this program's threads are among them.
/// `None` where the system does not tell.
pub fn load() -> Option<f64> {
    read_to_string("/proc/loadavg").ok()?.split_whitespace().next()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn this_machine_has_a_name_and_cores() {
        let machine = Machine::here();
        assert!(!machine.processor.is_empty() && machine.cores > 0);
        assert!(["avx512", "avx2", "neon", "baseline"].contains(&machine.instructions));
    }
}
