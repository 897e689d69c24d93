//! Any valid document grows or says why not, within bounded time and memory.
//!
//! Memory is held by the allocator of this program (`tests/fuzz/bodies/memory.rs`), time by the count of steps.

use crate::cases;
use crate::documents::document;
use dapple::internals::synth::grow;
use dapple::internals::synth::{GrowError, Options};
use proptest::prelude::*;

/// Steps on the finest grid that a layer may take (`synth::settle`), and a few on the way there.
const STEPS: u64 = 400_000;

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn any_valid_document_grows_or_says_why_not(document in document(48, 2)) {
        match grow(&document, &Options::default()) {
            Ok(grown) => {
                prop_assert_eq!(grown.layers.len(), document.layers.len());
                for layer in &grown.layers {
                    prop_assert!(layer.steps <= STEPS, "{} steps", layer.steps);
                    prop_assert!(layer.correction.iter().all(|factor| factor.is_finite() && *factor > 0.0));
                    let [width, height] = document.size.map(|side| side as usize);
                    let pattern = layer.pattern().field(width, height);
                    prop_assert_eq!(pattern.values.len(), width * height);
                    prop_assert!(pattern.values.iter().all(|value| value.is_finite()));
                }
            }
            Err(GrowError::Cancelled(_)) => prop_assert!(false, "nobody cancelled it"),
            Err(error) => {
                let message = error.to_string();
                prop_assert!(message.len() > 10 && !message.contains(char::is_control), "{:?}", message);
            }
        }
    }
}
