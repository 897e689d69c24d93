#![no_main]

#[path = "../bodies/memory.rs"]
mod memory;
#[path = "../bodies/model.rs"]
mod model;
#[path = "../bodies/refusal.rs"]
mod refusal;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| model::holds(bytes));
