//! What a layer's `options` may hold: the spread of its spots.

use super::*;
use dapple::attributes::Spread;
use dapple::synth::recipe::SpreadChoice;

fn given(options: Value) -> SpreadChoice {
    accepted(&with("/layers/0/options", options)).layers[0].options.spread
}

#[test]
fn a_spread_is_drawn_unless_it_is_given_as_a_number_or_an_object() {
    assert_eq!(given(json!({})), SpreadChoice::Drawn);
    assert_eq!(given(json!({"spread": "drawn"})), SpreadChoice::Drawn);
    assert_eq!(given(json!({"spread": 0})), SpreadChoice::Given(Spread::EVEN));
    assert_eq!(given(json!({"spread": 0.4})), SpreadChoice::Given(Spread { area: 0.4, ..Spread::EVEN }));
    let all = Spread { area: 0.6, angle: 45.0, aspect: 0.2, spacing: 0.2 };
    assert_eq!(given(json!({"spread": all})), SpreadChoice::Given(all));
    let one = Spread { angle: 7.5, ..Spread::EVEN };
    assert_eq!(given(json!({"spread": {"angle": 7.5}})), SpreadChoice::Given(one));
}

#[test]
fn what_was_read_is_written() {
    for options in [
        json!({}),
        json!({"spread": 0}),
        json!({"spread": 0.25}),
        json!({"spread": {"angle": 12, "aspect": 0.05}}),
    ] {
        let document = accepted(&with("/layers/0/options", options));
        assert_eq!(accepted(&serde_json::from_str(&document.to_json()).unwrap()), document);
    }
    let written: Value = serde_json::from_str(&accepted(&least()).to_json()).unwrap();
    assert_eq!(written["layers"][0]["options"], json!({}));
}

#[test]
fn what_no_spread_is_is_refused() {
    let spread = |value: Value| with("/layers/0/options", json!({"spread": value}));
    let place = "layers[0].options.spread";
    let allowed = "\"drawn\", a number from 0 to 0.6 (the areas' coefficient of variation), or an object with \
                   area, angle, aspect, spacing";
    for (value, found) in
        [(json!(0.7), "0.7"), (json!(-0.1), "-0.1"), (json!("wild"), "\"wild\""), (json!([1]), "[1]")]
    {
        refused(&spread(value), place, found, allowed);
    }
    let keys = "area, angle, aspect, spacing (did you mean angle?)";
    refused(&spread(json!({"angls": 3})), place, "the unknown key \"angls\"", keys);
    let parts = [
        ("area", json!(0.61), "0.61", "a number from 0 to 0.6"),
        ("angle", json!(46), "46", "a number from 0 to 45 degrees"),
        ("aspect", json!(-1), "-1", "a number from 0 to 0.2"),
        ("spacing", json!("x"), "\"x\"", "a number from 0 to 0.2"),
    ];
    for (key, value, found, allowed) in parts {
        let object: Value = [(key.to_owned(), value)].into_iter().collect();
        refused(&spread(object), &format!("{place}.{key}"), found, allowed);
    }
}

#[test]
fn other_options_are_refused() {
    let options = |value: Value| with("/layers/0/options", value);
    refused(&options(json!({"speed": 1})), "layers[0].options", "the unknown key \"speed\"", "spread");
    let mut stripes = options(json!({"speed": 1}));
    stripes["layers"][0]["system"] = json!("meinhardt-stripes");
    stripes["layers"][0]["strokes"] = json!([{"kind": "line", "from": [1, 1], "to": [50, 50]}]);
    refused(&stripes, "layers[0].options", "the unknown key \"speed\"", "no keys here yet");
}

#[test]
fn stripes_have_no_spread() {
    let allowed = "no such key: only spots have a spread";
    let place = "layers[0].options.spread";
    for system in ["auto", "meinhardt-stripes"] {
        let mut document = with("/layers/0/options", json!({"spread": 0.2}));
        document["layers"][0]["system"] = json!(system);
        document["layers"][0]["strokes"] = json!([{"kind": "line", "from": [1, 1], "to": [50, 50]}]);
        refused(&document, place, "a spread of stripes", allowed);
    }
    // What a freehand stroke is, is known once it is fitted.
    let mut document = with("/layers/0/options", json!({"spread": 0.2}));
    document["layers"][0]["strokes"] = json!([{"kind": "freehand", "points": [[1, 1], [30, 2], [60, 1]]}]);
    let error =
        dapple::synth::drawn::region_map(&accepted(&document), 0, "a.dapple").unwrap_err().to_string();
    assert_eq!(error, format!("a.dapple: {place}: found a spread of stripes; allowed: {allowed}"));
}
