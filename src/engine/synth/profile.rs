//! CPU time of a growth by section of the work.
//!
//! The code marks sections with [`during`]. Time counts for the innermost section; but the work of a probe counts for
//! [`Section::Probe`] as a whole, except its steps. [`measured`] collects the times of one thread, so the work has to run in a
//! thread pool of one thread. Nothing is measured outside of it. The caller provides the clock: the time since some moment.

use std::cell::RefCell;
use std::time::Duration;

/// A part of the work from a document to its picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Section {
    /// Attributes of the sketch and their parameters.
    LookUp,
    /// Growing and measuring small patches, to correct the looked-up parameters, except the steps of their growth.
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
    /// Measuring the pattern and correcting thresholds.
    Measure,
    /// Patterns and colours of the px.
    Paint,
    /// Encoding and writing files.
    Write,
    /// All else.
    Rest,
}

impl Section {
    /// All sections, in the order of the work.
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

/// CPU seconds of each of [`Section::ALL`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Seconds([f64; Section::ALL.len()]);

impl Seconds {
    /// Seconds of `section`.
    #[must_use]
    pub fn of(&self, section: Section) -> f64 {
        self.0[section as usize]
    }

    /// The seconds that `of` gives for each section.
    #[must_use]
    pub fn by_section(of: impl FnMut(Section) -> f64) -> Self {
        Self(Section::ALL.map(of))
    }

    /// The sum of all sections.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.0.iter().sum()
    }
}

/// Collects the times of a thread.
struct Clock {
    seconds: Seconds,
    section: Section,
    /// The time at which the current section began or was last counted.
    since: Duration,
    /// The time since some moment.
    now: fn() -> Duration,
}

impl Clock {
    /// Counts the time until now, and begins `section`. Returns the section before.
    fn begin(&mut self, section: Section) -> Section {
        let now = (self.now)();
        self.seconds.0[self.section as usize] += now.saturating_sub(self.since).as_secs_f64();
        self.since = now;
        std::mem::replace(&mut self.section, section)
    }
}

thread_local! {
    static CLOCK: RefCell<Option<Clock>> = const { RefCell::new(None) };
}

/// Begins `section` on this thread's clock, if it has one. Returns the section before.
fn begin(section: Section) -> Option<Section> {
    CLOCK.with_borrow_mut(|clock| clock.as_mut().map(|clock| clock.begin(section)))
}

/// Does `work`, whose time counts for `section`.
pub fn during<T>(section: Section, work: impl FnOnce() -> T) -> T {
    let current = CLOCK.with_borrow(|clock| clock.as_ref().map(|clock| clock.section));
    // The steps of a probe count as steps.
    let part_of_probe = current == Some(Section::Probe) && section != Section::Steps;
    let section = if part_of_probe { Section::Probe } else { section };
    let before = begin(section);
    let done = work();
    before.map(begin);
    done
}

/// Seconds that this thread's clock has counted; 0 where it has none.
#[must_use]
pub fn time() -> f64 {
    CLOCK.with_borrow_mut(|clock| {
        clock.as_mut().map_or(0.0, |clock| {
            clock.begin(clock.section);
            clock.seconds.total()
        })
    })
}

/// Does `work` and returns the time of its sections on this thread by the clock `now`, such as that of its CPU time.
pub fn measured<T>(now: fn() -> Duration, work: impl FnOnce() -> T) -> (T, Seconds) {
    let clock = Clock { seconds: Seconds::default(), section: Section::Rest, since: now(), now };
    let outer = CLOCK.replace(Some(clock));
    let done = work();
    begin(Section::Rest);
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

    /// Work of one millisecond by the clock.
    fn work() {
        NOW.set(now() + Duration::from_millis(1));
    }

    #[test]
    fn time_counts_for_the_innermost_section_and_then_for_the_outer_one_again() {
        let ((), seconds) = measured(now, || {
            during(Section::Measure, || {
                work();
                during(Section::Paint, work);
                work();
            });
        });
        assert_eq!([Section::Measure, Section::Paint].map(|section| seconds.of(section)), [2e-3, 1e-3]);
        assert_eq!(seconds.of(Section::Steps), 0.0);
        assert_eq!(seconds.total(), 3e-3);
    }

    #[test]
    fn all_of_a_probe_but_its_steps_counts_as_probe() {
        let ((), seconds) = measured(now, || {
            during(Section::Probe, || {
                during(Section::Measure, work);
                during(Section::Steps, work);
            });
        });
        assert_eq!(seconds.of(Section::Measure), 0.0);
        assert_eq!([Section::Probe, Section::Steps].map(|section| seconds.of(section)), [1e-3; 2]);
    }

    #[test]
    fn without_a_clock_the_work_is_done_all_the_same() {
        assert_eq!(during(Section::Steps, || 7), 7);
    }

    #[test]
    fn every_section_has_its_own_place_and_name() {
        for (index, section) in Section::ALL.into_iter().enumerate() {
            assert_eq!(section as usize, index);
            assert_eq!(Section::ALL.iter().filter(|other| other.name() == section.name()).count(), 1);
        }
    }
}
