//! The JSON Schema of documents against the reader.

mod broken;
mod validator;

use crate::documents::document as random;
use crate::on_large_stack;
use broken::breaks;
use dapple_engine::document;
use dapple_engine::document::Document;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use validator::Schema;

fn schema() -> Schema {
    Schema(serde_json::from_str(&document::schema()).expect("the schema is JSON"))
}

/// Valid documents, always the same ones.
fn documents(count: usize) -> Vec<Value> {
    let rng = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let mut runner = TestRunner::new_with_rng(Config::default(), rng);
    let strategy = random([8, 2_000], 3);
    let one = |_| {
        let made = strategy.new_tree(&mut runner).expect("a document").current();
        serde_json::from_str(&made.to_json()).expect("JSON")
    };
    (0..count).map(one).collect()
}

/// The documents below a folder of the project.
fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path()) {
        if entry.is_dir() {
            files(&entry, found);
        } else if entry.extension().is_some_and(|ending| ending == "dapple") {
            found.push(entry);
        }
    }
}

#[test]
fn every_example_is_allowed_by_the_schema() {
    let (schema, mut found) = (schema(), Vec::new());
    files(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples"), &mut found);
    assert!(found.len() > 100, "{}", found.len());
    for path in found {
        let text = fs::read_to_string(&path).expect("a document");
        let value: Value = serde_json::from_str(&text).expect("JSON");
        assert!(schema.allows(&value), "{}", path.display());
    }
}

#[test]
fn a_thousand_random_documents_are_allowed_by_the_schema() {
    on_large_stack(|| {
        let schema = schema();
        for value in documents(1_000) {
            assert!(schema.allows(&value), "{value:#}");
        }
    });
}

#[test]
fn what_the_schema_refuses_the_reader_refuses() {
    on_large_stack(|| {
        let schema = schema();
        let (mut tried, mut kinds) = (0, std::collections::BTreeSet::new());
        for (index, value) in documents(300).iter().enumerate() {
            let all = breaks(&schema, &schema.0, value, "");
            // Another one of each document: a stride that has no common factor with usual numbers of breaks.
            let chosen = all.iter().skip(index * 7 % all.len()).step_by(1 + all.len() / 5);
            for broken in chosen {
                let wrong = broken.applied(value);
                let refused = !schema.allows(&wrong);
                // A value of another branch may be allowed, such as a number in place of "drawn".
                if refused {
                    let read = Document::parse(&wrong.to_string(), "x");
                    assert!(read.is_err(), "{}: {:?} is read", broken.place, broken.value);
                    tried += 1;
                    kinds.insert(broken.place.replace(|c: char| c.is_ascii_digit(), ""));
                }
            }
        }
        assert!(tried >= 200 && kinds.len() >= 60, "only {tried} documents broken at {} places", kinds.len());
    });
}
