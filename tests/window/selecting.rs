//! Selecting, moving, resizing, turning, copying.

use egui::{Event, Key, Modifiers};

use crate::hand::{Hand, hand};

/// A window with ellipses of 40 × 20 px at these x, with the tool *Select*.
fn row(places: &[f64]) -> Hand {
    let mut hand = hand();
    hand.key(Modifiers::NONE, Key::E);
    for x in places {
        hand.drag(&[[x - 20.0, 190.0], [x + 20.0, 210.0]]);
    }
    hand.key(Modifiers::NONE, Key::V);
    hand
}

fn selected(hand: &Hand) -> usize {
    hand.window.state().session().selection.len()
}

#[test]
fn a_click_selects_one_and_shift_another() {
    let mut hand = row(&[100.0, 200.0, 300.0]);
    hand.click([100.0, 200.0]);
    assert_eq!(selected(&hand), 1);
    hand.drag_with(&[[200.0, 200.0], [200.0, 200.0]], Modifiers::SHIFT);
    assert_eq!(selected(&hand), 2);
    hand.click([400.0, 400.0]);
    assert_eq!(selected(&hand), 0);
}

#[test]
fn a_box_selects_the_marks_inside_it() {
    let mut hand = row(&[100.0, 200.0, 300.0]);
    hand.drag(&[[60.0, 150.0], [150.0, 200.0], [240.0, 250.0]]);
    assert_eq!(selected(&hand), 2);
}

#[test]
fn a_mark_is_moved_but_not_off_the_canvas() {
    let mut hand = row(&[100.0]);
    hand.drag(&[[100.0, 200.0], [150.0, 240.0], [180.0, 260.0]]);
    let moved = hand.ellipses()[0].center;
    assert!((moved[0] - 180.0).abs() < 0.1 && (moved[1] - 260.0).abs() < 0.1, "{moved:?}");
    hand.drag(&[[180.0, 260.0], [100.0, 260.0], [-60.0, 260.0]]);
    // One px of its radius of 20 px stays on the canvas.
    assert!((hand.ellipses()[0].center[0] + 19.0).abs() < 0.01, "{:?}", hand.ellipses()[0]);
}

#[test]
fn handles_resize_and_turn() {
    let mut hand = row(&[200.0]);
    hand.click([200.0, 200.0]);
    hand.drag(&[[220.0, 200.0], [230.0, 200.0], [250.0, 200.0]]);
    let ellipse = hand.ellipses()[0];
    assert!((ellipse.radii[0] - 50.0).abs() < 0.2 && (ellipse.radii[1] - 10.0).abs() < 0.2, "{ellipse:?}");
    // The handle for turning is 22 points beyond the end.
    let off = 22.0 / f64::from((hand.at([1.0, 0.0]) - hand.at([0.0, 0.0])).x);
    hand.drag(&[[250.0 + off, 200.0], [240.0, 240.0], [200.0, 300.0]]);
    assert!((hand.ellipses()[0].angle - 90.0).abs() < 0.5, "{:?}", hand.ellipses()[0]);
}

#[test]
fn several_are_scaled_by_their_box() {
    let mut hand = row(&[100.0, 200.0]);
    hand.key(Modifiers::COMMAND, Key::A);
    // The frame is 4 points larger than the marks in it.
    let off = 4.0 / f64::from((hand.at([1.0, 0.0]) - hand.at([0.0, 0.0])).x);
    hand.drag(&[[220.0 + off, 210.0 + off], [300.0, 220.0], [360.0, 230.0 + off]]);
    let [a, b] = hand.ellipses()[..] else { panic!() };
    assert!((a.radii[0] - 40.0).abs() < 1.5 && (a.radii[0] - b.radii[0]).abs() < 1e-3, "{a:?} {b:?}");
    assert!((b.center[0] - a.center[0] - 200.0).abs() < 8.0, "{a:?} {b:?}");
}

#[test]
fn numbers_are_typed() {
    let mut hand = row(&[100.0]);
    hand.click([100.0, 200.0]);
    hand.type_into("Centre x", "256.5");
    hand.type_into("Direction", "45");
    hand.type_into("Area", "500");
    let ellipse = hand.ellipses()[0];
    assert!((ellipse.center[0] - 256.5).abs() < 1e-9, "{ellipse:?}");
    assert!((ellipse.angle - 45.0).abs() < 1e-9, "{ellipse:?}");
    assert!((ellipse.area() - 500.0).abs() < 1e-6 && (ellipse.aspect() - 0.5).abs() < 0.02, "{ellipse:?}");
    hand.key(Modifiers::NONE, Key::Escape);
    hand.key(Modifiers::COMMAND, Key::Z);
    assert!((hand.ellipses()[0].area() - 500.0).abs() > 1.0);
}

#[test]
fn marks_are_copied_by_alt_drag_by_key_and_by_the_clipboard() {
    let mut hand = row(&[100.0]);
    hand.drag_with(&[[100.0, 200.0], [150.0, 240.0], [200.0, 300.0]], Modifiers::ALT);
    assert_eq!(hand.ellipses().len(), 2);
    hand.key(Modifiers::COMMAND, Key::D);
    assert_eq!(hand.ellipses().len(), 3);
    hand.key(Modifiers::COMMAND, Key::A);
    hand.window.event(Event::Copy);
    hand.window.step();
    let copied = hand.window.output().platform_output.commands.iter().find_map(|command| match command {
        egui::OutputCommand::CopyText(text) => Some(text.clone()),
        _ => None,
    });
    hand.window.event(Event::Paste(copied.expect("something was copied")));
    hand.rest();
    assert_eq!(hand.ellipses().len(), 6);
    assert_eq!(selected(&hand), 3);
    hand.window.event(Event::Paste("no marks".to_owned()));
    hand.rest();
    assert!(hand.window.state().notices()[0].wrong);
    assert_eq!(hand.ellipses().len(), 6);
}

#[test]
fn a_deleted_selection_can_be_restored() {
    let mut hand = row(&[100.0, 200.0, 300.0]);
    let before = hand.document();
    hand.key(Modifiers::COMMAND, Key::A);
    hand.key(Modifiers::NONE, Key::Delete);
    assert!(hand.strokes().is_empty());
    hand.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(hand.document(), before);
    hand.key(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    assert!(hand.strokes().is_empty());
}

#[test]
fn a_copy_is_made_by_ctrl_drag_and_none_by_a_click() {
    let mut hand = row(&[100.0]);
    hand.drag_with(&[[100.0, 200.0], [150.0, 240.0], [200.0, 300.0]], Modifiers::COMMAND);
    assert_eq!(hand.ellipses().len(), 2);
    hand.drag_with(&[[100.0, 200.0], [100.0, 200.0]], Modifiers::ALT);
    assert_eq!(hand.ellipses().len(), 2, "it would lie on its original");
}

#[test]
fn marks_are_pasted_at_the_pointer_and_never_exactly_on_identical_marks() {
    let mut hand = row(&[100.0]);
    hand.click([100.0, 200.0]);
    let text = hand.window.state().session().copy().unwrap();
    let at = hand.at([300.0, 350.0]);
    for _ in 0..3 {
        hand.window.hover_at(at);
        hand.window.event(Event::Paste(text.clone()));
        hand.rest();
    }
    let places: Vec<[f64; 2]> = hand.ellipses().iter().map(|ellipse| ellipse.center).collect();
    assert!((places[1][0] - 300.0).abs() < 0.5 && (places[1][1] - 350.0).abs() < 0.5, "{places:?}");
    for (index, place) in places.iter().enumerate() {
        let is_double = |other: &[f64; 2]| (other[0] - place[0]).hypot(other[1] - place[1]) < 1.0;
        assert!(!places[..index].iter().any(is_double), "{places:?}");
    }
}

#[test]
fn the_pen_draws_again_after_all_marks_were_selected_and_deleted() {
    let mut hand = hand();
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    hand.key(Modifiers::COMMAND, Key::A);
    hand.key(Modifiers::NONE, Key::Delete);
    hand.draw_round([300.0, 200.0], [40.0, 20.0], 30.0);
    assert_eq!(hand.ellipses().len(), 1);
}

#[test]
fn arithmetic_is_typed_into_number_fields() {
    let mut hand = row(&[100.0]);
    hand.click([100.0, 200.0]);
    hand.type_into("Centre x", "20*1.5 + 10");
    hand.type_into("Radius along", "2.54 cm / 10");
    hand.type_into("Direction", "90/2");
    let ellipse = hand.ellipses()[0];
    assert!((ellipse.center[0] - 40.0).abs() < 1e-9 && (ellipse.angle - 45.0).abs() < 1e-9, "{ellipse:?}");
    assert!((ellipse.radii[0] - 30.0).abs() < 1e-9, "{ellipse:?}");
}

#[test]
fn attributes_of_a_selection_are_typed_and_the_marks_follow() {
    let mut hand = row(&[100.0, 200.0, 300.0]);
    hand.key(Modifiers::COMMAND, Key::A);
    hand.type_into("Spacing of all", "50");
    let xs: Vec<f64> = hand.ellipses().iter().map(|ellipse| ellipse.center[0]).collect();
    for (found, wanted) in xs.iter().zip([150.0, 200.0, 250.0]) {
        assert!((found - wanted).abs() < 0.2, "{xs:?}");
    }
    hand.type_into("Aspect of all", "0.8");
    hand.type_into("Direction of all", "30");
    for ellipse in hand.ellipses() {
        assert!(
            (ellipse.aspect() - 0.8).abs() < 1e-6 && (ellipse.major_angle() - 30.0).abs() < 1e-6,
            "{ellipse:?}"
        );
        let area = std::f64::consts::PI * 200.0;
        assert!((ellipse.area() / area - 1.0).abs() < 0.02, "the area stays: {ellipse:?}");
    }
    hand.click([200.0, 200.0]);
    hand.type_into("Aspect", "0.5");
    assert!((hand.ellipses()[1].aspect() - 0.5).abs() < 1e-6);
}
