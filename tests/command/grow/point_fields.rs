//! Fields of points: they have the share that is asked for, are the same for any number of threads, and have no seam.

use crate::grow::folder::Folder;
use dapple::document::{AreaKind, Edges, SystemChoice};
use dapple::maps::{LayerMap, MapKey, MapSource};
use dapple::point_fields::{Interpolation, Labels, Points, Progression};
use dapple::tone::ToneImage;
use dapple::{Document, Grown, Layer, Stroke};
use dapple_engine::grid::Field;
use serde_json::{Value, json};

/// One of each kind of labels.
fn labels() -> Vec<Labels> {
    let image = ToneImage::new([2, 2], vec![0, 200, 200, 90]).expect("four px");
    vec![
        Labels::Values { group: 2 },
        Labels::Random { dark: [0.4; 2] },
        Labels::Image { image, passes: 3 },
        Labels::SpaceGiraffe { rays: [8, 14] },
        Labels::BreadthFirst { size: 12 },
        Labels::DepthFirst { size: 12 },
        Labels::RoundRobin { size: 30, rings: 0 },
        Labels::Connected { start: 0.1, rings: 0 },
    ]
}

fn grown(points: Points, edges: Edges) -> Grown {
    let layer = Layer::default().with_points(points);
    let document = Document { edges, ..Document::new([200, 150]).with_layer(layer) };
    document.grow().unwrap_or_else(|error| panic!("{error}"))
}

fn pattern(grown: &Grown, layer: usize) -> Field {
    let [width, height] = grown.size.map(|side| side as usize);
    grown.layers[layer].pattern().field(width, height)
}

/// The share of px above the edge.
fn share(field: &Field) -> f64 {
    field.values.iter().filter(|value| **value >= 0.5).count() as f64 / field.values.len() as f64
}

/// The share of dark px in the field of the lowest layer.
fn share_of(grown: &Grown) -> f64 {
    share(&pattern(grown, 0))
}

fn number(value: &Value, key: &str) -> f64 {
    value[key].as_f64().unwrap_or_else(|| panic!("{key} of {value}"))
}

#[test]
fn every_kind_of_labels_has_the_share_that_is_asked_for() {
    for edges in [Edges::Closed, Edges::Wrap] {
        for labels in labels() {
            let with = |share: Option<f64>| {
                let points =
                    Points { distance: Some([9.0; 2]), labels: labels.clone(), share, ..Points::default() };
                share_of(&grown(points, edges))
            };
            let natural = with(None);
            for wanted in [natural - 0.05, natural + 0.03] {
                let got = with(Some(wanted));
                assert!((got - wanted).abs() < 0.005, "{labels:?}, {edges:?}: {got} for {wanted}");
            }
        }
    }
}

#[test]
fn random_labels_have_the_share_of_their_probability() {
    for dark in [[0.3; 2], [0.5; 2], [0.65; 2], [0.0, 1.0], [0.9, 0.2]] {
        let (distance, labels) = (Some([8.0; 2]), Labels::Random { dark });
        let grown = grown(Points { distance, labels, axis: 1.4, ..Points::default() }, Edges::Closed);
        let wanted = 0.5 * (dark[0] + dark[1]);
        let got = share(&pattern(&grown, 0));
        assert!((got - wanted).abs() < 0.005, "{dark:?}: {got}");
        let report = serde_json::to_value(grown.report()).unwrap();
        let told = &report["layers"][0]["points"]["share"];
        assert!(
            (number(told, "asked") - wanted).abs() < 1e-3 && (number(told, "got") - got).abs() < 0.005,
            "{told}"
        );
    }
}

#[test]
fn a_tile_has_no_seam() {
    for labels in labels() {
        for interpolation in [Interpolation::Smooth, Interpolation::Nearest] {
            for progression in [Progression::Across, Progression::Down, Progression::Outward] {
                let distance = Some([7.0, 16.0]);
                let points = Points {
                    distance,
                    progression,
                    labels: labels.clone(),
                    interpolation,
                    ..Points::default()
                };
                let field = pattern(&grown(points, Edges::Wrap), 0);
                let rows = 0..field.height as isize;
                let step = |x: isize| {
                    let at = |y: isize| f64::from((field.get(x + 1, y) - field.get(x, y)).abs());
                    rows.clone().map(at).sum::<f64>() / field.height as f64
                };
                let inside: Vec<f64> = (0..field.width as isize - 1).map(step).collect();
                let most = inside.iter().copied().fold(0.0, f64::max);
                let seam = step(field.width as isize - 1);
                assert!(seam <= 1.3 * most, "{labels:?}, {interpolation:?}: {seam}, {most} at most inside");
            }
        }
    }
}

#[test]
fn a_field_is_the_same_for_any_number_of_threads() {
    let points = json!({"distance": [20, 6], "labels": {"kind": "round-robin", "size": 20}, "shift": 0.5, "octaves": 2});
    let document = json!({"format": "dapple", "version": 2, "size": [240, 180], "edges": "wrap",
        "layers": [{"system": "points", "strokes": [], "points": points}]});
    let folder = Folder::with(&document);
    folder.grow("--pattern one.png --threads 1");
    folder.grow("--pattern three.png --threads 3");
    assert_eq!(folder.bytes("one.png"), folder.bytes("three.png"));
}

#[test]
fn drawn_ellipses_give_distance_and_share() {
    let ellipses = [[60.0, 70.0], [84.0, 70.0], [72.0, 91.0]].map(|at| Stroke::ellipse(at, [7.0, 7.0], 0.0));
    let layer = Layer { strokes: ellipses.to_vec(), ..Layer::default().with_points(Points::default()) };
    let grown = Document::new([200, 150]).with_layer(layer).grow().unwrap();
    let plan = &grown.layers[0].points().unwrap().plan;
    assert!((plan.distances[0] - 24.0).abs() < 0.3, "{:?}", plan.distances);
    // The marks cover 154 px² in 0.9 · 24² px²; the points are dark as often.
    assert!((plan.share.unwrap() - 0.297).abs() < 0.01, "{:?}", plan.share);
    assert!((share(&pattern(&grown, 0)) - plan.share.unwrap()).abs() < 0.005);
}

#[test]
fn a_field_does_not_touch_the_marks_beneath_and_fills_its_share_of_the_rest() {
    let disc = Stroke::ellipse([100.0, 75.0], [40.0, 30.0], 0.0);
    let beneath = Layer::new([disc]).with_system(SystemChoice::Of(AreaKind::Patches.description()));
    let points = Points { distance: Some([6.0; 2]), share: Some(0.4), ..Points::default() };
    let document =
        Document::new([200, 150]).with_layer(beneath).with_layer(Layer::default().with_points(points));
    let grown = document.grow().unwrap();
    let (below, above) = (pattern(&grown, 0), pattern(&grown, 1));
    let both =
        below.values.iter().zip(&above.values).filter(|(below, above)| **below >= 0.5 && **above >= 0.5);
    assert_eq!(both.count(), 0);
    let free = 1.0 - share(&below);
    assert!((share(&above) / free - 0.4).abs() < 0.01, "{} of {free}", share(&above));
}

#[test]
fn distances_go_from_the_first_to_the_second() {
    let distance = Some([20.0, 5.0]);
    let labels = Labels::Values { group: 1 };
    let field = pattern(&grown(Points { distance, labels, ..Points::default() }, Edges::Closed), 0);
    let steps = |from: isize| {
        let cells = (0..150).flat_map(|y| (from..from + 60).map(move |x| (x, y)));
        cells.map(|(x, y)| f64::from((field.get(x + 1, y) - field.get(x, y)).abs())).sum::<f64>()
    };
    assert!(steps(139) > 1.8 * steps(0), "{} {}", steps(0), steps(139));
}

#[test]
fn a_field_of_one_value_is_refused_with_the_reason() {
    let document = json!({"format": "dapple", "version": 2, "size": [100, 80],
        "layers": [{"system": "points", "strokes": [], "points": {"labels": {"kind": "random", "dark": 0}}}]});
    Folder::with(&document).refuses("grow a.dapple -o a.png", 1, &["layer 1", "one value everywhere"]);
}

#[test]
fn check_lists_the_settings_of_a_field_and_the_attributes_that_it_takes_from_the_sketch() {
    let disc = |x: i32| json!({"kind": "ellipse", "center": [x, 50], "radii": [6, 6], "angle": 0});
    let mut document = json!({"format": "dapple", "version": 2, "size": [200, 150],
        "layers": [{"system": "points", "strokes": [disc(60), disc(80)], "points": {"distance": 12}}]});
    let folder = Folder::with(&document);
    let output = folder.dapple("check a.dapple").output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("a field of points on"), "{text}");
    assert!(text.contains("12.0 px apart, labels random") && text.contains("share by 2 drawn"), "{text}");
    document["layers"][0]["strokes"] = json!([]);
    folder.write("a.dapple", &document.to_string());
    let output = folder.dapple("check a.dapple --json").output().unwrap();
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(found["layers"][0]["honours"], json!([]));
    assert!((number(&found["layers"][0]["points"], "expected") - 146.0).abs() < 2.0, "{found}");
}

/// A map whose value goes from the first number at the left to the second at the right; it multiplies what is asked for
/// or replaces it.
fn ramp(factor: bool, range: [f64; 2]) -> LayerMap {
    let image = ToneImage::new([256, 1], (0..=255).collect()).expect("256 px");
    LayerMap { source: MapSource::Image { image, factor }, range }
}

/// The dark shares of the field of the lowest layer on four parts of 600 × 400 px, from left to right, and the number
/// of edges that a row crosses there.
fn by_part(layer: Layer) -> ([f64; 4], [usize; 4]) {
    let grown = Document::new([600, 400]).with_layer(layer).grow().unwrap_or_else(|error| panic!("{error}"));
    let field = pattern(&grown, 0);
    let part = |part: usize| 150 * part..150 * (part + 1);
    let rows = || field.values.chunks(600);
    let dark = |k: usize| rows().flat_map(|row| &row[part(k)]).filter(|value| **value >= 0.5).count();
    let crossed = |k: usize| {
        let edges = |row: &[f32]| row.windows(2).filter(|two| (two[0] >= 0.5) != (two[1] >= 0.5)).count();
        rows().map(|row| edges(&row[part(k)])).sum()
    };
    let all = [0, 1, 2, 3];
    (all.map(|k| dark(k) as f64 / (150.0 * 400.0)), all.map(crossed))
}

#[test]
fn a_map_of_the_area_sets_the_dark_share_at_each_place() {
    let points =
        Points { distance: Some([7.0; 2]), labels: Labels::Random { dark: [0.5; 2] }, ..Points::default() };
    let layer = Layer::default().with_points(points);
    let (shares, _) = by_part(layer.clone().with_map(MapKey::Area, ramp(true, [0.4, 1.6])));
    // In the middles of the parts, the factor on the probability is 0.2 + 0.6·x.
    for (share, wanted) in shares.iter().zip([0.275, 0.425, 0.575, 0.725]) {
        assert!((share - wanted).abs() < 0.06, "{shares:?}");
    }
    let mean = shares.iter().sum::<f64>() / 4.0;
    assert!((mean - 0.5).abs() < 0.01, "{mean}");
    // There are dark places of 15 to 40 px² where one point has about 44 px².
    let (shares, _) = by_part(layer.with_map(MapKey::Area, ramp(false, [10.0, 36.0])));
    assert!(shares.is_sorted() && shares[3] > 2.0 * shares[0], "{shares:?}");
}

#[test]
fn a_map_of_the_spacing_sets_the_distance_of_points_and_keeps_the_dark_share() {
    let points = Points { distance: Some([10.0; 2]), share: Some(0.4), ..Points::default() };
    let layer = Layer::default().with_points(points).with_map(MapKey::Spacing, ramp(true, [0.6, 2.4]));
    let (shares, crossed) = by_part(layer);
    let mean = shares.iter().sum::<f64>() / 4.0;
    assert!((mean - 0.4).abs() < 0.01, "{mean}");
    assert!(shares.iter().all(|share| (share - 0.4).abs() < 0.12), "{shares:?}");
    // Points are 8.3 px apart in the first part and 21.8 px in the last one; the number of edges is inversely
    // proportional to the distance.
    let ratio = crossed[0] as f64 / crossed[3] as f64;
    assert!((2.0..3.4).contains(&ratio), "{crossed:?}");
}
