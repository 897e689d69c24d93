use proptest::prelude::*;

use super::*;
use crate::marks::{Line, turn};

fn spot(center: [f64; 2], area: f64, aspect: f64, angle: f64) -> Mark {
    Mark::Ellipse(Ellipse::from_area(center, area, aspect, angle))
}

fn map(marks: &[Mark], grid: [usize; 2], edges: Edges) -> RegionMap {
    RegionMap::from_marks(marks, [grid[0] as f64 * 100.0, grid[1] as f64 * 100.0], grid, edges).unwrap()
}

fn spots_at(map: &RegionMap, point: [f64; 2]) -> Spots {
    match map.at(point) {
        Attributes::Spots(spots) => spots,
        Attributes::Stripes(_) => panic!("a map of spots"),
    }
}

#[test]
fn a_mark_belongs_to_the_region_of_its_centre_and_a_line_to_that_of_its_midpoint() {
    let marks = [spot([100.0, 10.0], 50.0, 0.5, 0.0), spot([99.0, 10.0], 70.0, 0.5, 0.0)];
    let map_of_spots = map(&marks, [2, 1], Edges::Closed);
    let areas: Vec<_> = map_of_spots.regions().map(|(place, region)| (place, region.marks)).collect();
    assert_eq!(areas, [([0, 0], 1), ([1, 0], 1)]);
    assert!((spots_at(&map_of_spots, [150.0, 50.0]).area - 50.0).abs() < 1e-9);
    let line = Mark::Line(Line { from: [10.0, 10.0], to: [196.0, 60.0], width: 6.0 });
    let map_of_lines = map(&[line], [2, 1], Edges::Closed);
    assert_eq!(map_of_lines.region([1, 0]).marks, 1);
    assert_eq!(map_of_lines.region([0, 0]).own, None);
    assert_eq!(map_of_lines.region([0, 0]).filled, map_of_lines.region([1, 0]).filled);
}

#[test]
fn values_are_bilinear_between_region_centres_and_clamped_beyond() {
    let marks = [
        spot([50.0, 50.0], 100.0, 0.4, 0.0),
        spot([150.0, 50.0], 200.0, 0.8, 0.0),
        spot([50.0, 150.0], 300.0, 0.4, 0.0),
        spot([150.0, 150.0], 800.0, 0.4, 0.0),
    ];
    let map = map(&marks, [2, 2], Edges::Closed);
    let area = |point| spots_at(&map, point).area;
    assert!((area([100.0, 100.0]) - 350.0).abs() < 1e-9);
    assert!((area([75.0, 50.0]) - 125.0).abs() < 1e-9);
    assert!((area([75.0, 0.0]) - 125.0).abs() < 1e-9);
    assert!((area([200.0, 200.0]) - 800.0).abs() < 1e-9);
    assert!((spots_at(&map, [100.0, 50.0]).aspect - 0.6).abs() < 1e-12);
}

#[test]
fn on_a_tile_the_border_lies_half_way_between_the_outer_centres() {
    let marks = [
        spot([50.0, 50.0], 100.0, 0.5, 0.0),
        spot([150.0, 50.0], 200.0, 0.5, 0.0),
        spot([250.0, 50.0], 400.0, 0.5, 0.0),
    ];
    let map = map(&marks, [3, 1], Edges::Wrap);
    for x in [0.0, 300.0, -300.0] {
        assert!((spots_at(&map, [x, 99.0]).area - 250.0).abs() < 1e-9);
    }
    assert!((spots_at(&map, [275.0, 0.0]).area - 325.0).abs() < 1e-9);
}

#[test]
fn angles_go_the_short_way_round() {
    let marks = [spot([50.0, 50.0], 100.0, 0.5, 170.0), spot([150.0, 50.0], 100.0, 0.5, 30.0)];
    let map = map(&marks, [2, 1], Edges::Closed);
    assert!(turn(spots_at(&map, [100.0, 50.0]).angle, 10.0).abs() < 1e-9);
    // The vector is interpolated, not the angle: half of atan2(0.75·sin −20° + …) at a quarter.
    let [c, s] = [340.0f64, 60.0]
        .map(f64::to_radians)
        .map(|a| [a.cos(), a.sin()])
        .into_iter()
        .zip([0.75, 0.25])
        .fold([0.0; 2], |[c, s], (v, w)| [c + w * v[0], s + w * v[1]]);
    let want = 0.5 * s.atan2(c).to_degrees();
    assert!(turn(spots_at(&map, [75.0, 50.0]).angle, want).abs() < 1e-9);
}

#[test]
fn cancelling_angles_fall_back_to_the_nearest_region() {
    let marks = [spot([50.0, 50.0], 100.0, 0.5, 20.0), spot([150.0, 50.0], 100.0, 0.5, 110.0)];
    let map = map(&marks, [2, 1], Edges::Closed);
    assert!((spots_at(&map, [100.0, 50.0]).angle - 20.0).abs() < 1e-9);
    assert!((spots_at(&map, [100.001, 50.0]).angle - 110.0).abs() < 1e-6);
}

#[test]
fn an_empty_region_takes_the_attributes_of_the_nearest_across_the_border_of_a_tile() {
    let marks = [spot([250.0, 50.0], 100.0, 0.5, 20.0), spot([450.0, 50.0], 300.0, 0.5, 20.0)];
    let areas = |edges| {
        map(&marks, [5, 1], edges)
            .regions()
            .map(|(_, region)| match region.filled {
                Attributes::Spots(spots) => spots.area.round(),
                Attributes::Stripes(_) => 0.0,
            })
            .collect::<Vec<_>>()
    };
    assert_eq!(areas(Edges::Closed), [100.0, 100.0, 100.0, 100.0, 300.0]);
    assert_eq!(areas(Edges::Wrap), [300.0, 100.0, 100.0, 100.0, 300.0]);
}

#[test]
fn a_round_region_takes_the_direction_of_the_nearest_that_has_one() {
    let marks = [
        spot([50.0, 50.0], 100.0, 0.5, 20.0),
        spot([150.0, 50.0], 100.0, 0.95, 80.0),
        spot([250.0, 50.0], 100.0, 0.9, 140.0),
        spot([350.0, 50.0], 100.0, 0.91, 80.0),
    ];
    let map = map(&marks, [4, 1], Edges::Closed);
    let angles: Vec<_> =
        (0..4).map(|i| spots_at(&map, [50.0 + 100.0 * f64::from(i), 50.0]).angle.round()).collect();
    assert_eq!(angles, [20.0, 20.0, 140.0, 140.0]);
    // Only the map turns it: the region keeps what was drawn.
    assert!((map.region([1, 0]).filled.angle() - 80.0).abs() < 1e-9);
    let round = RegionMap::from_marks(&marks[1..2], [100.0; 2], [1, 1], Edges::Closed).unwrap();
    assert_eq!(round.at([3.0, 3.0]).angle(), 0.0);
}

#[test]
fn a_free_spacing_stays_free_until_it_is_filled() {
    let marks = [spot([50.0, 50.0], 100.0, 0.95, 20.0), spot([150.0, 50.0], 400.0, 0.5, 30.0)];
    let mut map = map(&marks, [2, 1], Edges::Closed);
    assert_eq!(spots_at(&map, [70.0, 50.0]).spacing, None);
    let mut asked = Vec::new();
    map.fill_free_spacing(|spots| {
        asked.push((spots.area.round(), spots.angle.round()));
        3.0 * spots.area.sqrt()
    });
    assert_eq!(asked, [(100.0, 30.0), (400.0, 30.0)]);
    assert!((spots_at(&map, [100.0, 50.0]).spacing.unwrap() - 45.0).abs() < 1e-9);
    assert!((spots_at(&map, [50.0, 50.0]).spacing.unwrap() - 30.0).abs() < 1e-9);
    map.fill_free_spacing(|_| panic!("none is free any more"));
}

#[test]
fn a_resized_map_is_stretched_and_keeps_its_lengths() {
    let marks = [spot([50.0, 50.0], 100.0, 0.5, 20.0), spot([150.0, 50.0], 300.0, 0.5, 20.0)];
    let large = map(&marks, [2, 1], Edges::Closed).resized([2000.0, 300.0]);
    assert!((spots_at(&large, [500.0, 0.0]).area - 100.0).abs() < 1e-9);
    assert!((spots_at(&large, [1000.0, 299.0]).area - 200.0).abs() < 1e-9);
}

#[test]
fn marks_that_make_no_map_are_refused_with_the_reason() {
    let line = Mark::Line(Line { from: [0.0; 2], to: [9.0; 2], width: 2.0 });
    let ellipse = spot([5.0; 2], 9.0, 1.0, 0.0);
    let of =
        |marks: &[Mark], size, grid| RegionMap::from_marks(marks, size, grid, Edges::Closed).unwrap_err();
    assert_eq!(of(&[], [10.0; 2], [1, 1]), RegionsError::NoMarks);
    assert_eq!(
        of(&[line.clone(), ellipse, line.clone()], [10.0; 2], [1, 1]),
        RegionsError::Mixed { ellipses: 1, lines: 2 }
    );
    for (size, grid) in [([0.0, 5.0], [1, 1]), ([f64::NAN, 5.0], [1, 1]), ([5.0; 2], [1, 0])] {
        assert!(matches!(of(std::slice::from_ref(&line), size, grid), RegionsError::Layout { .. }));
    }
}

/// Some marks anywhere on a canvas of 300 × 200 px, a layout and edges.
fn maps() -> impl Strategy<Value = RegionMap> {
    let mark = (0.0..300.0f64, 0.0..200.0f64, 40.0..1500.0f64, 0.2..1.0f64, 0.0..180.0f64)
        .prop_map(|(x, y, area, aspect, angle)| spot([x, y], area, aspect, angle));
    (prop::collection::vec(mark, 1..30), 1usize..5, 1usize..5, any::<bool>()).prop_map(
        |(marks, columns, rows, wrap)| {
            let edges = if wrap { Edges::Wrap } else { Edges::Closed };
            let mut map = RegionMap::from_marks(&marks, [300.0, 200.0], [columns, rows], edges).unwrap();
            map.fill_free_spacing(|spots| 2.0 * spots.area.sqrt());
            map
        },
    )
}

/// Values and double-angle vector as one list.
fn numbers(map: &RegionMap, point: [f64; 2]) -> [f64; 5] {
    let spots = spots_at(map, point);
    let [c, s] = map.double_angle_at(point);
    [spots.area, spots.aspect, spots.spacing.unwrap(), c, s]
}

proptest! {
    #[test]
    fn at_a_region_s_centre_the_map_has_the_region_s_attributes(map in maps()) {
        for (place, region) in map.regions() {
            let (got, Attributes::Spots(want)) = (spots_at(&map, map.layout().center(place)), region.filled) else {
                panic!("a map of spots");
            };
            prop_assert!((got.area / want.area - 1.0).abs() < 1e-9);
            prop_assert!((got.aspect - want.aspect).abs() < 1e-9);
            prop_assert!((got.spacing.unwrap() / want.spacing.unwrap() - 1.0).abs() < 1e-9);
            if want.aspect <= 0.9 {
                prop_assert!(turn(got.angle, want.angle).abs() < 1e-6);
            }
        }
    }

    #[test]
    fn the_map_stays_within_the_range_of_its_regions_and_both_forms_of_the_angle_agree(
        map in maps(), x in -400.0..700.0f64, y in -300.0..500.0f64,
    ) {
        let got = spots_at(&map, [x, y]);
        let corners = map.layout().corners([x, y]);
        prop_assert!((corners.iter().map(|corner| corner.1).sum::<f64>() - 1.0).abs() < 1e-12);
        let areas = corners.map(|(i, _)| map.spots_of(i).area);
        let (low, high) = areas.iter().fold((f64::INFINITY, 0.0f64), |(l, h), &a| (l.min(a), h.max(a)));
        prop_assert!((low - 1e-9..=high + 1e-9).contains(&got.area));
        let [c, s] = map.double_angle_at([x, y]);
        prop_assert!((c * c + s * s - 1.0).abs() < 1e-12);
        prop_assert!(turn(got.angle, 0.5 * s.atan2(c).to_degrees()).abs() < 1e-9);
        prop_assert!((0.0..180.0).contains(&got.angle));
    }

    #[test]
    fn a_tile_s_map_is_periodic_and_every_map_is_continuous(
        map in maps(), x in 0.0..300.0f64, y in 0.0..200.0f64,
    ) {
        if map.layout().edges == Edges::Wrap {
            for [dx, dy] in [[300.0, 0.0], [0.0, -200.0], [-600.0, 400.0]] {
                let (here, there) = (spots_at(&map, [x, y]), spots_at(&map, [x + dx, y + dy]));
                prop_assert!((here.area - there.area).abs() < 1e-6 && (here.aspect - there.aspect).abs() < 1e-9);
            }
        }
        // Across the border and elsewhere: a millionth of a px changes next to nothing.
        for [x, y] in [[x, 0.0], [0.0, y], [300.0, y], [x, 200.0], [x, y]] {
            let (before, after) = (numbers(&map, [x - 5e-7, y - 5e-7]), numbers(&map, [x + 5e-7, y + 5e-7]));
            for i in 0..3 {
                prop_assert!((before[i] - after[i]).abs() <= 1e-4, "{before:?} {after:?}");
            }
        }
    }

    #[test]
    fn the_map_of_equal_regions_is_constant(
        area in 40.0..1500.0f64, aspect in 0.2..1.0f64, angle in 0.0..180.0f64,
        columns in 1usize..5, rows in 1usize..5, x in -10.0..310.0f64, y in -10.0..210.0f64, wrap: bool,
    ) {
        let edges = if wrap { Edges::Wrap } else { Edges::Closed };
        let layout = RegionGrid { size: [300.0, 200.0], grid: [columns, rows], edges };
        let marks: Vec<_> =
            (0..layout.len()).map(|i| spot(layout.center(layout.place(i)), area, aspect, angle)).collect();
        let map = RegionMap::from_marks(&marks, layout.size, layout.grid, edges).unwrap();
        let got = spots_at(&map, [x, y]);
        prop_assert!((got.area / area - 1.0).abs() < 1e-12 && (got.aspect - aspect).abs() < 1e-12);
        prop_assert!(aspect > 0.9 || turn(got.angle, angle).abs() < 1e-9);
    }
}

/// Six ellipses in a row from x on, whose areas alternate between 80 and 120 px², turned by ± 10°.
fn six(x: f64) -> Vec<Mark> {
    let sign = |k: u8| if k.is_multiple_of(2) { -1.0 } else { 1.0 };
    (0..6)
        .map(|k| spot([x + 10.0 * f64::from(k), 50.0], 100.0 + 20.0 * sign(k), 0.5, 30.0 + 10.0 * sign(k)))
        .collect()
}

#[test]
fn a_region_of_six_marks_varies_as_they_do_and_one_of_fewer_does_not() {
    let six = six(10.0);
    let spread = map(&six, [1, 1], Edges::Closed).region([0, 0]).spread;
    assert!((spread.area - 0.2).abs() < 1e-9 && (spread.angle - 10.0).abs() < 1e-9, "{spread:?}");
    assert!(spread.aspect < 1e-9 && spread.spacing < 1e-9, "{spread:?}");
    let five = map(&six[..5], [1, 1], Edges::Closed);
    assert_eq!(five.region([0, 0]).spread, Spread::ZERO);
}

#[test]
fn an_empty_region_takes_the_spread_with_the_attributes_and_between_regions_it_is_blended() {
    let mut marks = six(10.0);
    marks.push(spot([150.0, 50.0], 100.0, 0.5, 30.0));
    let map = map(&marks, [3, 1], Edges::Closed);
    assert_eq!(map.region([2, 0]).spread, Spread::ZERO);
    assert!((map.spread_at([100.0, 0.0]).area - 0.1).abs() < 1e-9);
    assert!((map.spread_at([0.0, 50.0]).area - 0.2).abs() < 1e-9);
    let alone = RegionMap::from_marks(&six(10.0), [200.0, 100.0], [2, 1], Edges::Closed).unwrap();
    assert_eq!(alone.region([1, 0]).spread, alone.region([0, 0]).spread);
}

#[test]
fn a_given_spread_holds_everywhere() {
    let given = Spread { area: 0.3, ..Spread::ZERO };
    let map = map(&six(10.0), [2, 1], Edges::Closed).with_spread(given);
    assert!(map.regions().all(|(_, region)| region.spread == given) && map.spread_is_given());
    assert!(map.resized([50.0, 50.0]).spread_is_given());
    let without = map.with_spread(Spread::ZERO);
    assert!(without.regions().all(|(_, region)| region.spread.is_zero()));
}

#[test]
fn a_path_counts_as_its_segments_weighted_by_their_lengths() {
    let points = vec![[10.0, 20.0], [40.0, 20.0], [40.0, 60.0], [44.0, 63.0]];
    let bent = Mark::Path(Path { points: points.clone(), width: 7.0 });
    let lines: Vec<Mark> =
        points.windows(2).map(|ends| Mark::Line(Line { from: ends[0], to: ends[1], width: 7.0 })).collect();
    let [one, many] = [&[bent][..], &lines[..]].map(|marks| map(marks, [1, 1], Edges::Closed));
    assert_eq!(one.at([5.0, 5.0]), many.at([5.0, 5.0]));
    assert_eq!(one.region([0, 0]).marks, 1);
}
