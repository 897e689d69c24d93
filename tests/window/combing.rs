//! The direction of the hair of a finish, combed on the sketch.

use dapple::document::{Document, Finish, FinishKind, FlowChoice, Layer, Stroke};
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;

use crate::hand::{hand, hand_with};

/// A spot with this finish.
fn spot(kind: FinishKind) -> Document {
    let spot = Stroke::ellipse([60.0, 60.0], [14.0, 10.0], 20.0);
    let finish = Some(Finish::new(kind).into());
    Document { finish, ..Document::new([160, 128]).with_layer(Layer::new([spot])) }
}

#[test]
fn a_drag_combs_hair_and_another_one_with_alt_erases_it() {
    let (mut hand, _folder, _) = hand_with(&spot(FinishKind::Fur));
    let before = hand.document();
    hand.press("Comb");
    hand.drag(&[[130.0, 20.0], [90.0, 24.0], [30.0, 40.0]]);
    hand.drag(&[[130.0, 100.0], [30.0, 100.0]]);
    let flow = hand.document().finish.expect("a finish").flow;
    let FlowChoice::Strokes(strokes) = &flow else { panic!("{flow:?}") };
    let first = strokes[0].mark().and_then(|mark| mark.path()).expect("a path").points[0];
    assert_eq!(strokes.len(), 2);
    assert!((first[0] - 130.0).abs() < 1.0 && (first[1] - 20.0).abs() < 1.0, "{first:?}");
    assert_eq!(hand.document().layers, before.layers, "no mark is drawn");
    hand.drag_with(&[[80.0, 90.0], [80.0, 110.0]], Modifiers::ALT);
    assert_eq!(hand.document().finish.expect("a finish").flow.strokes(), 1);
    for _ in 0..3 {
        hand.key(Modifiers::COMMAND, Key::Z);
    }
    assert_eq!(hand.document(), before);
}

#[test]
fn strokes_of_hair_outlast_a_finish_without_a_direction() {
    let mut document = spot(FinishKind::Fur);
    let strokes = vec![Stroke::line([130.0, 20.0], [30.0, 30.0], 6.0)];
    document.finish.as_mut().unwrap().flow = FlowChoice::Strokes(strokes.clone());
    let (mut hand, _folder, _) = hand_with(&document);
    hand.press("Colour");
    for material in ["Cloth", "Fur"] {
        hand.window.get_by_label("Material of the texture").scroll_to_me();
        hand.window.run_steps(60);
        hand.click_role(Role::ComboBox, "Material of the texture");
        hand.rest();
        hand.press(material);
        hand.rest();
        let flow = hand.document().finish.expect("a finish").flow;
        assert_eq!(flow, FlowChoice::Strokes(strokes.clone()), "{material}");
    }
}

#[test]
fn only_hair_and_scales_have_a_comb() {
    let offered = |kind| hand_with(&spot(kind)).0.window.query_by_label("Comb").is_some();
    assert!(offered(FinishKind::FishScales) && !offered(FinishKind::Cloth));
    assert!(hand().window.query_by_label("Comb").is_none());
}

#[test]
fn a_coat_to_begin_with_brings_its_canvas_and_its_finish_and_is_undone() {
    let mut hand = hand();
    let before = hand.document();
    hand.press("Tiger fur");
    hand.rest();
    let after = hand.document();
    assert_eq!(after.size, [640, 640]);
    assert_eq!(after.finish.expect("a finish").finish.kind, FinishKind::Fur);
    hand.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(hand.document(), before);
}
