//! Outcomes as JSON.

use super::outcome::{Of, Outcome, verdict};
use crate::learn::Errors;
use serde_json::{Map, Value, json};

/// `{"outcomes": [...]}`, one for each line of the printed table, with unrounded numbers and their bounds.
pub fn outcomes(outcomes: &[Outcome]) -> Value {
    json!({"outcomes": outcomes.iter().map(outcome).collect::<Vec<_>>()})
}

fn outcome(outcome: &Outcome) -> Value {
    let errors = |errors: &Errors| {
        let Errors { quantity, unit, count, median, p95 } = errors;
        let mut entry = Map::new();
        for (key, value) in [("unit", json!(unit)), ("count", json!(count)), ("median", json!(median))] {
            entry.insert(key.to_owned(), value);
        }
        entry.insert("p95".to_owned(), json!(p95));
        if let Some([median, p95]) = outcome.bound(quantity) {
            entry.insert("allowed".to_owned(), json!({"median": median, "p95": p95}));
            entry.insert("verdict".to_owned(), json!(verdict(outcome.holds(errors))));
        }
        ((*quantity).to_owned(), Value::Object(entry))
    };
    let mut entry = json!({
        "system": outcome.system,
        "errors": outcome.of.name(),
        "method": outcome.way,
        "rows": outcome.rows,
        "all": outcome.all,
        "asked": outcome.asked,
        "quantities": outcome.errors.iter().map(errors).collect::<Map<_, _>>(),
    });
    if outcome.of == Of::Grown {
        entry["failed"] = json!(outcome.failed);
        if let holds @ Some(_) = outcome.none_failed() {
            entry["verdict"] = json!(verdict(holds));
        }
    }
    entry
}
