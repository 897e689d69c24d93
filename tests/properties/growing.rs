//! Any valid document grows or says why not, within bounded time and memory.
//!
//! The allocator of this program (`tests/fuzz/bodies/memory.rs`) limits memory; the count of steps limits time.

use crate::cases;
use crate::documents::document;
use dapple::document::{AreaKind, Document};
use dapple_engine::synth::{GrowError, Grown, Growth, Options};
use proptest::prelude::*;
use proptest::test_runner::{RngAlgorithm, TestRng, TestRunner};
use std::cell::Cell;

/// Steps on the finest grid that a layer may take (`synth::settle`), and a few on the way there.
const STEPS: u64 = 400_000;

/// Share of the valid documents that must grow; some find no room or nothing to go around, and some would be all ground or
/// all marks on so small a canvas. Of 160 random ones 73 grew; of fewer, the share differs by chance: of the first 64 of these 22.
const GROWN: f64 = 0.4;

#[test]
fn any_valid_document_grows_or_says_why_not() {
    grown_of(TestRunner::new(cases(16)));
}

/// The same documents in each run: of a few random ones less than half might grow.
#[test]
fn most_valid_documents_grow() {
    let config = cases(160);
    let asked = config.cases;
    let grown = grown_of(TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::ChaCha)));
    assert!(f64::from(grown) >= GROWN * f64::from(asked), "only {grown} of {asked} grew");
}

/// Grows random documents, checks each result, and counts those that grew.
fn grown_of(mut runner: TestRunner) -> u32 {
    let grown = Cell::new(0);
    let outcome = runner.run(&document(48, 2), |document| {
        match Growth::begin(&document, &Options::default(), None).run() {
            Ok(texture) => {
                grown.set(grown.get() + 1);
                sound(&document, &texture)
            }
            Err(GrowError::Cancelled(_)) => Err(TestCaseError::fail("nobody cancelled it")),
            Err(error) => {
                let message = error.to_string();
                let readable = message.len() > 10 && !message.contains(char::is_control);
                prop_assert!(readable, "{:?}", message);
                Ok(())
            }
        }
    });
    outcome.unwrap_or_else(|error| panic!("{error}"));
    grown.get()
}

/// A grown texture has all layers, was grown within the limit of steps, and is finite everywhere.
fn sound(document: &Document, grown: &Grown) -> Result<(), TestCaseError> {
    prop_assert_eq!(grown.layers.len(), document.layers.len());
    for layer in &grown.layers {
        // Nothing reacts in patches, streaks, cracks and fields of points.
        prop_assert_eq!(
            layer.steps() > 0,
            layer.lines().is_none()
                && layer.points().is_none()
                && layer.areas().is_none_or(|areas| areas.plan.kind() == AreaKind::Cells)
        );
        prop_assert!(layer.steps() <= STEPS, "{} steps", layer.steps());
        if let Some(marks) = layer.marks() {
            prop_assert!(marks.correction.iter().all(|factor| factor.is_finite() && *factor > 0.0));
        }
        let [width, height] = document.size.map(|side| side as usize);
        let pattern = layer.pattern().field(width, height);
        prop_assert_eq!(pattern.values.len(), width * height);
        prop_assert!(pattern.values.iter().all(|value| value.is_finite()));
    }
    Ok(())
}
