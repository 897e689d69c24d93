//! Colours: the bar, its stops, the curve between them, presets, palettes, copies.

mod gradient;

use std::fs;

use dapple::ReadFile;
use dapple::app::GrowthState;
use dapple::document::palette::Palette;
use dapple::document::{Colours, Document, FlowChoice};
use dapple_engine::colour::{Bend, Gradient, PRESETS};
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, PointerButton, Pos2, Rect, vec2};
use egui_kittest::kittest::{NodeT, Queryable};

use crate::hand::{Hand, hand_with};
use crate::sights::picture;

/// A small canvas with a spot or two layers of them, and the colours shown.
fn with_layers(layers: usize) -> (Hand, tempfile::TempDir) {
    let layer = r#"{"strokes": [{"kind": "ellipse", "center": [60, 60], "radii": [14, 9], "angle": 20}]}"#;
    let layers = vec![layer; layers].join(",");
    let text = format!(r#"{{"format": "dapple", "version": 1, "size": [160, 160], "layers": [{layers}]}}"#);
    let (mut hand, folder, _) = hand_with(&Document::parse(&text, "small").unwrap());
    hand.press("Colour");
    (hand, folder)
}

impl Hand {
    /// The colours of a layer in the document.
    fn colours(&self, layer: usize) -> Colours {
        self.document().layers[layer].colours.clone().unwrap_or_else(|| Colours::default_for_layer(layer))
    }

    /// The rectangle of the control whose name begins with this.
    #[track_caller]
    fn place(&self, name: &str) -> Rect {
        let found = self.window.query_all_by_label_contains(name).next();
        found.unwrap_or_else(|| panic!("no {name}")).rect()
    }

    /// Focuses the control whose name begins with this.
    #[track_caller]
    fn focus(&mut self, name: &str) {
        self.window.query_all_by_label_contains(name).next().unwrap_or_else(|| panic!("no {name}")).focus();
        self.rest();
    }

    /// Drags on the screen in a few steps; calls `then` before the release.
    fn pull(&mut self, from: Pos2, to: Pos2, then: impl FnOnce(&mut Self)) {
        self.window.hover_at(from);
        self.window.step();
        let button = |pos, pressed| Event::PointerButton {
            pos,
            button: PointerButton::Primary,
            pressed,
            modifiers: Modifiers::NONE,
        };
        self.window.event(button(from, true));
        self.window.step();
        for i in 1..=8 {
            self.window.hover_at(from + (to - from) * (i as f32 / 8.0));
            self.window.step();
        }
        then(self);
        self.window.event(button(to, false));
        self.rest();
    }

    fn tap(&mut self, at: Pos2) {
        self.pull(at, at, |_| {});
    }

    fn places(&self) -> Vec<f64> {
        self.colours(0).stops.iter().map(|stop| stop.at).collect()
    }
}

#[test]
fn a_preset_is_applied_and_shows_its_source() {
    let (mut hand, _folder) = with_layers(1);
    let zebra = PRESETS.iter().find(|preset| preset.set.name == "zebra").unwrap();
    hand.window.get_by_label("Colours: zebra").scroll_to_me();
    hand.window.run_steps(60);
    hand.window.get_by_label("Colours: zebra").hover();
    hand.window.run_steps(60);
    assert!(hand.window.query_by_label(zebra.source).is_some(), "its source is shown");
    hand.reach("Colours: zebra");
    assert_eq!(hand.colours(0), Colours::from(&zebra.set.gradient()));
    hand.reach("Default");
    assert_eq!(hand.document().layers[0].colours, None);
}

#[test]
fn colours_are_copied_between_layers() {
    let (mut hand, _folder) = with_layers(2);
    assert_eq!(hand.window.state().session().active_layer, 1);
    hand.reach("Colours: tiger");
    let tiger = hand.colours(1);
    assert_ne!(hand.colours(0), tiger);
    hand.reach("Copy to");
    hand.press("layer 1");
    assert_eq!(hand.colours(0), tiger);
    hand.key(Modifiers::COMMAND, Key::Z);
    assert_ne!(hand.colours(0), tiger);
    hand.reach("Copy from");
    hand.press("layer 1");
    assert_eq!(hand.colours(1), Colours::default_for_layer(0));
}

#[test]
fn palettes_are_saved_and_opened() {
    let (mut hand, folder) = with_layers(1);
    hand.reach("Colours: zebra");
    let zebra = hand.colours(0);
    for name in ["p.json", "p.gpl"] {
        let file = folder.path().join(name);
        hand.reach("Save palette…");
        hand.type_into("File", file.to_str().unwrap());
        assert_eq!(Palette::read(&file).unwrap().name, "layer 1");
        hand.reach("Default");
        assert_ne!(hand.colours(0), zebra);
        hand.reach("Open palette…");
        hand.type_into("File", file.to_str().unwrap());
        let read = hand.colours(0);
        assert_eq!(read.stops, zebra.stops, "{name}");
        assert_eq!(read.bends == zebra.bends, name == "p.json", "{name}: only .json keeps transitions");
    }
    let bad = folder.path().join("bad.gpl");
    fs::write(&bad, "GIMP Palette\n1 2 300 x\n").unwrap();
    let before = hand.colours(0);
    hand.reach("Open palette…");
    hand.type_into("File", bad.to_str().unwrap());
    assert_eq!(hand.colours(0), before);
    let said = hand.window.state().notices().iter().find(|notice| notice.wrong).expect("it is said");
    assert!(said.text.contains("line 2: found \"1 2 300 x\""), "{said:?}");
}

#[test]
fn a_palette_that_cannot_be_read_or_written_is_reported_and_the_window_stays_usable() {
    let (mut hand, folder) = with_layers(1);
    let before = hand.colours(0);
    for (button, file) in [("Open palette…", "missing.gpl"), ("Save palette…", "nowhere/p.gpl")] {
        hand.reach(button);
        hand.type_into("File", folder.path().join(file).to_str().unwrap());
        let notices = hand.window.state().notices();
        assert!(notices.iter().any(|notice| notice.wrong && notice.text.contains(file)), "{notices:?}");
    }
    assert_eq!(hand.colours(0), before);
    hand.reach("Colours: zebra");
    assert_ne!(hand.colours(0), before);
}

#[cfg(unix)]
#[test]
fn the_window_stays_usable_while_a_palette_is_read_for_a_layer() {
    let (mut hand, folder) = with_layers(2);
    let file = folder.path().join("slow.gpl");
    crate::hand::pipe(&file);
    let [below, above] = [0, 1].map(|layer| hand.colours(layer));
    hand.reach("Open palette…");
    hand.type_slow_path("File", &file);
    assert!(hand.window.state().is_busy_with_files());
    hand.window.key_press_modifiers(Modifiers::NONE, Key::PageDown);
    hand.window.run_steps(4);
    assert_eq!(hand.window.state().session().active_layer, 0, "keys are carried out meanwhile");
    fs::write(&file, "GIMP Palette\n10 20 30 dark\n200 210 220 light\n").unwrap();
    hand.rest();
    assert_eq!(hand.colours(0), below);
    assert_ne!(hand.colours(1), above);
}

#[test]
fn colours_can_be_chosen_before_anything_is_drawn() {
    let mut hand = crate::hand::hand();
    hand.press("Colour");
    hand.reach("Colours: ladybird");
    hand.key(Modifiers::SHIFT, Key::E);
    assert_eq!(hand.document().layers.len(), 1);
    assert_eq!(hand.colours(0).stops[0].colour, [0xd8, 0x35, 0x2a]);
}

/// Whether the texture on the screen equals what the library paints for the current document.
fn is_painted(hand: &Hand) -> bool {
    let window = hand.window.state();
    let (Some(texture), Some(picture)) = (window.settled(), window.growth().picture.as_ref()) else {
        return false;
    };
    // A magnified canvas has several px of the picture for each of its own px.
    let scale = picture.image.size[0] / texture.grown.size[0] as usize;
    let rgb =
        dapple_engine::synth::render::painting::Painting::new(&window.document(), &texture.grown, scale)
            .rgb();
    assert_eq!(3 * picture.image.pixels.len(), rgb.len());
    picture.image.pixels.iter().zip(rgb.chunks_exact(3)).all(|(px, rgb)| px.to_array()[..3] == *rgb)
}

#[test]
fn the_picture_is_repainted_while_a_stop_moves_and_nothing_grows_again() {
    let (mut hand, _folder) = with_layers(1);
    hand.until_settled();
    let growth = hand.window.state().growth().generation();
    let grown = hand.window.state().settled().unwrap().grown.clone();
    let pin = hand.place("Stop 2 of 4").center();
    hand.pull(pin, pin - vec2(60.0, 0.0), |hand| {
        hand.until("repainted", |_| true);
        for _ in 0..500 {
            if is_painted(hand) {
                break;
            }
            hand.wait_for_tasks();
            hand.window.step();
        }
        assert!(is_painted(hand), "the picture follows before the hand lets go");
    });
    hand.reach("Colours: tiger");
    let window = hand.window.state();
    assert_eq!(window.growth().generation(), growth, "nothing was grown again");
    assert!(std::sync::Arc::ptr_eq(&window.settled().unwrap().grown, &grown));
    assert!(matches!(window.growth_state(), GrowthState::Settled(_)));
}

#[test]
fn a_change_of_colours_does_not_restart_the_growth() {
    let (mut hand, _folder) = with_layers(1);
    hand.key(Modifiers::COMMAND, Key::R);
    hand.until("first picture", |window| window.growth().first_picture.is_some());
    let growth = hand.window.state().growth().generation();
    hand.reach("Colours: zebra");
    assert_eq!(hand.window.state().growth().generation(), growth);
    hand.until_settled();
    assert_eq!(hand.window.state().growth().generation(), growth);
    for _ in 0..500 {
        if is_painted(&hand) {
            break;
        }
        hand.wait_for_tasks();
        hand.window.step();
    }
    assert!(is_painted(&hand), "it settles in the colours that were chosen meanwhile");
}

#[test]
fn every_control_of_the_colours_has_a_name() {
    let (mut hand, _folder) = with_layers(2);
    hand.reach("Bend by hand");
    for role in [Role::Button, Role::Slider, Role::TextInput, Role::SpinButton] {
        for node in hand.window.query_all_by_role(role) {
            let name = node.accesskit_node().label().unwrap_or_default();
            let labelled = node.accesskit_node().labelled_by().next().is_some();
            assert!(!name.trim().is_empty() || labelled, "a {role:?} has no name");
        }
    }
    assert!(hand.window.query_all_by_role(Role::Slider).count() >= 6, "stops and handles are among them");
}

#[test]
fn a_finish_is_chosen_beside_the_colours_without_growing_again_and_undone() {
    let (mut hand, _folder) = with_layers(1);
    hand.until_settled();
    let before = hand.document();
    hand.window.get_by_label("Material of the texture").scroll_to_me();
    hand.window.run_steps(60);
    hand.click_role(Role::ComboBox, "Material of the texture");
    hand.rest();
    hand.press("Fish scales");
    hand.rest();
    let chosen = hand.document().finish.expect("a finish");
    assert_eq!((chosen.finish.kind.name(), chosen.finish.size), ("fish-scales", 14.0));
    assert!(
        matches!(hand.growth_state(), GrowthState::Settled(_)),
        "it grows again: {:?}",
        hand.growth_state()
    );
    hand.window.get_by_label("Size of the material").scroll_to_me();
    hand.window.run_steps(60);
    hand.type_into("Size of the material", "9");
    hand.reach("Direction automatic");
    hand.type_into("Direction of the material", "45");
    let chosen = hand.document().finish.expect("a finish");
    assert_eq!((chosen.finish.size, chosen.flow), (9.0, FlowChoice::Angle(45.0)));
    for _ in 0..4 {
        hand.key(Modifiers::COMMAND, Key::Z);
    }
    assert_eq!(hand.document(), before);
}
