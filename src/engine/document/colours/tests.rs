use crate::colour::PRESETS;
use crate::document::colours::*;
use proptest::prelude::*;

fn cheetah() -> Colours {
    Colours::default_for_layer(0)
}

/// Random colours: up to six stops, some bent.
pub(in crate::document) fn any_colours() -> impl Strategy<Value = Colours> {
    // Mostly opaque, as in most documents.
    let alpha = prop_oneof![3 => Just(u8::MAX), 1 => any::<u8>()];
    let stops = prop::collection::vec((0..=1000_u32, any::<[u8; 3]>(), alpha), 1..6);
    let bends = prop::collection::vec([0.0..=1.0, -2.0..=3.0, 0.0..=1.0, -2.0..=3.0], 0..5);
    (stops, bends).prop_map(|(mut stops, bends)| {
        stops.sort_by_key(|(at, _, _)| *at);
        let bends = bends.into_iter().take(stops.len() - 1).collect();
        let stops = stops
            .into_iter()
            .map(|(at, colour, alpha)| Stop { at: f64::from(at) / 1000.0, colour, alpha })
            .collect();
        let mut colours = Colours { stops, bends, ..Colours::new([]) };
        colours.tidy();
        colours
    })
}

/// The colour over black, since the colour of a transparent stop does not matter.
fn seen(colours: &Colours, v: f32) -> [u8; 3] {
    let [red, green, blue, alpha] = colours.gradient().rgba(v).map(u32::from);
    [red, green, blue].map(|channel| (channel * alpha / 255) as u8)
}

/// Largest difference of a channel over all pattern values.
fn difference(one: &Colours, other: &Colours) -> u8 {
    let [one, other] = [one, other].map(Colours::gradient);
    let of = |v: f32| {
        let [a, b] = [&one, &other].map(|gradient| gradient.colour(v));
        (0..3).map(|channel| a[channel].abs_diff(b[channel])).max().unwrap_or(0)
    };
    (0..=200).map(|i| of(i as f32 / 200.0)).max().unwrap_or(0)
}

#[test]
fn default_colours_are_those_of_the_painter() {
    for layer in 0..6 {
        let colours = Colours::default_for_layer(layer);
        assert_eq!(colours.gradient().table(), Gradient::default_for_layer(layer).table());
    }
    assert_eq!(cheetah().stops.iter().map(|stop| stop.at).collect::<Vec<_>>(), [0.0, 0.4, 0.6, 1.0]);
}

#[test]
fn an_inserted_stop_changes_nothing_and_can_be_removed_again() {
    for preset in PRESETS {
        let before = Colours::from(&preset.set.gradient());
        for at in [0.1, 0.45, 0.5, 0.57, 0.8] {
            let mut colours = before.clone();
            let index = colours.insert(at);
            assert_eq!(colours.stops[index].at, at);
            assert!(difference(&colours, &before) <= 1, "{} at {at}: {colours:?}", preset.set.name);
            assert!(colours.remove(index));
            assert!(difference(&colours, &before) <= 2, "{} at {at}: {colours:?}", preset.set.name);
        }
    }
}

#[test]
fn a_stop_moves_past_others_and_back() {
    let mut colours = cheetah();
    let before = colours.clone();
    assert_eq!(colours.shift(1, 0.8), 2);
    assert_eq!(colours.stops.iter().map(|stop| stop.at).collect::<Vec<_>>(), [0.0, 0.6, 0.8, 1.0]);
    assert_eq!(colours.stops[2].colour, before.stops[1].colour);
    assert_eq!(colours.shift(2, 0.4), 1);
    assert_eq!(colours, before);
    assert_eq!(colours.shift(1, 7.0), 2, "at the value of the last stop, it stays below it");
}

#[test]
fn the_last_stop_stays() {
    let mut colours = Colours { stops: vec![Stop::opaque(0.3, [1, 2, 3])], ..Colours::new([]) };
    assert!(!colours.remove(0));
    assert_eq!(colours.insert(0.9), 1);
    assert_eq!(colours.stops[1].colour, [1, 2, 3]);
    assert!(colours.remove(0) && !colours.remove(0));
}

#[test]
fn colours_are_swapped_in_their_places() {
    let mut colours = cheetah();
    let before = colours.clone();
    colours.swap(0, 3);
    assert_eq!(colours.stops[0], Stop { at: 0.0, ..before.stops[3] });
    assert_eq!(colours.stops[3], Stop { at: 1.0, ..before.stops[0] });
    colours.swap(3, 0);
    assert_eq!(colours, before);
}

#[test]
fn a_stop_inserted_between_stops_of_different_opacity_changes_nothing() {
    let stops = vec![Stop { at: 0.0, colour: [250, 0, 0], alpha: 0 }, Stop::opaque(1.0, [20, 80, 160])];
    let before = Colours { stops, ..Colours::new([]) };
    let mut colours = before.clone();
    colours.insert(0.5);
    assert_eq!(colours.stops[1], Stop { at: 0.5, colour: [20, 80, 160], alpha: 128 });
    for v in [0.1, 0.3, 0.5, 0.8_f32] {
        let [was, is] = [&before, &colours].map(|colours| colours.gradient().rgba(v));
        assert!((0..4).all(|i| was[i].abs_diff(is[i]) <= 1), "{v}: {was:?} {is:?}");
    }
}

#[test]
fn hexadecimal_digits_name_the_opacity_where_it_counts() {
    assert_eq!(Stop::opaque(0.0, [1, 2, 255]).hex(), "#0102ff");
    assert_eq!(Stop { at: 0.0, colour: [1, 2, 255], alpha: 16 }.hex(), "#0102ff10");
}

proptest! {
    #[test]
    fn reversed_twice_is_as_before(colours in any_colours()) {
        let mut reversed = colours.clone();
        reversed.reverse();
        let back = [0.0_f32, 0.25, 0.5, 0.8].map(|v| seen(&reversed, 1.0 - v));
        let hard = colours.stops.windows(2).any(|pair| pair[1].at - pair[0].at < 0.01);
        if !hard {
            for (v, back) in [0.0_f32, 0.25, 0.5, 0.8].into_iter().zip(back) {
                let there = seen(&colours, v);
                let off = (0..3).map(|i| there[i].abs_diff(back[i])).max().unwrap_or(0);
                // 1 − v is rounded, and steep transitions enlarge the error.
                prop_assert!(off <= 8, "{v}: {there:?} {back:?}");
            }
        }
        reversed.reverse();
        prop_assert_eq!(&reversed.stops, &colours.stops);
        for gap in 0..colours.stops.len() - 1 {
            for (a, b) in reversed.bend(gap).into_iter().zip(colours.bend(gap)) {
                prop_assert!((a - b).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn colours_stay_valid_under_any_edits(
        mut colours in any_colours(),
        edits in prop::collection::vec((0..5_u8, any::<prop::sample::Index>(), -0.2..1.2_f64), 1..20),
    ) {
        for (edit, which, at) in edits {
            let index = which.index(colours.stops.len());
            match edit {
                0 => drop(colours.insert(at)),
                1 => drop(colours.remove(index)),
                2 => drop(colours.shift(index, at)),
                3 => colours.reverse(),
                _ => colours.set_bend(index, [at, 9.0 * at, at, -at]),
            }
            prop_assert!(colours.gradient().is_valid());
            prop_assert!(colours.bends.iter().all(|bend| *bend == within(*bend)));
        }
    }
}
