//! `data-gen` as users run it, its faults, and what it reads.

mod command;
mod faults;
mod fuzz;
#[path = "../../../tests/fuzz/bodies/refusal.rs"]
mod refusal;
