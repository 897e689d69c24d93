//! Steps on a surface: plain, and by slices with each instruction set, on one thread; slices on all threads. Described
//! in README.md.

use std::sync::Arc;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use dapple_engine::rd::{
    Operators, ParameterField, Parameters, Solver, SurfaceGrowth, System, from_places, nuclei,
};
use dapple_engine::surface::{Mesh, Surface, remesh};
use rayon::ThreadPoolBuilder;

/// Steps that are timed together: whole super steps.
const STEPS: u64 = 12;
/// Vertices of the mesh, for about 220 spots.
const VERTICES: f64 = 50_000.0;
/// Spacing of the spots, in vertices.
const SPACING: f64 = 15.0;

/// An octahedron with edges of √2.
fn octahedron() -> Mesh {
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let positions = axes.into_iter().chain(axes.map(|axis| axis.map(|along: f64| -along))).collect();
    let faces = [[0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2], [1, 0, 5], [3, 1, 5], [4, 3, 5], [0, 4, 5]];
    Mesh { positions, faces: faces.into() }
}

/// A growth of spots at its start, with this stretch.
fn start(stretch: f32) -> SurfaceGrowth {
    let system = System::MEINHARDT_SPOTS;
    let (body, cell) = (octahedron(), 4.0 * 3.0f64.sqrt() / VERTICES);
    let surface = |coarser: f64| {
        let edge = coarser * (2.0 / 3.0f64.sqrt() * cell).sqrt();
        Surface::new(remesh(&body, &|_| edge), [0.0, 0.0, 1.0])
    };
    let maps = |surface: Surface, spacing: f64| {
        let one = Parameters { rate: 1.0, ratio: 15.0, stretch, direction: 30.0, pitch: 1.0 };
        let apart = system.spacing(&one) / spacing;
        let own = Parameters { rate: (apart * apart) as f32, ..one };
        let vertices = surface.mesh.positions.len();
        ParameterField::new(surface, vec![own; vertices])
    };
    // Placing spots does not need a fine mesh.
    let (coarse, fine) = (maps(surface(3.0), SPACING / 3.0), maps(surface(1.0), SPACING));
    let places = nuclei(system, &coarse, 1, &[]).inside;
    let places: Vec<_> = places.iter().map(|at| fine.domain.closest(coarse.domain.position(*at))).collect();
    let begin = from_places(system, &fine, &places, &|_| false);
    let operators = Operators::new(system, &fine.domain.mesh, fine.domain.frames(), &fine.parameters);
    SurfaceGrowth::new(system, &fine, Arc::new(operators), &begin).expect("spots grow on surfaces")
}

fn steps(criterion: &mut Criterion) {
    let pool =
        |threads| ThreadPoolBuilder::new().num_threads(threads).build().expect("threads can be started");
    let (one, all) = (pool(1), pool(0));
    for stretch in [1.0, 0.5] {
        let mut group = criterion.benchmark_group(format!("surface/aspect-{stretch}"));
        group.sample_size(10);
        group.warm_up_time(Duration::from_millis(200)).measurement_time(Duration::from_millis(600));
        let mut growth = start(stretch);
        group.throughput(Throughput::Elements(growth.marks().len() as u64 * STEPS));
        for solver in Solver::available() {
            group.bench_function(BenchmarkId::from_parameter(solver.name()), |bencher| {
                one.install(|| bencher.iter(|| growth.advance_as(STEPS, solver)));
            });
        }
        group.bench_function("all threads", |bencher| {
            all.install(|| bencher.iter(|| growth.advance(STEPS)));
        });
    }
}

criterion_group!(benches, steps);
criterion_main!(benches);
