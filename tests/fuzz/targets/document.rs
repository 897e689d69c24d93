#![no_main]

#[path = "../bodies/document.rs"]
mod document;
#[path = "../bodies/kept.rs"]
mod kept;
#[path = "../bodies/memory.rs"]
mod memory;
#[path = "../bodies/refusal.rs"]
mod refusal;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| document::holds(bytes));
