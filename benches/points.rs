//! Fields from scattered points: the interpolation, plain and fast, and the steps before it. Described in README.md.

use std::hint::black_box;
use std::time::Duration;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use dapple_engine::attributes::Spread;
use dapple_engine::grid::{Edges, Field, Grid};
use dapple_engine::points::delaunay::Delaunay;
use dapple_engine::points::discs::poisson_discs;
use dapple_engine::points::extent::Extent;
use dapple_engine::points::interpolation::{Weights, interpolate};
use dapple_engine::points::metric::Metric;
use dapple_engine::points::patches::{Patches, Wanted};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use rayon::ThreadPoolBuilder;

/// px along each side: the size that the paper measured.
const SIDE: usize = 1000;
/// Radius of the discs, px: with it there are 725 points, as many as in the paper.
const RADIUS: f64 = 31.0;

/// The interpolation computed directly from the equations: for each point and its images, one px after the other in the
/// box around its support.
fn plain(graph: &Delaunay, values: &[f32], grid: &Grid, length: f64) -> Field {
    let [nx, ny] = grid.size;
    let mut sums = vec![[0.0f64; 2]; nx * ny];
    for (point, center) in graph.points.iter().enumerate() {
        let [mut low, mut high] = [*center; 2];
        for corner in graph.cell(point) {
            low = [0, 1].map(|axis| low[axis].min(center[axis] + 2.0 * length * corner[axis]));
            high = [0, 1].map(|axis| high[axis].max(center[axis] + 2.0 * length * corner[axis]));
        }
        for y in low[1].floor() as isize..=high[1].ceil() as isize {
            for x in low[0].floor() as isize..=high[0].ceil() as isize {
                let way = [x as f64 + 0.5 - center[0], y as f64 + 0.5 - center[1]];
                let mut weight = 1.0;
                for axis in graph.axes(point) {
                    let square = axis.displacement[0] * axis.displacement[0]
                        + axis.displacement[1] * axis.displacement[1];
                    let p =
                        (way[0] * axis.displacement[0] + way[1] * axis.displacement[1]) / (length * square);
                    let p = p.clamp(0.0, 1.0);
                    weight *= (1.0 - p) * (1.0 - p) * (1.0 + 2.0 * p);
                }
                let [sum, total] = &mut sums[grid.edges.index(y, ny) * nx + grid.edges.index(x, nx)];
                *sum += weight * f64::from(values[point]);
                *total += weight;
            }
        }
    }
    Field::new(grid, sums.into_iter().map(|[sum, total]| (sum / total) as f32).collect())
}

fn points(criterion: &mut Criterion) {
    let grid = Grid::unit([SIDE; 2], Edges::Wrap);
    let extent = Extent::from(grid.bounds_px());
    let lay = |radius: f64| {
        let mut rng = Pcg64Mcg::seed_from_u64(1);
        poisson_discs(&extent, 0.0, &|_| Metric::circle(radius), &[], &mut rng)
    };
    let scattered = lay(RADIUS);
    let graph = Delaunay::new(&scattered, extent);
    let mut rng = Pcg64Mcg::seed_from_u64(2);
    let values: Vec<f32> = scattered.iter().map(|_| rng.random()).collect();
    let weights = |length| Weights { length, ..Weights::default() };
    let [slow, fast] =
        [plain(&graph, &values, &grid, 1.0), interpolate(&graph, &values, &grid, &weights(1.0))];
    let apart = slow.values.iter().zip(&fast.values).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
    assert!(apart < 1e-4, "the plain and the fast interpolation are {apart} apart");
    let mut group = criterion.benchmark_group("points");
    group.sample_size(10);
    group.warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_millis(1500));
    group.throughput(Throughput::Elements((SIDE * SIDE) as u64));
    group.bench_function("plain", |bencher| bencher.iter(|| plain(black_box(&graph), &values, &grid, 1.0)));
    for (threads, name) in [(1, "fast"), (0, "fast, all threads")] {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build().expect("threads can be started");
        for length in [1.0, 2.0] {
            group.bench_function(format!("{name}, L = {length}"), |bencher| {
                pool.install(|| {
                    bencher.iter(|| interpolate(black_box(&graph), &values, &grid, &weights(length)));
                });
            });
        }
    }
    group.throughput(Throughput::Elements(lay(8.0).len() as u64));
    group.bench_function("discs", |bencher| bencher.iter(|| lay(black_box(8.0))));
    let many = lay(8.0);
    group.bench_function("graph", |bencher| bencher.iter(|| Delaunay::new(black_box(&many), extent)));
    let wanted = |_: [f64; 2]| Wanted {
        area: 1500.0,
        spacing: 70.0,
        aspect: 0.6,
        angle: 30.0,
        raggedness: 1.4,
        spread: Spread::ZERO,
    };
    let patches =
        Patches { grid, wanted: &wanted, kept: &[], blocked: None, detail: Patches::DETAIL, seed: 1 };
    group.throughput(Throughput::Elements((SIDE * SIDE) as u64));
    group.bench_function("patches", |bencher| bencher.iter(|| black_box(&patches).grow()));
}

criterion_group!(benches, points);
criterion_main!(benches);
