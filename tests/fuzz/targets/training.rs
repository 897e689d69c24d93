#![no_main]

#[path = "../bodies/memory.rs"]
mod memory;
#[path = "../bodies/refusal.rs"]
mod refusal;
#[path = "../bodies/training.rs"]
mod training;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| training::holds(bytes));
