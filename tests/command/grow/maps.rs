//! Maps: the attributes that a layer asks for vary by a picture or by noise, and the grown marks vary in the same way.

use crate::grow::folder::Folder;
use dapple::document::{System, SystemChoice};
use dapple::lookup::{Attributes, Spots, Stripes};
use dapple::maps::{LayerMap, MapKey, MapSource};
use dapple::tone::ToneImage;
use dapple::{Document, GrownMarks, Layer, Stroke};
use dapple_engine::grid::Field;
use dapple_engine::measure::{Regions, Spot, Target, spot_errors, stripe_errors};
use serde_json::{Value, json};

/// Parts of the canvas that are measured, from left to right.
const PARTS: usize = 4;

/// A ramp from black on the left to white on the right.
fn ramp() -> ToneImage {
    ToneImage::new([256, 1], (0..=255).collect()).expect("256 px")
}

fn by_picture(factor: bool, range: [f64; 2]) -> LayerMap {
    LayerMap { source: MapSource::Image { image: ramp(), factor }, range }
}

/// A layer with spots of 314 px², 34 px apart.
fn spots() -> Layer {
    let at = |x: f64, y: f64| Stroke::ellipse([256.0 + x, 256.0 + y], [12.6, 7.9], 20.0);
    let row = 34.0 * 0.75f64.sqrt();
    let spots = Layer::new([at(0.0, 0.0), at(34.0, 0.0), at(17.0, row), at(-17.0, row)]);
    // They are so dense that dapple would choose patches.
    spots.with_system(SystemChoice::Of(System::MEINHARDT_SPOTS.description()))
}

/// A layer with stripes 8 px wide along x.
fn stripes() -> Layer {
    Layer::new([Stroke::line([100.0, 256.0], [400.0, 256.0], 8.0)])
}

fn grown(layer: Layer) -> (GrownMarks, Field) {
    let document = Document::new([512, 512]).with_layer(layer);
    let grown = document.grow().expect("it grows");
    let marks = grown.layers[0].marks().expect("marks").clone();
    let field = marks.pattern().field(1024, 1024);
    let field = Field { cell: [0.5, 0.5], ..field };
    (marks, field)
}

/// Calls `measure` with the parts of the canvas.
fn by_part<T>(marks: &GrownMarks, measure: impl Fn(&Target) -> T) -> T {
    let part = |[x, _]: [f64; 2]| ((x / 512.0 * PARTS as f64) as usize).min(PARTS - 1);
    marks.plan.on_canvas(|target| measure(&Target { regions: Regions::Any(PARTS, &part), ..*target }))
}

/// Asserts, on each part of the canvas, the largest errors of spots: of area and spacing (relative), aspect, angle
/// (degrees).
#[track_caller]
fn spots_met(layer: Layer, [area, spacing, aspect, angle]: [f64; 4]) -> Vec<Spots> {
    let (marks, _) = grown(layer);
    let errors = by_part(&marks, |target| spot_errors(marks.measured.spots(), target));
    for of in &errors {
        let within = |error: Option<f64>, bound: f64| error.is_none_or(|error| error.abs() <= bound);
        let met = within(of.area, area) && within(of.spacing, spacing);
        assert!(of.marks > 10 && met && within(of.aspect, aspect) && within(of.angle, angle), "{errors:#?}");
    }
    errors.iter().map(|of| of.got.expect("whole spots")).collect()
}

#[test]
fn each_part_of_a_ramp_has_spots_of_the_area_that_it_asks_for() {
    let replaced = spots().with_map(MapKey::Area, by_picture(false, [150.0, 500.0]));
    let got = spots_met(replaced, [0.02, 0.03, 0.01, 1.0]);
    assert!(got[3].area > 2.1 * got[0].area, "{got:?}");
    let multiplied = spots().with_map(MapKey::Area, by_picture(true, [1.5, 0.4]));
    let got = spots_met(multiplied, [0.02, 0.03, 0.01, 1.0]);
    assert!(got[0].area > 2.1 * got[3].area, "{got:?}");
}

#[test]
fn each_part_of_a_ramp_has_the_spacing_direction_and_aspect_that_it_asks_for() {
    let apart = spots().with_map(MapKey::Spacing, by_picture(false, [36.0, 54.0]));
    let got = spots_met(apart, [0.02, 0.03, 0.01, 1.0]);
    assert!(got[3].spacing > got[0].spacing.map(|spacing| 1.25 * spacing), "{got:?}");
    let turned = spots().with_map(MapKey::Direction, by_picture(false, [0.0, 90.0]));
    let got = spots_met(turned, [0.06, 0.06, 0.01, 1.0]);
    assert!(got[3].angle - got[0].angle > 55.0, "{got:?}");
    let narrow = spots().with_map(MapKey::Aspect, by_picture(false, [0.45, 1.0]));
    let got = spots_met(narrow, [0.06, 0.06, 0.01, 1.0]);
    assert!(got[3].aspect - got[0].aspect > 0.35, "{got:?}");
}

#[test]
fn spots_without_a_drawn_spacing_are_farther_apart_where_a_map_makes_them_larger() {
    let one = Layer::new([Stroke::ellipse([256.0, 256.0], [12.0, 12.0], 0.0)]);
    let got = spots_met(one.with_map(MapKey::Area, by_picture(true, [0.5, 1.5])), [0.03, 0.04, 0.05, 90.0]);
    let [low, high] = [got[0], got[3]].map(|of| of.area.sqrt() / of.spacing.expect("many spots"));
    assert!((high / low - 1.0).abs() < 0.05, "{got:?}");
}

/// Asserts, on each part of the canvas, the largest errors of stripes: of width and period (relative), mean angle
/// (degrees).
#[track_caller]
fn stripes_met(layer: Layer, [width, period, angle]: [f64; 3]) -> Vec<Stripes> {
    let (marks, field) = grown(layer);
    let errors = by_part(&marks, |target| stripe_errors(&field, 0.5, target));
    for of in &errors {
        let within = |error: Option<f64>, bound: f64| error.is_none_or(|error| error.abs() <= bound);
        let met = within(of.width, width) && within(of.wavelength, period) && within(of.angle, angle);
        assert!(met, "{errors:#?}");
    }
    errors.iter().map(|of| of.got.expect("stripes")).collect()
}

#[test]
fn each_part_of_a_ramp_has_stripes_of_the_direction_that_it_asks_for() {
    let turned = stripes().with_map(MapKey::Direction, by_picture(true, [0.0, 90.0]));
    let got = stripes_met(turned, [0.04, 0.0, 1.5]);
    assert!(got[3].angle - got[0].angle > 60.0, "{got:?}");
}

#[test]
fn each_part_of_a_ramp_has_stripes_of_the_duty_that_it_asks_for() {
    for (range, inverted) in [([0.25, 0.5], false), ([0.5, 0.75], true)] {
        let layer = stripes().with_map(MapKey::Duty, by_picture(false, range));
        let got = stripes_met(layer, [0.08, 0.08, 2.0]);
        let duties = got.iter().map(Stripes::duty).collect::<Vec<_>>();
        let wanted = 0.6 * (range[1] - range[0]);
        assert!(duties[3] - duties[0] > wanted, "{inverted}: {duties:?}");
    }
}

#[test]
fn each_part_of_a_ramp_has_stripes_of_the_spacing_that_it_asks_for() {
    let apart = stripes().with_map(MapKey::Spacing, by_picture(false, [16.0, 26.0]));
    let got = stripes_met(apart, [0.1, 0.1, 2.0]);
    assert!(got[3].width > 1.25 * got[0].width, "{got:?}");
}

fn by_noise(size: f64, range: [f64; 2]) -> LayerMap {
    LayerMap { source: MapSource::Noise { size, octaves: 2 }, range }
}

#[test]
fn spots_have_the_area_of_the_noise_at_their_place() {
    let (marks, _) = grown(spots().with_map(MapKey::Area, by_noise(150.0, [0.4, 1.3])));
    let wanted = |spot: &Spot| match marks.plan.lookup.map.at(spot.ellipse.center) {
        Attributes::Spots(spots) => spots.area,
        Attributes::Stripes(_) => panic!("spots were drawn"),
    };
    let mut all: Vec<[f64; 2]> = marks
        .measured
        .spots()
        .iter()
        .filter(|spot| spot.whole)
        .map(|spot| [wanted(spot), spot.ellipse.area()])
        .collect();
    all.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let third = all.len() / 3;
    let means = [&all[..third], &all[2 * third..]]
        .map(|part| [0, 1].map(|k| part.iter().map(|one| one[k]).sum::<f64>() / part.len() as f64));
    assert!(means[1][0] > 1.4 * means[0][0], "{means:?}");
    for [asked, got] in means {
        assert!((got / asked - 1.0).abs() < 0.04, "{means:?}");
    }
}

#[test]
fn noise_follows_the_seed_and_nothing_else() {
    let picture = |seed: u64, threads: usize| {
        let layer = spots()
            .with_map(MapKey::Area, by_noise(60.0, [0.5, 1.3]))
            .with_map(MapKey::Colour, by_noise(40.0, [-0.3, 0.3]));
        let document =
            Document { seed, ..Document::new([160, 120]).with_layer(moved(layer, [-180.0, -200.0])) };
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| document.grow().expect("it grows").rgb())
    };
    let one = picture(3, 1);
    assert!(one == picture(3, 3) && one != picture(4, 1));
}

/// The layer with its ellipses moved.
fn moved(layer: Layer, [x, y]: [f64; 2]) -> Layer {
    let strokes = layer.strokes.iter().map(|stroke| match stroke {
        Stroke::Ellipse(one) => Stroke::ellipse([one.center[0] + x, one.center[1] + y], one.radii, one.angle),
        other => other.clone(),
    });
    Layer { strokes: strokes.collect(), ..layer }
}

#[test]
fn values_of_a_map_that_the_system_cannot_grow_are_noted() {
    let layer = stripes().with_map(MapKey::Duty, by_picture(false, [0.18, 0.7]));
    let document = Document::new([256, 256])
        .with_layer(Layer { strokes: vec![Stroke::line([30.0, 90.0], [200.0, 90.0], 8.0)], ..layer });
    let report = document.grow().expect("it grows").report();
    let notes = &report.layers[0].regions[0].notes;
    let said = "of it the maps ask for what cannot be grown, and the nearest grows: ";
    assert!(notes.iter().any(|note| note.contains(said) && note.contains("duty")), "{notes:?}");
}

/// 128 × 128 px of spots with these maps.
fn varied(maps: &Value) -> Folder {
    let mut document = crate::grow::folder::spots();
    document["version"] = json!(2);
    document["layers"][0]["maps"] = maps.clone();
    Folder::with(&document)
}

#[test]
fn colours_vary_and_marks_stay_where_they_are() {
    let folder = varied(&json!({"colour": {"noise": {"size": 30, "range": [-0.4, 0.4]}}}));
    let plain = varied(&json!({}));
    for folder in [&folder, &plain] {
        folder.grow("--pattern p.png --labels l.png");
    }
    assert_eq!(plain.gray16("p.png"), folder.gray16("p.png"));
    assert_eq!(plain.gray8("l.png"), folder.gray8("l.png"));
    let px = |folder: &Folder| image::open(folder.path("a.png")).unwrap().to_rgb8();
    assert!(px(&plain) != px(&folder));
    folder.dapple("grow a.png -o b.png").assert().success();
    assert_eq!(folder.bytes("b.png"), folder.bytes("a.png"));
}

#[test]
fn a_map_from_the_command_line_is_stored_in_the_picture_and_check_describes_it() {
    let folder = varied(&json!({}));
    image::GrayImage::from_fn(64, 8, |x, _| image::Luma([4 * x as u8]))
        .save(folder.path("ramp.png"))
        .unwrap();
    folder.grow("--map area=ramp.png:50:140 --map direction=noise:40:-30:30");
    let (document, _) = dapple::files::open(folder.path("a.png")).unwrap();
    folder.write("b.dapple", &document.to_json());
    let check = folder.dapple("check b.dapple").assert().success().get_output().clone();
    let text = String::from_utf8(check.stdout).unwrap();
    assert!(
        text.contains("a picture of 64 × 8 px gives the area: 50 px² at black to 140 px² at white"),
        "{text}"
    );
    assert!(
        text.contains("noise of 40 px in 2 octaves turns directions: by -30 degrees at its lowest"),
        "{text}"
    );
    folder.dapple("grow a.png -o b.png").assert().success();
    assert_eq!(folder.bytes("b.png"), folder.bytes("a.png"));
    folder.refuses("grow a.dapple -o ramp.png --map area=ramp.png:50:140", 2, &["--map", "ramp.png"]);
    folder.refuses(
        "grow a.dapple -o c.png --map duty=ramp.png:0.2:0.5",
        1,
        &["layers[0].maps.duty", "Only stripes have a duty"],
    );
    folder.refuses("grow a.dapple -o c.png --map area=none.png:50:140", 1, &["none.png"]);
}

#[test]
fn rings_only_take_maps_of_colours() {
    let mut document = crate::grow::folder::spots();
    document["version"] = json!(2);
    let line = json!({"kind": "line", "from": [20, 20], "to": [90, 20], "width": 3});
    let noise = json!({"noise": {"size": 30, "range": [0.5, 1.2]}});
    let rings = json!({"strokes": [line], "after": "around", "maps": {"spacing": noise}});
    document["layers"].as_array_mut().unwrap().push(rings);
    let folder = Folder::with(&document);
    folder.refuses("grow a.dapple -o a.png", 1, &["layers[1].maps.spacing", "allowed: no map"]);
}
