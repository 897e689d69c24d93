//! The search for the amplitude of the noise with which edges are as ragged as is asked.

use crate::points::roughened::Roughening;

/// The first amplitude: that of a Holstein's edges on most systems.
const FIRST: f64 = 0.12;
/// Most amplitudes that are tried. With the third one the error of the raggedness is below [`NEAR`] where it can be reached.
const TRIES: usize = 5;
/// Largest relative error of the excess of the raggedness that is accepted.
const NEAR: f64 = 0.03;

/// Tries amplitudes one after the other, and keeps the best pattern.
pub struct EdgeSearch<Pattern> {
    /// By how much the raggedness is to exceed 1.
    asked: f64,
    amount: f64,
    /// The best pattern so far, and its error.
    best: Option<(f64, Pattern)>,
    tries: usize,
}

impl<Pattern> EdgeSearch<Pattern> {
    /// A search for edges whose raggedness exceeds 1 by `asked`, above 0.
    #[must_use]
    pub fn new(asked: f64) -> Self {
        Self { asked, amount: FIRST, best: None, tries: 0 }
    }

    /// The amplitude to try next, up to [`Roughening::MOST`].
    #[must_use]
    pub fn amount(&self) -> f64 {
        self.amount
    }

    /// The share of the tries that are done, 0..1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        self.tries as f64 / TRIES as f64
    }

    /// Notes the `pattern` that [`Self::amount`] gave, and by how much its raggedness exceeds 1. Returns whether there may be a better
    /// amplitude.
    pub fn tried(&mut self, pattern: Pattern, excess: f64) -> bool {
        let excess = excess.max(0.0);
        let off = (excess / self.asked - 1.0).abs();
        if self.best.as_ref().is_none_or(|(least, _)| off < *least) {
            self.best = Some((off, pattern));
        }
        let (amount, most) = (self.amount, f64::from(Roughening::MOST));
        // Waves along an edge lengthen it by the square of their height.
        let next =
            (amount * (self.asked / excess.max(1e-3)).sqrt()).clamp(0.3 * amount, 3.0 * amount).min(most);
        self.tries += 1;
        if off < NEAR || next == amount {
            return false;
        }
        self.amount = next;
        self.tries < TRIES
    }

    /// The best pattern; `None` where none was tried.
    #[must_use]
    pub fn best(self) -> Option<Pattern> {
        self.best.map(|(_, pattern)| pattern)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The amplitudes that are tried where the excess is `factor` × amplitude², and the best one.
    fn search(asked: f64, factor: f64) -> (usize, f64) {
        let mut search = EdgeSearch::new(asked);
        let mut tries = 0;
        loop {
            tries += 1;
            let amount = search.amount();
            if !search.tried(amount, factor * amount * amount) {
                return (tries, search.best().unwrap());
            }
        }
    }

    #[test]
    fn an_amplitude_that_lengthens_edges_by_its_square_is_found_in_three_tries() {
        for (asked, factor) in [(0.1, 8.0), (0.5, 8.0), (0.3, 2.0)] {
            let (tries, amount) = search(asked, factor);
            assert!(tries <= 3, "{tries}");
            assert!((factor * amount * amount / asked - 1.0).abs() < NEAR, "{amount}");
        }
    }

    #[test]
    fn the_highest_amplitude_is_the_best_one_where_the_raggedness_cannot_be_reached() {
        assert_eq!(search(5.0, 1.0).1, f64::from(Roughening::MOST));
    }
}
