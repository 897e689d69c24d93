//! The table of the pairs beside the keys that the program reads, and the page beside the table.

use std::collections::BTreeSet;
use std::path::Path;

use serde_json::Value;

use super::document::parsed;
use super::quantity::Quantity;
use super::table::{Row, Table};
use super::{page, shown};

/// An object and one of its keys.
type Key = (String, String);

/// The keys that the program reads.
fn read() -> BTreeSet<Key> {
    let schema: Value = serde_json::from_str(&dapple::document::schema()).unwrap();
    let keys = |name: &str, object: &Value| -> Vec<Key> {
        object["properties"].as_object().unwrap().keys().map(|key| (name.to_owned(), key.clone())).collect()
    };
    let others = schema["$defs"].as_object().unwrap().iter().flat_map(|(name, object)| keys(name, object));
    keys("Document", &schema).into_iter().chain(others).collect()
}

#[test]
fn each_key_of_documents_has_a_pair_or_a_reason_why_not() {
    let table = Table::built_in().unwrap();
    let shown: BTreeSet<Key> =
        table.rows().map(|row| (row.section.object.clone(), row.pair.key.clone())).collect();
    let unseen = table
        .unseen
        .iter()
        .flat_map(|unseen| unseen.keys.iter().map(|key| (unseen.object.clone(), key.clone())));
    let unseen: BTreeSet<Key> = unseen.collect();
    assert_eq!(shown.intersection(&unseen).collect::<Vec<_>>(), Vec::<&Key>::new(), "with both");
    let listed: BTreeSet<Key> = shown.union(&unseen).cloned().collect();
    let read = read();
    assert_eq!(read.difference(&listed).collect::<Vec<_>>(), Vec::<&Key>::new(), "not in pairs.json");
    assert_eq!(listed.difference(&read).collect::<Vec<_>>(), Vec::<&Key>::new(), "not in documents");
}

#[test]
fn both_documents_of_a_pair_are_read_and_differ() {
    let table = Table::built_in().unwrap();
    for row in table.rows() {
        let both = [0, 1].map(|which| {
            parsed(&table.document(&row, which).unwrap(), &row.file())
                .unwrap_or_else(|error| panic!("{error}"))
        });
        assert_ne!(both[0], both[1], "{}", row.file());
        row.pair.shows.iter().for_each(|name| assert!(Quantity::named(name).is_ok(), "{name}"));
    }
}

#[test]
fn the_page_has_a_row_with_pictures_for_each_pair() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let page = std::fs::read_to_string(root.join("docs/keys.md")).unwrap();
    let table = Table::built_in().unwrap();
    let files: BTreeSet<String> = table.rows().map(|row| row.file()).collect();
    for row in table.rows() {
        let cells = format!("\n{} | ![", page::first_cells(&row));
        assert!(page.contains(&cells) && page.contains(&row.file()), "docs/keys.md has no row {cells}");
    }
    let there = std::fs::read_dir(root.join("assets/keys")).unwrap();
    let there: BTreeSet<String> =
        there.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    assert_eq!(there, files);
}

/// The pair of an object's key.
fn pair<'a>(table: &'a Table, object: &str, key: &str) -> Row<'a> {
    table.rows().find(|row| row.section.object == object && row.pair.key == key).unwrap()
}

#[test]
fn the_effect_of_a_key_is_measured_and_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let table = Table::built_in().unwrap();
    let row = pair(&table, "Points", "share");
    let effect = shown(&table, &row, folder.path()).unwrap().to_string();
    assert!(effect.starts_with("ink 19.9 → 70.0 %; points 279 → 279; "), "{effect}");
    let written = std::fs::read(folder.path().join("points-share.png")).unwrap();
    assert_eq!(written[..2], *b"\x89P");
}

#[test]
fn a_key_whose_pictures_look_equal_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let mut table = Table::built_in().unwrap();
    let points = table.sections.iter_mut().find(|section| section.object == "Points").unwrap();
    let share = points.pairs.iter_mut().find(|pair| pair.key == "share").unwrap();
    share.values = [0.3, 0.3].map(Value::from);
    let Err(error) = shown(&table, &pair(&table, "Points", "share"), folder.path()) else {
        panic!("no error")
    };
    assert_eq!(error, "points-share.png: only 0.00 % of the px differ");
}
