//! Ways to solve the equations of Witkin and Kass: cost and error of each on their zebra and weave, all in one run.
//!
//! ```text
//!  noise ─┬─▶ Euler, super steps (the kernel of dapple) ─┐
//!         ├─▶ eq. 11, eq. 12 in Fourier space ───────────┼─▶ D of each direction ─▶ period, width, direction
//!         ├─▶ binary convolution by tables ──────────────┤
//!         └─▶ a coarse grid, then a fine one ────────────┘
//! ```
//!
//! All run on one thread. A. Witkin & M. Kass, "Reaction-diffusion textures", SIGGRAPH 1991, section 5.

mod binary;
mod case;
mod fourier;
mod kernel;

use dapple_engine::grid::{Edges, Field, Grid};
use dapple_engine::marks::turn;
use dapple_engine::measure::stripes;

use crate::say;
use case::Case;
use fourier::Rule;

/// Seeds of each pattern.
const SEEDS: [u64; 4] = [1, 2, 3, 4];
/// Cells along a side.
const SIDE: usize = 256;

/// What has grown from one seed.
struct Run {
    /// Steps or iterations.
    steps: u64,
    /// CPU time of this thread, s.
    seconds: f64,
    /// The difference C₊ − C₋ of each direction, or what stands for it.
    differences: Vec<Vec<f32>>,
    /// The level of its edges.
    level: f32,
}

/// Period, width (cells) and turn (degrees) of the lines of each direction; `None` where there are none.
type Found = Vec<Option<[f64; 3]>>;

/// A way to solve the equations.
enum Method {
    Euler,
    /// Super steps, by which dapple grows pairs.
    Super,
    Fourier(Rule, f64),
    /// [`Self::Fourier`] without the instructions of one processor.
    ScalarFourier(Rule, f64),
    Binary,
    /// From a grid with so many times fewer cells each way.
    Coarse(usize),
}

impl Method {
    fn name(&self, case: &Case) -> String {
        match self {
            Self::Euler => "Euler, dapple's kernel".to_owned(),
            Self::Super => "super steps, dapple's kernel".to_owned(),
            Self::Fourier(rule, step) => format!("{}, bΔt {step}", rule.name()),
            Self::ScalarFourier(rule, step) => format!("{}, bΔt {step}, scalar", rule.name()),
            Self::Binary => "binary convolution".to_owned(),
            Self::Coarse(factor) => {
                format!("coarse-to-fine, s {} → {}", case.size / *factor as f64, case.size)
            }
        }
    }

    fn run(&self, case: &Case, seed: u64) -> Result<Run, String> {
        match self {
            Self::Euler => kernel::euler(case, seed),
            Self::Super => kernel::super_steps(case, seed),
            Self::Fourier(rule, step) => fourier::run(case, seed, *rule, *step, true),
            Self::ScalarFourier(rule, step) => fourier::run(case, seed, *rule, *step, false),
            Self::Binary => binary::run(case, seed),
            Self::Coarse(factor) => kernel::coarse_to_fine(case, seed, *factor),
        }
    }
}

/// The methods, the first of which the others are compared with.
const METHODS: [Method; 13] = [
    Method::Euler,
    Method::Super,
    Method::Fourier(Rule::Exponential, 0.25),
    Method::Fourier(Rule::Exponential, 0.5),
    Method::Fourier(Rule::Exponential, 1.0),
    Method::Fourier(Rule::Exponential, 2.0),
    Method::ScalarFourier(Rule::Exponential, 0.5),
    Method::Fourier(Rule::Impulse, 0.25),
    Method::Fourier(Rule::Impulse, 1.0),
    Method::Fourier(Rule::Impulse, 2.0),
    Method::Binary,
    Method::Coarse(2),
    Method::Coarse(4),
];

/// Prints a table for each pattern.
pub fn print() -> Result<(), String> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let pool = pool.map_err(|error| format!("cannot start a thread: {error}"))?;
    pool.install(|| case::ALL.iter().try_for_each(table))
}

/// The period and width (cells) of the lines of each direction, and how far their directions are off (degrees).
fn measured(case: &Case, run: &Run) -> Found {
    let grid = Grid::unit([SIDE; 2], Edges::Wrap);
    let of = |(difference, angle): (&Vec<f32>, &f64)| {
        let found = stripes(&Field::new(&grid, difference.clone()), run.level)?;
        Some([found.wavelength, found.width, turn(found.angle, *angle)])
    };
    run.differences.iter().zip(case.angles).map(of).collect()
}

fn table(case: &Case) -> Result<(), String> {
    say(&format!("{} at s = {}, {SIDE}² cells, {} seeds", case.name, case.size, SEEDS.len()))?;
    say(&format!(
        "  {:28} {:>6} {:>9} {:>7} {:>9} {:>7} {:>7} {:>7}",
        "", "steps", "CPU ms", "×", "period %", "± %", "width %", "off °"
    ))?;
    let mut first: Option<(f64, Vec<Found>)> = None;
    for method in &METHODS {
        let runs: Vec<Run> = SEEDS.iter().map(|seed| method.run(case, *seed)).collect::<Result<_, _>>()?;
        let mut seconds: Vec<f64> = runs.iter().map(|run| run.seconds).collect();
        seconds.sort_by(f64::total_cmp);
        let cost = 0.5 * (seconds[1] + seconds[2]);
        let found: Vec<Found> = runs.iter().map(|run| measured(case, run)).collect();
        let (reference, own) = first.get_or_insert_with(|| (cost, found.clone()));
        let lines = line(own, &found);
        say(&format!(
            "  {:28} {:>6} {:>9.0} {:>7.2} {lines}",
            method.name(case),
            runs[0].steps,
            1e3 * cost,
            *reference / cost
        ))?;
    }
    say("")
}

/// Period, its standard deviation over seeds and directions, width and direction against the `reference`.
fn line(reference: &[Found], found: &[Found]) -> String {
    let all: Option<Vec<[f64; 3]>> = found.iter().flatten().copied().collect();
    let of_reference: Option<Vec<[f64; 3]>> = reference.iter().flatten().copied().collect();
    let Some((all, reference)) = all.zip(of_reference) else { return "nothing grew".to_owned() };
    let mean = |of: &[[f64; 3]], index: usize| of.iter().map(|of| of[index]).sum::<f64>() / of.len() as f64;
    let ratio = |index: usize| 100.0 * (mean(&all, index) / mean(&reference, index) - 1.0);
    let period = mean(&all, 0);
    let square = all.iter().map(|of| (of[0] / period - 1.0).powi(2)).sum::<f64>() / all.len() as f64;
    let off = all.iter().map(|of| of[2].abs()).sum::<f64>() / all.len() as f64;
    format!("{:>+9.1} {:>7.1} {:>+7.1} {off:>7.2}", ratio(0), 100.0 * square.sqrt(), ratio(1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_exponential_steps_give_what_euler_gives() {
        let case = Case { time: 6.0, ..case::ALL[0] };
        let [euler, exponential] = [Method::Euler, Method::Fourier(Rule::Exponential, 0.02)]
            .map(|method| method.run(&case, 1).expect("runs"));
        let (mut both, mut own, mut other) = (0.0, 0.0, 0.0);
        for (a, b) in euler.differences[0].iter().zip(&exponential.differences[0]) {
            let [a, b] = [*a, *b].map(f64::from);
            (both, own, other) = (both + a * b, own + a * a, other + b * b);
        }
        let correlation = both / (own * other).sqrt();
        assert!(correlation > 0.97, "{correlation}");
    }
}
