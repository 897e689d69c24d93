//! The clipboard: marks, SVG and pictures are pasted, the texture is copied.

use std::sync::Arc;

use dapple::document::{Ellipse, Stroke};
use egui::{Color32, ColorImage, Event, Key, Modifiers, OutputCommand, PointerButton};
use egui_kittest::kittest::Queryable;

use crate::hand::{Hand, hand};

const SVG: &str = "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='60'>\
    <ellipse cx='20' cy='30' rx='10' ry='6' fill='black'/><ellipse cx='60' cy='30' rx='10' ry='6' fill='black'/></svg>";

fn paste(hand: &mut Hand, event: Event) {
    hand.window.event(event);
    hand.rest();
}

/// A click of the secondary button at a position on the screen.
pub fn secondary(hand: &mut Hand, pos: egui::Pos2) {
    hand.window.hover_at(pos);
    hand.window.step();
    for pressed in [true, false] {
        let (button, modifiers) = (PointerButton::Secondary, Modifiers::NONE);
        hand.window.event(Event::PointerButton { pos, button, pressed, modifiers });
        hand.window.step();
    }
    hand.rest();
}

#[test]
fn the_marks_of_a_pasted_svg_are_added_at_the_pointer() {
    let mut hand = hand();
    hand.key(Modifiers::NONE, Key::E);
    hand.drag(&[[400.0, 400.0], [440.0, 420.0]]);
    let at = hand.at([200.0, 150.0]);
    hand.window.hover_at(at);
    hand.window.step();
    paste(&mut hand, Event::Paste(SVG.to_owned()));
    let centers: Vec<[f64; 2]> = hand.ellipses().iter().map(|ellipse| ellipse.center).collect();
    assert_eq!(centers.len(), 3, "what was drawn stays");
    assert!((centers[1][0] - 180.0).abs() < 0.5 && (centers[2][0] - 220.0).abs() < 0.5, "{centers:?}");
    assert!((centers[1][1] - 150.0).abs() < 0.5, "{centers:?}");
    assert_eq!(hand.window.state().session().selection.len(), 2);
    hand.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(hand.ellipses().len(), 1, "one step to undo");
    paste(&mut hand, Event::Paste("a shopping list".to_owned()));
    assert!(hand.window.state().notices().last().unwrap().text.contains("holds no marks"));
}

#[test]
fn a_pasted_picture_becomes_the_reference_and_is_moved_and_scaled_while_it_is_unlocked() {
    let mut hand = hand();
    let picture = ColorImage::filled([64, 64], Color32::RED);
    paste(&mut hand, Event::PasteImage(Arc::new(picture)));
    hand.press("Canvas");
    assert!(hand.window.state().has_reference());
    let place = |hand: &Hand| hand.window.state().reference().unwrap();
    let before = place(&hand);
    assert_eq!((before.center, before.scale), ([256.0, 256.0], 8.0));
    hand.key(Modifiers::NONE, Key::V);
    hand.drag(&[[100.0, 100.0], [120.0, 130.0], [140.0, 160.0]]);
    assert_eq!(place(&hand), before, "it is locked");
    hand.press("Lock");
    hand.drag(&[[100.0, 100.0], [120.0, 130.0], [140.0, 160.0]]);
    let moved = place(&hand);
    assert!((moved.center[0] - 296.0).abs() < 0.5 && (moved.center[1] - 316.0).abs() < 0.5, "{moved:?}");
    // Its upper left corner is then at (40, 60): half as large, scaled about the opposite corner.
    hand.drag(&[[40.0, 60.0], [150.0, 170.0], [296.0, 316.0]]);
    let scaled = place(&hand);
    assert!((scaled.scale - 4.0).abs() < 0.1, "{scaled:?}");
    hand.type_into("Picture scale", "200");
    assert!((place(&hand).scale - 2.0).abs() < 1e-9);
    assert!(hand.strokes().is_empty());
    hand.press("Remove");
    assert!(!hand.window.state().has_reference());
}

#[test]
fn a_drag_on_an_unlocked_picture_moves_the_mark_there_not_the_picture() {
    let mut hand = hand();
    hand.key(Modifiers::NONE, Key::E);
    hand.drag(&[[200.0, 200.0], [240.0, 220.0]]);
    paste(&mut hand, Event::PasteImage(Arc::new(ColorImage::filled([64, 64], Color32::RED))));
    hand.press("Canvas");
    hand.press("Lock");
    let before = hand.window.state().reference();
    hand.drag(&[[220.0, 210.0], [240.0, 230.0], [260.0, 250.0]]);
    let Stroke::Ellipse(Ellipse { center, .. }) = hand.strokes()[0] else { panic!() };
    assert!((center[0] - 260.0).abs() < 0.5, "{center:?}");
    assert_eq!(hand.window.state().reference(), before);
}

#[test]
fn the_finished_texture_is_copied_as_a_picture() {
    let mut hand = hand();
    hand.key(Modifiers::NONE, Key::E);
    hand.drag(&[[200.0, 200.0], [250.0, 230.0]]);
    hand.until_settled();
    hand.rest();
    // The window system gives a key for Ctrl+Shift+C, and an event of its own only for Ctrl+C.
    hand.window.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::C);
    hand.window.step();
    let mut copied = None;
    for _ in 0..2000 {
        let commands = &hand.window.output().platform_output.commands;
        copied = copied.or_else(|| {
            commands.iter().find_map(|command| match command {
                OutputCommand::CopyImage(image) => Some(image.size),
                _ => None,
            })
        });
        if copied.is_some() {
            break;
        }
        hand.wait_for_tasks();
        hand.window.step();
    }
    assert_eq!(copied, Some([512, 512]));
    let texture = hand.window.get_by_label_contains("Texture, finished").rect();
    secondary(&mut hand, texture.center());
    assert!(hand.window.query_by_label_contains("Export…").is_some());
}
