//! What a document may not ask for on a model.

use crate::document::{
    After, Body, BodyMark, Document, DocumentError, Kind, Layer, LayerOptions, Problem, RaggedChoice,
    SpreadChoice, Stroke, SystemChoice,
};
use crate::rd::System;

/// The system that grows on models: the first of which is known what a coarse mesh does to it.
pub fn system() -> System {
    let is_known = |system: &System| system.definition().fineness.is_some();
    System::ALL.into_iter().find(is_known).unwrap_or(System::ALL[0])
}

/// The model of a document, if what it asks for grows on one.
///
/// # Errors
/// There is none, or the first thing that does not grow, with its place and what is allowed.
pub fn check<'a>(document: &'a Document, source: &str) -> Result<&'a Body, DocumentError> {
    let missing = || Problem::new("the document", "no key \"model\"", "a model to grow on");
    let body = document.model.as_ref().ok_or_else(|| missing().in_file(source))?;
    let problem = layers(document).or_else(|| refused(&document.layers[0]));
    problem.map_or(Ok(body), |problem| Err(problem.in_file(source)))
}

fn layers(document: &Document) -> Option<Problem> {
    let count = document.layers.len();
    let allowed = "one layer of spots: layers above each other do not grow on a model yet";
    (count != 1).then(|| Problem::new("layers", format!("{count} layers on a model"), allowed))
}

/// What of its only layer does not grow on a model.
fn refused(layer: &Layer) -> Option<Problem> {
    const NEW: &str = "leave it out: it does not grow on a model yet";
    let at = |key: &str, found: &str, allowed: &str| {
        Some(Problem::new(format!("layers[0].{key}"), found, allowed))
    };
    let name = system().description().name;
    let is_known = matches!(layer.system, SystemChoice::Auto) || layer.system.system() == Some(system());
    if !is_known {
        let found = format!("{:?} on a model", layer.system.name());
        return at("system", &found, &format!("auto or {name}; others do not grow on a model yet"));
    }
    let drawn = Kind::of_layer(layer.strokes.iter().filter_map(Stroke::mark).map(|mark| Kind::from(&mark)));
    let has_lines = layer.on_model.iter().any(|mark| matches!(mark, BodyMark::Path { .. }));
    if drawn == Some(Kind::Line) || has_lines {
        return at("strokes", "lines or paths on a model", "ellipses; stripes do not grow on a model yet");
    }
    let LayerOptions { spread, irregular, ragged, broken, .. } = layer.options;
    let options = [
        ("options.spread", matches!(spread, SpreadChoice::Given(_))),
        ("options.irregular", irregular != 0.0),
        ("options.ragged", matches!(ragged, RaggedChoice::Given(_))),
        ("options.broken", broken != 0.0),
        ("tone", layer.tone.is_some()),
        ("points", layer.points.is_some()),
        ("maps", !layer.maps.is_empty()),
    ];
    if layer.after != After::Between {
        return at("after", &format!("{:?}", layer.after.name()), "between: it is the lowest layer");
    }
    let (key, _) = options.into_iter().find(|(_, given)| *given)?;
    let name = key.trim_start_matches("options.");
    at(key, &format!("\"{name}\" on a model"), NEW)
}

/// What of the document means nothing on a model, and is not refused.
pub fn notes(document: &Document) -> Vec<String> {
    let layer = &document.layers[0];
    let is_unpinned = document.model.as_ref().is_some_and(|model| model.pins.is_empty());
    let said = [
        (
            !is_unpinned && layer.strokes.is_empty(),
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
            layer.options.keep == Some(true),
            "drawn marks say what is wanted, and are not kept in place on a model yet",
        ),
    ];
    said.into_iter().filter(|(is_so, _)| *is_so).map(|(_, note)| note.to_owned()).collect()
}
