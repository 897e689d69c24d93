//! Sets of systems of pairs: what is drawn for run i, the check of a set, and the run.

mod check;
mod draw;
mod run;
#[cfg(test)]
mod tests;

pub use check::check;
pub use run::{headers, run};
