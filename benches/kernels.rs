//! Time steps of the solvers: naive, plain, fast on one thread, fast on all threads. Described in README.md.

mod naive;

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use dapple_engine::rd::benchmark::{Case, Start};
use naive::Naive;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::time::Duration;

/// Steps that are timed together: the number that the fast solver takes in one sweep.
const STEPS: u64 = 16;

/// Cells along each side: a grid that fits into the cache of one core, and one that does not.
const SIZES: [usize; 2] = [256, 1024];

fn kernels(criterion: &mut Criterion) {
    for case in [0, 1, 2, 4, 7].map(|index| Case::ALL[index]) {
        let mut group = criterion.benchmark_group(case.name());
        group.sample_size(10);
        group.warm_up_time(Duration::from_millis(200)).measurement_time(Duration::from_millis(600));
        let start = case.start();
        for size in SIZES {
            solvers(&mut group, case, &start, size);
        }
    }
}

fn solvers(group: &mut BenchmarkGroup<WallTime>, case: Case, start: &Start, size: usize) {
    let maps = case.maps(size);
    let growth = case.growth(start, &maps).expect("the case's own start");
    let cells = (size * size) as u64;
    let id = |name: &str| BenchmarkId::new(name, size);
    if case == Case::ALL[0] {
        let mut naive = Naive::beside(&growth, size, maps.parameters[0].rate);
        naive.check(&growth);
        group.throughput(Throughput::Elements(cells));
        group.bench_function(id("naive"), |bencher| bencher.iter(|| naive.advance(1)));
    }
    let one = pool(1);
    group.throughput(Throughput::Elements(cells));
    let mut plain = growth.clone();
    group.bench_function(id("plain"), |bencher| one.install(|| bencher.iter(|| plain.advance_plain(1))));
    group.throughput(Throughput::Elements(cells * STEPS));
    let mut fast = growth;
    group.bench_function(id("fast"), |bencher| one.install(|| bencher.iter(|| fast.advance(STEPS))));
    let all = pool(0);
    group.bench_function(id("fast, all threads"), |bencher| {
        all.install(|| bencher.iter(|| fast.advance(STEPS)));
    });
}

fn pool(threads: usize) -> ThreadPool {
    ThreadPoolBuilder::new().num_threads(threads).build().expect("threads can be started")
}

criterion_group!(benches, kernels);
criterion_main!(benches);
