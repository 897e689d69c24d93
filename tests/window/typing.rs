//! Numbers that are typed for several marks and for regions; the grid to which marks snap; menus; the eyedropper.

use dapple::document::{Colours, Document, Stroke};
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;

use crate::clipboard::secondary;
use crate::hand::{Hand, hand, hand_with};

fn regions() -> (Hand, tempfile::TempDir) {
    let text = r#"{"format": "dapple", "version": 2, "size": [512, 512], "regions": [2, 2], "layers": [{"name": "a", "strokes": [
        {"kind": "ellipse", "center": [60, 60], "radii": [10, 10]},
        {"kind": "ellipse", "center": [120, 60], "radii": [10, 10]},
        {"kind": "ellipse", "center": [400, 400], "radii": [10, 10]}]}]}"#;
    let (hand, folder, _) = hand_with(&Document::parse(text, "regions").unwrap());
    (hand, folder)
}

#[test]
fn the_numbers_of_a_chosen_region_are_typed_and_its_marks_follow() {
    let (mut hand, _folder) = regions();
    hand.key(Modifiers::NONE, Key::V);
    hand.click([200.0, 200.0]);
    hand.window.get_by_label("Region 1, 1");
    hand.type_into("Spacing of the region", "90");
    let centers: Vec<f64> = hand.ellipses().iter().map(|ellipse| ellipse.center[0]).collect();
    assert!((centers[1] - centers[0] - 90.0).abs() < 0.1, "{centers:?}");
    assert!((centers[2] - 400.0).abs() < 1e-9, "the other region stays");
    hand.type_into("Mean area of the region", "100*2");
    assert!((hand.ellipses()[0].area() - 200.0).abs() < 0.1);
    assert!((hand.ellipses()[2].area() - 314.16).abs() < 0.1);
    hand.key(Modifiers::COMMAND, Key::Z);
    assert!((hand.ellipses()[0].area() - 314.16).abs() < 0.1, "one step");
    // Moving the pointer does not show another region.
    let at = hand.at([400.0, 100.0]);
    hand.window.hover_at(at);
    hand.rest();
    hand.window.get_by_label("Region 1, 1");
}

#[test]
fn the_spacing_of_selected_lines_is_typed() {
    let mut hand = hand();
    hand.key(Modifiers::NONE, Key::L);
    for y in [100.0, 120.0, 140.0] {
        hand.drag(&[[100.0, y], [200.0, y], [300.0, y]]);
    }
    hand.key(Modifiers::COMMAND, Key::A);
    hand.type_into("Line spacing of all", "20 + 10");
    let offsets: Vec<f64> = hand.lines().iter().map(|line| line.from[1]).collect();
    let apart: Vec<f64> = offsets.windows(2).map(|pair| pair[1] - pair[0]).collect();
    assert!(apart.iter().all(|apart| (apart - 30.0).abs() < 0.1), "{offsets:?}");
}

#[test]
fn drawn_and_moved_marks_snap_to_the_grid() {
    let mut hand = hand();
    hand.press("Canvas");
    hand.press("Snap to grid");
    hand.type_into("Distance of the grid lines", "20");
    hand.key(Modifiers::NONE, Key::L);
    hand.drag(&[[103.0, 98.0], [200.0, 150.0], [297.0, 204.0]]);
    assert_eq!((hand.lines()[0].from, hand.lines()[0].to), ([100.0, 100.0], [300.0, 200.0]));
    hand.key(Modifiers::NONE, Key::V);
    hand.drag(&[[200.0, 150.0], [220.0, 160.0], [233.0, 171.0]]);
    let center = hand.lines()[0].center();
    assert_eq!(center, [240.0, 180.0]);
}

#[test]
fn layers_and_stops_have_a_menu() {
    let (mut hand, _folder) = regions();
    let row = hand.window.get_by_label_contains("Layer a, 3 ellipses").rect();
    secondary(&mut hand, row.center());
    assert!(hand.window.query_by_label_contains("Rename layer").is_some(), "the menu is open");
    hand.key(Modifiers::NONE, Key::Escape);
    hand.press("Colour");
    let stops = |hand: &Hand| {
        let own = hand.document().layers[0].colours.clone();
        own.unwrap_or_else(|| Colours::default_for_layer(0)).stops.len()
    };
    let before = stops(&hand);
    let stop = hand.window.get_by_label_contains("Stop 2 of").rect();
    secondary(&mut hand, stop.center());
    // The button below the bar has the same name; an entry of the menu is wider.
    let entries = hand.window.query_all_by_label("Remove");
    let entry = entries.max_by(|a, b| a.rect().width().total_cmp(&b.rect().width())).unwrap();
    entry.click();
    hand.rest();
    assert_eq!(stops(&hand), before - 1);
}

#[test]
fn a_colour_is_taken_from_the_texture() {
    let (mut hand, _folder) = regions();
    hand.until_settled();
    hand.press("Colour");
    hand.click_label("Stop 1 of");
    hand.rest();
    let before = hand.strokes();
    hand.press("Take a colour from a picture");
    let texture = hand.window.get_by_label_contains("Texture, finished").rect();
    let marks = hand.at([60.0, 60.0]) - hand.canvas().min;
    let at = texture.min + marks;
    hand.window.hover_at(at);
    hand.window.step();
    hand.window.drag_at(at);
    hand.window.step();
    hand.window.drop_at(at);
    hand.rest();
    let stops = hand.document().layers[0].colours.clone().expect("it has colours of its own").stops;
    let ground = Colours::default_for_layer(0).stops[0].colour;
    assert!(stops[0].colour[0] < ground[0] - 60, "that of a mark, much darker than the ground: {stops:?}");
    assert_eq!(hand.strokes(), before, "nothing is drawn");
}

/// Draws a stroke of a pen with this pressure, from px to px of the canvas.
fn pen(hand: &mut Hand, path: &[[f64; 2]], force: f32) {
    let touch = |pos, phase| egui::Event::Touch {
        device_id: egui::TouchDeviceId(1),
        id: egui::TouchId(1),
        phase,
        pos,
        force: Some(force),
    };
    let path: Vec<egui::Pos2> = path.iter().map(|point| hand.at(*point)).collect();
    let button = |pos, pressed| egui::Event::PointerButton {
        pos,
        button: egui::PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    };
    hand.window.event(touch(path[0], egui::TouchPhase::Start));
    hand.window.event(egui::Event::PointerMoved(path[0]));
    hand.window.event(button(path[0], true));
    hand.window.step();
    for at in &path {
        hand.window.event(touch(*at, egui::TouchPhase::Move));
        hand.window.event(egui::Event::PointerMoved(*at));
        hand.window.step();
    }
    let last = path[path.len() - 1];
    hand.window.event(touch(last, egui::TouchPhase::End));
    hand.window.event(button(last, false));
    hand.rest();
}

#[test]
fn the_pressure_of_a_pen_sets_the_width_and_the_size_of_dabs() {
    let mut hand = hand();
    let line = |y: f64| [[100.0, y], [200.0, y], [300.0, y]];
    pen(&mut hand, &line(100.0), 1.0);
    pen(&mut hand, &line(200.0), 0.5);
    hand.drag(&line(300.0));
    let widths: Vec<f64> = hand.lines().iter().map(|line| line.width).collect();
    assert_eq!(widths, [12.0, 6.0, 6.0], "a mouse has the set width");
    hand.key(Modifiers::COMMAND | Modifiers::SHIFT, Key::N);
    hand.key(Modifiers::NONE, Key::E);
    pen(&mut hand, &[[100.0, 400.0], [100.0, 400.0]], 1.0);
    hand.click([200.0, 400.0]);
    let radii: Vec<f64> = hand.ellipses().iter().map(|ellipse| ellipse.radii[0]).collect();
    assert!((radii[0] / radii[1] - 2.0).abs() < 1e-6, "{radii:?}");
    hand.key(Modifiers::COMMAND, Key::Comma);
    hand.press("pressure sets the width");
    hand.press("Close");
    hand.key(Modifiers::NONE, Key::L);
    pen(&mut hand, &line(450.0), 1.0);
    assert_eq!(hand.lines().last().unwrap().width, 6.0, "it can be turned off");
}

#[test]
fn crossing_lines_are_moved_to_a_new_layer() {
    let mut hand = hand();
    hand.key(Modifiers::NONE, Key::L);
    hand.drag(&[[100.0, 200.0], [200.0, 200.0], [300.0, 200.0]]);
    hand.drag(&[[200.0, 100.0], [200.0, 200.0], [200.0, 300.0]]);
    hand.press("Grow stripes instead");
    hand.press("Move crossing lines to a new layer");
    hand.until("the lines are moved", |window| window.document().layers.len() == 2);
    let layers = hand.document().layers;
    assert_eq!(layers.iter().map(|layer| layer.strokes.len()).collect::<Vec<_>>(), [1, 1]);
    assert!(matches!(layers[1].strokes[0], Stroke::Line(line) if line.from[0] == line.to[0]));
    assert!(hand.window.query_by_label("Move crossing lines to a new layer").is_none());
}
