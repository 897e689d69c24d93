use super::*;
use crate::attributes::Stripes;
use crate::marks::{Line, turn};

const SIZE: [f64; 2] = [512.0, 512.0];

fn ellipse(center: [f64; 2], area: f64, aspect: f64, angle: f64) -> Mark {
    Mark::Ellipse(Ellipse::from_area(center, area, aspect, angle))
}

fn line(from: [f64; 2], to: [f64; 2], width: f64) -> Mark {
    Mark::Line(Line { from, to, width })
}

fn map(marks: &[Mark]) -> FreeMap {
    FreeMap::from_marks(marks, SIZE, Edges::Closed).expect("marks of one kind")
}

fn spots(attributes: Attributes) -> Spots {
    match attributes {
        Attributes::Spots(spots) => spots,
        Attributes::Stripes(_) => panic!("ellipses were drawn"),
    }
}

fn stripes(attributes: Attributes) -> Stripes {
    match attributes {
        Attributes::Stripes(stripes) => stripes,
        Attributes::Spots(_) => panic!("lines were drawn"),
    }
}

/// `count` ellipses on a circle about the centre of the canvas, along it.
fn ring(count: usize, radius: f64) -> Vec<Mark> {
    let at = |i: usize| {
        let (s, c) = libm::sincos(std::f64::consts::TAU * i as f64 / count as f64);
        let angle = 360.0 * i as f64 / count as f64 + 90.0;
        ellipse([256.0 + radius * c, 256.0 + radius * s], 400.0, 0.45, angle)
    };
    (0..count).map(at).collect()
}

#[test]
fn a_ring_of_ellipses_keeps_their_direction_and_the_field_between_them_follows_it() {
    let map = map(&ring(12, 120.0));
    for i in 0..72 {
        let (s, c) = libm::sincos(std::f64::consts::TAU * f64::from(i) / 72.0);
        let there = spots(map.at([256.0 + 120.0 * c, 256.0 + 120.0 * s]));
        assert!(turn(there.angle, 5.0 * f64::from(i) + 90.0).abs() < 3.0, "{i}: {there:?}");
        assert!((there.aspect - 0.45).abs() < 1e-9 && (there.area - 400.0).abs() < 1e-6, "{there:?}");
    }
}

#[test]
fn one_ellipse_is_wanted_everywhere_with_a_free_spacing() {
    let mut map = map(&[ellipse([100.0, 60.0], 500.0, 0.4, 30.0)]);
    let there = spots(map.at([500.0, 500.0]));
    assert!((there.area - 500.0).abs() < 1e-9 && (there.angle - 30.0).abs() < 1e-6, "{there:?}");
    assert_eq!((there.spacing, map.nodes().len()), (None, 1));
    map.fill_free_spacing(|spots| 2.0 * spots.area.sqrt());
    let spacing = spots(map.at([500.0, 500.0])).spacing.expect("filled");
    assert!((spacing - 2.0 * 500f64.sqrt()).abs() < 1e-9);
    assert_eq!(spots(map.own(0)).spacing, spots(map.mean()).spacing);
}

#[test]
fn a_blob_among_dots_does_not_change_the_field_between_the_dots() {
    let dot =
        |i: usize| ellipse([60.0 + 80.0 * (i % 5) as f64, 60.0 + 80.0 * (i / 5) as f64], 300.0, 0.7, 30.0);
    let mut marks: Vec<Mark> = (0..25).map(dot).collect();
    marks[12] = ellipse(marks[12].center(), 9000.0, 0.9, 120.0);
    let map = map(&marks);
    for i in 0..100 {
        let there = spots(map.at([26.0 + 51.0 * f64::from(i % 10), 26.0 + 51.0 * f64::from(i / 10)]));
        assert!((there.area / 300.0 - 1.0).abs() < 0.03, "{there:?}");
        assert!(turn(there.angle, 30.0).abs() < 2.0 && (there.aspect - 0.7).abs() < 0.02, "{there:?}");
    }
    assert!((spots(map.own(12)).area - 9000.0).abs() < 1e-6);
    assert!(map.spread().area < 0.05, "{:?}", map.spread());
}

#[test]
fn a_chevron_keeps_the_direction_of_its_two_strokes() {
    let map = map(&[line([100.0, 200.0], [250.0, 290.0], 10.0), line([262.0, 290.0], [412.0, 200.0], 10.0)]);
    for t in [0.1, 0.4, 0.7] {
        let [left, right] = [[100.0 + 150.0 * t, 200.0 + 90.0 * t], [412.0 - 150.0 * t, 200.0 + 90.0 * t]];
        let angle = 0.6f64.atan().to_degrees();
        assert!(turn(stripes(map.at(left)).angle, angle).abs() < 4.0, "{:?}", map.at(left));
        assert!(turn(stripes(map.at(right)).angle, -angle).abs() < 4.0, "{:?}", map.at(right));
    }
}

#[test]
fn the_distance_of_lines_side_by_side_is_the_period_wanted_and_a_line_alone_has_twice_its_width() {
    let beside: Vec<Mark> = (0..5)
        .map(|i| line([100.0, 100.0 + 24.0 * f64::from(i)], [300.0, 110.0 + 24.0 * f64::from(i)], 8.0))
        .collect();
    let there = stripes(map(&beside).at([200.0, 150.0]));
    assert!((there.wavelength.expect("always") / 23.97 - 1.0).abs() < 0.01, "{there:?}");
    let alone = stripes(map(&beside[..1]).at([200.0, 150.0]));
    assert!((alone.wavelength.expect("always") - 16.0).abs() < 1e-9 && (alone.width - 8.0).abs() < 1e-9);
    let even = stripes(map(&beside).with_duty(0.4).at([200.0, 150.0]));
    assert!((even.wavelength.expect("always") - 20.0).abs() < 1e-9, "{even:?}");
}

#[test]
fn no_marks_mixed_marks_and_a_canvas_without_extent_are_errors() {
    let of = |marks: &[Mark], size| FreeMap::from_marks(marks, size, Edges::Wrap).expect_err("not a map");
    let marks = [ellipse([9.0, 9.0], 20.0, 0.5, 0.0), line([1.0, 1.0], [9.0, 1.0], 2.0)];
    assert_eq!(of(&[], SIZE), RegionsError::NoMarks);
    assert_eq!(of(&marks, SIZE), RegionsError::Mixed { ellipses: 1, lines: 1 });
    assert_eq!(of(&marks, [0.0, 9.0]), RegionsError::Layout { size: [0.0, 9.0], grid: [1, 1] });
}

#[test]
fn a_larger_canvas_stretches_the_places_and_keeps_the_sizes() {
    let map = map(&ring(12, 120.0));
    let larger = map.resized([1024.0, 512.0]);
    assert_eq!(larger.at([600.0, 100.0]), map.at([300.0, 100.0]));
    assert_eq!(larger.nodes().size, [1024.0, 512.0]);
}
