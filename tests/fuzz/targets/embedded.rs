#![no_main]

#[path = "../bodies/kept.rs"]
mod kept;
#[path = "../bodies/embedded.rs"]
mod embedded;
#[path = "../bodies/memory.rs"]
mod memory;
#[path = "../bodies/told.rs"]
mod told;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| embedded::holds(bytes));
