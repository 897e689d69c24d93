//! Nuclei, initial conditions and masks on domains other than grids.

use super::*;
use crate::grid::relabelled::{Point, Relabelled};
use crate::grid::sphere::Sphere;
use crate::grid::{Domain, Edges, Grid};
use crate::rd::nucleus::Nucleus;
use crate::surface::test_meshes::{cylinder, slab, sphere as sphere_mesh};
use crate::surface::{LocalMap, Surface, SurfacePoint};

const SYSTEM: System = System::MEINHARDT_SPOTS;
const SIZE: [usize; 2] = [96, 84];

/// Sides of a cell. Rotated frames need one unit of length along both axes.
const SQUARE: [f64; 2] = [1.0; 2];
/// Unequal sides of a cell, as on most canvases.
const OBLONG: [f64; 2] = [1.0, 1.01];

/// Parameters that differ from cell to cell, on a grid of cells with these sides, and on one with renumbered cells in the frames
/// that `frame` gives, degrees.
fn pair(
    edges: Edges,
    obstacles: bool,
    cell: [f64; 2],
    frame: fn(usize) -> f64,
) -> (ParameterField, ParameterField<Relabelled>) {
    let grid = Grid { cell, ..Grid::unit(SIZE, edges) };
    let parameters = (0..grid.cells()).map(|cell| {
        let [x, y] = grid.center(cell);
        let rate = (7.0 + 2.0 * x / 96.0) as f32;
        let (stretch, direction) = ((0.6 + 0.3 * y / 84.0) as f32, (20.0 + 0.5 * x) as f32);
        Parameters { rate, ratio: 20.0, stretch, direction, pitch: 1.0 }
    });
    let mut flat = ParameterField::new(grid, parameters.collect());
    if obstacles {
        flat.obstacles = (0..grid.cells()).map(|cell| cell % 96 / 9 == 5 && cell / 96 > 20).collect();
    }
    let domain = Relabelled::new(grid, &flat.obstacles, frame);
    let parameters = domain.renumbered(&flat.parameters);
    let parameters = parameters.iter().zip(&domain.frames).map(|(p, frame)| p.turned(-frame)).collect();
    let obstacles = domain.renumbered(&flat.obstacles);
    (flat, ParameterField { obstacles, ..ParameterField::new(domain, parameters) })
}

fn same_frames(_: usize) -> f64 {
    0.0
}

fn other_frames(cell: usize) -> f64 {
    (cell % 7) as f64 * 51.0
}

fn pinned(at: [f64; 2], maps: &ParameterField) -> PinnedSpot {
    PinnedSpot { at, own: maps.at(at), near: 0.6 }
}

/// These spots in the frames of their places.
fn relabelled(spots: &[PinnedSpot], maps: &ParameterField<Relabelled>) -> Vec<PinnedSpot<Point>> {
    let spot = |spot: &PinnedSpot| {
        let at = Point(spot.at);
        PinnedSpot { at, own: maps.at(at), near: spot.near }
    };
    spots.iter().map(spot).collect()
}

/// All functions about places of spots, with and without pinned ones; the results as coordinates.
fn places(flat: &ParameterField, other: &ParameterField<Relabelled>) -> [Vec<[f64; 2]>; 2] {
    let spots: Vec<PinnedSpot> =
        [[12.5, 20.25], [14.0, 22.0], [80.0, 60.5]].map(|at| pinned(at, flat)).into();
    let moved = relabelled(&spots, other);
    assert_eq!(
        placeable(SYSTEM, &flat.domain, &flat.obstacles, &spots),
        placeable(SYSTEM, &other.domain, &other.obstacles, &moved)
    );
    let keep = [0, 2];
    let (spots, moved): (Vec<_>, Vec<_>) = keep.map(|i| (spots[i], moved[i])).into_iter().unzip();
    let mut found = [Vec::new(), Vec::new()];
    for number in [0, 2] {
        let a = nuclei(SYSTEM, flat, 3, &spots[..number]);
        let b = nuclei(SYSTEM, other, 3, &moved[..number]);
        let counts = [&a.inside, &a.beyond].map(Vec::len);
        assert_eq!(counts, [&b.inside, &b.beyond].map(Vec::len));
        assert!(counts[0] > 20, "{counts:?}");
        let own: Vec<Parameters> = a.inside.iter().map(|at| flat.at(*at)).collect();
        let own_there: Vec<Parameters> = b.inside.iter().map(|at| other.at(*at)).collect();
        found[0].extend(a.inside.iter().chain(&a.beyond));
        found[0].extend(relax_places(SYSTEM, flat, &a, &own, 1.25, 12));
        found[0].extend(adjust_to_walls(SYSTEM, flat, a.inside));
        found[1].extend(b.inside.iter().chain(&b.beyond).map(|at| at.0));
        found[1].extend(relax_places(SYSTEM, other, &b, &own_there, 1.25, 12).iter().map(|at| at.0));
        found[1].extend(adjust_to_walls(SYSTEM, other, b.inside).iter().map(|at| at.0));
    }
    found
}

#[test]
fn nuclei_do_not_depend_on_the_numbers_of_the_cells() {
    for edges in [Edges::Closed, Edges::Wrap] {
        for obstacles in [false, true] {
            let (flat, other) = pair(edges, obstacles, OBLONG, same_frames);
            let [a, b] = places(&flat, &other);
            assert!(a == b, "{edges:?} {obstacles}");
        }
    }
}

/// The mean distance of these places to their nearest neighbour, cells.
fn mean_nearest(places: &[[f64; 2]]) -> f64 {
    let nearest = |(i, a): (usize, &[f64; 2])| {
        let others = places.iter().enumerate().filter(|(j, _)| *j != i);
        others.map(|(_, b)| (a[0] - b[0]).hypot(a[1] - b[1])).fold(f64::INFINITY, f64::min)
    };
    places.iter().enumerate().map(nearest).sum::<f64>() / places.len() as f64
}

#[test]
fn nuclei_are_as_many_and_as_far_apart_in_any_frames() {
    for edges in [Edges::Closed, Edges::Wrap] {
        for obstacles in [false, true] {
            let (flat, other) = pair(edges, obstacles, SQUARE, other_frames);
            // Directions are rounded differently, so that a few points on the border of a neighbourhood move differently.
            let a = nuclei(SYSTEM, &flat, 3, &[]);
            let b = nuclei(SYSTEM, &other, 3, &[]);
            let there: Vec<[f64; 2]> = b.inside.iter().map(|at| at.0).collect();
            let [count, also] = [a.inside.len(), there.len()];
            assert!(count > 20 && count.abs_diff(also) <= 3, "{edges:?} {obstacles}: {count} and {also}");
            let [apart, also] = [mean_nearest(&a.inside), mean_nearest(&there)];
            assert!((also / apart - 1.0).abs() < 0.05, "{edges:?} {obstacles}: {apart} and {also}");
        }
    }
}

#[test]
fn initial_conditions_and_masks_do_not_depend_on_the_numbers_of_the_cells() {
    for edges in [Edges::Closed, Edges::Wrap] {
        let (flat, other) = pair(edges, true, OBLONG, same_frames);
        for system in [System::MEINHARDT_SPOTS, System::TURING_SPOTS] {
            let at = [[12.5, 20.25], [80.0, 60.5], [1.0, 1.0], [4.0, 2.0]];
            let lost = |cell: usize| cell % 96 < 20;
            let a = from_places(system, &flat, &at, &lost);
            let b = from_places(system, &other, &at.map(Point), &|cell| lost(other.domain.old[cell]));
            assert!(a.len() == 2 && a[0].iter().any(|value| *value != a[0][0]));
            for (a, b) in a.iter().zip(&b) {
                let a = other.domain.renumbered(a);
                let differ = a.iter().zip(b).filter(|(a, b)| a != b);
                assert_eq!(
                    differ.clone().count(),
                    0,
                    "{edges:?} {system:?}: {:?}",
                    differ.take(5).collect::<Vec<_>>()
                );
            }
            let [a, b] = [growth::masked(system, &flat), growth::masked(system, &other)];
            assert!(other.domain.renumbered(&a) == b, "{edges:?} {system:?}");
            assert!(system == System::MEINHARDT_SPOTS || a != flat.obstacles);
        }
        let noise = |seed| flat.clone().with_decay_noise(System::TURING_SPOTS, 1.0, seed).decay_noise;
        let there = other.clone().with_decay_noise(System::TURING_SPOTS, 1.0, 4).decay_noise;
        assert!(other.domain.renumbered(&noise(4)) == there && noise(5) != noise(4));
    }
}

#[test]
fn values_of_spots_are_interpolated_and_spots_moved_in_the_frames_of_the_cells() {
    for (frame, far) in [(same_frames as fn(usize) -> f64, 0.0), (other_frames, 1e-4)] {
        let (flat, other) = pair(Edges::Wrap, true, SQUARE, frame);
        let at = [[12.5, 20.25], [80.0, 60.5], [1.0, 1.0]];
        let frames = at.map(|at| other.domain.frames[other.domain.cell_at(Point(at))]);
        let [own, own_there] = [at.map(|at| flat.at(at)), at.map(|at| other.at(Point(at)))];
        // A direction as a vector whose length is interpolated, too.
        let known = [[1.0, 0.5], [0.0, 2.0], [-1.0, 0.25]];
        let known_there: Vec<[f64; 2]> = known
            .iter()
            .zip(frames)
            .map(|(displacement, frame)| crate::grid::turned(*displacement, -frame))
            .collect();
        let vary = |_: usize, values: &[[f64; 2]], made: &mut [Parameters]| {
            for (made, [x, y]) in made.iter_mut().zip(values) {
                *made = Parameters { rate: *x as f32, ratio: *y as f32, ..own[0] };
            }
        };
        let turned = |displacement: &[f64; 2], degrees: f64| crate::grid::turned(*displacement, degrees);
        let spots: [Kernel; 3] =
            std::array::from_fn(|i| Kernel::new(SYSTEM, &flat.domain, at[i], &own[i], &own[i]));
        let spots_there: [Kernel<Point>; 3] = std::array::from_fn(|i| {
            Kernel::new(SYSTEM, &other.domain, Point(at[i]), &own_there[i], &own_there[i])
        });
        let [mut a, mut b] = [&flat.parameters, &other.parameters].map(Vec::clone);
        interpolate_parameters(&flat.domain, &spots, &known, turned, &vary, &|_| true, &mut a);
        interpolate_parameters(&other.domain, &spots_there, &known_there, turned, &vary, &|_| true, &mut b);
        for (cell, a) in a.iter().enumerate() {
            let number = other.domain.new[cell];
            let there = [f64::from(b[number].rate), f64::from(b[number].ratio)];
            let [x, y] = crate::grid::turned(there, other.domain.frames[number]);
            assert!((x - f64::from(a.rate)).abs() <= far && (y - f64::from(a.ratio)).abs() <= far, "{cell}");
        }
        let warps = |i: usize| LocalWarp { at: at[i], own: own[i], by: known[i] };
        let warps_there = |i: usize| LocalWarp { at: Point(at[i]), own: own_there[i], by: known_there[i] };
        let a = local_warp::shifts(SYSTEM, &flat, &[warps(0), warps(1)]);
        let mut b = local_warp::shifts(SYSTEM, &other, &[warps_there(0), warps_there(1)]);
        b.iter_mut().for_each(|(cell, by)| {
            *by = crate::grid::turned(*by, other.domain.frames[*cell]);
            *cell = other.domain.old[*cell];
        });
        b.sort_by_key(|(cell, _)| *cell);
        let near = |a: [f64; 2], b: [f64; 2]| (0..2).all(|i| (a[i] - b[i]).abs() <= far);
        assert!(a.len() > 30 && a.len() == b.len());
        assert!(a.iter().zip(&b).all(|(a, b)| a.0 == b.0 && near(a.1, b.1)));
    }
}

/// Spots that are 14 cells apart on a sphere.
fn sphere() -> ParameterField<Sphere> {
    let p = Parameters { rate: 1.0, ratio: 20.0, stretch: 1.0, direction: 0.0, pitch: 1.0 };
    let rate = (SYSTEM.spacing(&p) / 9.0).powi(2) as f32;
    let domain = Sphere { size: [90, 60] };
    let cells = domain.cells();
    ParameterField::new(domain, vec![Parameters { rate, ..p }; cells])
}

#[test]
fn on_a_sphere_nuclei_are_as_many_as_its_area_takes_and_keep_their_distance() {
    let maps = sphere();
    let pitch = SYSTEM.spacing(&maps.parameters[0]);
    let all = nuclei(SYSTEM, &maps, 2, &[]).inside;
    let wanted = (maps.domain.cells() as f64 * 2.0 / (3.0f64.sqrt() * pitch * pitch)).round() as usize;
    assert_eq!(all.len(), wanted);
    let nearest = |i: usize| {
        let others = (0..all.len()).filter(|j| *j != i);
        others.map(|j| maps.domain.distance(all[i], all[j]) / pitch).fold(f64::INFINITY, f64::min)
    };
    let distances: Vec<f64> = (0..all.len()).map(nearest).collect();
    let mean = distances.iter().sum::<f64>() / distances.len() as f64;
    let least = distances.iter().copied().fold(f64::INFINITY, f64::min);
    assert!(mean > 0.85 && least > 0.6, "mean {mean}, least {least}");
    // Half of the area of a sphere lies between the parallels of 30°, but only a third of these cells.
    let share = all.iter().filter(|at| at[2].abs() < 0.5).count() as f64 / all.len() as f64;
    assert!((share - 0.5).abs() < 0.08, "{share}");
}

#[test]
fn on_a_sphere_masks_grow_and_bells_fall_by_distance_across_the_pole() {
    let mut maps = sphere();
    let domain = maps.domain.clone();
    let cell = domain.cells() - 85;
    let set: Vec<bool> = (0..domain.cells()).map(|other| other == cell).collect();
    let dilated = domain.dilated(&set, |_| 6.0);
    for (other, is_set) in dilated.iter().enumerate() {
        assert_eq!(*is_set, domain.distance(domain.center(cell), domain.center(other)) <= 6.0, "{other}");
    }
    assert!(domain.transport_angle(cell, cell - 45).abs() > 100.0 && dilated[cell - 45]);
    let at = domain.center(cell);
    let free = from_places(SYSTEM, &maps, &[at], &|_| false);
    let ground = free[0].iter().copied().fold(f32::INFINITY, f32::min);
    let peak = free[0][cell];
    let mut by_distance: Vec<(f64, f32)> = (0..domain.cells())
        .map(|other| (domain.distance(at, domain.center(other)), free[0][other]))
        .collect();
    by_distance.sort_by(|a, b| a.0.total_cmp(&b.0));
    assert!(peak > 10.0 * ground && free[0][cell - 45] > ground);
    // Cells at equal distances may differ in the last bits.
    assert!(by_distance.windows(2).all(|pair| pair[1].1 <= pair[0].1 * 1.000_01));
    maps.obstacles = set;
    let on = from_places(SYSTEM, &maps, &[at], &|_| false);
    assert_eq!(on[0][cell], 0.0);
}

/// Spots that are 9 units apart on a surface.
fn on_surface(mesh: crate::surface::Mesh, stretch: f32) -> ParameterField<Surface> {
    let p = Parameters { rate: 1.0, ratio: 20.0, stretch, direction: 30.0, pitch: 1.0 };
    let rate = (SYSTEM.spacing(&p) / 9.0).powi(2) as f32;
    let domain = Surface::new(mesh, [0.0, 0.0, 1.0]);
    let cells = domain.cells();
    ParameterField::new(domain, vec![Parameters { rate, ..p }; cells])
}

/// Distance of each place to its nearest neighbour, in pitches.
fn nearest_on(maps: &ParameterField<Surface>, places: &[SurfacePoint]) -> Vec<f64> {
    let surface = &maps.domain;
    let nearest = |i: usize| {
        let nucleus = Nucleus::at(maps, places[i], &|p| SYSTEM.spacing(p));
        let map = LocalMap::new(surface, places[i], 2.0 * nucleus.reach * surface.unit(), |_| false);
        let others = places.iter().filter(|place| **place != places[i]);
        let ways = others.filter_map(|place| map.displacement(surface, *place));
        let far =
            ways.map(|displacement| nucleus.distance2(displacement.map(|part| part / surface.unit())).sqrt());
        far.fold(f64::INFINITY, f64::min)
    };
    (0..places.len()).map(nearest).collect()
}

#[test]
fn on_a_surface_nuclei_are_as_many_as_its_area_takes_and_keep_their_distance_in_the_metric() {
    for (mesh, stretch) in [(sphere_mesh(20, 16.0), 1.0), (cylinder([80, 50], 12.0, 46.0), 0.5)] {
        let maps = on_surface(mesh, stretch);
        let pitch = SYSTEM.spacing(&maps.parameters[0]);
        let all = nuclei(SYSTEM, &maps, 2, &[]).inside;
        let wanted = (maps.domain.cells() as f64 * 2.0 / (3.0f64.sqrt() * pitch * pitch)).round() as usize;
        assert_eq!(all.len(), wanted);
        let distances = nearest_on(&maps, &all);
        let mean = distances.iter().sum::<f64>() / distances.len() as f64;
        let least = distances.iter().copied().fold(f64::INFINITY, f64::min);
        assert!(mean > 0.84 && least > 0.55, "stretch {stretch}: mean {mean}, least {least}");
        let own: Vec<Parameters> = all.iter().map(|at| maps.at(*at)).collect();
        let laid = Places { inside: all, beyond: Vec::new(), pinned: 1 };
        let relaxed = relax_places(SYSTEM, &maps, &laid, &own, 1.25, 5);
        assert!(relaxed[0] == laid.inside[0] && relaxed[1] != laid.inside[1]);
    }
}

#[test]
fn on_an_open_surface_nuclei_are_not_pushed_onto_the_border() {
    let maps = on_surface(cylinder([80, 60], 12.0, 56.0), 1.0);
    let all = nuclei(SYSTEM, &maps, 2, &[]).inside;
    let pitch = SYSTEM.spacing(&maps.parameters[0]) * maps.domain.unit();
    let depth = |at: &SurfacePoint| {
        let z = maps.domain.position(*at)[2];
        z.min(56.0 - z) / pitch
    };
    assert!(all.iter().all(|at| depth(at) > 0.2));
    // The borders are as dense as the rest.
    let outer = all.iter().filter(|at| depth(at) < 1.5).count() as f64;
    let share = 3.0 * pitch / 56.0 * all.len() as f64;
    assert!((outer / share - 1.0).abs() < 0.25, "{outer} {share}");
}

#[test]
fn on_a_thin_sheet_bells_stay_on_their_side() {
    let maps = on_surface(slab([40.0, 40.0, 0.4], 1.0), 1.0);
    let at = maps.domain.closest([3.0, 2.0, 0.2]);
    let free = from_places(SYSTEM, &maps, &[at], &|_| false);
    let ground = free[0].iter().copied().fold(f32::INFINITY, f32::min);
    let raised = |side: f64| {
        let cells = maps.domain.mesh.positions.iter().zip(&free[0]);
        cells.filter(|(position, value)| position[2] * side > 0.0 && **value > 1.5 * ground).count()
    };
    assert!(raised(1.0) > 20 && raised(-1.0) == 0);
}
