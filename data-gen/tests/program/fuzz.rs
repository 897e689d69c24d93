//! The fuzz target of the sweep's files as an ordinary test: plans in manifests, and journals.

#[path = "../../../tests/fuzz/mutations.rs"]
mod mutations;
#[path = "../../../tests/fuzz/bodies/sweep.rs"]
mod sweep;

use mutations::Seeds;
use proptest::test_runner::{Config, TestRunner};
use std::path::Path;

#[test]
fn any_plan_or_journal_is_read_or_refused() {
    let seeds = Seeds::for_target(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/fuzz"), "sweep");
    for (name, bytes) in &seeds.files {
        println!("{name}");
        sweep::holds(bytes);
    }
    let config = Config { failure_persistence: None, ..Config::with_cases(600) };
    let ran = TestRunner::new(config).run(&seeds.damaged(), |bytes| {
        sweep::holds(&bytes);
        Ok(())
    });
    ran.unwrap_or_else(|error| panic!("{error}"));
}
