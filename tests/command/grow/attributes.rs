//! Textures have the drawn attributes, measured on the written pattern.

use crate::grow::folder::{AREA, ASPECT, Folder, SPACING, document, hexagon, spots, stripes};
use dapple_engine::attributes::{Attributes, Spots, Stripes};
use dapple_engine::grid::{Edges, Field};
use dapple_engine::marks::turn;
use dapple_engine::measure::{self, Regions, SpotErrors, StripeErrors, Target};
use serde_json::{Value, json};

/// Errors of the spots of a written pattern in each of its halves, left and right.
fn spot_errors(pattern: &Field, wanted: Spots) -> Vec<SpotErrors> {
    let half = pattern.extent()[0] / 2.0;
    let target = Target {
        bounds: pattern.grid().bounds_px(),
        regions: Regions::Any(2, &|[x, _]| usize::from(x >= half)),
        covered: &|_| false,
        wanted: &|_| Attributes::Spots(wanted),
        surface: None,
    };
    measure::spot_errors(&measure::spots(pattern, 0.5), &target)
}

fn stripe_errors(pattern: &Field, wanted: Stripes) -> StripeErrors {
    let target = Target {
        bounds: pattern.grid().bounds_px(),
        regions: Regions::ONE,
        covered: &|_| false,
        wanted: &|_| Attributes::Stripes(wanted),
        surface: None,
    };
    measure::stripe_errors(pattern, 0.5, &target)[0]
}

#[track_caller]
fn near(what: &str, error: Option<f64>, tolerance: f64) {
    let error = error.unwrap_or_else(|| panic!("no {what} was measured"));
    assert!(error.abs() <= tolerance, "{what} is off by {error}, allowed: {tolerance}");
}

#[test]
fn spots_keep_the_drawn_area_aspect_angle_and_spacing() {
    // Turing's spots are close together and turn each other slightly.
    for (system, turned) in [("auto", 2.0), ("turing-spots", 4.0)] {
        for (angle, edges) in
            [(0.0, Edges::Closed), (30.0, Edges::Wrap), (75.0, Edges::Closed), (140.0, Edges::Wrap)]
        {
            let mut document = document([200, 160], &json!(hexagon([60.0, 60.0], angle)));
            document["edges"] = json!(edges);
            document["layers"][0]["system"] = json!(system);
            let folder = Folder::with(&document);
            folder.grow("--pattern p.png");
            let wanted = Spots { area: AREA, aspect: ASPECT, angle, spacing: Some(SPACING) };
            let got = spot_errors(&folder.pattern("p.png", edges), wanted);
            let mean = |value: fn(&SpotErrors) -> Option<f64>| {
                Some(got.iter().map(|half| value(half).expect("measured")).sum::<f64>() / 2.0)
            };
            near(&format!("{system} {angle}: area"), mean(|half| half.area), 0.02);
            near(&format!("{system} {angle}: aspect"), mean(|half| half.aspect), 0.03);
            near(&format!("{system} {angle}: angle"), mean(|half| half.angle), turned);
            if system != "turing-spots" {
                // Turing's spots have their own spacing.
                near(&format!("{system} {angle}: spacing"), mean(|half| half.spacing), 0.06);
            }
        }
    }
}

#[test]
fn round_spots_stay_round() {
    let ellipse = json!([{"kind": "ellipse", "center": [50, 50], "radii": [5, 5], "angle": 20}]);
    let folder = Folder::with(&document([160, 160], &ellipse));
    folder.grow("--pattern p.png");
    let spots = measure::spots(&folder.pattern("p.png", Edges::Closed), 0.5);
    let aspects: Vec<f64> =
        spots.iter().filter(|spot| spot.whole).map(|spot| spot.ellipse.aspect()).collect();
    let mean = aspects.iter().sum::<f64>() / aspects.len() as f64;
    assert!(aspects.len() > 20 && mean > 0.94, "{} of {mean}", aspects.len());
}

#[test]
fn stripes_follow_the_drawn_lines_in_width_and_direction() {
    for edges in [Edges::Closed, Edges::Wrap] {
        let mut document = stripes();
        document["size"] = json!([200, 180]);
        document["edges"] = json!(edges);
        let folder = Folder::with(&document);
        folder.grow("--pattern p.png");
        let error = stripe_errors(
            &folder.pattern("p.png", edges),
            Stripes { width: 6.0, angle: 30.0, wavelength: None },
        );
        near("width", error.width, 0.03);
        near("angle", error.angle, 4.0);
    }
}

#[test]
fn irregular_spots_differ_in_shape_and_size_but_not_in_their_mean() {
    let ellipse = json!([{"kind": "ellipse", "center": [50, 50], "radii": [7, 5.5], "angle": 20}]);
    let mut document = document([240, 220], &ellipse);
    let mut grown = |irregular: f64| {
        document["layers"][0]["options"] = json!({"irregular": irregular});
        let folder = Folder::with(&document);
        folder.grow("--pattern p.png --report r.json");
        let layer = folder.json("r.json")["layers"][0].clone();
        let error = layer["regions"][0]["error"]["area"].as_f64().unwrap();
        assert!(error.abs() < 0.02, "{irregular}: mean area off by {error}");
        assert_eq!(layer["settled"], true);
        assert!(irregular == 0.0 || layer["system"] == "turing-spots", "{layer}");
        // They are still measured as spots.
        let output = folder.measured("p.png");
        assert_eq!(output["kind"], "spots");
        let spots = measure::spots(&folder.pattern("p.png", Edges::Closed), 0.5);
        let whole: Vec<_> = spots.iter().filter(|spot| spot.whole).collect();
        let fill = whole.iter().map(|spot| spot.fill).sum::<f64>() / whole.len() as f64;
        (output["spread"]["area"].as_f64().unwrap(), fill, folder.bytes("p.png"))
    };
    let [even, half, full] = [0.0, 0.5, 1.0].map(&mut grown);
    assert!(even.0 < 0.1 && (0.1..0.3).contains(&half.0) && (0.3..0.65).contains(&full.0), "{even:?}");
    // The stripes are bent, but they are not a labyrinth.
    assert!((0.95..0.998).contains(&full.1), "{}", full.1);
    assert!(full.2 == grown(1.0).2, "the same document, other bytes");
}

#[test]
fn thin_stripes_are_as_wide_as_drawn_and_stand_as_far_apart_as_their_duty_says() {
    for (system, duty, angle) in
        [("auto", 0.2, 20.0), ("auto", 0.3, 90.0), ("auto", 0.42, 130.0), ("meinhardt-lines", 0.5, 65.0)]
    {
        let mut document = stripes();
        let [c, s] = [libm::cos, libm::sin].map(|f| 20.0 * f(f64::to_radians(angle)));
        let [from, to] = [[120.0 - c, 120.0 - s], [120.0 + c, 120.0 + s]];
        document["size"] = json!([240, 240]);
        document["layers"][0]["system"] = json!(system);
        document["layers"][0]["options"] = json!({"duty": duty});
        document["layers"][0]["strokes"] = json!([{"kind": "line", "from": from, "to": to, "width": 5}]);
        let folder = Folder::with(&document);
        folder.grow("--pattern p.png --report r.json");
        let layer = folder.json("r.json")["layers"][0].clone();
        assert_eq!((&layer["system"], &layer["settled"]), (&json!("meinhardt-lines"), &json!(true)));
        let of = |part: &str, key: &str| layer["regions"][0][part][key].as_f64();
        assert!((of("asked", "wavelength").unwrap() - 5.0 / duty).abs() < 1e-9);
        for key in ["width", "wavelength"] {
            assert!((of("got", key).unwrap() / of("asked", key).unwrap() - 1.0).abs() < 0.05, "{layer}");
        }
        let pattern = folder.pattern("p.png", Edges::Closed);
        let error = stripe_errors(&pattern, Stripes { width: 5.0, angle, wavelength: Some(5.0 / duty) });
        near(&format!("{duty}: width"), error.width, 0.01);
        near(&format!("{duty}: wavelength"), error.wavelength, 0.05);
        near(&format!("{duty}: angle"), error.angle, 3.0);
        // About 240·duty/5 lines cross the canvas; at most about one of them is broken.
        let pieces = measure::spots(&pattern, 0.5);
        let lines = 240.0 * duty / 5.0 * (c.abs() + s.abs()) / 20.0;
        assert!((pieces.len() as f64) < 1.5 * lines, "{duty}: {} pieces of {lines} lines", pieces.len());
        let bead = pieces.iter().find(|piece| piece.whole && piece.ellipse.area() < 3.0 * 25.0);
        assert!(bead.is_none(), "{duty}: a bead at {bead:?}");
    }
}

#[test]
fn a_region_without_marks_takes_its_neighbour_s_attributes() {
    let mut document = document([220, 130], &json!(hexagon([60.0, 60.0], 110.0)));
    document["regions"] = json!([2, 1]);
    let folder = Folder::with(&document);
    folder.grow("--pattern p.png --report r.json");
    let report = folder.json("r.json");
    let asked = |index: usize| report["layers"][0]["regions"][index]["asked"].clone();
    assert_eq!(asked(0), asked(1));
    let wanted = Spots { area: AREA, aspect: ASPECT, angle: 110.0, spacing: Some(SPACING) };
    let right = spot_errors(&folder.pattern("p.png", Edges::Closed), wanted)[1];
    assert!(right.marks >= 10, "{right:?}");
    near("area", right.area, 0.02);
    near("aspect", right.aspect, 0.03);
    near("angle", right.angle, 2.0);
    near("spacing", right.spacing, 0.08);
}

#[test]
fn attributes_change_over_the_canvas_as_drawn() {
    let ellipse = |x: f64, scale: f64, angle: f64| json!({"kind": "ellipse", "center": [x, 80], "radii": [7.0 * scale, 4.0 * scale], "angle": angle});
    let mut document = document([400, 160], &json!([ellipse(100.0, 1.0, 20.0), ellipse(300.0, 1.3, 50.0)]));
    document["regions"] = json!([2, 1]);
    let folder = Folder::with(&document);
    folder.grow("--pattern p.png");
    let spots = measure::spots(&folder.pattern("p.png", Edges::Closed), 0.5);
    // Beyond the centres of the outer regions, attributes are constant.
    let mean = |far: fn(f64) -> bool| {
        let there: Vec<_> = spots.iter().filter(|spot| spot.whole && far(spot.ellipse.center[0])).collect();
        let count = there.len() as f64;
        let area = there.iter().map(|spot| spot.ellipse.area()).sum::<f64>() / count;
        let angle = dapple_engine::attributes::axial_mean(
            there.iter().map(|spot| (spot.ellipse.major_angle(), 1.0 - spot.ellipse.aspect())),
        );
        (area, angle.unwrap().0)
    };
    let (left, right) = (mean(|x| x < 90.0), mean(|x| x > 310.0));
    assert!(
        (left.0 / AREA - 1.0).abs() < 0.05 && (right.0 / AREA / 1.69 - 1.0).abs() < 0.05,
        "{left:?} {right:?}"
    );
    assert!(turn(left.1, 20.0).abs() < 4.0 && turn(right.1, 50.0).abs() < 4.0, "{left:?} {right:?}");
}

#[test]
fn measuring_the_pattern_gives_the_numbers_of_the_report() {
    let number = |value: &Value, key: &str| value[key].as_f64().unwrap_or_else(|| panic!("{key} in {value}"));
    let folder = Folder::with(&spots());
    folder.grow("--pattern p.png --report r.json");
    let (measured, region) =
        (folder.measured("p.png"), folder.json("r.json")["layers"][0]["regions"][0].clone());
    assert_eq!((&measured["kind"], &measured["marks"]), (&json!("spots"), &region["marks"]));
    let got = &region["got"];
    assert!((number(&measured, "area") / number(got, "area") - 1.0).abs() < 0.001);
    assert!((number(&measured, "aspect") - number(got, "aspect")).abs() < 0.001);
    assert!(turn(number(&measured, "angle"), number(got, "angle")).abs() < 0.1);
    // Here an edge counts as too long compared with the median; in the report, compared with the spacing that was asked
    // for.
    assert!((number(&measured, "spacing") / number(got, "spacing") - 1.0).abs() < 0.03);
    let folder = Folder::with(&stripes());
    folder.grow("--pattern p.png --report r.json");
    let (measured, region) =
        (folder.measured("p.png"), folder.json("r.json")["layers"][0]["regions"][0].clone());
    assert_eq!(measured["kind"], "stripes");
    assert!((number(&measured, "width") / number(&region["got"], "width") - 1.0).abs() < 0.001);
    assert!(turn(number(&measured, "angle"), number(&region["got"], "angle")).abs() < 0.1);
}

/// The value that 98 of 100 values do not exceed.
fn high(mut values: Vec<f32>) -> f32 {
    values.sort_by(f32::total_cmp);
    values[values.len() * 98 / 100]
}

#[test]
fn a_wrapped_texture_has_no_seam() {
    for mut document in [spots(), stripes()] {
        document["size"] = json!([160, 140]);
        document["edges"] = json!("wrap");
        let folder = Folder::with(&document);
        folder.grow("--pattern p.png");
        let field = folder.pattern("p.png", Edges::Wrap);
        let (w, h) = (field.width as isize, field.height as isize);
        let down = |x: isize, y: isize| (field.get(x, y) - field.get(x, y + 1)).abs();
        let along = |x: isize, y: isize| (field.get(x, y) - field.get(x + 1, y)).abs();
        let inner = |step: &dyn Fn(isize, isize) -> f32| {
            high((0..(w - 1) * (h - 1)).map(|k| step(k % (w - 1), k / (w - 1))).collect())
        };
        let (across_bottom, inside) = (high((0..w).map(|x| down(x, h - 1)).collect()), inner(&down));
        assert!(across_bottom <= 1.25 * inside, "{across_bottom} {inside}");
        let (across_side, inside) = (high((0..h).map(|y| along(w - 1, y)).collect()), inner(&along));
        assert!(across_side <= 1.25 * inside, "{across_side} {inside}");
        // A texture with closed edges would fail: its left and right borders are independent.
        document["edges"] = json!("closed");
        folder.write("a.dapple", &document.to_string());
        folder.grow("--pattern closed.png");
        let field = folder.pattern("closed.png", Edges::Wrap);
        let along = |x: isize, y: isize| (field.get(x, y) - field.get(x + 1, y)).abs();
        assert!(high((0..h).map(|y| along(w - 1, y)).collect()) > 1.25 * inner(&along));
    }
}
