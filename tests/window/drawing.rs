//! Drawing: strokes of the pointer become the intended marks.

use dapple::document::{Path, Stroke};
use dapple_engine::marks::distance_to_segment;
use egui::{Event, Key, Modifiers, PointerButton};
use egui_kittest::kittest::Queryable;

use crate::hand::{Hand, hand};

#[test]
fn a_closed_stroke_becomes_an_ellipse_when_it_ends() {
    let mut hand = hand();
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 30.0);
    let [ellipse] = hand.ellipses()[..] else { panic!("{:?}", hand.strokes()) };
    for (found, drawn) in ellipse.center.into_iter().zip([150.0, 200.0]) {
        assert!((found - drawn).abs() < 1.5, "{ellipse:?}");
    }
    assert!((ellipse.area() / (std::f64::consts::PI * 800.0) - 1.0).abs() < 0.05, "{ellipse:?}");
    assert!((ellipse.major_angle() - 30.0).abs() < 3.0, "{ellipse:?}");
}

#[test]
fn an_open_stroke_becomes_a_line_as_wide_as_the_pen() {
    let mut hand = hand();
    hand.drag(&[[100.0, 100.0], [150.0, 121.0], [200.0, 139.0], [300.0, 180.0]]);
    let [line] = hand.lines()[..] else { panic!("{:?}", hand.strokes()) };
    assert!((line.angle() - 21.8).abs() < 1.0, "{line:?}");
    assert!((line.length() - 215.0).abs() < 8.0, "{line:?}");
    assert_eq!(line.width, 6.0);
}

/// The pointer events of a stroke, from press to release.
fn stroke(hand: &Hand, points: impl IntoIterator<Item = [f64; 2]>) -> Vec<Event> {
    let path: Vec<_> = points.into_iter().map(|point| hand.at(point)).collect();
    let button = |pos, pressed| Event::PointerButton {
        pos,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    };
    let mut events = vec![Event::PointerMoved(path[0]), button(path[0], true)];
    events.extend(path.iter().map(|at| Event::PointerMoved(*at)));
    events.push(button(path[path.len() - 1], false));
    events
}

/// The points of a circle.
fn circle([x, y]: [f64; 2], radius: f64) -> impl Iterator<Item = [f64; 2]> {
    let turn = |step| (std::f64::consts::TAU * f64::from(step) / 30.0).sin_cos();
    (0..=30).map(turn).map(move |(sin, cos)| [x + radius * cos, y + radius * sin])
}

#[test]
fn quick_circles_within_one_frame_are_separate_marks_and_undo_steps() {
    let mut hand = hand();
    let places = [80.0, 160.0, 240.0, 320.0, 400.0].map(|x| [x, 200.0]);
    let events: Vec<Event> = places.iter().flat_map(|at| stroke(&hand, circle(*at, 20.0))).collect();
    hand.window.input_mut().events.extend(events);
    hand.rest();
    assert!(hand.lines().is_empty() && hand.document().layers.len() == 1, "{:?}", hand.strokes());
    let found: Vec<f64> = hand.ellipses().iter().map(|ellipse| ellipse.center[0].round()).collect();
    assert_eq!(found, places.map(|[x, _]| x));
    hand.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(hand.ellipses().len(), 4);
}

#[test]
fn a_stroke_that_ends_in_the_frame_in_which_the_next_begins_is_not_joined_to_it() {
    let mut hand = hand();
    let [first, second] = [[100.0, 200.0], [300.0, 200.0]].map(|at| stroke(&hand, circle(at, 30.0)));
    let frames = [&first[..10], &[&first[10..], &second[..12]].concat(), &second[12..]];
    for events in frames {
        hand.window.input_mut().events.extend(events.iter().cloned());
        hand.window.step();
    }
    hand.rest();
    let found: Vec<f64> = hand.ellipses().iter().map(|ellipse| ellipse.center[0].round()).collect();
    assert_eq!(found, [100.0, 300.0]);
}

#[test]
fn quick_clicks_within_one_frame_each_add_an_ellipse() {
    let mut hand = hand();
    hand.key(Modifiers::NONE, Key::E);
    let events: Vec<Event> =
        [100.0, 200.0, 300.0].iter().flat_map(|x| stroke(&hand, [[*x, 150.0]])).collect();
    hand.window.input_mut().events.extend(events);
    hand.rest();
    assert_eq!(hand.ellipses().len(), 3);
}

/// The points of an S, 200 px long.
fn wave() -> Vec<[f64; 2]> {
    let at = |k: u32| {
        let t = f64::from(k) / 80.0;
        [120.0 + 200.0 * t, 250.0 + 50.0 * (std::f64::consts::TAU * t).sin()]
    };
    (0..=80).map(at).collect()
}

fn paths(hand: &Hand) -> Vec<Path> {
    let path = |stroke| if let Stroke::Path(path) = stroke { Some(path) } else { None };
    hand.strokes().into_iter().filter_map(path).collect()
}

#[test]
fn a_bent_stroke_stays_the_path_that_was_drawn() {
    let mut hand = hand();
    hand.drag(&wave());
    let [path] = &paths(&hand)[..] else { panic!("{:?}", hand.strokes()) };
    assert!((5..24).contains(&path.points.len()), "{path:?}");
    for point in wave() {
        let near = path.segments().map(|piece| distance_to_segment(point, [piece.from, piece.to]));
        assert!(near.fold(f64::INFINITY, f64::min) < 3.0, "{point:?}: {path:?}");
    }
}

#[test]
fn a_path_is_moved_bent_by_its_points_copied_and_all_of_it_undone() {
    let mut hand = hand();
    hand.drag(&wave());
    let drawn = paths(&hand)[0].clone();
    hand.key(Modifiers::NONE, Key::V);
    let middle = drawn.center();
    hand.drag(&[middle, [middle[0] + 30.0, middle[1] + 20.0], [middle[0] + 60.0, middle[1] + 40.0]]);
    let moved = paths(&hand)[0].clone();
    for (from, to) in drawn.points.iter().zip(&moved.points) {
        assert!(
            (to[0] - from[0] - 60.0).abs() < 0.2 && (to[1] - from[1] - 40.0).abs() < 0.2,
            "{from:?} {to:?}"
        );
    }
    let end = *moved.points.last().unwrap();
    hand.drag(&[end, [end[0] + 20.0, end[1]], [end[0] + 40.0, end[1] - 30.0]]);
    let bent = paths(&hand)[0].clone();
    let last = bent.points.last().unwrap();
    assert!((last[0] - end[0] - 40.0).abs() < 0.2 && (last[1] - end[1] + 30.0).abs() < 0.2, "{last:?}");
    assert_eq!(bent.points[..bent.points.len() - 1], moved.points[..moved.points.len() - 1]);
    hand.press("Duplicate");
    let [_, copy] = &paths(&hand)[..] else { panic!("{:?}", hand.strokes()) };
    assert_eq!((copy.width, copy.points.len()), (bent.width, bent.points.len()));
    for before in [bent, moved, drawn] {
        hand.key(Modifiers::COMMAND, Key::Z);
        assert_eq!(paths(&hand), [before]);
    }
}

#[test]
fn notes_on_what_will_not_grow_as_drawn_appear_while_drawing() {
    let mut hand = hand();
    let told = |hand: &Hand, text: &str| hand.window.query_all_by_label_contains(text).next().is_some();
    hand.key(Modifiers::NONE, Key::L);
    hand.drag(&[[100.0, 100.0], [200.0, 150.0], [300.0, 200.0]]);
    assert!(!told(&hand, "Will not grow as drawn"));
    hand.drag(&[[100.0, 200.0], [200.0, 150.0], [300.0, 100.0]]);
    assert!(
        told(&hand, "lines cross, so this layer grows a weave") && !told(&hand, "Will not grow as drawn")
    );
    hand.press("Grow stripes instead");
    hand.until_settled();
    assert!(told(&hand, "Will not grow as drawn") && told(&hand, "these lines cross each other"));
    hand.press("Grow a weave");
    assert_eq!(hand.document().layers[0].system.name(), "weave");
    assert!(!told(&hand, "Will not grow as drawn"));
    for _ in 0..3 {
        hand.key(Modifiers::COMMAND, Key::Z);
    }
    assert!(!told(&hand, "Will not grow as drawn"));
    hand.key(Modifiers::NONE, Key::B);
    let star = (0..=200).map(|k| f64::from(k) / 200.0 * std::f64::consts::TAU);
    let star: Vec<[f64; 2]> = star
        .map(|turn| (50.0 * (1.0 + 0.35 * (5.0 * turn).cos()), turn.sin_cos()))
        .map(|(radius, (s, c))| [300.0 + radius * c, 350.0 + radius * s])
        .collect();
    hand.drag(&star);
    assert!(told(&hand, "this outline is read as an ellipse"));
}

#[test]
fn outlines_side_by_side_suggest_cells() {
    let mut hand = hand();
    let suggested =
        |hand: &Hand| hand.window.query_all_by_label_contains("lie side by side").next().is_some();
    hand.press("Ellipse");
    for left in [60.0, 182.0, 304.0] {
        assert!(!suggested(&hand), "{left}");
        hand.drag(&[[left, 100.0], [left + 50.0, 140.0], [left + 100.0, 180.0]]);
    }
    assert!(suggested(&hand), "{:?}", hand.strokes());
    hand.press("Grow cells");
    assert_eq!(hand.document().layers[0].system.name(), "cells");
    assert!(!suggested(&hand));
    // A line now goes to the same layer.
    hand.press("Line");
    hand.drag(&[[60.0, 300.0], [160.0, 320.0], [300.0, 320.0]]);
    let document = hand.document();
    assert_eq!((document.layers.len(), document.layers[0].strokes.len()), (1, 4));
    assert!(matches!(document.layers[0].strokes[3], Stroke::Line(_)), "{:?}", document.layers[0].strokes);
}

#[test]
fn marks_denser_than_spots_grow_patches_unless_spots_are_chosen() {
    let mut hand = hand();
    let told =
        |hand: &Hand| hand.window.query_all_by_label_contains("this layer grows patches").next().is_some();
    hand.press("Ellipse");
    for at in 0..9 {
        let [left, top] = [at % 3, at / 3].map(|step| 100.0 + 90.0 * f64::from(step));
        hand.drag(&[[left, top], [left + 30.0, top + 30.0], [left + 60.0, top + 60.0]]);
    }
    assert!(told(&hand), "{:?}", hand.strokes());
    assert_eq!(hand.document().layers[0].system.name(), "auto");
    hand.press("Grow spots instead");
    hand.until_settled();
    assert_eq!(hand.document().layers[0].system.name(), "meinhardt-spots");
    assert!(!told(&hand));
    hand.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(hand.document().layers[0].system.name(), "auto");
    assert!(told(&hand));
}

#[test]
fn a_click_with_the_pen_adds_nothing() {
    let mut hand = hand();
    hand.click([100.0, 100.0]);
    assert!(hand.strokes().is_empty());
}

#[test]
fn an_ellipse_is_dragged_from_corner_to_corner() {
    let mut hand = hand();
    hand.press("Ellipse");
    hand.drag(&[[100.0, 100.0], [140.0, 130.0], [180.0, 140.0]]);
    let [ellipse] = hand.ellipses()[..] else { panic!("{:?}", hand.strokes()) };
    for (found, drawn) in ellipse.center.into_iter().chain(ellipse.radii).zip([140.0, 120.0, 40.0, 20.0]) {
        assert!((found - drawn).abs() < 0.1, "{ellipse:?}");
    }
}

#[test]
fn shift_makes_a_circle_and_a_click_adds_one_like_it() {
    let mut hand = hand();
    hand.key(Modifiers::NONE, Key::E);
    hand.drag_with(&[[100.0, 100.0], [120.0, 110.0], [160.0, 130.0]], Modifiers::SHIFT);
    hand.click([300.0, 300.0]);
    let [circle, again] = hand.ellipses()[..] else { panic!("{:?}", hand.strokes()) };
    assert!((circle.radii[0] - 30.0).abs() < 0.1 && circle.radii[0] == circle.radii[1], "{circle:?}");
    assert_eq!(again.radii, circle.radii);
    assert!((again.center[0] - 300.0).abs() < 0.1);
}

#[test]
fn a_line_takes_one_of_the_four_widths() {
    let mut hand = hand();
    hand.key(Modifiers::NONE, Key::L);
    hand.press("12 px wide");
    hand.drag(&[[100.0, 100.0], [200.0, 150.0], [300.0, 100.0]]);
    hand.drag_with(&[[100.0, 300.0], [200.0, 310.0], [300.0, 310.0]], Modifiers::SHIFT);
    let [line, straight] = hand.lines()[..] else { panic!("{:?}", hand.strokes()) };
    assert_eq!(line.width, 12.0);
    assert!((line.to[0] - 300.0).abs() < 0.1 && (line.to[1] - 100.0).abs() < 0.1, "{line:?}");
    assert!(straight.angle().abs() < 1e-6, "{straight:?}");
}

#[test]
fn a_line_among_ellipses_adds_a_layer_for_lines() {
    let mut hand = hand();
    hand.draw_round([150.0, 200.0], [40.0, 20.0], 0.0);
    hand.key(Modifiers::NONE, Key::L);
    hand.drag(&[[300.0, 300.0], [400.0, 300.0]]);
    hand.key(Modifiers::NONE, Key::E);
    hand.drag(&[[300.0, 100.0], [340.0, 120.0]]);
    let document = hand.document();
    let counts: Vec<usize> = document.layers.iter().map(|layer| layer.strokes.len()).collect();
    assert_eq!(counts, [2, 1]);
    document.check("two layers").unwrap();
}

#[test]
fn the_eraser_deletes_the_marks_it_touches() {
    let mut hand = hand();
    hand.key(Modifiers::NONE, Key::E);
    for x in [100.0, 200.0, 300.0, 400.0] {
        hand.drag(&[[x - 20.0, 180.0], [x + 20.0, 220.0]]);
    }
    hand.key(Modifiers::NONE, Key::X);
    hand.drag(&[[190.0, 150.0], [195.0, 200.0], [310.0, 200.0]]);
    let left: Vec<f64> = hand.ellipses().iter().map(|ellipse| ellipse.center[0].round()).collect();
    assert_eq!(left, [100.0, 400.0]);
}

#[test]
fn escape_cancels_the_stroke_in_progress() {
    let mut hand = hand();
    hand.key(Modifiers::NONE, Key::E);
    let [from, to] = [hand.at([100.0, 100.0]), hand.at([200.0, 200.0])];
    hand.window.drag_at(from);
    hand.window.step();
    hand.window.hover_at(to);
    hand.window.step();
    hand.key(Modifiers::NONE, Key::Escape);
    hand.window.drop_at(to);
    hand.rest();
    assert!(hand.strokes().is_empty());
}

#[test]
fn undo_while_a_stroke_is_drawn_cancels_that_stroke_only() {
    let mut hand = hand();
    for x in [110.0, 220.0] {
        hand.draw_round([x, 120.0], [30.0, 20.0], 20.0);
    }
    let events = stroke(&hand, circle([300.0, 300.0], 40.0));
    let (begun, rest) = events.split_at(12);
    hand.window.input_mut().events.extend(begun.iter().cloned());
    hand.rest();
    hand.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(hand.ellipses().len(), 2, "the earlier marks stay");
    hand.window.input_mut().events.extend(rest.iter().cloned());
    hand.rest();
    assert_eq!(hand.ellipses().len(), 2, "the cancelled stroke adds nothing");
    hand.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(hand.ellipses().len(), 1, "the next undo is the step before");
}

#[test]
fn movement_after_the_button_is_released_is_no_part_of_the_stroke() {
    let mut hand = hand();
    let mut path = Vec::new();
    for i in 0..=40 {
        let (y, x) = (std::f64::consts::TAU * f64::from(i) / 40.0).sin_cos();
        path.push(hand.at([150.0 + 40.0 * x, 200.0 + 20.0 * y]));
    }
    let button = |pos, pressed| Event::PointerButton {
        pos,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    };
    let (first, last, away) = (path[0], path[40], hand.at([400.0, 400.0]));
    hand.window.hover_at(first);
    hand.window.step();
    hand.window.event(button(first, true));
    hand.window.step();
    for at in path {
        hand.window.hover_at(at);
        hand.window.step();
    }
    // All events come in one frame, like on a busy machine.
    hand.window.input_mut().events.extend([button(last, false), Event::PointerMoved(away)]);
    hand.window.step();
    hand.rest();
    assert_eq!(hand.ellipses().len(), 1);
    assert!((hand.ellipses()[0].center[0] - 150.0).abs() < 1.0, "{:?}", hand.ellipses());
}

#[test]
fn an_empty_canvas_offers_starters_until_the_first_mark() {
    let mut hand = hand();
    let offered = |hand: &Hand| hand.window.query_by_label("A leopard").is_some();
    assert!(offered(&hand));
    hand.press("Stripes");
    assert!(hand.lines().len() > 2 && !offered(&hand));
    hand.key(Modifiers::COMMAND, Key::Z);
    assert!(hand.strokes().is_empty() && offered(&hand), "one step to undo");
    hand.press("Spots");
    assert!(hand.ellipses().len() > 3);
    hand.key(Modifiers::COMMAND, Key::Z);
    hand.press("A leopard");
    hand.rest();
    assert_eq!(hand.document().layers.len(), 2);
}
