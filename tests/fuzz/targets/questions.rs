#![no_main]

#[path = "../bodies/memory.rs"]
mod memory;
#[path = "../bodies/questions.rs"]
mod questions;
#[path = "../bodies/told.rs"]
mod told;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| questions::holds(bytes));
