#![no_main]

#[path = "../bodies/kept.rs"]
mod kept;
#[path = "../bodies/embedded.rs"]
mod embedded;
#[path = "../bodies/memory.rs"]
mod memory;
#[path = "../bodies/refusal.rs"]
mod refusal;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| embedded::holds(bytes));
