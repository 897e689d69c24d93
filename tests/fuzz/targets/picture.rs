#![no_main]

#[path = "../bodies/memory.rs"]
mod memory;
#[path = "../bodies/picture.rs"]
mod picture;
#[path = "../bodies/refusal.rs"]
mod refusal;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| picture::holds(bytes));
