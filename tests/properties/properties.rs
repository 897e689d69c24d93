//! Properties of all documents, parameters and maps, tested on random ones.
//!
//! `PROPTEST_CASES=5000 cargo test -p dapple-engine --test properties` tries more.

mod chemistry;
mod documents;
mod growing;
#[path = "../fuzz/bodies/memory.rs"]
mod memory;
mod regions;
mod tensors;

use proptest::test_runner::Config;

/// This many cases, or as many as `PROPTEST_CASES` says.
fn cases(usual: u32) -> Config {
    let asked = std::env::var("PROPTEST_CASES").ok().and_then(|text| text.parse().ok());
    Config { failure_persistence: None, ..Config::with_cases(asked.unwrap_or(usual)) }
}
