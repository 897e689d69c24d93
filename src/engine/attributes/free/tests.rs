mod accuracy;
mod continuity;
mod sketches;
mod strokes;

use super::*;
use crate::attributes::Stripes;
use crate::marks::turn;
use sketches::{SIDE, ellipse, line, polar, random_ellipses, ring};

const SIZE: [f64; 2] = [SIDE, SIDE];

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

#[test]
fn ellipses_in_a_ring_or_in_rays_keep_their_direction_and_the_field_between_them_follows_it() {
    let rings: Vec<Mark> = [ring(7, 60.0, 90.0), ring(16, 150.0, 90.0)].concat();
    let rays: Vec<Mark> = [ring(6, 60.0, 0.0), ring(10, 120.0, 0.0), ring(14, 190.0, 0.0)].concat();
    for (marks, radius, turned) in
        [(ring(12, 120.0, 90.0), 120.0, 90.0), (rings, 150.0, 90.0), (rays, 120.0, 0.0)]
    {
        let map = map(&marks);
        for i in 0..72 {
            let there = spots(map.at(polar(radius, 5.0 * f64::from(i))));
            assert!(turn(there.angle, 5.0 * f64::from(i) + turned).abs() < 6.0, "{i}: {there:?}");
            assert!((there.aspect - 0.45).abs() < 1e-9 && (there.area - 400.0).abs() < 1e-6, "{there:?}");
        }
        for ellipse in marks.iter().filter_map(Mark::ellipse) {
            let there = spots(map.at(ellipse.center));
            assert!(turn(there.angle, ellipse.major_angle()).abs() < 4.0, "{ellipse:?}: {there:?}");
        }
        assert!(map.spread().angle < 4.0, "{:?}", map.spread());
    }
}

#[test]
fn a_ring_and_rows_have_the_spacing_from_one_to_the_next() {
    let spacing = |marks: &[Mark], at| spots(map(marks).at(at)).spacing.expect("more than one");
    let apart = 2.0 * 120.0 * libm::sin(std::f64::consts::PI / 12.0);
    assert!((spacing(&ring(12, 120.0, 90.0), [256.0, 136.0]) / apart - 1.0).abs() < 0.01);
    let rows: Vec<Mark> = (0..20)
        .map(|i| {
            ellipse([80.0 + 30.0 * f64::from(i % 10), 200.0 + 100.0 * f64::from(i / 10)], 200.0, 0.8, 0.0)
        })
        .collect();
    assert!((28.0..40.0).contains(&spacing(&rows, [200.0, 200.0])));
    // Two clusters, one twice as dense as the other, keep their own.
    let cluster = |x: f64, step: f64| {
        (0..9).map(move |i| {
            ellipse([x + step * f64::from(i % 3), 230.0 + step * f64::from(i / 3)], 60.0, 0.9, 0.0)
        })
    };
    let marks: Vec<Mark> = cluster(60.0, 20.0).chain(cluster(380.0, 40.0)).collect();
    assert!((spacing(&marks, [80.0, 250.0]) / 21.0 - 1.0).abs() < 0.12, "{}", spacing(&marks, [80.0, 250.0]));
    assert!(
        (spacing(&marks, [420.0, 270.0]) / 42.0 - 1.0).abs() < 0.12,
        "{}",
        spacing(&marks, [420.0, 270.0])
    );
}

#[test]
fn from_one_to_seven_ellipses_and_ellipses_in_a_row_are_defined_and_stay_within_the_range_of_what_was_drawn()
{
    let row = |count: usize| {
        (0..count)
            .map(|i| {
                ellipse(
                    [60.0 + 60.0 * i as f64, 256.0],
                    100.0 + 80.0 * i as f64,
                    0.9 - 0.1 * i as f64,
                    20.0 * i as f64,
                )
            })
            .collect::<Vec<_>>()
    };
    let mut sketches: Vec<Vec<Mark>> = (1..=7).map(row).collect();
    sketches.extend((0..24).map(random_ellipses));
    sketches.push(vec![ellipse([100.0, 100.0], 50.0, 1.0, 0.0); 3]);
    for (index, marks) in sketches.iter().enumerate() {
        let edges = if index % 3 == 0 { Edges::Wrap } else { Edges::Closed };
        let map = FreeMap::from_marks(marks, SIZE, edges).expect("ellipses");
        let drawn: Vec<Ellipse> = marks.iter().filter_map(Mark::ellipse).collect();
        let range = |value: &dyn Fn(&Ellipse) -> f64| {
            let values = || drawn.iter().map(value);
            (1.0 - 1e-9) * values().fold(f64::INFINITY, f64::min)
                ..=(1.0 + 1e-9) * values().fold(0.0, f64::max)
        };
        let (areas, aspects) = (range(&Ellipse::area), range(&Ellipse::aspect));
        for i in 0..17 * 17 {
            let there = spots(map.at([32.0 * f64::from(i % 17), 32.0 * f64::from(i / 17)]));
            assert!(areas.contains(&there.area) && aspects.contains(&there.aspect), "{index}: {there:?}");
            assert!((0.0..180.0).contains(&there.angle), "{index}: {there:?}");
            assert!(
                there.spacing.is_none_or(|spacing| (1.0..=725.0).contains(&spacing)),
                "{index}: {there:?}"
            );
        }
    }
}

#[test]
fn along_a_row_sizes_and_directions_follow_it_and_beside_it_they_stay() {
    let mark =
        |i: usize| ellipse([60.0 + 65.0 * i as f64, 256.0], 100.0 + 60.0 * i as f64, 0.5, 12.0 * i as f64);
    let map = map(&(0..7).map(mark).collect::<Vec<_>>());
    for i in 0..7 {
        let there = spots(map.at(mark(i).center()));
        let beside = spots(map.at([mark(i).center()[0], 340.0]));
        let (area, angle) = (100.0 + 60.0 * i as f64, 12.0 * i as f64);
        assert!(
            (there.area / area - 1.0).abs() < 0.3 && turn(there.angle, angle).abs() < 9.0,
            "{i}: {there:?}"
        );
        assert!(
            (beside.area / area - 1.0).abs() < 0.35 && turn(beside.angle, angle).abs() < 14.0,
            "{i}: {beside:?}"
        );
    }
}

#[test]
fn two_ellipses_share_the_canvas_between_them() {
    let marks = [ellipse([120.0, 256.0], 300.0, 0.4, 10.0), ellipse([400.0, 256.0], 1200.0, 0.8, 50.0)];
    let map = map(&marks);
    let area = |x: f64| spots(map.at([x, 200.0])).area;
    assert!(
        area(120.0) < 420.0 && area(400.0) > 860.0 && (450.0..800.0).contains(&area(260.0)),
        "{} {} {}",
        area(120.0),
        area(260.0),
        area(400.0)
    );
    assert!((spots(map.at([260.0, 256.0])).spacing.expect("two") - 280.0).abs() < 1e-6);
    assert_eq!(map.spread(), Spread::ZERO);
}

#[test]
fn a_tile_may_be_cut_anywhere() {
    let marks = random_ellipses(6);
    let by = [200.0, 130.0];
    let moved: Vec<Mark> = marks.iter().map(|mark| mark.shifted(by)).collect();
    let [a, b] =
        [&marks, &moved].map(|marks| FreeMap::from_marks(marks, SIZE, Edges::Wrap).expect("ellipses"));
    for i in 0..100 {
        let node = |k: i32| 8.0 * (f64::from(7 * k % 64) + 0.5);
        let point = [node(i), node(i / 10 + 3)];
        let [here, there] =
            [a.at(point), b.at([point[0] + by[0], point[1] + by[1]].map(|x| x.rem_euclid(SIDE)))];
        let (here, there) = (spots(here), spots(there));
        assert!((here.area / there.area - 1.0).abs() < 0.02, "{here:?} {there:?}");
        assert!((here.aspect - there.aspect).abs() < 0.01, "{here:?} {there:?}");
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
fn no_marks_mixed_marks_and_a_canvas_without_extent_are_errors() {
    let of = |marks: &[Mark], size| FreeMap::from_marks(marks, size, Edges::Wrap).expect_err("not a map");
    let marks = [ellipse([9.0, 9.0], 20.0, 0.5, 0.0), line([1.0, 1.0], [9.0, 1.0], 2.0)];
    assert_eq!(of(&[], SIZE), RegionsError::NoMarks);
    assert_eq!(of(&marks, SIZE), RegionsError::Mixed { ellipses: 1, lines: 1 });
    assert_eq!(of(&marks, [0.0, 9.0]), RegionsError::Layout { size: [0.0, 9.0], grid: [1, 1] });
}

#[test]
fn a_larger_canvas_stretches_the_places_and_keeps_the_sizes() {
    let map = map(&ring(12, 120.0, 90.0));
    let larger = map.resized([1024.0, 512.0]);
    assert_eq!(larger.at([600.0, 100.0]), map.at([300.0, 100.0]));
    assert_eq!(larger.nodes().size, [1024.0, 512.0]);
}
