//! The fuzz targets as ordinary tests: they run on all seeds and on damaged ones.
//!
//! `docs/fuzzing.md` describes how libFuzzer runs the same bodies, guided by coverage.

#[path = "bodies/document.rs"]
mod document;
#[path = "bodies/embedded.rs"]
mod embedded;
#[path = "bodies/kept.rs"]
mod kept;
#[path = "bodies/memory.rs"]
mod memory;
#[path = "bodies/model.rs"]
mod model;
mod mutations;
#[path = "bodies/palette.rs"]
mod palette;
#[path = "bodies/picture.rs"]
mod picture;
#[path = "bodies/questions.rs"]
mod questions;
#[path = "bodies/refusal.rs"]
mod refusal;
#[path = "bodies/svg.rs"]
mod svg;
#[path = "bodies/training.rs"]
mod training;

use mutations::Seeds;
use proptest::test_runner::{Config, TestRunner};
use std::path::Path;

/// Runs `holds` on each seed of `target`, then on `cases` damaged ones.
fn tried(target: &str, cases: u32, holds: fn(&[u8])) {
    let seeds = Seeds::for_target(&Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fuzz"), target);
    for (name, bytes) in &seeds.files {
        println!("{name}");
        holds(bytes);
    }
    let config = Config { failure_persistence: None, ..Config::with_cases(cases) };
    let ran = TestRunner::new(config).run(&seeds.damaged(), |bytes| {
        holds(&bytes);
        Ok(())
    });
    ran.unwrap_or_else(|error| panic!("{target}: {error}"));
}

#[test]
fn any_document_is_read_and_planned_or_refused() {
    tried("document", 400, document::holds);
}

#[test]
fn any_training_set_is_read_and_answers_or_is_refused() {
    tried("training", 400, training::holds);
}

#[test]
fn any_svg_is_read_or_refused() {
    tried("svg", 400, svg::holds);
}

#[test]
fn any_picture_is_measured_or_refused() {
    tried("picture", 300, picture::holds);
}

#[test]
fn any_picture_gives_back_its_document_or_is_refused() {
    tried("embedded", 400, embedded::holds);
}

#[test]
fn any_palette_is_read_or_refused() {
    tried("palette", 1_000, palette::holds);
}

#[test]
fn any_table_of_questions_is_answered_or_refused() {
    tried("questions", 200, questions::holds);
}

#[test]
fn any_model_is_read_and_prepared_or_refused() {
    tried("model", 600, model::holds);
}
