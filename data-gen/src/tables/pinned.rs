//! How far drawn marks that are kept grow from their places.

use dapple::document::{Document, SystemChoice};
use dapple_engine::attributes::AttributeMap;
use dapple_engine::grid::Edges;
use dapple_engine::grid::resample::Spline;
use dapple_engine::marks::{Ellipse, Mark, Path};
use dapple_engine::measure::{self, StripeErrors};
use dapple_engine::rd::System;
use dapple_engine::synth::drawn::sketch_targets;
use dapple_engine::synth::marks::plan::{Surroundings, look_up};
use dapple_engine::synth::marks::report::pinned::distances;
use dapple_engine::synth::report::covered::covered;
use dapple_engine::synth::{Engine, GrownMarks, Measured, Training, Watch};

use super::{example, layers};
use crate::say;

/// Spots of 300 px² at 30°: their system, area ÷ spacing² and aspect.
#[derive(Clone, Copy)]
struct Spots {
    system: SystemChoice,
    packing: f64,
    aspect: f64,
}

const fn spots(system: SystemChoice, packing: f64, aspect: f64) -> Spots {
    Spots { system, packing, aspect }
}

const KINDS: [Spots; 7] = [
    spots(SystemChoice::Of(System::MEINHARDT_SPOTS.description()), 0.12, 0.95),
    spots(SystemChoice::Of(System::MEINHARDT_SPOTS.description()), 0.12, 0.5),
    spots(SystemChoice::Of(System::MEINHARDT_SPOTS.description()), 0.05, 0.8),
    spots(SystemChoice::Of(System::MEINHARDT_SPOTS.description()), 0.2, 0.8),
    spots(SystemChoice::Of(System::MEINHARDT_SPOTS.description()), 0.2, 0.5),
    spots(SystemChoice::Of(System::TURING_SPOTS.description()), 0.22, 0.9),
    spots(SystemChoice::Of(System::TURING_SPOTS.description()), 0.22, 0.5),
];

impl Spots {
    fn spacing(self) -> f64 {
        (300.0 / self.packing).sqrt()
    }

    fn mark(self, center: [f64; 2]) -> Mark {
        Mark::Ellipse(Ellipse::from_area(center, 300.0, self.aspect, 30.0))
    }

    /// Distances, in radii, of the grown `marks` from their places, on a canvas of 12 spacings.
    fn among(self, edges: Edges, marks: &[Mark]) -> Result<Vec<f64>, String> {
        let spacing = self.spacing();
        let drawn = [self.mark([200.0, 200.0]), self.mark([200.0 + spacing, 200.0])];
        let map = AttributeMap::from_marks(&drawn, [12.0 * spacing; 2], Some([1, 1]), edges)
            .map_err(|e| e.to_string())?;
        let training = Training::built_in();
        let lookup = look_up(training, self.system, &map).map_err(|e| e.to_string())?;
        let lookup = lookup.with_pinned(training, marks).map_err(|e| e.to_string())?.uncorrected();
        let begun = lookup.lay_out(Surroundings::default(), 1).map_err(|e| e.to_string())?.begin(1);
        let mut engine = Engine::new(&begun, 1);
        let plan = begun.plan;
        engine.settle(&Watch::NONE).map_err(|e| e.to_string())?;
        let size = (12.0 * spacing) as usize;
        let spots = measure::spots(&engine.pattern(&plan, size, size), 0.5);
        Ok(distances(plan.pinned_spots(), plan.lookup.map.layout(), &spots))
    }

    /// Nine pairs whose marks are `apart` spacings from each other, across or along the marks.
    fn pairs(self, apart: f64, across: bool) -> Vec<Mark> {
        let longer = if across { 1.0 / self.aspect } else { self.aspect };
        let (s, c) = (if across { 120.0f64 } else { 30.0 }).to_radians().sin_cos();
        let half = 0.5 * apart * self.spacing() / f64::sqrt(longer);
        let pair = |k: i32| {
            let [x, y] = [k % 3, k / 3].map(|v| (2.0 + 4.0 * f64::from(v)) * self.spacing());
            [-half, half].map(|h| self.mark([x + h * c, y + h * s]))
        };
        (0..9).flat_map(pair).collect()
    }

    /// Four marks that are `away` spacings from the left edge.
    fn at_edge(self, away: f64) -> Vec<Mark> {
        let mark = |k: i32| self.mark([away, 2.4 * f64::from(k)].map(|v| v * self.spacing()));
        (1..=4).map(mark).collect()
    }
}

/// Pairs at several distances, and marks at several distances from a closed edge.
pub fn pairs() -> Result<(), String> {
    for spots in KINDS {
        let what = format!("{} area/spacing² {} aspect {}", spots.system.name(), spots.packing, spots.aspect);
        for across in [false, true] {
            for apart in [0.5, 0.55, 0.6, 0.65, 0.7, 0.75, 0.8, 0.85, 0.9] {
                let off = spots.among(Edges::Wrap, &spots.pairs(apart, across))?;
                print(&format!("{what}, pairs {apart} spacings apart, across {across}"), off)?;
            }
        }
        for away in [0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4] {
            let off = spots.among(Edges::Closed, &spots.at_edge(away))?;
            print(&format!("{what}, {away} spacings from the edge"), off)?;
        }
    }
    Ok(())
}

fn print(what: &str, mut all: Vec<f64>) -> Result<(), String> {
    all.sort_by(f64::total_cmp);
    let n = all.len();
    if n == 0 {
        return say(&format!("{what}: none kept"));
    }
    let lost = all.iter().filter(|off| **off > 0.25).count();
    let [median, most, worst] = [all[n / 2], all[n * 9 / 10], all[n - 1]];
    say(&format!("{what}: kept {n}, off {lost}, median {median:.3}, 90 % {most:.3}, worst {worst:.2}"))
}

/// Drawn lines of the examples, kept and not: how many lie in stripes, and how far their directions are off.
pub fn lines() -> Result<(), String> {
    let names = [
        "line-stripes",
        "mackerel",
        "sand-ripples",
        "sloping-lines",
        "tiger",
        "tile-waves",
        "wood-grain",
        "zebra",
    ];
    for name in names {
        for keeps in [true, false] {
            let mut document = example(name)?;
            document.layers[0].options.keep = Some(keeps);
            let layer = layers(&document)?.remove(0);
            let shares = in_stripes(&document, &layer)?;
            let Measured::Stripes(errors) = &layer.measured else {
                return Err(format!("{name} has no lines"));
            };
            let good = shares.iter().filter(|share| **share >= 0.9).count();
            let least = shares.iter().copied().fold(1.0, f64::min);
            let mean = |value: &dyn Fn(&StripeErrors) -> Option<f64>| {
                errors.iter().filter_map(value).map(f64::abs).sum::<f64>() / errors.len() as f64
            };
            let (angle, rms) = (mean(&|error| error.angle), mean(&|error| error.angle_rms));
            let n = shares.len();
            say(&format!(
                "{name}, keep {keeps}: {good} of {n} in stripes, least {least:.2}; angle {angle:.2}°, rms {rms:.2}°"
            ))?;
        }
    }
    Ok(())
}

/// The share of each line of `document` that lies in a stripe of `layer`.
fn in_stripes(document: &Document, layer: &GrownMarks) -> Result<Vec<f64>, String> {
    let marks = sketch_targets::marks(document, 0, "document").map_err(|error| error.to_string())?;
    let [width, height] = document.size.map(|side| side as usize);
    let lines: Vec<Path> = marks.iter().filter_map(Mark::path).collect();
    let surface = Spline::new(&layer.pattern().field(width, height));
    let layout = layer.plan.lookup.map.layout();
    Ok(lines.iter().map(|line| covered(line, layout, &surface, |_| false).unwrap_or(0.0)).collect())
}
