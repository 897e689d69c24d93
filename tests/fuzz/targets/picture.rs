#![no_main]

#[path = "../bodies/memory.rs"]
mod memory;
#[path = "../bodies/picture.rs"]
mod picture;
#[path = "../bodies/told.rs"]
mod told;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| picture::holds(bytes));
