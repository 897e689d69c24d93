//! What coats have beyond their marks, set in the window: halo, second colour of the ground, warp, mottling, marks near those beneath.

use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;

use crate::hand::{Hand, hand_with};
use dapple::app::GrowthState;
use dapple::document::{After, Document, Finish, FinishKind, Layer, LayerMap, MapKey, Stroke, Warp};

/// A canvas with a spot, and a smaller one on a second layer.
fn document() -> Document {
    let layer = |radius: f64| Layer::new([Stroke::ellipse([40.0, 40.0], [radius, radius], 0.0)]);
    let ground = LayerMap::noise(MapKey::Ground);
    Document::new([120, 120]).with_layer(layer(9.0)).with_layer(layer(5.0).with_map(MapKey::Ground, ground))
}

fn type_number(hand: &mut Hand, field: &str, text: &str) {
    hand.window.get_by_role_and_label(Role::SpinButton, field).scroll_to_me();
    hand.window.run_steps(60);
    hand.type_into(field, text);
    hand.rest();
}

#[test]
fn the_ground_the_warp_and_the_mottling_are_set_in_the_tab_of_colours_and_undone() {
    let mut start = document();
    start.finish = Some(Finish::new(FinishKind::Fur).into());
    let (mut hand, _folder, _) = hand_with(&start);
    hand.press("Colour");
    hand.until_settled();
    type_number(&mut hand, "Halo", "0.3");
    let colours = |hand: &Hand| hand.document().layers[1].colours.clone().expect("colours of its own");
    assert_eq!(colours(&hand).halo, 0.3);
    assert!(hand.window.query_by_label("Second colour of the ground").is_some());
    hand.reach("Halo: default");
    assert_eq!(colours(&hand).halo, 1.0);
    type_number(&mut hand, "Mottling", "12");
    assert_eq!(hand.document().finish.expect("a finish").finish.mottle, 0.12);
    hand.reach("Bend the marks");
    hand.rest();
    assert_eq!(hand.document().warp, Some(Warp::USUAL));
    assert!(matches!(hand.growth_state(), GrowthState::Settled(_)), "{:?}", hand.growth_state());
    type_number(&mut hand, "Displacement of the warp", "90");
    assert_eq!(hand.document().warp, Some(Warp { by: 0.2 * Warp::USUAL.size, ..Warp::USUAL }));
    for _ in 0..2 {
        hand.key(Modifiers::COMMAND, Key::Z);
    }
    assert_eq!(hand.document().warp, None);
}

#[test]
fn a_layer_above_another_grows_near_its_marks_as_far_as_one_sets() {
    let (mut hand, _folder, _) = hand_with(&document());
    hand.press("How it grows");
    hand.reach("Grows: Near");
    hand.rest();
    assert_eq!(hand.document().layers[1].after, After::Near);
    type_number(&mut hand, "Near", "40");
    assert_eq!(hand.document().layers[1].options.near, 40.0);
    hand.reach("Grows: Between");
    hand.rest();
    let layer = &hand.document().layers[1];
    assert_eq!((layer.after, layer.options.near), (After::Between, 24.0), "what has no meaning goes");
}
