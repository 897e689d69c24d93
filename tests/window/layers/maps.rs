//! Maps: attributes that vary over the canvas by noise or by a picture.

use dapple::document::{LayerMaps, MapChange, MapKey, MapSource};
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;

use crate::hand::{Hand, hand};
use crate::layers::{choose, undo};

/// A window with two ellipses, with the rows about variation unfolded.
fn two_ellipses() -> Hand {
    let mut hand = hand();
    hand.key(Modifiers::NONE, Key::E);
    hand.drag(&[[80.0, 80.0], [120.0, 104.0]]);
    hand.drag(&[[180.0, 80.0], [220.0, 104.0]]);
    hand.key(Modifiers::NONE, Key::Escape);
    hand.press("How it grows");
    let header = "Varies over the canvas";
    hand.window.get_by_label(header).scroll_to_me();
    hand.window.run_steps(60);
    hand.window.get_by_label(header).click();
    hand.rest();
    hand
}

fn maps(hand: &Hand) -> LayerMaps {
    hand.document().layers[0].maps.clone()
}

fn scroll_to(hand: &mut Hand, role: Role, name: &str) {
    hand.window.get_by_role_and_label(role, name).scroll_to_me();
    hand.window.run_steps(60);
}

fn pick(hand: &mut Hand, list: &str, item: &str) {
    scroll_to(hand, Role::ComboBox, list);
    choose(hand, list, item);
}

fn set(hand: &mut Hand, name: &str, text: &str) {
    scroll_to(hand, Role::SpinButton, name);
    hand.type_into(name, text);
}

#[test]
fn noise_is_chosen_for_an_attribute_changed_and_removed() {
    let mut hand = two_ellipses();
    assert!(
        hand.window.query_by_role_and_label(Role::ComboBox, "Width varies").is_none(),
        "spots have no duty"
    );
    pick(&mut hand, "Size varies", "By noise");
    set(&mut hand, "Size, noise size", "90");
    set(&mut hand, "Size, octaves", "3");
    set(&mut hand, "Size, from", "0.4");
    set(&mut hand, "Size, from, at the end", "1.5");
    let map = maps(&hand).get(MapKey::Area).cloned().expect("a map");
    assert_eq!(map.source, MapSource::Noise { size: 90.0, octaves: 3 });
    assert_eq!(map.range, [0.4, 1.5]);
    hand.document().check("what was chosen").unwrap();
    undo(&mut hand);
    assert_ne!(maps(&hand).get(MapKey::Area).map(|map| map.range), Some([0.4, 1.5]));
    pick(&mut hand, "Size varies", "No");
    assert!(maps(&hand).is_empty());
}

#[test]
fn a_picture_turns_marks_or_sets_their_direction() {
    let mut hand = two_ellipses();
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("ramp.png");
    image::GrayImage::from_fn(16, 4, |x, _| image::Luma([16 * x as u8])).save(&file).unwrap();
    pick(&mut hand, "Direction varies", "By a picture…");
    hand.type_into("File", file.to_str().unwrap());
    hand.rest();
    let map = maps(&hand).get(MapKey::Direction).cloned().expect("a map");
    assert_eq!((map.change(MapKey::Direction), map.range), (MapChange::Add, [-25.0, 25.0]));
    let MapSource::Image { image, .. } = &map.source else { panic!("{map:?}") };
    assert_eq!((image.size(), image.values()[15]), ([16, 4], 240));
    scroll_to(&mut hand, Role::CheckBox, "Direction, changes what is drawn");
    hand.press("Direction, changes what is drawn");
    let map = maps(&hand).get(MapKey::Direction).cloned().expect("a map");
    assert_eq!((map.change(MapKey::Direction), map.range), (MapChange::Replace, [0.0, 90.0]));
    hand.document().check("what was chosen").unwrap();
}
