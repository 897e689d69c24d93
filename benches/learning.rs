//! The training sets: answering a question, and reading a set. Described in README.md.

use criterion::{Criterion, criterion_group, criterion_main};
use dapple::files::TrainingFolder;
use dapple_engine::attributes::{Attributes, Spots, Stripes};
use dapple_engine::learn::{InCells, Parameters, Row, TrainingSet, write_rows};
use dapple_engine::rd::System;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use std::hint::black_box;
use std::time::Duration;

/// Rows of the largest generated set.
const ROWS: u64 = 9_000;

/// Rows of Meinhardt spots from the scaling laws (facts B), with the noise of 80 spots.
fn rows() -> Vec<Row> {
    let row = |seed| {
        let rng = &mut Pcg64::seed_from_u64(seed);
        let mut between = |low: f64, high: f64| low + (high - low) * rng.random::<f64>();
        let ratio = libm::exp(between(libm::log(12.0), libm::log(70.0)));
        let level = if seed % 10 < 3 { between(0.27, 0.5) } else { 0.5 };
        let area = libm::exp(between(libm::log(18.0), libm::log(150.0)));
        let (stretch, direction) = (between(0.26, 1.0), between(0.0, 180.0));
        let density = 1.41 / ratio * libm::exp(2.8 * (0.5 - level));
        let spots = Spots {
            area: area * between(0.98, 1.02),
            aspect: 0.99 * stretch,
            angle: (direction + between(-0.5, 0.5)).rem_euclid(180.0),
            spacing: Some((area / density).sqrt() * between(0.98, 1.02)),
        };
        let rate = 1_387.0 * density * (1.0 - 1.2 / area) / area;
        Row {
            seed,
            extent: 80.0,
            evenness: 0.05,
            attributes: InCells(Attributes::Spots(spots)),
            parameters: Parameters { rate, ratio: Some(ratio), stretch, direction, level: Some(level) },
        }
    };
    (0..ROWS).map(row).collect()
}

fn learning(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("learning");
    group.sample_size(20);
    group.warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_millis(1500));

    let stripes = InCells(Attributes::Stripes(Stripes { width: 8.0, angle: 30.0, wavelength: None }));
    let spots = |density: f64, aspect: f64| {
        let spacing = Some((60.0 / density).sqrt());
        InCells(Attributes::Spots(Spots { area: 60.0, aspect, angle: 30.0, spacing }))
    };
    let built_in = |system: System| TrainingSet::embedded(system.description()).expect("the set is built in");
    let swept =
        TrainingSet::from_rows(System::MEINHARDT_SPOTS.description(), rows()).expect("the rows are good");
    let questions = [
        ("turing-spots", &built_in(System::TURING_SPOTS), spots(0.22, 0.6)),
        ("meinhardt-spots", &built_in(System::MEINHARDT_SPOTS), spots(0.1, 0.6)),
        ("meinhardt-stripes", &built_in(System::MEINHARDT_STRIPES), stripes),
        ("9000 rows", &swept, spots(0.1, 0.6)),
    ];
    for (name, set, wanted) in &questions {
        group.bench_function(format!("ask {name}"), |bencher| bencher.iter(|| set.ask(black_box(wanted))));
    }
    // Attributes that a user may draw: inside the set, at its edge, round, in a corner of it, outside it.
    for (name, density, aspect) in
        [("round", 0.1, 1.0), ("in a corner", 0.021, 0.27), ("beyond", 0.9, 0.1), ("dense", 0.2, 0.5)]
    {
        let wanted = spots(density, aspect);
        group.bench_function(format!("ask 9000 rows, {name}"), |bencher| {
            bencher.iter(|| swept.ask(black_box(&wanted)));
        });
    }
    group.bench_function("read meinhardt-spots", |bencher| {
        bencher.iter(|| TrainingSet::embedded(black_box(System::MEINHARDT_SPOTS.description())));
    });
    let folder = tempfile::tempdir().expect("there is room for a file");
    let file = std::fs::File::create(folder.path().join("meinhardt-spots.csv")).expect("a file can be made");
    write_rows(System::MEINHARDT_SPOTS.description(), &rows(), file).expect("a file can be written");
    let files = TrainingFolder::new(folder.path());
    group.bench_function("read 9000 rows", |bencher| {
        bencher.iter(|| TrainingSet::load(&files, black_box(System::MEINHARDT_SPOTS.description()), &[]));
    });
}

criterion_group!(benches, learning);
criterion_main!(benches);
