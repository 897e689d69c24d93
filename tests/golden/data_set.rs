//! The first hundred items of a data set.

use dapple::data_set::{Settings, item};
use dapple::engine::synth::Watch;
use rayon::prelude::*;
use sha2::{Digest, Sha256};

use crate::renew::same_lines;

const COUNT: u64 = 100;
/// A quarter of the px of a usual data set, so that the test takes a quarter of the time.
const SIDE: u32 = 128;

/// Index, kind and the SHA-256 of the names and bytes of an item's files.
fn line(index: u64) -> String {
    let settings = Settings { side: SIDE, ..Settings::default() };
    let item = item(&settings, index, &Watch::NONE).expect("an item");
    let mut digest = Sha256::new();
    for (name, bytes) in item.files().expect("files") {
        digest.update(name);
        digest.update((bytes.len() as u64).to_le_bytes());
        digest.update(bytes);
    }
    let hexadecimal: String = digest.finalize().iter().map(|byte| format!("{byte:02x}")).collect();
    format!("{index} {} {hexadecimal}\n", item.kind.name())
}

#[test]
fn the_first_hundred_items_of_a_data_set_keep_their_bytes() {
    let lines: Vec<String> = (0..COUNT).into_par_iter().map(line).collect();
    same_lines("data-set.txt", &lines.concat());
}
