//! The library: documents and their messages, layers, and the verdict on grown patterns.

mod border;
mod dense;
mod documents;
mod gallery;
mod half_grown;
mod layers;
mod links;
mod patches;
mod verdicts;

use proptest::test_runner::Config;

/// This number of random cases, or the number in `PROPTEST_CASES` (`.ci/property`).
fn cases(usual: u32) -> Config {
    let asked = std::env::var("PROPTEST_CASES").ok().and_then(|text| text.parse().ok());
    Config::with_cases(asked.unwrap_or(usual))
}
