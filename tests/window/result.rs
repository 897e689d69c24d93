//! The result: asked and grown attributes, and marks that are changed to reachable attributes.

use std::fs;

use assert_cmd::Command;
use dapple::app::{Axis, Tab, Verdict, Window};
use dapple::document::systems::TURING_GROWTH;
use dapple::document::{Document, Layer, SystemChoice};
use dapple_engine::attributes::Attribute;
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};

use crate::hand::{Hand, hand, hand_with};
use crate::sights::picture;

/// A document with four spots in the left half of a small canvas, `apart` px from each other; the right half takes
/// their attributes.
fn spots(radius: f64, apart: f64) -> Document {
    let center = |[x, y]: [f64; 2]| [16.0 + x * apart, 50.0 + y * apart];
    let strokes: Vec<String> = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.87], [1.5, 0.87]]
        .map(center)
        .iter()
        .map(|[x, y]| {
            format!(
                r#"{{"kind": "ellipse", "center": [{x}, {y}], "radii": [{radius}, {radius}], "angle": 0}}"#
            )
        })
        .collect();
    let text = format!(
        r#"{{"format": "dapple", "version": 1, "size": [220, 160], "regions": [2, 1], "growth": {{"refine": true}},
        "layers": [{{"name": "spots", "system": "meinhardt-spots", "strokes": [{}]}}]}}"#,
        strokes.join(",")
    );
    Document::parse(&text, "spots").unwrap()
}

/// Waits until all results of the settled texture are computed.
#[track_caller]
fn until_known(hand: &mut Hand) {
    hand.until_settled();
    hand.until("measured", known);
    hand.rest();
}

fn known(window: &Window) -> bool {
    let texture = window.settled();
    texture.is_some() && window.results().for_texture(texture).is_some_and(|outcome| outcome.complete)
}

#[test]
fn the_numbers_are_those_of_the_report() {
    let document = spots(8.0, 30.0);
    let (mut hand, _folder, path) = hand_with(&document);
    hand.press("Result");
    until_known(&mut hand);

    let folder = tempfile::tempdir().unwrap();
    let [picture, report] = ["a.png", "a.json"].map(|name| folder.path().join(name));
    let mut dapple = Command::new(assert_cmd::cargo::cargo_bin!("dapple"));
    dapple.arg("grow").arg(&path).arg("-o").arg(&picture).arg("--report").arg(&report).arg("-q");
    dapple.assert().success();
    let report: serde_json::Value = serde_json::from_str(&fs::read_to_string(&report).unwrap()).unwrap();
    let outcome = hand.window.state().results().outcome().unwrap();
    assert_eq!(report["layers"][0]["system"], outcome.layers[0].system.name);
    for (region, output) in
        outcome.layers[0].regions.iter().zip(report["layers"][0]["regions"].as_array().unwrap())
    {
        let region = &region.report;
        assert_eq!(output["region"], serde_json::json!(region.place));
        for (attribute, value) in &region.error {
            assert_eq!(output["error"][attribute.name()], serde_json::json!(value), "{attribute}");
        }
        for (name, value) in &region.parameters {
            assert_eq!(output["parameters"][name], serde_json::json!(value), "{name}");
        }
        assert_eq!(output["notes"], serde_json::json!(region.notes));
    }
    // The numbers are on the screen, too.
    let area = outcome.layers[0].regions[0].report.asked.scaled(1.0);
    let dapple_engine::attributes::Attributes::Spots(area) = area else { panic!() };
    let text = format!("{:.0} px²", area.area);
    assert!(hand.window.query_all_by_label(&text).count() > 0, "{text}");
}

#[test]
fn each_region_has_a_verdict_that_a_screen_reader_reads() {
    let (mut hand, ..) = hand_with(&spots(8.0, 30.0));
    hand.press("Result");
    until_known(&mut hand);
    for (place, region) in ["1, 1", "2, 1"].iter().zip([0, 1]) {
        let verdict = hand.window.state().results().outcome().unwrap().layers[0].regions[region].verdict;
        let row = format!("Region {place}: {}", verdict.name());
        assert!(hand.window.query_by_label_contains(&row).is_some(), "{row}");
    }
}

#[test]
fn marks_that_cannot_be_reached_are_changed_to_reachable_ones_in_one_step() {
    let before = spots(11.0, 26.0);
    let (mut hand, ..) = hand_with(&before);
    hand.press("Result");
    until_known(&mut hand);
    let outcome = hand.window.state().results().outcome().unwrap().clone();
    let region = &outcome.layers[0].regions[0];
    assert_eq!(region.verdict, Verdict::Missed);
    assert!(region.report.beyond[0].to_string().contains("too small for spots of this size"));
    assert!(hand.window.query_by_label("Cannot be reached").is_some());

    hand.press("Draw what can be reached");
    assert_ne!(hand.document(), before);
    until_known(&mut hand);
    let outcome = hand.window.state().results().outcome().unwrap().clone();
    assert!(outcome.layers[0].regions.iter().all(|region| region.report.beyond.is_empty()));
    assert!(hand.window.query_by_label("Cannot be reached").is_none());
    // The distances were changed; the areas hardly, because those of the densest examples are one per cent larger.
    let areas = |document: &Document| -> Vec<f64> {
        document.layers[0]
            .strokes
            .iter()
            .map(|stroke| match stroke {
                dapple::document::Stroke::Ellipse(ellipse) => ellipse.area(),
                other => panic!("{other:?}"),
            })
            .collect()
    };
    for (before, after) in areas(&before).iter().zip(areas(&hand.document())) {
        assert!((after / before - 1.0).abs() < 0.03, "{before} {after}");
    }

    hand.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(hand.document(), before);
    assert!(!hand.window.state().session().can_undo_redo()[0]);
}

#[test]
fn a_region_without_marks_selects_the_marks_whose_attributes_it_takes() {
    let (mut hand, ..) = hand_with(&spots(11.0, 26.0));
    hand.press("Result");
    until_known(&mut hand);
    let outcome = hand.window.state().results().outcome().unwrap();
    let [own, taken] = [0, 1].map(|region| outcome.layers[0].regions[region].reach.clone().unwrap());
    assert_eq!(own, taken);
}

#[test]
fn the_region_under_the_pointer_is_shown() {
    let (mut hand, ..) = hand_with(&spots(8.0, 30.0));
    hand.press("Result");
    until_known(&mut hand);
    for (place, name) in [([30.0, 80.0], "Region 1, 1"), ([200.0, 80.0], "Region 2, 1")] {
        let at = hand.at(place);
        hand.window.hover_at(at);
        hand.rest();
        assert!(hand.window.query_by_label(name).is_some(), "{name}");
    }
}

#[test]
fn a_region_is_chosen_by_keys_alone() {
    let (mut hand, ..) = hand_with(&spots(8.0, 30.0));
    hand.window.remove_cursor();
    hand.window.get_by_role_and_label(Role::Button, "Result").focus();
    hand.rest();
    hand.key(Modifiers::NONE, Key::Enter);
    until_known(&mut hand);
    for _ in 0..20 {
        hand.key(Modifiers::NONE, Key::Tab);
        let row = hand.window.query_by_label_contains("Region 2, 1:");
        if row.is_some_and(|row| row.accesskit_node().is_focused()) {
            assert_eq!(hand.window.state().chosen_region(), Some([1, 0]));
            assert!(hand.window.query_by_label("Region 2, 1").is_some());
            return;
        }
    }
    panic!("Tab never came to the second region");
}

#[test]
fn reachable_marks_are_not_searched_for_before_the_tab_is_shown() {
    let (mut hand, ..) = hand_with(&spots(11.0, 26.0));
    hand.until_settled();
    hand.until("measured", |window| window.results().for_texture(window.settled()).is_some());
    hand.rest();
    let outcome = hand.window.state().results().outcome().unwrap();
    assert!(!outcome.complete && outcome.layers[0].regions.iter().all(|region| region.reach.is_none()));
    hand.press("Result");
    hand.until("measured", known);
    assert!(hand.window.state().results().outcome().unwrap().layers[0].regions[0].reach.is_some());
}

#[test]
fn the_result_of_an_empty_canvas_says_that_it_is_empty() {
    let mut hand = hand();
    hand.press(Tab::Result.name());
    assert!(hand.window.query_by_label("Nothing has grown yet.").is_some());
}

#[test]
fn the_training_cloud_shows_the_question_and_the_rows_of_the_answer() {
    let (mut hand, ..) = hand_with(&spots(8.0, 30.0));
    hand.press("Result");
    until_known(&mut hand);
    hand.press("Training data…");
    hand.until("a cloud", |window| window.cloud().points().is_some());
    hand.rest();
    let points = hand.window.state().cloud().points().unwrap();
    assert!(points.rows.len() > 200);
    assert!(!points.neighbours.is_empty() && points.neighbours.len() < points.rows.len());
    assert!(points.neighbours.iter().all(|(_, weight)| (0.0..=1.0).contains(weight)));
    let area_axis = Axis::Attribute(Attribute::Area);
    let area = points.value(&points.asked, area_axis);
    assert!((area / (64.0 * std::f64::consts::PI) - 1.0).abs() < 1e-6, "{area}");
    // The rows with the largest weights are similar to the question.
    let (nearest, _) = &points.neighbours[0];
    assert!((points.value(nearest, area_axis) / area).ln().abs() < 0.5);
    assert!(hand.window.query_by_label_contains("Along x").is_some());
    hand.press("Close window");
    assert!(hand.window.state().cloud().points().is_none());
}

#[test]
fn the_growth_of_a_layer_is_marked_in_the_growth_map() {
    let layer = Layer { system: SystemChoice::Of(TURING_GROWTH), ..Layer::default() };
    let (mut hand, ..) = hand_with(&Document::new([160; 2]).with_layer(layer));
    hand.press("Result");
    until_known(&mut hand);
    hand.press("Growth map…");
    hand.rest();
    assert_eq!(hand.window.state().cloud().growth(), Some([22.0, 22.0]));
    assert!(hand.window.query_by_label_contains("G = 22.0, decay 20").is_some());
    hand.press("Close window");
    assert_eq!(hand.window.state().cloud().growth(), None);
}

#[test]
fn another_document_has_its_own_results() {
    let (mut hand, ..) = hand_with(&spots(8.0, 30.0));
    hand.press("Result");
    until_known(&mut hand);
    hand.key(Modifiers::COMMAND, Key::N);
    hand.press("Create");
    assert!(hand.window.state().results().outcome().is_none());
}

#[test]
fn a_missed_region_is_marked_on_the_tab_and_in_the_region_on_every_tab() {
    let (mut hand, ..) = hand_with(&spots(11.0, 26.0));
    hand.until_settled();
    hand.until("measured", |window| window.results().for_texture(window.settled()).is_some());
    assert!(hand.window.state().results().outcome().unwrap().is_missed());
    let missed = picture(&mut hand);
    let (mut other, ..) = hand_with(&spots(8.0, 30.0));
    other.until_settled();
    other.until("measured", |window| window.results().for_texture(window.settled()).is_some());
    assert!(!other.window.state().results().outcome().unwrap().is_missed());
    let met = picture(&mut other);
    let tab = hand.window.get_by_role_and_label(Role::Button, "Result").rect();
    let corner = |picture: &image::RgbaImage| {
        let [x, y] = [tab.right() as u32 - 13, tab.top() as u32 + 1];
        image::imageops::crop_imm(picture, x, y, 12, 12).to_image()
    };
    assert_ne!(corner(&missed), corner(&met));
    hand.press("Result");
    until_known(&mut hand);
    assert!(hand.window.query_all_by_label_contains("their centres need about").next().is_some());
}
