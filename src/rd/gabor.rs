//! Initial noise of stripes, with their wavelength and direction.
//!
//! n(x) = Σᵢ (1 − r²)² cos(2π (x − xᵢ)·nᵢ/λᵢ + φᵢ), r² = (along/A)² + (across/B)², with the direction of the
//! stripes along and nᵢ across: sparse convolution with oriented waves.
//! Lagae et al., "Procedural noise using sparse Gabor convolution", SIGGRAPH 2009; its Gaussian window is
//! replaced by a polynomial of compact support.

use std::f64::consts::TAU;
use std::ops::Range;

use multiversion::multiversion;
use rand::{Rng, RngExt};
use rayon::prelude::*;

use super::maps::{Maps, Parameters};
use crate::grid::{Domain, Edges, Grid, atan2, sin_cos_degrees};
use crate::rd::line_noise::{Guide, GuideLine, Led, Reach, Wavelength};

/// The kernels of the noise.
#[derive(Clone, Copy, Debug)]
pub struct Kernels {
    /// A and B, their reach along and across the stripes, in wavelengths. Longer kernels give longer stripes with fewer
    /// forks, but follow changes of direction less closely.
    pub reach: [f64; 2],
    /// Kernels in a square wavelength; fewer leave gaps.
    pub density: f64,
}

/// Amplitude of the waves along guide lines in [`phases`]; the standard deviation of the noise is 2.5.
const LEADING: f64 = 4.0;

/// Rows that are summed at once.
const ROWS_A_BAND: usize = 32;

/// Noise over the grid, row by row, of about unit variance.
pub fn noise(maps: &Maps, wavelength: Wavelength, kernels: Kernels, rng: &mut impl Rng) -> Vec<f32> {
    let waves = waves(maps, wavelength, kernels, rng);
    let mut sum = vec![0.0f32; maps.domain.cells()];
    // Each band sums all waves in order, so that the sums do not depend on the number of threads.
    sum.par_chunks_mut(ROWS_A_BAND * maps.domain.size[0]).enumerate().for_each(|(band, sum)| {
        for wave in &waves {
            add(wave, rows(band, sum.len(), maps), &maps.domain, |cells, cos, _| {
                sum[cells].iter_mut().zip(cos).for_each(|(sum, cos)| *sum += *cos);
            });
        }
    });
    // ∫ window² cos² = ½ (π/5) A·B, times density/λ².
    let Kernels { reach: [a, b], density } = kernels;
    let deviation = (0.5 * std::f64::consts::PI / 5.0 * a * b * density).sqrt() as f32;
    for n in &mut sum {
        *n /= deviation;
    }
    sum
}

/// The phase of that noise over the grid, row by row, −π..π: 0 along a crest, however low the noise is there. Crests
/// at phase 0 all have the same height, and end only where two waves cancel each other.
///
/// φ(x) = atan2(Σᵢ ±(1 − r²)² sin(…), Σᵢ (1 − r²)² cos(…)): Tricard et al., "Procedural phasor noise", SIGGRAPH 2019.
/// The direction of a wave is axial, nᵢ and −nᵢ are equivalent: ± chooses the one closer to the direction at the place, so
/// the sign of the phase has no meaning. The phase follows `lines` within `reach`.
pub fn phases(
    maps: &Maps,
    wavelength: Wavelength,
    kernels: Kernels,
    (lines, reach): (&[GuideLine], Reach),
    rng: &mut impl Rng,
) -> Vec<f32> {
    let waves = waves(maps, wavelength, kernels, rng);
    let guide = Guide::new(maps, lines, wavelength, reach);
    let mut phases = vec![0.0f32; maps.domain.cells()];
    phases.par_chunks_mut(ROWS_A_BAND * maps.domain.size[0]).enumerate().for_each(|(band, phases)| {
        let rows = rows(band, phases.len(), maps);
        let first = rows.start as usize * maps.domain.size[0];
        let own = &maps.parameters[first..first + phases.len()];
        let own: Vec<[f64; 2]> = own.iter().map(across).collect();
        let mut sums = vec![[0.0f64; 2]; phases.len()];
        for wave in &waves {
            add(wave, rows.clone(), &maps.domain, |cells, cos, sin| {
                let own = &own[cells.clone()];
                for ((sum, own), (cos, sin)) in sums[cells].iter_mut().zip(own).zip(cos.iter().zip(sin)) {
                    let same = own[0] * wave.n[0] + own[1] * wave.n[1] >= 0.0;
                    sum[0] += f64::from(*cos);
                    sum[1] += f64::from(if same { *sin } else { -sin });
                }
            });
        }
        for (cell, (phase, [cos, sin])) in phases.iter_mut().zip(sums).enumerate() {
            let Led { share, wave } = guide.led(first + cell, own[cell]);
            let [cos, sin] =
                [(cos, wave[0]), (sin, wave[1])].map(|(noise, wave)| (1.0 - share) * noise + LEADING * wave);
            *phase = atan2(sin, cos) as f32;
        }
    });
    phases
}

/// The rows of a band of `cells` cells.
fn rows(band: usize, cells: usize, maps: &Maps) -> Range<isize> {
    let first = band * ROWS_A_BAND;
    first as isize..(first + cells / maps.domain.size[0]) as isize
}

/// The wavelength of each cell.
fn lengths(maps: &Maps, wavelength: Wavelength) -> Vec<f64> {
    let part = |part: &[Parameters]| {
        let mut before: Option<(Parameters, f64)> = None;
        let of = |p: &Parameters| {
            // Mostly the same as beside it.
            let length =
                before.filter(|(same, _)| same == p).map_or_else(|| wavelength(p), |(_, length)| length);
            before = Some((*p, length));
            length
        };
        part.iter().map(of).collect::<Vec<_>>()
    };
    let parts: Vec<Vec<f64>> = maps.parameters.par_chunks(maps.domain.part()).map(part).collect();
    parts.concat()
}

/// Waves at random places.
fn waves(
    maps: &Maps,
    wavelength: Wavelength,
    Kernels { reach, density }: Kernels,
    rng: &mut impl Rng,
) -> Vec<Wave> {
    let [nx, ny] = maps.domain.size;
    let lengths = lengths(maps, wavelength);
    let densest = lengths.iter().map(|length| density / (length * length)).fold(0.0, f64::max);
    // Waves are also placed in a frame beyond closed edges, so that the noise does not fade there.
    let frame = match maps.domain.edges {
        Edges::Wrap => 0.0,
        Edges::Closed => reach[0] * lengths.iter().copied().fold(0.0, f64::max),
    };
    let (w, h) = (nx as f64 + 2.0 * frame, ny as f64 + 2.0 * frame);
    let throws = (densest * w * h).ceil() as usize;
    let mut waves = Vec::new();
    for _ in 0..throws {
        let at = [rng.random::<f64>() * w - frame, rng.random::<f64>() * h - frame];
        let (keep, phase) = (rng.random::<f64>(), rng.random::<f64>());
        let p = maps.at(at);
        let length = lengths[maps.domain.cell_at(at)];
        if keep * densest <= density / (length * length) {
            waves.push(Wave::new(at, &p, reach, length, phase));
        }
    }
    waves
}

/// The unit vector across the stripes that have these parameters.
fn across(p: &Parameters) -> [f64; 2] {
    let (sin, cos) = sin_cos_degrees(f64::from(p.direction) + 90.0);
    [cos, sin]
}

/// One wave under its window.
struct Wave {
    at: [f64; 2],
    /// Unit vector across.
    n: [f64; 2],
    /// a, b, c of the window 1 − (a·dx² + 2b·dx·dy + c·dy²).
    window: [f64; 3],
    /// By how much its phase grows a cell along x and y, radians.
    turns: [f64; 2],
    /// Cosines and sines of what it grows by along x within a block.
    turned: [[f32; BLOCK]; 2],
    /// Cosine and sine of what it grows by along a whole block.
    leap: [f64; 2],
    /// The phase at its middle, radians.
    phase: f64,
}

impl Wave {
    /// One of these parameters, `length` cells long; it reaches `reach` lengths along and across. The `phase` is a share of a wave.
    fn new(at: [f64; 2], p: &Parameters, reach: [f64; 2], length: f64, phase: f64) -> Self {
        let ([far, near], n) = (reach.map(|reach| reach * length), across(p));
        let window = [
            n[1] * n[1] / (far * far) + n[0] * n[0] / (near * near),
            n[0] * n[1] * (1.0 / (near * near) - 1.0 / (far * far)),
            n[0] * n[0] / (far * far) + n[1] * n[1] / (near * near),
        ];
        let turns = n.map(|n| TAU / length * n);
        let mut turned = [[0.0; BLOCK]; 2];
        let turn = |k: usize| sin_cos_degrees((k as f64 * turns[0]).to_degrees());
        let [cosines, sines] = &mut turned;
        for (k, (cos, sin)) in cosines.iter_mut().zip(sines).enumerate() {
            let (s, c) = turn(k);
            (*cos, *sin) = (c as f32, s as f32);
        }
        let (sin, cos) = turn(BLOCK);
        Self { at, n, window, turns, turned, leap: [cos, sin], phase: TAU * phase }
    }

    /// The cells within reach in row `y` of the canvas, which may lie beyond its border, and begin at cell `first` of those that are
    /// summed.
    #[inline(always)]
    fn chord(&self, y: isize, first: usize, grid: &Grid) -> Chord {
        let ([nx, _], edges) = (grid.size, grid.edges);
        let ([a, b, c], [kx, ky]) = (self.window, self.turns);
        let dy = y as f64 + 0.5 - self.at[1];
        let midpoint = -b * dy / a;
        let half = (midpoint * midpoint - (c * dy * dy - 1.0) / a).max(0.0).sqrt();
        let begin = (self.at[0] - 0.5 + midpoint - half).ceil() as isize;
        let mut columns = begin..(self.at[0] - 0.5 + midpoint + half).floor() as isize + 1;
        if edges == Edges::Closed {
            columns = columns.start.max(0)..columns.end.min(nx as isize);
        }
        let dx = columns.start as f64 + 0.5 - self.at[0];
        let start = self.phase + dx * kx + dy * ky;
        Chord { first, dy, columns, start }
    }
}

/// Cells of a row that are computed side by side. Not tuned.
const BLOCK: usize = 16;

/// Calls `sum` with runs of the cells that `wave` reaches in the rows `rows` (counted from the first of them), its values under the
/// window, and the same a quarter of a wave behind.
#[multiversion(targets("x86_64+avx2"))]
fn add(wave: &Wave, rows: Range<isize>, grid: &Grid, mut sum: impl FnMut(Range<usize>, &[f32], &[f32])) {
    let [a, b, c] = wave.window;
    let tall = (a / (a * c - b * b)).sqrt();
    let [first, last] =
        [(wave.at[1] - 0.5 - tall).ceil() as isize, (wave.at[1] - 0.5 + tall).floor() as isize];
    let [nx, ny] = grid.size.map(|side| side as isize);
    // On a tile a row is also those so many tiles above and below.
    let tiles = match grid.edges {
        Edges::Closed => 0..=0,
        Edges::Wrap => first.div_euclid(ny)..=last.div_euclid(ny),
    };
    for tile in tiles {
        let shift = tile * ny;
        for row in rows.start.max(first - shift)..rows.end.min(last + 1 - shift) {
            let chord = wave.chord(row + shift, ((row - rows.start) * nx) as usize, grid);
            add_chord(wave, &chord, grid, &mut sum);
        }
    }
}

/// The same for these cells.
#[inline(always)]
fn add_chord(wave: &Wave, chord: &Chord, grid: &Grid, sum: &mut impl FnMut(Range<usize>, &[f32], &[f32])) {
    let nx = grid.size[0];
    let Chord { first, dy, columns, start } = chord;
    // The window along the row is 1 − (a·dx² + linear·dx + constant).
    let [a, b, c] = wave.window;
    let [a, linear, constant] = [a, 2.0 * b * dy, c * dy * dy].map(|part| part as f32);
    let (mut sin, mut cos) = sin_cos_degrees(start.to_degrees());
    let [turned_cos, turned_sin] = &wave.turned;
    for done in (0..columns.len()).step_by(BLOCK) {
        let begin = columns.start + done as isize;
        let from = (begin as f64 + 0.5 - wave.at[0]) as f32;
        let turn = [cos as f32, sin as f32];
        let mut values = [[0.0; BLOCK]; 2];
        for k in 0..BLOCK {
            let dx = from + k as f32;
            let window = (1.0 - ((a * dx + linear) * dx + constant)).max(0.0);
            let height = window * window;
            // cos(α + β) and sin(α + β) by the angle-sum rule: no cosine a cell.
            values[0][k] = height * (turn[0] * turned_cos[k] - turn[1] * turned_sin[k]);
            values[1][k] = height * (turn[1] * turned_cos[k] + turn[0] * turned_sin[k]);
        }
        // On a tile those beyond a border lie at the other one.
        let (mut k, count) = (0, (columns.len() - done).min(BLOCK));
        while k < count {
            let column = grid.edges.index(begin + k as isize, nx);
            let run = (count - k).min(nx - column);
            sum(first + column..first + column + run, &values[0][k..k + run], &values[1][k..k + run]);
            k += run;
        }
        let [leap_cos, leap_sin] = wave.leap;
        (cos, sin) = (cos * leap_cos - sin * leap_sin, sin * leap_cos + cos * leap_sin);
    }
}

/// The cells of a row that a wave reaches.
struct Chord {
    /// The first cell of the row.
    first: usize,
    /// How far the row is from the middle of the wave, cells.
    dy: f64,
    columns: Range<isize>,
    /// The phase of the wave at the first of them.
    start: f64,
}

#[cfg(test)]
mod tests {
    use rand::SeedableRng;
    use rand_pcg::Pcg64Mcg;

    use super::*;

    const KERNELS: Kernels = Kernels { reach: [8.0, 4.0], density: 0.6 };
    const REACH: Reach = Reach { beyond: [0.0, 4.0], across: [0.4, 3.0] };

    /// Crests that each column of a grid crosses ÷ those of waves of 10 cells along x, where directions change from `left` to
    /// `right` degrees.
    fn crossed(left: f32, right: f32) -> f64 {
        const N: usize = 160;
        let p = Parameters { rate: 1.0, ratio: 20.0, stretch: 0.35, direction: 0.0, pitch: 1.0 };
        let mut maps = Maps::uniform([N, N], Edges::Closed, p);
        for (cell, p) in maps.parameters.iter_mut().enumerate() {
            let share = (cell % N) as f32 / N as f32;
            // Directions of parameters are 0..180.
            p.direction = (left + share * (right - left)).rem_euclid(180.0);
        }
        let phases = phases(&maps, &|_| 10.0, KERNELS, (&[], REACH), &mut Pcg64Mcg::seed_from_u64(1));
        let crest = |cell: usize| phases[cell].abs() < 0.8;
        let begins = (N..N * N).filter(|cell| crest(*cell) && !crest(cell - N)).count();
        begins as f64 / (N * N) as f64 * 10.0
    }

    #[test]
    fn crests_are_one_wavelength_apart_also_where_directions_wrap_from_180_to_0_degrees() {
        for (left, right) in [(30.0, 20.0), (5.0, -5.0), (176.0, 190.0)] {
            // Along y, waves at 25° are 1/cos 25° = 1.1 times as long.
            let share = crossed(left, right);
            assert!((0.82..1.08).contains(&share), "{left}° to {right}°: {share}");
        }
    }

    #[test]
    fn the_number_of_threads_changes_no_phase() {
        let p = Parameters { rate: 1.0, ratio: 20.0, stretch: 0.35, direction: 33.0, pitch: 1.0 };
        let maps = Maps::uniform([90, 70], Edges::Wrap, p);
        let phases = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
            pool.install(|| phases(&maps, &|_| 9.0, KERNELS, (&[], REACH), &mut Pcg64Mcg::seed_from_u64(2)))
        };
        assert!(phases(1) == phases(4));
    }
}
