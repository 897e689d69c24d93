//! One sketch: grown, measured, written.

use std::io::Write;
use std::path::Path;

use dapple::document::{Document, SpreadChoice};
use dapple::files::{self, WriteFile};
use dapple_engine::attributes::Spread as Numbers;
use dapple_engine::export::ExportError;
use dapple_engine::export::png::rgb8;
use dapple_engine::synth::layer_report::report;
use dapple_engine::synth::passes::Entry;
use dapple_engine::synth::render::painting::Painting;
use dapple_engine::synth::{Grown, Growth, Options, Training};
use serde_json::Value;

use super::drawing::{Drawing, drawn};
use super::shapes::{FINE, Shapes};
use super::{Kind, Spread, named, paths, spots};
use crate::cpu::Stopwatch;
use crate::trial::passes::PassArgs;

/// A sketch to try.
pub struct Task {
    /// What kind it is.
    pub kind: Kind,
    /// The document.
    pub name: String,
    /// What is drawn.
    pub document: Document,
}

/// The result of a sketch.
#[derive(Default)]
pub struct Attempt {
    /// Its name.
    pub name: String,
    /// The failures of the whole sketch.
    pub failures: Vec<String>,
    /// CPU time of the growth that was measured, s.
    pub seconds: f64,
    /// What the passes over its layer did.
    pub passes: Vec<Entry>,
    /// CPU time with the default spread ÷ that without spread.
    pub slower: Option<f64>,
    /// Its ellipses.
    pub spots: Vec<spots::Spot>,
    /// Its strokes.
    pub strokes: Vec<paths::Stroke>,
    /// For each ellipse, whether the report says that it is there; `None` where the report does not list them.
    pub reported: Option<Vec<bool>>,
    /// The number of grown shapes that are two in one, and the number of all shapes.
    pub double: [usize; 2],
    /// The drawing beside the texture; `None` where nothing grew or nothing is written.
    pub drawing: Option<Drawing>,
}

/// A share of ink, or of ground, below this counts as none.
const LEAST: f64 = 0.002;
/// A shape that fills less than this share of its ellipse is two in one.
const DOUBLE: f64 = 0.93;
/// The largest allowed share of the area that is in shapes that are two in one.
const DOUBLES: f64 = 0.05;

impl Task {
    /// Grows, measures and, if there is a folder, writes.
    ///
    /// # Errors
    /// A file cannot be written. A sketch that does not grow is a result.
    pub fn run(
        &self,
        spread: Spread,
        training: &Training,
        passes: &PassArgs,
        out: Option<&Path>,
    ) -> Result<Attempt, String> {
        let mut attempt = Attempt { name: self.name.clone(), ..Attempt::default() };
        let options = Options { source: &self.name, training, ..Options::default() };
        let even = self.without_spread();
        let measured = if spread == Spread::Zero { &even } else { &self.document };
        let clock = Stopwatch::start();
        let (grown, entries) = passes.grow(measured, &options);
        attempt.seconds = clock.seconds();
        attempt.passes = entries;
        if spread == Spread::Both && !self.kind.is_striped() && grown.is_ok() {
            let clock = Stopwatch::start();
            attempt.slower =
                Growth::begin(&even, &options, None).run().is_ok().then(|| attempt.seconds / clock.seconds());
        }
        if let Some(folder) = out {
            let path = folder.join(format!("{}.dapple", self.name));
            measured.write(path).map_err(|error| error.to_string())?;
        }
        match grown {
            Err(error) => attempt.failures.push(format!("not grown: {error}")),
            Ok(grown) => {
                let report = report(measured, &self.name, &grown, attempt.seconds);
                let report = serde_json::to_value(report).map_err(|error| error.to_string())?;
                attempt.measure(measured, &grown, &report);
                if let Some(folder) = out {
                    attempt.drawing = Some(Drawing::new(measured, &grown, &attempt.spots, &attempt.strokes));
                    files(folder, &self.name, measured, &grown, &report)?;
                }
            }
        }
        if out.is_some() && attempt.drawing.is_none() {
            attempt.drawing = Some(Drawing::without_texture(measured));
        }
        Ok(attempt)
    }

    fn without_spread(&self) -> Document {
        let mut document = self.document.clone();
        for layer in &mut document.layers {
            layer.options.spread = SpreadChoice::Given(Numbers::ZERO);
        }
        document
    }
}

impl Attempt {
    fn measure(&mut self, document: &Document, grown: &Grown, report: &Value) {
        let size = document.size.map(|side| side as usize * FINE);
        let shapes = Shapes::find(grown.layers[0].pattern().field(size[0], size[1]));
        let (ellipses, strokes) = drawn(document);
        let canvas = document.size.map(f64::from);
        self.spots = spots::compare(&ellipses, &shapes, canvas);
        self.strokes = paths::compare(&strokes, &shapes);
        self.reported = named::there(report, 0, ellipses.len());
        self.failures.extend(whole(&shapes));
        if !ellipses.is_empty() {
            let merged = spots::merged(&ellipses, &shapes);
            if merged > 0 {
                self.failures.push(format!("merged: {merged} pairs of drawn marks are one"));
            }
            self.count_double(&shapes);
        }
    }

    fn count_double(&mut self, shapes: &Shapes) {
        let double: Vec<_> = shapes.all.iter().filter(|shape| !shape.cut && shape.fill < DOUBLE).collect();
        self.double = [double.len(), shapes.all.len()];
        let area: f64 = double.iter().map(|shape| shape.ellipse.area()).sum();
        let all: f64 = shapes.all.iter().map(|shape| shape.ellipse.area()).sum();
        if area > DOUBLES * all {
            self.failures.push(format!("merged: {:.0} % of the area is in marks of two", 100.0 * area / all));
        }
    }
}

/// The failure of the pattern as a whole, if there is one.
fn whole(shapes: &Shapes) -> Option<String> {
    if shapes.share < LEAST {
        return Some(format!("blank: {:.2} % is ink", 100.0 * shapes.share));
    }
    let ground = 1.0 - shapes.share;
    (ground < LEAST).then(|| format!("solid: {:.2} % is ground", 100.0 * ground))
}

/// Writes the texture and the report.
fn files(
    folder: &Path,
    name: &str,
    document: &Document,
    grown: &Grown,
    report: &Value,
) -> Result<(), String> {
    let failed = |error: ExportError| error.to_string();
    let size = grown.size.map(|side| side as usize);
    let rgb = Painting::sized(document, grown, size).rgb();
    let path = folder.join(format!("{name}.png"));
    files::save(&path, |out| rgb8(out, size, Some(document.dpi), &rgb)).map_err(failed)?;
    let text = format!("{report:#}\n");
    let path = folder.join(format!("{name}.report.json"));
    files::save(&path, |out| Ok(out.write_all(text.as_bytes())?)).map_err(failed)
}
