//! The steps around the growth, from the plan to the picture: placing nuclei, measuring, resampling, colours, PNG.
//! Described in README.md.

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main};
use dapple_engine::colour::{Gradient, Painted, paint};
use dapple_engine::export::png;
use dapple_engine::grid::Field;
use dapple_engine::grid::resample::Spline;
use dapple_engine::measure;
use dapple_engine::rd::benchmark::Case;
use dapple_engine::rd::{Growth, nuclei};
use std::hint::black_box;
use std::time::Duration;

/// px along each side of the pictures.
const SIDE: usize = 1024;

/// A group whose benchmarks are short, and work on [`SIDE`]² px unless it says otherwise.
fn group<'a>(criterion: &'a mut Criterion, name: &str) -> BenchmarkGroup<'a, WallTime> {
    let mut group = criterion.benchmark_group(name);
    group.sample_size(10);
    group.warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_millis(1500));
    group.throughput(Throughput::Elements((SIDE * SIDE) as u64));
    group
}

/// A grown pattern of marks whose direction changes, with one cell per px.
fn grown(case: Case) -> Field {
    let maps = case.maps(SIDE);
    let mut growth = Growth::new(case.system, &maps, 1);
    growth.advance(growth.steps_in(10.0));
    growth.marks()
}

fn beginning(criterion: &mut Criterion) {
    let mut group = group(criterion, "begin");
    let case = Case::ALL[4];
    let maps = case.maps(SIDE);
    group.bench_function("nuclei", |bencher| {
        bencher.iter(|| nuclei(case.system, black_box(&maps), 1, &[]));
    });
}

fn ruler(criterion: &mut Criterion) {
    let [spots, stripes] = [grown(Case::ALL[4]), grown(Case::ALL[7])];
    let mut group = group(criterion, "ruler");
    group.measurement_time(Duration::from_millis(3000));
    group.bench_function("spots", |bencher| bencher.iter(|| measure::spots(black_box(&spots), 0.5)));
    group.bench_function("stripes", |bencher| bencher.iter(|| measure::stripes(black_box(&stripes), 0.5)));
    group.finish();
    pictures(criterion, &spots);
}

/// Outputs of a grown field.
fn pictures(criterion: &mut Criterion, pattern: &Field) {
    let mut resampling = group(criterion, "resample");
    resampling.bench_function("same size", |bencher| {
        bencher.iter(|| Spline::new(black_box(pattern)).rows(0..SIDE, SIDE, SIDE));
    });
    resampling.throughput(Throughput::Elements((4 * SIDE * SIDE) as u64));
    resampling.bench_function("twice the size", |bencher| {
        bencher.iter(|| Spline::new(black_box(pattern)).rows(0..2 * SIDE, 2 * SIDE, 2 * SIDE));
    });
    resampling.finish();

    let mut colours = group(criterion, "colour");
    let gradient = Gradient::default_for_layer(0);
    let table = gradient.table();
    // The exact colours, px by px, for comparison with the table; an eighth of the px is enough.
    let some = &pattern.values[..SIDE * SIDE / 8];
    colours.throughput(Throughput::Elements(some.len() as u64));
    colours.bench_function("exact", |bencher| {
        bencher.iter(|| some.iter().flat_map(|v| gradient.colour(*v)).collect::<Vec<u8>>());
    });
    colours.throughput(Throughput::Elements((SIDE * SIDE) as u64));
    let layers = [Painted { ground: None, pattern, free: None, table: &table, visible: true }];
    colours.bench_function("table", |bencher| bencher.iter(|| paint(black_box(&layers), SIDE, SIDE)));
    colours.throughput(Throughput::Elements(1 << 16));
    colours.bench_function("make the table", |bencher| bencher.iter(|| black_box(&gradient).table()));
    colours.finish();

    let mut writing = group(criterion, "png");
    let rgb = paint(&layers, SIDE, SIDE);
    writing.bench_function("8-bit colour", |bencher| {
        bencher.iter(|| written(|bytes| png::rgb8(bytes, [SIDE, SIDE], None, black_box(&rgb))));
    });
    writing.bench_function("16-bit gray", |bencher| {
        bencher.iter(|| written(|bytes| png::gray16(bytes, black_box(pattern), None)));
    });
}

/// The bytes that `write` writes.
fn written(write: impl FnOnce(&mut Vec<u8>) -> Result<(), dapple_engine::export::Stopped>) -> Vec<u8> {
    let mut bytes = Vec::new();
    write(&mut bytes).expect("memory can be written");
    bytes
}

criterion_group!(benches, beginning, ruler);
criterion_main!(benches);
