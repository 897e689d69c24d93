//! Stripes with tips on a surface, from one pair of morphogens.
//!
//! ```text
//!  noise, and lines along the paths that are kept ─▶ grow ─▶ cut by duty ─▶ the period is measured ─▶ corrected: grow again
//! ```

mod cut;
mod growth;
mod start;

pub use growth::{GrownPairStripes, PairStripesGrowth};

#[cfg(test)]
mod tests;
