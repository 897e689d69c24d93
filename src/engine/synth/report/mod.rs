//! The report of a growth: what was asked, what was looked up and what has grown.
//!
//! [`regions`] lists one layer's regions; [`report`] collects all layers in the form that `grow --report` writes.

pub mod areas;
pub mod covered;
pub mod drawn;

pub mod pinned;
pub mod point_fields;
pub mod point_lines;
mod region;
pub mod stripe_along;
pub mod threads;
pub mod tone;

pub use areas::{WidthReport, area_regions, drawn_areas};
pub use drawn::{DrawnMark, drawn_marks, left_out};
pub use point_fields::{PointsReport, points_report};
pub use point_lines::{ShareReport, line_regions};
pub use region::{RaggednessReport, RegionReport, merged_spots, regions};
pub use threads::{ThreadReport, drawn_lines};
pub use tone::{GrowthReport, ToneReport, growth_report, tone_report};

use serde::Serialize;

use crate::attributes::Polarity;
use crate::document::Document;
use crate::synth::grow::layer::{Grown, GrownLayer, GrownMarks};
use crate::synth::grow::pairs::GrownPairs;
use crate::synth::plan::inside::is_replaced;

/// The report of a growth. Serialised, it is the JSON of `grow --report`.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// The name of the document's file.
    pub document: String,
    /// The canvas, px.
    pub size: [u32; 2],
    /// The document's seed.
    pub seed: u64,
    /// Wall time of the growth and of writing its pictures.
    pub seconds: f64,
    /// One a layer, the lowest first.
    pub layers: Vec<LayerReport>,
}

/// What has grown on one layer.
#[derive(Clone, Debug, Serialize)]
pub struct LayerReport {
    /// The layer's name.
    pub name: String,
    /// The reaction-diffusion system.
    pub system: &'static str,
    /// Whether its stripes are the gaps between the lines that grow, because they cover more than half.
    pub inverted: bool,
    /// px a cell.
    pub cell: f64,
    /// Cells along x and y.
    pub grid: [usize; 2],
    /// Steps taken.
    pub steps: u64,
    /// Whether the pattern settled within the step limit.
    pub settled: bool,
    /// One a region, row by row; empty of pairs.
    pub regions: Vec<RegionReport>,
    /// The lines between cells.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gap: Option<WidthReport>,
    /// The blotches of stucco.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub blotches: Option<WidthReport>,
    /// The share of the canvas that streaks or cracks cover.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub share: Option<ShareReport>,
    /// One a direction of a weave.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub threads: Vec<ThreadReport>,
    /// What the user should know of a weave; regions have notes of their own.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
    /// Its field of points.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub points: Option<PointsReport>,
    /// How near it is to the picture that drives it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tone: Option<ToneReport>,
    /// What Turing's growth has made.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub growth: Option<GrowthReport>,
    /// What became of each drawn mark; empty where none was to be among those that grow.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub drawn: Vec<DrawnMark>,
    /// `Some(false)` for a layer whose marks are replaced by those of the layer above; otherwise `None`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shown: Option<bool>,
}

/// The report of `grown`, the growth of `document`, whose file is named `source`.
#[must_use]
pub fn report(document: &Document, source: &str, grown: &Grown, seconds: f64) -> Report {
    let layers = grown.layers.iter().enumerate().take(document.layers.len()).map(|(index, layer)| {
        let shown = is_replaced(document, index).then_some(false);
        LayerReport { shown, ..layer_report(document, index, layer) }
    });
    Report {
        document: source.to_owned(),
        size: grown.size,
        seed: document.seed,
        seconds,
        layers: layers.collect(),
    }
}

/// What became of each drawn mark of a layer.
#[must_use]
pub fn drawn_of(layer: &GrownLayer) -> Vec<DrawnMark> {
    match layer {
        GrownLayer::Marks(layer) => drawn_of_marks(layer),
        GrownLayer::Pairs(layer) => drawn_lines(layer),
        GrownLayer::Areas(layer) => drawn_areas(layer),
        GrownLayer::Tone(_) | GrownLayer::Lines(_) | GrownLayer::Points(_) => Vec::new(),
    }
}

fn drawn_of_marks(layer: &GrownMarks) -> Vec<DrawnMark> {
    let [nx, ny] = layer.plan.lookup.grid.size;
    drawn_marks(layer, &|| layer.whole_pattern().field(nx, ny))
}

fn layer_report(document: &Document, index: usize, layer: &GrownLayer) -> LayerReport {
    let report = LayerReport {
        name: document.layers[index].name.clone(),
        system: layer.system().name,
        inverted: false,
        cell: layer.px_a_cell(),
        grid: layer.grid(),
        steps: layer.steps(),
        settled: layer.settled(),
        regions: Vec::new(),
        threads: Vec::new(),
        points: None,
        tone: None,
        growth: None,
        drawn: drawn_of(layer),
        notes: Vec::new(),
        shown: None,
        gap: None,
        blotches: None,
        share: None,
    };
    match layer {
        GrownLayer::Marks(marks) => LayerReport {
            inverted: marks.plan.lookup.polarity == Polarity::Negative,
            regions: regions(document, index, marks, &report.drawn),
            ..report
        },
        GrownLayer::Pairs(pairs) => LayerReport {
            threads: threads::threads(pairs),
            blotches: threads::blotches(pairs),
            notes: pair_notes(pairs, &report.drawn),
            ..report
        },
        GrownLayer::Areas(areas) => {
            LayerReport { regions: area_regions(areas, &report.drawn), gap: areas::gap(areas), ..report }
        }
        GrownLayer::Lines(lines) => {
            LayerReport { regions: line_regions(lines), share: Some(point_lines::share(lines)), ..report }
        }
        GrownLayer::Points(grown) => {
            LayerReport { points: Some(points_report(grown)), notes: point_fields::notes(grown), ..report }
        }
        GrownLayer::Tone(grown) => {
            let tone = document.layers[index].tone.as_ref();
            let tone = tone.and_then(|tone| tone_report(tone, grown));
            LayerReport { tone, growth: growth_report(grown), ..report }
        }
    }
}

/// What the user should know of what pairs have grown.
fn pair_notes(layer: &GrownPairs, drawn: &[DrawnMark]) -> Vec<String> {
    threads::notes(layer).into_iter().chain(drawn::note(drawn, Some("threads"))).collect()
}
