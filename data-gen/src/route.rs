//! Compares the fast route with the long one, on the same seeds and grids: growth over coarse grids until settled, and
//! growth by plain Euler steps on the planned grid alone.

use dapple_engine::attributes::Attributes;
use dapple_engine::grid::{Edges, Field};
use dapple_engine::rd::{Growth, ParameterField, Parameters, System};
use dapple_engine::synth::{Engine, ProbePatch as Grown, Sample, Watch};
use rayon::prelude::*;
use serde_json::{Map, Value, json};

/// What to compare.
#[derive(clap::Args)]
pub struct Args {
    /// Seeds for each system and shape
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = clap::value_parser!(u64).range(1..=1_000))]
    seeds: u64,
    /// Print each seed, not only means
    #[arg(long)]
    each: bool,
    /// Print one JSON object instead, once all comparisons are done
    #[arg(long)]
    json: bool,
    /// Threads to use [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

/// A seamless patch with one kind of mark, whose size in cells is the planned one.
struct Patch {
    system: System,
    rate: f32,
    ratio: f32,
    stretch: f32,
    /// Normalised time of the long route.
    end: f64,
    /// Share of the peak at which spots are read.
    level: f64,
}

/// The number of squared spacings (or wavelengths) in a patch.
const MARKS: f64 = 92.0;
/// The largest allowed mean differences over the seeds: %, %, %, %, degrees.
const BOUNDS: [f64; 5] = [1.0, 1.0, 1.0, 1.0, 0.3];
/// Their names in JSON: differences in %, of the angle in degrees.
const NAMES: [&str; 5] = ["marks", "area_or_width", "spacing_or_wavelength", "aspect", "angle"];
/// The aspect above which spots are too round to have a direction.
const ROUND: f64 = 0.85;

fn patches() -> Vec<Patch> {
    let mut patches = Vec::new();
    for stretch in [1.0, 0.6, 0.35] {
        let turing =
            Patch { system: System::TURING_SPOTS, rate: 0.119, ratio: 3.8, stretch, end: 120.0, level: 0.35 };
        patches.push(turing);
        for (ratio, rate) in [(12.0, 3.4), (20.0, 2.0)] {
            patches.push(Patch {
                system: System::MEINHARDT_SPOTS,
                rate,
                ratio,
                stretch,
                end: 120.0,
                level: 0.5,
            });
        }
    }
    patches.push(Patch {
        system: System::MEINHARDT_STRIPES,
        rate: 25.6,
        ratio: 1.0,
        stretch: 0.5,
        end: 200.0,
        level: 0.5,
    });
    patches
}

/// The results of both routes for one seed.
struct Pair {
    /// Differences of marks, area (width), spacing, aspect, %; of the angle, degrees.
    differences: [Option<f64>; 5],
    steps: [u64; 2],
    settled: bool,
}

/// Compares and prints the table. Returns whether all means are within the bounds.
pub fn run(args: &Args) -> Result<bool, String> {
    if let Some(threads) = args.threads {
        rayon::ThreadPoolBuilder::new()
            .num_threads(usize::from(threads))
            .build_global()
            .map_err(|error| format!("cannot start {threads} threads: {error}"))?;
    }
    if args.json {
        return print_json(args.seeds);
    }
    crate::say("differences, fast − long: mean over seeds / largest of a seed")?;
    crate::say(&format!(
        "{:18} {:>5} {:>7} {:>7} {:>6} {:>13} {:>13} {:>13} {:>13} {:>13}",
        "system", "ratio", "stretch", "long", "fast", "marks %", "area %", "spacing %", "aspect %", "angle °"
    ))?;
    let mut good = true;
    for patch in patches() {
        let pairs = patch.pairs(args.seeds)?;
        if args.each {
            for (seed, pair) in pairs.iter().enumerate() {
                let output: Vec<String> =
                    pair.differences.iter().flatten().map(|d| format!("{d:+.2}")).collect();
                crate::say(&format!(
                    "    seed {seed}: {} steps for {}: {}",
                    pair.steps[1],
                    pair.steps[0],
                    output.join(" ")
                ))?;
            }
        }
        good &= patch.tell(&pairs)?;
    }
    Ok(good)
}

/// Compares all patches, and prints the numbers of the table and those of each seed.
fn print_json(seeds: u64) -> Result<bool, String> {
    let mut good = true;
    let mut output = Vec::new();
    for patch in patches() {
        let pairs = patch.pairs(seeds)?;
        let summary = Summary::from_pairs(&pairs);
        good &= summary.good;
        output.push(patch.json(&pairs, &summary));
    }
    crate::say(&format!("{:#}", json!({"patches": output, "good": good})))?;
    Ok(good)
}

/// The summary over the seeds of a patch.
struct Summary {
    /// Mean and largest difference, where the difference has a meaning.
    differences: [Option<[f64; 2]>; 5],
    steps: [u64; 2],
    good: bool,
}

impl Summary {
    fn from_pairs(pairs: &[Pair]) -> Self {
        let differences = [0, 1, 2, 3, 4].map(|k: usize| {
            let of_seeds: Vec<f64> = pairs.iter().filter_map(|pair| pair.differences[k]).collect();
            let mean = of_seeds.iter().sum::<f64>() / of_seeds.len() as f64;
            let largest = of_seeds.iter().map(|d| d.abs()).fold(0.0, f64::max);
            (!of_seeds.is_empty()).then_some([mean, largest])
        });
        let mut within = differences.iter().zip(BOUNDS);
        let within = within.all(|(found, bound)| found.is_none_or(|[mean, _]| mean.abs() <= bound));
        let good = within && pairs.iter().all(|pair| pair.settled);
        let steps = [0, 1].map(|k: usize| pairs.iter().map(|pair| pair.steps[k]).sum::<u64>());
        Self { differences, steps: steps.map(|steps| steps / pairs.len() as u64), good }
    }
}

impl Patch {
    fn pairs(&self, seeds: u64) -> Result<Vec<Pair>, String> {
        (0..seeds).into_par_iter().map(|seed| self.pair(seed)).collect()
    }

    fn json(&self, pairs: &[Pair], summary: &Summary) -> Value {
        let named = |values: &dyn Fn(usize) -> Value| -> Map<String, Value> {
            let named = NAMES.iter().enumerate().map(|(k, name)| ((*name).to_owned(), values(k)));
            named.filter(|(_, value)| !value.is_null()).collect()
        };
        let of_all = named(&|k| {
            summary.differences[k].map_or(
                Value::Null,
                |[mean, largest]| json!({"mean": mean, "largest": largest, "bound": BOUNDS[k]}),
            )
        });
        let seed = |pair: &Pair| {
            let [long, fast] = pair.steps;
            json!({"long_steps": long, "fast_steps": fast, "settled": pair.settled,
                "differences": named(&|k| json!(pair.differences[k]))})
        };
        let [long, fast] = summary.steps;
        json!({"system": self.system.name(), "ratio": self.ratio, "stretch": self.stretch, "long_steps": long,
            "fast_steps": fast, "differences": of_all, "good": summary.good,
            "seeds": pairs.iter().map(seed).collect::<Vec<_>>()})
    }

    fn pair(&self, seed: u64) -> Result<Pair, String> {
        let direction = (10.0 + 37.0 * seed as f32) % 180.0;
        let p =
            Parameters { rate: self.rate, ratio: self.ratio, stretch: self.stretch, direction, pitch: 1.0 };
        let spacing = self.system.spacing(&p);
        let side = (MARKS * 0.866 * spacing * spacing).sqrt().ceil() as usize;
        let maps = ParameterField::uniform([side, side], Edges::Wrap, p);
        let mut long = Growth::new(self.system, &maps, seed);
        long.advance(long.steps_in(self.end));
        let mut engine = Engine::from_maps(self.system, maps, seed);
        let settled = engine.settle(&Watch::NONE).map_err(|cancelled| cancelled.to_string())?;
        let [a, b] = [self.measured(&long.marks())?, self.measured(&engine.marks())?];
        Ok(Pair { differences: differences(&a, &b), steps: [long.steps(), engine.steps()], settled })
    }

    fn measured(&self, marks: &Field) -> Result<Sample, String> {
        let parameters = dapple_engine::learn::Parameters {
            rate: f64::from(self.rate),
            ratio: Some(f64::from(self.ratio)),
            stretch: f64::from(self.stretch),
            direction: 0.0,
            level: Some(self.level),
        };
        let patch = Grown { system: self.system, parameters, extent: MARKS, seed: 0 };
        patch.measure(marks).map_err(|reason| reason.to_string())
    }

    /// Prints a line. Returns whether it is within the bounds.
    fn tell(&self, pairs: &[Pair]) -> Result<bool, String> {
        let Summary { differences, steps, good } = Summary::from_pairs(pairs);
        let cells = differences.map(|found| {
            found.map_or("–".to_owned(), |[mean, largest]| format!("{mean:+.2} / {largest:.2}"))
        });
        crate::say(&format!(
            "{:18} {:>5} {:>7} {:>7} {:>6} {:>13} {:>13} {:>13} {:>13} {:>13}{}",
            self.system.name(),
            self.ratio,
            self.stretch,
            steps[0],
            steps[1],
            cells[0],
            cells[1],
            cells[2],
            cells[3],
            cells[4],
            if good { "" } else { "  ← out of bounds" }
        ))?;
        Ok(good)
    }
}

fn differences(long: &Sample, fast: &Sample) -> [Option<f64>; 5] {
    let [n, m] = [long.extent, fast.extent];
    let percent = |a: f64, b: f64| Some(100.0 * (b / a - 1.0));
    let turn = |a: f64, b: f64| Some((b - a + 90.0).rem_euclid(180.0) - 90.0);
    match (long.attributes.0, fast.attributes.0) {
        (Attributes::Spots(a), Attributes::Spots(b)) => [
            percent(n, m),
            percent(a.area, b.area),
            a.spacing.zip(b.spacing).and_then(|(a, b)| percent(a, b)),
            percent(a.aspect, b.aspect),
            turn(a.angle, b.angle).filter(|_| a.aspect < ROUND),
        ],
        (Attributes::Stripes(a), Attributes::Stripes(b)) => {
            [None, percent(a.width, b.width), percent(m, n), None, turn(a.angle, b.angle)]
        }
        _ => [None; 5],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_json_has_the_numbers_of_the_table() {
        let pair = |area: f64, turn: Option<f64>| Pair {
            differences: [Some(0.0), Some(area), None, Some(0.5), turn],
            steps: [1_000, 120],
            settled: true,
        };
        let pairs = [pair(1.5, None), pair(-0.5, Some(0.4))];
        let summary = Summary::from_pairs(&pairs);
        assert_eq!(summary.differences[1], Some([0.5, 1.5]));
        // The mean rotation, of the only seed that has a direction, is over its bound.
        assert!(!summary.good && Summary::from_pairs(&[pair(0.9, None)]).good);
        let output = patches()[0].json(&pairs, &summary);
        assert_eq!(
            output["differences"]["area_or_width"],
            json!({"mean": 0.5, "largest": 1.5, "bound": 1.0})
        );
        assert_eq!(output["seeds"][1]["differences"]["angle"], json!(0.4));
        assert_eq!((&output["long_steps"], &output["good"]), (&json!(1_000), &json!(false)));
        assert!(output["differences"].get("spacing_or_wavelength").is_none());
    }
}
