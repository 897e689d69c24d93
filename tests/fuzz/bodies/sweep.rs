//! Fuzz body for the files of a sweep: the plan in a manifest, and the journal of a sweep that was stopped.

use data_gen::journal::Part;
use data_gen::plan::Plan;
use std::path::Path;

use crate::refusal::assert_readable;

const FILE: &str = "bad.json";

/// `bytes` are a plan or are refused, and are a journal or are refused.
pub fn holds(bytes: &[u8]) {
    if let Ok(text) = std::str::from_utf8(bytes) {
        match Plan::parse(text, FILE) {
            Ok(plan) => {
                let value = serde_json::to_value(&plan).expect("a plan is written");
                assert_eq!(Plan::from_json(&value).expect("what is written is read"), plan);
                for set in &plan.sets {
                    for run in [0, set.runs - 1] {
                        let drawn = set.parameters_of(run);
                        assert!(drawn.named().iter().all(|(_, value)| value.is_finite()), "{drawn:?}");
                        assert!(drawn.rate > 0.0 && drawn.stretch > 0.0, "{drawn:?}");
                    }
                }
            }
            Err(error) => assert_readable(&error, FILE),
        }
    }
    match Part::parse(Path::new("bad.journal"), bytes) {
        Ok(part) => {
            for record in &part.records {
                let set = &part.plan.sets[record.set];
                assert!(record.index < set.runs && part.shard.holds(record.index), "{record:?}");
            }
        }
        Err(error) => assert_readable(&error, "bad.journal"),
    }
}
