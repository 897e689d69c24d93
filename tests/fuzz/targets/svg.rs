#![no_main]

#[path = "../bodies/kept.rs"]
mod kept;
#[path = "../bodies/memory.rs"]
mod memory;
#[path = "../bodies/svg.rs"]
mod svg;
#[path = "../bodies/refusal.rs"]
mod refusal;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| svg::holds(bytes));
