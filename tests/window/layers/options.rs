//! How a layer grows: its relation to those beneath, its system, its options.

use dapple::document::{After, DutyChoice, Seeding, SpreadChoice, SystemChoice};
use dapple_engine::rd::System;
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};

use super::{choose, two, undo};

#[test]
fn the_relation_to_the_layers_beneath_is_chosen_by_a_picture() {
    let mut hand = two();
    hand.press("How it grows");
    for (name, after) in [("Around", After::Around), ("Net", After::Net), ("Between", After::Between)] {
        hand.press(&format!("Grows: {name}"));
        assert_eq!(hand.document().layers[1].after, after);
    }
    // A layer of lines has no spots that could grow inside others.
    hand.press("Grows: Inside");
    assert_eq!(hand.document().layers[1].after, After::Between);
    // The lowest layer has no relation to choose.
    hand.press("Layer layer 1, 2 ellipses");
    let net = hand.window.get_by_role_and_label(Role::Button, "Grows: Net");
    assert!(net.accesskit_node().is_disabled());
    undo(&mut hand);
    assert_eq!(hand.document().layers[1].after, After::Net);
}

#[test]
fn a_system_is_chosen_and_reset() {
    let mut hand = two();
    hand.press("How it grows");
    choose(&mut hand, "System", "Meinhardt's lines");
    assert_eq!(hand.document().layers[1].system, SystemChoice::Of(System::MEINHARDT_LINES.description()));
    // Systems that grow spots are disabled.
    hand.click_role(Role::ComboBox, "System");
    hand.rest();
    let spots = hand.window.get_by_role_and_label(Role::Button, "Turing's spots");
    assert!(spots.accesskit_node().is_disabled());
    hand.key(Modifiers::NONE, Key::Escape);
    assert!(hand.window.query_by_role_and_label(Role::Button, "Turing's spots").is_none());
    hand.press("System: default");
    assert_eq!(hand.document().layers[1].system, SystemChoice::Auto);
    undo(&mut hand);
    assert_eq!(hand.document().layers[1].system, SystemChoice::Of(System::MEINHARDT_LINES.description()));
}

#[test]
fn options_of_stripes() {
    let mut hand = two();
    hand.press("How it grows");
    hand.press("Stripe width as drawn");
    hand.type_into("Stripe width", "30");
    assert_eq!(hand.document().layers[1].options.duty, DutyChoice::Given(0.3));
    hand.type_into("Stripe width", "90");
    assert_eq!(hand.document().layers[1].options.duty, DutyChoice::Given(0.82));
    hand.type_into("Stripe width", "50");
    assert_eq!(hand.document().layers[1].options.duty, DutyChoice::Given(0.5));
    choose(&mut hand, "Starts from", "Drawn lines");
    assert_eq!(hand.document().layers[1].options.seeding, Seeding::Initiators);
    hand.reach("Starts from: default");
    assert_eq!(hand.document().layers[1].options.seeding, Seeding::Noise);
    let kept = hand.document().keeps_marks(1);
    hand.window.get_by_role_and_label(Role::CheckBox, "Keep marks").scroll_to_me();
    hand.window.run_steps(60);
    hand.press("Keep marks");
    assert_eq!(hand.document().layers[1].options.keep, Some(!kept));
    hand.reach("Keep marks: default");
    assert_eq!(hand.document().layers[1].options.keep, None);
    hand.press("Grows: Around");
    hand.type_into("Broken", "25");
    assert_eq!(hand.document().layers[1].options.broken, 0.25);
    undo(&mut hand);
    assert_eq!(hand.document().layers[1].options.broken, 0.0);
    hand.document().check("what was chosen").unwrap();
}

#[test]
fn shapes_of_stripes() {
    let mut hand = two();
    hand.press("How it grows");
    hand.window.get_by_role_and_label(Role::SpinButton, "Varying").scroll_to_me();
    hand.window.run_steps(60);
    hand.type_into("Varying", "40");
    hand.type_into("Doubled", "25");
    let options = &hand.document().layers[1].options;
    assert_eq!((options.vary, options.double), (0.4, 0.25));
    hand.type_into("Varying", "95");
    assert_eq!(hand.document().layers[1].options.vary, 0.8);
    hand.reach("Varying: default");
    assert_eq!(hand.document().layers[1].options.vary, 0.0);
    hand.document().check("what was chosen").unwrap();
}

#[test]
fn options_of_spots() {
    let mut hand = two();
    hand.press("Layer layer 1, 2 ellipses");
    hand.press("How it grows");
    hand.type_into("Irregular", "40");
    assert_eq!(hand.document().layers[0].options.irregular, 0.4);
    choose(&mut hand, "Variation", "By numbers");
    for (name, value) in [("area", "30"), ("spacing", "10"), ("aspect", "5"), ("direction", "20")] {
        hand.type_into(&format!("Variation of {name}"), value);
    }
    let SpreadChoice::Given(spread) = hand.document().layers[0].options.spread else { panic!() };
    assert_eq!([spread.area, spread.spacing, spread.aspect, spread.angle], [0.3, 0.1, 0.05, 20.0]);
    hand.press("Variation: default");
    assert_eq!(hand.document().layers[0].options.spread, SpreadChoice::Drawn);
    // A system without irregular spots resets that option.
    choose(&mut hand, "System", "Meinhardt's spots");
    assert_eq!(hand.document().layers[0].options.irregular, 0.0);
    undo(&mut hand);
    assert_eq!(hand.document().layers[0].options.irregular, 0.4);
}
