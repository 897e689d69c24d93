#![no_main]

#[path = "../bodies/memory.rs"]
mod memory;
#[path = "../bodies/palette.rs"]
mod palette;
#[path = "../bodies/refusal.rs"]
mod refusal;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| palette::holds(bytes));
