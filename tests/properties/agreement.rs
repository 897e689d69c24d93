//! A document that is valid for `dapple check` grows, except for reasons that only growing shows; and no picture is
//! blank without a note.

use crate::documents::{document, wild_document};
use crate::growing::{Reasons, runner};
use crate::on_large_stack;
use dapple_engine::document::Document;
use dapple_engine::synth::check::check;
use dapple_engine::synth::time::TimeLimit;
use dapple_engine::synth::{Grown, Options};
use proptest::prelude::*;
use std::cell::{Cell, RefCell};

/// The name of the documents in messages.
const FILE: &str = "a.dapple";
/// Bytes of memory that a growth may use: about 300,000 cells, which grow within seconds. Documents that need more are
/// refused.
const MEMORY: f64 = 0.1e9;
/// Longest side of a canvas, px.
const MOST: u32 = 400;
/// Range of the sides of the canvases of documents whose parts suit each other, px.
const SIDES: [u32; 2] = [48, 256];
/// The largest share of the documents that `check` accepts and growing refuses, rounded up to a whole document.
const LATE: f64 = 0.02;

#[test]
fn documents_that_check_accepts_grow_except_for_reasons_that_only_growing_shows() {
    on_large_stack(|| {
        let (valid, refused, late) =
            (Cell::new(0_u32), RefCell::<Reasons>::default(), RefCell::<Reasons>::default());
        let documents = prop_oneof![wild_document(MOST, 3), document(SIDES, 3)];
        let outcome = runner(6).run(&documents, |document| {
            let options =
                Options { source: FILE, memory: Some(MEMORY), time: TimeLimit::Usual, ..Options::default() };
            if document.check(FILE).is_err() {
                return Ok(());
            }
            let checked = match check(&document, &options) {
                Ok(checked) => checked.refusal,
                Err(error) => Some(error),
            };
            match (checked.map(|error| error.to_string()), document.grow_with(&options)) {
                (None, Ok(grown)) => {
                    valid.set(valid.get() + 1);
                    is_noted_where_it_is_of_one_colour(&document, &grown)?;
                }
                (None, Err(error)) => {
                    valid.set(valid.get() + 1);
                    let message = error.to_string();
                    prop_assert!(error.is_shown_by_growing(), "{}", message);
                    prop_assert!(message.starts_with("a.dapple: layer "), "{}", message);
                    late.borrow_mut().add(&message);
                }
                (Some(message), Ok(_)) => prop_assert!(false, "grows, and is refused: {}", message),
                (Some(message), Err(error)) => {
                    prop_assert_eq!(&message, &error.to_string());
                    prop_assert!(message.starts_with("a.dapple: lay"), "{}", message);
                    refused.borrow_mut().add(&message);
                }
            }
            Ok(())
        });
        outcome.unwrap_or_else(|error| panic!("{error}"));
        let (valid, refused, late) = (valid.get(), refused.into_inner(), late.into_inner());
        println!(
            "{valid} are valid for check, which refuses\n{refused}\nof the valid ones growing refuses\n{late}"
        );
        assert!(
            valid > 0 && f64::from(late.all()) <= (LATE * f64::from(valid)).ceil(),
            "of {valid}:\n{late}"
        );
    });
}

/// Asserts that a picture of one colour has a note that says so and gives the remedy.
fn is_noted_where_it_is_of_one_colour(document: &Document, grown: &Grown) -> Result<(), TestCaseError> {
    let rgb = grown.rgb();
    let (px, _) = rgb.as_chunks::<3>();
    if px.iter().any(|other| *other != px[0]) {
        return Ok(());
    }
    let report = grown.report();
    let mut notes = report.layers.iter().flat_map(|layer| &layer.notes);
    prop_assert!(notes.any(|note| note.contains("everywhere")), "{}", document.to_json());
    Ok(())
}
