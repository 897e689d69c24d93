//! Other documents that fit the same sketch.

use crate::attributes::Spread;
use crate::document::{Document, SpreadChoice, Stroke, limits};
use crate::synth::drawn::sketch_targets;

/// How many other seeds are offered.
const SEEDS: u64 = 4;
/// The spread of the *Varied* alternative ÷ the drawn spread.
const LOOSER: f64 = 1.6;
/// The least spread of the *Varied* alternative.
const LOOSE: Spread = Spread { area: 0.2, angle: 10.0, aspect: 0.06, spacing: 0.14 };

/// A document, and how it differs from the sketch.
#[derive(Clone, Debug, PartialEq)]
pub struct Variant {
    /// The difference, in a few words.
    pub name: String,
    /// The difference, in a sentence.
    pub help: String,
    /// The document.
    pub document: Document,
}

impl Variant {
    fn new(name: impl Into<String>, help: impl Into<String>, document: Document) -> Self {
        Self { name: name.into(), help: help.into(), document }
    }
}

/// The variants of `document`: the same strokes, with another seed or with another variation on `layer`.
#[must_use]
pub fn variants(document: &Document, layer: usize) -> Vec<Variant> {
    let mut all = Vec::new();
    all.extend((1..=SEEDS).map(|step| seeded(document, step)));
    all.extend(spreads(document, layer));
    all
}

/// The document with another seed.
fn seeded(document: &Document, step: u64) -> Variant {
    let seed = document.seed.wrapping_add(step);
    let mut other = Document { seed, ..document.clone() };
    for layer in &mut other.layers {
        // A layer with its own seed does not follow the seed of the document, so its seed is changed as well.
        layer.seed = layer.seed.map(|seed| seed.wrapping_add(step));
    }
    Variant::new(
        format!("Seed {seed}"),
        "Another random start: the same kind of texture, with other positions and shapes",
        other,
    )
}

fn is_spotted(document: &Document, layer: usize) -> bool {
    match document.layers[layer].strokes.first() {
        // Cells and fields of points have no spread. The spread of patches is not varied, nor that of a layer whose
        // picture sets it.
        _ if document.is_of_points(layer) || document.layers[layer].is_driven() => false,
        Some(Stroke::Ellipse(_) | Stroke::Outline(_) | Stroke::Fitted { .. }) => true,
        Some(Stroke::Line(_) | Stroke::Path(_)) | None => false,
        Some(Stroke::Freehand { .. }) => sketch_targets::marks(document, layer, "")
            .is_ok_and(|marks| marks.iter().all(|mark| matches!(mark, crate::marks::Mark::Ellipse(_)))),
    }
}

/// A variant whose spots differ less from each other, and one whose spots differ more.
fn spreads(document: &Document, layer: usize) -> Vec<Variant> {
    let Some(of) = document.layers.get(layer).filter(|_| is_spotted(document, layer)) else {
        return Vec::new();
    };
    let Some(drawn) = spread(document, layer) else { return Vec::new() };
    let given = |spread| {
        let mut other = document.clone();
        other.layers[layer].options.spread = SpreadChoice::Given(spread);
        other
    };
    let mut all = Vec::new();
    if !drawn.is_zero() {
        all.push(Variant::new(
            "Uniform",
            "All spots of a region have the same size and shape",
            given(Spread::ZERO),
        ));
    }
    let looser = limited(drawn.with(&LOOSE, |drawn, least| (LOOSER * drawn).max(least)));
    if of.options.spread != SpreadChoice::Given(looser) {
        let help = "Spots that differ more in size, shape, direction and spacing";
        all.push(Variant::new("Varied", help, given(looser)));
    }
    all
}

/// The spread within the limits of documents.
fn limited(spread: Spread) -> Spread {
    Spread {
        area: spread.area.min(limits::SPREAD_AREA.high),
        angle: spread.angle.min(limits::SPREAD_ANGLE.high),
        aspect: spread.aspect.min(limits::SPREAD_ASPECT.high),
        spacing: spread.spacing.min(limits::SPREAD_SPACING.high),
    }
}

/// The largest spread of a layer's regions.
fn spread(document: &Document, layer: usize) -> Option<Spread> {
    let map = sketch_targets::region_map(document, layer, "").ok()?;
    let spreads = map.regions().map(|(_, region)| region.spread);
    Some(spreads.fold(Spread::ZERO, |most, spread| most.with(&spread, f64::max)))
}
