//! JSON that is not a document: keys, types, choices.

use super::*;

#[test]
fn other_json_is_refused() {
    refused(&json!([1, 2]), "the document", "[1,2]", "an object {…}");
    refused(&json!(null), "the document", "null", "an object {…}");
    refused(&json!({"a": 1}), "the document", "no key \"format\"", "\"format\": \"dapple\"");
    refused(&with("/format", json!("gimp")), "format", "\"gimp\"", "dapple");
}

#[test]
fn a_newer_version_is_refused_with_a_message_that_says_so() {
    let document = with("/version", json!(3));
    let error = Document::parse(&document.to_string(), "bad.dapple").unwrap_err();
    assert!(matches!(error, DocumentError::Newer { version: 3, known: 2, .. }));
    assert!(error.to_string().contains("version: found 3, which is newer than this program"), "{error}");
}

#[test]
fn a_newer_version_is_reported_before_its_unknown_keys() {
    let mut document = with("/version", json!(3));
    document["wings"] = json!(2);
    assert!(error_of_text(&document.to_string()).contains("newer"));
}

#[test]
fn an_invalid_version_is_refused() {
    let allowed = "a whole number from 1 to 18446744073709551615";
    for (version, shown) in [(json!(0), "0"), (json!(-1), "-1"), (json!(1.5), "1.5"), (json!("1"), "\"1\"")] {
        refused(&with("/version", version), "version", shown, allowed);
    }
}

#[test]
fn an_unknown_key_is_named_with_its_place_and_its_neighbours() {
    refused(
        &with("/sead", json!(1)),
        "the document",
        "the unknown key \"sead\"",
        "format, version, name, size, regions, edges, seed, dpi, growth, model, layers, starred (did you mean seed?)",
    );
    refused(
        &with("/layers/0/colors", json!({})),
        "layers[0]",
        "the unknown key \"colors\"",
        "name, system, after, visible, seed, strokes, far_spacing, options, tone, points, maps, colours (did you mean colours?)",
    );
    let stroke = "layers[0].strokes[0]";
    let keys = "kind, center, radii, angle, outline";
    refused(&with("/layers/0/strokes/0/wobble", json!(1)), stroke, "the unknown key \"wobble\"", keys);
    refused(&with("/growth", json!({"x": 1})), "growth", "the unknown key \"x\"", "refine");
}

#[test]
fn missing_keys_are_named() {
    for key in ["size", "layers", "version"] {
        let mut document = least();
        document.as_object_mut().unwrap().remove(key);
        let message = error_of_text(&document.to_string());
        assert!(
            message.contains(&format!("the document: found no key \"{key}\"; allowed: \"{key}\": ")),
            "{message}"
        );
    }
    let layer = with("/layers", json!([{}]));
    refused(&layer, "layers[0]", "no key \"strokes\"", "\"strokes\": a list of strokes");
    let stroke = with_stroke(&json!({"kind": "ellipse", "center": [1, 1]}));
    let allowed = "\"radii\": [along the angle, across it] in px";
    refused(&stroke, "layers[0].strokes[0]", "no key \"radii\"", allowed);
}

#[test]
fn a_wrong_type_is_refused_everywhere() {
    let wrong = json!({"a": [1]});
    for pointer in [
        "/format",
        "/version",
        "/name",
        "/size",
        "/regions",
        "/edges",
        "/seed",
        "/dpi",
        "/growth",
        "/layers",
        "/layers/0",
        "/layers/0/name",
        "/layers/0/system",
        "/layers/0/after",
        "/layers/0/visible",
        "/layers/0/seed",
        "/layers/0/strokes",
        "/layers/0/strokes/0",
        "/layers/0/options",
        "/layers/0/colours",
        "/layers/0/strokes/0/kind",
        "/layers/0/strokes/0/center",
        "/layers/0/strokes/0/radii",
        "/layers/0/strokes/0/angle",
    ] {
        for value in [wrong.clone(), json!(null), json!([null, {}])] {
            let message = error_of_text(&with(pointer, value).to_string());
            assert!(message.contains("found") && message.contains("allowed: "), "{pointer}: {message}");
        }
    }
    refused(&with("/name", json!(5)), "name", "5", "a text of at most 1000 characters");
    refused(&with("/growth", json!({"refine": 1})), "growth.refine", "1", "true or false");
    refused(&with("/size", json!([1])), "size", "[1]", "a list of 2 whole numbers");
}

#[test]
fn a_canvas_without_px_or_with_too_many_is_refused() {
    let allowed = "a whole number from 1 to 65536";
    refused(&with("/size", json!([0, 10])), "size[0]", "0", allowed);
    refused(&with("/size", json!([10, -4])), "size[1]", "-4", allowed);
    refused(&with("/size", json!([10, 65537])), "size[1]", "65537", allowed);
    refused(&with("/size", json!([1e300, 10])), "size[0]", "1e+300", allowed);
    refused(&with("/size", json!([10.5, 10])), "size[0]", "10.5", allowed);
}

#[test]
fn regions_are_1_to_64_and_at_most_the_number_of_px() {
    refused(&with("/regions", json!([0, 1])), "regions[0]", "0", "a whole number from 1 to 64");
    refused(&with("/regions", json!([1, 65])), "regions[1]", "65", "a whole number from 1 to 64");
    let mut small = with_stroke(&json!({"kind": "ellipse", "center": [1, 1], "radii": [1, 1]}));
    small["size"] = json!([3, 512]);
    small["regions"] = json!([4, 1]);
    refused(&small, "regions[0]", "4", "a whole number from 1 to 3");
}

#[test]
fn seeds_and_dpi_have_bounds() {
    let whole = "a whole number from 0 to 18446744073709551615";
    refused(&with("/seed", json!(-1)), "seed", "-1", whole);
    refused(&with("/seed", json!(0.5)), "seed", "0.5", whole);
    refused(&with("/seed", json!(1e20)), "seed", "1e+20", whole);
    refused(&with("/layers/0/seed", json!("7")), "layers[0].seed", "\"7\"", whole);
    refused(&with("/dpi", json!(0)), "dpi", "0", "a number from 1 to 100000 dots an inch");
}

#[test]
fn an_unknown_choice_lists_the_known_ones() {
    let systems = "auto, stripes, turing-spots, meinhardt-spots, meinhardt-stripes, meinhardt-lines, weave, maze, pair-stripes, stucco, patches, cells, streaks, cracks, points, turing-growth";
    let near = format!("{systems} (did you mean turing-spots?)");
    refused(&with("/layers/0/system", json!("turing-spot")), "layers[0].system", "\"turing-spot\"", &near);
    refused(&with("/layers/0/system", json!("gray-scott")), "layers[0].system", "\"gray-scott\"", systems);
    refused(&with("/edges", json!("open")), "edges", "\"open\"", "closed, wrap");
    let after = "between, around, net, inside";
    refused(&with("/layers/0/after", json!("over")), "layers[0].after", "\"over\"", after);
    let kind = with_stroke(&json!({"kind": "square"}));
    refused(&kind, "layers[0].strokes[0].kind", "\"square\"", "ellipse, line, path, freehand, outline");
}
