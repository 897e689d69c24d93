//! Checks documents of every version, in their original form: they can be opened, keep their meaning, and grow.
//!
//! `versions/VERSION-WHAT.dapple`; those with a name are from this repository's history, as they were first committed.
//! They are never edited: a version that can no longer be read needs a migration, not another file.

use crate::folder::Folder;
use crate::renew::golden;
use dapple::ReadFile;
use dapple::document::{Document, DocumentError};
use dapple_engine::synth::Growth;
use dapple_engine::synth::Options;
use serde_json::{Value, json};
use std::path::PathBuf;

/// The version that dapple writes.
fn newest() -> u64 {
    let written: Value = serde_json::from_str(&all()[0].1.to_json()).unwrap();
    written["version"].as_u64().unwrap()
}

/// The kept documents with their files, by name.
fn all() -> Vec<(PathBuf, Document)> {
    let entries = std::fs::read_dir(golden("versions")).unwrap();
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    files.sort();
    let read = |file: PathBuf| {
        let document = Document::read(&file).unwrap_or_else(|error| panic!("{error}"));
        (file, document)
    };
    files.into_iter().map(read).collect()
}

#[test]
fn a_document_of_every_version_is_kept() {
    let versions: Vec<u64> = all()
        .iter()
        .map(|(file, _)| {
            let text: Value = serde_json::from_slice(&std::fs::read(file).unwrap()).unwrap();
            let named = file.file_name().unwrap().to_str().unwrap().split('-').next().unwrap().to_owned();
            assert_eq!(text["version"].to_string(), named, "{}", file.display());
            text["version"].as_u64().unwrap()
        })
        .collect();
    for version in 1..=newest() {
        assert!(versions.contains(&version), "keep one of version {version} in tests/golden/versions");
    }
}

/// The places where `written` differs from `read`; keys that `read` does not have are not compared.
fn lost(at: &str, read: &Value, written: &Value) -> Vec<String> {
    match (read, written) {
        (Value::Object(read), Value::Object(written)) => {
            let there = |key| written.get(key).unwrap_or(&Value::Null);
            read.iter().flat_map(|(key, value)| lost(&format!("{at}.{key}"), value, there(key))).collect()
        }
        (Value::Array(read), Value::Array(written)) if read.len() == written.len() => {
            read.iter().zip(written).flat_map(|(read, written)| lost(at, read, written)).collect()
        }
        _ if read == written || read.as_f64().is_some_and(|read| Some(read) == written.as_f64()) => {
            Vec::new()
        }
        _ => vec![format!("{at}: {read} → {written}")],
    }
}

#[test]
fn the_content_of_a_document_is_kept_when_it_is_written() {
    for (file, document) in all() {
        let read: Value = serde_json::from_slice(&std::fs::read(&file).unwrap()).unwrap();
        let written: Value = serde_json::from_str(&document.to_json()).unwrap();
        let mut lost = lost("", &read, &written);
        if read["version"] == json!(1) {
            // Open freehand strokes were lines in that version.
            let migrated =
                [".version", ".layers.strokes.kind: \"freehand\" → \"line\"", ".layers.strokes.points"];
            lost.retain(|lost| !migrated.iter().any(|start| lost.starts_with(start)));
        }
        assert!(lost.is_empty(), "{}: {lost:?}", file.display());
        assert_eq!(Document::parse(&document.to_json(), "again").unwrap(), document, "{}", file.display());
    }
}

#[test]
fn documents_of_every_version_grow() {
    for (file, document) in all() {
        let name = file.display().to_string();
        let small = document.size.map(|side| side.min(256));
        let options = Options { size: Some(small), refine: Some(false), source: &name, ..Options::default() };
        let grown = Growth::begin(&document, &options, None).run();
        let grown = grown.unwrap_or_else(|error| panic!("{name}: {error}"));
        for layer in &grown.layers {
            let pattern = layer.pattern().field(small[0] as usize, small[1] as usize);
            let marked = pattern.values.iter().filter(|value| **value > 0.5).count();
            assert!(marked > 20 && marked < pattern.values.len() * 4 / 5, "{name}: {marked} px of marks");
        }
    }
}

#[test]
fn a_document_of_a_later_version_is_refused_with_the_remedy() {
    let later = newest() + 1;
    let text =
        json!({"format": "dapple", "version": later, "size": [64, 64], "shape": "round", "layers": []});
    let error = Document::parse(&text.to_string(), "new.dapple").unwrap_err();
    assert!(matches!(error, DocumentError::Newer { .. }), "{error}");
    let output = error.to_string();
    for word in ["new.dapple", &format!("version: found {later}"), "newer dapple reads it"] {
        assert!(output.contains(word), "{word} in {output}");
    }
    // The same check through the command line.
    let folder = Folder::with(&text.to_string());
    for command in ["check a.dapple", "grow a.dapple -o a.png", "film a.dapple -o a.gif"] {
        let message = folder.refused(command);
        assert!(message.contains("a.dapple") && message.contains("newer"), "{message}");
    }
    assert_eq!(folder.files().len(), 1);
}

#[test]
fn a_key_that_no_version_has_is_named_with_its_place() {
    let (_, document) = &all()[0];
    let mut text: Value = serde_json::from_str(&document.to_json()).unwrap();
    text["layers"][0]["softness"] = json!(1);
    let output = Document::parse(&text.to_string(), "a.dapple").unwrap_err().to_string();
    assert!(output.contains("layers[0]") && output.contains("softness"), "{output}");
}
