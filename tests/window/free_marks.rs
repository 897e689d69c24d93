//! Free marks: the sizes and directions between them are shown, marks that did not grow are hollow, and two sizes
//! become two layers.

use dapple::app::{Start, Window};
use dapple::document::{Document, Layer, Stroke};
use egui::{Key, Modifiers, Theme, vec2};
use egui_kittest::kittest::Queryable;

use crate::hand::{Hand, hand, hand_with, with};
use crate::sights::{picture, see};

/// Whether this text is on the screen.
fn is_shown(hand: &Hand, text: &str) -> bool {
    hand.window.query_all_by_label_contains(text).next().is_some()
}

/// The number of drawn marks of the lowest layer that did not grow, once it is known.
#[track_caller]
fn lost(hand: &mut Hand) -> usize {
    hand.until_settled();
    hand.until("measured", |window: &Window| window.results().for_texture(window.settled()).is_some());
    hand.rest();
    hand.window.state().results().outcome().unwrap().layers[0].lost()
}

/// Rings of ellipses around the middle of the canvas, each along its ring.
fn draw_rings(hand: &mut Hand) {
    hand.key(Modifiers::NONE, Key::B);
    for (radius, count) in [(90.0, 6), (190.0, 11)] {
        for k in 0..count {
            let turn = 360.0 * f64::from(k) / f64::from(count);
            let (s, c) = turn.to_radians().sin_cos();
            hand.draw_round([256.0 + radius * c, 256.0 + radius * s], [22.0, 11.0], turn + 90.0);
        }
    }
}

#[test]
fn sizes_and_directions_between_marks_are_shown_while_drawing_and_can_be_hidden() {
    let mut hand = hand();
    assert!(hand.window.state().wanted().is_empty());
    hand.draw_round([150.0, 150.0], [30.0, 15.0], 0.0);
    hand.draw_round([250.0, 150.0], [30.0, 15.0], 0.0);
    hand.until_settled();
    let first = hand.window.state().wanted().to_vec();
    assert!(first.len() > 10 && first.iter().all(|glyph| !glyph.is_cancelled()), "{first:?}");
    // The display follows the sketch.
    hand.draw_round([200.0, 350.0], [30.0, 15.0], 60.0);
    hand.until_settled();
    assert_ne!(hand.window.state().wanted(), first);

    let shown = picture(&mut hand);
    hand.press("Canvas");
    hand.press("Sizes and directions between marks");
    assert!(hand.window.state().wanted().is_empty());
    let hidden = picture(&mut hand);
    assert!(shown != hidden, "nothing was painted");
    hand.key(Modifiers::NONE, Key::W);
    assert!(!hand.window.state().wanted().is_empty());
    // A document with regions has a grid instead.
    hand.press("Canvas regions");
    assert!(hand.document().regions.is_some() && hand.window.state().wanted().is_empty());
    assert!(is_shown(&hand, "Region grid") && !is_shown(&hand, "Sizes and directions between marks"));
}

#[test]
fn the_attributes_at_the_pointer_are_shown() {
    let mut hand = hand();
    hand.draw_round([100.0, 256.0], [40.0, 40.0], 0.0);
    hand.draw_round([400.0, 256.0], [10.0, 10.0], 0.0);
    hand.key(Modifiers::NONE, Key::Escape);
    hand.window.remove_cursor();
    hand.until_settled();
    assert!(is_shown(&hand, "Asked for on average"));
    let mut areas = Vec::new();
    for x in [180.0, 340.0] {
        let at = hand.at([x, 256.0]);
        hand.window.hover_at(at);
        hand.rest();
        assert!(is_shown(&hand, "Asked for at the pointer"));
        let label = hand.window.query_all_by_label_contains("px²").next().unwrap();
        let text = format!("{label:?}");
        let digits: String =
            text.split(" px²").next().unwrap().chars().rev().take_while(char::is_ascii_digit).collect();
        areas.push(digits.chars().rev().collect::<String>().parse::<f64>().unwrap());
    }
    assert!(areas[0] > 1.5 * areas[1], "{areas:?}");
}

#[test]
fn directions_that_cancel_are_marked_on_the_canvas() {
    let mut hand = hand();
    hand.key(Modifiers::NONE, Key::L);
    hand.drag(&[[60.0, 100.0], [250.0, 100.0], [450.0, 100.0]]);
    let cancelled =
        |hand: &Hand| hand.window.state().wanted().iter().filter(|glyph| glyph.is_cancelled()).count();
    assert_eq!(cancelled(&hand), 0);
    hand.drag(&[[256.0, 220.0], [256.0, 350.0], [256.0, 480.0]]);
    hand.until_settled();
    assert!(cancelled(&hand) > 0);
}

#[test]
fn the_field_of_rings_of_ellipses() {
    let mut hand = with(Start::default(), vec2(1280.0, 800.0), Theme::Light);
    draw_rings(&mut hand);
    hand.key(Modifiers::NONE, Key::Escape);
    hand.until_settled();
    hand.window.state_mut().hide_times();
    see(&mut hand, "wanted-light");
}

#[test]
fn the_field_of_strokes_that_meet_in_the_dark() {
    let mut hand = with(Start::default(), vec2(1280.0, 800.0), Theme::Dark);
    let arc = |radius: f64| -> Vec<[f64; 2]> {
        (0..=30)
            .map(|k| (180.0 + 3.0 * f64::from(k)).to_radians().sin_cos())
            .map(|(s, c)| [300.0 + radius * c, 300.0 + radius * s])
            .collect()
    };
    hand.drag(&arc(120.0));
    hand.drag(&arc(160.0));
    hand.drag(&[[330.0, 420.0], [400.0, 380.0], [470.0, 340.0]]);
    hand.key(Modifiers::NONE, Key::Escape);
    hand.until_settled();
    hand.window.state_mut().hide_times();
    see(&mut hand, "wanted-dark");
}

/// Spots far apart, and one that overlaps another.
fn overlapping() -> Document {
    let mut strokes: Vec<Stroke> = (0..9)
        .map(|k| [100.0 + 110.0 * f64::from(k % 3), 100.0 + 110.0 * f64::from(k / 3)])
        .map(|center| Stroke::ellipse(center, [24.0, 16.0], 30.0))
        .collect();
    strokes.push(Stroke::ellipse([228.0, 216.0], [24.0, 16.0], 30.0));
    Document { size: [420, 420], layers: vec![Layer::new(strokes)], ..Document::default() }
}

#[test]
fn a_mark_that_did_not_grow_is_hollow_and_says_why() {
    let (mut hand, ..) = hand_with(&overlapping());
    // This is known as soon as the growth is planned.
    hand.until("planned", |window: &Window| window.growth().left_out.iter().flatten().count() == 1);
    hand.rest();
    assert!(is_shown(&hand, "1 mark does not grow (dashed outline)"));
    assert_eq!(lost(&mut hand), 1);
    let drawn = hand.window.state().results().outcome().unwrap().layers[0].drawn.clone();
    let lost_mark = drawn.iter().find(|mark| !mark.there).unwrap();
    let at = hand.at(lost_mark.place);
    hand.window.hover_at(at);
    // The text appears where the pointer rests.
    hand.window.run_steps(60);
    assert!(is_shown(&hand, "Does not grow: "), "no reason at the pointer");
    assert!(is_shown(&hand, lost_mark.reason.unwrap()));
    assert!(is_shown(&hand, "1 mark does not grow (dashed outline)"));
    hand.press("Result");
    assert!(is_shown(&hand, "1 of 10 drawn marks did not grow: dashed outlines in the sketch"));
    hand.window.state_mut().hide_times();
    see(&mut hand, "lost-light");
    // After a change, it is unknown which marks did not grow.
    hand.press("Draw");
    hand.key(Modifiers::NONE, Key::V);
    hand.click(lost_mark.place);
    hand.key(Modifiers::NONE, Key::Delete);
    assert_eq!(lost(&mut hand), 0);
}

#[test]
fn the_drawn_and_the_grown_attributes_of_a_selected_mark_are_shown() {
    let (mut hand, ..) = hand_with(&overlapping());
    lost(&mut hand);
    hand.key(Modifiers::NONE, Key::V);
    hand.click([100.0, 100.0]);
    lost(&mut hand);
    for text in ["Grown", "asked", "grown", "error", "Its centre is"] {
        assert!(is_shown(&hand, text), "{text}");
    }
    let asked = format!("{:.0} px²", std::f64::consts::PI * 24.0 * 16.0);
    assert!(is_shown(&hand, &asked), "{asked}");
    hand.key(Modifiers::NONE, Key::Escape);
    let at = hand.at([320.0, 100.0]);
    hand.window.hover_at(at);
    hand.rest();
    assert!(is_shown(&hand, "The mark under the pointer"));
}

/// Large and small spots among each other.
fn two_sizes() -> Document {
    let spot = |k: u32| {
        let center = [60.0 + 70.0 * f64::from(k % 5), 60.0 + 70.0 * f64::from(k / 5)];
        Stroke::ellipse(center, if k % 7 == 3 { [26.0, 22.0] } else { [8.0, 7.0] }, 20.0)
    };
    Document { size: [400, 400], layers: vec![Layer::new((0..25).map(spot))], ..Document::default() }
}

#[test]
fn two_sizes_become_two_layers_by_a_click_and_one_undo_restores_them() {
    let before = two_sizes();
    let (mut hand, ..) = hand_with(&before);
    assert!(is_shown(&hand, "the spots of this layer have two sizes"));
    hand.reach("Split into two layers");
    let after = hand.document();
    let counts: Vec<usize> = after.layers.iter().map(|layer| layer.strokes.len()).collect();
    assert_eq!(counts, [4, 21]);
    assert!(after.layers.iter().all(|layer| layer.system == before.layers[0].system));
    assert!(!is_shown(&hand, "have two sizes") && !is_shown(&hand, "Split into two layers"));
    hand.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(hand.document().layers[0].strokes, before.layers[0].strokes);
    assert_eq!(hand.document().layers.len(), 1);
    assert!(!hand.window.state().session().can_undo_redo()[0]);
}

#[test]
fn notes_on_a_sketch_are_shown_whole() {
    let (mut hand, ..) = hand_with(&two_sizes());
    hand.window.get_by_label("Split into two layers").scroll_to_me();
    hand.window.run_steps(60);
    let column = hand.window.get_by_label("Will not grow as drawn").rect();
    for part in ["the spots of this layer have two sizes", "Split into two layers"] {
        let shown = hand.window.get_by_label_contains(part).rect();
        assert!(shown.left() >= column.left() - 1.0 && shown.right() <= 1280.0 - 10.0, "{part}: {shown:?}");
        assert!(shown.top() > 60.0 && shown.bottom() < 640.0, "{part}: {shown:?}");
    }
}

#[test]
fn notes_report_impossible_distances_of_stripes_and_hidden_layers() {
    let mut hand = hand();
    hand.key(Modifiers::NONE, Key::L);
    hand.drag(&[[100.0, 100.0], [250.0, 100.0], [400.0, 100.0]]);
    assert!(!is_shown(&hand, "Will not grow as drawn"));
    hand.drag(&[[100.0, 107.0], [250.0, 107.0], [400.0, 107.0]]);
    hand.until_settled();
    assert!(is_shown(&hand, "draw them farther apart, or thinner"));
    hand.key(Modifiers::COMMAND, Key::Z);
    hand.until_settled();
    assert!(!is_shown(&hand, "Will not grow as drawn"));
    hand.key(Modifiers::SHIFT, Key::H);
    assert!(is_shown(&hand, "all layers are hidden"));
}

#[test]
fn the_result_of_the_last_drawn_mark_is_shown_once_it_is_measured() {
    let mut hand = hand();
    for k in 0..6 {
        hand.draw_round([100.0 + 50.0 * f64::from(k), 200.0], [16.0, 10.0], 30.0);
        lost(&mut hand);
        assert!(is_shown(&hand, "Grown"), "mark {k}");
    }
}

#[test]
fn a_sign_at_its_place_explains_what_will_not_grow_as_drawn() {
    let mut hand = hand();
    hand.key(Modifiers::NONE, Key::L);
    hand.drag(&[[100.0, 100.0], [200.0, 150.0], [300.0, 200.0]]);
    hand.drag(&[[100.0, 200.0], [200.0, 150.0], [300.0, 100.0]]);
    hand.press("Grow stripes instead");
    let at = hand.at([200.0, 150.0]);
    hand.window.hover_at(at);
    hand.window.run_steps(60);
    let texts = hand.window.query_all_by_label_contains("these lines cross each other").count();
    assert_eq!(texts, 2, "in the column and at the pointer");
}
