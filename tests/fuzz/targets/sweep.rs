#![no_main]

#[path = "../bodies/memory.rs"]
mod memory;
#[path = "../bodies/sweep.rs"]
mod sweep;
#[path = "../bodies/refusal.rs"]
mod refusal;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| sweep::holds(bytes));
