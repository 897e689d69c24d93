//! Training rows of systems of pairs → corrections of their laws.
//!
//! Laws in closed form give the size s of a pair whose lines have a given width and period (`rd::pairs`). The row of a run holds
//! the measured values, the parameters, and the factor: the size ÷ the size that the law gives for the measured values. The factor
//! changes slowly, and locally weighted regression learns it in these coordinates:
//!
//! ```text
//! weave          asked: ln duty, others, ln unequal, between   answered: ln factor          for two directions, and for more
//! maze           asked: duty, ln long, between                 answered: ln factor, level   for two directions, and for more
//! pair-stripes   asked: ln duty, (cos 4θ, sin 4θ)              answered: ln factor
//! stucco         asked: decay                                  answered: ln factor
//! cells          asked: ln sparse, aspect                      answered: ln factor, ln apart
//! ```
//!
//! The names are those of the columns. A question beyond the rows is moved into their range.

mod hold_out;
mod pair_set;
#[cfg(test)]
mod tests;

pub use hold_out::{HeldOut, held_out};
pub use pair_set::{PairAnswer, PairRow, PairSet, write_pair_row};
