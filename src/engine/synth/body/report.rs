//! The report of a growth on a model: what was asked, what was looked up, what has grown around each anchor.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::attributes::{Attribute, Spots};
use crate::measure::surface_edges;
use crate::surface::SurfacePoint;
use crate::synth::body::anchors::Origin;
use crate::synth::body::grown::GrownBody;
use crate::synth::body::refusals::{self, system};

/// Below this aspect spots have a direction that is measured.
const DIRECTED: f64 = 0.85;
/// The coherence of directions above which a place is away from singularities. Not tuned.
const COHERENT: f64 = 0.98;

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
    /// Its only layer.
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
    /// Spots that were laid, and those that have grown.
    pub laid: usize,
    /// Spots that have grown.
    pub spots: usize,
    /// One a pin or a mark on the model; one of the whole sketch where there are neither.
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
    /// Whole spots that are nearest to it.
    pub marks: usize,
    /// What was wanted there.
    pub asked: Spots,
    /// Parameters of the simulation by name, in cells; and `cell`, px a cell.
    pub parameters: BTreeMap<&'static str, f64>,
    /// What the rows say that grows.
    pub predicted: crate::attributes::Attributes,
    /// What has grown; none without whole spots.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub got: Option<Spots>,
    /// By how much it differs from what was wanted where it stands: shares of area and spacing, differences of aspect and angle.
    pub error: BTreeMap<Attribute, f64>,
    /// How far the directions of single spots are off; none where they are round.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub direction: Option<DirectionReport>,
    /// The share by which the area differed with the looked-up level.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub area_before_level: Option<f64>,
    /// What cannot be reached.
    pub notes: Vec<String>,
}

/// How far the directions of single spots are off, degrees. Spots near singularities, where directions turn within a spot, do not
/// count.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct DirectionReport {
    /// Spots that count.
    pub spots: usize,
    /// The median of the deviations.
    pub median: f64,
    /// What 95 % of them do not exceed.
    pub p95: f64,
}

impl DirectionReport {
    fn new(mut deviations: Vec<f64>) -> Option<Self> {
        deviations.sort_by(f64::total_cmp);
        let at =
            |share: f64| deviations.get((share * (deviations.len() as f64 - 1.0)).round() as usize).copied();
        Some(Self { spots: deviations.len(), median: at(0.5)?, p95: at(0.95)? })
    }
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
        BodyReport {
            document: document.to_owned(),
            model,
            seed: self.document.seed,
            seconds,
            layers: vec![self.layer_report()],
        }
    }

    /// For each anchor the weighted mean length of the edges between neighbours whose middles are nearest to it, and of the spacings
    /// wanted there, px.
    fn spacings(&self) -> Vec<Option<[f64; 2]>> {
        let surface = self.plan.surface();
        let places: Vec<SurfacePoint> = self.levelled.measured.spots.iter().map(|spot| spot.place).collect();
        let mut sums = vec![[0.0; 3]; self.plan.anchors.len()];
        for edge in surface_edges(surface, &places) {
            let vertex = surface.vertex_of(edge.midpoint);
            let wanted = self.plan.wanted[vertex].spacing.unwrap_or(edge.length);
            let weight = edge.weight(wanted);
            let sum = &mut sums[self.plan.influence.nearest(vertex)];
            for (sum, value) in sum.iter_mut().zip([weight, weight * edge.length, weight * wanted]) {
                *sum += value;
            }
        }
        let mean = |[weight, got, wanted]: [f64; 3]| (weight > 0.0).then(|| [got / weight, wanted / weight]);
        sums.into_iter().map(mean).collect()
    }

    fn layer_report(&self) -> BodyLayerReport {
        let singularities: Vec<[f64; 3]> = self
            .plan
            .directions
            .iter()
            .flat_map(|field| &field.singularities)
            .map(|one| self.placed.scale.to_file(self.plan.surface().position(one.place)))
            .collect();
        let mut notes = refusals::notes(&self.document);
        if !singularities.is_empty() {
            let places = if singularities.len() == 1 { "place" } else { "places" };
            notes.push(format!(
                "directions turn round {} {places} of the model, where spots are round; \"strokes\" of the model move such places",
                singularities.len()
            ));
        }
        let lost = self.laid.saturating_sub(self.spots());
        if lost * 33 > self.laid {
            notes.push(format!("of {} spots that were laid {lost} have died or merged", self.laid));
        }
        BodyLayerReport {
            name: self.document.layers[0].name.clone(),
            system: system().description().name,
            cell: self.plan.surface().unit(),
            vertices: self.plan.surface().mesh.positions.len(),
            steps: self.steps,
            settled: self.settled,
            laid: self.laid,
            spots: self.spots(),
            regions: self
                .spacings()
                .into_iter()
                .enumerate()
                .map(|(index, spacing)| self.anchor_report(index, spacing))
                .collect(),
            singularities,
            notes,
        }
    }

    fn anchor_report(&self, index: usize, spacing: Option<[f64; 2]>) -> AnchorReport {
        let (anchor, answer) = (&self.plan.anchors[index], &self.plan.answers[index]);
        let (region, pin, mark) = match anchor.origin {
            Origin::Sketch => (Some([0, 0]), None, None),
            Origin::Pin(pin, region) => (Some(region), Some(pin), None),
            Origin::Mark(mark) => (None, None, Some(mark)),
        };
        let mut notes: Vec<String> = answer.notes.iter().map(ToString::to_string).collect();
        let got = Got::new(self, index, spacing);
        if got.count == 0 {
            notes.push("no whole spot grew here: nothing was measured".to_owned());
        }
        let asked = anchor.wanted;
        let before = &self.levelled.before[index];
        let named = answer.parameters.named().into_iter().chain([("cell", self.plan.surface().unit())]);
        AnchorReport {
            region,
            pin,
            mark,
            marks: got.count,
            asked,
            parameters: named.collect(),
            predicted: answer.predicted,
            got: (got.count > 0).then(|| got.spots(&asked)),
            error: got.error(),
            direction: DirectionReport::new(got.deviations.clone()),
            area_before_level: (before.count > 0).then(|| before.area / before.wanted - 1.0),
            notes,
        }
    }
}

/// Means over the whole spots that are nearest to an anchor.
#[derive(Default)]
struct Got {
    count: usize,
    area: f64,
    wanted_area: f64,
    aspect: f64,
    wanted_aspect: f64,
    /// Σ (1 − aspect)·(cos 2Δ, sin 2Δ) of the deviations of directed spots.
    turned: [f64; 2],
    /// Of directed spots away from singularities, degrees without a sign.
    deviations: Vec<f64>,
    /// Weighted mean of the lengths of edges, and of those wanted at their middles.
    spacing: Option<[f64; 2]>,
}

impl Got {
    fn new(grown: &GrownBody, index: usize, spacing: Option<[f64; 2]>) -> Self {
        let measured = &grown.levelled.measured;
        let mut got = Self { spacing, ..Self::default() };
        let of_anchor = measured.spots.iter().zip(&measured.anchor).filter(|(_, anchor)| **anchor == index);
        for (spot, _) in of_anchor.filter(|(spot, _)| spot.whole) {
            let wanted = &grown.plan.wanted[grown.plan.surface().vertex_of(spot.place)];
            let aspect = spot.radii[1] / spot.radii[0];
            got.count += 1;
            got.area += spot.area;
            got.wanted_area += wanted.area;
            got.aspect += aspect;
            got.wanted_aspect += wanted.aspect;
            if wanted.aspect < DIRECTED {
                let off = (spot.degrees - wanted.angle + 90.0).rem_euclid(180.0) - 90.0;
                let vertex = grown.plan.surface().vertex_of(spot.place);
                let coherence = grown.plan.directions.as_ref().map_or(1.0, |field| field.coherence[vertex]);
                if coherence > COHERENT {
                    got.deviations.push(off.abs());
                }
                let (sin, cos) = libm::sincos(2.0 * (spot.degrees - wanted.angle).to_radians());
                got.turned[0] += (1.0 - aspect) * cos;
                got.turned[1] += (1.0 - aspect) * sin;
            }
        }
        got
    }

    /// The mean deviation of directions, degrees; none where spots are round.
    fn angle(&self) -> Option<f64> {
        let [x, y] = self.turned;
        (x != 0.0 || y != 0.0).then(|| 0.5 * libm::atan2(y, x).to_degrees())
    }

    /// What has grown, for what was asked at the anchor.
    fn spots(&self, asked: &Spots) -> Spots {
        let count = self.count as f64;
        Spots {
            area: asked.area * self.area / self.wanted_area,
            aspect: asked.aspect + (self.aspect - self.wanted_aspect) / count,
            angle: crate::marks::axial(asked.angle + self.angle().unwrap_or(0.0)),
            spacing: self.spacing.and_then(|[got, wanted]| Some(asked.spacing? * got / wanted)),
        }
    }

    fn error(&self) -> BTreeMap<Attribute, f64> {
        if self.count == 0 {
            return BTreeMap::new();
        }
        let count = self.count as f64;
        let area = (Attribute::Area, self.area / self.wanted_area - 1.0);
        let aspect = (Attribute::Aspect, (self.aspect - self.wanted_aspect) / count);
        let spacing = self.spacing.map(|[got, wanted]| (Attribute::Spacing, got / wanted - 1.0));
        let angle = self.angle().map(|angle| (Attribute::Angle, angle));
        [Some(area), Some(aspect), spacing, angle].into_iter().flatten().collect()
    }
}
