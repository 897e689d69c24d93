//! Tests of the tracing alone.

use super::*;

/// A field from a picture in text: `#` = 1, anything else 0.
fn traced(picture: &[&str], edges: Edges, level: f64) -> Traced {
    let size = [picture[0].len(), picture.len()];
    let rows = |range: Range<usize>| {
        let values = picture[range].iter().flat_map(|row| row.bytes());
        Ok(values.map(|c| if c == b'#' { 1.0 } else { 0.0 }).collect())
    };
    trace(size, size.map(|n| n as f64), edges, level, &mut { rows }).unwrap()
}

fn area(ring: &Ring) -> f64 {
    let n = ring.points.len();
    let twice = |i: usize| {
        let (a, b) = (ring.points[i], ring.points[(i + 1) % n]);
        a.x * b.y - a.y * b.x
    };
    0.5 * (0..n).map(twice).sum::<f64>()
}

#[test]
fn one_cell_becomes_a_diamond() {
    let Traced { rings, .. } = traced(&["...", ".#.", "..."], Edges::Closed, 0.5);
    assert_eq!(rings.len(), 1);
    assert_eq!(area(&rings[0]), 0.5);
    for point in [[1.5, 1.0], [1.0, 1.5], [1.5, 2.0], [2.0, 1.5]] {
        assert!(
            rings[0].points.contains(&Point::new(point[0], point[1])),
            "{point:?} in {:?}",
            rings[0].points
        );
    }
}

#[test]
fn a_ring_has_a_hole_with_the_opposite_direction() {
    let Traced { rings, outside, .. } =
        traced(&[".....", ".###.", ".#.#.", ".###.", "....."], Edges::Closed, 0.5);
    let areas: Vec<f64> = rings.iter().map(area).collect();
    assert_eq!(areas.len(), 2);
    let (outer, hole) = if areas[0] > 0.0 { (0, 1) } else { (1, 0) };
    assert!(areas[outer] > 7.0 && (-2.0..-0.4).contains(&areas[hole]), "{areas:?}");
    assert_eq!(rings[outer].sides[0], rings[hole].sides[0]);
    assert_eq!(rings[outer].sides[1], outside);
    assert_ne!(rings[hole].sides[1], outside);
}

#[test]
fn a_full_canvas_is_outlined_by_its_frame_and_an_empty_one_has_no_outline() {
    for edges in [Edges::Closed, Edges::Wrap] {
        let Traced { rings, .. } = traced(&["###", "###"], edges, 0.5);
        assert_eq!((rings.len(), area(&rings[0])), (1, 6.0));
        assert!(traced(&["...", "..."], edges, 0.5).rings.is_empty());
    }
}

#[test]
fn the_mean_decides_which_diagonal_is_connected() {
    for picture in [["....", ".#..", "..#.", "...."], ["....", "..#.", ".#..", "...."]] {
        assert_eq!(traced(&picture, Edges::Closed, 0.4).rings.len(), 1);
        assert_eq!(traced(&picture, Edges::Closed, 0.6).rings.len(), 2);
    }
}

#[test]
fn on_a_wrapped_canvas_lines_continue_on_the_opposite_side() {
    let picture = ["....#.....", "##.....###", "###....###", "..........", "...##.....", "....#....."];
    let Traced { rings, .. } = traced(&picture, Edges::Wrap, 0.5);
    let points: Vec<[f64; 2]> =
        rings.iter().flat_map(|ring| &ring.points).map(|point| [point.x, point.y]).collect();
    for (axis, far) in [(0, 10.0), (1, 6.0)] {
        let on = |border: f64| {
            let mut at: Vec<f64> = points.iter().filter(|p| p[axis] == border).map(|p| p[1 - axis]).collect();
            at.sort_by(f64::total_cmp);
            at
        };
        assert!(!on(0.0).is_empty());
        assert_eq!(on(0.0), on(far));
    }
}

#[test]
fn values_that_are_not_finite_give_finite_lines() {
    let values = [f32::NAN, 1.0, f32::INFINITY, 0.0, f32::NEG_INFINITY, 1.0, 0.5, f32::NAN, 0.2];
    for level in [0.5, 0.0, -1.0, 1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for edges in [Edges::Closed, Edges::Wrap] {
            let rows = |range: Range<usize>| Ok(values[3 * range.start..3 * range.end].to_vec());
            let traced = trace([3, 3], [3.0, 3.0], edges, level, &mut { rows }).unwrap();
            assert!(traced.rings.iter().flat_map(|ring| &ring.points).all(|point| point.is_finite()));
        }
    }
}
