//! Small pictures of what the active layer can become.

use dapple::app::{Goal, ShownGoal};
use dapple::document::{After, Document, SpreadChoice, SystemChoice};
use dapple_engine::document::{AreaKind, LineKind};
use egui::accesskit::Role;
use egui::{Key, Modifiers, Theme, vec2};
use egui_kittest::kittest::{NodeT, Queryable};

use crate::hand::{self, Hand, with_goals};
use crate::sights::see;

const SPOTS: &str = r#"{"kind": "ellipse", "center": [50, 60], "radii": [12, 9], "angle": 20},
    {"kind": "ellipse", "center": [95, 50], "radii": [12, 9], "angle": 20},
    {"kind": "ellipse", "center": [70, 100], "radii": [12, 9], "angle": 20}"#;
const LINES: &str = r#"{"kind": "line", "from": [20, 40], "to": [120, 40], "width": 6},
    {"kind": "line", "from": [20, 60], "to": [120, 60], "width": 6}"#;
const CROSSING: &str = r#"{"kind": "line", "from": [50, 20], "to": [55, 130], "width": 6},
    {"kind": "line", "from": [80, 20], "to": [85, 130], "width": 6}"#;

/// A window with pictures of what layers can become.
fn hand() -> Hand {
    with_goals();
    hand::hand()
}

/// A window with a document and such pictures.
fn hand_with(document: &Document) -> (Hand, tempfile::TempDir, std::path::PathBuf) {
    with_goals();
    hand::hand_with(document)
}

/// A document of 150² px with these layers and these other keys.
fn document(layers: &[&str], keys: &str) -> Document {
    sized(150, layers, keys)
}

fn sized(side: u32, layers: &[&str], keys: &str) -> Document {
    let layer = |strokes: &&str| format!(r#"{{"name": "a", "strokes": [{strokes}]}}"#);
    let layers: Vec<String> = layers.iter().map(layer).collect();
    let all = layers.join(", ");
    let text = format!(
        r#"{{"format": "dapple", "version": 2, "size": [{side}, {side}], {keys} "layers": [{all}]}}"#
    );
    Document::parse(&text, "goals").unwrap()
}

#[track_caller]
fn until_grown(hand: &mut Hand) {
    hand.until_settled();
    hand.until("goals", |window| !window.goals().all.is_empty() && window.goals().is_complete());
    hand.rest();
}

fn goal(hand: &Hand, goal: Goal) -> &ShownGoal {
    hand.window.state().goals().all.iter().find(|one| one.offer.goal == goal).unwrap()
}

#[test]
fn a_click_on_a_goal_changes_the_layer_and_one_undo_takes_it_back() {
    let (mut hand, ..) = hand_with(&document(&[SPOTS], ""));
    until_grown(&mut hand);
    let before = hand.document();
    assert!(goal(&hand, Goal::Spots).is_now);
    hand.press("Become Cells");
    assert_eq!(hand.document().layers[0].system, SystemChoice::Of(AreaKind::Polygons.description()));
    until_grown(&mut hand);
    assert!(goal(&hand, Goal::Cells).is_now && !goal(&hand, Goal::Spots).is_now);
    hand.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(hand.document(), before);
    until_grown(&mut hand);

    // Rings are drawn as lines, on a layer of their own.
    hand.press("Become Rings");
    assert_eq!(
        hand.document().layers.iter().map(|layer| layer.after).collect::<Vec<_>>(),
        [After::Between, After::Around]
    );
    until_grown(&mut hand);
    assert!(goal(&hand, Goal::Rings).is_now);
    hand.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(hand.document(), before);
}

#[test]
fn a_stroke_cancels_the_growing_of_goals() {
    let (mut hand, ..) = hand_with(&document(&[SPOTS], ""));
    hand.until_settled();
    hand.key(Modifiers::NONE, Key::E);
    hand.until("some growing", |window| window.goals().is_growing());
    let at = hand.at([120.0, 120.0]);
    hand.window.hover_at(at);
    hand.window.drag_at(at);
    hand.window.step();
    hand.window.hover_at(at + vec2(12.0, 9.0));
    hand.window.step();
    assert!(!hand.window.state().goals().is_growing());
    hand.window.run_steps(3);
    assert!(!hand.window.state().goals().is_growing(), "they wait until the stroke has ended");
    hand.window.drop_at(at + vec2(12.0, 9.0));
    until_grown(&mut hand);
    assert!(goal(&hand, Goal::Cells).picture.is_some());
}

#[track_caller]
fn all_grow(document: &Document, asked: &[Goal]) {
    let (mut hand, ..) = hand_with(document);
    until_grown(&mut hand);
    let all = &hand.window.state().goals().all;
    for one in all {
        let name = one.offer.goal.name();
        let is_shown = hand.window.query_all_by_label_contains(&format!("Become {name}")).next().is_some();
        assert_eq!(is_shown, one.failed.is_none(), "{name}: {:?}", one.failed);
        assert_eq!(one.can_be_taken(), one.offer.outcome.is_ok() && is_shown, "{name}");
    }
    for goal in asked {
        assert!(all.iter().any(|one| one.offer.goal == *goal && one.can_be_taken()), "{goal:?}");
    }
    // The pictures differ from each other.
    let pictures: Vec<_> = all.iter().filter_map(|one| one.picture.as_ref()).collect();
    for (index, one) in pictures.iter().enumerate() {
        assert!(one.pixels.iter().any(|px| *px != one.pixels[0]), "{index} is of one colour");
        assert!(pictures[..index].iter().all(|other| one.pixels != other.pixels), "{index}");
    }
}

#[test]
fn every_goal_of_spots_grows() {
    use Goal::{Blotches, Cells, DenseSpots, DotsAndWorms, Net, Patches, Rings, Spots, Tone, Worms};
    let all = [Spots, DenseSpots, Cells, Patches, Rings, Net, DotsAndWorms, Worms, Blotches, Tone];
    all_grow(&document(&[SPOTS], ""), &all);
}

#[test]
fn every_goal_of_lines_grows() {
    use Goal::{Cracks, DotsAndWorms, Maze, Streaks, Stripes, Tips, Tone, Weave, Worms};
    all_grow(&document(&[LINES], ""), &[Stripes, Tips, Streaks, Cracks, DotsAndWorms, Worms, Tone]);
    let crossing = format!("{LINES}, {CROSSING}");
    all_grow(&document(&[&crossing], r#""edges": "wrap","#), &[Stripes, Tips, Streaks, Weave, Maze, Cracks]);
}

#[test]
fn every_goal_of_a_layer_above_others_grows() {
    use Goal::{Inside, Net, Rings, Streaks, Stripes};
    all_grow(&document(&[SPOTS, LINES], ""), &[Stripes, Rings, Net, Streaks]);
    let small = SPOTS.replace("[12, 9]", "[5, 4]");
    all_grow(&document(&[SPOTS, &small], ""), &[Inside]);
}

#[test]
fn goals_grow_in_regions_and_in_a_part_of_a_large_sketch() {
    let far =
        format!(r#"{SPOTS}, {{"kind": "ellipse", "center": [450, 450], "radii": [14, 9], "angle": 0}}"#);
    let large = sized(500, &[&far], "");
    all_grow(&large, &[Goal::Spots, Goal::Cells, Goal::Rings]);
    all_grow(&Document { regions: Some([4, 4]), ..large }, &[Goal::Spots, Goal::Cells, Goal::Patches]);
}

#[test]
fn goals_that_need_a_layer_beneath_say_so() {
    let (mut hand, ..) = hand_with(&document(&[LINES], ""));
    until_grown(&mut hand);
    let before = hand.document();
    for name in ["Rings", "Net"] {
        let label = format!("Become {name}: needs spots on a layer beneath");
        let card = hand.window.get_by_role_and_label(Role::Button, &label);
        assert!(card.accesskit_node().is_disabled());
        hand.press(&label);
        assert_eq!(hand.document(), before);
    }
    assert!(hand.window.query_by_label("Become Weave: needs lines that cross").is_some());
}

#[test]
fn the_panel_names_no_systems() {
    for layers in [&[SPOTS][..], &[LINES], &[SPOTS, LINES]] {
        let (mut hand, ..) = hand_with(&document(layers, ""));
        until_grown(&mut hand);
        for name in ["Turing", "Meinhardt"] {
            assert!(hand.window.query_all_by_label_contains(name).next().is_none(), "{name}");
        }
    }
}

#[test]
fn a_tone_asks_for_a_picture() {
    let (mut hand, ..) = hand_with(&document(&[LINES], ""));
    until_grown(&mut hand);
    let before = hand.document();
    hand.press("Become Tone");
    assert!(hand.window.query_by_role_and_label(Role::TextInput, "File").is_some());
    hand.press("Cancel");
    assert_eq!(hand.document(), before);
}

#[test]
fn goals_are_taken_by_keys_alone() {
    let (mut hand, ..) = hand_with(&document(&[LINES], ""));
    until_grown(&mut hand);
    hand.window.get_by_role_and_label(Role::Button, "Become Stripes, as it is now").focus();
    hand.rest();
    hand.key(Modifiers::NONE, Key::Tab);
    hand.key(Modifiers::NONE, Key::Tab);
    hand.key(Modifiers::NONE, Key::Enter);
    assert_eq!(hand.document().layers[0].system, SystemChoice::Of(LineKind::Streaks.description()));
}

#[test]
fn hidden_goals_are_not_grown_and_stay_hidden() {
    let (mut hand, ..) = hand_with(&document(&[SPOTS], ""));
    until_grown(&mut hand);
    let view = hand.canvas();
    hand.press("Hide");
    assert!(hand.canvas().height() > view.height(), "sketch and texture get their room");
    hand.draw_round([120.0, 120.0], [10.0, 10.0], 0.0);
    hand.until_settled();
    hand.rest();
    assert!(!hand.window.state().goals().is_growing());
    assert!(hand.window.query_by_label_contains("What it can become").is_none());
    hand.press("View");
    hand.press("What it can become");
    until_grown(&mut hand);
}

#[test]
fn low_windows_and_alternatives_leave_no_room_for_goals() {
    with_goals();
    let mut low = hand::with(dapple::app::Start::default(), vec2(900.0, 500.0), Theme::Light);
    assert!(low.window.query_by_label("What it can become").is_none());
    low.draw_round([120.0, 120.0], [20.0, 20.0], 0.0);
    low.until_settled();
    assert!(low.window.state().goals().all.is_empty());

    let mut hand = hand();
    hand.draw_round([120.0, 120.0], [20.0, 20.0], 0.0);
    assert!(hand.window.query_by_label("What it can become").is_some());
    hand.key(Modifiers::NONE, Key::A);
    assert!(hand.window.query_by_label("What it can become").is_none());
}

#[test]
fn options_that_would_help_offer_themselves_and_are_undone() {
    let mut hand = hand();
    for (k, radius) in [30.0, 16.0, 24.0].into_iter().enumerate() {
        hand.draw_round([100.0 + 140.0 * k as f64, 250.0], [radius, radius], 0.0);
    }
    let before = hand.document();
    hand.press("Let the sizes vary");
    let SpreadChoice::Given(spread) = hand.document().layers[0].options.spread else { panic!() };
    assert!(spread.area > 0.2, "{spread:?}");
    assert!(hand.window.query_by_label("Let the sizes vary").is_none());
    hand.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(hand.document(), before);
}

#[test]
fn what_spots_and_crossing_lines_can_become() {
    let spots = [[150.0, 150.0], [290.0, 120.0], [240.0, 250.0], [380.0, 270.0], [130.0, 320.0]];
    let mut hand = hand();
    for (k, center) in spots.into_iter().enumerate() {
        hand.draw_round(center, [40.0 - 3.0 * k as f64, 28.0], 20.0);
    }
    until_grown(&mut hand);
    hand.window.state_mut().hide_times();
    see(&mut hand, "goals-light");

    let crossing = format!("{LINES}, {CROSSING}");
    let (mut hand, ..) = hand_with(&document(&[&crossing], ""));
    until_grown(&mut hand);
    hand.window.state_mut().hide_times();
    see(&mut hand, "goals-of-lines-light");
}
