//! Drawn marks that are kept grow at the places where they were drawn.

use crate::grow::folder::{Folder, document};
use dapple::WriteFile;
use dapple::document::Edges;
use dapple::document::{Document, Layer, LayerOptions, Stroke, SystemChoice};
use dapple_engine::attributes::AttributeMap;
use dapple_engine::grid::resample::Spline;
use dapple_engine::marks::{Ellipse, Line, Mark, Path, turn};
use dapple_engine::measure::Spot;

use dapple_engine::synth::kind::Setting;
use dapple_engine::synth::marks::grow::MarksLayer;
use dapple_engine::synth::marks::plan::{Surroundings, look_up};
use dapple_engine::synth::marks::report::pinned::distances;
use dapple_engine::synth::passes::{PassSet, Passes};
use dapple_engine::synth::report::covered::covered;
use dapple_engine::synth::{GrownMarks, Growth, Measured, Options, Training};
use serde_json::{Value, json};

fn grown(document: &Document) -> GrownMarks {
    Growth::begin(document, &Options::default(), None)
        .run()
        .unwrap()
        .layers
        .remove(0)
        .into_marks()
        .expect("spots or stripes")
}

/// Distances of the pinned spots from the nearest grown ones, in radii.
fn off(grown: &GrownMarks) -> Vec<f64> {
    distances(grown.corrections.pinned_spots(), grown.plan.lookup.map.layout(), grown.measured.spots())
}

/// Ten spots like those that a user draws: uneven, of several sizes, two of them cut by the edge.
fn drawn() -> Vec<Ellipse> {
    let ellipse =
        |x: f64, y: f64, r: f64, q: f64, angle: f64| Ellipse { center: [x, y], radii: [r, q], angle };
    vec![
        ellipse(6.0, 40.0, 14.0, 9.0, 20.0),
        ellipse(60.0, 52.0, 16.0, 10.0, 35.0),
        ellipse(104.0, 30.0, 13.0, 9.0, 25.0),
        ellipse(150.0, 5.0, 13.0, 9.0, 30.0),
        ellipse(40.0, 92.0, 13.0, 8.0, 15.0),
        ellipse(88.0, 90.0, 18.0, 10.0, 32.0),
        ellipse(139.0, 66.0, 14.0, 10.0, 40.0),
        ellipse(70.0, 133.0, 13.0, 9.0, 27.0),
        ellipse(118.0, 128.0, 15.0, 10.0, 24.0),
        ellipse(166.0, 105.0, 15.0, 9.0, 10.0),
    ]
}

fn one_layer(ellipses: &[Ellipse], edges: Edges) -> Document {
    let strokes = ellipses.iter().map(|ellipse| Stroke::Ellipse(*ellipse)).collect();
    let layers = vec![Layer { strokes, ..Layer::default() }];
    Document { size: [300, 240], edges, layers, ..Document::default() }
}

fn spots(layer: &GrownMarks) -> &[Spot] {
    let Measured::Spots { marks, .. } = &layer.measured else { panic!("spots were drawn") };
    marks
}

fn nearest(spots: &[Spot], to: [f64; 2]) -> Spot {
    let far = |spot: &&Spot| (spot.ellipse.center[0] - to[0]).hypot(spot.ellipse.center[1] - to[1]);
    *spots.iter().min_by(|a, b| far(a).total_cmp(&far(b))).expect("spots have grown")
}

#[test]
fn each_kept_spot_grows_in_its_place_with_its_size_and_direction() {
    for edges in [Edges::Closed, Edges::Wrap] {
        let layer = grown(&one_layer(&drawn(), edges));
        let off = off(&layer);
        assert_eq!(off.len(), 10);
        assert!(off.iter().all(|off| *off < 0.25), "{edges:?}: {off:?}");
        let (mut turned, mut grown) = (Vec::new(), Vec::new());
        for mark in drawn().iter().filter(|mark| mark.center[0] > 10.0 && mark.center[1] > 10.0) {
            let found = nearest(spots(&layer), mark.center).ellipse;
            grown.push((found.area() / mark.area() - 1.0).abs());
            assert!((found.aspect() - mark.aspect()).abs() < 0.06, "{mark:?} grew as {found:?}");
            turned.push(turn(found.major_angle(), mark.angle).abs());
        }
        // Crowded marks are smaller than drawn.
        let mean = grown.iter().sum::<f64>() / grown.len() as f64;
        assert!(mean < 0.1 && grown.iter().all(|off| *off < 0.25), "{edges:?}: areas off by {grown:?}");
        // Neighbours turn some marks by up to 7°.
        let mean = turned.iter().sum::<f64>() / turned.len() as f64;
        assert!(mean < 3.0 && turned.iter().all(|turned| *turned < 9.0), "{edges:?}: turned by {turned:?}");
    }
}

#[test]
fn a_region_with_kept_marks_has_the_drawn_attributes() {
    for seed in [1, 2, 3] {
        let layer = grown(&Document { seed, size: [420, 400], ..one_layer(&drawn(), Edges::Wrap) });
        let Measured::Spots { errors, .. } = &layer.measured else { panic!("spots were drawn") };
        let [area, aspect, angle, spacing] =
            [errors[0].area, errors[0].aspect, errors[0].angle, errors[0].spacing].map(Option::unwrap);
        assert!(area.abs() < 0.003 && aspect.abs() < 0.006, "{area} {aspect}");
        assert!(angle.abs() < 1.0 && spacing.abs() < 0.04, "{angle} {spacing}");
    }
}

#[test]
fn marks_too_close_together_are_counted_and_as_many_as_possible_stay() {
    let mut marks = drawn();
    // One mark lies between two neighbours, so that only this mark is not kept; another lies nearly on a drawn one.
    marks.push(Ellipse { center: [74.0, 71.0], ..marks[5] });
    marks.push(Ellipse { center: [168.0, 108.0], ..marks[5] });
    let document = Document { edges: Edges::Wrap, ..one_layer(&marks, Edges::Wrap) };
    let folder = Folder::new();
    document.write(folder.path("a.dapple")).unwrap();
    let said = folder.grow("--report r.json");
    assert!(
        said.contains("2 of 12 drawn marks did not grow: at (74, 71): closer to another drawn mark than such spots can be"),
        "{said}"
    );
    let region = folder.json("r.json")["layers"][0]["regions"][0].clone();
    assert_eq!((&region["kept"]["drawn"], &region["kept"]["kept"]), (&json!(12), &json!(10)));
    assert!(region["kept"]["farthest"].as_f64().unwrap() < 0.25, "{region}");
}

#[test]
fn on_a_larger_canvas_kept_marks_are_at_scaled_places_with_their_size_unchanged() {
    let document = one_layer(&drawn(), Edges::Closed);
    let options = Options { size: Some([450, 480]), ..Options::default() };
    let grown = Growth::begin(&document, &options, None).run().unwrap();
    let mark = drawn()[5];
    let found =
        nearest(spots(grown.layers[0].marks().expect("marks")), [mark.center[0] * 1.5, mark.center[1] * 2.0])
            .ellipse;
    let off = [found.center[0] - mark.center[0] * 1.5, found.center[1] - mark.center[1] * 2.0];
    assert!(off[0].hypot(off[1]) < 3.0 && (found.area() / mark.area() - 1.0).abs() < 0.08, "{found:?}");
}

#[test]
fn marks_are_kept_by_default_only_if_there_is_one_region() {
    let mut document = one_layer(&drawn(), Edges::Closed);
    assert_eq!(grown(&document).corrections.pinned_spots().len(), 10);
    document.regions = Some([2, 1]);
    assert!(grown(&document).corrections.pinned_spots().is_empty());
    document.layers[0].options.keep = Some(true);
    let layer = grown(&document);
    let off = off(&layer);
    assert!(off.len() == 10 && off.iter().all(|off| *off < 0.25), "{off:?}");
    document.regions = Some([1, 1]);
    document.layers[0].options.keep = Some(false);
    assert!(grown(&document).corrections.pinned_spots().is_empty());
}

#[test]
fn a_mark_drawn_on_one_of_a_layer_beneath_is_not_kept_and_reported() {
    let ellipse = |center: [f64; 2], r: f64| json!({"kind": "ellipse", "center": center, "radii": [r, r]});
    let mut both = document([200, 160], &json!([]));
    both["layers"] = json!([
        {"strokes": [ellipse([60.0, 60.0], 10.0), ellipse([120.0, 60.0], 10.0)]},
        {"strokes": [ellipse([62.0, 60.0], 3.0), ellipse([90.0, 60.0], 3.0), ellipse([90.0, 74.0], 3.0)]}
    ]);
    let folder = Folder::with(&both);
    let said = folder.grow("--report r.json");
    let output =
        "1 of 3 drawn marks did not grow: at (62, 60): on a mark of a layer beneath, or too close to one";
    assert!(said.contains(output), "{said}");
    let kept = folder.json("r.json")["layers"][1]["regions"][0]["kept"].clone();
    assert!(kept["farthest"].as_f64().unwrap() < 0.25, "{kept}");
}

#[test]
fn kept_marks_grow_equal_again_and_on_one_thread() {
    let folder = Folder::new();
    one_layer(&drawn(), Edges::Closed).write(folder.path("a.dapple")).unwrap();
    folder.grow("--pattern p.png");
    folder.grow("--pattern again.png --threads 1");
    assert!(folder.bytes("p.png") == folder.bytes("again.png"));
}

/// Stripes 8 px wide along these lines.
fn lined(regions: [u32; 2], keeps: Option<bool>) -> Document {
    let line = |from: [f64; 2], to: [f64; 2]| Stroke::Line(Line { from, to, width: 8.0 });
    let strokes = vec![
        line([40.0, 50.0], [110.0, 70.0]),
        line([60.0, 120.0], [140.0, 150.0]),
        line([200.0, 60.0], [260.0, 90.0]),
        line([190.0, 170.0], [270.0, 185.0]),
    ];
    let options = LayerOptions { keep: keeps, ..LayerOptions::default() };
    let layers = vec![Layer { strokes, options, ..Layer::default() }];
    Document { size: [300, 240], regions: Some(regions), layers, ..Document::default() }
}

/// For each line of `document`, the share of it that lies in a stripe of `layer`.
fn in_stripes(document: &Document, layer: &GrownMarks) -> Vec<f64> {
    let marks = dapple_engine::synth::drawn::sketch_targets::marks(document, 0, "test").unwrap();
    let [width, height] = document.size.map(|side| side as usize);
    let lines: Vec<Path> = marks.iter().filter_map(Mark::path).collect();
    let surface = Spline::new(&layer.pattern().field(width, height));
    let layout = layer.plan.lookup.map.layout();
    lines.iter().map(|line| covered(line, layout, &surface, |_| false).unwrap_or(0.0)).collect()
}

#[test]
fn drawn_lines_lie_in_stripes_and_directions_do_not_become_worse() {
    let rms = |layer: &GrownMarks| {
        let Measured::Stripes(errors) = &layer.measured else { panic!("lines were drawn") };
        errors.iter().map(|error| error.angle_rms.unwrap()).sum::<f64>() / errors.len() as f64
    };
    for regions in [[1, 1], [2, 2]] {
        let document = lined(regions, Some(true));
        let kept = grown(&document);
        let shares = in_stripes(&document, &kept);
        assert!(shares.iter().all(|share| *share >= 0.9), "{shares:?}");
        let free = grown(&lined(regions, Some(false)));
        assert!(in_stripes(&document, &free).iter().any(|share| *share < 0.8));
        assert!(rms(&kept) < rms(&free) + 1.5, "{} {}", rms(&kept), rms(&free));
    }
    assert_eq!(grown(&lined([1, 1], None)).plan.pinned_lines().len(), 4);
    assert!(grown(&lined([2, 2], None)).plan.pinned_lines().is_empty());
}

#[test]
fn lines_that_no_stripes_can_follow_are_reported() {
    let mut crossed = document([200, 160], &json!([]));
    let line = |from: [f64; 2], to: [f64; 2]| json!({"kind": "line", "from": from, "to": to, "width": 8});
    crossed["layers"][0]["strokes"] = json!([
        line([20.0, 40.0], [150.0, 60.0]),
        line([80.0, 20.0], [90.0, 140.0]),
        line([20.0, 90.0], [180.0, 100.0])
    ]);
    let folder = Folder::with(&crossed);
    let said = folder.grow("--report r.json");
    let kept: Value = folder.json("r.json")["layers"][0]["regions"][0]["kept"].clone();
    assert!(said.contains("1 of 3 drawn lines lie partly outside of stripes: at (85, 80)"), "{said}");
    assert_eq!((&kept["drawn"], &kept["kept"]), (&json!(3), &json!(3)));
    assert!(kept["off"].as_u64().unwrap() >= 1, "{kept}");
}

/// Distances of the grown `marks` from their places, among spots of 300 px² with this density and aspect at 30°, on a
/// canvas of 12 spacings.
fn among(
    system: SystemChoice,
    packing: f64,
    aspect: f64,
    edges: Edges,
    marks: &dyn Fn(f64) -> Vec<Mark>,
) -> Vec<f64> {
    let spacing = (300.0 / packing).sqrt();
    let ellipse = |x: f64| Mark::Ellipse(Ellipse::from_area([x, 200.0], 300.0, aspect, 30.0));
    let drawn = [ellipse(200.0), ellipse(200.0 + spacing)];
    let map = AttributeMap::from_marks(&drawn, [12.0 * spacing; 2], Some([1, 1]), edges).unwrap();
    let training = Training::built_in();
    let lookup = look_up(training, system, &map).unwrap().with_pinned(training, &marks(spacing)).unwrap();
    let begun = lookup.uncorrected().lay_out(Surroundings::default(), 1).unwrap().begin(1);
    let setting = Setting {
        seed: 1,
        source: "pairs",
        training,
        memory: None,
        corrects: true,
        without: PassSet::NONE,
        concentrations: false,
        filmed: false,
    };
    let mut layer = MarksLayer::new(begun, LayerOptions::default(), setting).unwrap();
    let mut passes = Passes::new(true, PassSet::NONE);
    while !passes.advance(&mut layer, u64::MAX).unwrap().done {}
    let grown = layer.complete().unwrap();
    assert_eq!(grown.corrections.left_out(), []);
    off(&grown)
}

/// Nine pairs whose marks are `apart` spacings from each other, along or across the marks.
fn pairs(aspect: f64, apart: f64, across: bool) -> impl Fn(f64) -> Vec<Mark> {
    let longer = if across { 1.0 / aspect } else { aspect };
    let (s, c) = (if across { 120.0f64 } else { 30.0 }).to_radians().sin_cos();
    move |spacing| {
        let pair = |k: i32| {
            let at = [k % 3, k / 3].map(|v| (2.0 + 4.0 * f64::from(v)) * spacing);
            let half = 0.5 * apart * spacing / f64::sqrt(longer);
            [-half, half].map(|h| {
                Mark::Ellipse(Ellipse::from_area([at[0] + h * c, at[1] + h * s], 300.0, aspect, 30.0))
            })
        };
        (0..9).flat_map(pair).collect()
    }
}

#[test]
fn close_pairs_of_marks_are_kept_at_their_places() {
    for (packing, aspect, apart) in [(0.2, 0.5, 0.75), (0.12, 0.95, 0.65), (0.05, 0.8, 0.55)] {
        for across in [false, true] {
            let off = among(SystemChoice::Auto, packing, aspect, Edges::Wrap, &pairs(aspect, apart, across));
            assert!(off.len() == 18 && off.iter().all(|off| *off < 0.1), "{packing} {across}: {off:?}");
        }
    }
}
