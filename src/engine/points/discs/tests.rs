use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

use super::*;
use crate::points::delaunay::Delaunay;

const TILE: Extent = Extent { size: [300.0, 200.0], wrap: [true, true] };
const CARD: Extent = Extent { size: [300.0, 200.0], wrap: [false, false] };

fn lay(extent: &Extent, margin: f64, metric: &dyn Fn([f64; 2]) -> Metric, seed: u64) -> Vec<[f64; 2]> {
    poisson_discs(extent, margin, metric, &[], &mut Pcg64Mcg::seed_from_u64(seed))
}

/// Radius of the largest empty circle between round discs on a tile, in radii of the discs: its centre is a corner of a Voronoi
/// cell.
fn largest_gap(points: &[[f64; 2]], radius: f64) -> f64 {
    let graph = Delaunay::new(points, TILE);
    let corners = (0..points.len()).flat_map(|point| graph.cell(point).to_vec());
    corners.map(|[x, y]| libm::hypot(x, y)).fold(0.0, f64::max) / radius
}

#[test]
fn round_discs_keep_their_radius_and_leave_no_room() {
    for seed in 1..5 {
        let points = lay(&TILE, 0.0, &|_| Metric::circle(4.0), seed);
        let graph = Delaunay::new(&points, TILE);
        let edges = (0..points.len()).flat_map(|point| graph.axes(point).to_vec());
        let nearest = edges
            .map(|axis| libm::hypot(axis.displacement[0], axis.displacement[1]))
            .fold(f64::INFINITY, f64::min);
        let gap = largest_gap(&points, 4.0);
        assert!((4.0..4.1).contains(&nearest), "{nearest}");
        assert!(gap < 1.0 && gap > 0.9, "{gap}");
        let density = points.len() as f64 * 16.0 / (300.0 * 200.0);
        assert!((density - POINTS_A_SQUARE).abs() < 0.03, "{density}");
    }
}

#[test]
fn every_place_lies_in_the_disc_of_a_point_where_discs_vary_too() {
    let metric = |[x, _]: [f64; 2]| Metric::ellipse(4.0 + 8.0 * (x / 300.0).clamp(0.0, 1.0), 0.5, 0.4 * x);
    let points = lay(&CARD, 20.0, &metric, 3);
    let covered = |at: [f64; 2]| {
        points.iter().any(|center| metric(*center).square([at[0] - center[0], at[1] - center[1]]) < 1.0)
    };
    assert!((0..6_000).all(|k| covered([3.0 * f64::from(k % 100) + 1.3, f64::from(k / 100) * 200.0 / 60.0])));
    let inside = |low: f64| points.iter().filter(|[x, _]| (low..low + 100.0).contains(x)).count();
    assert!(inside(0.0) > 3 * inside(200.0), "{}, {}", inside(0.0), inside(200.0));
    for (i, a) in points.iter().enumerate() {
        for b in &points[..i] {
            let displacement = [a[0] - b[0], a[1] - b[1]];
            // The later point is not in the disc of the earlier one.
            assert!(metric(*b).square(displacement) >= 1.0, "{a:?}, {b:?}");
        }
    }
}

#[test]
fn ellipses_are_farther_apart_along_their_direction() {
    let points = lay(&TILE, 0.0, &|_| Metric::ellipse(8.0, 0.3, 30.0), 2);
    let (s, c) = libm::sincos(30f64.to_radians());
    // Half axes of 14.6 and 4.4 px.
    let [mut along, mut across] = [0, 0];
    for (i, a) in points.iter().enumerate() {
        for b in &points[..i] {
            let [x, y] = TILE.shortest([a[0] - b[0], a[1] - b[1]]);
            let (u, v) = ((c * x + s * y).abs(), (c * y - s * x).abs());
            along += usize::from(u < 13.0 && v < 2.0);
            across += usize::from(u < 2.0 && v < 13.0);
        }
    }
    // If three points lie in a row across, the nearest one may lie a little aside.
    assert!(along == 0 && across > points.len() / 3, "{along}, {across} of {}", points.len());
}

#[test]
fn points_given_first_stay_and_others_keep_away_from_them() {
    let first = [[10.0, 10.0], [290.5, 190.0]];
    let metric = |_: [f64; 2]| Metric::circle(12.0);
    let points = poisson_discs(&TILE, 0.0, &metric, &first, &mut Pcg64Mcg::seed_from_u64(1));
    assert_eq!(points[..2], first);
    let away = |at: &[f64; 2]| TILE.shortest([at[0] - 290.5, at[1] - 190.0]);
    assert!(points[2..].iter().map(away).all(|[x, y]| libm::hypot(x, y) >= 12.0));
}

#[test]
fn the_margin_lies_beyond_closed_borders_alone() {
    let cylinder = Extent { wrap: [true, false], ..TILE };
    let points = lay(&cylinder, 30.0, &|_| Metric::circle(9.0), 4);
    let [low, high] = points.iter().fold([[f64::MAX; 2], [f64::MIN; 2]], |[low, high], at| {
        [[0, 1].map(|k| at[k].min(low[k])), [0, 1].map(|k| at[k].max(high[k]))]
    });
    assert!(low[0] >= 0.0 && high[0] < 300.0);
    assert!(low[1] > -30.0 && low[1] < -15.0 && high[1] > 215.0 && high[1] < 230.0);
}

#[test]
fn the_same_seed_gives_the_same_points() {
    let points = |seed| lay(&TILE, 0.0, &|_| Metric::circle(7.0), seed);
    assert!(points(1) == points(1) && points(1) != points(2));
}

#[test]
fn a_disc_that_covers_a_tile_many_times_is_laid_once() {
    for radius in [400.0, 1e5, 1e12] {
        assert_eq!(lay(&TILE, 0.0, &|_| Metric::circle(radius), 1).len(), 1, "{radius}");
    }
    // Long discs that do not cover the tile still have all their images.
    let metric = |_: [f64; 2]| Metric::ellipse(120.0, 0.04, 20.0);
    let points = lay(&TILE, 0.0, &metric, 2);
    let covered = |at: [f64; 2]| {
        let images =
            (-9..10).flat_map(|x| (-9..10).map(move |y| [300.0 * f64::from(x), 200.0 * f64::from(y)]));
        let mut ways = points
            .iter()
            .flat_map(|center| images.clone().map(|image| [0, 1].map(|k| at[k] - center[k] + image[k])));
        ways.any(|displacement| metric(at).square(displacement) < 1.0)
    };
    assert!((0..600).all(|k| covered([10.0 * f64::from(k % 30) + 1.3, 10.0 * f64::from(k / 30) + 0.7])));
}

#[test]
fn the_cost_of_laying_discs_is_estimated_in_advance() {
    let varied = |[x, _]: [f64; 2]| Metric::circle(4.0 + 8.0 * (x / 300.0).clamp(0.0, 1.0));
    for (extent, margin) in [(TILE, 0.0), (CARD, 40.0)] {
        for metric in [&varied as &dyn Fn([f64; 2]) -> Metric, &|_| Metric::circle(6.0)] {
            let laying = Laying::new(&extent, margin, metric);
            let points = lay(&extent, margin, metric, 3).len() as f64;
            assert!((0.9..1.25).contains(&(laying.points / points)), "{laying:?}, {points}");
        }
    }
    // No disc is smaller than 1/2,000 of the longer side.
    let laying = Laying::new(&CARD, 1e5, &|_| Metric::circle(1e-3));
    assert!(laying.points < 2.9e6 && laying.buckets < 4.1e6, "{laying:?}");
}
