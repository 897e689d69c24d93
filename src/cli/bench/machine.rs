//! This machine: processor, cores, load.

use crate::machine::threads;
use crate::rd::Solver;
use sysinfo::{CpuRefreshKind, RefreshKind, System};

/// The machine that was measured.
#[derive(Clone, Debug)]
pub struct Machine {
    /// The processor's name, or its architecture if the system does not give a name.
    pub processor: String,
    /// Cores that this program may use.
    pub cores: usize,
    /// The widest vectors that the fast solver uses here: `avx512`, `avx2`, `neon` or `baseline`; `plain` if the plain solver was
    /// chosen.
    pub instructions: &'static str,
}

impl Machine {
    /// The machine that runs this program.
    pub fn here() -> Self {
        let cores = threads::cores();
        Self { processor: processor(), cores, instructions: Solver::chosen().name() }
    }
}

fn processor() -> String {
    let system = System::new_with_specifics(RefreshKind::nothing().with_cpu(CpuRefreshKind::nothing()));
    let name = system.ok().and_then(|system| Some(system.cpus().first()?.brand().trim().to_owned()));
    name.filter(|name| !name.is_empty()).unwrap_or_else(|| std::env::consts::ARCH.to_owned())
}

/// Processes running or waiting to run, averaged over the last minute, including this program's threads. `None` if the
/// system does not report it.
pub fn load() -> Option<f64> {
    System::load_average().ok().map(|load| load.one)
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
