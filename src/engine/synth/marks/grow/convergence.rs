//! Convergence: when a pattern has settled.
//!
//! The criteria ([`crate::rd::Convergence`]) were tuned on patches of 90 spots and 10 wavelengths grown to T = 200, and on canvases
//! whose regions differ. While spots form, changes halve from check to check. Then they become steady: spots drift along gradients
//! and even out their distances, and forks of stripes heal, ever more slowly. From there on the mean area is within 0.3 % (Turing
//! 0.5 %, width of stripes 2 %) of its limit, and the direction within 0.5°.

use crate::rd::{Convergence, System};

/// Normalised time between two checks.
const EVERY: f64 = 2.5;
/// Normalised time between two checks where only the errors of a coarser grid are corrected.
const OFTEN: f64 = 1.0;
/// The change of a pattern that still forms falls below this share from check to check; changes by drift stay above it.
const FALLING: f64 = 0.8;
/// Step limit per grid. A canvas that needs more would take hours.
const STEPS: u64 = 150_000;
/// A change per unit of time below which any pattern counts as settled.
const NEGLIGIBLE: f64 = 0.0003;

/// Normalised time after which marks that are moved back to their places change only by these moves.
const HELD: f64 = 40.0;
/// Normalised time after which a settled pattern, some marks of which were corrected, does not change any more.
const CORRECTED: f64 = 8.0;
/// Most Euler steps per unit of time where drawn spots begin near their final shapes: the last per cents of the area of large ones
/// among small ones come from their thresholds. With 450 the errors of six sketches were those without a limit, in 0.4 to 0.8 of
/// the time.
pub const LONGEST: f64 = 250.0;

/// Time after which stripes from segments are as wide as others; at T = 30 there are blots where segments met.
const HEALED: f64 = 100.0;

/// Monitors a pattern on one grid until it has settled.
#[derive(Clone, Debug)]
pub struct ConvergenceMonitor {
    system: System,
    /// Steps that make up a unit of time.
    unit: f64,
    /// Whether marks begin on this grid.
    begins: bool,
    /// Factor of the drift that counts as settled.
    slack: f64,
    /// Normalised time before which it does not count as settled.
    earliest: f64,
    /// Normalised time after which the growth is given up.
    latest: f64,
    before: Vec<f32>,
    last: f64,
    checks: u64,
}

/// The result of a check.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The pattern still forms.
    Forming,
    /// The pattern has settled.
    Settled,
    /// The pattern has not settled within its time.
    GivenUp,
}

impl ConvergenceMonitor {
    /// Starts from `marks`, before the first step; `unit` steps are a unit of normalised time.
    #[must_use]
    pub fn new(system: System, unit: f64, begins: bool, marks: Vec<f32>) -> Self {
        let Convergence { earliest, latest, .. } = system.definition().convergence;
        Self {
            system,
            unit,
            begins,
            slack: 1.0,
            earliest,
            latest,
            before: marks,
            last: f64::INFINITY,
            checks: 0,
        }
    }

    /// This monitor, for marks among obstacles, which push them for a long time: single spots in lanes between three obstacles
    /// drift by up to 0.007 per unit of time when their areas have settled long ago.
    #[must_use]
    pub fn among_obstacles(self) -> Self {
        Self { slack: 2.0, ..self }
    }

    /// Takes account of marks that are moved back to their places. Marks that are moved until the end never rest: a pair that
    /// pushes each other is moved by 0.006 per unit of time when all areas have settled long ago. A unit of time takes at most
    /// `longest` steps ([`LONGEST`]). The growth takes `pace` times the steps.
    pub fn hold_marks(&mut self, longest: Option<f64>, pace: f64) {
        if let Some(longest) = longest {
            self.slack = 3.0;
            self.unit = self.unit.min(longest / pace);
        }
        self.latest = self.latest.min(HELD);
        self.unit *= pace;
    }

    /// Takes account of marks that are moved back to their places, in a pattern that had settled before some of its marks were
    /// corrected.
    pub fn hold_corrected_marks(&mut self, longest: Option<f64>) {
        self.hold_marks(longest, 1.0);
        self.latest = self.latest.min(CORRECTED);
    }

    /// Steps that make up a unit of time.
    #[must_use]
    pub fn unit(&self) -> f64 {
        self.unit
    }

    /// This monitor, for stripes that start from `scattered` segments, which must join first.
    #[must_use]
    pub fn joining(self, scattered: bool) -> Self {
        if scattered { Self { earliest: HEALED, ..self } } else { self }
    }

    /// The number of steps at which to check next.
    #[must_use]
    pub fn next_check(&self) -> u64 {
        let every = if self.begins { EVERY } else { OFTEN };
        let steps = ((self.checks + 1) as f64 * every * self.unit).ceil() as u64;
        steps.clamp(self.checks + 1, STEPS.max(self.checks + 1))
    }

    /// Steps that are expected on a grid.
    #[must_use]
    pub fn expected(system: System, unit: f64, begins: bool) -> f64 {
        let criterion = system.definition().convergence;
        (unit * if begins { 1.3 * criterion.earliest } else { criterion.corrected }).min(STEPS as f64)
    }

    /// Checks the marks after `steps` steps. `update` replaces the marks of the last check by the current ones, and returns the
    /// sums of |after − before| and of after over the cells that count.
    pub fn check(&mut self, steps: u64, update: impl FnOnce(&mut [f32]) -> [f64; 2]) -> Verdict {
        let criterion = self.system.definition().convergence;
        let time = steps as f64 / self.unit;
        let every = if self.begins { EVERY } else { OFTEN };
        let [moved, total] = update(&mut self.before);
        let change = if moved == 0.0 { 0.0 } else { moved / total } / every;
        let steady = change < self.slack * criterion.drift && change > FALLING * self.last;
        let corrected = !self.begins && time >= criterion.corrected && change < criterion.still;
        self.last = change;
        self.checks += 1;
        if corrected || time >= self.earliest && (steady || change < NEGLIGIBLE) {
            return Verdict::Settled;
        }
        if time >= self.latest || steps >= STEPS || !change.is_finite() {
            return Verdict::GivenUp;
        }
        Verdict::Forming
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The verdicts on a mark that changes by the share `change(check)` from check to check, one unit of time of ten steps each,
    /// until one is not [`Verdict::Forming`]; returns that verdict with its time.
    fn watched(begins: bool, change: impl Fn(usize) -> f32) -> (Verdict, f64) {
        let mut mark = 1.0f32;
        let mut monitor = ConvergenceMonitor::new(System::MEINHARDT_SPOTS, 10.0, begins, vec![mark]);
        for check in 0..1_000 {
            mark *= 1.0 + change(check);
            let steps = monitor.next_check();
            let verdict = monitor.check(steps, |before| {
                let moved = (mark - before[0]).abs();
                before[0] = mark;
                [f64::from(moved), f64::from(mark)]
            });
            if verdict != Verdict::Forming {
                return (verdict, steps as f64 / 10.0);
            }
        }
        panic!("never settled");
    }

    #[test]
    fn a_new_pattern_has_settled_when_its_change_stops_falling_but_not_before_the_earliest_time() {
        assert_eq!(watched(true, |_| 0.005), (Verdict::Settled, 15.0));
        let (verdict, time) = watched(true, |look| 0.5 * 0.5f32.powi(look as i32));
        assert!(verdict == Verdict::Settled && time > 20.0, "{time}");
        assert_eq!(watched(true, |_| 0.05), (Verdict::GivenUp, 120.0));
    }

    #[test]
    fn a_correction_is_short_unless_its_change_does_not_fall() {
        assert_eq!(watched(false, |_| 0.003), (Verdict::Settled, 4.0));
        let (verdict, time) = watched(false, |look| if look < 8 { 0.02 } else { 0.003 });
        assert_eq!((verdict, time), (Verdict::Settled, 9.0));
        assert_eq!(watched(false, |_| 0.011), (Verdict::GivenUp, 120.0));
    }

    #[test]
    fn concentrations_that_are_nan_end_the_growth() {
        let (verdict, time) = watched(true, |look| if look == 3 { f32::NAN } else { 0.001 });
        assert_eq!((verdict, time), (Verdict::GivenUp, 10.0));
    }
}
