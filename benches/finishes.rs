//! Every finish of a picture of 256 × 256 px, at scales 1 and 4, on one thread. Described in README.md.

use std::time::Duration;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use dapple_engine::finish::{Finish, Flow, Kind, Source};
use dapple_engine::grid::Edges;
use rayon::ThreadPoolBuilder;

/// px of the picture along each side, at every scale.
const SIDE: usize = 256;
/// The distance of two marks, and their radius, px of the canvas.
const SPACING: f32 = 32.0;
const RADIUS: f32 = 9.0;

/// The labels of round marks on a tile, `scale` px along each px of the canvas.
fn labels(side: usize, scale: usize) -> Vec<u8> {
    let is_mark = |px: usize| {
        let [x, y] =
            [px % side, px / side].map(|at| (at as f32 + 0.5) / scale as f32 % SPACING - 0.5 * SPACING);
        x * x + y * y < RADIUS * RADIUS
    };
    (0..side * side).map(|px| u8::from(is_mark(px))).collect()
}

fn finishes(criterion: &mut Criterion) {
    let one = ThreadPoolBuilder::new().num_threads(1).build().expect("threads can be started");
    for scale in [1, 4] {
        let canvas = SIDE / scale;
        let (marks, of_canvas) = (labels(SIDE, scale), labels(canvas, 1));
        let colour = |label: &u8| if *label > 0 { [40, 26, 18] } else { [226, 190, 130] };
        let rgb: Vec<u8> = marks.iter().flat_map(colour).collect();
        let mut group = criterion.benchmark_group(format!("finish/scale-{scale}"));
        group.sample_size(10);
        group.warm_up_time(Duration::from_millis(200)).measurement_time(Duration::from_millis(800));
        group.throughput(Throughput::Elements((SIDE * SIDE) as u64));
        for (name, kind) in Kind::NAMES {
            let finish = Finish::new(kind);
            let reach = finish.reach(&of_canvas, [canvas; 2], Edges::Wrap);
            let source = Source {
                size: [SIDE; 2],
                canvas: [canvas as f32; 2],
                edges: Edges::Wrap,
                rgb: &rgb,
                labels: &marks,
                flow: &Flow::uniform(190.0),
                reach: &reach,
                seed: 5,
            };
            group.bench_function(BenchmarkId::from_parameter(name), |bencher| {
                one.install(|| bencher.iter(|| finish.paint(&source)));
            });
        }
    }
}

criterion_group!(benches, finishes);
criterion_main!(benches);
