//! The window, operated by pointer and keys like a user does.
#![cfg(feature = "app")]

mod access;
mod aiming;
mod alternatives;
mod clipboard;
mod coats;
mod colour;
mod columns;
mod combing;
mod documents;
mod drawing;
mod exporting;
mod free_marks;
mod glance;
mod goals;
mod growing;
mod habits;
mod hand;
mod history;
mod importing;
mod keyboard;
mod layers;
mod leopard;
mod links;
mod opening;
mod outlines;
mod preferences;
mod recovery;
mod reference;
mod result;
mod selecting;
mod sights;
mod typing;
mod views;

use proptest::test_runner::Config;

/// This number of random cases, or the number in `PROPTEST_CASES` (`.ci/property`).
fn cases(usual: u32) -> Config {
    let asked = std::env::var("PROPTEST_CASES").ok().and_then(|text| text.parse().ok());
    Config::with_cases(asked.unwrap_or(usual))
}
