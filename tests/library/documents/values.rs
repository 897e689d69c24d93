//! Values of strokes and colours that are not allowed.

use super::*;

#[test]
fn radii_of_0_and_negative_and_huge_ones_are_refused() {
    let radii = |radii: Value| with("/layers/0/strokes/0/radii", radii);
    let allowed = "a number from 0.01 to 512 px";
    refused(&radii(json!([0, 6])), "layers[0].strokes[0].radii[0]", "0", allowed);
    refused(&radii(json!([6, -6])), "layers[0].strokes[0].radii[1]", "-6", allowed);
    refused(&radii(json!([6, 1e300])), "layers[0].strokes[0].radii[1]", "1e+300", allowed);
    refused(&radii(json!([6, "6"])), "layers[0].strokes[0].radii[1]", "\"6\"", allowed);
    refused(&radii(json!([6, 6, 6])), "layers[0].strokes[0].radii", "[6,6,6]", "a list of 2 numbers");
}

#[test]
fn the_place_of_a_deep_value_is_its_whole_path() {
    let mut document = least();
    let good = document["layers"][0]["strokes"][0].clone();
    let mut bad = good.clone();
    bad["radii"][1] = json!(0);
    document["layers"] = json!([{"strokes": [good]}, {"strokes": [good, good, good, bad]}]);
    refused(&document, "layers[1].strokes[3].radii[1]", "0", "a number from 0.01 to 512 px");
}

#[test]
fn a_line_of_no_length_is_refused() {
    let line = with_stroke(&json!({"kind": "line", "from": [10, 10], "to": [10, 10], "width": 6}));
    let allowed = "\"from\" and \"to\" at least 0.01 px apart";
    refused(&line, "layers[0].strokes[0]", "a line of length 0 px", allowed);
}

#[test]
fn a_line_of_no_width_is_refused() {
    let line = with_stroke(&json!({"kind": "line", "from": [10, 10], "to": [20, 10], "width": 0}));
    refused(&line, "layers[0].strokes[0].width", "0", "a number from 0.01 to 512 px");
}

#[test]
fn a_freehand_stroke_without_extent_is_refused() {
    let points = |points: Value| with_stroke(&json!({"kind": "freehand", "points": points, "width": 6}));
    let place = "layers[0].strokes[0].points";
    refused(&points(json!([])), place, "0 points", "at least 2 points");
    refused(&points(json!([[1, 1]])), place, "1 points", "at least 2 points");
    let allowed = "a stroke that extends over at least 0.01 px";
    refused(&points(json!([[5, 5], [5, 5], [5, 5]])), place, "points within 0 × 0 px", allowed);
    let item = "layers[0].strokes[0].points[1]";
    refused(&points(json!([[5, 5], [5]])), item, "[5]", "a list of 2 numbers");
    refused(
        &points(json!([[5, 5], [5, 1e9]])),
        &format!("{item}[1]"),
        "1000000000.0",
        "a number from -256 to 512 px",
    );
}

#[test]
fn a_freehand_stroke_beside_the_canvas_is_refused() {
    let stroke = |x: f64| with_stroke(&json!({"kind": "freehand", "points": [[x, 5], [-20, 5]]}));
    accepted(&stroke(1.0));
    let allowed =
        "a stroke of which some part is on the canvas, from [0, 0] to [512, 256]: move it, or leave it out";
    let found = "a stroke about [-15, 5] that is wholly outside the canvas";
    refused(&stroke(-10.0), "layers[0].strokes[0].points", found, allowed);
}

#[test]
fn a_layer_holds_ellipses_or_lines() {
    let mut document = least();
    let line = json!({"kind": "line", "from": [10, 10], "to": [90, 60]});
    document["layers"][0]["strokes"].as_array_mut().unwrap().push(line);
    let allowed = "an ellipse (a layer holds ellipses or lines: give the others a layer of their own)";
    refused(&document, "layers[0].strokes[1]", "a line in a layer of ellipses", allowed);
}

#[test]
fn a_system_that_grows_other_marks_is_refused() {
    let stripes = with("/layers/0/system", json!("meinhardt-stripes"));
    let allowed = "auto, turing-spots, meinhardt-spots, stucco, patches, cells, points, turing-growth. This system grows stripes; this layer holds ellipses";
    refused(&stripes, "layers[0].system", "\"meinhardt-stripes\"", allowed);
}

#[test]
fn a_document_without_layers_or_strokes_is_refused() {
    refused(&with("/layers", json!([])), "layers", "no layers", "a list of 1 to 255 layers");
    refused(&with("/layers/0/strokes", json!([])), "layers[0].strokes", "no strokes", "at least one stroke");
    let layer = least()["layers"][0].clone();
    let many = with("/layers", Value::Array(vec![layer; 256]));
    refused(&many, "layers", "256 layers", "a list of 1 to 255 layers");
}

#[test]
fn wrong_colours_are_refused() {
    let colour = |c: Value| with("/layers/0/colours", json!({"stops": [{"at": 0, "colour": c}]}));
    accepted(&colour(json!("#abc")));
    accepted(&colour(json!("#11223344")));
    let allowed = "#rrggbb or #rgb in hexadecimal digits; #rrggbbaa with opacity";
    for wrong in ["red", "#12", "#12345", "#1122334", "#112233445", "#ggg", "# aabbcc", "", "#ééé", "aabbcc"]
    {
        let found = format!("{wrong:?}");
        refused(&colour(json!(wrong)), "layers[0].colours.stops[0].colour", &found, allowed);
    }
    refused(&colour(json!(255)), "layers[0].colours.stops[0].colour", "255", allowed);
}

#[test]
fn stops_ascend_from_0_to_1() {
    let stops = |places: &[f64]| {
        let stops: Vec<_> = places.iter().map(|at| json!({"at": at, "colour": "#000"})).collect();
        with("/layers/0/colours", json!({"stops": stops}))
    };
    let place = "layers[0].colours.stops";
    refused(&stops(&[]), place, "no stops", "at least one colour stop");
    refused(&stops(&[0.0, 1.5]), &format!("{place}[1].at"), "1.5", "a number from 0 to 1");
    let allowed = "no less than the stop before it, 0.5: stops ascend";
    refused(&stops(&[0.0, 0.5, 0.25]), &format!("{place}[2].at"), "0.25", allowed);
}

#[test]
fn two_stops_at_one_value_make_a_hard_step() {
    let stops = json!([{"at": 0.5, "colour": "#000"}, {"at": 0.5, "colour": "#fff"}]);
    let text = with("/layers/0/colours", json!({"stops": stops})).to_string();
    let document = Document::parse(&text, "step.dapple").unwrap();
    let colours = document.layers[0].colours.as_ref().unwrap();
    assert_eq!(colours.stops.iter().map(|stop| stop.at).collect::<Vec<_>>(), [0.5, 0.5]);
}

#[test]
fn bends_are_four_numbers_each_at_most_one_for_each_gap() {
    let bends = |bends: Value| {
        let stops = json!([{"at": 0, "colour": "#000"}, {"at": 1, "colour": "#fff"}]);
        with("/layers/0/colours", json!({"stops": stops, "bends": bends}))
    };
    accepted(&bends(json!([])));
    accepted(&bends(json!([[0, -2, 1, 3]])));
    let place = "layers[0].colours.bends";
    refused(&bends(json!([[0, 0, 1]])), &format!("{place}[0]"), "[0,0,1]", "a list of 4 numbers");
    refused(&bends(json!([[0, 0, 1.5, 1]])), &format!("{place}[0][2]"), "1.5", "a number from 0 to 1");
    refused(&bends(json!([[0, 9, 1, 1]])), &format!("{place}[0][1]"), "9", "a number from -2 to 3");
    let two = bends(json!([[0, 0, 1, 1], [0, 0, 1, 1]]));
    refused(&two, place, "2 bends for 2 stops", "at most 1: one between each stop and the next");
}

#[test]
fn a_long_value_is_shortened_in_the_message() {
    let message = error_of_text(&with("/edges", json!("x".repeat(100_000))).to_string());
    assert!(message.len() < 300, "{message}");
    let message = error_of_text(&with("/size", json!(vec![1; 100_000])).to_string());
    assert!(message.contains("found a list of 100000 values"), "{message}");
}
