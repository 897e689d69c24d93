//! Editing one gradient: its stops, the bar and the curve.

use egui::pos2;

use super::*;

#[test]
fn a_stop_is_dragged_along_the_bar_in_one_step() {
    let (mut hand, _folder) = with_layers(1);
    let width = hand.place("Add a stop").width();
    let from = hand.place("Stop 2 of 4").center();
    let before = hand.document();
    hand.pull(from, from + vec2(0.1 * width, 0.0), |_| {});
    let places = hand.places();
    assert!((places[1] - 0.5).abs() < 0.006, "{places:?}");
    assert_eq!([places[0], places[2], places[3]], [0.0, 0.6, 1.0]);
    hand.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(hand.document(), before, "one drag is one step");
    hand.key(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    assert_eq!(hand.places(), places);
}

#[test]
fn a_stop_is_dragged_past_another() {
    let (mut hand, _folder) = with_layers(1);
    let before = hand.colours(0);
    let width = hand.place("Add a stop").width();
    let from = hand.place("Stop 2 of 4").center();
    hand.pull(from, from + vec2(0.4 * width, 0.0), |_| {});
    let after = hand.colours(0);
    assert_eq!(after.stops[1], before.stops[2]);
    assert_eq!(after.stops[2].colour, before.stops[1].colour);
    assert!((after.stops[2].at - 0.8).abs() < 0.006);
}

#[test]
fn a_stop_is_added_by_a_click_and_removed_by_dragging_it_off() {
    let (mut hand, _folder) = with_layers(1);
    let before = hand.document();
    let bar = hand.place("Add a stop");
    hand.tap(bar.left_center() + vec2(0.2 * bar.width(), 0.0));
    assert_eq!(hand.places().len(), 5);
    assert!((hand.places()[1] - 0.2).abs() < 0.006, "{:?}", hand.places());
    let was = Gradient::default_for_layer(0);
    let is = hand.colours(0).gradient();
    for v in [0.1, 0.2, 0.3, 0.5] {
        let off = (0..3).map(|i| was.colour(v)[i].abs_diff(is.colour(v)[i])).max().unwrap();
        assert!(off <= 1, "a stop more changes nothing at {v}");
    }
    let pin = hand.place("Stop 2 of 5").center();
    hand.pull(pin, pin + vec2(10.0, 90.0), |hand| {
        assert_eq!(hand.places().len(), 4, "the picture shows it before the hand lets go");
    });
    assert_eq!(hand.places(), [0.0, 0.4, 0.6, 1.0]);
    hand.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(hand.places().len(), 5);
    hand.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(hand.document(), before);
}

#[test]
fn escape_cancels_the_drag_of_a_stop() {
    let (mut hand, _folder) = with_layers(1);
    let before = hand.places();
    let pin = hand.place("Stop 3 of 4").center();
    hand.pull(pin, pin + vec2(40.0, 0.0), |hand| {
        assert_ne!(hand.places(), before);
        hand.key(Modifiers::NONE, Key::Escape);
        assert_eq!(hand.places(), before);
    });
    assert_eq!(hand.places(), before);
}

#[test]
fn handles_bend_the_transition() {
    let (mut hand, _folder) = with_layers(1);
    hand.focus("Stop 1 of 4");
    hand.reach("Bend by hand");
    let first = hand.place("First handle").center();
    let second = hand.place("Second handle").center();
    // The handles of a straight transition are in the corners, so they give the size of the plot.
    let room = second - first;
    hand.pull(first, first + vec2(0.5 * room.x, 0.25 * room.y), |_| {});
    let bend = hand.colours(0).bend(0);
    assert!((bend[0] - 0.5).abs() < 0.02 && (bend[1] - 0.25).abs() < 0.03, "{bend:?}");
    assert_eq!(bend[2..], [1.0, 1.0]);
    let eased = Bend(bend).ease(0.5);
    assert!(eased < 0.45, "it starts slowly: {eased}");
    hand.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(hand.colours(0).bend(0), [0.0, 0.0, 1.0, 1.0]);
    hand.press("Slow start and end");
    assert_eq!(hand.colours(0).bend(0), [0.42, 0.0, 0.58, 1.0]);
}

#[test]
fn colours_are_edited_by_keys_alone() {
    let (mut hand, _folder) = with_layers(1);
    hand.focus("Stop 2 of 4");
    for key in [Key::ArrowRight, Key::ArrowRight, Key::ArrowUp] {
        hand.key(Modifiers::NONE, key);
    }
    assert_eq!(hand.places(), [0.0, 0.43, 0.6, 1.0]);
    hand.key(Modifiers::SHIFT, Key::ArrowRight);
    hand.key(Modifiers::SHIFT, Key::ArrowRight);
    assert_eq!(hand.places(), [0.0, 0.6, 0.63, 1.0], "past the next");
    hand.key(Modifiers::NONE, Key::Delete);
    assert_eq!(hand.places(), [0.0, 0.6, 1.0]);
    assert_eq!(hand.strokes().len(), 1, "the marks stay");

    hand.focus("Add a stop");
    hand.key(Modifiers::NONE, Key::Enter);
    assert_eq!(hand.places().len(), 4, "at the midpoint of the chosen transition");

    hand.press("Straight");
    hand.reach("Bend by hand");
    hand.focus("First handle");
    hand.key(Modifiers::SHIFT, Key::ArrowRight);
    hand.key(Modifiers::NONE, Key::ArrowUp);
    let gap = (0..3).find(|gap| hand.colours(0).bend(*gap)[0] == 0.1);
    let gap = gap.unwrap_or_else(|| panic!("{:?}", hand.colours(0)));
    assert_eq!(hand.colours(0).bend(gap)[1], 0.01);
    hand.key(Modifiers::NONE, Key::Delete);
    assert_eq!(hand.colours(0).bend(gap), [0.0, 0.0, 1.0, 1.0]);

    hand.focus("Stop 1 of 4");
    hand.key(Modifiers::NONE, Key::Enter);
    let before = hand.colours(0).stops[0].colour;
    assert!(hand.window.query_by_label_contains("Saturation and brightness").unwrap().is_focused());
    hand.key(Modifiers::SHIFT, Key::ArrowDown);
    let darker = hand.colours(0).stops[0].colour;
    assert!(darker[0] < before[0], "{darker:?}");
    hand.focus("Hue");
    hand.key(Modifiers::SHIFT, Key::ArrowRight);
    assert_ne!(hand.colours(0).stops[0].colour, darker);
    hand.key(Modifiers::NONE, Key::Escape);
    assert!(hand.window.query_by_label_contains("Saturation and brightness").is_none());
    hand.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(hand.colours(0).stops[0].colour, darker);
}

#[test]
fn a_colour_is_typed() {
    let (mut hand, _folder) = with_layers(1);
    let mut types = |text: &str| {
        hand.click_role(Role::TextInput, "Colour in hexadecimal digits");
        hand.rest();
        hand.key(Modifiers::COMMAND, Key::A);
        hand.window.event(Event::Text(text.to_owned()));
        hand.window.step();
        hand.key(Modifiers::NONE, Key::Enter);
        hand.colours(0).stops[0].colour
    };
    assert_eq!(types("#0a80ff"), [0x0a, 0x80, 0xff]);
    assert_eq!(types("fc0"), [0xff, 0xcc, 0x00]);
    assert_eq!(types("reddish"), [0xff, 0xcc, 0x00], "what is no colour changes nothing");
    hand.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(hand.colours(0).stops[0].colour, [0x0a, 0x80, 0xff]);
}

#[test]
fn the_opacity_of_a_stop_is_typed_and_pulled_and_the_texture_has_it() {
    let (mut hand, _folder) = with_layers(1);
    hand.until_settled();
    hand.focus("Stop 1 of 4");
    hand.key(Modifiers::NONE, Key::Enter);
    hand.type_into("Opacity in per cent", "40");
    assert_eq!(hand.colours(0).stops[0].alpha, 102);
    hand.focus("Opacity, 40 %");
    hand.key(Modifiers::NONE, Key::ArrowLeft);
    assert_eq!(hand.colours(0).stops[0].alpha, 99);
    hand.key(Modifiers::NONE, Key::Escape);
    hand.click_role(Role::TextInput, "Colour in hexadecimal digits");
    hand.rest();
    hand.key(Modifiers::COMMAND, Key::A);
    hand.window.event(Event::Text("#10203000".to_owned()));
    hand.window.step();
    hand.key(Modifiers::NONE, Key::Enter);
    let stop = hand.colours(0).stops[0];
    assert_eq!((stop.colour, stop.alpha), ([0x10, 0x20, 0x30], 0));
    hand.until("a transparent texture", |window| {
        window.growth().picture.as_ref().is_some_and(|picture| !picture.is_opaque)
    });
}

#[test]
fn a_checkerboard_is_seen_through_a_transparent_texture() {
    let (mut hand, _folder) = with_layers(1);
    hand.until_settled();
    assert_eq!(squares(&mut hand), [0, 0], "nothing is transparent yet");
    hand.focus("Stop 1 of 4");
    hand.key(Modifiers::NONE, Key::Enter);
    hand.type_into("Opacity in per cent", "0");
    hand.key(Modifiers::NONE, Key::Escape);
    hand.until("a transparent texture", |window| {
        window.growth().picture.as_ref().is_some_and(|picture| !picture.is_opaque)
    });
    let [light, dark] = squares(&mut hand);
    assert!(
        light.min(dark) > 10_000 && 2 * light.min(dark) > light.max(dark),
        "{light} light px, {dark} dark"
    );
}

/// The number of px of the shown texture that have the light gray and the dark gray of the checkerboard.
fn squares(hand: &mut Hand) -> [usize; 2] {
    let shown = hand.place("Texture, finished");
    let shot = picture(hand);
    let inside = |x: u32, y: u32| shown.contains(pos2(x as f32, y as f32));
    [250, 218].map(|gray: u8| {
        // The ground contains a trace of the next colour.
        let is_gray = |px: &image::Rgba<u8>| px.0[..3].iter().all(|value| value.abs_diff(gray) <= 5);
        shot.enumerate_pixels().filter(|(x, y, px)| inside(*x, *y) && is_gray(px)).count()
    })
}

#[test]
fn stops_are_swapped_and_the_gradient_is_reversed() {
    let (mut hand, _folder) = with_layers(1);
    let before = hand.colours(0);
    hand.focus("Stop 1 of 4");
    hand.press("Swap with next");
    assert_eq!(hand.colours(0).stops[0].colour, before.stops[1].colour);
    hand.press("Swap with previous");
    assert_eq!(hand.colours(0), before);
    hand.press("Reverse");
    let reversed = hand.colours(0);
    assert_eq!(reversed.stops[0].colour, before.stops[3].colour);
    hand.press("Reverse");
    assert_eq!(hand.colours(0), before);
    hand.press("Remove");
    assert_eq!(hand.places().len(), 3);
}

#[test]
fn the_bar_and_the_curve_show_the_values_of_the_library() {
    let (mut hand, _folder) = with_layers(1);
    hand.reach("Colours: tiger");
    hand.focus("Stop 2 of 4");
    hand.window.get_by_label("Add a stop").scroll_to_me();
    hand.window.run_steps(60);
    let bar = hand.place("Add a stop");
    hand.window.get_by_role(Role::Canvas).focus();
    let seen = picture(&mut hand);
    let px = |picture: &image::RgbaImage, x: f32, y: f32| {
        let [red, green, blue, _] = picture.get_pixel(x as u32, y as u32).0;
        [red, green, blue]
    };
    let off = |a: [u8; 3], b: [u8; 3]| (0..3).map(|i| a[i].abs_diff(b[i])).max().unwrap_or(0);
    let table = hand.colours(0).gradient().table();
    for x in bar.left().ceil() as u32 + 1..bar.right() as u32 - 1 {
        let x = x as f32 + 0.5;
        // The exact border between columns depends on the resolution.
        let near = [-1.0, -0.5, 0.0, 0.5, 1.0].map(|by| table.colour((x + by - bar.left()) / bar.width()));
        let worst = near.into_iter().map(|colour| off(colour, px(&seen, x, bar.center().y))).min();
        assert!(worst <= Some(3), "the bar at {x} is off by {worst:?}");
    }
    // The line of the curve is the darkest px of its column.
    hand.reach("Bend by hand");
    hand.window.get_by_label("First handle").scroll_to_me();
    hand.window.run_steps(60);
    let [first, second] = ["First handle", "Second handle"].map(|name| hand.place(name).center());
    hand.window.get_by_role(Role::Canvas).focus();
    let seen = picture(&mut hand);
    let bend = hand.colours(0).bend(1);
    assert_eq!(bend, [0.42, 0.0, 0.58, 1.0]);
    let unit = (second.x - first.x) / 0.16;
    for way in [0.2, 0.3, 0.7, 0.8] {
        let x = first.x + (way - 0.42) * unit;
        let dark = |y: &u32| px(&seen, x, *y as f32).into_iter().map(u32::from).sum::<u32>();
        let (top, bottom) = (second.y as u32 + 4, first.y as u32 - 4);
        let darkest = (top..bottom).min_by_key(dark).unwrap() as f32 + 0.5;
        let eased = Bend(bend).ease(f64::from(way)) as f32;
        let expected = first.y + eased * (second.y - first.y);
        assert!((darkest - expected).abs() < 2.5, "at {way} the curve is at {darkest}, not {expected}");
    }
}
