//! When a pattern is settled.
//!
//! The criteria ([`crate::rd::Convergence`]) were tuned on patches of 90 spots and 10 wavelengths grown to T = 200, and on
//! canvases whose regions differ. Changes fall by a half from look to look while spots form; then they stay: spots drift
//! along gradients and even out their distances, forks of stripes heal, ever more slowly. From there on the mean area is
//! within 0.3 % (Turing 0.5 %, width of stripes 2 %) of its limit, and the direction within 0.5°.

use crate::rd::System;

/// Time between two looks.
const EVERY: f64 = 2.5;
/// Time between two looks at a correction.
const OFTEN: f64 = 1.0;
/// From look to look what is still forming falls to below this share, drift stays above it.
const FALLING: f64 = 0.8;
/// Steps that are taken at most on one grid: a canvas that needs more has no business to take the night.
const STEPS: u64 = 150_000;
/// Change a unit of time that is rest by any measure.
const REST: f64 = 0.0003;

/// Time after which stripes from segments are as wide as others; at T = 30 there are blots where segments met.
const HEALED: f64 = 100.0;

/// Watches a pattern on one grid come to rest.
#[derive(Clone, Debug)]
pub struct Rest {
    system: System,
    /// Steps that make up a unit of time.
    unit: f64,
    /// Does anything begin on this grid?
    begins: bool,
    /// What the drift that counts as rest is multiplied by.
    slack: f64,
    /// Not asked before.
    earliest: f64,
    before: Vec<f32>,
    last: f64,
    looks: u64,
}

/// What a look found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It still forms.
    Forming,
    /// It has come to rest.
    Settled,
    /// It has not, in the time that it was given.
    GivenUp,
}

impl Rest {
    /// Begins to watch `marks`, as they are before the first of the steps of which `unit` make up a unit of time.
    #[must_use]
    pub fn new(system: System, unit: f64, begins: bool, marks: Vec<f32>) -> Self {
        let earliest = system.definition().convergence.earliest;
        Self { system, unit, begins, slack: 1.0, earliest, before: marks, last: f64::INFINITY, looks: 0 }
    }

    /// The same among frozen marks, which push what stands beside them on for long: lone spots in lanes between three
    /// others drift by up to 0.007 a unit of time when their areas have long come to rest.
    #[must_use]
    pub fn among_frozen(self) -> Self {
        Self { slack: 2.0, ..self }
    }

    /// The same where the marks must find together first, if they are `scattered`.
    #[must_use]
    pub fn healing(self, scattered: bool) -> Self {
        if scattered { Self { earliest: HEALED, ..self } } else { self }
    }

    /// The steps after which to look next.
    #[must_use]
    pub fn next(&self) -> u64 {
        let every = if self.begins { EVERY } else { OFTEN };
        let steps = ((self.looks + 1) as f64 * every * self.unit).ceil() as u64;
        steps.clamp(self.looks + 1, STEPS.max(self.looks + 1))
    }

    /// Steps that this grid takes if all goes well.
    #[must_use]
    pub fn expected(system: System, unit: f64, begins: bool) -> f64 {
        let criterion = system.definition().convergence;
        (unit * if begins { 1.3 * criterion.earliest } else { criterion.corrected }).min(STEPS as f64)
    }

    /// Looks at `marks` after `steps` steps. Cells that do not count are left out.
    pub fn look(&mut self, marks: Vec<f32>, counts: &[bool], steps: u64) -> Verdict {
        let criterion = self.system.definition().convergence;
        let time = steps as f64 / self.unit;
        let every = if self.begins { EVERY } else { OFTEN };
        let change = change(&self.before, &marks, counts) / every;
        let steady = change < self.slack * criterion.drift && change > FALLING * self.last;
        let corrected = !self.begins && time >= criterion.corrected && change < criterion.still;
        (self.before, self.last) = (marks, change);
        self.looks += 1;
        if corrected || time >= self.earliest && (steady || change < REST) {
            return Verdict::Settled;
        }
        if time >= criterion.latest || steps >= STEPS || !change.is_finite() {
            return Verdict::GivenUp;
        }
        Verdict::Forming
    }
}

/// Σ|after − before| ÷ Σ after over what is not ground.
fn change(before: &[f32], after: &[f32], counts: &[bool]) -> f64 {
    let (mut moved, mut total) = (0.0f64, 0.0f64);
    for ((b, a), counts) in before.iter().zip(after).zip(counts) {
        if *counts {
            moved += f64::from((a - b).abs());
            total += f64::from(a.max(0.0));
        }
    }
    if moved == 0.0 { 0.0 } else { moved / total }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The verdicts on a mark that changes by `change(look)` of itself from look to look, one time unit of ten steps
    /// each, until one is not [`Verdict::Forming`]; gives it with its time.
    fn watched(begins: bool, change: impl Fn(usize) -> f32) -> (Verdict, f64) {
        let mut mark = 1.0f32;
        let mut rest = Rest::new(System::MEINHARDT_SPOTS, 10.0, begins, vec![mark, 0.0]);
        for look in 0..1_000 {
            mark *= 1.0 + change(look);
            let steps = rest.next();
            // What does not count may do what it likes.
            let verdict = rest.look(vec![mark, look as f32], &[true, false], steps);
            if verdict != Verdict::Forming {
                return (verdict, steps as f64 / 10.0);
            }
        }
        panic!("watched for ever");
    }

    #[test]
    fn what_begins_is_settled_when_its_change_no_longer_falls_but_not_before_its_time() {
        assert_eq!(watched(true, |_| 0.005), (Verdict::Settled, 15.0));
        let (verdict, time) = watched(true, |look| 0.5 * 0.5f32.powi(look as i32));
        assert!(verdict == Verdict::Settled && time > 20.0, "{time}");
        assert_eq!(watched(true, |_| 0.05), (Verdict::GivenUp, 120.0));
    }

    #[test]
    fn a_correction_is_short_and_falls_back_to_the_whole_time_where_it_does_not_fade() {
        assert_eq!(watched(false, |_| 0.003), (Verdict::Settled, 4.0));
        let (verdict, time) = watched(false, |look| if look < 8 { 0.02 } else { 0.003 });
        assert_eq!((verdict, time), (Verdict::Settled, 9.0));
        assert_eq!(watched(false, |_| 0.011), (Verdict::GivenUp, 120.0));
    }

    #[test]
    fn concentrations_that_are_no_numbers_end_the_growth() {
        let (verdict, time) = watched(true, |look| if look == 3 { f32::NAN } else { 0.001 });
        assert_eq!((verdict, time), (Verdict::GivenUp, 10.0));
    }
}
