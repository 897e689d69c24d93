//! Properties of all documents, parameters and maps, tested on random examples.
//!
//! `PROPTEST_CASES=5000 cargo test -p dapple-engine --test properties` tries more.

mod agreement;
mod chemistry;
mod documents;
mod growing;
#[path = "../fuzz/bodies/memory.rs"]
mod memory;
mod regions;
mod schema;
mod tensors;

use proptest::test_runner::Config;

/// This number of cases, or the number in `PROPTEST_CASES`.
fn cases(usual: u32) -> Config {
    let asked = std::env::var("PROPTEST_CASES").ok().and_then(|text| text.parse().ok());
    Config { failure_persistence: None, ..Config::with_cases(asked.unwrap_or(usual)) }
}

/// Runs a test on a large stack, because the values of nested strategies overflow the stack of an ordinary test.
fn on_large_stack(test: impl FnOnce() + Send + 'static) {
    const BYTES: usize = 64 << 20;
    let thread = std::thread::Builder::new().stack_size(BYTES).spawn(test).expect("a thread");
    if let Err(panic) = thread.join() {
        std::panic::resume_unwind(panic);
    }
}
