//! Measures whether patches have the area, spacing, aspect, direction and raggedness of the drawn outlines, over random
//! sketches of nine outlines each.

use std::f64::consts::{PI, TAU};
use std::time::Instant;

use dapple::document::{Document, Edges, Layer, LayerOptions, Outline, Stroke};
use dapple_engine::attributes::Attribute;
use dapple_engine::measure::raggedness;

use super::dice::Dice;
use super::parallel;
use super::statistics::Summary;

/// The seed of all sketches: the year of the paper on partition of unity parametrics.
const SEED: u64 = 2009;
/// The attributes that are measured, with their factor and unit in the table.
const ATTRIBUTES: [(Attribute, f64, &str); 5] = [
    (Attribute::Area, 100.0, "%"),
    (Attribute::Spacing, 100.0, "%"),
    (Attribute::Aspect, 1.0, ""),
    (Attribute::Angle, 1.0, "°"),
    (Attribute::Raggedness, 100.0, "%"),
];
/// A mark whose area is more than this many times the asked one is two that grew together.
const MERGED: f64 = 1.6;
/// Corners of a drawn outline.
const CORNERS: usize = 90;
/// Steps of the bisection that finds the height of an outline's waves for its raggedness.
const HALVINGS: usize = 30;

/// The options of the trial.
#[derive(clap::Args)]
pub struct Args {
    /// Number of sketches
    #[arg(long, value_name = "N", default_value_t = 60)]
    sketches: u64,
    /// Sides of the canvas, px
    #[arg(long, value_name = "PX", default_value_t = 1024, value_parser = clap::value_parser!(u32).range(256..=8192))]
    side: u32,
    /// Threads to use; each grows its own documents [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

/// The attributes that a sketch asks for.
struct Wanted {
    coverage: f64,
    area: f64,
    aspect: f64,
    angle: f64,
    raggedness: f64,
    edges: Edges,
}

/// The result of a sketch.
struct Outcome {
    errors: [Option<f64>; ATTRIBUTES.len()],
    patches: usize,
    merged: usize,
    cramped: usize,
    seconds: f64,
}

/// Grows and measures all sketches, and prints the table. Returns whether nothing failed and no patches grew together.
pub fn run(args: &Args) -> Result<bool, String> {
    let sketches: Vec<u64> = (0..args.sketches).collect();
    let name = |index: &u64| format!("patches {index}");
    let outcomes =
        parallel::each(&sketches, parallel::threads(args.threads), name, |index| tried(*index, args.side))?;
    for (k, (name, factor, unit)) in ATTRIBUTES.iter().enumerate() {
        let errors = outcomes.iter().filter_map(|of| of.errors[k]).map(|error| factor * error);
        let line = match Summary::from_errors(errors) {
            Some(Summary { count, median, p95, max }) => {
                format!(
                    "{name:<11}{count:>4} sketches  median {median:.3}{unit}  95 % {p95:.3}{unit}  largest {max:.3}{unit}"
                )
            }
            None => format!("{name:<11}nothing was measured"),
        };
        crate::say(&line)?;
    }
    for (sketch, of) in outcomes.iter().enumerate().filter(|(_, of)| of.merged > 0) {
        crate::say(&format!("sketch {sketch}: {} of {} patches run together", of.merged, of.patches))?;
    }
    let sum = |count: fn(&Outcome) -> usize| outcomes.iter().map(count).sum::<usize>();
    let merged = sum(|of| of.merged);
    let slowest = outcomes.iter().enumerate().max_by(|(_, a), (_, b)| a.seconds.total_cmp(&b.seconds));
    let (sketch, seconds) = slowest.map_or((0, 0.0), |(sketch, of)| (sketch, of.seconds));
    crate::say(&format!(
        "{} patches, {merged} run together, {} without room for nine tenths of their area; the slowest, sketch {sketch}, took {seconds:.2} s",
        sum(|of| of.patches),
        sum(|of| of.cramped)
    ))?;
    Ok(merged == 0 && outcomes.iter().all(|of| of.errors[0].is_some()))
}

/// Grows and measures sketch `index` on `side` × `side` px.
fn tried(index: u64, side: u32) -> Result<Outcome, String> {
    let mut dice = Dice::from_seed(SEED * 1_000 + index);
    let wanted = Wanted::drawn(&mut dice);
    let document = wanted.document(&mut dice, side, index);
    let started = Instant::now();
    let grown = document.grow().map_err(|error| format!("sketch {index}: {error}"))?;
    let seconds = started.elapsed().as_secs_f64();
    let report = grown.report();
    let region = &report.layers[0].regions[0];
    let of =
        |attribute: Attribute| region.error.iter().find(|(of, _)| *of == attribute).map(|(_, error)| *error);
    let areas = grown.layers[0].areas().ok_or_else(|| format!("sketch {index}: no patches grew"))?;
    let merged = areas.spots.iter().filter(|spot| spot.ellipse.area() > MERGED * wanted.area).count();
    Ok(Outcome {
        errors: ATTRIBUTES.map(|(attribute, ..)| of(attribute)),
        patches: areas.spots.len(),
        merged,
        cramped: areas.cramped,
        seconds,
    })
}

impl Wanted {
    /// Random attributes: coverage 0.15–0.7, aspect 0.4–0.9 (0.8 above a raggedness of 1.6), raggedness 1.15–2.2, areas
    /// of 500–3,000 px².
    fn drawn(dice: &mut Dice) -> Self {
        let coverage = dice.between([0.15, 0.7]);
        let raggedness = dice.between([1.15, 2.2]);
        let aspect = dice.between([0.4, if raggedness > 1.6 { 0.8 } else { 0.9 }]);
        let area = dice.log_between([500.0, 3_000.0]);
        let angle = dice.between([0.0, 180.0]);
        let edges = if dice.chance(0.5) { Edges::Wrap } else { Edges::Closed };
        Self { coverage, area, aspect, angle, raggedness, edges }
    }

    /// Nine outlines on a hexagonal lattice in the middle; the drawn outlines themselves are not part of the texture.
    fn document(&self, dice: &mut Dice, side: u32, seed: u64) -> Document {
        let apart = (self.area * 2.0 / (3f64.sqrt() * self.coverage)).sqrt();
        let middle = 0.5 * f64::from(side);
        let outlines = (0..9).map(|k| {
            let (column, row) = (f64::from(k % 3), f64::from(k / 3));
            let x = (column - 1.0 + 0.5 * (row % 2.0)) * apart;
            let at = [middle + x, middle + (row - 1.0) * 0.75f64.sqrt() * apart];
            Stroke::Outline(Outline { points: self.outline(dice, at) })
        });
        let options = LayerOptions { keep: Some(false), ..LayerOptions::default() };
        let layer = Layer { options, ..Layer::new(outlines.collect::<Vec<_>>()) };
        Document { edges: self.edges, seed, ..Document::new([side; 2]).with_layer(layer) }
    }

    /// An ellipse whose radius varies by four waves, whose height gives the raggedness.
    fn outline(&self, dice: &mut Dice, at: [f64; 2]) -> Vec<[f64; 2]> {
        let waves =
            [3.0f64, 5.0, 8.0, 13.0].map(|turns| (turns, dice.between([0.0, TAU]), dice.between([0.5, 1.0])));
        let shape = |high: f64| {
            let corner = |k: usize| {
                let turn = TAU * k as f64 / CORNERS as f64;
                let wave = waves
                    .iter()
                    .map(|(turns, phase, part)| part / turns.sqrt() * libm::sin(turns * turn + phase));
                let radius = libm::exp(high * wave.sum::<f64>());
                let (s, c) = libm::sincos(turn);
                [radius * c / self.aspect.sqrt(), radius * s * self.aspect.sqrt()]
            };
            self.placed((0..CORNERS).map(corner).collect(), at)
        };
        let [mut low, mut high] = [0.0, 1.2];
        for _ in 0..HALVINGS {
            let between = 0.5 * (low + high);
            let is_below = raggedness(&shape(between)).is_some_and(|found| found < self.raggedness);
            if is_below { low = between } else { high = between }
        }
        shape(low)
    }

    /// The shape, turned and scaled to the asked direction and area.
    fn placed(&self, shape: Vec<[f64; 2]>, at: [f64; 2]) -> Vec<[f64; 2]> {
        let next = shape.iter().cycle().skip(1);
        let area: f64 = shape.iter().zip(next).map(|(a, b)| 0.5 * (a[0] * b[1] - b[0] * a[1])).sum();
        let scale = (self.area / area.abs().max(1e-3 * PI)).sqrt();
        let (s, c) = libm::sincos(self.angle.to_radians());
        let moved = |[x, y]: [f64; 2]| [at[0] + scale * (c * x - s * y), at[1] + scale * (s * x + c * y)];
        shape.into_iter().map(moved).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn drawn_outlines_have_the_area_and_the_raggedness_that_their_sketch_asks_for() {
        for index in 0..12 {
            let mut dice = Dice::from_seed(index);
            let wanted = Wanted::drawn(&mut dice);
            let outline = wanted.outline(&mut dice, [500.0, 400.0]);
            let found = raggedness(&outline).expect("an area");
            // The smoothest outlines are a little rounder than the waves alone would make them.
            assert!((found / wanted.raggedness - 1.0).abs() < 0.02, "{found} {}", wanted.raggedness);
        }
    }

    #[test]
    fn a_small_sketch_is_grown_and_measured() {
        let outcome = tried(3, 384).unwrap();
        // Round patches have no direction.
        let is_measured = |k: &usize| outcome.errors[*k].is_some_and(|error| error.abs() < 0.2);
        assert!(outcome.patches > 5 && [0, 1, 2, 4].iter().all(is_measured), "{:?}", outcome.errors);
    }
}
