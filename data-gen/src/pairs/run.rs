//! One run of a set of pairs: drawn marks → simulation by the laws → verdict → a line of one of the two files.

use dapple_engine::attributes::system::Description;
use dapple_engine::learn::{six_digits, write_pair_row};
use dapple_engine::synth::{PairPatch, Watch};

use super::draw::drawn;
use crate::plan::Set;
use crate::verdicts::ACCEPTED;

/// Grows, measures and judges run `index` of `set`, whose system is `system`.
pub fn run(set: &Set, system: &'static Description, index: u64) -> Result<(&'static str, String), String> {
    let (drawn, named) = drawn(set, index);
    let (periods, least) = (set.patch.grown, set.patch.least);
    let patch = PairPatch { system, drawn, periods, least, seed: set.seed_of(index) };
    match patch.grow(&Watch::NONE).map_err(|cancelled| cancelled.to_string())? {
        Ok(row) => {
            let failed = |error| format!("set '{}', seed {}: {error}", set.name, patch.seed);
            Ok((ACCEPTED, write_pair_row(system, &row).map_err(failed)?))
        }
        Err(reason) => {
            let values = named.iter().map(|(_, value)| six_digits(*value)).collect::<Vec<_>>().join(",");
            // The texts contain no quotes.
            let detail = reason.to_string().replace('"', "'");
            Ok((reason.kind(), format!("{},{values},{},\"{detail}\"", patch.seed, reason.kind())))
        }
    }
}

/// The header of the file of rows and that of the file of rejected runs.
pub fn headers(set: &Set) -> [String; 2] {
    let rows: Vec<&str> = set.system.description().all_columns().map(|column| column.name).collect();
    let (_, named) = drawn(set, 0);
    let names: Vec<&str> = named.iter().map(|(name, _)| *name).collect();
    [rows.join(","), format!("seed,{},reason,detail", names.join(","))]
}
