//! The choices for a layer, and why others are not possible, as the panel needs them from
//! [`crate::document::layer_rules`].

use crate::document::layer_rules::{Beneath, Combination, Condition};
use crate::document::{After, AreaKind, Kind, Layer, MapKey, OptionKey, SystemChoice};
use crate::editor::session::Session;

/// Why layer `layer` cannot have this value of `after`; `None` where it can.
#[must_use]
pub fn after_refusal(session: &Session, layer: usize, after: After) -> Option<&'static str> {
    Some(combination(session, layer)?.against_after(after)?.reason)
}

/// Why layer `layer` cannot be grown by this system; `None` where it can.
#[must_use]
pub fn system_refusal(session: &Session, layer: usize, system: SystemChoice) -> Option<&'static str> {
    Some(combination(session, layer)?.against_system(system)?.reason)
}

/// Whether `layer`, whose marks are of `kind`, has this option.
#[must_use]
pub fn has_option(layer: &Layer, kind: Option<Kind>, option: OptionKey) -> bool {
    let combination = Combination::new(layer, kind, Beneath::Unknown);
    let changeable =
        |condition: &Condition| matches!(condition, Condition::SystemWithout(..) | Condition::Option(_));
    combination.grows().is_some()
        && combination.against_option(option).is_none_or(|rule| changeable(&rule.condition))
}

/// Whether `layer`, whose marks are of `kind`, can have a map of `key`.
#[must_use]
pub fn has_map(layer: &Layer, kind: Option<Kind>, key: MapKey) -> bool {
    let combination = Combination::new(layer, kind, Beneath::Unknown);
    (combination.grows().is_some() || layer.point_field().is_some()) && combination.against_map(key).is_none()
}

/// Why the option cannot be changed together with the other settings of `layer`; `None` where it can.
#[must_use]
pub fn option_refusal(layer: &Layer, kind: Option<Kind>, option: OptionKey) -> Option<&'static str> {
    Some(Combination::new(layer, kind, Beneath::Unknown).against_option(option)?.reason)
}

/// Layer `layer` with the properties that the rules depend on.
fn combination(session: &Session, layer: usize) -> Option<Combination> {
    Some(Combination::new(
        session.document().layers.get(layer)?,
        session.kind(layer),
        beneath(session, layer),
    ))
}

/// The kind of the layer beneath layer `layer`.
#[must_use]
pub fn beneath(session: &Session, layer: usize) -> Beneath {
    session.beneath(layer).map_or(Beneath::Nothing, |beneath| {
        as_beneath(&session.document().layers[beneath], session.areas(beneath), session.kind(beneath))
    })
}

/// The kind that `layer`, whose marks are of `kind` and grow these `areas`, is for a layer above it.
#[must_use]
pub fn as_beneath(layer: &Layer, areas: Option<AreaKind>, kind: Option<Kind>) -> Beneath {
    if layer.is_driven() {
        Beneath::Tone
    } else if layer.system.pairs().is_some() {
        Beneath::Pairs
    } else if areas.is_some() || layer.is_of_points() {
        Beneath::Areas
    } else {
        kind.map_or(Beneath::Unknown, Beneath::Grows)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Document, Stroke};
    use crate::marks::Line;
    use crate::rd::System;

    fn line() -> Stroke {
        Stroke::Line(Line { from: [50.0, 50.0], to: [150.0, 50.0], width: 6.0 })
    }

    #[test]
    fn only_the_options_that_a_layer_takes_are_offered() {
        let offered = |layer: &Layer, kind| {
            let has = OptionKey::ALL.into_iter().filter(|option| has_option(layer, kind, *option));
            has.map(OptionKey::name).collect::<Vec<_>>()
        };
        let mut layer = Layer::default();
        assert_eq!(offered(&layer, Some(Kind::Ellipse)), ["spread", "irregular", "keep", "ragged"]);
        assert_eq!(
            offered(&layer, Some(Kind::Line)),
            ["duty", "seeding", "keep", "vary", "double", "ragged"]
        );
        assert!(offered(&layer, None).is_empty());
        layer.system = SystemChoice::Of(System::MEINHARDT_LINES.description());
        assert_eq!(offered(&layer, Some(Kind::Line)), ["duty", "keep", "vary", "double", "ragged"]);
        layer.after = After::Around;
        assert_eq!(offered(&layer, Some(Kind::Line)), ["broken", "vary", "double", "ragged"]);
        layer = Layer { after: After::Inside, ..Layer::default() };
        assert_eq!(offered(&layer, Some(Kind::Ellipse)), ["spread", "ragged"]);
    }

    #[test]
    fn the_lowest_layer_offers_no_relation_and_says_why() {
        let mut session = Session::open(Document::default(), None);
        session.edit(|document| {
            document.layers.push(Layer { strokes: vec![line()], ..Layer::default() });
        });
        assert_eq!(after_refusal(&session, 0, After::Between), None);
        for after in [After::Around, After::Net, After::Inside] {
            assert!(after_refusal(&session, 0, after).unwrap().contains("beneath"));
        }
        session.edit(|document| {
            document.layers.push(Layer { strokes: vec![line()], ..Layer::default() });
        });
        assert_eq!(after_refusal(&session, 1, After::Around), None);
        assert!(after_refusal(&session, 1, After::Inside).unwrap().contains("lines"));
        assert!(
            system_refusal(&session, 1, SystemChoice::Of(System::TURING_SPOTS.description()))
                .unwrap()
                .contains("spots")
        );
        assert_eq!(
            system_refusal(&session, 1, SystemChoice::Of(System::MEINHARDT_LINES.description())),
            None
        );
    }
}
