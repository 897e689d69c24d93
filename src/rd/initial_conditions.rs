//! What growth begins from: the same places on any grid.

use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;

use crate::grid::{Domain, Field};
use crate::rd::line_noise::{GuideLine, lead};
use crate::rd::maps::{GuideCurves, Maps, Parameters};
use crate::rd::nuclei::{Laid, Nucleus, PinnedSpot, Places, lay, thinned};
use crate::rd::plane::{Plane, RowLayout};
use crate::rd::seeding::{Seeding, seeded, segments, waves};
use crate::rd::systems::{meinhardt_lines, meinhardt_spots, meinhardt_stripes, turing_spots};
use crate::rd::{System, gabor};

/// Where the spots of this growth begin, in cells, the `kept` ones first; without any, the same places that
/// [`crate::rd::Growth::new`] takes. Empty for stripes and lines.
#[must_use]
pub fn nuclei(system: System, maps: &Maps, seed: u64, kept: &[PinnedSpot]) -> Places {
    if system.is_striped() {
        return Places::default();
    }
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    let fixed: Vec<Nucleus> = kept.iter().map(|kept| kept.nucleus(system, maps)).collect();
    let Laid { inside, beyond } = lay(maps, &|p| system.spacing(p), &fixed, &mut rng);
    let at = |laid: Vec<Nucleus>| laid.iter().map(|nucleus| nucleus.at).collect();
    Places { inside: at(inside), beyond: at(beyond), kept: kept.len() }
}

/// What a growth begins from, for any grid over its canvas: spots at the same places, stripes from the same waves.
#[derive(Clone, Debug)]
pub struct InitialConditions {
    system: System,
    seed: u64,
    /// Where spots begin, as shares of the canvas' sides.
    places: Vec<[f64; 2]>,
    /// Lines along which stripes run.
    crests: Vec<GuideLine>,
    seeding: Seeding,
}

impl InitialConditions {
    /// What [`crate::rd::Growth::new`] begins from.
    #[must_use]
    pub fn new(system: System, maps: &Maps, seed: u64) -> Self {
        Self::at_places(system, maps, seed, &nuclei(system, maps, seed, &[]).inside)
    }

    /// The same from spots at these `places`, cells of `maps`.
    #[must_use]
    pub fn at_places(system: System, maps: &Maps, seed: u64, places: &[[f64; 2]]) -> Self {
        let [nx, ny] = maps.grid.size.map(|n| n as f64);
        let share = |[x, y]: &[f64; 2]| [x / nx, y / ny];
        Self {
            system,
            seed,
            places: places.iter().map(share).collect(),
            crests: Vec::new(),
            seeding: Seeding::Noise,
        }
    }

    /// The same of stripes with other seeds: `crests` are the lines that they are to run along. Segments are thrown for
    /// `maps`.
    #[must_use]
    pub fn with_seeding(self, maps: &Maps, seeding: Seeding, crests: Vec<GuideLine>) -> Self {
        let mut rng = Pcg64Mcg::seed_from_u64(self.seed);
        let crests = if seeding == Seeding::Segments { segments(maps, &crests, &mut rng) } else { crests };
        Self { crests, seeding, ..self }
    }

    /// Does anything begin? Spots need a place.
    #[must_use]
    pub fn has_marks(&self) -> bool {
        self.system.is_striped() || !self.places.is_empty()
    }

    /// Do stripes begin in pieces that must find together?
    #[must_use]
    pub fn starts_scattered(&self) -> bool {
        self.seeding == Seeding::Segments
    }

    fn stripes(&self, maps: &Maps) -> [Vec<f32>; 5] {
        match self.seeding {
            Seeding::Noise => {
                let mut rng = Pcg64Mcg::seed_from_u64(self.seed);
                oriented_noise(maps, &self.crests, &mut rng)
            }
            Seeding::Segments => {
                let seeded = seeded(maps, &self.crests);
                let mut cells = meinhardt_stripes::REST.map(|c| vec![c; seeded.len()]);
                for (cells, seed) in cells.iter_mut().zip(meinhardt_stripes::SEED) {
                    cells.iter_mut().zip(&seeded).for_each(|(cell, share)| *cell += share * (seed - *cell));
                }
                cells
            }
            Seeding::Initiators => ripples(&waves(maps, &self.crests)),
        }
    }

    /// The concentrations that it makes on `maps`.
    ///
    /// Where marks are smaller than the grid can hold (`lost`, by cell), `maps` holds larger ones, and only so
    /// many of the spots begin as have room. Neighbours may die there; nothing else would be left of them.
    #[must_use]
    pub fn on(&self, maps: &Maps, lost: &dyn Fn(usize) -> bool) -> Vec<Vec<f32>> {
        match self.system {
            System::MeinhardtStripes => {
                return with_obstacle_state(self.system, maps, self.stripes(maps).into());
            }
            System::MeinhardtLines => {
                let begun = match &maps.curves {
                    Some(curves) => along(curves, maps),
                    None => crests(maps, &self.crests, &mut Pcg64Mcg::seed_from_u64(self.seed)),
                };
                return with_obstacle_state(self.system, maps, begun.into());
            }
            System::TuringSpots | System::MeinhardtSpots => {}
        }
        let pitch = |p: &Parameters| self.system.spacing(p);
        let nucleus = |at: &[f64; 2]| {
            let at = [at[0] * maps.grid.size[0] as f64, at[1] * maps.grid.size[1] as f64];
            Nucleus::at(maps, at, &pitch)
        };
        let laid = self.places.iter().map(nucleus).collect();
        let crowded = |nucleus: &Nucleus| lost(maps.grid.cell_at(nucleus.at));
        let cells = bells_on(self.system, maps, &thinned(laid, maps, &crowded));
        with_obstacle_state(self.system, maps, cells.into())
    }
}

/// What shows of the marks that this growth begins from.
#[must_use]
pub fn initial_marks(system: System, maps: &Maps, seed: u64) -> Field {
    crate::rd::Growth::new(system, maps, seed).marks(maps)
}

/// The same concentrations with those of taken cells as marks of other layers have them.
#[must_use]
pub fn with_obstacle_state(system: System, maps: &Maps, mut chemicals: Vec<Vec<f32>>) -> Vec<Vec<f32>> {
    let values = system.obstacle_state();
    for (cells, value) in chemicals.iter_mut().zip(values) {
        for (cell, taken) in cells.iter_mut().zip(&maps.obstacles) {
            if *taken {
                *cell = *value;
            }
        }
    }
    if let (Some(curves), [_, inhibitor, ..]) = (&maps.curves, &mut chemicals[..]) {
        for ((cell, taken), held) in inhibitor.iter_mut().zip(&maps.obstacles).zip(&curves.inhibitor) {
            if *taken {
                *cell = *held;
            }
        }
    }
    chemicals
}

/// Spots begin as bells on [`nuclei`].
pub fn spots(system: System, maps: &Maps, rng: &mut Pcg64Mcg) -> [Plane; 2] {
    let laid = lay(maps, &|p| system.spacing(p), &[], rng).inside;
    planes(maps, bells_on(system, maps, &laid))
}

fn bells_on(system: System, maps: &Maps, laid: &[Nucleus]) -> [Vec<f32>; 2] {
    let radius = |p: &Parameters| match system {
        System::TuringSpots => turing_spots::RADIUS,
        _ => meinhardt_spots::radius(p.ratio) / p.apart(),
    };
    let bell = bells(maps, laid, &radius);
    let mut cells = [vec![0.0; bell.len()], vec![0.0; bell.len()]];
    let [a, b] = cells.each_mut().map(|cells| cells.par_chunks_mut(maps.grid.size[0]));
    let rows = bell.par_chunks(maps.grid.size[0]).zip(maps.parameters.par_chunks(maps.grid.size[0]));
    a.zip(b).zip(rows).for_each(|((a, b), (bell, parameters))| {
        let (mut ratio, mut peak) = (f32::NAN, 0.0);
        for (i, (bell, p)) in bell.iter().zip(parameters).enumerate() {
            // Mostly the same as beside it.
            if p.ratio != ratio {
                (ratio, peak) = (p.ratio, meinhardt_spots::peak(p.ratio));
            }
            [a[i], b[i]] = match system {
                System::TuringSpots => turing_spots::begin(*bell),
                _ => meinhardt_spots::begin(*bell, peak, p.apart() > 1.0),
            };
        }
    });
    cells
}

/// Rows of bells that are drawn at once.
const ROWS: usize = 16;

/// For each cell, 1 in the middle of a spot to be, falling to 0 away from it as a Gaussian of its metric.
fn bells(maps: &Maps, nuclei: &[Nucleus], radius: &(dyn Fn(&Parameters) -> f64 + Sync)) -> Vec<f32> {
    let radii: Vec<f64> = nuclei.iter().map(|nucleus| radius(&maps.at(nucleus.at))).collect();
    let mut bell = vec![0.0f32; maps.grid.cells()];
    let band = ROWS * maps.grid.size[0];
    bell.par_chunks_mut(band).enumerate().for_each(|(index, bell)| {
        let first = index * band;
        for (nucleus, radius) in nuclei.iter().zip(&radii) {
            let far = 3.5 * radius * nucleus.reach;
            maps.grid.near(nucleus.at, far, first..first + bell.len()).for_each(|(cell, delta)| {
                let exponent = -0.5 * nucleus.distance2(delta) / (radius * radius);
                // Farther out it is less than 2·10⁻⁷ of the peak: a ten-thousandth of the ground.
                if exponent > -16.0 {
                    let cell = &mut bell[cell - first];
                    *cell = cell.max(libm::exp(exponent) as f32);
                }
            });
        }
    });
    bell
}

/// Stripes begin as oriented noise in a against b.
pub fn stripes(maps: &Maps, rng: &mut Pcg64Mcg) -> [Plane; 5] {
    planes(maps, oriented_noise(maps, &[], rng))
}

fn oriented_noise(maps: &Maps, crests: &[GuideLine], rng: &mut Pcg64Mcg) -> [Vec<f32>; 5] {
    let wavelength = |p: &Parameters| System::MeinhardtStripes.spacing(p);
    let mut noise = gabor::noise(maps, &wavelength, rng);
    lead(System::MeinhardtStripes, &mut noise, maps, crests);
    ripples(&noise)
}

/// The ground at rest with a raised against b, and d against e, by `noise`.
fn ripples(noise: &[f32]) -> [Vec<f32>; 5] {
    let mut cells = meinhardt_stripes::REST.map(|c| vec![c; noise.len()]);
    for (i, noise) in noise.iter().enumerate() {
        let n = (0.2 * noise).clamp(-0.9, 0.9);
        for (chemical, sign) in [(0, 1.0), (1, -1.0), (3, 1.0), (4, -1.0)] {
            cells[chemical][i] *= 1.0 + sign * n;
        }
    }
    cells
}

/// Lines begin as crests of oriented waves.
pub fn lines(maps: &Maps, rng: &mut Pcg64Mcg) -> [Plane; 2] {
    planes(maps, crests(maps, &[], rng))
}

/// Standard deviation of a crest's profile, a Gaussian, ÷ the width of the line it becomes: at half its height it is as
/// wide.
const CREST: f64 = 0.42;

fn crests(maps: &Maps, leading: &[GuideLine], rng: &mut Pcg64Mcg) -> [Vec<f32>; 2] {
    let wavelength = |p: &Parameters| System::MeinhardtLines.spacing(p);
    let phases = gabor::phases(maps, &wavelength, leading, rng);
    let mut cells = [vec![0.0; phases.len()], vec![0.0; phases.len()]];
    let [a, b] = cells.each_mut().map(|cells| cells.par_chunks_mut(maps.grid.size[0]));
    let rows = phases.par_chunks(maps.grid.size[0]).zip(maps.parameters.par_chunks(maps.grid.size[0]));
    a.zip(b).zip(rows).for_each(|((a, b), (phases, parameters))| {
        for (i, (phase, p)) in phases.iter().zip(parameters).enumerate() {
            let width = CREST * meinhardt_lines::width(p.ratio) / f64::from(p.rate).sqrt();
            let off = f64::from(*phase) / std::f64::consts::TAU * wavelength(p) / width;
            let crest = libm::exp(-0.5 * off * off) as f32;
            [a[i], b[i]] = meinhardt_lines::begin(crest, meinhardt_lines::peak(p.ratio));
        }
    });
    cells
}

/// Lines begin along the curves of `maps`.
fn along(curves: &GuideCurves, maps: &Maps) -> [Vec<f32>; 2] {
    let mut cells = [vec![0.0; curves.distance.len()], vec![0.0; curves.distance.len()]];
    let [a, b] = cells.each_mut().map(|cells| cells.par_chunks_mut(maps.grid.size[0]));
    let rows =
        curves.distance.par_chunks(maps.grid.size[0]).zip(maps.parameters.par_chunks(maps.grid.size[0]));
    a.zip(b).zip(rows).for_each(|((a, b), (off, parameters))| {
        for (i, (off, p)) in off.iter().zip(parameters).enumerate() {
            let width = CREST * meinhardt_lines::width(p.ratio) / f64::from(p.rate).sqrt();
            let off = f64::from(*off) / width;
            let crest = libm::exp(-0.5 * off * off) as f32;
            [a[i], b[i]] = meinhardt_lines::begin(crest, meinhardt_lines::peak(p.ratio));
        }
    });
    cells
}

/// The cells of each chemical inside their margins.
fn planes<const N: usize>(maps: &Maps, cells: [Vec<f32>; N]) -> [Plane; N] {
    let grid = RowLayout::new(&maps.grid);
    cells.map(|cells| {
        let mut plane = Plane::flat(grid, 0.0);
        for (y, row) in cells.chunks_exact(maps.grid.size[0]).enumerate() {
            plane.set_row(y, row);
        }
        plane
    })
}
