//! dapple's side of `compare`: takes the number of steps in each line of standard input, and prints the seconds.
//!
//! `peer CASE SIZE THREADS FOLDER` sets the problem up and writes it into FOLDER, raw little-endian f32 row by row,
//! so that the other side computes the same:
//!
//! - `start-0`, `start-1`: concentrations; `after-0`, `after-1`: those 20 plain steps later
//! - `weights`: 8 planes, one an offset of `dapple_engine::rd::selling::OFFSETS`
//! - `mobility-0`, `mobility-1`, `rate`: dt·D and dt·s of each cell
//!
//! Then it says `ready` and reads lines: `fast N`, `plain N`, `naive N` (isotropic only).

#[path = "../naive.rs"]
mod naive;

use dapple_engine::rd::benchmark::Case;
use dapple_engine::rd::selling::Tensor;
use dapple_engine::rd::{Growth, ParameterField, System};
use naive::Naive;
use std::error::Error;
use std::f64::consts::TAU;
use std::io::{BufRead, Write, stdin, stdout};
use std::path::Path;
use std::time::Instant;

/// Steps after which the results of both sides must agree.
const CHECKED: u64 = 20;
/// Variation of rate and ratio from place to place, so that no solver can treat them as constant.
const UNEVEN: f64 = 0.3;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [case, size, threads, folder] = &arguments[..] else {
        return Err("usage: peer isotropic|tensor|ratio SIZE THREADS FOLDER".into());
    };
    let (size, threads): (usize, usize) = (size.parse()?, threads.parse()?);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build()?;
    pool.install(|| serve(case, size, Path::new(folder)).map_err(|error| error.to_string()))?;
    Ok(())
}

fn serve(name: &str, size: usize, folder: &Path) -> Result<(), Box<dyn Error>> {
    let (system, stretch) = match name {
        "isotropic" => (System::TURING_SPOTS, 1.0),
        "tensor" => (System::TURING_SPOTS, 0.5),
        "ratio" => (System::MEINHARDT_SPOTS, 0.5),
        _ => return Err(format!("{name}: allowed: isotropic, tensor, ratio").into()),
    };
    let case = Case { system, stretch };
    let mut maps = case.maps(size);
    if stretch < 1.0 {
        make_uneven(&mut maps);
    }
    let mut growth = case.growth(&case.start(), &maps).ok_or("another system's start")?;
    export(system, &maps, &growth, folder)?;
    let rate = maps.parameters[0].rate;
    let mut naive = (name == "isotropic").then(|| Naive::beside(&growth, size, rate));
    if let Some(naive) = &mut naive {
        naive.check(&growth);
    }
    drop(maps);
    tell("ready")?;
    for line in stdin().lock().lines() {
        let line = line?;
        let (solver, steps) = line.split_once(' ').ok_or("allowed: SOLVER STEPS")?;
        let steps: u64 = steps.parse()?;
        let started = Instant::now();
        match (solver, &mut naive) {
            ("fast", _) => growth.advance(steps),
            ("plain", _) => growth.advance_plain(steps),
            ("naive", Some(naive)) => naive.advance(steps),
            _ => return Err(format!("{solver}: allowed: fast, plain, naive (isotropic)").into()),
        }
        tell(&started.elapsed().as_secs_f64().to_string())?;
    }
    Ok(())
}

fn make_uneven(maps: &mut ParameterField) {
    let [nx, ny] = maps.domain.size;
    for (cell, p) in maps.parameters.iter_mut().enumerate() {
        let [x, y] = [(cell % nx) as f64 / nx as f64, (cell / nx) as f64 / ny as f64];
        p.rate *= (1.0 + UNEVEN * libm::sin(TAU * x) * libm::cos(TAU * y)) as f32;
        p.ratio *= (1.0 + UNEVEN * libm::cos(TAU * x) * libm::sin(TAU * y)) as f32;
    }
}

/// Writes the problem as described at the head of this file.
fn export(
    system: System,
    maps: &ParameterField,
    growth: &Growth,
    folder: &Path,
) -> Result<(), Box<dyn Error>> {
    let decay = if system == System::MEINHARDT_SPOTS { 0.04 } else { 1.0 };
    let slowest = maps.parameters.iter().map(|p| p.rate).fold(f32::INFINITY, f32::min);
    let scale = naive::scale(growth, slowest, decay);
    let ratio = |p: f32| if system == System::MEINHARDT_SPOTS { p } else { 1.0 / naive::RATIO };
    let plane =
        |f: &dyn Fn(&dapple_engine::rd::Parameters) -> f32| maps.parameters.iter().map(f).collect::<Vec<_>>();
    write(folder, "rate", &plane(&|p| scale * p.rate))?;
    write(folder, "mobility-0", &plane(&|p| scale / ratio(p.ratio).sqrt()))?;
    write(folder, "mobility-1", &plane(&|p| scale * ratio(p.ratio).sqrt()))?;
    let weights: Vec<_> = maps
        .parameters
        .iter()
        .map(|p| {
            let stretch = f64::from(p.stretch);
            Tensor::oriented(1.0 / stretch, stretch, f64::from(p.direction)).weights()
        })
        .collect();
    // The other side takes the first eight offsets: the patterns that are compared have no tensors that need longer
    // ones.
    let planes: Vec<f32> = (0..8).flat_map(|k| weights.iter().map(move |w| w[k])).collect();
    write(folder, "weights", &planes)?;
    let mut later = growth.clone();
    later.advance_plain(CHECKED);
    for (when, growth) in [("start", growth), ("after", &later)] {
        for (chemical, cells) in growth.concentrations().iter().enumerate() {
            write(folder, &format!("{when}-{chemical}"), cells)?;
        }
    }
    Ok(())
}

fn write(folder: &Path, name: &str, values: &[f32]) -> std::io::Result<()> {
    std::fs::write(folder.join(name), values.iter().flat_map(|v| v.to_le_bytes()).collect::<Vec<_>>())
}

fn tell(word: &str) -> std::io::Result<()> {
    let mut out = stdout().lock();
    writeln!(out, "{word}")?;
    out.flush()
}
