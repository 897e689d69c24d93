#![no_main]

#[path = "../bodies/document.rs"]
mod document;
#[path = "../bodies/kept.rs"]
mod kept;
#[path = "../bodies/memory.rs"]
mod memory;
#[path = "../bodies/told.rs"]
mod told;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| document::holds(bytes));
