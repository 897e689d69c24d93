//! The picture under the canvas belongs to the document that it was put under.

use std::path::PathBuf;
use std::sync::Arc;

use egui::{Color32, ColorImage, Event, Key, Modifiers};

use crate::documents::drop_file;
use crate::hand::{Hand, hand};

/// A window with a mark and a picture of one colour.
fn with_picture() -> Hand {
    let mut hand = hand();
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    paste(&mut hand, Color32::RED);
    assert!(hand.window.state().has_reference());
    hand
}

fn paste(hand: &mut Hand, colour: Color32) {
    hand.window.event(Event::PasteImage(Arc::new(ColorImage::filled([64, 32], colour))));
    hand.rest();
}

#[test]
fn removing_the_reference_picture_is_undone_and_redone() {
    let mut hand = with_picture();
    hand.press("Canvas");
    let place = hand.window.state().reference();
    hand.press("Remove");
    assert!(!hand.window.state().has_reference());
    hand.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(hand.window.state().reference(), place, "it is back where it was");
    assert_eq!(hand.strokes().len(), 1, "the mark stays");
    hand.key(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    assert!(!hand.window.state().has_reference());
}

#[test]
fn a_move_of_the_reference_picture_and_another_picture_are_steps_to_undo() {
    let mut hand = with_picture();
    hand.press("Canvas");
    hand.press("Lock");
    let before = hand.window.state().reference();
    hand.drag(&[[400.0, 300.0], [420.0, 310.0], [440.0, 320.0]]);
    let moved = hand.window.state().reference();
    assert_ne!(moved, before);
    hand.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(hand.window.state().reference(), before);
    hand.key(Modifiers::COMMAND, Key::Z);
    assert!(!hand.window.state().has_reference(), "there was none before");
}

#[test]
fn another_document_does_not_get_the_reference_picture() {
    let mut hand = with_picture();
    drop_file(&mut hand, &PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("examples/zebra.dapple"));
    hand.press("Don't save");
    assert!(!hand.window.state().has_reference());
    hand.key(Modifiers::COMMAND, Key::Z);
    assert!(!hand.window.state().has_reference());
}
