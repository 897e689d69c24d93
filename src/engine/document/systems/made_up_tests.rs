//! A system that exists in tests alone, by its description and a line in the list. It is offered, refused and documented as the
//! other systems are.

use crate::attributes::system::{Description, Family, Keys};
use crate::document::layer_rules::{Beneath, Combination, RULES, Rule};
use crate::document::{After, Document, Kind, Layer, MapKey, OptionKey, Stroke, SystemChoice};

const GAP: &str = "Cells and made-up spots have a gap: set \"system\" to one of these";
const NO_DIRECTION: &str = "Made-up spots have no direction";
const LOWEST: &str = "Made-up spots grow on the ground";

pub(super) static MADE_UP: Description = Description {
    name: "made-up",
    title: "Made-up spots",
    noun: "made-up spots",
    help: "Nothing: no program grows it",
    kind: Family::Areas,
    lowest_alone: Some(LOWEST),
    free_spacing: true,
    option_keys: &["keep", "gap"],
    own_keys: &[Keys { keys: &["options.gap"], reason: GAP }],
    refused_keys: &[Keys { keys: &["maps.direction"], reason: NO_DIRECTION }],
    ..Description::PLAIN
};

const CHOICE: SystemChoice = SystemChoice::Of(&MADE_UP);

/// A document of one ellipse or line; `more` are other keys of its layer.
fn document(stroke: &str, more: &str) -> String {
    let layer = format!(r#"{{"system": "made-up", "strokes": [{stroke}]{more}}}"#);
    format!(r#"{{"format": "dapple", "version": 2, "size": [128, 128], "layers": [{layer}]}}"#)
}

const ELLIPSE: &str = r#"{"kind": "ellipse", "center": [64, 64], "radii": [12, 6]}"#;
const LINE: &str = r#"{"kind": "line", "from": [10, 10], "to": [90, 60]}"#;

fn refused(text: &str) -> String {
    Document::parse(text, "itself").expect_err("it is refused").to_string()
}

#[test]
fn it_is_offered_by_its_name() {
    assert_eq!(SystemChoice::named("made-up"), Some(CHOICE));
    assert_eq!((CHOICE.title(), CHOICE.help()), (MADE_UP.title, MADE_UP.help));
    let ellipses = Combination::new(&Layer::default(), Some(Kind::Ellipse), Beneath::Nothing);
    assert!(ellipses.against_system(CHOICE).is_none());
    let layer = Layer { system: CHOICE, ..Layer::default() };
    let of_it = Combination::new(&layer, Some(Kind::Ellipse), Beneath::Nothing);
    let has = |option: &OptionKey| of_it.against_option(*option).is_none();
    let options: Vec<_> = OptionKey::ALL.into_iter().filter(has).map(OptionKey::name).collect();
    assert_eq!(options, MADE_UP.option_keys);
    assert!(of_it.against_map(MapKey::Area).is_none() && of_it.against_map(MapKey::Direction).is_some());
}

#[test]
fn a_document_of_it_is_read_as_it_was_written() {
    let read =
        Document::parse(&document(ELLIPSE, r#", "options": {"gap": 4}"#), "itself").expect("a document");
    assert_eq!(read.layers[0].system, CHOICE);
    assert_eq!(Document::parse(&read.to_json(), "itself").map_err(|error| error.to_string()), Ok(read));
}

#[test]
fn what_it_refuses_is_refused_with_its_own_reasons() {
    assert!(refused(&document(LINE, "")).contains("This system grows spots; this layer holds lines"));
    let noise = r#", "maps": {"direction": {"noise": {"size": 40, "range": [0, 20]}}}"#;
    assert!(refused(&document(ELLIPSE, noise)).contains(NO_DIRECTION));
    let spread = r#", "options": {"spread": {"area": 0.1}}"#;
    assert!(refused(&document(ELLIPSE, spread)).contains("This system does not take this option"));
    let decay = r#", "options": {"decay": 0.5}"#;
    assert!(refused(&document(ELLIPSE, decay)).contains("Only stucco has this option"));

    let combination = |system, beneath, after| {
        let layer = Layer { system, after, ..Layer::default() };
        Combination::new(&layer, Some(Kind::Ellipse), beneath)
    };
    let above = combination(CHOICE, Beneath::Grows(Kind::Ellipse), After::Between);
    assert_eq!(above.broken_rule().map(|rule| rule.reason), Some(LOWEST));
    let inside = combination(CHOICE, Beneath::Nothing, After::Inside);
    assert!(inside.against_system(CHOICE).is_some());
    let layer = Layer {
        system: CHOICE,
        strokes: vec![Stroke::ellipse([64.0; 2], [9.0; 2], 0.0)],
        ..Layer::default()
    };
    assert!(layer.is_of_points(), "no rings grow around its marks");
}

#[test]
fn the_rules_on_the_page_name_it() {
    let row = |rule: &Rule| format!("{} | {} | {}", rule.key, rule.condition, rule.reason);
    let rows: Vec<String> = RULES.iter().map(row).collect();
    let of = |start: &str| rows.iter().find(|row| row.starts_with(start)).cloned().unwrap_or_default();
    assert_eq!(
        of("`system` `\"made-up\"`"),
        format!("`system` `\"made-up\"` | a layer above another | {LOWEST}")
    );
    assert!(of("`options.gap`").contains("| a layer of neither cells nor made-up |"));
    assert!(rows.contains(&format!("`maps.direction` | `system` `\"made-up\"` | {NO_DIRECTION}")));
    assert!(rows.iter().any(|row| {
        row.contains("a layer above patches, cells, streaks, cracks, a field of points or made-up spots")
    }));
}
