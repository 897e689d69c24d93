use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

use super::*;
use crate::grid::Edges;
use crate::points::delaunay::Delaunay;
use crate::points::discs::poisson_discs;
use crate::points::extent::Extent;
use crate::points::metric::Metric;

const TILE: Extent = Extent { size: [300.0, 200.0], wrap: [true, true] };

fn graph(radius: f64, seed: u64) -> Delaunay {
    let points =
        poisson_discs(&TILE, 0.0, &|_| Metric::circle(radius), &[], &mut Pcg64Mcg::seed_from_u64(seed));
    Delaunay::new(&points, TILE)
}

/// The sizes of the connected parts if only points of the same cluster are joined.
fn parts(graph: &Delaunay, owner: &[Option<u32>]) -> Vec<usize> {
    let mut seen = vec![false; owner.len()];
    let mut sizes = Vec::new();
    for start in (0..owner.len()).filter(|point| owner[*point].is_some()) {
        let (mut open, mut size) = (vec![start], 0);
        while let Some(point) = open.pop() {
            if !std::mem::replace(&mut seen[point], true) {
                size += 1;
                open.extend(graph.neighbours(point).filter(|other| owner[*other] == owner[start]));
            }
        }
        if size > 0 {
            sizes.push(size);
        }
    }
    sizes
}

#[test]
fn as_many_points_are_dark_as_the_probability_says() {
    let graph = graph(3.0, 1);
    let labels = random(&graph.points, |[x, _]| x / 300.0, &mut Pcg64Mcg::seed_from_u64(2));
    let share = |low: f64| {
        let there: Vec<bool> = (0..labels.len())
            .filter(|point| (low..low + 60.0).contains(&graph.points[*point][0]))
            .map(|point| labels[point])
            .collect();
        there.iter().filter(|dark| **dark).count() as f64 / there.len() as f64
    };
    assert!((share(0.0) - 0.1).abs() < 0.05 && (share(240.0) - 0.9).abs() < 0.05);
}

#[test]
fn a_reference_picture_gives_its_own_light_and_dark() {
    let reference =
        Field::from_fn([30, 20], [10.0, 10.0], Edges::Closed, |[x, _]| f32::from(u8::from(x > 150.0)));
    let points = [[149.0, 5.0], [151.0, 5.0], [299.9, 199.9], [-20.0, 50.0], [330.0, 50.0]];
    let labels = by_reference(&points, &reference, &mut Pcg64Mcg::seed_from_u64(1));
    assert_eq!(labels, [false, true, true, false, true]);
}

#[test]
fn clusters_have_their_size_and_light_points_between_them() {
    let graph = graph(4.0, 3);
    for order in [Order::BreadthFirst, Order::DepthFirst] {
        let owner = clusters(&graph, 12, order, &mut Pcg64Mcg::seed_from_u64(4));
        for point in (0..owner.len()).filter(|point| owner[*point].is_some()) {
            assert!(
                graph.neighbours(point).all(|other| owner[other].is_none() || owner[other] == owner[point])
            );
        }
        for point in (0..owner.len()).filter(|point| owner[*point].is_none()) {
            assert!(graph.neighbours(point).any(|other| owner[other].is_some()));
        }
        let sizes = parts(&graph, &owner);
        assert!(sizes.iter().all(|size| *size <= 12));
        assert!(sizes.iter().filter(|size| **size == 12).count() * 3 > sizes.len());
    }
}

/// Mean of the smaller ÷ the larger standard deviation of the clusters' points, and their axial mean direction, degrees.
fn shape(graph: &Delaunay, owner: &[Option<u32>], least: usize) -> (f64, f64) {
    let count = owner.iter().flatten().max().map_or(0, |most| *most as usize + 1);
    let (mut aspects, mut double) = (Vec::new(), [0.0, 0.0]);
    for cluster in 0..count {
        let own: Vec<usize> = (0..owner.len()).filter(|p| owner[*p] == Some(cluster as u32)).collect();
        if own.len() < least {
            continue;
        }
        let ways = own.iter().map(|point| {
            let (at, first) = (graph.points[*point], graph.points[own[0]]);
            TILE.shortest([at[0] - first[0], at[1] - first[1]])
        });
        let n = own.len() as f64;
        let [mut x, mut y, mut xx, mut xy, mut yy] = [0.0; 5];
        for [dx, dy] in ways {
            (x, y, xx, xy, yy) = (x + dx, y + dy, xx + dx * dx, xy + dx * dy, yy + dy * dy);
        }
        let (xx, xy, yy) = (xx / n - x * x / n / n, xy / n - x * y / n / n, yy / n - y * y / n / n);
        let apart = (0.25 * (xx - yy) * (xx - yy) + xy * xy).sqrt();
        aspects.push(((0.5 * (xx + yy) - apart).max(0.0) / (0.5 * (xx + yy) + apart)).sqrt());
        double = [double[0] + 0.5 * (xx - yy) / apart, double[1] + xy / apart];
    }
    let angle = 0.5 * libm::atan2(double[1], double[0]).to_degrees();
    (aspects.iter().sum::<f64>() / aspects.len() as f64, angle)
}

#[test]
fn breadth_first_is_compact_and_depth_first_is_not() {
    let graph = graph(3.0, 5);
    fn shape_of(graph: &Delaunay, order: Order) -> (f64, f64) {
        let owner = clusters(graph, 20, order, &mut Pcg64Mcg::seed_from_u64(6));
        shape(graph, &owner, 20)
    }
    let (compact, _) = shape_of(&graph, Order::BreadthFirst);
    assert!(compact > 0.6, "{compact}");
    let (loose, _) = shape_of(&graph, Order::DepthFirst);
    assert!(loose < compact - 0.1, "{loose}, {compact}");
}

struct Meeting;

impl Claim for Meeting {
    fn cost(&self, _: usize, _: usize, displacement: [f64; 2]) -> Option<f64> {
        Some(libm::hypot(displacement[0], displacement[1]))
    }

    fn wants(&self, _: usize, _: f64, _: f64) -> bool {
        true
    }

    fn clearance(&self) -> Option<f64> {
        None
    }
}

#[test]
fn round_robin_clusters_share_all_points_equally() {
    let graph = graph(4.0, 7);
    let centers: Vec<usize> = (0..40).map(|k| 31 * k).collect();
    let (owner, areas) = round_robin(&graph, &centers, &[], &Meeting);
    assert!(owner.iter().all(Option::is_some));
    assert_eq!(parts(&graph, &owner).len(), 40);
    assert!((areas.iter().sum::<f64>() / (300.0 * 200.0) - 1.0).abs() < 1e-9);
    let thin = bordered(&graph, &owner, 0);
    let thick = bordered(&graph, &owner, 1);
    let dark = |labels: &[bool]| labels.iter().filter(|dark| **dark).count();
    assert!(dark(&thick) > 0 && dark(&thick) < dark(&thin) && dark(&thin) < owner.len());
    for point in (0..owner.len()).filter(|point| thin[*point]) {
        assert!(graph.neighbours(point).all(|other| owner[other] == owner[point]));
    }
}

#[test]
fn connected_points_are_one_part_for_any_start() {
    let graph = graph(3.0, 8);
    let mut shares = Vec::new();
    for (start, rings) in [(0.01, 0), (0.03, 0), (0.03, 1), (0.4, 0)] {
        let joined =
            connected(&graph, |ends| sparse(&graph, ends), start, rings, &mut Pcg64Mcg::seed_from_u64(9));
        let owner: Vec<Option<u32>> = joined.iter().map(|joined| joined.then_some(0)).collect();
        assert_eq!(parts(&graph, &owner).len(), 1, "{start}");
        shares.push(joined.iter().filter(|joined| **joined).count() as f64 / joined.len() as f64);
    }
    assert!(shares.is_sorted(), "{shares:?}");
    assert!(shares[1] < 0.6 && shares[2] > 0.8, "{shares:?}");
}

#[test]
fn the_rays_of_a_space_giraffe_are_dark_inside_and_light_outside() {
    let centers = graph(30.0, 10);
    let (points, labels) = space_giraffe(&centers, &(10..21), &mut Pcg64Mcg::seed_from_u64(11));
    assert_eq!(points.len(), labels.len());
    let count = labels.iter().filter(|dark| !**dark).count();
    let cells = centers.points.len();
    assert_eq!(labels.len(), cells + 2 * count);
    assert!(count >= 10 * cells && count <= 20 * cells);
    // No point is farther from its centre than half of the displacement to the next centre.
    for at in &points {
        let away = centers.points.iter().map(|center| {
            let [x, y] = TILE.shortest([at[0] - center[0], at[1] - center[1]]);
            libm::hypot(x, y)
        });
        assert!(away.fold(f64::INFINITY, f64::min) <= 30.0);
    }
}
