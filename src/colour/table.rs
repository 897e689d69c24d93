//! A gradient by look-up.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, PoisonError};

use super::Gradient;
use crate::grid::to_u16;

/// A gradient by look-up: one colour for each 16-bit step of the pattern.
///
/// A value is first brought to the nearest step, as `--pattern` writes it, so that the picture is a
/// function of the written pattern; at the steps the colours are the gradient's own.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    colours: Arc<Vec<[u8; 3]>>,
}

/// The tables that were worked out last, the newest at the end. Who paints a growth moment by moment asks for the same ones
/// hundreds of times, and to work one out takes longer than to paint a small picture: a film of 150² px took 24 s without
/// this and takes 1 s.
static LAST: Mutex<VecDeque<(Gradient, Table)>> = Mutex::new(VecDeque::new());
/// More than the layers of most documents; 200 kB each.
const KEPT: usize = 32;

impl Table {
    /// That of `gradient`.
    pub(super) fn of(gradient: &Gradient) -> Self {
        let last = || LAST.lock().unwrap_or_else(PoisonError::into_inner);
        let known = last().iter().find(|(of, _)| of == gradient).map(|(_, table)| table.clone());
        // Not held while it is worked out: whoever helps with that may want a table himself.
        known.unwrap_or_else(|| {
            let table = Self { colours: Arc::new(gradient.worked_out()) };
            let mut last = last();
            last.push_back((gradient.clone(), table.clone()));
            while last.len() > KEPT {
                last.pop_front();
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
    fn what_is_kept_is_what_is_worked_out() {
        // Twice each, and more than are kept.
        for colour in (0..=2 * KEPT as u8).chain(0..=2 * KEPT as u8) {
            let mut gradient = Gradient::default_for_layer(0);
            gradient.stops[0].colour[1] = colour;
            for _ in 0..2 {
                assert!(*Table::of(&gradient).colours == gradient.worked_out());
            }
        }
        assert!(LAST.lock().unwrap().len() <= KEPT);
    }

    #[test]
    fn gradients_that_differ_in_a_bend_alone_have_tables_of_their_own() {
        let straight = Gradient::default_for_layer(1);
        let mut bent = straight.clone();
        bent.bends = vec![crate::colour::Bend([0.42, 0.0, 0.58, 1.0])];
        assert!(Table::of(&straight) != Table::of(&bent));
        assert!(*Table::of(&bent).colours == bent.worked_out());
    }
}
