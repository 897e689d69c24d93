#![no_main]

#[path = "../bodies/memory.rs"]
mod memory;
#[path = "../bodies/questions.rs"]
mod questions;
#[path = "../bodies/refusal.rs"]
mod refusal;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| questions::holds(bytes));
