//! Initial conditions of stripes other than noise: seeds on a uniform ground at equilibrium.

use std::f64::consts::TAU;

use rand::{Rng, RngExt};
use rayon::prelude::*;

use super::parameter_field::{ParameterField, Parameters};
use crate::grid::{Domain, Grid};
use crate::rd::line_noise::{GuideLine, Wavelength};

/// Initial state of stripes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Seeding {
    /// Noise that already has their wavelength and direction; they grow along a tensor.
    #[default]
    Noise,
    /// Short line segments of their direction at random places; they grow without a tensor (Phan & Grimm, V.1).
    Segments,
    /// The drawn lines alone: stripes form from these outwards in regular order, without a tensor (Turk, "Regular Stripe
    /// Patterns"; Phan & Grimm, figure 11).
    Initiators,
}

/// Segments in a square wavelength (`facts.md` E).
const DENSITY: f64 = 0.5;
/// Length of a segment, wavelengths (`facts.md` E).
const LENGTH: f64 = 2.0;
/// Standard deviation of their directions, degrees (`facts.md` E).
const JITTER: f64 = 5.0;
/// Smallest distance of their midpoints from drawn lines, wavelengths: closer ones would cross these.
const CLEAR: f64 = 1.25;
/// Half of the thickness of a segment, wavelengths: a cell of the coarsest grid, which has eight cells per wavelength.
const THICKNESS: f64 = 0.0625;

/// The segments for the grid of `maps`: `drawn` ones, and elsewhere random ones of the usual density.
pub fn segments(
    maps: &ParameterField,
    drawn: &[GuideLine],
    wavelength: Wavelength,
    rng: &mut impl Rng,
) -> Vec<GuideLine> {
    let clear = |at: [f64; 2], length: f64| {
        drawn.iter().all(|line| line.distance(at, &maps.domain.bounds()) >= CLEAR * length)
    };
    let [w, h] = maps.domain.bounds().size;
    let density = |p: &Parameters| {
        let length = wavelength(p);
        DENSITY / (length * length)
    };
    let densest = maps.parameters.iter().map(density).fold(0.0, f64::max);
    let mut all = drawn.to_vec();
    for _ in 0..(densest * w * h).ceil() as usize {
        let at = [rng.random::<f64>() * w, rng.random::<f64>() * h];
        let (keep, one, other) = (rng.random::<f64>(), rng.random::<f64>(), rng.random::<f64>());
        let p = maps.at(at);
        if keep * densest > density(&p) || !clear(at, wavelength(&p)) {
            continue;
        }
        // A difference of two uniform random numbers has a variance of 1/6.
        let way = (f64::from(p.direction) + JITTER * 6.0f64.sqrt() * (one - other)).to_radians();
        let half = [libm::cos(way), libm::sin(way)].map(|part| 0.5 * LENGTH * wavelength(&p) * part);
        let end = |sign: f64| [(at[0] + sign * half[0]) / w, (at[1] + sign * half[1]) / h];
        all.push(GuideLine { from: end(-1.0), to: end(1.0) });
    }
    all
}

/// Strength of the seed in each cell of the grid of `maps`, 0..1, for these segments.
pub fn seeded(maps: &ParameterField, segments: &[GuideLine], wavelength: Wavelength) -> Vec<f32> {
    let grid = maps.domain;
    let bounds = grid.bounds();
    let mut seeded = vec![0.0f32; grid.cells()];
    for segment in segments {
        let [low, high] = segment.box_of(&bounds);
        let midpoint = [0, 1].map(|axis| 0.5 * (low[axis] + high[axis]));
        let thick = THICKNESS * wavelength(&maps.at(midpoint));
        let margin = thick + 1.0;
        let corners = [low.map(|at| at - margin), high.map(|at| at + margin)];
        for (cell, _) in grid.within(corners, 0..grid.cells()) {
            let away = segment.distance(grid.center(cell), &bounds);
            seeded[cell] = seeded[cell].max((thick + 0.5 - away).clamp(0.0, 1.0) as f32);
        }
    }
    seeded
}

/// Waves that travel outwards from the `lines`, −1..1: cos 2πφ with |∇φ| = 1/λ and φ = 0 on the lines.
///
/// Fast sweeping: Zhao, "A fast sweeping method for eikonal equations", Mathematics of Computation 74 (2005), eq. 2.4.
pub fn waves(maps: &ParameterField, lines: &[GuideLine], wavelength: Wavelength) -> Vec<f32> {
    let bounds = maps.domain.bounds();
    let steps: Vec<f32> = maps.parameters.par_iter().map(|p| (1.0 / wavelength(p)) as f32).collect();
    let mut phase = vec![f32::INFINITY; maps.domain.cells()];
    phase.par_iter_mut().enumerate().for_each(|(cell, phase)| {
        let nearest = |line: &GuideLine| line.distance(maps.domain.center(cell), &bounds);
        let away = lines.iter().map(nearest).fold(f64::INFINITY, f64::min);
        let reached = away as f32 * steps[cell];
        if reached < EXACT {
            *phase = reached;
        }
    });
    for _ in 0..SWEEPS {
        for (down, right) in [(true, true), (true, false), (false, false), (false, true)] {
            sweep(&mut phase, &steps, &maps.domain, down, right);
        }
    }
    phase.into_par_iter().map(|phase| libm::cos(TAU * f64::from(phase)) as f32).collect()
}

/// Largest φ that is computed from the distance to the line: near the line sweeps are least accurate.
const EXACT: f32 = 1.0;
/// Rounds of four sweeps: the second carries waves across the border of a tile.
const SWEEPS: usize = 2;

/// One sweep over all cells, downwards or up, to the right or left.
fn sweep(phase: &mut [f32], steps: &[f32], grid: &Grid, down: bool, right: bool) {
    let ([nx, ny], edges) = (grid.size, grid.edges);
    let order = |k: usize, n: usize, forth: bool| if forth { k } else { n - 1 - k };
    for k in 0..ny {
        let y = order(k, ny, down);
        for l in 0..nx {
            let x = order(l, nx, right);
            let at = |x: isize, y: isize| phase[edges.index(y, ny) * nx + edges.index(x, nx)];
            let (column, row) = (x as isize, y as isize);
            let a = at(column - 1, row).min(at(column + 1, row));
            let b = at(column, row - 1).min(at(column, row + 1));
            let step = steps[y * nx + x];
            let reached = if (a - b).abs() >= step {
                a.min(b) + step
            } else {
                0.5 * (a + b + (2.0 * step * step - (a - b) * (a - b)).sqrt())
            };
            let cell = &mut phase[y * nx + x];
            // Neither neighbour has a value yet: the difference of two infinities is NaN.
            if reached < *cell {
                *cell = reached;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;
    use rand::SeedableRng;
    use rand_pcg::Pcg64Mcg;

    fn wavelength(p: &Parameters) -> f64 {
        81.0 / f64::from(p.rate).sqrt()
    }

    /// Stripes of 16 cells a wavelength, at 30°.
    fn maps(nx: usize, ny: usize, edges: Edges) -> ParameterField {
        let rate = ((81.0 / 16.0) * (81.0 / 16.0)) as f32;
        let p = Parameters { rate, ratio: 1.0, stretch: 1.0, direction: 30.0, pitch: 1.0 };
        ParameterField::uniform([nx, ny], edges, p)
    }

    #[test]
    fn waves_from_a_line_have_the_given_wavelength() {
        let maps = maps(160, 140, Edges::Closed);
        let line = GuideLine { from: [0.4, 0.5], to: [0.6, 0.5] };
        let waves = waves(&maps, &[line], &wavelength);
        let off = |cell: usize| {
            let away = line.distance(maps.domain.center(cell), &maps.domain.bounds());
            (f64::from(waves[cell]) - libm::cos(TAU * away / 16.0)).abs()
        };
        // Sweeps are of first order: after four wavelengths their error is a few tenths of a cell.
        let mean = (0..waves.len()).map(off).sum::<f64>() / waves.len() as f64;
        assert!(mean < 0.1, "{mean}");
    }

    #[test]
    fn waves_cross_the_border_of_a_tile() {
        let line = [GuideLine { from: [0.0, 0.0], to: [0.0, 1.0] }];
        let [wrap, closed] =
            [Edges::Wrap, Edges::Closed].map(|edges| waves(&maps(128, 96, edges), &line, &wavelength));
        let mirrored = |x: usize| (wrap[40 * 128 + x] - wrap[40 * 128 + 127 - x]).abs();
        assert!((0..64).all(|x| mirrored(x) < 1e-3));
        assert!((closed[40 * 128 + 63] - wrap[40 * 128 + 63]).abs() < 1e-3);
    }

    #[test]
    fn segments_have_the_given_density_and_length_and_keep_away_from_drawn_lines() {
        let maps = maps(320, 320, Edges::Closed);
        let drawn = [GuideLine { from: [0.4, 0.4], to: [0.6, 0.5] }];
        let all = segments(&maps, &drawn, &wavelength, &mut Pcg64Mcg::seed_from_u64(1));
        assert!(all[0] == drawn[0] && (185..=200).contains(&all.len()), "{}", all.len());
        let ways = all[1..].iter().map(|segment| {
            let way = [0, 1].map(|axis| 320.0 * (segment.to[axis] - segment.from[axis]));
            assert!(((way[0] * way[0] + way[1] * way[1]).sqrt() - 32.0).abs() < 1e-6);
            let midpoint = [0, 1].map(|axis| 160.0 * (segment.to[axis] + segment.from[axis]));
            assert!(drawn[0].distance(midpoint, &maps.domain.bounds()) >= 20.0);
            libm::atan2(way[1], way[0]).to_degrees() - 30.0
        });
        let squares: f64 = ways.map(|off| off * off).sum();
        let deviation = (squares / (all.len() - 1) as f64).sqrt();
        assert!((4.2..5.8).contains(&deviation), "{deviation}");
    }

    #[test]
    fn a_seeded_line_has_the_given_thickness() {
        let maps = maps(100, 100, Edges::Closed);
        let seeded = seeded(&maps, &[GuideLine { from: [0.2, 0.5], to: [0.8, 0.5] }], &wavelength);
        let across: f32 = (0..100).map(|y| seeded[y * 100 + 50]).sum();
        assert!((f64::from(across) - 2.0 * THICKNESS * 16.0).abs() < 0.5, "{across}");
        assert_eq!((seeded[50 * 100 + 5], seeded[30 * 100 + 50]), (0.0, 0.0));
    }
}
