//! Where drawn marks vary, grown marks vary equally, with the same means.

use crate::grow::folder::{Folder, document, hexagon, spots};
use dapple::document::Edges;
use dapple::document::Spread;
use dapple::document::{Document, Layer, LayerOptions, SpreadChoice, Stroke, SystemChoice};
use dapple_engine::marks::{Ellipse, turn};
use dapple_engine::measure::SpotErrors;
use dapple_engine::rd::System;
use dapple_engine::synth::Growth;
use dapple_engine::synth::{Measured, Options};
use serde_json::{Value, json};

const EVEN: Spread = Spread::ZERO;

/// Spots of 300 px² with this aspect and density (area ÷ spacing²), at 30°.
#[derive(Clone, Copy)]
struct Spots {
    system: SystemChoice,
    aspect: f64,
    packing: f64,
}

const ROUNDISH: Spots =
    Spots { system: SystemChoice::Of(System::MEINHARDT_SPOTS.description()), aspect: 0.8, packing: 0.12 };
const LONG: Spots =
    Spots { system: SystemChoice::Of(System::MEINHARDT_SPOTS.description()), aspect: 0.5, packing: 0.16 };
const SPARSE: Spots =
    Spots { system: SystemChoice::Of(System::MEINHARDT_SPOTS.description()), aspect: 0.7, packing: 0.05 };
const TURING: Spots =
    Spots { system: SystemChoice::Of(System::TURING_SPOTS.description()), aspect: 0.5, packing: 0.22 };

/// Grows 130 to 200 of these spots with this spread on a seamless canvas: the measured spread, and the number of merged
/// marks.
fn grown(spots: Spots, spread: Spread, seed: u64) -> (SpotErrors, usize) {
    grown_about(150.0, spots, spread, seed)
}

/// Grows about `number` of these spots on a seamless canvas: the measured spread, and the number of merged marks.
fn grown_about(number: f64, spots: Spots, spread: Spread, seed: u64) -> (SpotErrors, usize) {
    let spacing = (300.0 / spots.packing).sqrt();
    let ellipse = |x: f64| Stroke::Ellipse(Ellipse::from_area([x, 200.0], 300.0, spots.aspect, 30.0));
    let layer = Layer {
        system: spots.system,
        strokes: vec![ellipse(200.0), ellipse(200.0 + spacing)],
        options: LayerOptions {
            spread: SpreadChoice::Given(spread),
            keep: Some(false),
            ..LayerOptions::default()
        },
        ..Layer::default()
    };
    let side = ((number * 0.75f64.sqrt()).sqrt() * spacing) as u32;
    let document =
        Document { size: [side, side], edges: Edges::Wrap, seed, layers: vec![layer], ..Document::default() };
    let grown = Growth::begin(&document, &Options::default(), None).run().unwrap();
    let Measured::Spots { errors, marks } = &grown.layers[0].marks().expect("marks").measured else {
        panic!("spots were drawn")
    };
    let merged = marks.iter().filter(|mark| mark.endless || mark.fill < 0.93).count();
    (errors[0], merged)
}

/// The mean spread of two patches, and the largest errors of their means.
fn spread_of(spots: Spots, asked: Spread) -> (Spread, [f64; 4]) {
    let mut got = EVEN;
    let mut worst = [0.0f64; 4];
    for seed in [1, 2] {
        let (found, merged) = grown(spots, asked, seed);
        assert_eq!(merged, 0, "{asked:?} of {} marks", found.marks);
        got = got.with(&found.spread.unwrap(), |sum, one| sum + 0.5 * one);
        for (worst, error) in worst.iter_mut().zip([found.area, found.aspect, found.angle, found.spacing]) {
            *worst = worst.max(error.unwrap_or(0.0).abs());
        }
    }
    (got, worst)
}

/// Asserts that the spread is the asked one, within the tolerance, and that the means are those of the drawing.
#[track_caller]
fn varies(spots: Spots, asked: Spread, tolerance: Spread) {
    let (got, [area, aspect, angle, spacing]) = spread_of(spots, asked);
    for (((name, asked), (_, got)), (_, tolerance)) in
        asked.named().into_iter().zip(got.named()).zip(tolerance.named())
    {
        assert!(tolerance == 0.0 || (got - asked).abs() <= tolerance, "{name}: asked {asked}, got {got}");
    }
    // Turing's spots have their own spacing, and are shaped by their neighbours.
    let free = f64::from(u8::from(spots.system == SystemChoice::Of(System::TURING_SPOTS.description())));
    assert!(area < 0.003, "the mean area is off by {area}");
    assert!(aspect < 0.006 + 0.012 * free, "the mean aspect is off by {aspect}");
    assert!(angle < 0.5 + 1.5 * free, "the mean angle is off by {angle}");
    assert!(spacing < 0.03 + 0.02 * free, "the mean spacing is off by {spacing}");
}

#[test]
fn areas_vary_as_asked() {
    for (spots, area) in [(ROUNDISH, 0.1), (ROUNDISH, 0.5), (LONG, 0.3), (SPARSE, 0.4), (TURING, 0.3)] {
        varies(spots, Spread { area, ..EVEN }, Spread { area: 0.02, ..EVEN });
    }
}

#[test]
fn directions_vary_as_asked() {
    for (spots, angle) in [(ROUNDISH, 20.0), (LONG, 5.0), (LONG, 12.0), (SPARSE, 30.0), (TURING, 15.0)] {
        varies(spots, Spread { angle, ..EVEN }, Spread { angle: 0.5 + 0.06 * angle, ..EVEN });
    }
}

#[test]
fn aspects_vary_as_asked() {
    for (spots, aspect) in [(ROUNDISH, 0.08), (LONG, 0.04), (LONG, 0.1), (SPARSE, 0.12), (TURING, 0.08)] {
        varies(spots, Spread { aspect, ..EVEN }, Spread { aspect: 0.002 + 0.12 * aspect, ..EVEN });
    }
}

/// This number of spots is placed in fewer rounds.
#[test]
fn hundreds_of_spots_vary_as_asked_at_the_distance_asked() {
    for asked in [EVEN, Spread { area: 0.2, spacing: 0.15, ..EVEN }] {
        let (found, merged) = grown_about(420.0, ROUNDISH, asked, 3);
        let (got, spacing) = (found.spread.unwrap(), found.spacing.unwrap());
        assert!(found.marks > 340 && merged == 0, "{} marks, {merged} merged", found.marks);
        assert!(spacing.abs() < 0.015, "the mean spacing is off by {spacing}");
        let natural = asked.spacing == 0.0;
        assert!(natural || (got.spacing - asked.spacing).abs() < 0.02, "asked {asked:?}, got {got:?}");
        // Without a spread, areas vary by 0.03.
        assert!((got.area - asked.area).abs() < 0.04, "asked {asked:?}, got {got:?}");
    }
}

#[test]
fn distances_vary_as_asked_beyond_their_own_variation() {
    for (spots, spacing) in [(ROUNDISH, 0.14), (ROUNDISH, 0.16), (SPARSE, 0.16)] {
        varies(spots, Spread { spacing, ..EVEN }, Spread { spacing: 0.02, ..EVEN });
    }
}

#[test]
fn all_vary_at_once() {
    let tolerance = Spread { area: 0.03, angle: 1.5, aspect: 0.009, spacing: 0.0 };
    varies(LONG, Spread { area: 0.25, angle: 10.0, aspect: 0.06, spacing: 0.0 }, tolerance);
    varies(TURING, Spread { area: 0.25, angle: 12.0, aspect: 0.07, spacing: 0.0 }, tolerance);
}

/// Twelve ellipses of about 110 px² and about 35°, all different.
fn pebbles() -> Vec<Value> {
    let place = |k: u32| [40.0 + 34.0 * f64::from(k % 4), 44.0 + 34.0 * f64::from(k / 4)];
    let off = |k: u32, by: u32| f64::from((k * by + 3) % 12) / 5.5 - 1.0;
    let ellipse = |k: u32| {
        let wide = 7.0 * (1.0 + 0.2 * off(k, 5));
        let radii = [wide, 0.7 * wide * (1.0 + 0.15 * off(k, 7))];
        json!({"kind": "ellipse", "center": place(k), "radii": radii, "angle": 35.0 + 14.0 * off(k, 11)})
    };
    (0..12).map(ellipse).collect()
}

fn drawn_spread() -> Spread {
    let ellipses: Vec<Ellipse> = pebbles()
        .iter()
        .map(|value| Ellipse {
            center: serde_json::from_value(value["center"].clone()).unwrap(),
            radii: serde_json::from_value(value["radii"].clone()).unwrap(),
            angle: value["angle"].as_f64().unwrap(),
        })
        .collect();
    Spread::measure(&ellipses)
}

#[test]
fn varied_drawn_marks_grow_varied_and_the_report_has_the_spread() {
    let mut varied = document([420, 360], &json!(pebbles()));
    let folder = Folder::with(&varied);
    assert_eq!(folder.grow("--pattern p.png --report r.json"), "");
    let region = folder.json("r.json")["layers"][0]["regions"][0].clone();
    let [asked, got]: [Spread; 2] =
        ["asked", "got"].map(|which| serde_json::from_value(region["spread"][which].clone()).unwrap());
    for ((name, asked), (_, drawn)) in asked.named().into_iter().zip(drawn_spread().named()) {
        assert!((asked - drawn).abs() < 1e-9, "{name}: asked {asked}, drawn {drawn}");
    }
    assert!((got.area - asked.area).abs() < 0.03 && (got.aspect - asked.aspect).abs() < 0.01, "{region}");
    assert!((got.angle - asked.angle).abs() < 1.0, "{region}");
    // The written picture has the same spread.
    let measured = folder.measured("p.png");
    for name in ["area", "aspect", "angle"] {
        let [output, read] =
            [&region["spread"]["got"], &measured["spread"]].map(|from| from[name].as_f64().unwrap());
        assert!((read / output - 1.0).abs() < 0.02, "{name}: {output} in the report, {read} in the picture");
    }
    for (name, tolerance) in [("area", 0.005), ("spacing", 0.03)] {
        assert!(region["error"][name].as_f64().unwrap().abs() < tolerance, "{region}");
    }
    assert!(region["error"]["aspect"].as_f64().unwrap().abs() < 0.006, "{region}");
    assert!(
        turn(region["got"]["angle"].as_f64().unwrap(), region["asked"]["angle"].as_f64().unwrap()).abs()
            < 1.0
    );
    // Without a spread, all spots are equal, except for drawn spots that are kept.
    varied["layers"][0]["options"] = json!({"spread": 0, "keep": false});
    folder.write("a.dapple", &varied.to_string());
    folder.grow("--pattern even.png --report even.json");
    assert!(folder.json("even.json")["layers"][0]["regions"][0].get("spread").is_none());
    assert!(folder.measured("even.png")["spread"]["area"].as_f64().unwrap() < 0.06);
}

#[test]
fn without_a_spread_nothing_changes() {
    let folder = Folder::with(&spots());
    folder.grow("--pattern drawn.png --report drawn.json --no-document");
    assert!(folder.json("drawn.json")["layers"][0]["regions"][0].get("spread").is_none());
    let mut even = spots();
    even["layers"][0]["options"] = json!({"spread": {"area": 0, "angle": 0}});
    folder.write("a.dapple", &even.to_string());
    // Only the pictures are compared, because the documents in them differ.
    folder.grow("--pattern even.png --no-document");
    assert!(folder.bytes("even.png") == folder.bytes("drawn.png"));
    even["layers"][0]["options"] = json!({"spread": 0.2});
    folder.write("a.dapple", &even.to_string());
    folder.grow("--pattern varied.png --no-document");
    assert!(folder.bytes("varied.png") != folder.bytes("drawn.png"));
    folder.grow("--pattern again.png --threads 1 --no-document");
    assert!(folder.bytes("again.png") == folder.bytes("varied.png"));
}

#[test]
fn a_spread_that_cannot_be_reached_is_reported() {
    let mut wild = document([128, 128], &json!(hexagon([60.0, 60.0], 30.0)));
    for stroke in wild["layers"][0]["strokes"].as_array_mut().unwrap() {
        stroke["radii"] = json!([8.0, 3.6]);
    }
    wild["layers"][0]["options"] = json!({"spread": {"angle": 45, "aspect": 0.2, "spacing": 0.1}});
    let folder = Folder::with(&wild);
    let notes = folder.grow("");
    assert!(
        notes.contains("the aspect of spots varies by 0.20, more than the 0.18 which fits around"),
        "{notes}"
    );
    assert!(notes.contains("the angle of spots varies by 45°, more than the "), "{notes}");
    assert!(notes.contains("the spacing of spots varies by 0.10, less than the "), "{notes}");
    let checked = folder.dapple("check a.dapple").assert().success().get_output().stdout.clone();
    let checked = String::from_utf8(checked).unwrap();
    assert!(checked.contains("varied: angle by 45.0°, aspect by 0.200, spacing by 0.100"), "{checked}");
    assert!(checked.contains("the aspect of spots varies by 0.20, more than the 0.18"), "{checked}");
}
