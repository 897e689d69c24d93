use std::collections::BTreeSet;

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::*;
use crate::attributes::spacing;

const TILE: Extent = Extent { size: [90.0, 60.0], wrap: [true, true] };
const CARD: Extent = Extent { size: [90.0, 60.0], wrap: [false, false] };
const CYLINDER: Extent = Extent { size: [90.0, 60.0], wrap: [false, true] };

fn random(count: usize, seed: u64) -> Vec<[f64; 2]> {
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    (0..count).map(|_| [90.0 * rng.random::<f64>(), 60.0 * rng.random::<f64>()]).collect()
}

/// Pairs of points that are joined by an edge, with its length in 1/1,000 px.
fn pairs(graph: &Delaunay) -> BTreeSet<(u32, u32, i64)> {
    let mut pairs = BTreeSet::new();
    for point in 0..graph.points.len() {
        for axis in graph.axes(point) {
            let Some(to) = axis.to else { continue };
            let (low, high) = ((point as u32).min(to), (point as u32).max(to));
            pairs.insert((
                low,
                high,
                (1e3 * libm::hypot(axis.displacement[0], axis.displacement[1])).round() as i64,
            ));
        }
    }
    pairs
}

#[test]
fn edges_on_a_tile_agree_with_those_of_the_measurement() {
    for (count, seed) in [(300, 1), (40, 2), (5, 3), (2, 4)] {
        let points = random(count, seed);
        let edges = spacing::edges(&points, Some(TILE.size));
        let expected: BTreeSet<(u32, u32, i64)> = edges
            .iter()
            .map(|edge| (edge.ends[0] as u32, edge.ends[1] as u32, (1e3 * edge.length).round() as i64))
            .collect();
        assert_eq!(pairs(&Delaunay::new(&points, TILE)), expected, "{count}");
    }
}

#[test]
fn the_cells_cover_the_extent_without_overlap() {
    for extent in [TILE, CARD, CYLINDER] {
        for count in [1, 2, 3, 200] {
            let graph = Delaunay::new(&random(count, 5), extent);
            let sum: f64 = (0..count).map(|point| graph.area_inside(point)).sum();
            assert!((sum / (90.0 * 60.0) - 1.0).abs() < 1e-9, "{extent:?}, {count} points: {sum}");
        }
    }
}

#[test]
fn axes_and_corners_of_the_cell_alternate_round_a_point() {
    let graph = Delaunay::new(&random(120, 6), TILE);
    for point in 0..120 {
        let (axes, cell) = (graph.axes(point), graph.cell(point));
        for (k, corner) in cell.iter().enumerate() {
            // A corner is as far from the point as from the neighbours before and after it.
            for axis in [axes[k], axes[(k + 1) % axes.len()]] {
                let dot = axis.displacement[0] * corner[0] + axis.displacement[1] * corner[1];
                let half = 0.5
                    * (axis.displacement[0] * axis.displacement[0]
                        + axis.displacement[1] * axis.displacement[1]);
                assert!((dot - half).abs() < 1e-6 * half, "{point}, corner {k}: {dot}, {half}");
            }
        }
    }
}

#[test]
fn places_on_an_edge_with_clearance_are_nearest_to_its_ends() {
    let points = random(150, 7);
    let graph = Delaunay::new(&points, TILE);
    let mut found = [0; 2];
    for point in 0..150 {
        for axis in graph.axes(point) {
            let middle = [0, 1].map(|k| graph.points[point][k] + 0.5 * axis.displacement[k]);
            let half = 0.25
                * (axis.displacement[0] * axis.displacement[0] + axis.displacement[1] * axis.displacement[1]);
            let nearest = |at: &[f64; 2]| {
                let displacement = TILE.shortest([at[0] - middle[0], at[1] - middle[1]]);
                displacement[0] * displacement[0] + displacement[1] * displacement[1]
            };
            let least = points.iter().map(nearest).fold(f64::INFINITY, f64::min);
            assert_eq!(axis.clearance > 0.0, least > half * (1.0 - 1e-9), "{point}");
            found[usize::from(axis.clearance > 0.0)] += 1;
        }
    }
    assert!(found.iter().all(|count| *count > 50), "{found:?}");
}

#[test]
fn the_points_opposite_to_an_edge_are_the_third_corners_of_its_triangles() {
    let square = Delaunay::new(&[[20.0, 20.0], [40.0, 10.0], [60.0, 20.0], [40.0, 31.0]], CARD);
    // The edge between 1 and 3 is the shorter diagonal.
    let across = |point: usize| square.opposite(point).map(|(other, _)| other).collect::<Vec<_>>();
    assert_eq!((across(0), across(2)), (vec![2], vec![0]));
    let clearance = square.opposite(0).next().expect("an opposite").1;
    let axis = square.axes(1).iter().find(|axis| axis.to == Some(3)).expect("the diagonal");
    assert!(clearance > 0.0 && axis.clearance == clearance);
    let graph = Delaunay::new(&random(90, 9), TILE);
    for point in 0..90 {
        assert_eq!(graph.opposite(point).count(), graph.axes(point).len());
        for (other, _) in graph.opposite(point) {
            assert!(graph.opposite(other).any(|(back, _)| back == point), "{point}, {other}");
        }
    }
}

#[test]
fn coincident_and_non_finite_points_have_no_neighbours() {
    let mut points = random(30, 8);
    points.push(points[4]);
    points.push([f64::NAN, 3.0]);
    let graph = Delaunay::new(&points, CARD);
    assert!(graph.axes(30).is_empty() && graph.axes(31).is_empty());
    assert!(!graph.axes(4).is_empty() && graph.area(30) == 0.0);
    assert!(Delaunay::new(&[], TILE).points.is_empty());
}

#[test]
fn a_clipped_polygon_keeps_the_part_on_the_extent() {
    let square = vec![[-5.0, 10.0], [5.0, 10.0], [5.0, 20.0], [-5.0, 20.0]];
    assert_eq!(area(&clipped(square.clone(), &CARD)), 50.0);
    assert_eq!(area(&clipped(square.clone(), &TILE)), 100.0);
    assert_eq!(area(&clipped(square, &CYLINDER)), 50.0);
}
