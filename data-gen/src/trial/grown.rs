//! One document: grown, rounded to 16 bits like its pattern picture, measured.

use std::path::Path;
use std::time::Instant;

use dapple::document::Document;
use dapple_engine::attributes::Attributes;
use dapple_engine::grid::{Field, to_u16};
use dapple_engine::measure::{self, Regions, Spot, Target};
use dapple_engine::synth::drawn::sketch_targets;
use dapple_engine::synth::passes::Entry;
use dapple_engine::synth::{GrownLayer, Options, Training};

use super::attribute::{ATTRIBUTES, Errors};
use super::passes::PassArgs;
use super::pictures;
use super::verdict::{self, Failure};

/// A document to try.
pub struct Task {
    /// The name of the file without its ending, or that of the sketch.
    pub name: String,
    /// Whether it is a random sketch.
    pub random: bool,
    /// The document.
    pub document: Document,
}

/// The outcome of a document.
pub struct Outcome {
    /// The task's name.
    pub name: String,
    /// Whether it was a random sketch.
    pub random: bool,
    /// Whether spots or stripes were drawn.
    pub spots: bool,
    /// The system of each layer.
    pub systems: Vec<&'static str>,
    /// Whether all layers settled.
    pub settled: bool,
    /// The time of its growth on one thread, s.
    pub seconds: f64,
    /// What the passes over its layers did.
    pub passes: Vec<Entry>,
    /// What was measured, by region.
    pub regions: Vec<Region>,
    /// The failures.
    pub failures: Vec<Failure>,
}

/// What was measured in a region of a layer.
pub struct Region {
    /// Layer, 0 = the lowest.
    pub layer: usize,
    /// [column, row].
    pub place: [usize; 2],
    /// Whole marks (only for spots).
    pub marks: usize,
    /// The mean attributes asked for, at the places of the marks (or stripes).
    pub wanted: Option<Attributes>,
    /// The mean attributes of the marks (or stripes).
    pub got: Option<Attributes>,
    /// Errors by attribute.
    pub errors: Errors,
}

impl Task {
    /// Grows and measures the document, and writes pictures into `out`.
    ///
    /// # Errors
    /// A picture cannot be written. A document that does not grow is not an error, but an outcome.
    pub fn run(&self, training: &Training, passes: &PassArgs, out: Option<&Path>) -> Result<Outcome, String> {
        let mut outcome = Outcome {
            name: self.name.clone(),
            random: self.random,
            spots: true,
            systems: Vec::new(),
            settled: true,
            seconds: 0.0,
            passes: Vec::new(),
            regions: Vec::new(),
            failures: Vec::new(),
        };
        let started = Instant::now();
        let options = Options { source: &self.name, training, ..Options::default() };
        let (grown, entries) = passes.grow(&self.document, &options);
        outcome.passes = entries;
        outcome.seconds = started.elapsed().as_secs_f64();
        match grown {
            Err(error) => outcome.failures.push(Failure::NotGrown(error.to_string())),
            Ok(grown) => {
                let mut patterns = Vec::new();
                for (index, layer) in grown.layers.iter().enumerate() {
                    let pattern = written(layer, self.document.size);
                    outcome.measure(&self.document, index, layer, &pattern);
                    patterns.push(pattern);
                }
                if let Some(folder) = out {
                    pictures::write(folder, &self.name, &self.document, &patterns)?;
                }
            }
        }
        Ok(outcome)
    }
}

/// The pattern as read back from the written picture.
pub(super) fn written(layer: &GrownLayer, size: [u32; 2]) -> Field {
    let [width, height] = size.map(|side| side as usize);
    let mut pattern = layer.pattern().field(width, height);
    for value in &mut pattern.values {
        if value.is_finite() {
            *value = f32::from(to_u16(*value)) / 65535.0;
        }
    }
    pattern
}

impl Outcome {
    fn measure(&mut self, document: &Document, index: usize, layer: &GrownLayer, pattern: &Field) {
        self.systems.push(layer.system().name);
        self.settled &= layer.settled();
        let map = match sketch_targets::region_map(document, index, &self.name) {
            Ok(map) => map,
            Err(error) => {
                self.failures.push(Failure::NotGrown(error.to_string()));
                return;
            }
        };
        if let Some(failure) = verdict::of_any(pattern) {
            self.failures.push(failure);
            return;
        }
        let layout = *map.layout();
        let target = Target {
            bounds: layout.bounds(),
            regions: Regions::Grid(&layout),
            covered: &|_| false,
            wanted: &|point| map.at(point),
            surface: None,
        };
        self.spots = matches!(map.at([0.0, 0.0]), Attributes::Spots(_));
        let mut regions = if self.spots {
            let marks = measure::spots(pattern, 0.5);
            self.failures.extend(verdict::of_spots(&marks, &map));
            spots(&marks, &target)
        } else {
            self.failures.extend(verdict::of_stripes(pattern, &layout, map.mean_duty()));
            stripes(pattern, &target)
        };
        for (k, region) in regions.iter_mut().enumerate() {
            (region.layer, region.place) = (index, layout.place(k));
        }
        self.regions.append(&mut regions);
    }
}

fn spots(marks: &[Spot], target: &Target) -> Vec<Region> {
    let errors = measure::spot_errors(marks, target);
    let whole: Vec<Spot> = marks.iter().copied().filter(|mark| mark.whole).collect();
    let of_whole = measure::spot_errors(&whole, target);
    let regions = errors.iter().zip(of_whole).map(|(found, whole)| {
        let mut errors = [None; ATTRIBUTES.len()];
        let values = [found.area, found.spacing, whole.spacing, found.aspect, found.angle];
        errors[..values.len()].copy_from_slice(&values);
        let [wanted, got] = [found.wanted, found.got].map(|spots| spots.map(Attributes::Spots));
        Region { layer: 0, place: [0, 0], marks: found.marks, wanted, got, errors }
    });
    regions.collect()
}

fn stripes(pattern: &Field, target: &Target) -> Vec<Region> {
    let regions = measure::stripe_errors(pattern, 0.5, target).into_iter().map(|found| {
        let mut errors = [None; ATTRIBUTES.len()];
        let values = [found.width, found.angle, found.angle_rms];
        errors[ATTRIBUTES.len() - values.len()..].copy_from_slice(&values);
        let [wanted, got] = [found.wanted, found.got].map(|stripes| stripes.map(Attributes::Stripes));
        Region { layer: 0, place: [0, 0], marks: 0, wanted, got, errors }
    });
    regions.collect()
}
