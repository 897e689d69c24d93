//! The examples as rows of numbers; lengths are scaled to the marks that are asked for, px.

use crate::attributes::Attributes;
use crate::learn::Parameters;
use crate::rd::System;
use crate::synth::Training;
use crate::synth::marks::plan::exact_cell;
use crate::synth::report::RegionReport;

/// Names and titles of the quantities of each kind of system, attributes first.
const SPOTS: [(&str, &str); 10] = [
    ("area", "Area, px²"),
    ("packing", "Area ÷ spacing²"),
    ("aspect", "Aspect"),
    ("angle", "Direction, °"),
    ("spacing", "Spacing, px"),
    ("rate", "Rate, 1/cell²"),
    ("ratio", "Ratio"),
    ("stretch", "Stretch"),
    ("direction", "Diffusion's direction, °"),
    ("level", "Level"),
];
const STRIPES: [(&str, &str); 5] = [
    ("width", "Width, px"),
    ("angle", "Direction, °"),
    ("rate", "Rate, 1/cell²"),
    ("stretch", "Stretch"),
    ("direction", "Diffusion's direction, °"),
];
const LINES: [(&str, &str); 7] = [
    ("width", "Width, px"),
    ("duty", "Width ÷ period"),
    ("angle", "Direction, °"),
    ("rate", "Rate, 1/cell²"),
    ("ratio", "Ratio"),
    ("stretch", "Stretch"),
    ("direction", "Diffusion's direction, °"),
];

/// The cloud: rows of numbers in the order of `names`.
#[derive(Clone, Debug)]
pub struct Points {
    /// The system of the examples.
    pub system: &'static str,
    /// Name and title of each quantity.
    pub names: &'static [(&'static str, &'static str)],
    /// Index of the quantity along y by default.
    pub second: usize,
    /// The examples.
    pub rows: Vec<Vec<f64>>,
    /// The examples from which the parameters were interpolated, mirrored as they were used, and their weights, 0..1.
    pub neighbours: Vec<(Vec<f64>, f64)>,
    /// What was asked for, with the parameters that were found.
    pub asked: Vec<f64>,
    /// The nearest that can be reached, with the same parameters; equal to `asked` where that can be reached.
    pub nearest: Vec<f64>,
    /// What has grown, with the same parameters; `None` where nothing was measured.
    pub got: Option<Vec<f64>>,
}

impl Points {
    /// The points for a region that was grown with `system`; `None` where there are no examples of it.
    #[must_use]
    pub fn for_region(training: &Training, system: System, region: &RegionReport) -> Option<Self> {
        let set = training.set(system).ok()?;
        let grid = region.parameters.iter().find(|(name, _)| *name == "cell")?.1;
        let polarity = region.polarity;
        let lines = polarity.lines(&region.asked);
        let cell = exact_cell(system, &lines, grid);
        let answer = set.ask(&lines.scaled(1.0 / cell)).ok()?;
        let names: &'static [(&str, &str)] = match (region.asked, answer.parameters.ratio) {
            (Attributes::Spots(_), _) => &SPOTS,
            (Attributes::Stripes(_), None) => &STRIPES,
            (Attributes::Stripes(_), Some(_)) => &LINES,
        };
        let row = |attributes: &Attributes, parameters: &Parameters| -> Vec<f64> {
            names.iter().map(|(name, _)| value(name, attributes, parameters)).collect()
        };
        let scaled = |lines: &Attributes, parameters: &Parameters| {
            row(&polarity.marks(&lines.scaled(cell)), parameters)
        };
        let near = set.neighbours(&answer.nearest);
        Some(Self {
            system: system.name(),
            names,
            second: usize::from(names.len() > 1),
            rows: set.rows().iter().map(|known| scaled(&known.attributes, &known.parameters)).collect(),
            neighbours: near
                .iter()
                .map(|near| (scaled(&near.attributes, &near.parameters), near.weight))
                .collect(),
            asked: row(&region.asked, &answer.parameters),
            nearest: scaled(&answer.nearest, &answer.parameters),
            got: region.got.map(|got| row(&got, &answer.parameters)),
        })
    }

    /// The title of a quantity.
    #[must_use]
    pub fn title(&self, name: &str) -> &'static str {
        self.names.iter().find(|(of, _)| *of == name).map_or("", |(_, title)| title)
    }

    /// A quantity of a row; NaN where there is none.
    #[must_use]
    pub fn value(&self, row: &[f64], name: &str) -> f64 {
        let index = self.names.iter().position(|(of, _)| *of == name);
        index.and_then(|index| row.get(index)).copied().unwrap_or(f64::NAN)
    }
}

fn value(name: &str, attributes: &Attributes, parameters: &Parameters) -> f64 {
    match (name, attributes) {
        ("area", Attributes::Spots(spots)) => spots.area,
        ("aspect", Attributes::Spots(spots)) => spots.aspect,
        ("spacing", Attributes::Spots(spots)) => spots.spacing.unwrap_or(f64::NAN),
        ("packing", Attributes::Spots(spots)) => {
            spots.spacing.map_or(f64::NAN, |spacing| spots.area / (spacing * spacing))
        }
        ("width", Attributes::Stripes(stripes)) => stripes.width,
        ("duty", Attributes::Stripes(stripes)) => stripes.duty(),
        ("angle", attributes) => attributes.angle(),
        (name, _) => {
            let named = parameters.named();
            named.iter().find(|(of, _)| *of == name).map_or(f64::NAN, |(_, value)| *value)
        }
    }
}

/// Whether a quantity is plotted on a logarithmic scale.
#[must_use]
pub fn is_logarithmic(name: &str) -> bool {
    matches!(name, "area" | "packing" | "spacing" | "width" | "duty" | "rate" | "ratio")
}
