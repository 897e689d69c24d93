//! Lookup tables of gradients.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, PoisonError};

use super::Gradient;
use crate::grid::to_u16;

/// The lookup table of a gradient: one colour for each 16-bit value of the pattern.
///
/// A value is first rounded to 16 bits, as `--pattern` writes it, so the picture is a function of the written pattern. At these
/// values the colours are exactly those of the gradient, over white where it is transparent.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    colours: Arc<Vec<[u8; 3]>>,
}

/// The most recent tables, the newest last. A film uses the same tables for hundreds of frames, and computing one takes longer
/// than painting a small picture: a film of 150² px took 24 s without this cache and takes 1 s with it.
static CACHE: Mutex<VecDeque<(Gradient, Table)>> = Mutex::new(VecDeque::new());
/// Number of cached tables, more than the layers of most documents; 200 kB each.
const CACHED: usize = 32;

impl Gradient {
    /// The lookup table of its colours, from a cache if possible.
    #[must_use]
    pub fn table(&self) -> Table {
        Table::cached(self)
    }
}

impl Table {
    /// The table of `gradient`, from the cache or computed.
    fn cached(gradient: &Gradient) -> Self {
        let cache = || CACHE.lock().unwrap_or_else(PoisonError::into_inner);
        let known = cache().iter().find(|(cached, _)| cached == gradient).map(|(_, table)| table.clone());
        // The lock is not held during the computation: rayon may run another job on this thread that needs a table.
        known.unwrap_or_else(|| {
            let table = Self { colours: Arc::new(gradient.computed_table()) };
            let mut cache = cache();
            cache.push_back((gradient.clone(), table.clone()));
            while cache.len() > CACHED {
                cache.pop_front();
            }
            table
        })
    }

    /// The colour of the step nearest to the pattern value `v`.
    #[must_use]
    pub fn colour(&self, v: f32) -> [u8; 3] {
        self.colours[usize::from(to_u16(v))]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cached_table_equals_a_computed_one() {
        // Each twice, and more than the cache holds.
        for colour in (0..=2 * CACHED as u8).chain(0..=2 * CACHED as u8) {
            let mut gradient = Gradient::default_for_layer(0);
            gradient.stops[0].colour[1] = colour;
            for _ in 0..2 {
                assert!(*Table::cached(&gradient).colours == gradient.computed_table());
            }
        }
        assert!(CACHE.lock().unwrap().len() <= CACHED);
    }

    #[test]
    fn gradients_that_differ_only_in_a_bend_have_different_tables() {
        let straight = Gradient::default_for_layer(1);
        let mut bent = straight.clone();
        bent.bends = vec![crate::colour::Bend([0.42, 0.0, 0.58, 1.0])];
        assert!(Table::cached(&straight) != Table::cached(&bent));
        assert!(*Table::cached(&bent).colours == bent.computed_table());
    }
}
