//! Views: zoom, pan, one over the other or side by side, touch.

use dapple::ReadFile;
use dapple::document::Document;
use egui::{
    Event, Key, Modifiers, MouseWheelSource, MouseWheelUnit, TouchDeviceId, TouchId, TouchPhase,
    ViewportCommand, ViewportEvent, ViewportId, vec2,
};
use egui_kittest::kittest::Queryable;

use crate::hand::{Hand, hand, hand_with};

fn wheel(hand: &mut Hand, at: [f64; 2], by: f32, modifiers: Modifiers) {
    let at = hand.at(at);
    hand.window.hover_at(at);
    hand.window.event(Event::ModifiersChanged(modifiers));
    let delta = vec2(0.0, by);
    let (unit, phase) = (MouseWheelUnit::Point, TouchPhase::Move);
    let source = MouseWheelSource::Wheel;
    hand.window.event(Event::MouseWheel { unit, delta, phase, modifiers, source });
    hand.window.run_steps(20);
    hand.window.event(Event::ModifiersChanged(Modifiers::NONE));
    hand.rest();
}

#[test]
fn the_wheel_zooms_around_the_pointer_in_both_views() {
    let mut hand = hand();
    let before = hand.at([100.0, 150.0]);
    wheel(&mut hand, [100.0, 150.0], 200.0, Modifiers::COMMAND);
    let [(center, zoom), texture] = hand.window.state().views();
    assert!(zoom > 1.2 && center != [256.0, 256.0], "{zoom} {center:?}");
    assert!(before.distance(hand.at([100.0, 150.0])) < 0.5, "what is under the pointer stays");
    assert_eq!(texture, (center, zoom));

    hand.press("Canvas");
    hand.press("Link both views");
    wheel(&mut hand, [100.0, 150.0], -60.0, Modifiers::NONE);
    let [sketch, apart] = hand.window.state().views();
    assert_ne!(sketch, apart);
    hand.key(Modifiers::COMMAND, Key::Num0);
    let [sketch, texture] = hand.window.state().views();
    assert_eq!(sketch, texture);
}

#[test]
fn a_mark_is_drawn_at_the_pointer_at_any_zoom() {
    let mut hand = hand();
    wheel(&mut hand, [300.0, 300.0], 300.0, Modifiers::COMMAND);
    hand.key(Modifiers::NONE, Key::E);
    hand.drag(&[[290.0, 290.0], [300.0, 300.0], [310.0, 300.0]]);
    let ellipse = hand.ellipses()[0];
    assert!((ellipse.center[0] - 300.0).abs() < 0.1 && (ellipse.radii[1] - 5.0).abs() < 0.1, "{ellipse:?}");
}

#[test]
fn two_fingers_move_the_view_and_draw_nothing() {
    let mut hand = hand();
    let [a, b] = [hand.at([100.0, 100.0]), hand.at([200.0, 100.0])];
    let touch = |id, phase, pos| Event::Touch {
        device_id: TouchDeviceId(0),
        id: TouchId(id),
        phase,
        pos,
        force: None,
    };
    hand.window.event(touch(1, TouchPhase::Start, a));
    hand.window.drag_at(a);
    hand.window.step();
    hand.window.hover_at(a + vec2(8.0, 0.0));
    hand.window.event(touch(1, TouchPhase::Move, a + vec2(8.0, 0.0)));
    hand.window.step();
    hand.window.event(touch(2, TouchPhase::Start, b));
    hand.window.step();
    for step in 1..10 {
        let by = vec2(0.0, 6.0 * step as f32);
        hand.window.event(touch(1, TouchPhase::Move, a + by));
        hand.window.event(touch(2, TouchPhase::Move, b + by));
        hand.window.hover_at(a + by);
        hand.window.step();
    }
    hand.window.event(touch(1, TouchPhase::End, a));
    hand.window.event(touch(2, TouchPhase::End, b));
    hand.window.drop_at(a);
    hand.rest();
    assert!(hand.strokes().is_empty());
    assert_ne!(hand.window.state().views()[0].0, [256.0, 256.0]);
}

#[test]
fn pointing_at_a_region_shows_its_attributes() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/turning-spots.dapple");
    let (mut hand, ..) = hand_with(&Document::read(file).unwrap());
    let there = hand.at([50.0, 400.0]);
    hand.window.hover_at(there);
    hand.rest();
    assert!(hand.window.query_by_label("Region 1, 2").is_some());
    assert!(hand.window.query_by_label("Mean area of the region").is_some());
}

#[test]
fn the_sketch_under_the_texture_can_be_drawn_on() {
    let mut hand = hand();
    hand.press("Texture over the sketch");
    hand.draw_round([120.0, 200.0], [40.0, 20.0], 30.0);
    assert_eq!(hand.ellipses().len(), 1);
}

#[test]
fn a_window_with_unsaved_work_asks_before_it_closes() {
    let mut hand = hand();
    hand.draw_round([120.0, 200.0], [40.0, 20.0], 30.0);
    let root = hand.window.input_mut().viewports.entry(ViewportId::ROOT).or_default();
    root.events.push(ViewportEvent::Close);
    hand.window.step();
    let commands = &hand.window.output().viewport_output[&ViewportId::ROOT].commands;
    assert!(commands.contains(&ViewportCommand::CancelClose), "{commands:?}");
    hand.window.input_mut().viewports.entry(ViewportId::ROOT).or_default().events.clear();
    hand.rest();
    assert!(hand.window.query_by_label("Don't save").is_some());
    hand.press("Cancel");
    assert_eq!(hand.ellipses().len(), 1);
}

#[test]
fn a_stroke_over_the_texture_is_visible_while_it_is_drawn() {
    let mut hand = hand();
    hand.draw_round([120.0, 200.0], [40.0, 20.0], 30.0);
    hand.until_settled();
    hand.press("Texture over the sketch");
    hand.key(Modifiers::NONE, Key::L);
    hand.key(Modifiers::NONE, Key::Escape);
    let [from, to] = [hand.at([330.0, 250.0]), hand.at([480.0, 250.0])];
    let before = hand.window.render().unwrap();
    hand.window.hover_at(from);
    hand.window.step();
    hand.window.drag_at(from);
    hand.window.hover_at(to);
    hand.window.step();
    hand.window.step();
    let drawn = hand.window.render().unwrap();
    let on_line = hand.at([400.0, 250.0]);
    let at = |picture: &image::RgbaImage| *picture.get_pixel(on_line.x as u32, on_line.y as u32);
    assert_ne!(at(&before), at(&drawn), "the line is painted over the texture");
    hand.window.drop_at(to);
    hand.rest();
    assert_eq!(hand.lines().len(), 1);
}
