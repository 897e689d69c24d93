//! Sweeps of systems of pairs, with small patches.

use dapple::files::TrainingFolder;
use dapple_engine::learn::PairSet;
use dapple_engine::rd::pairs::PairKind;
use dapple_engine::synth::PairReason;
use serde_json::{Value, json};

use crate::plan::Plan;
use crate::sweep::whole;

/// A plan with one set of pairs.
fn of_pairs(set: &str, runs: u64) -> Plan {
    let mut plan = Plan::built_in().unwrap().chosen(&[set.to_owned()], Some(runs)).unwrap();
    plan.sets[0].patch.grown = if set == "cells" { 40.0 } else { 10.0 };
    plan.sets[0].patch.least = 6.0;
    plan
}

#[test]
fn a_set_of_pairs_is_swept_and_learnt_from() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(whole(&of_pairs("stucco", 32), folder.path()), Ok(32));
    let (system, known) = (PairKind::Stucco.description(), [PairKind::Stucco.description()]);
    let set = PairSet::load(&TrainingFolder::new(folder.path()), system, &known).unwrap().expect("a set");
    assert_eq!(set.rows().len(), 32);
    // Dots are thinner than the law says, worms are not.
    let [worms, dots] = [0.05, 0.7].map(|decay| set.ask(1, &[decay]).values[0]);
    assert!((0.93..1.05).contains(&worms) && (0.7..0.87).contains(&dots), "{worms} {dots}");
    let manifest: Value =
        serde_json::from_str(&std::fs::read_to_string(folder.path().join("stucco.json")).unwrap()).unwrap();
    assert_eq!(
        (&manifest["counts"]["accepted"], &manifest["counts"]["rejected"]["broken"]),
        (&json!(32), &json!(0))
    );
}

#[test]
fn runs_of_pairs_that_are_not_as_drawn_are_rejected_with_their_reason() {
    let mut plan = of_pairs("weave", 4);
    // Three directions of which two leave too little room for the first.
    let s = &mut plan.sets[0].sweep;
    s.directions.as_mut().unwrap().range = [3.0, 3.0];
    s.duty.as_mut().unwrap().range = [0.12, 0.12];
    s.others.as_mut().unwrap().range = [0.4, 0.42];
    s.unequal.as_mut().unwrap().range = [0.25, 0.3];
    let folder = tempfile::tempdir().unwrap();
    whole(&plan, folder.path()).unwrap();
    let rejected = std::fs::read_to_string(folder.path().join("weave.rejected.csv")).unwrap();
    let known = |line: &str| PairReason::KINDS.iter().any(|kind| line.contains(&format!(",{kind},\"")));
    assert!(rejected.lines().count() > 1 && rejected.lines().skip(1).all(known), "{rejected}");
    assert!(rejected.starts_with("seed,directions,duty,others,unequal,between,direction,reason,detail\n"));
}

#[test]
fn a_set_of_pairs_has_the_quantities_of_its_system_and_no_others() {
    let message = |set: &str, change: &dyn Fn(&mut Value)| {
        let mut plan = serde_json::to_value(of_pairs(set, 5)).unwrap();
        change(&mut plan["sets"][0]);
        Plan::from_json(&plan).unwrap_err()
    };
    let error = message("maze", &|set| set["sweep"]["duty"] = set["sweep"]["level"].clone());
    assert!(error.contains("sweep.duty: maze has no duty; it has directions"), "{error}");
    let error = message("cells", &|set| drop(set["sweep"].as_object_mut().unwrap().remove("sparse")));
    assert!(error.contains("sweep.sparse: it is missing; cells needs"), "{error}");
    let error = message("stucco", &|set| set["sweep"]["decay"]["range"] = json!([0, 0.99]));
    assert!(error.contains("sweep.decay.range: 0.99 is not from 0 to 0.85"), "{error}");
    let error = message("stucco", &|set| set["sweep"]["stretch"] = set["sweep"]["decay"].clone());
    assert!(error.contains("sweep.stretch: stucco has no stretch"), "{error}");
    let error = message("weave", &|set| set["patch"]["unit"] = json!("spots"));
    assert!(error.contains("patch.unit: it is 'periods', not 'spots'"), "{error}");
}
