//! What growth begins from: the same places on any grid.

use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

use super::maps::{Maps, Parameters};
use super::nuclei::{Nucleus, lay};
use super::plane::Plane;
use super::{System, gabor, meinhardt_spots, meinhardt_stripes, turing_spots};
use crate::field::Edges;

/// Where the spots of this growth begin, in cells; the same places that [`super::Growth::new`] takes. Empty for stripes.
#[must_use]
pub fn nuclei(system: System, maps: &Maps, edges: Edges, seed: u64) -> Vec<[f64; 2]> {
    if system == System::MeinhardtStripes {
        return Vec::new();
    }
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    lay(maps, edges, &|p| system.spacing(p), &mut rng).iter().map(|nucleus| nucleus.at).collect()
}

/// Concentrations on `maps` with spots begun at `nuclei`, in cells.
#[must_use]
pub fn spots_at(system: System, maps: &Maps, edges: Edges, nuclei: &[[f64; 2]]) -> Vec<Vec<f32>> {
    let laid: Vec<Nucleus> =
        nuclei.iter().map(|at| Nucleus::at(maps, *at, &|p| system.spacing(p))).collect();
    bells_on(system, maps, edges, &laid).into()
}

/// Spots begin as bells on [`nuclei`].
pub fn spots(system: System, maps: &Maps, edges: Edges, rng: &mut Pcg64Mcg) -> [Plane; 2] {
    let laid = lay(maps, edges, &|p| system.spacing(p), rng);
    planes(maps, edges, bells_on(system, maps, edges, &laid))
}

fn bells_on(system: System, maps: &Maps, edges: Edges, laid: &[Nucleus]) -> [Vec<f32>; 2] {
    let radius = |p: &Parameters| match system {
        System::TuringSpots => turing_spots::RADIUS,
        _ => meinhardt_spots::radius(p.ratio),
    };
    let bell = bells(maps, edges, laid, &radius);
    let mut cells = [vec![0.0; bell.len()], vec![0.0; bell.len()]];
    for (i, (bell, p)) in bell.iter().zip(&maps.parameters).enumerate() {
        [cells[0][i], cells[1][i]] = match system {
            System::TuringSpots => turing_spots::begin(*bell),
            _ => meinhardt_spots::begin(*bell, p.ratio),
        };
    }
    cells
}

/// For each cell, 1 in the middle of a spot to be, falling to 0 away from it as a Gaussian of its metric.
fn bells(maps: &Maps, edges: Edges, nuclei: &[Nucleus], radius: &dyn Fn(&Parameters) -> f64) -> Vec<f32> {
    let (nx, ny) = (maps.nx, maps.ny);
    let mut bell = vec![0.0f32; nx * ny];
    for nucleus in nuclei {
        let radius = radius(&maps.at(nucleus.at));
        let far = 3.5 * radius * nucleus.reach;
        let range = |v: f64| (v - 0.5 - far).ceil() as isize..=(v - 0.5 + far).floor() as isize;
        for y in range(nucleus.at[1]) {
            for x in range(nucleus.at[0]) {
                let inside = (0..nx as isize).contains(&x) && (0..ny as isize).contains(&y);
                if edges == Edges::Closed && !inside {
                    continue;
                }
                let d2 = nucleus.distance2([x as f64 + 0.5 - nucleus.at[0], y as f64 + 0.5 - nucleus.at[1]]);
                let here = libm::exp(-0.5 * d2 / (radius * radius)) as f32;
                let cell = &mut bell[edges.index(y, ny) * nx + edges.index(x, nx)];
                *cell = cell.max(here);
            }
        }
    }
    bell
}

/// Stripes begin as oriented noise in a against b.
pub fn stripes(maps: &Maps, edges: Edges, rng: &mut Pcg64Mcg) -> [Plane; 5] {
    planes(maps, edges, oriented_noise(maps, edges, rng))
}

/// Concentrations on `maps` with stripes begun as oriented noise: the same waves on any grid.
#[must_use]
pub fn stripes_of(maps: &Maps, edges: Edges, seed: u64) -> Vec<Vec<f32>> {
    oriented_noise(maps, edges, &mut Pcg64Mcg::seed_from_u64(seed)).into()
}

fn oriented_noise(maps: &Maps, edges: Edges, rng: &mut Pcg64Mcg) -> [Vec<f32>; 5] {
    let wavelength = |p: &Parameters| System::MeinhardtStripes.spacing(p);
    let noise = gabor::noise(maps, edges, &wavelength, rng);
    let mut cells = meinhardt_stripes::REST.map(|c| vec![c; noise.len()]);
    for (i, noise) in noise.iter().enumerate() {
        let n = (0.2 * noise).clamp(-0.9, 0.9);
        for (chemical, sign) in [(0, 1.0), (1, -1.0), (3, 1.0), (4, -1.0)] {
            cells[chemical][i] *= 1.0 + sign * n;
        }
    }
    cells
}

/// The cells of each chemical inside their margins.
fn planes<const N: usize>(maps: &Maps, edges: Edges, cells: [Vec<f32>; N]) -> [Plane; N] {
    cells.map(|cells| {
        let mut plane = Plane::flat(maps.nx, maps.ny, 0.0);
        for (y, row) in cells.chunks_exact(maps.nx).enumerate() {
            let at = plane.at(0, y);
            plane.values[at..at + maps.nx].copy_from_slice(row);
        }
        plane.fill_margin(edges);
        plane
    })
}
