//! Free marks: a drawn mark grows where it was drawn, and the texture continues between and beyond the marks.

use dapple::document::{Document, Layer, Stroke};
use dapple_engine::attributes::Attributes;
use dapple_engine::marks::turn;
use dapple_engine::measure::{Directions, Spot};
use dapple_engine::synth::layer_report::report;
use dapple_engine::synth::report::DrawnMark;
use dapple_engine::synth::{GrowError, Grown, Growth, LayerError, Options};

fn free(strokes: Vec<Stroke>) -> Document {
    let layers = vec![Layer { strokes, ..Layer::default() }];
    let document = Document { size: [512, 512], layers, ..Document::default() };
    assert_eq!(document.regions, None);
    document
}

fn grown(strokes: Vec<Stroke>) -> (Grown, Vec<DrawnMark>) {
    let document = free(strokes);
    let grown = Growth::begin(&document, &Options::default(), None).run().unwrap();
    let drawn = report(&document, "free", &grown, 0.0).layers.remove(0).drawn;
    (grown, drawn)
}

/// Asserts that every mark is there, at most `off` of its radius from its place, with its area and aspect within these
/// shares.
fn assert_there(marks: &[DrawnMark], count: usize, off: f64, area: f64, aspect: f64) {
    assert_eq!(marks.len(), count);
    for mark in marks {
        assert!(mark.there && mark.off.is_some_and(|found| found <= off), "{mark:?}");
        if let (Some(Attributes::Spots(asked)), Some(Attributes::Spots(got))) = (mark.asked, mark.got) {
            assert!((got.area / asked.area - 1.0).abs() < area, "{mark:?}");
            assert!((got.aspect - asked.aspect).abs() < aspect, "{mark:?}");
            if asked.aspect < 0.8 {
                assert!(turn(got.angle, asked.angle).abs() < 8.0, "{mark:?}");
            }
        }
    }
}

#[test]
fn each_ellipse_of_an_array_is_there_with_its_size_and_shape() {
    let place = |k: usize| [96.0 + 80.0 * (k % 5) as f64, 96.0 + 80.0 * (k / 5) as f64];
    let (_, marks) = grown((0..25).map(|k| Stroke::ellipse(place(k), [14.0, 10.0], 30.0)).collect());
    assert_there(&marks, 25, 0.2, 0.05, 0.05);
}

#[test]
fn rows_of_long_ellipses_drawn_end_to_end_all_grow() {
    let long = |k: usize| {
        let place = [40.0 + 50.0 * (k % 8) as f64, 40.0 + 60.0 * (k / 8) as f64];
        Stroke::ellipse(place, [20.0, 6.0], 0.0)
    };
    let (_, marks) = grown((0..56).map(long).collect());
    assert_there(&marks, 56, 0.2, 0.2, 0.05);
}

#[test]
fn a_spot_drawn_narrower_than_possible_does_not_become_two_spots() {
    let narrow = |minor| {
        [
            Stroke::ellipse([20.0, 60.0], [40.0, minor], 90.0),
            Stroke::ellipse([200.0, 200.0], [15.0, 10.0], 0.0),
        ]
    };
    for minor in [2.0, 2.8, 3.2] {
        let (_, marks) = grown(narrow(minor).to_vec());
        let Some(Attributes::Spots(got)) = marks[0].got else { panic!("{:?}", marks[0]) };
        assert!(marks[0].there && (0.14..0.2).contains(&got.aspect), "{:?}", marks[0]);
    }
}

#[test]
fn ellipses_in_a_ring_keep_their_places_and_the_others_follow_the_ring() {
    let ellipse = |k: usize| {
        let angle = std::f64::consts::TAU * k as f64 / 12.0;
        let center = [256.0 + 120.0 * angle.cos(), 256.0 + 120.0 * angle.sin()];
        Stroke::ellipse(center, [16.0, 8.0], angle.to_degrees() + 90.0)
    };
    let (grown, marks) = grown((0..12).map(ellipse).collect());
    assert_there(&marks, 12, 0.2, 0.05, 0.05);
    // Outside the ring, but still close to it, the spots lie along circles.
    let spots = grown.layers[0].marks().expect("marks").measured.spots().iter().filter(|spot| spot.whole);
    let ring = spots.filter(|spot| {
        let [x, y] = [0, 1].map(|axis| spot.ellipse.center[axis] - 256.0);
        (140.0..190.0).contains(&x.hypot(y))
    });
    let off: Vec<f64> = ring
        .map(|spot| {
            let [x, y] = [0, 1].map(|axis| spot.ellipse.center[axis] - 256.0);
            turn(spot.ellipse.major_angle(), y.atan2(x).to_degrees() + 90.0).abs()
        })
        .collect();
    let mean = off.iter().sum::<f64>() / off.len() as f64;
    assert!(off.len() > 8 && mean < 10.0, "{} spots, {mean}° off", off.len());
}

#[test]
fn ellipses_of_aspect_0_15_at_any_angle_are_there_with_their_shape() {
    let place = |k: usize| [70.0 + 124.0 * (k % 4) as f64, 70.0 + 124.0 * (k / 4) as f64];
    let ellipse = |k: usize| Stroke::ellipse(place(k), [34.0, 5.1], 11.25 * k as f64);
    let (_, marks) = grown((0..16).map(ellipse).collect());
    assert!(marks.len() == 16 && marks.iter().all(|mark| mark.there), "{marks:?}");
    // The neighbours that were not drawn may shorten one of them.
    let mut errors: Vec<[f64; 3]> = marks.iter().map(errors).collect();
    for (part, [median, most]) in [[0.01, 0.2], [0.012, 0.06], [1.0, 4.0]].into_iter().enumerate() {
        errors.sort_by(|a, b| a[part].total_cmp(&b[part]));
        assert!(errors[8][part] < median && errors[14][part] < most, "{part}: {errors:?}");
    }
}

/// The differences of area (relative), aspect and direction (degrees) between a grown mark and the drawn one.
fn errors(mark: &DrawnMark) -> [f64; 3] {
    let (Some(Attributes::Spots(asked)), Some(Attributes::Spots(got))) = (mark.asked, mark.got) else {
        panic!("{mark:?}");
    };
    let turned = turn(got.angle, asked.angle).abs();
    [(got.area / asked.area - 1.0).abs(), (got.aspect - asked.aspect).abs(), turned]
}

#[test]
fn marks_of_very_different_sizes_keep_their_sizes() {
    let sizes = [4.5, 6.0, 9.0, 14.0, 20.0, 11.0, 5.5, 16.0, 7.0];
    let place = |k: usize| [100.0 + 156.0 * (k % 3) as f64, 100.0 + 156.0 * (k / 3) as f64];
    let ellipse = |(k, r): (usize, &f64)| Stroke::ellipse(place(k), [*r, 0.8 * r], 20.0 * k as f64);
    let (_, marks) = grown(sizes.iter().enumerate().map(ellipse).collect());
    assert_there(&marks, 9, 0.2, 0.2, 0.12);
}

#[test]
fn ellipses_a_quarter_of_their_diameter_apart_all_grow() {
    let drawn = [
        ([281.0, 212.0], [13.4, 6.7], 109.0),
        ([304.0, 168.0], [12.9, 7.5], 80.0),
        ([311.0, 203.0], [14.4, 7.4], 166.0),
        ([257.0, 148.0], [14.7, 7.5], 32.0),
        ([271.0, 182.0], [15.0, 7.1], 70.0),
    ];
    let (_, marks) = grown(drawn.map(|(center, radii, angle)| Stroke::ellipse(center, radii, angle)).into());
    assert_there(&marks, 5, 0.2, 0.2, 0.12);
}

#[test]
fn one_of_two_ellipses_that_overlap_grows_and_the_other_is_named() {
    let twice = [[150.0, 150.0], [162.0, 154.0], [350.0, 200.0], [250.0, 400.0]];
    let (_, marks) = grown(twice.map(|place| Stroke::ellipse(place, [11.0, 7.0], 20.0)).into());
    assert_eq!(marks.iter().filter(|mark| mark.there).count(), 3, "{marks:?}");
    let missing = marks.iter().find(|mark| !mark.there).expect("one is missing");
    assert!(missing.mark < 2 && missing.reason.is_some(), "{missing:?}");
}

#[test]
fn the_visible_part_of_a_spot_that_the_border_cuts_has_the_drawn_area() {
    let places = [[300.0, 4.0], [4.0, 200.0], [506.0, 350.0], [250.0, 250.0], [120.0, 390.0]];
    let drawn = places.map(|place| Stroke::ellipse(place, [14.0, 10.0], 30.0));
    let (grown, marks) = grown(drawn.into());
    assert!(marks.iter().all(|mark| mark.there), "{marks:?}");
    for pinned in grown.layers[0].marks().expect("marks").corrections.pinned_spots() {
        let near = |spot: &&Spot| {
            let [x, y] = [0, 1].map(|axis| spot.ellipse.center[axis] - pinned.visible.center[axis]);
            x.hypot(y) < 7.0
        };
        let got =
            grown.layers[0].marks().expect("marks").measured.spots().iter().find(near).expect("it is there");
        assert!((got.ellipse.area() / pinned.visible.area - 1.0).abs() < 0.15, "{got:?} {pinned:?}");
    }
}

#[test]
fn stripes_follow_a_drawn_arc_along_its_whole_length() {
    let point = |r: f64, k: usize| {
        let angle = (200.0 + 140.0 * k as f64 / 32.0).to_radians();
        [256.0 + r * angle.cos(), 460.0 + r * angle.sin()]
    };
    let arcs = [150.0, 250.0, 350.0];
    let (grown, _) = grown(arcs.iter().map(|r| Stroke::path((0..=32).map(|k| point(*r, k)), 10.0)).collect());
    let pattern = grown.layers[0].pattern().field(256, 256);
    let directions = Directions::measure(&pattern, 20.0);
    let places: Vec<(usize, [f64; 2])> = directions.at_places(|place| {
        let [x, y] = [place[0] - 256.0, place[1] - 460.0];
        let near = arcs.iter().any(|r| (x.hypot(y) - r).abs() < 10.0 && y < -0.35 * r);
        let double = 2.0 * (y.atan2(x) + std::f64::consts::FRAC_PI_2);
        (usize::from(!near), [double.cos(), double.sin()])
    });
    let found = directions.deviations(&places, 2)[0].expect("there are stripes on the arcs");
    assert!(found.mean.abs() < 3.0 && found.rms < 12.0, "{} {}", found.mean, found.rms);
}

#[test]
fn stripes_keep_the_distance_of_lines_drawn_side_by_side() {
    let line =
        |k: usize| Stroke::line([120.0, 180.0 + 26.0 * k as f64], [390.0, 180.0 + 26.0 * k as f64], 8.0);
    let (grown, marks) = grown((0..5).map(line).collect());
    assert!(marks.iter().all(|mark| mark.there), "{marks:?}");
    let Some(Attributes::Stripes(got)) = grown.layers[0].marks().expect("marks").measured.got(0) else {
        panic!("stripes grew")
    };
    let wavelength = got.wavelength.expect("a distance was drawn");
    assert!((wavelength / 26.0 - 1.0).abs() < 0.08 && (got.width / 8.0 - 1.0).abs() < 0.05, "{got:?}");
}

#[test]
fn strokes_round_a_centre_do_not_drift_outwards() {
    let ring = |k: usize| {
        let point = |i: usize| {
            let angle = (80.0 * k as f64 + 300.0 * i as f64 / 60.0).to_radians();
            let radius = 75.0 + 39.0 * k as f64;
            [250.0 + radius * angle.cos(), 256.0 + radius * angle.sin()]
        };
        Stroke::path((0..=60).map(point), 15.0)
    };
    let (_, marks) = grown((0..4).map(ring).collect());
    assert!(marks.len() == 4 && marks.iter().all(|mark| mark.there), "{marks:?}");
}

#[test]
fn a_spot_and_the_dots_around_it_of_a_twentieth_of_its_area_keep_their_sizes() {
    let dots = (0..36).map(|k| [71.0 + 74.0 * (k % 6) as f64, 71.0 + 74.0 * (k / 6) as f64]);
    let away = |[x, y]: &[f64; 2]| (x - 256.0).hypot(y - 256.0) > 80.0;
    let dots = dots.filter(away).map(|place| Stroke::ellipse(place, [9.0, 9.0], 0.0));
    let (_, marks) =
        grown([Stroke::ellipse([256.0, 256.0], [40.0, 40.0], 0.0)].into_iter().chain(dots).collect());
    assert_there(&marks, 33, 0.2, 0.2, 0.12);
}

#[test]
fn a_result_without_marks_or_without_ground_is_an_error() {
    let document = free(vec![Stroke::ellipse([256.0, 256.0], [20_000.0, 20_000.0], 0.0)]);
    match Growth::begin(&document, &Options::default(), None).run() {
        Err(GrowError::Document(_)) => {}
        Err(GrowError::Layer { layer: 1, reason, .. }) if matches!(*reason, LayerError::Blank { .. }) => {}
        Err(other) => panic!("{other}"),
        Ok(_) => panic!("a mark forty times as large as the canvas cannot be grown"),
    }
}

#[test]
fn a_narrow_spot_across_the_others_does_not_split() {
    let marks = [
        [45.0, 50.0, 5.0],
        [120.0, 40.0, -8.0],
        [195.0, 60.0, 3.0],
        [60.0, 190.0, -4.0],
        [180.0, 195.0, 8.0],
        [120.0, 115.0, 90.0],
    ];
    let document = Document {
        size: [240, 240],
        ..free(marks.map(|[x, y, t]| Stroke::ellipse([x, y], [16.0, 3.0], t)).into())
    };
    let grown = Growth::begin(&document, &Options::default(), None).run().unwrap();
    let drawn = report(&document, "free", &grown, 0.0).layers.remove(0).drawn;
    assert_there(&drawn, 6, 0.2, 0.1, 0.12);
    // Its two halves had grown above and below it.
    let near = |spot: &&Spot| (spot.ellipse.center[0] - 120.0).abs() < 30.0;
    let spots = grown.layers[0].marks().expect("marks").measured.spots();
    assert_eq!(spots.iter().filter(|spot| spot.whole).filter(near).count(), 2, "{spots:?}");
}

/// The spots between these marks, which differ much in size and direction, grow together at first.
#[test]
fn spots_that_grew_together_are_separated() {
    let marks = [
        [175.0, 250.0, 30.3, 13.7, 89.0],
        [222.0, 216.0, 10.8, 4.1, 109.0],
        [259.0, 178.0, 11.4, 4.1, 143.0],
        [302.0, 144.0, 9.6, 3.7, 2.0],
        [215.0, 292.0, 27.5, 12.2, 54.0],
        [256.0, 255.0, 13.7, 5.4, 59.0],
        [292.0, 220.0, 14.0, 5.7, 126.0],
        [337.0, 188.0, 10.7, 4.2, 42.0],
        [286.0, 293.0, 13.0, 4.8, 18.0],
        [327.0, 261.0, 20.2, 8.2, 140.0],
        [368.0, 229.0, 31.3, 12.3, 84.0],
        [283.0, 374.0, 10.7, 4.4, 2.0],
        [321.0, 338.0, 20.6, 8.1, 167.0],
        [362.0, 301.0, 7.1, 2.7, 143.0],
        [403.0, 268.0, 9.2, 3.8, 103.0],
    ];
    let document = Document {
        seed: 180,
        ..free(marks.map(|[x, y, a, b, t]| Stroke::ellipse([x, y], [a, b], t)).into())
    };
    assert_eq!(merged(&document), 0);
}

#[test]
fn marks_drawn_over_each_other_do_not_make_the_others_grow_together() {
    let place = |k: usize| {
        [110.0 + 140.0 * (k / 2 % 3) as f64 + 12.0 * (k % 2) as f64, 110.0 + 140.0 * (k / 6) as f64]
    };
    let document = free((0..18).map(|k| Stroke::ellipse(place(k), [20.0, 19.0], 30.0)).collect());
    assert_eq!(merged(&document), 0);
}

/// The number of grown marks that are two in one.
fn merged(document: &Document) -> usize {
    let grown = Growth::begin(document, &Options::default(), None).run().unwrap();
    report(document, "free", &grown, 0.0).layers[0].regions[0].merged.unwrap()
}

#[test]
fn a_drawn_spot_takes_the_place_of_one_that_was_not_drawn() {
    let drawn = [
        (270.8, 357.0, 21.3, 18.1, 85.0),
        (274.3, 441.5, 9.1, 8.6, 77.0),
        (230.9, 430.1, 9.1, 8.4, 83.0),
        (500.9, 402.2, 21.0, 18.7, 80.0),
        (21.8, 380.7, 9.0, 9.0, 79.0),
        (223.2, 498.3, 20.4, 20.4, 82.0),
        (175.6, 263.2, 21.0, 19.8, 84.0),
        (351.0, 380.0, 18.7, 18.6, 87.0),
        (320.8, 184.4, 10.1, 8.9, 78.0),
        (31.2, 2.8, 9.0, 8.4, 88.0),
        (209.6, 152.4, 9.7, 9.7, 77.0),
        (297.9, 130.3, 20.2, 20.2, 84.0),
        (304.0, 280.0, 9.1, 9.1, 78.0),
        (270.5, 447.3, 8.8, 8.8, 90.0),
        (360.7, 93.1, 9.8, 8.9, 89.0),
        (278.4, 88.6, 9.3, 8.9, 83.0),
        (221.4, 120.0, 8.6, 8.6, 87.0),
    ];
    assert_eq!(missing(86, &drawn), [(13, "closer to another drawn mark than such spots can be")]);
}

#[test]
fn a_drawn_spot_that_dies_beside_another_one_grows_when_both_start_together() {
    let drawn = [
        (472.4, 321.6, 10.5, 9.9, 46.0),
        (9.0, 429.1, 12.2, 8.9, 53.0),
        (269.0, 385.7, 11.2, 8.4, 179.0),
        (36.7, 317.1, 11.9, 9.5, 127.0),
        (153.3, 343.4, 12.6, 8.5, 120.0),
        (97.4, 291.8, 12.6, 9.5, 78.0),
        (145.1, 232.0, 12.0, 8.9, 90.0),
        (389.4, 433.2, 11.6, 9.6, 90.0),
        (130.5, 154.4, 11.9, 8.8, 157.0),
        (369.0, 490.9, 10.8, 10.0, 163.0),
        (397.7, 90.1, 11.9, 9.5, 136.0),
        (20.2, 292.7, 12.5, 8.8, 52.0),
        (329.7, 174.4, 12.0, 8.9, 107.0),
        (328.2, 34.6, 11.7, 9.0, 68.0),
        (116.2, 475.7, 11.9, 8.8, 49.0),
        (196.4, 93.5, 11.7, 9.4, 57.0),
        (469.0, 324.6, 10.9, 8.6, 42.0),
        (380.6, 316.9, 11.1, 9.3, 10.0),
        (99.4, 89.4, 12.3, 9.7, 161.0),
        (45.6, 133.8, 10.7, 9.3, 93.0),
        (210.9, 198.8, 11.3, 9.1, 69.0),
        (316.1, 356.5, 12.5, 9.7, 141.0),
        (310.5, 56.0, 12.7, 8.6, 138.0),
        (253.6, 426.9, 12.5, 8.4, 122.0),
    ];
    assert_eq!(missing(9, &drawn), [(16, "closer to another drawn mark than such spots can be")]);
}

/// The drawn ellipses (centre, radii, angle) that do not grow from `seed`, and why.
fn missing(seed: u64, drawn: &[(f64, f64, f64, f64, f64)]) -> Vec<(usize, &'static str)> {
    let ellipse = |&(x, y, a, b, angle): &(f64, f64, f64, f64, f64)| Stroke::ellipse([x, y], [a, b], angle);
    let document = Document { seed, ..free(drawn.iter().map(ellipse).collect()) };
    let grown = Growth::begin(&document, &Options::default(), None).run().unwrap();
    let marks = report(&document, "missing", &grown, 0.0).layers.remove(0).drawn;
    marks.iter().filter_map(|mark| Some((mark.mark, mark.reason?))).collect()
}
