//! Where the time of a growth goes: CPU time by phase.
//!
//! The code names the phase that it works for with [`during`]. Time counts for the innermost phase; only what a probe does
//! besides its steps counts for [`Phase::Probe`] as a whole. [`measured`] collects the times of one thread, so the work has to run
//! in a thread pool of one. Nothing is measured elsewhere. The caller brings the clock: the time since some moment.

use std::cell::RefCell;
use std::time::Duration;

/// A part of the work from a document to its picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// Attributes of the sketch and their parameters.
    LookUp,
    /// Growing and measuring small patches, to correct the looked-up parameters; but for the steps of their growth.
    Probe,
    /// Places of marks.
    LayOut,
    /// Parameters of every cell, on each grid.
    Parameters,
    /// Stencil weights, rates and mobilities of every cell, on each grid.
    Coefficients,
    /// Initial concentrations, and prolongation to finer grids.
    Start,
    /// Steps of the solver.
    Steps,
    /// Checks of convergence.
    Checks,
    /// Moving drawn marks back to their places.
    Moves,
    /// Measuring the pattern and correcting levels.
    Measure,
    /// Patterns and colours of the px.
    Paint,
    /// Encoding and writing files.
    Write,
    /// All else.
    Rest,
}

impl Phase {
    /// All phases, in the order of the work.
    pub const ALL: [Self; 13] = [
        Self::LookUp,
        Self::Probe,
        Self::LayOut,
        Self::Parameters,
        Self::Coefficients,
        Self::Start,
        Self::Steps,
        Self::Checks,
        Self::Moves,
        Self::Measure,
        Self::Paint,
        Self::Write,
        Self::Rest,
    ];

    /// Its name in tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::LookUp => "look up",
            Self::Probe => "probe",
            Self::LayOut => "lay out",
            Self::Parameters => "parameters",
            Self::Coefficients => "coefficients",
            Self::Start => "start",
            Self::Steps => "steps",
            Self::Checks => "checks",
            Self::Moves => "moves",
            Self::Measure => "measure",
            Self::Paint => "paint",
            Self::Write => "write",
            Self::Rest => "rest",
        }
    }
}

/// CPU seconds of each of [`Phase::ALL`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Seconds([f64; Phase::ALL.len()]);

impl Seconds {
    /// Those of `phase`.
    #[must_use]
    pub fn of(&self, phase: Phase) -> f64 {
        self.0[phase as usize]
    }

    /// Those that `of` gives for each phase.
    #[must_use]
    pub fn by_phase(of: impl FnMut(Phase) -> f64) -> Self {
        Self(Phase::ALL.map(of))
    }

    /// The sum of all phases.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.0.iter().sum()
    }
}

/// Collects the times of a thread.
struct Clock {
    seconds: Seconds,
    phase: Phase,
    /// When the current phase began or was last counted.
    since: Duration,
    /// The time since some moment.
    now: fn() -> Duration,
}

impl Clock {
    /// Counts the time until now, and begins `phase`. Returns the phase before.
    fn begin(&mut self, phase: Phase) -> Phase {
        let now = (self.now)();
        self.seconds.0[self.phase as usize] += now.saturating_sub(self.since).as_secs_f64();
        self.since = now;
        std::mem::replace(&mut self.phase, phase)
    }
}

thread_local! {
    static CLOCK: RefCell<Option<Clock>> = const { RefCell::new(None) };
}

/// Begins `phase` on this thread's clock, if it has one. Returns the phase before.
fn begin(phase: Phase) -> Option<Phase> {
    CLOCK.with_borrow_mut(|clock| clock.as_mut().map(|clock| clock.begin(phase)))
}

/// Does `work`, whose time counts for `phase`.
pub fn during<T>(phase: Phase, work: impl FnOnce() -> T) -> T {
    let current = CLOCK.with_borrow(|clock| clock.as_ref().map(|clock| clock.phase));
    // The steps of a probe are steps.
    let part_of_probe = current == Some(Phase::Probe) && phase != Phase::Steps;
    let phase = if part_of_probe { Phase::Probe } else { phase };
    let before = begin(phase);
    let done = work();
    before.map(begin);
    done
}

/// Seconds that this thread's clock has counted; 0 where it has none.
#[must_use]
pub fn time() -> f64 {
    CLOCK.with_borrow_mut(|clock| {
        clock.as_mut().map_or(0.0, |clock| {
            clock.begin(clock.phase);
            clock.seconds.total()
        })
    })
}

/// Does `work` and returns the time of its phases on this thread by the clock `now`, such as that of its CPU time.
pub fn measured<T>(now: fn() -> Duration, work: impl FnOnce() -> T) -> (T, Seconds) {
    let clock = Clock { seconds: Seconds::default(), phase: Phase::Rest, since: now(), now };
    let outer = CLOCK.replace(Some(clock));
    let done = work();
    begin(Phase::Rest);
    let seconds = CLOCK.replace(outer).map_or_else(Seconds::default, |clock| clock.seconds);
    (done, seconds)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::Cell;

    thread_local! {
        static NOW: Cell<Duration> = const { Cell::new(Duration::ZERO) };
    }

    fn now() -> Duration {
        NOW.get()
    }

    /// Takes a millisecond of the clock.
    fn work() {
        NOW.set(now() + Duration::from_millis(1));
    }

    #[test]
    fn time_counts_for_the_innermost_phase_and_then_for_the_outer_one_again() {
        let ((), seconds) = measured(now, || {
            during(Phase::Measure, || {
                work();
                during(Phase::Paint, work);
                work();
            });
        });
        assert_eq!([Phase::Measure, Phase::Paint].map(|phase| seconds.of(phase)), [2e-3, 1e-3]);
        assert_eq!(seconds.of(Phase::Steps), 0.0);
        assert_eq!(seconds.total(), 3e-3);
    }

    #[test]
    fn all_of_a_probe_but_its_steps_counts_as_probe() {
        let ((), seconds) = measured(now, || {
            during(Phase::Probe, || {
                during(Phase::Measure, work);
                during(Phase::Steps, work);
            });
        });
        assert_eq!(seconds.of(Phase::Measure), 0.0);
        assert_eq!([Phase::Probe, Phase::Steps].map(|phase| seconds.of(phase)), [1e-3; 2]);
    }

    #[test]
    fn without_a_clock_the_work_is_done_all_the_same() {
        assert_eq!(during(Phase::Steps, || 7), 7);
    }

    #[test]
    fn every_phase_has_its_own_place_and_name() {
        for (index, phase) in Phase::ALL.into_iter().enumerate() {
            assert_eq!(phase as usize, index);
            assert_eq!(Phase::ALL.iter().filter(|other| other.name() == phase.name()).count(), 1);
        }
    }
}
