//! The report of a growth on a model: what was asked, what was looked up, what has grown around each anchor.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::attributes::{Attribute, Attributes};
use crate::document::Document;
use crate::synth::body::anchors::Origin;
use crate::synth::body::direction_report::DirectionReport;
use crate::synth::body::got::{Got, of_anchors};
use crate::synth::body::grown::GrownBody;
use crate::synth::body::layer::BodyLayer;
use crate::synth::body::placed::Scale;
use crate::synth::body::refusals;
use crate::synth::points::report::other_share;
use crate::synth::report::PointsReport;

/// The report of a growth on a model. Serialised, it is the JSON of `grow --report`.
#[derive(Clone, Debug, Serialize)]
pub struct BodyReport {
    /// The name of the document's file.
    pub document: String,
    /// The model.
    pub model: ModelReport,
    /// The document's seed.
    pub seed: u64,
    /// Wall time of the growth and of writing its files.
    pub seconds: f64,
    /// Its layers, the lowest first.
    pub layers: Vec<BodyLayerReport>,
}

/// What was grown on.
#[derive(Clone, Debug, Serialize)]
pub struct ModelReport {
    /// Its name in the document.
    pub file: String,
    /// The longest side of its bounding box, px.
    pub px: f64,
    /// px² of its surface that is grown on.
    pub area: f64,
    /// What was mended before growing, in words.
    pub repairs: Vec<String>,
}

/// What has grown.
#[derive(Clone, Debug, Serialize)]
pub struct BodyLayerReport {
    /// The layer's name.
    pub name: String,
    /// The reaction-diffusion system.
    pub system: &'static str,
    /// px a cell: √(mean cell area).
    pub cell: f64,
    /// Vertices of the remeshed surface.
    pub vertices: usize,
    /// Steps taken.
    pub steps: u64,
    /// Whether the pattern settled within the step limit.
    pub settled: bool,
    /// Spots that were laid; none of stripes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub laid: Option<usize>,
    /// Spots that have grown; none of stripes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub spots: Option<usize>,
    /// A field of points; none of marks.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub points: Option<PointsReport>,
    /// One a pin or a mark on the model; one of the whole sketch where there are neither; none of a field of points.
    pub regions: Vec<AnchorReport>,
    /// Places, in the coordinates of the file, around which directions turn by half a turn or more: spots are round there.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub singularities: Vec<[f64; 3]>,
    /// What the user should know.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
}

/// What has grown around an anchor.
#[derive(Clone, Debug, Serialize)]
pub struct AnchorReport {
    /// Column and row of the region that a pin holds; [0, 0] of the whole sketch.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub region: Option<[u32; 2]>,
    /// The index of the pin.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pin: Option<usize>,
    /// The index of the mark on the model.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mark: Option<usize>,
    /// Whole spots that are nearest to it; none of stripes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub marks: Option<usize>,
    /// What was wanted there.
    pub asked: Attributes,
    /// Parameters of the simulation by name, in cells; and `cell`, px a cell.
    pub parameters: BTreeMap<&'static str, f64>,
    /// What the rows say that grows.
    pub predicted: Attributes,
    /// What has grown; none without whole spots, or without stripes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub got: Option<Attributes>,
    /// By how much it differs from what was wanted where it stands: shares of area, spacing, width and wavelength, differences of aspect
    /// and angle.
    pub error: BTreeMap<Attribute, f64>,
    /// How far directions are off; none where spots are round.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub direction: Option<DirectionReport>,
    /// The share by which the area or the width differed with the looked-up level.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub size_before_level: Option<f64>,
    /// What cannot be reached.
    pub notes: Vec<String>,
}

impl GrownBody {
    /// Its report; `document` is what messages call the document.
    #[must_use]
    pub fn report(&self, document: &str, seconds: f64) -> BodyReport {
        let body = self.document.model.as_ref();
        let model = ModelReport {
            file: body.map_or_else(String::new, |body| body.source.name().to_owned()),
            px: body.map_or(0.0, |body| body.px),
            area: self.placed.mesh.area(),
            repairs: self.placed.notes(),
        };
        let mut layers: Vec<BodyLayerReport> =
            self.layers.iter().map(|layer| layer.report(&self.document, &self.placed.scale)).collect();
        if let Some(first) = layers.first_mut() {
            first.notes.splice(0..0, refusals::notes(&self.document));
        }
        BodyReport { document: document.to_owned(), model, seed: self.document.seed, seconds, layers }
    }
}

impl BodyLayer {
    fn report(&self, document: &Document, scale: &Scale) -> BodyLayerReport {
        let counts = !self.plan.choice.system.is_striped() && self.points.is_none();
        let surface = self.plan.surface();
        let singularities: Vec<[f64; 3]> = self
            .plan
            .directions
            .iter()
            .flat_map(|field| &field.singularities)
            .map(|one| scale.to_file(surface.position(one.place)))
            .collect();
        let of_marks = if self.points.is_some() { Vec::new() } else { of_anchors(self) };
        let regions = of_marks.into_iter().enumerate();
        BodyLayerReport {
            name: document.layers[self.plan.layer].name.clone(),
            system: self.plan.choice.description().name,
            cell: surface.unit(),
            vertices: surface.mesh.positions.len(),
            steps: self.steps,
            settled: self.settled,
            laid: counts.then_some(self.laid),
            spots: counts.then(|| self.spots()),
            points: self.points.clone(),
            regions: regions.map(|(index, got)| self.anchor_report(index, got)).collect(),
            notes: self.notes(singularities.len()),
            singularities,
        }
    }

    fn notes(&self, singularities: usize) -> Vec<String> {
        let mut notes = self.plan.notes.clone();
        notes.extend(self.points.iter().filter_map(|points| other_share(&points.share, "surface")));
        notes.extend(self.plan.curves.iter().flat_map(|curves| curves.remarks.clone()));
        if singularities > 0 && self.plan.curves.is_none() && self.points.is_none() {
            let places = if singularities == 1 { "place" } else { "places" };
            let there =
                if self.plan.choice.system.is_striped() { "stripes fork or end" } else { "spots are round" };
            notes.push(format!(
                "directions turn round {singularities} {places} of the model, where {there}; \"strokes\" of the model move such places"
            ));
        }
        let lost = self.laid.saturating_sub(self.spots());
        if lost * 33 > self.laid {
            notes.push(format!("of {} spots that were laid {lost} have died or merged", self.laid));
        }
        notes
    }

    fn anchor_report(&self, index: usize, got: Got) -> AnchorReport {
        let (anchor, answer) = (&self.plan.anchors[index], &self.plan.answers[index]);
        let (region, pin, mark) = match anchor.origin {
            Origin::Sketch => (Some([0, 0]), None, None),
            Origin::Pin(pin, region) => (Some(region), Some(pin), None),
            Origin::Mark(mark) => (None, None, Some(mark)),
        };
        let mut notes: Vec<String> = answer.notes.iter().map(ToString::to_string).collect();
        if got.count == 0 {
            let what = if self.plan.choice.system.is_striped() { "stripe" } else { "whole spot" };
            notes.push(format!("no {what} grew here: nothing was measured"));
        }
        let before = &self.levelled.before[index];
        // Those of a pair vary from vertex to vertex, and are not looked up.
        let looked_up = self.plan.choice.pair.is_none().then(|| answer.parameters.named());
        let named = looked_up.into_iter().flatten().chain([("cell", self.plan.surface().unit())]);
        AnchorReport {
            region,
            pin,
            mark,
            marks: (!self.plan.choice.system.is_striped()).then_some(got.count),
            asked: anchor.wanted,
            parameters: named.collect(),
            predicted: answer.predicted,
            got: got.attributes,
            error: got.error,
            direction: got.direction,
            size_before_level: (before.count > 0).then(|| before.got / before.wanted - 1.0),
            notes,
        }
    }
}
