//! Compares growth on unprepared meshes, with diffusion by cotangent weights and by the average of neighbours.

use std::sync::Arc;

use dapple_engine::grid::Domain;
use dapple_engine::measure::surface_spots;
use dapple_engine::rd::{Operators, ParameterField, Parameters, SurfaceGrowth, System, from_places, nuclei};
use dapple_engine::surface::{Laplacian, Mesh, Stretch, Surface, SurfacePoint, built_in, laplacian, prepare};

use super::triangulations::{self, animal, edge, evenly, four};
use super::{mean, system, variation};

/// The number of spots on a surface, about.
const SPOTS: f64 = 290.0;
/// Cells per spacing on the mesh on which the places of spots are chosen.
const LAID: f64 = 6.0;
/// Vertices of the graded sphere: 16 per spacing.
const VERTICES: f64 = 64_000.0;
/// Normalised time.
const TIME: f64 = 60.0;
/// The share of the peak that is the edge of a spot.
const LEVEL: f32 = 0.5;
/// Displacement of the angle from the pole, divided by its sine: at one pole, edges are 1.6 times and cells 2.7 times
/// as large as at the other.
const GRADED: f64 = 0.25;
/// The ends of a surface are the parts within this share of its length, along the axis.
const END: f64 = 0.25;

/// How diffusion is computed on a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spreading {
    /// By cotangent weights and the areas of cells.
    Cotangents,
    /// By the average of neighbours, as many mesh tools do (Phan & Grimm 2006, equation 3).
    Average,
}

impl Spreading {
    fn name(self) -> &'static str {
        match self {
            Self::Cotangents => "cotangents",
            Self::Average => "average of neighbours",
        }
    }

    /// The operators of this method on a surface, and the mean area of a cell.
    fn operators(self, surface: &Surface) -> Arc<Operators> {
        let vertices = surface.cells();
        let own = laplacian(&surface.mesh, surface.frames(), &vec![Stretch::NONE; vertices]);
        let cell = surface.mesh.area() / vertices as f64;
        match self {
            Self::Cotangents => Arc::new(Operators::of(&[(own, vec![1.0; vertices])], cell)),
            Self::Average => {
                let (average, factors) = average(surface);
                Arc::new(Operators::of(&[(average, factors)], 1.0))
            }
        }
    }
}

/// The average of the neighbours minus the value itself, × 2√3. On regular triangles whose cells have an area of 1 this
/// is ∇². It is given as rows of equal weights, with a factor for each row.
fn average(surface: &Surface) -> (Laplacian, Vec<f64>) {
    let (mut starts, mut columns, mut factors) = (vec![0], Vec::new(), Vec::new());
    for vertex in 0..surface.cells() {
        let mut ring: Vec<u32> = surface.ring(vertex).map(|other| other as u32).collect();
        ring.sort_unstable();
        factors.push(1.0 / ring.len().max(1) as f64);
        columns.append(&mut ring);
        starts.push(columns.len() as u32);
    }
    let weights = vec![2.0 * 3.0_f64.sqrt(); columns.len()];
    let mass = vec![1.0; factors.len()];
    (Laplacian { starts, columns, weights, mass }, factors)
}

/// The result of a growth on a mesh.
#[derive(Clone, Debug)]
pub struct Grown {
    /// The number of spots at the start.
    pub laid: usize,
    /// For each spot that grew: its area ÷ (initial spacing)², and its place along the axis, 0..1.
    pub spots: Vec<(f64, f64)>,
}

impl Grown {
    /// Areas ÷ (initial spacing)².
    pub fn areas(&self) -> impl Iterator<Item = f64> + Clone {
        self.spots.iter().map(|(area, _)| *area)
    }

    /// Mean area ÷ spacing² of the spots at both ends of the x axis.
    pub fn ends(&self) -> [f64; 2] {
        let end = |is_there: fn(f64) -> bool| {
            mean(self.spots.iter().filter(move |(_, at)| is_there(*at)).map(|(area, _)| *area))
        };
        [end(|at| at < END), end(|at| at > 1.0 - END)]
    }
}

/// The spacing at which about this number of spots covers a surface.
fn spacing(surface: &Surface, spots: f64) -> f64 {
    edge(surface.mesh.area(), spots)
}

/// A surface, and round spots with the spacing for this number of spots.
pub fn with_spots(system: System, surface: Surface, spots: f64) -> ParameterField<Surface> {
    let one = Parameters { rate: 1.0, ratio: 15.0, stretch: 1.0, direction: 0.0, pitch: 1.0 };
    let apart = system.spacing(&one) * surface.unit() / spacing(&surface, spots);
    let cells = surface.cells();
    ParameterField::new(surface, vec![Parameters { rate: (apart * apart) as f32, ..one }; cells])
}

/// Places for about this number of spots, chosen on an even, coarser mesh of the same surface.
pub fn laid(system: System, surface: &Surface, spots: f64, seed: u64) -> Result<Vec<SurfacePoint>, String> {
    let (even, _) = prepare(&surface.mesh).map_err(|error| error.to_string())?;
    let coarse = evenly(&even, LAID * LAID * spots * 0.75_f64.sqrt());
    let maps = with_spots(system, Surface::new(coarse, [1.0, 0.0, 0.0]), spots);
    let places = nuclei(system, &maps, seed, &[]).inside;
    let carried = |place: &SurfacePoint| {
        let normal = maps.domain.normal(maps.domain.vertex_of(*place));
        surface.closest_facing(maps.domain.position(*place), normal)
    };
    Ok(places.iter().map(carried).collect())
}

/// Grows spots on an unprepared mesh.
fn grown(surface: Surface, spreading: Spreading, seed: u64) -> Result<Grown, String> {
    let system = system()?;
    let places = laid(system, &surface, SPOTS, seed)?;
    let operators = spreading.operators(&surface);
    let maps = with_spots(system, surface, SPOTS);
    let begin = from_places(system, &maps, &places, &|_| false);
    let mut growth = SurfaceGrowth::new(system, &maps, operators, &begin).ok_or("spots do not grow there")?;
    growth.advance(growth.steps_in(TIME));
    Ok(Grown { laid: places.len(), spots: spots(&maps.domain, &growth.marks()) })
}

/// Areas ÷ spacing² and places along the x axis of the spots in values by vertex.
fn spots(surface: &Surface, marks: &[f32]) -> Vec<(f64, f64)> {
    let [low, high] = surface.mesh.bounds();
    let square = spacing(surface, SPOTS) * spacing(surface, SPOTS);
    let spots = surface_spots(surface, marks, &vec![LEVEL; marks.len()]);
    let along = |place| (surface.position(place)[0] - low[0]) / (high[0] - low[0]);
    spots.iter().map(|spot| (spot.area / square, along(spot.place))).collect()
}

/// The built-in sphere, prepared.
pub fn sphere() -> Result<Mesh, String> {
    let ball = built_in("sphere").ok_or("there is no built-in sphere")?;
    let mesh = ball.mesh(&[]).map_err(|error| error.to_string())?;
    prepare(&mesh).map(|(mesh, _)| mesh).map_err(|error| error.to_string())
}

/// A sphere whose cells are about three times as large at one pole (on the x axis) as at the other: 2.8 times by
/// [`GRADED`], and further by the differences within even meshes.
fn graded_sphere() -> Result<Mesh, String> {
    let mesh = sphere()?;
    let mut even = evenly(&mesh, VERTICES);
    even.positions.iter_mut().for_each(|at| *at = moved_from_the_pole(*at));
    Ok(even)
}

/// A place on a sphere about the origin, with its angle θ from the pole +x changed to θ + .25 sin θ.
pub fn moved_from_the_pole([x, y, z]: [f64; 3]) -> [f64; 3] {
    let (radius, beside) = ((x * x + y * y + z * z).sqrt(), (y * y + z * z).sqrt());
    if beside == 0.0 {
        return [x, y, z];
    }
    let (sin, cos) = libm::sincos(libm::atan2(beside, x) + GRADED * beside / radius);
    [radius * cos, radius * sin * y / beside, radius * sin * z / beside]
}

/// Prints the results on the four triangulations of the animal and on a graded sphere, without preparing the meshes.
pub fn table(seeds: u64) -> Result<(), String> {
    crate::say("")?;
    crate::say(
        "| mesh as it is | spread by | spots of those laid | area ÷ spacing² | its variation | at the ends |",
    )?;
    crate::say("|---|---|---|---|---|---|")?;
    let mut meshes: Vec<(&str, Mesh)> = four(triangulations::VERTICES)?
        .iter()
        .map(|triangulation| (triangulation.name, triangulation.mesh()))
        .collect();
    meshes.push(("graded sphere, cells 1 : 3.3", graded_sphere()?));
    meshes.push(("remeshed animal", evenly(&animal()?, VERTICES)));
    for (name, mesh) in &meshes {
        for spreading in [Spreading::Cotangents, Spreading::Average] {
            let all = (1..=seeds)
                .map(|seed| grown(Surface::new(mesh.clone(), [1.0, 0.0, 0.0]), spreading, seed))
                .collect::<Result<Vec<Grown>, String>>()?;
            let spots: Vec<String> =
                all.iter().map(|grown| format!("{}/{}", grown.spots.len(), grown.laid)).collect();
            let ends = [0, 1].map(|end| mean(all.iter().map(|grown| grown.ends()[end])));
            crate::say(&format!(
                "| {name} | {} | {} | {:.4} | {:.3} | {:.4}, {:.4} |",
                spreading.name(),
                spots.join(" "),
                mean(all.iter().map(|grown| mean(grown.areas()))),
                // Growths without spots are left out.
                mean(all.iter().map(|grown| variation(grown.areas())).filter(|of| of.is_finite())),
                ends[0],
                ends[1],
            ))?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_of_the_graded_sphere_are_some_three_times_as_large_at_one_pole() {
        let surface = Surface::new(graded_sphere().expect("a sphere"), [1.0, 0.0, 0.0]);
        let [low, high] = surface.mesh.bounds().map(|corner| corner[0]);
        let cell = |is_there: fn(f64) -> bool| {
            let along = |cell: &usize| (surface.mesh.positions[*cell][0] - low) / (high - low);
            mean(
                (0..surface.cells()).filter(|cell| is_there(along(cell))).map(|cell| surface.cell_area(cell)),
            )
        };
        let ratio = cell(|along| along > 0.98) / cell(|along| along < 0.02);
        assert!((2.4..3.5).contains(&ratio), "{ratio}");
    }
}
