//! Strokes of the kind `outline`, and the options of patches.

use super::*;
use dapple::document::{AreaKind, RaggedChoice, SpreadChoice};

fn drawn(points: &Value) -> Value {
    with_stroke(&json!({"kind": "outline", "points": points}))
}

const PLACE: &str = "layers[0].strokes[0].points";

#[test]
fn an_outline_is_written_as_it_was_read_and_counts_as_the_ellipse_with_its_moments() {
    // A rectangle 60 × 20 about (90, 70): second moments 60²/12 and 20²/12.
    let document = accepted(&drawn(&json!([[60, 60], [120, 60], [120, 80.0], [60, 80]])));
    let written: Value = serde_json::from_str(&document.to_json()).unwrap();
    assert_eq!(
        written["layers"][0]["strokes"][0]["points"],
        json!([[60, 60], [120, 60], [120, 80], [60, 80]])
    );
    assert_eq!(accepted(&written), document);
    let ellipse = document.layers[0].strokes[0].mark().unwrap().ellipse().unwrap();
    assert!((ellipse.area() - 1200.0).abs() < 1e-9 && (ellipse.aspect() - 1.0 / 3.0).abs() < 1e-12);
    assert!((ellipse.center[0] - 90.0).abs() < 1e-9 && (ellipse.center[1] - 70.0).abs() < 1e-9);
    assert!(ellipse.major_angle() < 1e-9, "{ellipse:?}");
}

#[test]
fn outlines_that_enclose_nothing_or_cross_themselves_are_refused_with_the_remedy() {
    let enclosing = "an outline that is 0.02 px wide or more; points on one line enclose nothing";
    let same = "at least 3, the corners of the outline";
    refused(&drawn(&json!([[5, 5], [9, 9], [5, 5]])), PLACE, "2 different points", same);
    refused(&drawn(&json!([[5, 5], [9, 9], [13, 13]])), PLACE, "an outline that encloses no area", enclosing);
    let eight = "an outline that crosses itself near [90.0, 60.0], with a loop of 20 % of its area";
    let open = "loops of at most 5 %: draw it without crossing, or draw two outlines";
    refused(&drawn(&json!([[80, 55], [80, 65], [110, 50], [110, 70]])), PLACE, eight, open);
    // Its centroid is outside the canvas, one of its corners is on it.
    accepted(&drawn(&json!([[-200, 40], [100, 40], [-100, 90]])));
    refused(
        &drawn(&json!([[-210, 40], [-30, 40], [-120, 100]])),
        PLACE,
        "an outline about [-120, 60] that is wholly outside the canvas",
        "a stroke of which some part is on the canvas, from [0, 0] to [512, 256]: move it, or leave it out",
    );
    let many: Vec<[f64; 2]> =
        (0..1001).map(|k| (0.001 * f64::from(k)).sin_cos()).map(|(s, c)| [s, c]).collect();
    refused(
        &drawn(&json!(many)),
        PLACE,
        "1001 points",
        "at most 1000: leave out those that are nearest to others",
    );
    // A hand goes slightly too far when it closes the outline.
    accepted(&drawn(&json!([[40, 40], [100, 40], [100, 100], [40, 100], [40.5, 39], [42, 39]])));
}

#[test]
fn an_ellipse_keeps_the_outline_that_it_was_fitted_to_and_grows_as_an_ellipse() {
    let stroke = |outline: Value| {
        with_stroke(
            &json!({"kind": "ellipse", "center": [90, 70], "radii": [33, 15], "angle": 0, "outline": outline}),
        )
    };
    let document = accepted(&stroke(json!([[60, 60], [120, 60], [120, 80.0], [60, 80]])));
    let written: Value = serde_json::from_str(&document.to_json()).unwrap();
    let found = &written["layers"][0]["strokes"][0];
    assert_eq!(found["outline"], json!([[60, 60], [120, 60], [120, 80], [60, 80]]));
    assert_eq!(accepted(&written), document);
    let layer = &document.layers[0];
    assert_eq!(layer.areas(), None, "automatic takes spots");
    assert_eq!(layer.strokes[0].mark(), Stroke::ellipse([90.0, 70.0], [33.0, 15.0], 0.0).mark());
    let allowed = "at least 3, the corners of the outline";
    let place = "layers[0].strokes[0].outline";
    refused(&stroke(json!([[60, 60], [120, 60]])), place, "2 different points", allowed);
}

#[test]
fn automatic_chooses_patches_where_outlines_are_drawn_and_no_option_asks_for_spots() {
    let outlined = || drawn(&json!([[60, 60], [120, 60], [120, 80.0], [60, 80]]));
    let takes = |change: &dyn Fn(&mut Value)| {
        let mut document = outlined();
        change(&mut document["layers"][0]);
        accepted(&document).layers[0].areas() == Some(AreaKind::Patches)
    };
    assert!(takes(&|_| {}) && takes(&|layer| layer["system"] = json!("patches")));
    assert!(!takes(&|layer| layer["system"] = json!("turing-spots")));
    assert!(!takes(&|layer| layer["options"] = json!({"irregular": 0.4})));
    assert!(!takes(&|layer| layer["after"] = json!("inside")));
    assert!(accepted(&least()).layers[0].areas().is_none());
}

#[test]
fn the_options_of_patches_are_written_as_they_were_read_and_refused_elsewhere() {
    let mut document = drawn(&json!([[60, 60], [120, 60], [120, 80.0], [60, 80]]));
    document["layers"][0]["options"] = json!({"ragged": 0.25, "detail": 40});
    let read = accepted(&document);
    assert_eq!(read.layers[0].options.ragged, RaggedChoice::Given(0.25));
    let written: Value = serde_json::from_str(&read.to_json()).unwrap();
    assert_eq!(written["layers"][0]["options"], json!({"ragged": 0.25, "detail": 40}));
    let points = "Only patches and streaks are made from a number of points: set \"system\" to one of these";
    let detail = with("/layers/0/options", json!({"detail": 30}));
    refused(&detail, "layers[0].options.detail", "30", &format!("24. {points}"));
    document["layers"][0]["options"] = json!({"ragged": 0.6});
    refused(&document, "layers[0].options.ragged", "0.6", "\"drawn\", or a number from 0 to 0.5");
    document["layers"][0]["options"] = json!({"spread": 0.3});
    assert!(
        matches!(accepted(&document).layers[0].options.spread, SpreadChoice::Given(spread) if spread.area == 0.3)
    );
}

#[test]
fn spots_stripes_and_streaks_can_have_ragged_edges_and_others_cannot() {
    let only = "\"drawn\". Only patches, streaks, and the spots and stripes of reaction and diffusion have ragged edges";
    let (ellipse, line) = (
        json!({"kind": "ellipse", "center": [60, 60], "radii": [12, 9]}),
        json!({"kind": "line", "from": [20, 20], "to": [90, 30]}),
    );
    let systems = [
        ("auto", &ellipse, true),
        ("turing-spots", &ellipse, true),
        ("meinhardt-spots", &ellipse, true),
        ("auto", &line, true),
        ("meinhardt-stripes", &line, true),
        ("meinhardt-lines", &line, true),
        ("cells", &ellipse, false),
        ("weave", &line, false),
        ("maze", &line, false),
        ("streaks", &line, true),
        ("pair-stripes", &line, true),
        ("cracks", &line, false),
    ];
    for (system, stroke, takes) in systems {
        let mut document = with("/layers/0/strokes", json!([stroke]));
        document["layers"][0]["system"] = json!(system);
        document["layers"][0]["options"] = json!({"ragged": 0.2});
        if takes {
            let read = accepted(&document);
            assert_eq!(read.layers[0].options.ragged, RaggedChoice::Given(0.2), "{system}");
        } else {
            refused(&document, "layers[0].options.ragged", "0.2", only);
        }
    }
}
