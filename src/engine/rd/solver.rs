//! The solver: the widest vector instructions of the machine, unless another solver was chosen. All give the same bits;
//! `tests/golden` checks this.

use std::sync::OnceLock;

use super::wavefront::Instructions;

/// The solver of a growth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Solver {
    /// The plain solver, step by step and cell by cell; two to five times slower on the same grid (`dapple bench`).
    Plain,
    /// The fast solver with these instructions.
    Fast(Instructions),
}

/// Set once, before or by the first growth.
static CHOSEN: OnceLock<Solver> = OnceLock::new();

impl Solver {
    /// The solvers that this machine supports, the fastest last.
    #[must_use]
    pub fn available() -> Vec<Self> {
        std::iter::once(Self::Plain).chain(Instructions::available().into_iter().map(Self::Fast)).collect()
    }

    /// `plain`, `baseline` (or `neon`, which every 64-bit ARM has), `avx2` or `avx512`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Plain => "plain",
            #[cfg(target_arch = "x86_64")]
            Self::Fast(Instructions::Avx512) => "avx512",
            #[cfg(target_arch = "x86_64")]
            Self::Fast(Instructions::Avx2) => "avx2",
            Self::Fast(Instructions::Baseline) if cfg!(target_arch = "aarch64") => "neon",
            Self::Fast(Instructions::Baseline) => "baseline",
        }
    }

    /// The solver of every growth of this program: the one that was chosen, else the fastest.
    #[must_use]
    pub fn chosen() -> Self {
        *CHOSEN.get_or_init(|| Self::Fast(Instructions::best()))
    }

    /// Chooses the solver of this name for every growth of this program. `false` if the machine supports none of this name, or
    /// if another has been used already.
    #[must_use]
    pub fn choose(name: &str) -> bool {
        let Some(solver) = Self::available().into_iter().find(|solver| solver.name() == name) else {
            return false;
        };
        *CHOSEN.get_or_init(|| solver) == solver
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solver_names_are_unique_and_an_unknown_name_gives_none() {
        let names: Vec<&str> = Solver::available().into_iter().map(Solver::name).collect();
        assert!(names.len() >= 2 && names[0] == "plain", "{names:?}");
        assert!((1..names.len()).all(|i| !names[..i].contains(&names[i])), "{names:?}");
        assert!(!Solver::choose("abacus"));
        assert_eq!(Solver::chosen(), Solver::Fast(Instructions::best()));
    }
}
