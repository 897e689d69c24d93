//! Advice if a picture or Turing's growth leaves no pattern.

use crate::synth::tone::plan::TonePlan;

/// The reason why there is nothing but marks (`full`), or none, and what to change.
#[must_use]
pub fn advice(plan: &TonePlan, full: bool) -> &'static str {
    match (plan.growth.is_empty(), full) {
        (true, true) => {
            "its picture asks for ink everywhere; take one with lighter places, or draw smaller marks"
        }
        (true, false) => {
            "its picture asks for hardly any ink; take one with darker places, or draw smaller marks"
        }
        (false, true) => "its growth is too high for any ground; lower it, or draw smaller marks",
        (false, false) => "its growth is too low for any dot; raise it, or draw smaller marks",
    }
}
