use proptest::prelude::*;

use super::spaced::spaced;
use super::*;
use crate::attributes::regions::RegionGrid;
use crate::document::{DutyChoice, Layer, Stroke, SystemChoice};
use crate::marks::{Ellipse, Line};
use crate::rd::System;
use crate::synth::drawn::sketch_targets;
use crate::synth::marks::plan::look_up;

fn planned_alone(training: &Training, document: &Document) -> Lookup {
    let map = sketch_targets::region_map(document, 0, "").unwrap();
    look_up(training, document.layers[0].wanted_system(), &map).unwrap()
}

fn document(strokes: Vec<Stroke>, system: SystemChoice) -> Document {
    let layers = vec![Layer { strokes, system, ..Layer::default() }];
    Document { size: [512, 512], regions: Some([2, 2]), layers, ..Document::default() }
}

/// Applies the change for region 0; gives the number of notes before and after.
fn changed(training: &Training, document: &Document) -> (usize, Option<usize>) {
    let first = planned_alone(training, document);
    let notes = |plan: &Lookup| plan.answers[0].notes.iter().filter(|note| note.is_beyond()).count();
    let before = notes(&first);
    let Some(reach) = reach(training, document, &[Some(&first)], 0, 0) else { return (before, None) };
    let mut changed = document.clone();
    if let Some(duty) = reach.duty {
        changed.layers[0].options.duty = DutyChoice::Given(duty);
    }
    for (stroke, mark) in reach.marks {
        changed.layers[0].strokes[stroke] = Stroke::from(mark);
    }
    (before, Some(notes(&planned_alone(training, &changed))))
}

fn spots(area: f64, aspect: f64, apart: f64) -> Vec<Stroke> {
    let at = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.866], [1.5, 0.866], [0.0, 1.732]];
    let place = |at: [f64; 2]| at.map(|x| 40.0 + x * apart);
    at.map(|at| Stroke::Ellipse(Ellipse::from_area(place(at), area, aspect, 30.0))).into()
}

#[test]
fn spots_that_are_too_close_are_moved_apart_and_then_reached() {
    let training = Training::default();
    let document = document(spots(500.0, 0.9, 35.0), SystemChoice::Of(System::MEINHARDT_SPOTS.description()));
    let (before, after) = changed(&training, &document);
    assert!(before > 0);
    assert_eq!(after, Some(0));
    let first = planned_alone(&training, &document);
    let reach = reach(&training, &document, &[Some(&first)], 0, 0).unwrap();
    assert!(reach.text.contains("% farther apart"), "{}", reach.text);
    // The densest examples are rounder than these, and their areas a little larger.
    for (stroke, mark) in reach.marks {
        let [Some(before), Some(after)] = [document.layers[0].strokes[stroke].mark(), Some(mark)]
            .map(|mark| mark.as_ref().and_then(Mark::ellipse))
        else {
            panic!("an ellipse stays one")
        };
        assert!((after.area() / before.area() - 1.0).abs() < 0.03, "{}", reach.text);
        assert!(after.aspect() > before.aspect(), "{}", reach.text);
    }
}

#[test]
fn spots_that_are_moved_apart_beside_an_edge_stay_on_the_canvas() {
    let layout = RegionGrid { size: [512.0; 2], grid: [1, 1], edges: crate::grid::Edges::Closed };
    let centers = [[20.0, 256.0], [60.0, 256.0], [480.0, 256.0]];
    let moved = spaced(&centers, &[[15.0, 10.0]; 3], 1.03, &layout, [0, 0]).unwrap();
    for (before, after) in [(20.0, moved[0][0]), (480.0, moved[2][0])] {
        assert!((15.0 - 1e-9..=497.0).contains(&after), "{before} {after}");
    }
    assert!((moved[1][0] - moved[0][0] - 1.03 * 40.0).abs() < 1e-9);
    // A mark that reached over the edge may still do so, but no farther.
    let moved = spaced(&[[10.0, 256.0], [100.0, 256.0]], &[[15.0, 10.0]; 2], 1.5, &layout, [0, 0]).unwrap();
    assert!(moved[0][0] >= 10.0 - 1e-9, "{moved:?}");
}

#[test]
fn without_room_spots_become_smaller() {
    let training = Training::default();
    let document =
        document(spots(9000.0, 0.95, 120.0), SystemChoice::Of(System::MEINHARDT_SPOTS.description()));
    let first = planned_alone(&training, &document);
    let reach = reach(&training, &document, &[Some(&first)], 0, 0).unwrap();
    assert!(reach.text.contains("smaller"), "{}", reach.text);
    assert_eq!(changed(&training, &document).1, Some(0));
}

#[test]
fn a_duty_that_no_system_has_becomes_one_that_a_system_has() {
    let training = Training::default();
    let line = Line { from: [20.0, 100.0], to: [220.0, 120.0], width: 1.0 };
    let document = document(vec![Stroke::Line(line)], SystemChoice::Auto);
    let (before, after) = changed(&training, &document);
    assert!(before == 0 || after == Some(0), "{before} {after:?}");
}

#[test]
fn a_region_that_can_be_reached_is_not_changed() {
    let training = Training::default();
    let document = document(spots(500.0, 0.8, 60.0), SystemChoice::Of(System::MEINHARDT_SPOTS.description()));
    assert_eq!(changed(&training, &document), (0, None));
}

#[test]
fn a_change_that_narrowly_fails_is_increased() {
    let training = Training::default();
    let document =
        document(spots(1000.0, 0.2333, 80.0), SystemChoice::Of(System::TURING_SPOTS.description()));
    let (before, after) = changed(&training, &document);
    assert!(before > 0);
    assert_eq!(after, Some(0));
}

#[test]
fn dense_spots_whose_change_ends_just_short_of_the_limit_are_moved_farther_apart() {
    let (area, packing) = (60.0f64, 0.4655);
    let document = document(
        spots(area, 0.828, (area / packing).sqrt()),
        SystemChoice::Of(System::MEINHARDT_SPOTS.description()),
    );
    assert_eq!(changed(&Training::default(), &document).1, Some(0));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    #[test]
    fn a_reachable_change_is_found_for_any_spots(
        area in 60.0f64..3000.0,
        aspect in 0.15f64..1.0,
        packing in 0.03f64..0.7,
        turing in any::<bool>(),
    ) {
        let training = Training::default();
        let system = if turing { SystemChoice::Of(System::TURING_SPOTS.description()) } else { SystemChoice::Of(System::MEINHARDT_SPOTS.description()) };
        let apart = (area / packing).sqrt().min(110.0);
        let (before, after) = changed(&training, &document(spots(area, aspect, apart), system));
        prop_assert!(before == 0 || after == Some(0), "{before} {after:?}");
    }
}
