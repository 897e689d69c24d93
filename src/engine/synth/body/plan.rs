//! The plan of a layer on a model: the remeshed surface, and the parameters of each vertex.

use rayon::prelude::*;

use crate::attributes::{Attributes, Polarity, Stripes};
use crate::document::{Body, Document, Layer, Towards};
use crate::learn::Answer;
use crate::rd::{ParameterField, Parameters};
use crate::surface::{Directions, Surface, directions};
use crate::synth::body::anchors::{Anchor, Origin, anchors};
use crate::synth::body::answer_table::{AnswerTable, asked_on, parameters};
use crate::synth::body::area_form::AreaForm;
use crate::synth::body::asked::Asked;
use crate::synth::body::choice::Choice;
use crate::synth::body::clearance::with_clearance;
use crate::synth::body::curves::{Curves, Request, widths};
use crate::synth::body::given_directions::given;
use crate::synth::body::maps::BodyMaps;
use crate::synth::body::placed::Placed;
use crate::synth::body::wanted::{Influence, aspect, turned, wanted};
use crate::synth::error::LayerError;
use crate::synth::training::Training;

/// Vertices a spacing of spots: the distance that the system keeps by itself ÷ √(mean cell area), where the pattern is finest. Spots are
/// then corrected for the fineness of the mesh by [`crate::rd::fineness`].
const FINENESS: f64 = 12.0;
/// Vertices a wavelength, and across a stripe. With 14 the wavelength is within 1.1 % of the law.
const STRIPES: [f64; 2] = [14.0, 5.0];
/// From this aspect on spots are so round that their directions do not matter.
const ROUND: f64 = 0.97;
/// The weight of the axis `along` in the field of directions, against 1 of strokes and pins: they reach about 30 cells far.
const ALONG: f64 = 0.001;
/// Vertices that a round spot covers at least, and one of a stretch below ½: from there on two patches differ by at most half a per
/// cent (`training/README.md`).
const COVERED: [f64; 2] = [14.0, 18.0];

/// What is grown on a model.
pub struct BodyPlan {
    /// The index of the layer.
    pub layer: usize,
    /// What grows it.
    pub choice: Choice,
    /// The surface, px, and the parameters of each vertex, in cells.
    pub maps: ParameterField<Surface>,
    /// What is wanted around which places.
    pub anchors: Vec<Anchor>,
    /// Their weights at each vertex.
    pub influence: Influence,
    /// What is wanted at each vertex, the angle in its frame.
    pub wanted: Vec<Attributes>,
    /// Where +x of the sketch points; `None` where spots are round.
    pub directions: Option<Directions>,
    /// What was looked up for each anchor: lengths in px, parameters in cells.
    pub answers: Vec<Answer>,
    /// The share of the local peak that is the edge of a mark, by vertex.
    pub levels: Vec<f32>,
    /// What cannot be reached.
    pub notes: Vec<String>,
    /// The parameters of the marks about each anchor, in the frame of its place.
    own: Vec<Parameters>,
    /// The curves that its lines run along; `None` where they run freely.
    pub curves: Option<Curves>,
}

/// Whether the points of a layer are shifted along a direction.
fn shifts(layer: &Layer) -> bool {
    let points = layer.point_field();
    points.is_some_and(|points| points.shift > 0.0 && matches!(points.towards, Towards::Angle(_)))
}

/// Whether a field of points grows.
fn is_of_points(choice: &Choice) -> bool {
    matches!(choice.areas, Some(AreaForm::Points(_)))
}

/// px a cell that suits what is asked for.
///
/// # Errors
/// The training set cannot be read.
pub fn cell(document: &Document, asked: &Asked, training: &Training) -> Result<f64, LayerError> {
    let polarity = asked.choice.polarity;
    let mut finest = f64::INFINITY;
    let maps = BodyMaps::new(document, asked.layer, asked.is_free);
    for wanted in asked.all().flat_map(|wanted| maps.extremes(*wanted)) {
        if let Some(form) = &asked.pair {
            finest = finest.min(form.cell(&wanted));
            continue;
        }
        let lines = polarity.lines(&wanted);
        // On cells of 1 px the parameters say how many cells the system keeps marks apart by itself, and a mark covers.
        let own = parameters(&asked_on(training, &asked.choice, &lines, 1.0)?, 0.0);
        finest = finest.min(suited(&asked.choice, &own, &lines));
    }
    Ok(finest)
}

/// px a cell that suits marks of these parameters, which are those of cells of 1 px.
fn suited(Choice { system, curves, areas, .. }: &Choice, own: &Parameters, wanted: &Attributes) -> f64 {
    if let Some(form) = areas {
        return form.cell(wanted);
    }
    if let Attributes::Stripes(Stripes { width, .. }) = wanted {
        if curves.is_some() {
            return width / STRIPES[1];
        }
        return (system.spacing(own) / STRIPES[0]).min(width / STRIPES[1]);
    }
    let covered = match system.definition().fineness {
        Some(_) => COVERED[usize::from(own.stretch < 0.5)],
        None => system.definition().resolution.planned.asked_distance,
    };
    let own = Parameters { pitch: 1.0, ..*own };
    (system.spacing(&own) / FINENESS).min((system.cells(&own) / covered).sqrt())
}

impl BodyPlan {
    /// Plans what a layer asks for on a surface.
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
        let Choice { system, polarity, .. } = asked.choice;
        let anchors = anchors(asked, document, body, &surface, &placed.scale);
        let vertices = surface.mesh.positions.len();
        let layer = &document.layers[asked.layer];
        let has_directions = anchors.iter().any(|anchor| aspect(&anchor.wanted) < ROUND) || shifts(layer);
        let directions =
            has_directions.then(|| directions(&surface, &given(body, layer, asked, &surface, placed), ALONG));
        let anchors = in_the_field(anchors, directions.as_ref(), &surface);
        let influence = Influence::new(&surface, &anchors);
        let wanted = wanted(&anchors, &influence, vertices);
        let maps = BodyMaps::new(document, asked.layer, asked.is_free);
        let mut wanted = maps.varied(&surface, wanted, placed.coordinates.as_ref());
        if let Some(field) = &directions {
            for (vertex, wanted) in wanted.iter_mut().enumerate() {
                *wanted = turned(*wanted, wanted.angle() + field.degrees[vertex]);
                if let Attributes::Spots(spots) = wanted {
                    // Directions turn about singularities: there spots are round.
                    spots.aspect = libm::pow(spots.aspect, field.coherence[vertex]);
                }
            }
        }
        let cell = surface.unit();
        let answer = |anchor: &Anchor| {
            let answer = asked_on(training, &asked.choice, &polarity.lines(&anchor.wanted), cell)?;
            Ok(Answer { predicted: polarity.marks(&answer.predicted), ..answer })
        };
        let answers = anchors.par_iter().map(answer).collect::<Result<Vec<_>, LayerError>>()?;
        let lines: Vec<Attributes> = wanted.iter().map(|wanted| polarity.lines(wanted)).collect();
        let at_anchor = |anchor: &Anchor| {
            let turn =
                directions.as_ref().map_or(0.0, |field| field.degrees[surface.vertex_of(anchor.place)]);
            turned(polarity.lines(&anchor.wanted), anchor.wanted.angle() + turn)
        };
        let of_anchors: Vec<Attributes> = anchors.iter().map(at_anchor).collect();
        let all: Vec<Attributes> = lines.iter().chain(&of_anchors).copied().collect();
        let table = AnswerTable::new(training, &asked.choice, &all, cell)?;
        let own = of_anchors.iter().map(|wanted| table.at(wanted).0).collect();
        let of_vertices: Vec<(Parameters, f32)> = lines.par_iter().map(|lines| table.at(lines)).collect();
        let (mut parameters, mut levels): (Vec<Parameters>, Vec<f32>) = of_vertices.into_iter().unzip();
        // The share of points above the edge is sought when the field is there.
        levels.iter_mut().filter(|_| is_of_points(&asked.choice)).for_each(|level| *level = 0.5);
        if let (Some(field), true) = (&directions, system.is_striped()) {
            // Where directions turn about a singularity, nothing pulls stripes along them.
            for (p, coherence) in parameters.iter_mut().zip(&field.coherence) {
                p.stretch = libm::pow(f64::from(p.stretch), *coherence) as f32;
            }
        }
        let maps = ParameterField::new(surface, parameters);
        Ok(Self {
            layer: asked.layer,
            choice: asked.choice,
            maps,
            anchors,
            influence,
            wanted,
            directions,
            answers,
            levels,
            notes: asked.notes.clone(),
            own,
            curves: None,
        })
    }

    /// The parameters of a mark on the model, in the frame of its place; `None` where there is no mark of this index.
    #[must_use]
    pub fn own_parameters(&self, mark: usize) -> Option<Parameters> {
        let index = self.anchors.iter().position(|anchor| anchor.origin == Origin::Mark(mark))?;
        Some(self.own[index])
    }

    /// Among `obstacles`, vertices that the marks beneath cover: nothing grows there, and lines along curves run round or between them.
    ///
    /// # Errors
    /// Lines find nothing to run around, or no room.
    pub fn among(mut self, document: &Document, obstacles: Vec<bool>) -> Result<Self, LayerError> {
        self.maps.obstacles = if self.choice.system.is_striped() {
            obstacles
        } else {
            with_clearance(&self.maps, &obstacles, self.choice.system)
        };
        if let Some((kind, laws)) = self.choice.curves {
            let request = Request {
                surface: &self.maps.domain,
                kind,
                laws,
                obstacles: &self.maps.obstacles,
                widths: widths(&self.wanted),
                broken: document.layers[self.layer].options.broken,
                seed: document.layer_seed(self.layer),
            };
            let curves = Curves::lay(&request).map_err(LayerError::Curves)?;
            curves.guide(&mut self.maps);
            self.curves = Some(curves);
        }
        Ok(self)
    }

    /// The surface, px.
    #[must_use]
    pub fn surface(&self) -> &Surface {
        &self.maps.domain
    }

    /// Whether its stripes are the gaps between the lines that grow.
    #[must_use]
    pub fn is_inverted(&self) -> bool {
        self.choice.polarity == Polarity::Negative
    }
}

/// Anchors whose angles all count from +x of the sketch: those of ellipses on the model counted from the axis of the model.
fn in_the_field(mut anchors: Vec<Anchor>, field: Option<&Directions>, surface: &Surface) -> Vec<Anchor> {
    let Some(field) = field else { return anchors };
    let is_ellipse =
        |anchor: &Anchor| matches!((anchor.origin, anchor.wanted), (Origin::Mark(_), Attributes::Spots(_)));
    for anchor in anchors.iter_mut().filter(|anchor| is_ellipse(anchor)) {
        let vertex = surface.vertex_of(anchor.place);
        anchor.wanted = turned(anchor.wanted, anchor.wanted.angle() - field.degrees[vertex]);
    }
    anchors
}
