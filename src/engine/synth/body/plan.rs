//! The plan of a growth on a model: the remeshed surface, and the parameters of each vertex.

use rayon::prelude::*;

use crate::attributes::{Attributes, Spots};
use crate::document::{Body, Document};
use crate::learn::Answer;
use crate::rd::{ParameterField, Parameters, fineness, selling::MIN_STRETCH};
use crate::surface::{Directions, Surface, SurfacePoint, directions};
use crate::synth::body::anchors::{Anchor, Asked, Origin, anchors};
use crate::synth::body::placed::Placed;
use crate::synth::body::refusals::system;
use crate::synth::body::wanted::{Influence, wanted};
use crate::synth::error::LayerError;
use crate::synth::marks::plan::Answers;
use crate::synth::training::Training;

/// Vertices a spacing: the distance that the system keeps by itself ÷ √(mean cell area), where the pattern is finest. Spots are
/// then corrected for the fineness of the mesh by [`crate::rd::fineness`].
const FINENESS: f64 = 12.0;
/// From this aspect on spots are so round that their directions do not matter.
const ROUND: f64 = 0.97;
/// The weight of the axis `along` in the field of directions, against 1 of strokes and pins: they reach about 30 cells far.
const ALONG: f64 = 0.001;
/// Vertices that a round spot covers at least, and one of a stretch below ½: from there on two patches differ by at most half a per
/// cent (`training/README.md`).
const COVERED: [f64; 2] = [14.0, 18.0];

/// What is grown on a model.
pub struct BodyPlan {
    /// The surface, px, and the parameters of each vertex, in cells.
    pub maps: ParameterField<Surface>,
    /// What is wanted around which places.
    pub anchors: Vec<Anchor>,
    /// Their weights at each vertex.
    pub influence: Influence,
    /// What is wanted at each vertex, the angle in its frame.
    pub wanted: Vec<Spots>,
    /// Where +x of the sketch points; `None` where spots are round.
    pub directions: Option<Directions>,
    /// What was looked up for each anchor: lengths in px, parameters in cells.
    pub answers: Vec<Answer>,
    /// The share of the local peak that is the edge of a spot, by vertex.
    pub levels: Vec<f32>,
}

/// Cells, px, of the flat grids for which questions are asked: those on which such spots are grown on a canvas, where rows are
/// dense.
fn flat_cell(spots: &Spots) -> f64 {
    (spots.area / system().definition().resolution.planned.asked_distance).sqrt()
}

/// Looks up spots on a flat grid of their own; the rate is that of cells of `cell` px.
fn asked_on(training: &Training, spots: &Spots, cell: f64) -> Result<Answer, LayerError> {
    let fine = flat_cell(spots);
    let mut answer = Answers::new(training).ask(system(), &Attributes::Spots(*spots), fine)?.predict();
    answer.parameters.rate *= (cell / fine) * (cell / fine);
    Ok(answer)
}

/// px a cell that suits what is asked for.
///
/// # Errors
/// The training set cannot be read.
pub fn cell(all: &Asked, training: &Training) -> Result<f64, LayerError> {
    let mut finest = f64::INFINITY;
    for spots in all.all() {
        // On cells of 1 px the parameters say how many cells the system keeps spots apart by itself, and a spot covers.
        let own = Parameters { pitch: 1.0, ..parameters(&asked_on(training, spots, 1.0)?, 0.0) };
        let covered = COVERED[usize::from(own.stretch < 0.5)];
        finest = finest.min(system().spacing(&own) / FINENESS).min((system().cells(&own) / covered).sqrt());
    }
    Ok(finest)
}

/// The parameters of an answer, with another direction.
fn parameters(answer: &Answer, direction: f64) -> Parameters {
    let of = &answer.parameters;
    Parameters {
        rate: of.rate as f32,
        ratio: of.ratio.unwrap_or(1.0) as f32,
        stretch: of.stretch as f32,
        direction: direction as f32,
        pitch: answer.pitch as f32,
    }
}

impl BodyPlan {
    /// Plans what a document asks for on a surface.
    ///
    /// # Errors
    /// The training set cannot be read.
    pub fn new(
        document: &Document,
        body: &Body,
        asked: &Asked,
        placed: &Placed,
        surface: Surface,
        training: &Training,
    ) -> Result<Self, LayerError> {
        let anchors = anchors(asked, document, body, &surface, &placed.scale);
        let vertices = surface.mesh.positions.len();
        let has_directions = anchors.iter().any(|anchor| anchor.wanted.aspect < ROUND);
        let directions = has_directions.then(|| directions(&surface, &given(body, &surface, placed), ALONG));
        let anchors = in_the_field(anchors, directions.as_ref(), &surface);
        let influence = Influence::new(&surface, &anchors);
        let mut wanted = wanted(&anchors, &influence, vertices);
        if let Some(field) = &directions {
            for (vertex, spots) in wanted.iter_mut().enumerate() {
                spots.angle = crate::marks::axial(spots.angle + field.degrees[vertex]);
                // Directions turn about singularities: there spots are round.
                spots.aspect = libm::pow(spots.aspect, field.coherence[vertex]);
            }
        }
        let cell = surface.unit();
        let answer = |spots: &Spots| asked_on(training, spots, cell);
        let answers =
            anchors.par_iter().map(|anchor| answer(&anchor.wanted)).collect::<Result<Vec<_>, _>>()?;
        let lattice = Lattice::new(&wanted, cell, &answer)?;
        let of_vertices: Vec<(Parameters, f32)> = wanted.par_iter().map(|spots| lattice.at(spots)).collect();
        let (parameters, levels) = of_vertices.into_iter().unzip();
        Ok(Self {
            maps: ParameterField::new(surface, parameters),
            anchors,
            influence,
            wanted,
            directions,
            answers,
            levels,
        })
    }

    /// The surface, px.
    #[must_use]
    pub fn surface(&self) -> &Surface {
        &self.maps.domain
    }
}

/// A place, a direction in its frame, degrees, and its weight.
type Given = (SurfacePoint, f64, f64);

/// The directions that strokes and pins give: +x of the sketch.
fn given(body: &Body, surface: &Surface, placed: &Placed) -> Vec<Given> {
    let mut given: Vec<Given> = Vec::new();
    for pin in &body.pins {
        if let Some(toward) = pin.toward {
            let place = surface.closest(placed.scale.to_px(pin.at));
            given.extend(degrees(surface, place, toward).map(|degrees| (place, degrees, 1.0)));
        }
    }
    for stroke in &body.strokes {
        for [from, to] in stroke.array_windows() {
            let [a, b] = [from, to].map(|at| placed.scale.to_px(*at));
            given.extend(along_segment(surface, a, b));
        }
    }
    given
}

/// The direction of a vector at a place, degrees in its frame; `None` where it has no part in the tangent plane.
pub fn degrees(surface: &Surface, place: SurfacePoint, vector: [f64; 3]) -> Option<f64> {
    let frame = surface.frame(surface.vertex_of(place));
    let [x, y] = frame.map(|axis| (0..3).map(|i| axis[i] * vector[i]).sum::<f64>());
    let length = vector.iter().map(|part| part * part).sum::<f64>().sqrt();
    (x.abs().max(y.abs()) > 1e-6 * length).then(|| libm::atan2(y, x).to_degrees())
}

/// Places along a segment, about two cells apart, with its direction.
fn along_segment(surface: &Surface, from: [f64; 3], to: [f64; 3]) -> Vec<Given> {
    let way: [f64; 3] = std::array::from_fn(|i| to[i] - from[i]);
    let length = way.iter().map(|part| part * part).sum::<f64>().sqrt();
    let count = (length / (2.0 * surface.unit())).ceil().clamp(1.0, 1_000.0) as usize;
    let at = |k: usize| {
        let share = (k as f64 + 0.5) / count as f64;
        let place = surface.closest(std::array::from_fn(|i| from[i] + share * way[i]));
        Some((place, degrees(surface, place, way)?, 1.0))
    };
    (0..count).filter_map(at).collect()
}

/// Anchors whose angles all count from +x of the sketch: those of marks on the model counted from the axis of the model.
fn in_the_field(mut anchors: Vec<Anchor>, field: Option<&Directions>, surface: &Surface) -> Vec<Anchor> {
    let Some(field) = field else { return anchors };
    for anchor in anchors.iter_mut().filter(|anchor| matches!(anchor.origin, Origin::Mark(_))) {
        let vertex = surface.vertex_of(anchor.place);
        anchor.wanted.angle = crate::marks::axial(anchor.wanted.angle - field.degrees[vertex]);
    }
    anchors
}

/// Answers for all that is wanted on a surface. By the laws of scale only area ÷ spacing² and the aspect need rows of their own.
struct Lattice {
    /// Nodes along ln(area ÷ spacing²), and along the aspect.
    axes: [Axis; 2],
    /// By aspect, then density.
    nodes: Vec<Node>,
}

/// The answer at a node. On p cells a spacing area and aspect differ by factors 1 + k ÷ p².
struct Node {
    /// ln(rate · area).
    rate: f64,
    /// ln ratio.
    ratio: f64,
    /// ln stretch.
    stretch: f64,
    /// ln pitch.
    pitch: f64,
    level: f64,
    /// k of the area.
    area_by_cells: f64,
    /// k of the aspect.
    aspect_by_cells: f64,
}

/// Nodes at even distances.
#[derive(Clone, Copy)]
struct Axis {
    first: f64,
    step: f64,
    count: usize,
}

impl Axis {
    /// From the lowest of some values to the highest, at most `step` apart.
    fn over(values: impl Iterator<Item = f64>, step: f64) -> Self {
        let (low, high) =
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
        let count = ((high - low) / step).ceil().max(0.0) as usize + 1;
        let step = if count > 1 { (high - low) / (count - 1) as f64 } else { 1.0 };
        Self { first: low, step, count }
    }

    fn node(&self, index: usize) -> f64 {
        self.first + self.step * index as f64
    }

    /// The nodes on both sides of a value, and the share of the second.
    fn around(&self, value: f64) -> ([usize; 2], f64) {
        let at = ((value - self.first) / self.step).clamp(0.0, (self.count - 1) as f64);
        let low = (at as usize).min(self.count.saturating_sub(2));
        ([low, (low + 1).min(self.count - 1)], at - low as f64)
    }
}

fn density(spots: &Spots) -> f64 {
    let spacing = spots.spacing.unwrap_or(1.0);
    libm::log(spots.area / (spacing * spacing))
}

impl Lattice {
    /// Steps of ln(area ÷ spacing²) and of the aspect. A test holds what is interpolated against what is looked up.
    const STEPS: [f64; 2] = [0.1, 0.04];

    fn new(
        wanted: &[Spots],
        cell: f64,
        answer: &(impl Fn(&Spots) -> Result<Answer, LayerError> + Sync),
    ) -> Result<Self, LayerError> {
        let densities = Axis::over(wanted.iter().map(density), Self::STEPS[0]);
        let aspects = Axis::over(wanted.iter().map(|spots| spots.aspect), Self::STEPS[1]);
        let usual = wanted.first().map_or(1.0, |spots| spots.area);
        let node = |index: usize| {
            let (aspect, density) =
                (aspects.node(index / densities.count), densities.node(index % densities.count));
            let spots =
                Spots { area: usual, aspect, angle: 0.0, spacing: Some((usual / libm::exp(density)).sqrt()) };
            let answer = answer(&spots)?;
            let of = &answer.parameters;
            let level = of.level.unwrap_or(0.5);
            let own = Parameters { pitch: 1.0, ..parameters(&answer, 0.0) };
            let p = system().spacing(&own);
            let fine = fineness(system(), f64::from(own.ratio), p, f64::from(own.stretch));
            let factor = |of: f64| (of - 1.0) * p * p;
            // The flat grid has made them smaller, too, which its rows make up for.
            let flat =
                1.0 + factor(fine.smooth) / ((p * cell / flat_cell(&spots)) * (p * cell / flat_cell(&spots)));
            let level = level * libm::pow(flat, 1.0 / system().definition().level_slope);
            Ok(Node {
                rate: libm::log(of.rate * usual),
                ratio: libm::log(of.ratio.unwrap_or(1.0)),
                stretch: libm::log(of.stretch),
                pitch: libm::log(answer.pitch),
                level,
                area_by_cells: factor(fine.smooth),
                aspect_by_cells: factor(fine.aspect),
            })
        };
        let nodes = (0..densities.count * aspects.count)
            .into_par_iter()
            .map(node)
            .collect::<Result<_, LayerError>>()?;
        Ok(Self { axes: [densities, aspects], nodes })
    }

    /// Parameters and level of spots.
    fn at(&self, spots: &Spots) -> (Parameters, f32) {
        let [densities, aspects] = self.axes;
        let ((columns, x), (rows, y)) = (densities.around(density(spots)), aspects.around(spots.aspect));
        let node = |row: usize, column: usize| &self.nodes[row * densities.count + column];
        let mix = |of: fn(&Node) -> f64| {
            let of_row = |row: usize| {
                let [first, second] = columns.map(|column| of(node(row, column)));
                first + x * (second - first)
            };
            of_row(rows[0]) + y * (of_row(rows[1]) - of_row(rows[0]))
        };
        let parameters = Parameters {
            rate: (libm::exp(mix(|node| node.rate)) / spots.area) as f32,
            ratio: libm::exp(mix(|node| node.ratio)) as f32,
            stretch: 1.0,
            direction: spots.angle as f32,
            pitch: libm::exp(mix(|node| node.pitch)) as f32,
        };
        let p = system().spacing(&Parameters { pitch: 1.0, ..parameters });
        let factor = |k: f64| (1.0 + k / (p * p)).clamp(0.5, 1.5);
        let stretch = (libm::exp(mix(|node| node.stretch)) / factor(mix(|node| node.aspect_by_cells)))
            .clamp(f64::from(MIN_STRETCH), 1.0);
        // At a lower level spots are larger, as much as the cells make them smaller.
        let level = mix(|node| node.level)
            * libm::pow(factor(mix(|node| node.area_by_cells)), -1.0 / system().definition().level_slope);
        (Parameters { stretch: stretch as f32, ..parameters }, level as f32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_interpolated_between_nodes_is_about_what_is_looked_up() {
        let training = Training::built_in();
        let spots = |area: f64, aspect: f64| Spots { area, aspect, angle: 0.0, spacing: Some(40.0) };
        let wanted = [spots(110.0, 0.5), spots(190.0, 0.95)];
        let answer = |spots: &Spots| asked_on(training, spots, 3.0);
        let lattice = Lattice::new(&wanted, 3.0, &answer).expect("answers");
        for wanted in [spots(127.0, 0.61), spots(150.0, 0.73), spots(171.0, 0.88)] {
            let (found, _) = lattice.at(&wanted);
            let exact = parameters(&answer(&wanted).expect("an answer"), 0.0);
            for (name, found, exact) in
                [("rate", found.rate, exact.rate), ("ratio", found.ratio, exact.ratio)]
            {
                assert!((found / exact - 1.0).abs() < 0.01, "{name}: {found} for {exact} of {wanted:?}");
            }
        }
    }
}
