//! Fields of points: the settings of their rows.

use std::fs;

use dapple::document::systems::POINTS;
use dapple::document::{Interpolation, Labels, Layer, Points, Progression, SystemChoice, Towards};
use egui::accesskit::Role;
use egui_kittest::kittest::Queryable;

use crate::hand::{Hand, hand};
use crate::layers::{choose, undo};

/// The points of the only layer.
fn points(hand: &Hand) -> Points {
    hand.document().layers[0].point_field().expect("a field of points")
}

/// A window whose canvas was filled by a click, with the settings unfolded.
fn cow() -> Hand {
    let mut hand = hand();
    hand.press("A cow");
    hand.press("How it grows");
    hand
}

/// Scrolls the settings until the control is visible.
fn scroll_to(hand: &mut Hand, role: Role, name: &str) {
    hand.window.get_by_role_and_label(role, name).scroll_to_me();
    hand.window.run_steps(60);
}

fn set(hand: &mut Hand, name: &str, text: &str) {
    scroll_to(hand, Role::SpinButton, name);
    hand.type_into(name, text);
}

fn pick(hand: &mut Hand, list: &str, item: &str) {
    scroll_to(hand, Role::ComboBox, list);
    choose(hand, list, item);
}

#[test]
fn a_click_fills_an_empty_canvas_and_can_be_undone() {
    let mut hand = hand();
    hand.press("A cow");
    assert_eq!(hand.document().layers[0].system, SystemChoice::Of(&POINTS));
    assert_eq!(hand.document().layers[0].points, Layer::cow().points);
    assert!(hand.window.query_by_label("Layer layer 1, points").is_some());
    assert!(!hand.window.state().session().is_empty());
    hand.document().check("what was chosen").unwrap();
    undo(&mut hand);
    assert!(hand.document().layers.is_empty());
}

#[test]
fn every_row_of_a_field_of_points_sets_its_value() {
    let mut hand = cow();
    set(&mut hand, "Dark", "30");
    set(&mut hand, "Dark, at the end", "80");
    assert_eq!(points(&hand).labels, Labels::Random { dark: [0.3, 0.8] });
    pick(&mut hand, "Along", "Down");
    assert_eq!(points(&hand).progression, Progression::Down);
    hand.reach("Distance automatic");
    set(&mut hand, "Distance", "20");
    set(&mut hand, "Distance, at the end", "40");
    assert_eq!(points(&hand).distance, Some([20.0, 40.0]));
    set(&mut hand, "Octaves", "3");
    scroll_to(&mut hand, Role::CheckBox, "Fold");
    hand.press("Fold");
    assert!(points(&hand).fold && points(&hand).octaves == 3);
    hand.reach("Octaves: default");
    set(&mut hand, "Reach", "9");
    assert_eq!((points(&hand).octaves, points(&hand).axis), (1, 2.0), "no more than is allowed");
    set(&mut hand, "Lean", "0.4");
    pick(&mut hand, "Towards", "An angle");
    set(&mut hand, "Angle", "30");
    assert_eq!((points(&hand).shift, points(&hand).towards), (0.4, Towards::Angle(30.0)));
    set(&mut hand, "Dark area", "25");
    assert_eq!(points(&hand).share, Some(0.25));
    hand.reach("Dark area: default");
    assert_eq!(points(&hand).share, None);
    hand.reach("Dark area automatic");
    assert!(points(&hand).share.is_some());
    pick(&mut hand, "Borders", "Sharp");
    assert_eq!(points(&hand).interpolation, Interpolation::Nearest);
    assert_eq!(points(&hand).share, None, "dark and light cells have no level");
    hand.document().check("what was chosen").unwrap();
}

#[test]
fn kinds_of_labels_are_chosen_by_a_picture_and_have_their_own_rows() {
    let mut hand = cow();
    for (kind, row, typed, labels) in [
        ("Grays", "Points a group", "4", Labels::Values { group: 4 }),
        ("Space giraffe", "Rays", "30", Labels::SpaceGiraffe { rays: [30, 30] }),
        ("Breadth first", "Cluster", "9", Labels::BreadthFirst { size: 9 }),
        ("Depth first", "Cluster", "12", Labels::DepthFirst { size: 12 }),
        ("Round robin", "Thicker by", "2", Labels::RoundRobin { size: Labels::SIZE, rings: 2 }),
        ("Connected", "Nodes", "2.5", Labels::Connected { start: 0.025, rings: 0 }),
    ] {
        pick(&mut hand, "Values", kind);
        set(&mut hand, row, typed);
        assert_eq!(points(&hand).labels, labels, "{kind}");
        hand.document().check(kind).unwrap();
    }
    hand.reach("Values: default");
    assert_eq!(points(&hand).labels, Labels::Random { dark: [Labels::DARK; 2] });
}

#[test]
fn a_picture_says_which_points_are_dark() {
    let mut hand = cow();
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("half.png");
    image::GrayImage::from_fn(8, 8, |x, _| image::Luma([if x < 4 { 0 } else { 255 }])).save(&file).unwrap();
    pick(&mut hand, "Values", "A picture…");
    hand.type_into("File", file.to_str().unwrap());
    hand.rest();
    let Labels::Image { image, passes: Labels::PASSES } = points(&hand).labels else {
        panic!("{:?}", points(&hand).labels)
    };
    assert_eq!((image.size(), image.values()[0], image.values()[7]), ([8, 8], 0, 255));
    pick(&mut hand, "Values", "Dark or light");
    set(&mut hand, "Dark", "10");
    pick(&mut hand, "Along", "By a picture…");
    fs::write(folder.path().join("bad.png"), "no picture").unwrap();
    hand.type_into("File", folder.path().join("bad.png").to_str().unwrap());
    hand.rest();
    assert_eq!(points(&hand).progression, Progression::Across);
    assert!(
        hand.window.state().notices().iter().any(|notice| notice.wrong && notice.text.contains("bad.png"))
    );
    pick(&mut hand, "Along", "By a picture…");
    hand.type_into("File", file.to_str().unwrap());
    hand.rest();
    assert_eq!(points(&hand).progression, Progression::Image(image));
}
