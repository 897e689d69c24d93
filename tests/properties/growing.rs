//! Any valid document grows or is refused with a reason, within bounded time and memory.
//!
//! The allocator of this program (`tests/fuzz/bodies/memory.rs`) limits memory; the count of steps limits time.

use crate::documents::{any_document, document};
use crate::{cases, on_large_stack};
use dapple_engine::document::{After, AreaKind, Document, SystemChoice};
use dapple_engine::synth::{GrowError, Grown};
use proptest::prelude::*;
use proptest::test_runner::{RngAlgorithm, TestRng, TestRunner};
use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, BTreeSet};

/// The most steps on the finest grid that a layer may take (`synth::settle`), and a few more on coarser grids.
const STEPS: u64 = 400_000;

/// Sides of the canvases, px.
const SIDES: [u32; 2] = [48, 256];

/// The least share of the random documents that must be valid.
const VALID: f64 = 0.8;

/// The least share of the valid documents that must grow; the others have no room, or nothing to grow around.
const GROWN: f64 = 0.9;

/// A test runner with fixed random numbers; `DAPPLE_SEED` chooses others.
pub fn runner(usual: u32) -> TestRunner {
    let seed = std::env::var("DAPPLE_SEED").ok().and_then(|text| text.parse().ok()).unwrap_or(0_u64);
    let mut bytes = [0; 32];
    bytes[..8].copy_from_slice(&seed.to_le_bytes());
    TestRunner::new_with_rng(cases(usual), TestRng::from_seed(RngAlgorithm::ChaCha, &bytes))
}

/// Grows a document; all growths of this test use this function.
fn grown(document: &Document) -> Result<Grown, GrowError> {
    document.grow()
}

#[test]
fn any_valid_document_grows_or_is_refused_with_a_reason() {
    on_large_stack(|| {
        Count::default().grow_all(TestRunner::new(cases(8)));
    });
}

#[test]
fn most_documents_are_valid_and_these_contain_every_system_and_after() {
    on_large_stack(|| {
        let mut runner = runner(2_000);
        let (cases, refused) = (runner.config().cases, RefCell::new(Reasons::default()));
        let names = RefCell::new(BTreeSet::new());
        let outcome = runner.run(&any_document(SIDES, 2), |document| {
            match document.check("x") {
                Err(error) => refused.borrow_mut().add(&error.to_string()),
                Ok(()) => names
                    .borrow_mut()
                    .extend(document.layers.iter().map(|layer| [layer.system.name(), layer.after.name()])),
            }
            Ok(())
        });
        outcome.unwrap_or_else(|error| panic!("{error}"));
        let refused = refused.into_inner();
        let valid = cases - refused.all();
        println!("{valid} of {cases} are valid\n{refused}");
        assert!(
            f64::from(valid) >= VALID * f64::from(cases),
            "only {valid} of {cases} are valid:\n{refused}"
        );
        let names: BTreeSet<&str> = names.into_inner().into_iter().flatten().collect();
        let systems = SystemChoice::names().into_iter().map(|(name, _)| name);
        let all: BTreeSet<&str> = systems.chain(After::NAMES.into_iter().map(|(name, _)| name)).collect();
        assert_eq!(names, all);
    });
}

#[test]
fn most_valid_documents_grow() {
    on_large_stack(|| {
        let runner = runner(40);
        let (cases, mut count) = (runner.config().cases, Count::default());
        count.grow_all(runner);
        let (grown, refused) = (count.grown.get(), count.refused.into_inner());
        println!("{grown} of {cases} grew\n{refused}");
        assert!(f64::from(grown) >= GROWN * f64::from(cases), "only {grown} of {cases} grew:\n{refused}");
    });
}

/// Refusals by their message, with each number replaced by `#`.
#[derive(Default)]
pub struct Reasons(BTreeMap<String, u32>);

impl Reasons {
    pub fn add(&mut self, message: &str) {
        let mut words = String::new();
        for c in message.chars() {
            match c {
                '0'..='9' if words.ends_with('#') => {}
                '0'..='9' => words.push('#'),
                _ => words.push(c),
            }
        }
        *self.0.entry(words.replace("#.#", "#")).or_default() += 1;
    }

    pub fn all(&self) -> u32 {
        self.0.values().sum()
    }
}

impl std::fmt::Display for Reasons {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let mut reasons: Vec<_> = self.0.iter().collect();
        reasons.sort_by_key(|(_, count)| std::cmp::Reverse(**count));
        reasons.into_iter().try_for_each(|(reason, count)| writeln!(f, "{count:6} {reason}"))
    }
}

/// The results of random documents.
#[derive(Default)]
struct Count {
    grown: Cell<u32>,
    refused: RefCell<Reasons>,
}

impl Count {
    /// Grows random valid documents, and checks each result.
    fn grow_all(&mut self, mut runner: TestRunner) {
        let outcome = runner.run(&document(SIDES, 2), |document| match grown(&document) {
            Ok(texture) => {
                self.grown.set(self.grown.get() + 1);
                sound(&document, &texture)
            }
            Err(GrowError::Cancelled(_)) => Err(TestCaseError::fail("nobody cancelled it")),
            Err(error) => {
                let message = error.to_string();
                let readable = message.len() > 10 && !message.contains(char::is_control);
                prop_assert!(readable, "{:?}", message);
                self.refused.borrow_mut().add(&message);
                Ok(())
            }
        });
        outcome.unwrap_or_else(|error| panic!("{error}"));
    }
}

/// Asserts that a grown texture has all layers, was grown within the limit of steps, and is finite everywhere.
fn sound(document: &Document, grown: &Grown) -> Result<(), TestCaseError> {
    prop_assert_eq!(grown.layers.len(), document.layers.len());
    for layer in &grown.layers {
        // There is no reaction in patches, streaks, cracks and fields of points.
        prop_assert_eq!(
            layer.steps() > 0,
            layer.lines().is_none()
                && layer.points().is_none()
                && layer.areas().is_none_or(|areas| areas.plan.kind() == AreaKind::Polygons)
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
