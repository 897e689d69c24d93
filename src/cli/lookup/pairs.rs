//! The answer for a system of pairs, as text and as JSON, with the keys of other answers.

use serde_json::{Map, Value, json};
use std::fmt::Write;

use super::Args;
use super::answer::brief;
use super::sketch::{Direction, checked, directions, document, side};
use crate::attributes::{Attributes, Spots, Stripes};
use crate::cli::Error;
use crate::document::{Document, GapChoice, Layer, LayerOptions, PairKind, Stroke, SystemChoice};
use crate::learn::{Coverage, PairAnswer, PairSet};
use crate::rd::pairs::polygons;
use crate::synth::Training;
use crate::synth::areas::plan::polygons::{PolygonForm, USUAL};
use crate::synth::areas::plan::{AreaForm, AreaPlan};
use crate::synth::pairs::plan::{PairForm, PairPlan};
use crate::synth::report::NOTED;

/// Periods along the side of the canvas for which parameters are looked up.
const PERIODS: f64 = 16.0;
/// Cells along the side of the canvas.
const CELLS: f64 = 120.0;

/// A value by its name.
type Named = (String, f64);

/// A question and its answer. Lengths are px.
pub(super) struct PairReport {
    system: SystemChoice,
    asked: Vec<Named>,
    parameters: Vec<Named>,
    predicted: Vec<Named>,
    /// 90 % intervals of what is predicted.
    interval: Vec<(String, [f64; 2])>,
    inside: bool,
    notes: Vec<String>,
}

impl PairReport {
    /// The answer of the law and the rows for `wanted`.
    ///
    /// # Errors
    ///
    /// [`Error::Usage`] where directions are missing, or where an option belongs to another system; a training set that
    /// cannot be read.
    pub fn new(
        training: &Training,
        system: SystemChoice,
        wanted: &Attributes,
        args: &Args,
    ) -> Result<Self, Error> {
        refuse(system, args)?;
        match (system.pairs(), wanted) {
            (Some(kind), Attributes::Stripes(stripes)) => Self::of_lines(training, kind, *stripes, args),
            (_, Attributes::Spots(spots)) => Self::of_cells(training, *spots, args),
            (_, Attributes::Stripes(_)) => {
                Err(Error::Usage(format!("--system {}: it needs --area", system.name())))
            }
        }
    }

    fn of_lines(training: &Training, kind: PairKind, first: Stripes, args: &Args) -> Result<Self, Error> {
        let all = directions(kind, first, args)?;
        let widest = all.iter().map(|of| of.threads.period).fold(0.0, f64::max);
        let side = side("--width", "period", PERIODS, widest)?;
        let document = checked(document(kind, &all, side, args))?;
        let rows = training.pairs(kind.description()).map_err(Error::step)?;
        let plan = PairPlan::read(&document, 0, "the question", [side; 2], rows)?;
        let answers = rows.map(|rows| plan.answers(rows)).unwrap_or_default();
        let mut report = Self::empty(SystemChoice::Of(kind.description()), plan.notes.clone());
        for pair in 0..plan.threads.len() {
            // Each direction was drawn as two lines.
            let index = plan.threads[pair].lines.first().map_or(pair, |(line, _)| line / 2);
            let number = if all.len() > 1 { format!(" {}", index + 1) } else { String::new() };
            report.add(&plan, pair, (&all[index], &number), answers.get(pair));
        }
        report.asked.extend(args.long.map(|long| ("long".to_owned(), long)));
        report.asked.extend(args.decay.map(|decay| ("decay".to_owned(), decay)));
        match (kind, answers.first()) {
            (PairKind::Stucco, _) => {
                let decay = document.layers[0].options.decay;
                report.parameters.push(("decay".to_owned(), decay));
            }
            (PairKind::Maze, Some(answer)) => {
                report.parameters.extend(answer.values.get(1).map(|level| ("level".to_owned(), *level)));
            }
            _ => {}
        }
        report.parameters.push(("cell".to_owned(), plan.px_a_cell()));
        Ok(report.covered(&answers, rows))
    }

    /// Adds pair `pair` of `plan`, which was drawn as lines of the direction that has this number in names.
    fn add(
        &mut self,
        plan: &PairPlan,
        pair: usize,
        (drawn, number): (&Direction, &str),
        answer: Option<&PairAnswer>,
    ) {
        let name = |name: &str| format!("{name}{number}");
        let directed = plan.kind().description().directed;
        let Direction { angle, threads, asks_period } = drawn;
        let (width, got) = (plan.reached(&plan.threads[pair]), plan.threads[pair].mean());
        let period = got.width / got.duty();
        self.asked.push((name("width"), threads.width));
        self.parameters.push((name("size"), plan.usual_sizes()[pair]));
        if let PairForm::Weave(weave) = &plan.form {
            self.parameters.push((name("threshold"), weave.thresholds[pair]));
        }
        self.predict(name("width"), width, answer);
        if !directed {
            return;
        }
        if *asks_period {
            self.asked.push((name("period"), threads.period));
        } else {
            self.notes.push(format!("no {} given: {} px chosen", name("period"), brief(threads.period)));
        }
        self.asked.push((name("angle"), *angle));
        self.parameters.push((name("direction"), *angle));
        self.predicted.push((name("period"), period));
        let reached = [width / threads.width, period / threads.period];
        self.inside &= reached.iter().all(|reached| (reached - 1.0).abs() <= NOTED);
    }

    fn of_cells(training: &Training, wanted: Spots, args: &Args) -> Result<Self, Error> {
        let gap = args.gap.map_or(GapChoice::Drawn, GapChoice::Given);
        let distance = polygons::distance(wanted.area.sqrt(), args.gap.unwrap_or(USUAL * wanted.area.sqrt()));
        let side = side("--area", "distance of cells", CELLS.sqrt(), distance)?;
        let major = (wanted.area / std::f64::consts::PI / wanted.aspect).sqrt();
        let cell = Stroke::ellipse([0.5 * side; 2], [major, wanted.aspect * major], wanted.angle);
        let system = args.system.unwrap_or_default();
        let options = LayerOptions { gap, keep: Some(false), ..LayerOptions::default() };
        let layer = Layer::new(vec![cell]).with_system(system).with_options(options);
        let document = checked(Document::new([side.round() as u32; 2]).with_layer(layer))?;
        let rows = training.pairs(&polygons::POLYGONS).map_err(Error::step)?;
        let plan = AreaPlan::read(&document, 0, "the question", [side; 2], rows)?;
        let AreaForm::Polygons(form) = &plan.form else {
            return Err(Error::Usage("--system: no cells".to_owned()));
        };
        let at = plan.wanted([0.5 * side; 2]);
        let answer = rows.map(|rows| rows.ask(1, &[wanted.area.sqrt() / form.gap, wanted.aspect]));
        let mut report = Self::empty(system, plan.notes.clone());
        report.asked = [("area", wanted.area), ("aspect", wanted.aspect), ("angle", wanted.angle)]
            .map(|(name, value)| (name.to_owned(), value))
            .into();
        report.asked.extend(args.gap.map(|gap| ("gap".to_owned(), gap)));
        let parameters = [
            ("size", form.size(&at)),
            ("distance", PolygonForm::distance_of(&at)),
            ("cell", plan.px_a_cell()),
        ];
        report.parameters = parameters.map(|(name, value)| (name.to_owned(), value)).into();
        report.predicted.push(("area".to_owned(), wanted.area));
        report.predict("gap".to_owned(), form.gap, answer.as_ref());
        Ok(report.covered(answer.as_slice(), rows))
    }

    fn empty(system: SystemChoice, notes: Vec<String>) -> Self {
        let (asked, parameters, predicted) = (Vec::new(), Vec::new(), Vec::new());
        Self { system, asked, parameters, predicted, interval: Vec::new(), inside: true, notes }
    }

    /// Lengths are as uncertain as the size of their pair.
    fn predict(&mut self, name: String, value: f64, answer: Option<&PairAnswer>) {
        if let Some(within) = answer.and_then(|answer| answer.within.first()) {
            self.interval.push((name.clone(), [value * libm::exp(-within), value * libm::exp(*within)]));
        }
        self.predicted.push((name, value));
    }

    fn covered(mut self, answers: &[PairAnswer], rows: Option<&PairSet>) -> Self {
        let known = answers.iter().all(|answer| answer.inside);
        self.inside &= known;
        match rows {
            None => self.notes.push("by the law alone, without training rows".to_owned()),
            Some(rows) if !known => {
                let asked = rows.asked().collect::<Vec<_>>().join(", ");
                self.notes.push(format!(
                    "outside the training rows in one of {asked}: the values at the end of the rows are used"
                ));
            }
            Some(_) => {}
        }
        self
    }

    fn coverage(&self) -> Coverage {
        if self.inside { Coverage::Inside } else { Coverage::Outside }
    }

    /// The JSON of `lookup --json`.
    pub fn json(&self) -> Value {
        let object = |named: &[Named]| -> Map<String, Value> {
            named.iter().map(|(name, value)| (name.clone(), json!(value))).collect()
        };
        let interval: Map<String, Value> =
            self.interval.iter().map(|(name, range)| (name.clone(), json!(range))).collect();
        json!({
            "system": self.system.name(),
            "asked": object(&self.asked),
            "parameters": object(&self.parameters),
            "inverted": false,
            "predicted": object(&self.predicted),
            "interval": interval,
            "coverage": self.coverage().to_string(),
            "nearest": object(&self.predicted),
            "notes": self.notes,
        })
    }

    /// The answer as text.
    pub fn text(&self) -> String {
        let range = |name: &str| {
            let found = self.interval.iter().find(|(of, _)| of == name);
            found.map_or_else(String::new, |(_, [low, high])| {
                format!(" ({} to {})", brief(*low), brief(*high))
            })
        };
        let list = |named: &[Named], ranged: bool| {
            let words = named.iter().map(|(name, value)| {
                let range = if ranged { range(name) } else { String::new() };
                format!("{name} {}{range}", brief(*value))
            });
            words.collect::<Vec<_>>().join("  ")
        };
        let mut text = String::new();
        // Writing to a String cannot fail.
        let _ = writeln!(text, "system:     {}", self.system.name());
        let _ = writeln!(text, "asked:      {}", list(&self.asked, false));
        let _ = writeln!(text, "parameters: {}", list(&self.parameters, false));
        let _ = writeln!(text, "predicted:  {}", list(&self.predicted, true));
        let _ = writeln!(text, "coverage:   {}", self.coverage());
        for note in &self.notes {
            let _ = writeln!(text, "note:       {note}");
        }
        text
    }
}

/// # Errors
/// [`Error::Usage`] where an option is of another system.
fn refuse(system: SystemChoice, args: &Args) -> Result<(), Error> {
    let is = |kind| system.pairs() == Some(kind);
    let crosses = is(PairKind::Weave) || is(PairKind::Maze);
    let given = [
        ("--across", !args.across.is_empty() && !crosses, "with weave and maze"),
        ("--long", args.long.is_some() && !is(PairKind::Maze), "with maze"),
        ("--decay", args.decay.is_some() && !is(PairKind::Stucco), "with stucco"),
        ("--duty", args.duty.is_some() && is(PairKind::Stucco), "with all lines"),
        ("--raggedness", args.raggedness.is_some(), "with patches"),
        (
            "--spacing",
            args.spacing.is_some(),
            "with spots; that of cells follows from their area and the gap",
        ),
    ];
    if let Some((key, _, allowed)) = given.iter().find(|(_, given, _)| *given) {
        return Err(Error::Usage(format!("{key}: {} has none; allowed: {allowed}", system.name())));
    }
    let found = args.across.len();
    if crosses && !(1..=4).contains(&found) {
        let name = system.name();
        return Err(Error::Usage(format!(
            "--across: given {found} times; allowed: one to four times, with {name}"
        )));
    }
    Ok(())
}
