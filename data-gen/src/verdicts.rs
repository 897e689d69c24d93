//! The verdicts on runs, as they are written in files.

use dapple_engine::measure::Reason;
use dapple_engine::synth::PairReason;

use crate::swept::Swept;

/// The verdict on an accepted run; on others it is one of [`reasons`].
pub const ACCEPTED: &str = "accepted";

/// All reasons for which runs are rejected: those of the systems, then those that only systems of pairs have.
pub fn reasons() -> impl Iterator<Item = &'static str> {
    let of_pairs = PairReason::KINDS.into_iter().filter(|kind| !Reason::KINDS.contains(kind));
    Reason::KINDS.into_iter().chain(of_pairs)
}

/// The reasons for which runs of a set of this system are rejected.
pub fn reasons_of(system: Swept) -> Vec<&'static str> {
    match system {
        Swept::System(_) => Reason::KINDS.into(),
        Swept::Pairs(_) => PairReason::KINDS.into(),
    }
}
