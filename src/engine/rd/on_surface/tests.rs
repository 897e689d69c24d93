//! Growth on small surfaces.

use std::sync::Arc;

use super::SurfaceGrowth;
use crate::grid::{Domain, Edges, Grid};
use crate::rd::sparse::SparseProblem;
use crate::rd::{
    Growth, Operators, ParameterField, Parameters, Solver, System, fineness, from_places, nuclei,
};
use crate::surface::test_meshes::{even_plate, sphere};
use crate::surface::{Mesh, Surface, SurfacePoint, remesh};

const FLAT: [[f64; 3]; 2] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

/// Parameters by vertex. Growth asks the domain for nothing else, where there are no obstacles.
fn maps(parameters: Vec<Parameters>) -> ParameterField {
    ParameterField::new(Grid::unit([parameters.len(), 1], Edges::Closed), parameters)
}

fn uneven(vertex: usize) -> f32 {
    libm::sinf(12.9 * vertex as f32)
}

/// A growth on a sphere, whose parameters and concentrations differ from vertex to vertex.
fn uneven_growth(system: System) -> SurfaceGrowth {
    let mesh = sphere(18, 1.0);
    let count = mesh.positions.len();
    let parameters = (0..count).map(|vertex| Parameters {
        rate: system.definition().usual_rate * (1.0 + 0.2 * uneven(vertex)),
        ratio: 20.0 + 4.0 * uneven(vertex + 7),
        stretch: 0.6 + 0.3 * uneven(vertex / 9),
        direction: 40.0 * uneven(vertex / 5),
        pitch: 1.0,
    });
    let maps = maps(parameters.collect());
    let operators = Arc::new(Operators::new(system, &mesh, &vec![FLAT; count], &maps.parameters));
    let chemicals = 0..system.chemicals().len();
    let begin: Vec<Vec<f32>> =
        chemicals.map(|k| (0..count).map(|vertex| 1.5 + uneven(vertex + 99 * k)).collect()).collect();
    SurfaceGrowth::new(system, &maps, operators, &begin).expect("it grows on surfaces")
}

const SYSTEMS: [System; 3] = [System::MEINHARDT_SPOTS, System::TURING_SPOTS, System::MEINHARDT_STRIPES];

#[test]
fn all_solvers_grow_the_same_bits_on_one_thread_and_on_three() {
    for system in SYSTEMS {
        let start = uneven_growth(system);
        for stages in [1, 3] {
            let start = start.clone().with_stages(stages);
            let mut plain = start.clone();
            plain.advance_plain(12);
            let wanted = plain.concentrations();
            assert!(
                wanted != start.concentrations() && wanted.iter().flatten().all(|value| value.is_finite())
            );
            for threads in [1, 3] {
                let pool =
                    rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads start");
                for solver in Solver::available() {
                    let mut fast = start.clone();
                    pool.install(|| fast.advance_as(12, solver));
                    assert!(fast.concentrations() == wanted, "{system:?} {solver:?} {stages} {threads}");
                    assert_eq!(fast.steps(), plain.steps());
                }
            }
        }
    }
}

#[test]
fn concentrations_that_are_the_same_everywhere_stay_the_same_everywhere() {
    let mesh = sphere(10, 2.0);
    let count = mesh.positions.len();
    let p = Parameters { rate: 40.0, ratio: 20.0, stretch: 0.4, direction: 30.0, pitch: 1.0 };
    let system = System::MEINHARDT_STRIPES;
    let maps = maps(vec![p; count]);
    let operators = Arc::new(Operators::new(system, &mesh, &vec![FLAT; count], &maps.parameters));
    let begin: Vec<Vec<f32>> = [1.1, 0.9, 0.3, 1.0, 1.0].map(|value| vec![value; count]).into();
    let mut growth = SurfaceGrowth::new(system, &maps, operators, &begin).expect("it grows on surfaces");
    growth.advance(30);
    for (after, before) in growth.concentrations().iter().zip(&begin) {
        assert!(after.iter().all(|value| *value == after[0]) && after[0] != before[0]);
    }
}

/// Area, aspect and direction (degrees) of the part of values above ½, by moments, of cells of an area at these places.
fn moments(values: &[f32], places: impl Iterator<Item = [f64; 2]>, cell: f64) -> [f64; 3] {
    // A soft edge instead of whole cells: a cell at the edge counts in part.
    let weight = |value: f32| f64::from(((value - 0.5) / 0.2 + 0.5).clamp(0.0, 1.0));
    let all: Vec<(f64, [f64; 2])> =
        values.iter().map(|value| weight(*value)).zip(places).filter(|(weight, _)| *weight > 0.0).collect();
    let mean = |of: &dyn Fn(&[f64; 2]) -> f64| {
        let total: f64 = all.iter().map(|(weight, _)| weight).sum();
        all.iter().map(|(weight, at)| weight * of(at)).sum::<f64>() / total
    };
    let [x, y] = [mean(&|at| at[0]), mean(&|at| at[1])];
    let xx = mean(&|at| (at[0] - x) * (at[0] - x));
    let xy = mean(&|at| (at[0] - x) * (at[1] - y));
    let yy = mean(&|at| (at[1] - y) * (at[1] - y));
    let (half, apart) = (0.5 * (xx + yy), (0.25 * (xx - yy) * (xx - yy) + xy * xy).sqrt());
    let area = cell * all.iter().map(|(weight, _)| weight).sum::<f64>();
    let aspect = ((half - apart) / (half + apart)).sqrt();
    [area, aspect, 0.5 * crate::grid::atan2(2.0 * xy, xx - yy).to_degrees()]
}

#[test]
fn a_spot_on_a_plate_has_the_area_shape_and_direction_of_one_on_a_grid() {
    let system = System::MEINHARDT_SPOTS;
    let mut seen = Vec::new();
    for (stretch, direction) in [(1.0, 0.0), (0.5, 25.0), (0.5, -70.0)] {
        let p = Parameters { rate: 3.0, ratio: 15.0, stretch, direction, pitch: 1.0 };
        let size = [56, 56];
        let flat = ParameterField::uniform(size, Edges::Closed, p);
        let begin = from_places(system, &flat, &[[28.0, 28.0]], &|_| false);
        let mut on_grid = Growth::resumed(system, &flat, begin.clone()).expect("as many as cells");
        on_grid.advance(on_grid.steps_in(25.0));
        let grid_places = (0..56 * 56).map(|cell| [(cell % 56) as f64 + 0.5, (cell / 56) as f64 + 0.5]);
        let wanted = moments(&on_grid.marks().values, grid_places, 1.0);

        // Triangles as large as half a square: lengths in cells are the same.
        let side = (2.0 / 3.0f64.sqrt()).sqrt();
        let mesh = even_plate([56.0; 2], side);
        let vertices = mesh.positions.len();
        // A mean cell is a little smaller than one of the grid: those at the border are halves.
        let cell = mesh.area() / vertices as f64;
        let plate = maps(vec![Parameters { rate: p.rate * cell as f32, ..p }; vertices]);
        let operators = Arc::new(Operators::new(system, &mesh, &vec![FLAT; vertices], &plate.parameters));
        let at = |place: &[f64; 3]| flat.domain.cell_at([place[0], place[1]]);
        let begin: Vec<Vec<f32>> =
            begin.iter().map(|of| mesh.positions.iter().map(|place| of[at(place)]).collect()).collect();
        let mut growth = SurfaceGrowth::new(system, &plate, operators, &begin).expect("it grows on surfaces");
        growth.advance(growth.steps_in(25.0));
        let cell = 2.0 * mesh.area() / mesh.faces.len() as f64;
        let plate_places = mesh.positions.iter().map(|[x, y, _]| [*x, *y]);
        let found = moments(&growth.marks(), plate_places, cell);
        assert!(
            (found[0] / wanted[0] - 1.0).abs() < 0.03,
            "{stretch} {direction}°: {found:?} for {wanted:?}"
        );
        assert!((found[1] - wanted[1]).abs() < 0.02, "{stretch} {direction}°: {found:?} for {wanted:?}");
        assert!(
            stretch == 1.0 || (found[2] - wanted[2]).abs() < 1.0,
            "{direction}°: {found:?} for {wanted:?}"
        );
        seen.push(found[1]);
    }
    assert!(seen[0] > 0.95 && seen[1] < 0.6, "{seen:?}");
}

/// A sphere of radius 1 remeshed so that this many spots have `fineness` vertices a spacing, and the parameters of these.
fn sphere_of(spots: f64, fineness: f64, stretch: f32) -> ParameterField<Surface> {
    let ball = sphere(24, 1.0);
    let spacing = (ball.area() / spots * 2.0 / 3.0f64.sqrt()).sqrt();
    let edge = spacing / fineness * (2.0 / 3.0f64.sqrt()).sqrt();
    let surface = Surface::new(remesh(&ball, &|_| edge), [0.0, 0.0, 1.0]);
    let one = Parameters { rate: 1.0, ratio: 15.0, stretch, direction: 0.0, pitch: 1.0 };
    let apart = System::MEINHARDT_SPOTS.spacing(&one) * surface.unit() / spacing;
    let vertices = surface.mesh.positions.len();
    ParameterField::new(surface, vec![Parameters { rate: (apart * apart) as f32, ..one }; vertices])
}

#[test]
fn spots_on_a_sphere_all_live_and_have_the_area_of_flat_ones() {
    let system = System::MEINHARDT_SPOTS;
    // Places need no fine mesh.
    let coarse = sphere_of(40.0, 5.0, 1.0);
    let maps = sphere_of(40.0, 12.0, 1.0);
    let places = nuclei(system, &coarse, 2, &[]).inside;
    let places: Vec<SurfacePoint> =
        places.iter().map(|at| maps.domain.closest(coarse.domain.position(*at))).collect();
    let begin = from_places(system, &maps, &places, &|_| false);
    let surface = &maps.domain;
    let operators = Arc::new(Operators::new(system, &surface.mesh, surface.frames(), &maps.parameters));
    let mut growth = SurfaceGrowth::new(system, &maps, operators, &begin).expect("it grows on surfaces");
    growth.advance(growth.steps_in(40.0));
    let marks = growth.marks();
    let is_peak = |vertex: &usize| {
        marks[*vertex] > 0.5 && surface.ring(*vertex).all(|other| marks[other] < marks[*vertex])
    };
    let peaks = (0..marks.len()).filter(is_peak).count();
    assert!(places.len().abs_diff(40) <= 2 && peaks == places.len(), "{peaks} of {}", places.len());
    // A soft edge instead of parts of triangles.
    let weight = |value: f32| f64::from(((value - 0.5) / 0.2 + 0.5).clamp(0.0, 1.0));
    let covered: f64 =
        marks.iter().enumerate().map(|(vertex, mark)| weight(*mark) * surface.cell_area(vertex)).sum();
    let found = covered / surface.mesh.area() * 0.75f64.sqrt();
    // On flat lattices that are endlessly fine, area ÷ spacing² is 0.0988 (`training/fineness.csv`).
    let wanted = 0.0988 * fineness(system, 15.0, 12.0, 1.0).linear;
    assert!((found / wanted - 1.0).abs() < 0.04, "{found} for {wanted}");
}

#[test]
fn the_solver_takes_less_than_200_bytes_a_vertex() {
    let system = System::MEINHARDT_SPOTS;
    let maps = sphere_of(100.0, 12.0, 0.6);
    let surface = &maps.domain;
    let operators = Arc::new(Operators::new(system, &surface.mesh, surface.frames(), &maps.parameters));
    let begin = vec![vec![1.0; maps.parameters.len()]; 2];
    let growth = SurfaceGrowth::new(system, &maps, operators, &begin).expect("it grows on surfaces");
    let SparseProblem { operators, mobility, rate, .. } = &growth.problem;
    let of_rows = operators.rows.iter().map(|rows| {
        size_of_val(&rows.starts[..]) + size_of_val(&rows.columns[..]) + size_of_val(&rows.weights[..])
    });
    let of_slices = operators
        .slices
        .iter()
        .map(|slices| size_of_val(&slices.starts[..]) + size_of_val(&slices.columns[..]));
    let of_coefficients = [&mobility[0], &mobility[1], rate].map(|numbers| size_of_val(&numbers[..]));
    let of_order = size_of_val(&operators.order[..]);
    // Concentrations of now and before, and those at the centres of marks; which vertices are masked.
    let of_states = (2 * begin.len() * size_of::<f32>() + size_of::<f32>() + size_of::<bool>()) * rate.len();
    let all = of_rows.chain(of_slices).chain(of_coefficients).sum::<usize>() + of_order + of_states;
    let one = all as f64 / maps.parameters.len() as f64;
    assert!((100.0..200.0).contains(&one), "{one}");
}

#[test]
fn frozen_vertices_keep_their_concentrations_and_others_change() {
    let mut growth = uneven_growth(System::MEINHARDT_SPOTS);
    let before = growth.concentrations();
    growth.problem.freeze(|vertex| vertex % 5 == 0);
    let (mut marks, count) = (growth.marks(), vec![true; before[0].len()]);
    let shown = marks.clone();
    assert_eq!(growth.update_marks(&mut marks, &count)[0], 0.0);
    growth.advance(20);
    assert!(growth.update_marks(&mut marks, &count)[0] > 0.0 && marks == growth.marks());
    assert!(marks.iter().zip(&shown).step_by(5).all(|(after, before)| after == before));
    for (after, before) in growth.concentrations().iter().zip(&before) {
        for (vertex, (after, before)) in after.iter().zip(before).enumerate() {
            assert_eq!(after == before, vertex % 5 == 0, "{vertex}");
        }
    }
}

#[test]
fn what_does_not_fit_the_surface_begins_no_growth() {
    let mesh: Mesh = sphere(2, 1.0);
    let count = mesh.positions.len();
    let p = Parameters { rate: 2.0, ratio: 20.0, stretch: 1.0, direction: 0.0, pitch: 1.0 };
    let spots = System::MEINHARDT_SPOTS;
    let operators = Arc::new(Operators::new(spots, &mesh, &vec![FLAT; count], &vec![p; count]));
    let begins = |system: System, vertices: usize, begin: Vec<Vec<f32>>| {
        SurfaceGrowth::new(system, &maps(vec![p; vertices]), operators.clone(), &begin).is_some()
    };
    assert!(begins(spots, count, vec![vec![1.0; count]; 2]));
    assert!(!begins(spots, count, vec![vec![1.0; count]; 3]));
    assert!(!begins(spots, count, vec![vec![1.0; count + 1]; 2]));
    assert!(!begins(spots, count + 1, vec![vec![1.0; count]; 2]));
    assert!(!begins(spots, count, Vec::new()));
    assert!(!begins(System::MEINHARDT_LINES, count, vec![vec![1.0; count]; 2]));
    // These need another Laplacian for what spreads the same in all directions.
    assert!(!begins(System::MEINHARDT_STRIPES, count, vec![vec![1.0; count]; 5]));
}
