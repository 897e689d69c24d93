//! What growth begins from.

use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

use super::maps::{Maps, Parameters};
use super::nuclei::{Nucleus, lay};
use super::plane::{Grid, Plane};
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

/// Spots begin as bells on [`nuclei`].
pub fn spots(system: System, maps: &Maps, edges: Edges, rng: &mut Pcg64Mcg) -> [Plane; 2] {
    let (nx, ny) = (maps.nx, maps.ny);
    let radius = |p: &Parameters| match system {
        System::TuringSpots => turing_spots::RADIUS,
        _ => meinhardt_spots::radius(p.ratio),
    };
    let bell = bells(maps, edges, &lay(maps, edges, &|p| system.spacing(p), rng), &radius);
    let mut planes = [(); 2].map(|()| Plane::flat(Grid { nx, ny, edges }, 0.0));
    let mut rows = [vec![0.0; nx], vec![0.0; nx]];
    for y in 0..ny {
        for x in 0..nx {
            let (q, p) = (bell[y * nx + x], maps.parameters[y * nx + x]);
            let [a, b] = match system {
                System::TuringSpots => turing_spots::begin(q),
                _ => meinhardt_spots::begin(q, p.ratio),
            };
            (rows[0][x], rows[1][x]) = (a, b);
        }
        planes.iter_mut().zip(&rows).for_each(|(plane, row)| plane.set_row(y, row));
    }
    planes
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
    let wavelength = |p: &Parameters| System::MeinhardtStripes.spacing(p);
    let noise = gabor::noise(maps, edges, &wavelength, rng);
    let grid = Grid { nx: maps.nx, ny: maps.ny, edges };
    let mut planes = meinhardt_stripes::REST.map(|c| Plane::flat(grid, c));
    for (y, noise) in noise.chunks_exact(maps.nx).enumerate() {
        for (chemical, sign) in [(0, 1.0), (1, -1.0), (3, 1.0), (4, -1.0)] {
            let rest = meinhardt_stripes::REST[chemical];
            let row: Vec<f32> =
                noise.iter().map(|n| rest * (1.0 + sign * (0.2 * n).clamp(-0.9, 0.9))).collect();
            planes[chemical].set_row(y, &row);
        }
    }
    planes
}
