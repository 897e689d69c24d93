//! Keys, the wheel and menus do what users of other programs expect.

use dapple::ReadFile;
use dapple::app::{Settings, Start, Wheel};
use dapple::document::Document;
use egui::accesskit::Role;
use egui::{
    Event, Key, Modifiers, MouseWheelSource, MouseWheelUnit, Theme, TouchPhase, Vec2, ViewportCommand, vec2,
};
use egui_kittest::kittest::Queryable;

use crate::documents::drop_file;
use crate::hand::{Hand, hand, with};

/// Whether the tools, the right column, and the status line are shown.
fn panels(hand: &Hand) -> [bool; 3] {
    let is = |name: &str| hand.window.query_by_role_and_label(Role::Button, name).is_some();
    [is("Eraser"), is("Result"), hand.window.query_by_label_contains("Draw with the pointer").is_some()]
}

#[test]
fn tab_hides_the_panels_while_the_pointer_is_used_and_shows_them_again() {
    let mut hand = hand();
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    assert_eq!(panels(&hand), [true; 3]);
    let narrow = hand.canvas().width();
    hand.key(Modifiers::NONE, Key::Tab);
    assert_eq!(panels(&hand), [false; 3]);
    assert!(hand.canvas().width() > narrow);
    hand.draw_round([300.0, 200.0], [40.0, 20.0], 30.0);
    assert_eq!(hand.ellipses().len(), 2, "the canvas stays usable");
    hand.key(Modifiers::NONE, Key::Tab);
    assert_eq!(panels(&hand), [true; 3]);
    hand.key(Modifiers::NONE, Key::Tab);
    hand.key(Modifiers::NONE, Key::F9);
    assert_eq!(panels(&hand), [true; 3], "F9 asks for a panel");
}

#[test]
fn tab_goes_from_control_to_control_while_they_are_chosen_with_the_keyboard() {
    let mut hand = hand();
    hand.key(Modifiers::NONE, Key::Tab);
    assert_eq!(panels(&hand), [true; 3], "the pointer was not used yet");
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    hand.key(Modifiers::SHIFT, Key::Tab);
    hand.key(Modifiers::NONE, Key::Tab);
    assert_eq!(panels(&hand), [true; 3]);
}

#[test]
fn f11_fills_the_screen() {
    let mut hand = hand();
    // In the frame whose output is read: an event that is queued has a frame of its own.
    hand.window.input_mut().events.push(Event::Key {
        key: Key::F11,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers: Modifiers::NONE,
    });
    let asked = (0..4).any(|_| {
        hand.window.step();
        let output = hand.window.output().viewport_output.values();
        output
            .flat_map(|output| &output.commands)
            .any(|command| *command == ViewportCommand::Fullscreen(true))
    });
    assert!(asked);
}

#[test]
fn alt_and_a_letter_open_a_menu_and_choose_no_tool() {
    for (key, entry) in
        [(Key::E, "Undo"), (Key::L, "New layer"), (Key::V, "Zoom in"), (Key::H, "About dapple")]
    {
        let mut hand = hand();
        hand.key(Modifiers::ALT, key);
        assert!(hand.window.query_all_by_label_contains(entry).next().is_some(), "{key:?}");
        hand.key(Modifiers::NONE, Key::Escape);
        hand.drag(&[[100.0, 100.0], [200.0, 140.0], [300.0, 180.0]]);
        assert_eq!(hand.lines().len(), 1, "{key:?}: Freehand is still chosen");
    }
}

/// Turns the wheel over the middle of the canvas.
fn wheel(hand: &mut Hand, delta: Vec2) {
    let at = hand.canvas().center();
    hand.window.hover_at(at);
    hand.window.step();
    let (unit, phase, modifiers) = (MouseWheelUnit::Point, TouchPhase::Move, Modifiers::NONE);
    let source = MouseWheelSource::Wheel;
    hand.window.event(Event::MouseWheel { unit, delta, phase, modifiers, source });
    hand.window.run_steps(30);
}

#[test]
fn the_wheel_moves_the_view_or_zooms_as_the_preference_says() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("settings");
    let start = Start { settings: Settings::read(&file), ..Start::default() };
    let mut hand = with(start, vec2(1280.0, 800.0), Theme::Light);
    let [(center, zoom), _] = hand.window.state().views();
    wheel(&mut hand, vec2(0.0, 60.0));
    let [(moved, same), _] = hand.window.state().views();
    assert!(moved != center && same == zoom);
    hand.key(Modifiers::COMMAND, Key::Comma);
    hand.press("zooms");
    hand.press("Close");
    wheel(&mut hand, vec2(0.0, 60.0));
    let [(_, larger), (_, linked)] = hand.window.state().views();
    assert!(larger > 1.1 * zoom && linked == larger, "{zoom} {larger}");
    assert_eq!(Settings::read(&file).wheel, Wheel::Zoom);
}

#[test]
fn the_scale_of_the_interface_is_chosen_and_remembered() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("settings");
    let start = || Start { settings: Settings::read(&file), ..Start::default() };
    let mut hand = with(start(), vec2(1280.0, 800.0), Theme::Light);
    hand.key(Modifiers::COMMAND, Key::Comma);
    hand.click_role(Role::ComboBox, "Scale of the interface");
    hand.rest();
    hand.press("150 %");
    assert_eq!(hand.window.ctx.zoom_factor(), 1.5);
    hand.press("Close");
    let again = with(start(), vec2(1280.0, 800.0), Theme::Light);
    assert_eq!(again.window.ctx.zoom_factor(), 1.5);
}

#[test]
fn recent_documents_are_listed_with_their_folder_and_open() {
    let folder = tempfile::tempdir().unwrap();
    let start = Start { settings: Settings::read(&folder.path().join("settings")), ..Start::default() };
    let mut hand = with(start, vec2(1280.0, 800.0), Theme::Light);
    let zebra = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/zebra.dapple");
    drop_file(&mut hand, zebra.as_ref());
    hand.key(Modifiers::COMMAND, Key::N);
    hand.press("Create");
    hand.press("File");
    let entry = hand.window.get_by_label_contains("Open recent").rect().center();
    hand.window.hover_at(entry);
    hand.window.run_steps(30);
    hand.rest();
    let name = format!("zebra.dapple, {}/examples", env!("CARGO_MANIFEST_DIR"));
    hand.press(&name);
    assert_eq!(hand.document(), Document::read(zebra).unwrap());
}

#[test]
fn a_colour_is_typed_by_its_name() {
    let mut hand = hand();
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    hand.press("Colour");
    let field = hand.window.query_all_by_role(Role::TextInput).next().unwrap().rect().center();
    hand.window.hover_at(field);
    hand.window.step();
    hand.click_field(field);
    hand.key(Modifiers::COMMAND, Key::A);
    hand.window.event(Event::Text("Tan".to_owned()));
    hand.window.step();
    hand.key(Modifiers::NONE, Key::Enter);
    let colours = hand.document().layers[0].colours.clone().unwrap();
    assert!(colours.stops.iter().any(|stop| stop.colour == [210, 180, 140]), "{colours:?}");
}
