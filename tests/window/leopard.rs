//! The tutorial `docs/leopard.md`: from an empty canvas to a leopard. The page shows the stored pictures.

use std::sync::Arc;

use dapple::app::Window;
use dapple::document::{After, Kind};
use egui::{Key, Modifiers};

use crate::hand::{Hand, hand};
use crate::sights::see;

/// Applies these colours, and waits until the picture has them, also the picture of the frozen layers under the sketch.
fn recolour(hand: &mut Hand, preset: &str) {
    let image = |window: &Window| window.growth().picture.as_ref().map(|picture| Arc::clone(&picture.image));
    let before = image(hand.window.state());
    hand.reach(preset);
    hand.until("repainted", |window| image(window) != before && !window.is_painting_frozen_layers());
}

#[test]
fn from_an_empty_canvas_to_a_leopard() {
    let mut hand = hand();
    for (center, degrees) in [
        ([170.0, 212.0], 25.0),
        ([254.0, 177.0], 19.0),
        ([243.0, 260.0], 21.0),
        ([179.0, 290.0], 25.0),
        ([241.0, 335.0], 18.0),
    ] {
        hand.draw_round(center, [21.0, 19.0], degrees);
    }
    hand.until_settled();
    hand.window.state_mut().hide_times();
    // Nothing is selected, so that the sizes and directions between marks are shown.
    hand.key(Modifiers::NONE, Key::Escape);
    see(&mut hand, "leopard-1");

    hand.press("Freeze layer and start the next");
    hand.press("How it grows");
    hand.press("Grows: Around");
    hand.type_into("Line width", "7.5");
    hand.drag(&[[300.0, 300.0], [340.0, 310.0], [380.0, 320.0], [410.0, 330.0]]);
    hand.type_into("Broken", "35");
    hand.until_settled();
    hand.window.state_mut().hide_times();
    see(&mut hand, "leopard-2");

    hand.press("Colour");
    recolour(&mut hand, "Colours: leopard");
    hand.press("Layer layer 1, 5 ellipses, frozen");
    recolour(&mut hand, "Colours: jaguar");
    hand.window.state_mut().hide_times();
    see(&mut hand, "leopard-3");

    hand.press("Result");
    hand.press("Layer layer 2, 1 line");
    hand.until_settled();
    hand.rest();
    hand.window.state_mut().hide_times();
    see(&mut hand, "leopard-4");

    let document = hand.document();
    let [middles, rings] = &document.layers[..] else { panic!("{} layers", document.layers.len()) };
    assert!(middles.strokes.iter().all(|stroke| stroke.kind() == Some(Kind::Ellipse)));
    assert_eq!((rings.after, rings.strokes.len()), (After::Around, 1));
    assert!((rings.options.broken - 0.35).abs() < 1e-9);
    assert!(middles.colours.is_some() && rings.colours.is_some());
    // Every step can be undone.
    for _ in 0..60 {
        hand.key(Modifiers::COMMAND, Key::Z);
    }
    assert!(hand.document().layers.is_empty());
}
