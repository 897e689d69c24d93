//! Compares growth by Turk's method with growth by cotangent weights on the same surface.

use std::collections::BTreeMap;
use std::sync::Arc;

use dapple_engine::grid::{Domain, Edges, Grid, UnionFind};
use dapple_engine::rd::{Operators, ParameterField, Parameters, SurfaceGrowth, from_places};
use dapple_engine::surface::voronoi::{RelaxedPoints, WeightedSum, voronoi_laplacian};
use dapple_engine::surface::{Mesh, Surface, SurfacePoint};
use rayon::prelude::*;

use super::spread::{Grown, laid, moved_from_the_pole, sphere, with_spots};
use super::triangulations::{animal, evenly};
use super::{mean, system, variation};

/// Normalised time.
const TIME: f64 = 60.0;
/// Iterations of repulsion, as in the paper's figure 7.
const ITERATIONS: usize = 40;
/// Vertices of the surface on which values of points are read.
const READ: f64 = 60_000.0;

/// The share of the peak that is the edge of a spot.
const EDGE: f32 = 0.5;
/// Points whose values are within this distance of the edge count as partly inside.
const SOFT: f32 = 0.4;
/// The number of spots on each surface, about.
const SPOTS: f64 = 80.0;

/// The points on which a pattern grows.
#[derive(Clone, Copy, Debug)]
pub struct Points {
    /// Points per spacing of the spots.
    pub fineness: f64,
    /// Rounds of repulsion.
    pub iterations: usize,
    /// Whether the points are then crowded at one pole.
    pub is_graded: bool,
}

impl Points {
    /// Twelve points per spacing, spread as evenly as in the paper.
    pub const USUAL: Self = Self { fineness: 12.0, iterations: ITERATIONS, is_graded: false };

    /// The number of points on a surface with about this number of spots.
    fn number(self, spots: f64) -> usize {
        (self.fineness * self.fineness * spots * 0.75_f64.sqrt()).round() as usize
    }
}

/// The result of a growth on points.
pub struct OnPoints {
    /// The surface, about as fine as the points.
    pub surface: Surface,
    /// Where they are.
    pub points: RelaxedPoints,
    /// The number of spots at the start.
    pub laid: usize,
    /// The values that show the marks, by point.
    pub marks: Vec<f32>,
    /// The values of a growth by cotangent weights on the surface, read at the points.
    pub by_cotangents: Vec<f32>,
}

/// Grows about this number of round spots on relaxed points of a surface, and on the surface itself.
pub fn grown(mesh: &Mesh, spots: f64, points: Points, seed: u64) -> Result<OnPoints, String> {
    let (system, number) = (system()?, points.number(spots));
    let surface = Surface::new(evenly(mesh, number as f64), [1.0, 0.0, 0.0]);
    let mut relaxed = RelaxedPoints::new(&surface, number, points.iterations, seed);
    if points.is_graded {
        for place in &mut relaxed.places {
            *place = surface.closest(moved_from_the_pole(surface.position(*place)));
        }
    }
    let places = laid(system, &surface, spots, seed)?;
    let laplacian = voronoi_laplacian(&surface, &relaxed);
    let maps = with_spots(system, surface, spots);
    let begin = from_places(system, &maps, &places, &|_| false);
    let at_points = |values: &[f32]| -> Vec<f32> {
        let at = |place: &SurfacePoint| maps.domain.interpolate(*place, |vertex| f64::from(values[vertex]));
        relaxed.places.iter().map(|place| at(place) as f32).collect()
    };
    let by_cotangents = {
        let operators = Operators::new(system, &maps.domain.mesh, maps.domain.frames(), &maps.parameters);
        at_points(&shown(SurfaceGrowth::new(system, &maps, Arc::new(operators), &begin))?)
    };
    // Lengths are in units of √(area ÷ number of points), whatever the areas of single cells are.
    let unit = maps.domain.mesh.area() / number as f64 / (maps.domain.unit() * maps.domain.unit());
    let own = Parameters { rate: maps.parameters[0].rate * unit as f32, ..maps.parameters[0] };
    let on_points = ParameterField::new(Grid::unit([number, 1], Edges::Closed), vec![own; number]);
    let operators = Arc::new(Operators::of(&[(laplacian, vec![1.0; number])], 1.0));
    let begin: Vec<Vec<f32>> = begin.iter().map(|values| at_points(values)).collect();
    let marks = shown(SurfaceGrowth::new(system, &on_points, operators, &begin))?;
    Ok(OnPoints { laid: places.len(), marks, by_cotangents, surface: maps.domain, points: relaxed })
}

/// The final values of a growth.
fn shown(growth: Option<SurfaceGrowth>) -> Result<Vec<f32>, String> {
    let mut growth = growth.ok_or("spots do not grow there")?;
    growth.advance(growth.steps_in(TIME));
    Ok(growth.marks())
}

/// The area around each point: that of the parts of a finer surface that are nearest to the point.
fn areas(mesh: &Mesh, grown: &OnPoints) -> Vec<f64> {
    let fine = Surface::new(evenly(mesh, READ), [1.0, 0.0, 0.0]);
    let sums = WeightedSum::new(&grown.surface, &grown.points);
    let nearest = |vertex: usize| {
        let place = grown.surface.closest_facing(fine.mesh.positions[vertex], fine.normal(vertex));
        sums.nearest(place)
    };
    let nearest: Vec<Option<(usize, f64)>> = (0..fine.cells()).into_par_iter().map(nearest).collect();
    let mut areas = vec![0.0; grown.points.places.len()];
    for (vertex, point) in nearest.iter().enumerate() {
        if let Some((point, _)) = point {
            areas[*point] += fine.cell_area(vertex);
        }
    }
    areas
}

/// The spots in values by point. Points whose value is close to the level count in part, because the edge of a spot
/// lies between points.
fn read(grown: &OnPoints, areas: &[f64], values: &[f32]) -> Grown {
    let laplacian = voronoi_laplacian(&grown.surface, &grown.points);
    let mut pieces = UnionFind::new(values.len());
    let neighbours = |point: usize| {
        laplacian.columns[laplacian.starts[point] as usize..laplacian.starts[point + 1] as usize]
            .iter()
            .copied()
    };
    for (point, other) in
        (0..values.len()).flat_map(|point| neighbours(point).map(move |other| (point, other)))
    {
        if values[point].min(values[other as usize]) > EDGE {
            pieces.join(point as u32, other, [0; 2]);
        }
    }
    let [low, high] = grown.surface.mesh.bounds();
    let square = grown.surface.mesh.area() / SPOTS * 2.0 / 3.0_f64.sqrt();
    let share = |value: f32| f64::from(((value - EDGE) / SOFT + 0.5).clamp(0.0, 1.0));
    // A point below the level belongs to the spot of its highest neighbour.
    let mut spots: BTreeMap<u32, (f64, f64)> = BTreeMap::new();
    for point in (0..values.len()).filter(|point| share(values[*point]) > 0.0) {
        let higher = neighbours(point).max_by(|a, b| values[*a as usize].total_cmp(&values[*b as usize]));
        let own = if values[point] > EDGE { Some(point as u32) } else { higher };
        let Some(own) = own.filter(|own| values[*own as usize] > EDGE) else { continue };
        let area = share(values[point]) * areas[point] / square;
        let along = (grown.surface.position(grown.points.places[point])[0] - low[0]) / (high[0] - low[0]);
        let spot = spots.entry(pieces.root(own).0).or_default();
        *spot = (spot.0 + area, spot.1 + area * along);
    }
    let spots = spots.into_values().map(|(area, along)| (area, along / area)).collect();
    Grown { laid: grown.laid, spots }
}

/// Prints results for points that are more or less relaxed, finer or coarser, and crowded at one side.
pub fn table(seeds: u64) -> Result<(), String> {
    let sphere = sphere()?;
    let animal = animal()?;
    let usual = Points::USUAL;
    let all = [
        ("sphere", &sphere, usual),
        ("sphere", &sphere, Points { fineness: 8.0, ..usual }),
        ("sphere", &sphere, Points { fineness: 16.0, ..usual }),
        ("animal", &animal, usual),
        ("sphere", &sphere, Points { iterations: 5, ..usual }),
        ("sphere", &sphere, Points { iterations: 0, ..usual }),
        ("sphere, crowded at one pole", &sphere, Points { is_graded: true, ..usual }),
    ];
    crate::say(
        "| surface | points a spacing | rounds | spots of those laid | area ÷ spacing² | its variation | at the ends | by cotangents | its variation |",
    )?;
    crate::say("|---|---|---|---|---|---|---|---|---|")?;
    for (name, mesh, points) in all {
        let (mut turk, mut cotangents) = (Vec::new(), Vec::new());
        for seed in 1..=seeds {
            let grown = grown(mesh, SPOTS, points, seed)?;
            let areas = areas(mesh, &grown);
            turk.push(read(&grown, &areas, &grown.marks));
            cotangents.push(read(&grown, &areas, &grown.by_cotangents));
        }
        let area = |all: &[Grown]| mean(all.iter().map(|grown| mean(grown.areas())));
        let varies = |all: &[Grown]| mean(all.iter().map(|grown| variation(grown.areas())));
        let ends = [0, 1].map(|end| mean(turk.iter().map(|grown| grown.ends()[end])));
        let spots: Vec<String> =
            turk.iter().map(|grown| format!("{}/{}", grown.spots.len(), grown.laid)).collect();
        crate::say(&format!(
            "| {name} | {} | {} | {} | {:.4} | {:.3} | {:.4}, {:.4} | {:.4} | {:.3} |",
            points.fineness,
            points.iterations,
            spots.join(" "),
            area(&turk),
            varies(&turk),
            ends[0],
            ends[1],
            area(&cotangents),
            varies(&cotangents),
        ))?;
    }
    Ok(())
}
