//! One run: parameters → simulation → a row, or the reason why not.

use dapple::attributes::spacing::{edges, trimmed_mean};
use dapple::attributes::{Attributes, Spots, axial_mean};
use dapple::field::{Edges, Field};
use dapple::learn::{Parameters, Row};
use dapple::measure::{self, Spot};
use dapple::rd::{Maps, System};
use dapple::synth::{Engine, Watch, settle};
use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;

use crate::plan::Set;

/// Spots that a patch holds, or squared wavelengths: enough that its means are known to a per cent.
const MARKS: f64 = 80.0;
/// Range of the marks field below which nothing has formed, a tenth of the usual.
const LEAST: f32 = 0.1;

/// What came of a run.
pub struct Outcome {
    /// Its seed.
    pub seed: u64,
    /// What had been set.
    pub parameters: Parameters,
    /// What was measured, or why it cannot be learnt from.
    pub row: Result<Row, String>,
}

/// Runs 0..`runs` of a set, in parallel, in their order.
pub fn all(set: &Set, runs: u64) -> Vec<Outcome> {
    let style = ProgressStyle::with_template("{msg:18} {bar:40} {pos}/{len}  {elapsed} gone, {eta} left");
    let bar = ProgressBar::new(runs)
        .with_message(set.system.name())
        .with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    let outcomes = (0..runs)
        .into_par_iter()
        .map(|index| {
            let outcome = one(set, index);
            bar.inc(1);
            outcome
        })
        .collect();
    bar.finish();
    outcomes
}

fn one(set: &Set, index: u64) -> Outcome {
    let (seed, parameters) = (set.seed(index), set.draw(index));
    let row = grown(set.system, &parameters, seed)
        .and_then(|field| match set.system {
            System::MeinhardtStripes => stripes(&field),
            _ => spots(&field, parameters.level.unwrap_or(0.5)),
        })
        .map(|(extent, evenness, attributes)| Row { seed, extent, evenness, attributes, parameters });
    Outcome { seed, parameters, row }
}

/// Grows a wrapped square patch until it is settled.
fn grown(system: System, p: &Parameters, seed: u64) -> Result<Field, String> {
    let set = dapple::rd::Parameters {
        rate: p.rate as f32,
        ratio: p.ratio.unwrap_or(1.0) as f32,
        stretch: p.stretch as f32,
        direction: p.direction as f32,
        pitch: 1.0,
    };
    let spacing = system.spacing(&set);
    let side = match system {
        System::MeinhardtStripes => (MARKS.sqrt() * spacing).ceil(),
        // A hexagonal lattice has 2/√3 points a squared spacing.
        _ => (MARKS * 0.866 * spacing * spacing).sqrt().ceil(),
    } as usize;
    let maps = Maps::uniform(side, side, set);
    let mut engine = Engine::of(system, maps, Edges::Wrap, seed);
    match settle(&mut engine, &Watch::NOBODY) {
        Ok(true) => Ok(engine.marks()),
        Ok(false) => Err("did not settle".to_owned()),
        Err(cancelled) => Err(cancelled.to_string()),
    }
}

/// Marks (or wavelengths), evenness, what was measured.
pub type Measured = (f64, f64, Attributes);

/// Means over the whole spots of a patch.
pub fn spots(field: &Field, level: f64) -> Result<Measured, String> {
    let census = measure::census(field, level as f32);
    measure::spot_texture(field, &census, LEAST).map_err(|reason| reason.to_string())?;
    let whole: Vec<&Spot> = census.spots.iter().filter(|spot| spot.whole).collect();
    let n = whole.len() as f64;
    let mean = |value: &dyn Fn(&Spot) -> f64| whole.iter().map(|spot| value(spot)).sum::<f64>() / n;
    let area = mean(&|spot| spot.ellipse.area());
    let variance = mean(&|spot| (spot.ellipse.area() - area) * (spot.ellipse.area() - area));
    let centers: Vec<[f64; 2]> = whole.iter().map(|spot| spot.ellipse.center).collect();
    let lengths = edges(&centers, Some(field.extent())).iter().map(|edge| edge.length).collect();
    let spacing = trimmed_mean(lengths).ok_or("no neighbours")?;
    let weighted = whole.iter().map(|spot| (spot.ellipse.major_angle(), 1.0 - spot.ellipse.aspect()));
    let angle = axial_mean(weighted).map_or(0.0, |(angle, _)| angle);
    let attributes =
        Spots { area, aspect: mean(&|spot| spot.ellipse.aspect()), angle, spacing: Some(spacing) };
    Ok((n, variance.sqrt() / area, Attributes::Spots(attributes)))
}

/// Means over a patch of stripes.
pub fn stripes(field: &Field) -> Result<Measured, String> {
    let found = measure::stripes(field, 0.5);
    measure::stripe_texture(field, found.as_ref(), LEAST).map_err(|reason| reason.to_string())?;
    let found = found.ok_or("no stripes")?;
    let wavelengths = field.extent()[0] / found.wavelength;
    let stripes = dapple::attributes::Stripes { width: found.width, angle: found.angle };
    Ok((wavelengths, found.coherence, Attributes::Stripes(stripes)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::sets;

    #[test]
    fn the_rows_do_not_depend_on_the_number_of_threads() {
        let [.., set] = sets();
        let rows = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            let outcomes = pool.install(|| all(&set, 3));
            outcomes.into_iter().map(|outcome| outcome.row.unwrap()).collect::<Vec<_>>()
        };
        assert_eq!(rows(1), rows(3));
    }

    #[test]
    fn what_has_no_pattern_is_rejected_with_the_reason() {
        let flat = Field::flat(40, 40, Edges::Wrap, 0.4);
        assert!(spots(&flat, 0.5).unwrap_err().starts_with("no pattern"));
        assert!(stripes(&flat).unwrap_err().starts_with("no pattern"));
    }
}
