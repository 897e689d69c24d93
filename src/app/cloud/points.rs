//! The examples as rows of numbers; lengths are scaled to the marks that are asked for, px.

use crate::attributes::{Attribute, Attributes};
use crate::learn::{InCells, Parameters};
use crate::rd::System;
use crate::synth::Training;
use crate::synth::marks::plan::exact_cell;
use crate::synth::report::RegionReport;

/// What can be plotted along an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Axis {
    /// An attribute of the marks.
    Attribute(Attribute),
    /// A parameter of the simulation, by name.
    Parameter(&'static str),
}

/// Quantities and titles of each kind of system, attributes first.
const SPOTS: [(Axis, &str); 10] = [
    (Axis::Attribute(Attribute::Area), "Area, px²"),
    (Axis::Attribute(Attribute::Density), "Area ÷ spacing²"),
    (Axis::Attribute(Attribute::Aspect), "Aspect"),
    (Axis::Attribute(Attribute::Angle), "Direction, °"),
    (Axis::Attribute(Attribute::Spacing), "Spacing, px"),
    (Axis::Parameter("rate"), "Rate, 1/cell²"),
    (Axis::Parameter("ratio"), "Ratio"),
    (Axis::Parameter("stretch"), "Stretch"),
    (Axis::Parameter("direction"), "Diffusion's direction, °"),
    (Axis::Parameter("level"), "Level"),
];
const STRIPES: [(Axis, &str); 5] = [
    (Axis::Attribute(Attribute::Width), "Width, px"),
    (Axis::Attribute(Attribute::Angle), "Direction, °"),
    (Axis::Parameter("rate"), "Rate, 1/cell²"),
    (Axis::Parameter("stretch"), "Stretch"),
    (Axis::Parameter("direction"), "Diffusion's direction, °"),
];
const LINES: [(Axis, &str); 7] = [
    (Axis::Attribute(Attribute::Width), "Width, px"),
    (Axis::Attribute(Attribute::Duty), "Width ÷ period"),
    (Axis::Attribute(Attribute::Angle), "Direction, °"),
    (Axis::Parameter("rate"), "Rate, 1/cell²"),
    (Axis::Parameter("ratio"), "Ratio"),
    (Axis::Parameter("stretch"), "Stretch"),
    (Axis::Parameter("direction"), "Diffusion's direction, °"),
];

/// The cloud: rows of numbers in the order of `names`.
#[derive(Clone, Debug)]
pub struct Points {
    /// The system of the examples.
    pub system: &'static str,
    /// Each quantity with its title.
    pub quantities: &'static [(Axis, &'static str)],
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
        let answer = set.ask(&InCells::from_px(lines, cell)).ok()?;
        let quantities: &'static [(Axis, &str)] = match (region.asked, answer.parameters.ratio) {
            (Attributes::Spots(_), _) => &SPOTS,
            (Attributes::Stripes(_), None) => &STRIPES,
            (Attributes::Stripes(_), Some(_)) => &LINES,
        };
        let row = |attributes: &Attributes, parameters: &Parameters| -> Vec<f64> {
            quantities.iter().map(|(axis, _)| value(*axis, attributes, parameters)).collect()
        };
        let scaled = |lines: &InCells<Attributes>, parameters: &Parameters| {
            row(&polarity.marks(&lines.in_px(cell)), parameters)
        };
        let near = set.neighbours(&answer.nearest);
        Some(Self {
            system: system.name(),
            quantities,
            second: usize::from(quantities.len() > 1),
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
    pub fn title(&self, axis: Axis) -> &'static str {
        self.quantities.iter().find(|(of, _)| *of == axis).map_or("", |(_, title)| title)
    }

    /// A quantity of a row; NaN where there is none.
    #[must_use]
    pub fn value(&self, row: &[f64], axis: Axis) -> f64 {
        let index = self.quantities.iter().position(|(of, _)| *of == axis);
        index.and_then(|index| row.get(index)).copied().unwrap_or(f64::NAN)
    }
}

fn value(axis: Axis, attributes: &Attributes, parameters: &Parameters) -> f64 {
    let found = match axis {
        Axis::Attribute(attribute) => attributes.get(attribute),
        Axis::Parameter(name) => {
            parameters.named().iter().find(|(of, _)| *of == name).map(|(_, value)| *value)
        }
    };
    found.unwrap_or(f64::NAN)
}

/// Whether a quantity is plotted on a logarithmic scale.
#[must_use]
pub fn is_logarithmic(axis: Axis) -> bool {
    match axis {
        Axis::Attribute(attribute) => !matches!(attribute, Attribute::Aspect | Attribute::Angle),
        Axis::Parameter(name) => matches!(name, "rate" | "ratio"),
    }
}
