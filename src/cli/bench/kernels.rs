//! Cell updates a second of the plain solver on one thread and of the fast solver on one and on several threads,
//! measured alternately.

use super::check_interrupt;
use crate::cli::Error;
use crate::machine::clock::Instant;
use crate::machine::threads::{self, ThreadPool};
use crate::rd::Growth;
use crate::rd::benchmark::{Case, Start};
use std::time::Duration;

/// How long to measure.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// Number of runs of each solver.
    pub pairs: usize,
    /// Least duration of a run.
    pub at_least: Duration,
    /// Number of growths of each picture.
    pub pictures: usize,
}

/// Thread pools.
pub struct Pools {
    one: ThreadPool,
    all: ThreadPool,
    /// Threads of the second pool.
    pub threads: usize,
}

impl Pools {
    /// A pool of one thread, and one of `threads` threads (`None` = as many as there are cores).
    pub fn new(threads: Option<usize>) -> Result<Self, Error> {
        let pool = |threads: usize| threads::pool(threads).map_err(Error::step);
        // With 0, rayon chooses the number.
        let all = pool(threads.unwrap_or(0))?;
        let threads = all.current_num_threads();
        Ok(Self { one: pool(1)?, all, threads })
    }

    /// Runs `work` on all threads.
    pub fn run<T: Send>(&self, work: impl FnOnce() -> T + Send) -> T {
        self.all.install(work)
    }

    /// Runs `work` on one thread.
    pub fn run_on_one<T: Send>(&self, work: impl FnOnce() -> T + Send) -> T {
        self.one.install(work)
    }
}

/// The measurements of one case at one size. Rates are cell updates a second (all chemicals of a cell, one step).
#[derive(Clone, Debug)]
pub struct Kernel {
    /// The case.
    pub case: Case,
    /// Cells along each side.
    pub size: usize,
    /// Median rate of the plain solver on one thread.
    pub plain: f64,
    /// Median rate of the fast solver on one thread.
    pub one: f64,
    /// Median rate of the fast solver on all threads.
    pub all: f64,
    /// Median over the pairs of fast ÷ plain, both on one thread.
    pub fast_over_plain: f64,
    /// Median over the pairs of all threads ÷ one, both fast.
    pub all_over_one: f64,
}

/// The steps of the fast solver are multiples of this, because it takes several steps in one sweep over the grid.
const SWEEP: u64 = 16;

/// Advances a growth by a number of steps.
type Solver<'a> = &'a dyn Fn(&mut Growth, u64);

/// Measures `case` at `size`.
///
/// # Errors
/// [`Error::Interrupted`].
pub fn measure(
    case: &Case,
    start: &Start,
    size: usize,
    pools: &Pools,
    effort: Effort,
) -> Result<Kernel, Error> {
    let growth = case.growth(start, &case.maps(size));
    // The start belongs to the system of the case.
    let mut growth = growth
        .ok_or_else(|| Error::Usage(format!("{}: the start belongs to another system", case.name())))?;
    let plain: Solver = &|growth, steps| pools.one.install(|| growth.advance_plain(steps));
    let one: Solver = &|growth, steps| pools.one.install(|| growth.advance(steps));
    let all: Solver = &|growth, steps| pools.all.install(|| growth.advance(steps));
    let mut turns = Vec::with_capacity(3);
    for (solver, sweep) in [(plain, 1), (one, SWEEP), (all, SWEEP)] {
        let steps = steps_for(effort.at_least, sweep, |steps| {
            check_interrupt()?;
            Ok(seconds(|| solver(&mut growth, steps)))
        })?;
        turns.push((solver, steps));
    }
    let mut rates = [const { Vec::new() }; 3];
    for _ in 0..effort.pairs {
        for ((solver, steps), rates) in turns.iter().zip(&mut rates) {
            check_interrupt()?;
            let updates = (size * size) as f64 * *steps as f64;
            rates.push(updates / seconds(|| solver(&mut growth, *steps)));
        }
    }
    let [plain, one, all] = &rates;
    let ratio = |a: &[f64], b: &[f64]| median(a.iter().zip(b).map(|(a, b)| a / b).collect());
    Ok(Kernel {
        case: *case,
        size,
        plain: median(plain.clone()),
        one: median(one.clone()),
        all: median(all.clone()),
        fast_over_plain: ratio(one, plain),
        all_over_one: ratio(all, one),
    })
}

/// The number of steps, a multiple of `sweep`, that takes at least `at_least`. `run` returns the duration of some steps, seconds.
fn steps_for(
    at_least: Duration,
    sweep: u64,
    mut run: impl FnMut(u64) -> Result<f64, Error>,
) -> Result<u64, Error> {
    let wanted = at_least.as_secs_f64();
    // The first run is not counted: it fills the caches.
    run(sweep)?;
    let mut steps = sweep;
    loop {
        let taken = run(steps)?;
        if taken >= 0.25 * wanted {
            // A tenth more, because the next run may be faster.
            let sweeps = (1.1 * wanted / taken * steps as f64 / sweep as f64).ceil() as u64;
            return Ok(sweep * sweeps.max(1));
        }
        steps *= 2;
    }
}

/// The duration of `work`, seconds.
pub fn seconds(work: impl FnOnce()) -> f64 {
    let started = Instant::now();
    work();
    started.elapsed().as_secs_f64()
}

/// The median; NaN where there are no numbers.
pub fn median(mut numbers: Vec<f64>) -> f64 {
    numbers.sort_by(f64::total_cmp);
    let half = numbers.len() / 2;
    match numbers.len() {
        0 => f64::NAN,
        n if n % 2 == 1 => numbers[half],
        _ => 0.5 * (numbers[half - 1] + numbers[half]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_is_the_central_value() {
        assert_eq!(median(vec![3.0, 1.0, 2.0]), 2.0);
        assert_eq!(median(vec![4.0, 1.0, 2.0, 3.0]), 2.5);
        assert!(median(vec![]).is_nan());
    }

    #[test]
    fn the_steps_take_long_enough() {
        for a_step in [1e-6, 0.003, 0.5] {
            let steps = steps_for(Duration::from_millis(100), 16, |steps| Ok(a_step * steps as f64)).unwrap();
            assert!(steps % 16 == 0 && a_step * steps as f64 >= 0.1);
            assert!(steps == 16 || a_step * (steps as f64) < 0.2, "{steps}");
        }
    }

    #[test]
    fn measuring_gives_rates_of_each_solver() {
        let effort = Effort { pairs: 1, at_least: Duration::from_micros(10), pictures: 0 };
        let case = Case::ALL[1];
        let found = measure(&case, &case.start(), 24, &Pools::new(Some(2)).unwrap(), effort).unwrap();
        for rate in [found.plain, found.one, found.all, found.fast_over_plain, found.all_over_one] {
            assert!(rate.is_finite() && rate > 0.0, "{found:?}");
        }
        assert_eq!(found.fast_over_plain, found.one / found.plain);
    }
}
