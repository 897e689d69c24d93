//! The options of a layer: the spread of its spots, the duty of its stripes.

use super::*;
use dapple::document::Spread;
use dapple::document::SpreadChoice;

fn given(options: Value) -> SpreadChoice {
    accepted(&with("/layers/0/options", options)).layers[0].options.spread
}

#[test]
fn a_spread_is_drawn_unless_it_is_given_as_a_number_or_an_object() {
    assert_eq!(given(json!({})), SpreadChoice::Drawn);
    assert_eq!(given(json!({"spread": "drawn"})), SpreadChoice::Drawn);
    assert_eq!(given(json!({"spread": 0})), SpreadChoice::Given(Spread::ZERO));
    assert_eq!(given(json!({"spread": 0.4})), SpreadChoice::Given(Spread { area: 0.4, ..Spread::ZERO }));
    let all = Spread { area: 0.6, angle: 45.0, aspect: 0.2, spacing: 0.2 };
    assert_eq!(given(json!({"spread": all})), SpreadChoice::Given(all));
    let one = Spread { angle: 7.5, ..Spread::ZERO };
    assert_eq!(given(json!({"spread": {"angle": 7.5}})), SpreadChoice::Given(one));
}

#[test]
fn options_are_written_as_they_were_read() {
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
fn invalid_spreads_are_refused() {
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
    refused(
        &options(json!({"speed": 1})),
        "layers[0].options",
        "the unknown key \"speed\"",
        "spread, irregular, duty, seeding, broken, keep, ragged, detail, gap, decay, over",
    );
}

#[test]
fn an_option_with_its_default_is_allowed_in_any_layer() {
    let defaults = json!({"spread": "drawn", "irregular": 0, "duty": 0.5, "seeding": "noise", "broken": 0, "keep": false});
    accepted(&with("/layers/0/options", defaults.clone()));
    for system in ["auto", "meinhardt-stripes", "meinhardt-lines"] {
        accepted(&lined(system, defaults.clone()));
    }
}

#[test]
fn stripes_have_no_spread() {
    let allowed = "\"drawn\". Only spots have a spread";
    let found = "a spread of area 0.2, angle 0, aspect 0, spacing 0";
    let place = "layers[0].options.spread";
    for system in ["auto", "meinhardt-stripes"] {
        let mut document = with("/layers/0/options", json!({"spread": 0.2}));
        document["layers"][0]["system"] = json!(system);
        document["layers"][0]["strokes"] = json!([{"kind": "line", "from": [1, 1], "to": [50, 50]}]);
        refused(&document, place, found, allowed);
    }
    // The kind of a freehand stroke is known only after it is fitted.
    let mut document = with("/layers/0/options", json!({"spread": 0.2}));
    document["layers"][0]["strokes"] = json!([{"kind": "freehand", "points": [[1, 1], [30, 2], [60, 1]]}]);
    let error = dapple_engine::synth::drawn::sketch_targets::region_map(&accepted(&document), 0, "a.dapple")
        .unwrap_err()
        .to_string();
    assert_eq!(error, format!("a.dapple: {place}: found {found}; allowed: {allowed}"));
}

/// A layer of a line with these options, grown by `system`.
fn lined(system: &str, options: Value) -> Value {
    let mut document = with("/layers/0/options", options);
    document["layers"][0]["system"] = json!(system);
    document["layers"][0]["strokes"] = json!([{"kind": "line", "from": [1, 1], "to": [50, 50]}]);
    document
}

#[test]
fn a_duty_is_the_drawn_one_unless_it_is_given_and_is_written() {
    let given = DutyChoice::Given;
    for (options, duty) in [
        (json!({}), DutyChoice::Drawn),
        (json!({"duty": "drawn"}), DutyChoice::Drawn),
        (json!({"duty": 0.5}), given(0.5)),
        (json!({"duty": 0.18}), given(0.18)),
        (json!({"duty": 0.82}), given(0.82)),
    ] {
        for system in ["auto", "meinhardt-lines"] {
            let document = accepted(&lined(system, options.clone()));
            assert_eq!(document.layers[0].options.duty, duty);
            assert_eq!(accepted(&serde_json::from_str(&document.to_json()).unwrap()), document);
        }
    }
    assert_eq!(
        accepted(&lined("meinhardt-stripes", json!({"duty": 0.5}))).layers[0].options.duty,
        given(0.5)
    );
}

#[test]
fn invalid_duties_are_refused() {
    let place = "layers[0].options.duty";
    for (value, found) in [(json!(0.17), "0.17"), (json!(0.83), "0.83"), (json!("thin"), "\"thin\"")] {
        refused(
            &lined("auto", json!({"duty": value})),
            place,
            found,
            "\"drawn\", or a number from 0.18 to 0.82",
        );
    }
    let allowed = "\"drawn\" or 0.5. Meinhardt's stripes are as wide as their gaps; Meinhardt's lines and automatic grow thinner and wider ones";
    refused(&lined("meinhardt-stripes", json!({"duty": 0.3})), place, "0.3", allowed);
}

#[test]
fn spots_have_no_duty() {
    let allowed = "\"drawn\" or 0.5. Only stripes have a duty; spots are as far apart as they are drawn";
    let place = "layers[0].options.duty";
    refused(&with("/layers/0/options", json!({"duty": 0.3})), place, "0.3", allowed);
    // The kind of a freehand stroke is known only after it is fitted.
    let mut document = with("/layers/0/options", json!({"duty": 0.3}));
    document["layers"][0]["strokes"] =
        json!([{"kind": "freehand", "points": [[20, 20], [40, 20], [40, 40], [20, 40], [20, 21]]}]);
    let error = dapple_engine::synth::drawn::sketch_targets::region_map(&accepted(&document), 0, "a.dapple")
        .unwrap_err()
        .to_string();
    assert_eq!(error, format!("a.dapple: {place}: found 0.3; allowed: {allowed}"));
}

#[test]
fn spots_are_regular_by_default() {
    for (options, irregular) in
        [(json!({}), 0.0), (json!({"irregular": 1}), 1.0), (json!({"irregular": 0.3}), 0.3)]
    {
        for system in ["auto", "turing-spots"] {
            let mut document = with("/layers/0/options", options.clone());
            document["layers"][0]["system"] = json!(system);
            let document = accepted(&document);
            assert_eq!(document.layers[0].options.irregular, irregular);
            assert_eq!(accepted(&serde_json::from_str(&document.to_json()).unwrap()), document);
        }
    }
}

#[test]
fn irregular_is_refused_for_systems_without_irregular_spots() {
    let place = "layers[0].options.irregular";
    for (value, found) in [(json!(1.01), "1.01"), (json!(-0.5), "-0.5"), (json!("very"), "\"very\"")] {
        refused(
            &with("/layers/0/options", json!({"irregular": value})),
            place,
            found,
            "a number from 0 to 1",
        );
    }
    let mut round = with("/layers/0/options", json!({"irregular": 0.5}));
    round["layers"][0]["system"] = json!("meinhardt-spots");
    let allowed = "0. The spots of Meinhardt's system stay ellipses; Turing's can be irregular";
    refused(&round, place, "0.5", allowed);
    let mut inside = with("/layers/0/options", json!({"irregular": 0.5}));
    inside["layers"][0]["after"] = json!("inside");
    refused(&inside, place, "0.5", "0. A spot inside another one begins and stays as an ellipse");
    refused(&lined("auto", json!({"irregular": 0.5})), place, "0.5", "0. Only spots can be irregular");
}
