//! The options `keep` and `seeding` of a layer.

use super::*;
use dapple::document::Seeding;

/// The shortest document with a line instead of an ellipse, and these options.
fn lined(options: Value) -> Value {
    let mut document = with("/layers/0/options", options);
    document["layers"][0]["strokes"] = json!([{"kind": "line", "from": [1, 1], "to": [50, 50]}]);
    document
}

#[test]
fn marks_are_kept_without_regions_and_in_one_unless_the_document_says_otherwise() {
    let keeps = |options: Value, regions: Value| {
        let mut document = with("/layers/0/options", options);
        document["regions"] = regions;
        accepted(&document).keeps_marks(0)
    };
    assert!(accepted(&least()).keeps_marks(0));
    assert!(keeps(json!({}), json!([1, 1])) && !keeps(json!({}), json!([2, 1])));
    assert!(keeps(json!({"keep": true}), json!([2, 1])) && !keeps(json!({"keep": false}), json!([1, 1])));
    assert!(!keeps(json!({"irregular": 0.5}), json!([1, 1])));
}

#[test]
fn keep_and_seeding_are_written_as_they_were_read() {
    for options in [json!({}), json!({"keep": true}), json!({"keep": false, "seeding": "segments"})] {
        let document = accepted(&lined(options.clone()));
        assert_eq!(accepted(&serde_json::from_str(&document.to_json()).unwrap()), document);
        let written: Value = serde_json::from_str(&document.to_json()).unwrap();
        assert_eq!(written["layers"][0]["options"], options);
    }
    let seeding = |name: &str| accepted(&lined(json!({"seeding": name}))).layers[0].options.seeding;
    assert_eq!(seeding("noise"), Seeding::Noise);
    assert_eq!(seeding("segments"), Seeding::Segments);
    assert_eq!(seeding("initiators"), Seeding::Initiators);
}

#[test]
fn other_values_of_keep_and_seeding_are_refused() {
    let place = |key: &str| format!("layers[0].options.{key}");
    refused(&lined(json!({"keep": 1})), &place("keep"), "1", "true or false");
    let allowed = "noise, segments, initiators (did you mean segments?)";
    refused(&lined(json!({"seeding": "segment"})), &place("seeding"), "\"segment\"", allowed);
}

#[test]
fn a_seeding_without_effect_is_refused() {
    let place = "layers[0].options.seeding";
    let spots = with("/layers/0/options", json!({"seeding": "segments"}));
    refused(&spots, place, "\"segments\"", "\"noise\". Only stripes have a seeding");
    let thin = lined(json!({"seeding": "initiators", "duty": 0.3}));
    let allowed = "\"noise\". Stripes of any other duty than 0.5 (50 %) begin from noise alone";
    refused(&thin, place, "\"initiators\"", allowed);
    // The kind of a freehand stroke is known only after it is fitted.
    let mut document = spots;
    document["layers"][0]["strokes"] =
        json!([{"kind": "freehand", "points": [[10, 10], [30, 8], [40, 25], [25, 40], [8, 30], [10, 11]]}]);
    let error = dapple_engine::synth::drawn::sketch_targets::region_map(&accepted(&document), 0, "a.dapple")
        .unwrap_err()
        .to_string();
    assert!(
        error.contains("options.seeding: found \"segments\"; allowed: \"noise\". Only stripes"),
        "{error}"
    );
}

#[test]
fn no_marks_are_kept_where_the_layer_beneath_gives_the_places() {
    let second = |after: &str, options: Value| {
        let mut document = least();
        let layer = document["layers"][0].clone();
        document["layers"] = json!([layer, layer]);
        document["layers"][1]["after"] = json!(after);
        document["layers"][1]["options"] = options;
        document
    };
    let allowed = "false. The marks of the layer beneath determine the places of these marks";
    refused(&second("inside", json!({"keep": true})), "layers[1].options.keep", "true", allowed);
    assert!(accepted(&second("between", json!({"keep": true}))).keeps_marks(1));
    assert!(!accepted(&second("inside", json!({}))).keeps_marks(1));
    assert!(!accepted(&second("inside", json!({"keep": false}))).keeps_marks(1));
}
