use proptest::prelude::*;

use super::*;

fn lattice(columns: usize, rows: usize, a: [f64; 2], b: [f64; 2]) -> Vec<[f64; 2]> {
    let at = |i: usize, j: usize| {
        let (i, j) = (i as f64, j as f64);
        [10.0 + i * a[0] + j * b[0], 20.0 + i * a[1] + j * b[1]]
    };
    (0..rows).flat_map(|j| (0..columns).map(move |i| at(i, j))).collect()
}

/// Edges by the definition: a triangle counts where its circumcircle holds no other point. O(n⁴).
fn by_definition(points: &[[f64; 2]]) -> Vec<[usize; 2]> {
    let n = points.len();
    let mut edges = Vec::new();
    for i in 0..n {
        for j in i + 1..n {
            for k in j + 1..n {
                let Some((center, radius)) = circle(points[i], points[j], points[k]) else { continue };
                let away = |p: [f64; 2]| (p[0] - center[0]).hypot(p[1] - center[1]);
                let mut others = (0..n).filter(|l| ![i, j, k].contains(l));
                if others.all(|l| away(points[l]) >= radius * (1.0 - 1e-9)) {
                    edges.extend([[i, j], [j, k], [i, k]]);
                }
            }
        }
    }
    edges.sort_unstable();
    edges.dedup();
    edges
}

fn circle(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Option<([f64; 2], f64)> {
    let (b, c) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
    let d = 2.0 * (b[0] * c[1] - b[1] * c[0]);
    let (bb, cc) = (b[0] * b[0] + b[1] * b[1], c[0] * c[0] + c[1] * c[1]);
    let u = [(c[1] * bb - b[1] * cc) / d, (b[0] * cc - c[0] * bb) / d];
    (d.abs() > 1e-9).then(|| ([a[0] + u[0], a[1] + u[1]], u[0].hypot(u[1])))
}

#[test]
fn a_hexagonal_lattice_has_its_own_spacing() {
    let h = 6.0 * 3.0_f64.sqrt();
    let points = lattice(7, 8, [12.0, 0.0], [6.0, h]);
    assert!((mean_spacing(&points).unwrap() - 12.0).abs() < 1e-9);
    let on_tile: Vec<[f64; 2]> = (0..8)
        .flat_map(|j| (0..7).map(move |i| [12.0 * i as f64 + 6.0 * (j % 2) as f64, h * j as f64]))
        .collect();
    let found = edges(&on_tile, Some([84.0, 8.0 * h]));
    assert_eq!(found.len(), 3 * on_tile.len());
    assert!(found.iter().all(|edge| (edge.length - 12.0).abs() < 1e-9 && !edge.hull));
}

#[test]
fn a_square_lattice_has_two_sides_and_one_diagonal_a_point() {
    let points = lattice(6, 5, [10.0, 0.0], [0.0, 10.0]);
    let found = edges(&points, Some([60.0, 50.0]));
    let diagonals = found.iter().filter(|edge| edge.length > 12.0).count();
    assert_eq!((found.len(), diagonals), (90, 30));
    let inner = edges(&points, None);
    assert_eq!(inner.iter().filter(|edge| edge.hull).count(), 18);
    assert_eq!(inner.iter().filter(|edge| !edge.hull && edge.length > 12.0).count(), 20);
}

#[test]
fn few_points_have_the_spacing_that_the_format_defines() {
    assert_eq!(mean_spacing(&[]), None);
    assert_eq!(mean_spacing(&[[3.0, 4.0]]), None);
    assert_eq!(mean_spacing(&[[3.0, 4.0], [0.0, 0.0]]), Some(5.0));
    // Three: all three edges are hull and no inner one remains.
    assert_eq!(mean_spacing(&[[0.0, 0.0], [3.0, 0.0], [0.0, 4.0]]), Some(4.0));
    // On one line the edges join neighbours; 30 is over twice the median.
    assert_eq!(mean_spacing(&[[0.0, 0.0], [10.0, 0.0], [20.0, 0.0], [50.0, 0.0]]), Some(10.0));
    // A wheel of six spokes: its rim is hull, six inner edges remain.
    let wheel = [[0.0, 0.0], [9.0, 0.0], [4.0, 7.0], [-4.0, 7.0], [-9.0, 0.0], [-4.0, -7.0], [4.0, -7.0]];
    let spokes = (18.0 + 4.0 * 65.0_f64.sqrt()) / 6.0;
    assert!((mean_spacing(&wheel).unwrap() - spokes).abs() < 1e-12);
}

#[test]
fn points_that_coincide_or_are_not_finite_are_left_out() {
    assert_eq!(mean_spacing(&[[1.0, 1.0]; 5]), None);
    assert_eq!(mean_spacing(&[[1.0, 1.0], [1.0, 1.0], [4.0, 5.0]]), Some(5.0));
    assert_eq!(mean_spacing(&[[f64::NAN, 1.0], [0.0, 0.0], [1e-200, 6.0], [f64::INFINITY, 0.0]]), Some(6.0));
    assert_eq!(edges(&[[1.0, 1.0], [33.0, 1.0]], Some([32.0, 32.0])).len(), 3);
}

#[test]
fn one_point_on_a_tile_neighbours_its_own_copies() {
    let mut lengths: Vec<f64> = edges(&[[5.0, 5.0]], Some([30.0, 10.0])).iter().map(|e| e.length).collect();
    lengths.sort_by(f64::total_cmp);
    assert_eq!(lengths, [10.0, 30.0, 1000.0_f64.sqrt()]);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, ..ProptestConfig::default() })]

    #[test]
    fn edges_are_those_of_empty_circles(
        points in prop::collection::vec([0.0..100.0, 0.0..100.0_f64], 3..16),
    ) {
        let found: Vec<[usize; 2]> = edges(&points, None).iter().map(|edge| edge.ends).collect();
        prop_assert_eq!(found, by_definition(&points));
    }

    #[test]
    fn a_tile_has_three_edges_a_point_wherever_it_is_cut(
        points in prop::collection::vec([0.0..40.0, 0.0..25.0_f64], 1..40), dx in 0.0..40.0, dy in 0.0..25.0,
    ) {
        let tile = [40.0, 25.0];
        let found = edges(&points, Some(tile));
        prop_assert_eq!(found.len(), 3 * points.len());
        let moved: Vec<[f64; 2]> = points.iter().map(|p| [p[0] + dx, p[1] + dy]).collect();
        let again = edges(&moved, Some(tile));
        let total = |edges: &[Edge]| edges.iter().map(|edge| edge.length).sum::<f64>();
        prop_assert!((total(&found) - total(&again)).abs() < 1e-6);
        for edge in found {
            prop_assert!(edge.midpoint[0] >= 0.0 && edge.midpoint[0] <= 40.0);
        }
    }

    #[test]
    fn a_tile_agrees_with_nine_copies_of_it(
        points in prop::collection::vec([0.0..40.0, 0.0..40.0_f64], 4..20),
    ) {
        let mut copies = Vec::new();
        for shift in [[0.0, 0.0], [-1.0, -1.0], [0.0, -1.0], [1.0, -1.0], [-1.0, 0.0], [1.0, 0.0], [-1.0, 1.0], [0.0, 1.0], [1.0, 1.0]] {
            copies.extend(points.iter().map(|p| [p[0] + 40.0 * shift[0], p[1] + 40.0 * shift[1]]));
        }
        let inside = |p: &[f64; 2]| p.iter().all(|x| (0.0..40.0).contains(x));
        let slow: f64 = edges(&copies, None).iter().filter(|e| inside(&e.midpoint)).map(|e| e.length).sum();
        let fast: f64 = edges(&points, Some([40.0, 40.0])).iter().map(|e| e.length).sum();
        prop_assert!((slow - fast).abs() < 1e-6, "{} {}", slow, fast);
    }
}
