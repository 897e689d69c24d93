//! A document for each system that a document can name, and one with a tone, grown to the end and corrected.
//!
//! `kinds/NAME.dapple` is a small canvas. Every px of its texture must equal that of `kinds/NAME.png`, and the values
//! of its pattern must have the hash in `patterns.txt`. The list of systems is that of the program: a new system fails
//! here until its document and picture exist.

use crate::renew::{bits, golden, renews, same_lines};
use crate::textures::compare_picture;
use dapple::ReadFile;
use dapple::document::{Document, SystemChoice};
use dapple_engine::synth::Grown;
use std::collections::BTreeSet;

/// The document with a picture that drives the growth.
const TONE: &str = "tone";

/// Every system, and the tone.
fn names() -> Vec<&'static str> {
    // A choice without a description leaves the system open.
    let systems = SystemChoice::names().into_iter().filter(|(_, choice)| choice.description().is_some());
    systems.map(|(name, _)| name).chain([TONE]).collect()
}

/// The document of this name.
fn document(name: &str) -> Document {
    Document::read(golden(&format!("kinds/{name}.dapple"))).unwrap_or_else(|error| panic!("{error}"))
}

/// Grows the document of this name; all growths of this test use this function.
fn grown(name: &str) -> Grown {
    document(name).grow().unwrap_or_else(|error| panic!("{name}: {error}"))
}

#[test]
fn every_system_has_its_document_and_picture() {
    let files = |name: &str| ["dapple", "png"].map(|ending| format!("{name}.{ending}"));
    let wanted: BTreeSet<String> = names().into_iter().flat_map(files).collect();
    let entries = std::fs::read_dir(golden("kinds")).unwrap();
    let there = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    assert!(
        renews() || wanted == there,
        "without: {:?}; left over: {:?}",
        &wanted - &there,
        &there - &wanted
    );
    for name in names() {
        let document = document(name);
        let [layer] = &document.layers[..] else { panic!("{name} has {} layers", document.layers.len()) };
        assert_eq!(layer.tone.is_some(), name == TONE, "{name}");
        assert_eq!(layer.system.name(), if name == TONE { "auto" } else { name });
    }
}

#[test]
fn every_system_grows_the_stored_px_and_bits() {
    let mut wrong = Vec::new();
    let mut patterns = "# Patterns of the documents in kinds, by name: FNV-1a of the bits of all px; then px at 0, 1/4, 1/2, 3/4 of\n\
                        # the list and the last one as bits=value.\n"
        .to_owned();
    for name in names() {
        let grown = grown(name);
        let pattern = grown.pattern(0).unwrap();
        patterns.push_str(&format!("{name} {}\n", bits(&pattern.values)));
        let size = [pattern.width, pattern.height];
        wrong.extend(compare_picture("kinds", name, size, &grown.rgb()));
    }
    assert!(wrong.is_empty(), "{}\nIf that is meant: REGENERATE=1", wrong.join("\n"));
    same_lines("patterns.txt", &patterns);
}
