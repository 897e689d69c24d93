use proptest::prelude::*;
use rand::SeedableRng as _;
use rand_pcg::Pcg64Mcg;

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
    // Opposite to the hypotenuse is a right angle: weight 0.
    assert_eq!(mean_spacing(&[[0.0, 0.0], [3.0, 0.0], [0.0, 4.0]]), Some(3.5));
    assert_eq!(mean_spacing(&[[0.0, 0.0], [10.0, 0.0], [20.0, 0.0], [55.0, 0.0]]), Some(10.0));
    // Of the weight 1/2: 3 times the median distance to the nearest.
    assert_eq!(mean_spacing(&[[0.0, 0.0], [10.0, 0.0], [20.0, 0.0], [50.0, 0.0]]), Some(14.0));
}

#[test]
fn points_in_a_row_are_read_from_one_to_the_next_straight_or_nearly() {
    let row = |bend: f64| -> Vec<[f64; 2]> {
        [0.0, 20.0, 50.0, 70.0, 100.0].iter().map(|x| [*x, bend * libm::sin(*x)]).collect()
    };
    assert_eq!(mean_spacing(&row(0.0)), Some(25.0));
    for bend in [1e-12, 1e-6, 1e-3, 0.1] {
        assert!((mean_spacing(&row(bend)).unwrap() - 25.0).abs() < 1e-3, "{bend}");
    }
}

#[test]
fn an_array_has_the_distance_of_its_rows() {
    let spacing = mean_spacing(&lattice(5, 5, [80.0, 0.0], [0.0, 80.0])).unwrap();
    assert!((78.0..83.0).contains(&spacing), "{spacing}");
}

#[test]
fn a_ring_is_read_along_itself() {
    let radius = 31.0 / libm::sin(std::f64::consts::PI / 12.0);
    let at = |k: u32| {
        let turn = f64::from(k) * std::f64::consts::TAU / 12.0;
        [256.0 + radius * libm::cos(turn), 256.0 + radius * libm::sin(turn)]
    };
    let ring: Vec<[f64; 2]> = (0..12).map(at).collect();
    assert!((mean_spacing(&ring).unwrap() - 62.0).abs() < 1e-6);
}

#[test]
fn rows_far_apart_are_read_along_themselves() {
    for columns in 4..15 {
        let spacing = mean_spacing(&lattice(columns, 2, [30.0, 0.0], [0.0, 100.0])).unwrap();
        assert!((30.0..=40.0).contains(&spacing), "{columns} columns: {spacing}");
    }
}

#[test]
fn pairs_far_apart_have_the_distance_within_a_pair() {
    let pairs = |away: f64| {
        lattice(3, 3, [42.0 + away, 0.0], [0.0, away]).into_iter().flat_map(|[x, y]| [[x, y], [x + 42.0, y]])
    };
    for away in [150.0, 180.0, 300.0] {
        let points: Vec<[f64; 2]> = pairs(away).collect();
        assert!((mean_spacing(&points).unwrap() - 42.0).abs() < 1e-9, "{away}");
    }
}

#[test]
fn the_two_nearest_points_always_have_the_full_weight() {
    for (name, points) in sketches() {
        for wrap in [None, Some([SIDE; 2])] {
            let edges = neighbours(&points, wrap);
            let shortest = edges.iter().min_by(|a, b| a.length.total_cmp(&b.length)).unwrap();
            assert_eq!(shortest.weight, 1.0, "{name}");
        }
    }
}

#[test]
fn moving_one_point_a_little_changes_the_spacing_a_little() {
    for (name, points) in sketches() {
        for wrap in [None, Some([SIDE; 2])] {
            let spacing = |points: &[[f64; 2]]| mean_length(&neighbours(points, wrap)).unwrap();
            let before = spacing(&points);
            // The least step finds jumps, the other slopes that are too steep.
            for (share, most) in [(1e-9, 1e-7), (1e-3, 0.03)] {
                for (index, [x, y]) in points.iter().enumerate() {
                    for step in [[share, 0.0], [-share, 0.0], [0.0, share], [0.0, -share]] {
                        let mut moved = points.clone();
                        moved[index] = [x + SIDE * step[0], y + SIDE * step[1]];
                        let change = (spacing(&moved) / before - 1.0).abs();
                        assert!(change <= most, "{name}, {wrap:?}: point {index} by {step:?}: {change}");
                    }
                }
            }
        }
    }
}

/// Side of the canvas of the random sketches.
const SIDE: f64 = 512.0;

/// 200 random sketches of 8–30 points: scattered, in arrays, rows, rings and clusters, exact ones and uneven ones.
fn sketches() -> Vec<(String, Vec<[f64; 2]>)> {
    (0..200).map(|seed| (format!("sketch {seed}"), sketch(seed))).collect()
}

fn sketch(seed: u64) -> Vec<[f64; 2]> {
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    let mut uniform = |low: f64, high: f64| low + (high - low) * rng.random::<f64>();
    let count = uniform(8.0, 31.0) as usize;
    let step = uniform(30.0, 80.0);
    let unevenness = [0.0, 1e-9, 0.3, 1.0][(seed / 5 % 4) as usize];
    let turn = std::f64::consts::TAU / count as f64;
    let mut points: Vec<[f64; 2]> = Vec::new();
    while points.len() < count {
        let k = points.len();
        let along = k as f64;
        let [x, y] = match seed % 5 {
            0 => [uniform(0.0, SIDE), uniform(0.0, SIDE)],
            1 => [60.0 + step * (k % 5) as f64, 40.0 + step * (k / 5) as f64],
            2 => [40.0 + 20.0 * along, 80.0 + 1.7 * step * (k % 2) as f64],
            3 => [libm::cos(turn * along), libm::sin(turn * along)].map(|v| 256.0 + step * v / turn),
            _ => [100.0 + 150.0 * (k % 3) as f64 + uniform(-60.0, 60.0), 256.0 + uniform(-90.0, 90.0)],
        };
        let point = [x + unevenness * uniform(-1.0, 1.0), y + unevenness * uniform(-1.0, 1.0)];
        // Marks of a cluster do not lie on each other.
        let clear = |other: &[f64; 2]| (point[0] - other[0]).hypot(point[1] - other[1]) > 24.0;
        if seed % 5 != 4 || points.iter().all(clear) {
            points.push(point);
        }
    }
    points
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

/// Groups of a canvas cut into four quarters.
fn quarters(points: &[[f64; 2]]) -> Vec<Vec<WeightedEdge>> {
    grouped_neighbours(points, 4, |index| {
        points[index].map(|x| usize::from(x >= 0.5 * SIDE)).iter().fold(0, |g, x| 2 * g + x)
    })
}

#[test]
fn one_group_has_the_edges_of_all_points() {
    let points = sketch(0);
    assert_eq!(grouped_neighbours(&points, 1, |_| 0), [neighbours(&points, None)]);
}

#[test]
fn a_cut_pattern_has_the_same_spacing_in_each_of_its_parts() {
    let h = 16.0 * 3.0_f64.sqrt();
    let points = lattice(16, 17, [32.0, 0.0], [0.0, 2.0 * h]);
    let between = points.iter().map(|[x, y]| [x + 16.0, y + h]);
    let points: Vec<[f64; 2]> = points.iter().copied().chain(between).collect();
    for edges in quarters(&points) {
        assert!(edges.len() > 100 && (mean_length(&edges).unwrap() - 32.0).abs() < 1e-9);
    }
}

#[test]
fn points_of_a_group_that_others_part_have_their_own_distance() {
    let points = [[10.0, 10.0], [90.0, 10.0], [50.0, 9.0], [50.0, 11.0], [50.0, 60.0]];
    let edges = grouped_neighbours(&points, 2, |index| usize::from(index > 1));
    assert_eq!(edges[0], [WeightedEdge { ends: [0, 1], length: 80.0, midpoint: [50.0, 10.0], weight: 1.0 }]);
}

#[test]
fn moving_one_point_a_little_changes_the_spacing_of_groups_a_little() {
    for seed in 0..200 {
        let points = sketch(seed);
        for index in 0..points.len() {
            let mut moved = points.clone();
            moved[index][0] += 1e-9 * SIDE;
            for (before, after) in quarters(&points).iter().zip(&quarters(&moved)) {
                let [before, after] = [before, after].map(|edges| mean_length(edges));
                let Some((before, after)) = before.zip(after) else { continue };
                assert!((after / before - 1.0).abs() < 1e-6, "sketch {seed}: {before} → {after}");
            }
        }
    }
}
