//! What a document may not ask for on a model.

use crate::attributes::system::Family;
use crate::document::{
    After, AreaKind, Body, BodyMark, Document, DocumentError, Kind, Labels, Layer, LayerOptions, MapKey,
    Points, Problem, Progression, Seeding, Stroke, SystemChoice, Towards,
};
use crate::points::fields::POINTS;
use crate::rd::pairs::PairKind;
use crate::synth::body::choice::{grows, systems};
use crate::synth::drawn::maps;

/// The model of a document, if what it asks for grows on one.
///
/// # Errors
/// There is none, or the first thing that does not grow, with its place and what is allowed.
pub fn check<'a>(document: &'a Document, source: &str) -> Result<&'a Body, DocumentError> {
    let missing = || Problem::new("the document", "no key \"model\"", "a model to grow on");
    let body = document.model.as_ref().ok_or_else(|| missing().in_file(source))?;
    let layers = document.layers.iter().enumerate();
    let problem = layers.into_iter().find_map(|(index, layer)| refused(layer, index));
    problem.map_or(Ok(body), |problem| Err(problem.in_file(source)))
}

/// The problem of a layer whose system does not grow its marks on a model.
#[must_use]
pub fn system(layer: &Layer, index: usize) -> Problem {
    let areas = AreaKind::ALL.into_iter().map(|kind| kind.description().name);
    let others = [POINTS.name, PairKind::Stripes.description().name];
    let names: Vec<&str> =
        systems().map(|system| system.description().name).chain(areas).chain(others).collect();
    let found = format!("{:?} on a model", layer.wanted_system().name());
    let allowed =
        format!("auto, {}, for marks that they grow; others do not grow on a model yet", names.join(", "));
    Problem::new(format!("layers[{index}].system"), found, allowed)
}

/// Whether a layer asks for stripes with tips, the kind of pairs that grows on models.
fn is_pair_stripes(system: SystemChoice) -> bool {
    system.pairs() == Some(PairKind::Stripes)
}

/// What of layer `index` does not grow on a model.
fn refused(layer: &Layer, index: usize) -> Option<Problem> {
    const NEW: &str = "leave it out: it does not grow on a model yet";
    let at = |key: &str, found: &str, allowed: &str| {
        Some(Problem::new(format!("layers[{index}].{key}"), found, allowed))
    };
    let is_known = match layer.wanted_system() {
        SystemChoice::Auto | SystemChoice::Stripes => true,
        given => {
            given.areas().is_some()
                || given.kind() == Some(Family::Points)
                || given.system().is_some_and(grows)
                || is_pair_stripes(given)
        }
    };
    if !is_known {
        return Some(system(layer, index));
    }
    let drawn = Kind::of_layer(layer.strokes.iter().filter_map(Stroke::mark).map(|mark| Kind::from(&mark)));
    let on_model = layer.on_model.iter().map(|mark| match mark {
        BodyMark::Ellipse(_) => Kind::Ellipse,
        BodyMark::Path { .. } => Kind::Line,
    });
    let kinds: Vec<Kind> = on_model.chain(drawn).collect();
    if kinds.iter().any(|kind| *kind != kinds[0]) {
        return at("strokes", "ellipses and lines in one layer", "marks of one kind in a layer on a model");
    }
    let has_paths = layer.on_model.iter().any(|mark| matches!(mark, BodyMark::Path { .. }));
    let needs_paths = "a path on the model, from which stripes begin";
    match layer.options.seeding {
        Seeding::Segments => return at("options.seeding", "\"segments\" on a model", "noise or initiators"),
        Seeding::Initiators if !has_paths => return at("strokes", "no path on the model", needs_paths),
        Seeding::Initiators | Seeding::Noise => {}
    }
    if let Some((key, found, allowed)) = refused_of_kind(layer) {
        return at(key, found, allowed);
    }
    for (key, _) in layer.maps.iter() {
        if maps::modulated(key).is_none() && !key.is_painted() {
            let name = key.name();
            let allowed = "maps of area, spacing, direction, aspect, duty, colour or ground: Turing's growth is of canvases";
            return at(&format!("maps.{name}"), &format!("this map of {name} on a model"), allowed);
        }
    }
    if index == 0 && layer.after != After::Between {
        return at("after", &format!("{:?}", layer.after.name()), "between: it is the lowest layer");
    }
    if layer.after == After::Near {
        return at(
            "after",
            "\"near\" on a model",
            "between: marks do not become rarer with a distance on a model yet",
        );
    }
    let key = refused_key(layer)?;
    let name = key.trim_start_matches("options.");
    at(key, &format!("\"{name}\" on a model"), NEW)
}

/// A key of `layer` that grows on no model yet.
fn refused_key(layer: &Layer) -> Option<&'static str> {
    let LayerOptions { irregular, broken, vary, double, rosette, .. } = layer.options;
    let takes_noise =
        layer.wanted_system().system().is_some_and(|system| system.definition().decay_noise.is_some());
    let keys = [
        ("options.irregular", irregular != 0.0 && !takes_noise),
        ("options.vary", vary != 0.0),
        ("options.double", double != 0.0),
        ("options.rosette", rosette.is_some()),
        ("options.broken", broken != 0.0 && layer.after != After::Around),
        ("tone", layer.tone.is_some()),
        ("points", layer.points.is_some() && layer.point_field().is_none()),
    ];
    keys.into_iter().find_map(|(key, given)| given.then_some(key))
}

/// A key of a layer, the value that does not grow on a model, and what is allowed.
type Refused = (&'static str, &'static str, &'static str);

/// What of stripes with tips or of a field of points does not grow on a model.
fn refused_of_kind(layer: &Layer) -> Option<Refused> {
    let points = layer.point_field();
    if layer.after != After::Between && (points.is_some() || is_pair_stripes(layer.system)) {
        return Some(("after", "stripes with tips or points round or inside marks on a model", "between"));
    }
    points_refused(&points?, layer)
}

/// What of a field of points does not grow on a model.
fn points_refused(points: &Points, layer: &Layer) -> Option<Refused> {
    const PLACE: &str = "across or down: a model has no middle, and a picture of the canvas no place on it";
    if matches!(points.labels, Labels::Image { .. }) {
        let allowed = "other labels: a picture of the canvas has no place on a model";
        return Some(("points.labels.kind", "\"image\" on a model", allowed));
    }
    match points.progression {
        Progression::Outward => return Some(("points.progression", "\"outward\" on a model", PLACE)),
        Progression::Image(_) => return Some(("points.progression", "a picture on a model", PLACE)),
        Progression::Across | Progression::Down => {}
    }
    if points.shift > 0.0 && points.towards == Towards::Outward {
        let allowed = "random or an angle: a model has no middle";
        return Some(("points.towards", "\"outward\" on a model", allowed));
    }
    let only = layer.maps.iter().all(|(key, _)| key == MapKey::Spacing || key.is_painted());
    (!only).then_some((
        "maps",
        "maps of a field of points on a model",
        "maps of its spacing, colour or ground",
    ))
}

/// What of the document means nothing on a model, and is not refused.
pub fn notes(document: &Document) -> Vec<String> {
    let is_unpinned = document.model.as_ref().is_some_and(|model| model.pins.is_empty());
    let has_strokes = document.layers.iter().any(|layer| !layer.strokes.is_empty());
    let said = [
        (
            !is_unpinned && !has_strokes,
            "pins hold what is drawn on the canvas, and nothing is drawn there: they mean nothing",
        ),
        (
            document.edges == crate::grid::Edges::Wrap,
            "edges \"wrap\" means nothing on a model, whose surface has no border of the canvas",
        ),
        (
            is_unpinned && document.regions.is_some_and(|regions| regions != [1, 1]),
            "without pins the whole sketch holds everywhere on the model; its regions are read as one",
        ),
        (
            document.layers.iter().any(|layer| layer.options.keep == Some(true) && layer.on_model.is_empty()),
            "marks that are drawn on the canvas have no place on the model: \"keep\" holds for marks on the model",
        ),
    ];
    said.into_iter().filter(|(is_so, _)| *is_so).map(|(_, note)| note.to_owned()).collect()
}
