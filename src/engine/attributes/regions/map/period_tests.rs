//! Which period the lines of a region want.

use super::*;
use crate::marks::Line;

const SIDE: f64 = 300.0;

/// A line of this `width` through `middle` in this direction, 120 px long.
fn line(middle: [f64; 2], width: f64, angle: f64) -> Mark {
    let (s, c) = libm::sincos(angle.to_radians());
    let end = |way: f64| [middle[0] + way * c, middle[1] + way * s];
    Mark::Line(Line { from: end(-60.0), to: end(60.0), width })
}

/// Level lines 10 px wide, `apart` px apart, the first at `first`.
fn lines(first: [f64; 2], count: usize, apart: f64) -> Vec<Mark> {
    (0..count).map(|k| line([first[0], first[1] + k as f64 * apart], 10.0, 0.0)).collect()
}

fn map(marks: &[Mark], grid: [usize; 2], edges: Edges) -> RegionMap {
    RegionMap::from_marks(marks, [SIDE; 2], grid, edges).expect("lines")
}

/// The period of each region, row by row.
fn periods(map: &RegionMap) -> Vec<f64> {
    let period = |region: &Region| match region.filled {
        Attributes::Stripes(stripes) => stripes.wavelength.expect("a period"),
        Attributes::Spots(_) => panic!("lines were drawn"),
    };
    map.regions().map(|(_, region)| period(region)).collect()
}

#[track_caller]
fn near(found: &[f64], wanted: &[f64]) {
    let are_near = found.iter().zip(wanted).all(|(found, wanted)| (found / wanted - 1.0).abs() < 1e-9);
    assert!(are_near && found.len() == wanted.len(), "{found:?}, not {wanted:?}");
}

#[test]
fn five_lines_ask_for_the_distance_at_which_they_lie() {
    for apart in [14.0, 20.0, 33.0, 54.0] {
        near(&periods(&map(&lines([150.0, 40.0], 5, apart), [1, 1], Edges::Closed)), &[apart]);
    }
}

#[test]
fn lines_that_do_not_lie_side_by_side_are_half_as_wide_as_their_period() {
    let one = lines([150.0, 150.0], 1, 0.0);
    let far = lines([150.0, 60.0], 2, 90.0);
    let in_a_row = [line([70.0, 100.0], 10.0, 0.0), line([220.0, 110.0], 10.0, 0.0)];
    let oblique = [line([150.0, 100.0], 10.0, 0.0), line([150.0, 190.0], 10.0, 60.0)];
    for marks in [&one[..], &far, &in_a_row, &oblique] {
        assert_eq!(periods(&map(marks, [1, 1], Edges::Closed)), [20.0], "{marks:?}");
    }
}

#[test]
fn a_region_with_one_line_takes_the_nearest_period_and_one_without_the_region_that_is_nearest() {
    let mut marks = lines([50.0, 20.0], 3, 33.0);
    marks.extend(lines([250.0, 20.0], 3, 24.0));
    marks.push(line([250.0, 250.0], 10.0, 0.0));
    let map = map(&marks, [3, 3], Edges::Closed);
    near(&periods(&map), &[33.0, 33.0, 24.0, 33.0, 33.0, 24.0, 33.0, 24.0, 24.0]);
}

#[test]
fn a_region_keeps_its_width_with_the_nearest_period_that_stripes_of_it_can_have() {
    let mut marks = lines([75.0, 40.0], 5, 33.0);
    marks.push(line([225.0, 150.0], 4.0, 0.0));
    near(&periods(&map(&marks, [2, 1], Edges::Closed)), &[33.0, 4.0 / 0.18]);
}

#[test]
fn a_line_beside_which_none_lies_says_nothing_about_the_period_of_its_region() {
    let mut marks = lines([100.0, 30.0], 4, 33.0);
    marks.push(line([220.0, 260.0], 10.0, 0.0));
    near(&periods(&map(&marks, [1, 1], Edges::Closed)), &[33.0]);
}

#[test]
fn lines_farther_apart_count_less_and_less() {
    let period = |apart: f64| periods(&map(&lines([150.0, 10.0], 4, apart), [1, 1], Edges::Closed))[0];
    let periods = [60.0, 65.0, 70.0, 75.0, 79.9, 80.1].map(period);
    // Stripes cover 0.18 of their period and more.
    assert!((periods[0] - 10.0 / 0.18).abs() < 1e-6, "{periods:?}");
    assert!(periods.is_sorted_by(|a, b| a > b) && periods[4] < 20.6 && periods[5] == 20.0, "{periods:?}");
}

#[test]
fn the_distance_of_lines_of_two_regions_is_that_of_neither() {
    let marks = [line([150.0, 135.0], 10.0, 0.0), line([150.0, 168.0], 10.0, 0.0)];
    assert_eq!(periods(&map(&marks, [1, 2], Edges::Closed)), [20.0; 2]);
    near(&periods(&map(&marks, [1, 1], Edges::Closed)), &[33.0]);
}

#[test]
fn lines_lie_side_by_side_across_the_border_of_a_tile() {
    let marks = [line([150.0, 290.0], 10.0, 0.0), line([150.0, 23.0], 10.0, 0.0)];
    near(&periods(&map(&marks, [1, 1], Edges::Wrap)), &[33.0]);
    assert_eq!(periods(&map(&marks, [1, 1], Edges::Closed)), [20.0]);
}
