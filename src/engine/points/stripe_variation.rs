//! Stripes whose width varies along them, down to pointed tips, and which open into two where they are wide, as on tigers.
//!
//! ```text
//! s = min(h′ − r, r − l),   h′ = h·(1 + v·n + O·clamp(u + ½, 0, 1)),   l = max(h′, 0)·clamp(u, −1, I)
//! ```
//! The ink lies where s > 0. r is the distance from the middle line of the stripe, found as h minus the depth inside its edge; h is half
//! of the width of the stripes around the place, from the mean depth there. n is noise with the deviation 1, n̄ = 0, long along the
//! stripes: noise averaged along a line that follows them. u is another such noise minus the level that the share `double` of the
//! ink exceeds: where it is positive, the stripe opens by l on both sides of its middle line. A stripe grows by at most `ROOM` of the
//! gap beside it. Then the level of the edge is found again, so that the covered area stays: the mean width and the distance of the
//! stripes are those of the plain ones.

use rayon::prelude::*;

use super::level::{relevel, share_above};
use super::noise::Noise;
use super::stripe_widths::{StripeWidths, depths};
use crate::grid::blur::boxes;
use crate::grid::{Domain, Field, Grid, atan2};

/// How the width of stripes varies along them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StripeVariation {
    /// v: standard deviation ÷ mean of the width along a stripe, 0–[`Self::MOST_VARY`]. Where the width falls to 0, the stripe ends in
    /// a point.
    pub vary: f64,
    /// The share of the stripes that open into two, 0–1.
    pub double: f64,
}

impl StripeVariation {
    /// The highest v: above it stripes are chains of blots.
    pub const MOST_VARY: f64 = 0.8;

    /// Whether stripes stay as they are.
    #[must_use]
    pub fn is_none(&self) -> bool {
        self.vary == 0.0 && self.double == 0.0
    }
}

/// The edge of a mark.
const EDGE: f32 = 0.5;
/// O: how much wider a stripe is where it opens, in its half width, so that what lies beside the opening is no hairline.
const OPENED: f64 = 0.7;
/// I: the largest half width of the opening, in that of the opened stripe: as much ink as ground, as on tigers.
const INNER: f64 = 0.5;
/// The noise of openings rises from the level to a full opening within this number of its deviations: the ends of openings are
/// lenses, not slits.
const RISE: f64 = 0.6;
/// The largest growth of a stripe at each side, in half of the gap beside it: two wide stripes side by side stay apart.
const ROOM: f64 = 0.65;
/// The least half width from which the pattern falls to an edge, in that of the stripe.
const THIN: f64 = 0.3;
/// Where stripes end or are thin, gaps are wide: a slope over the whole gap would show where the stripe was. It is shorter by this
/// share, where `vary` and `double` add up to `STEEP`, and as long as it was where nothing varies.
const STEEPER: f64 = 0.7;
const STEEP: f64 = 0.3;
/// Radius of the noise of widths and of openings, in periods. Shorter waves make chains of beads.
const RADII: [f64; 2] = [0.5, 0.7];
/// Places along a stripe whose noise is averaged, to each side, and the distance of two, in periods: waves of about 2.4 and 3.6
/// periods along stripes, as between the swellings of a tiger's.
const PLACES: [usize; 2] = [4, 6];
const STEP: f64 = 0.3;
/// Combined with the seed, so that the noise of openings has random numbers of its own.
const SECOND: u64 = 0x9E37_79B9_7F4A_7C15;

/// The `stripes`, 0..1 with edges at ½, varied; unchanged where nothing is asked for, and where there are no edges.
#[must_use]
pub fn varied(stripes: &Field, by: &StripeVariation, seed: u64) -> Field {
    let Some(depths) = depths(stripes).filter(|_| !by.is_none()) else { return stripes.clone() };
    let grid = stripes.grid();
    let widths = StripeWidths::new(&depths, &grid);
    let along = directions(&depths, &grid, widths.mean[0]);
    let noise = |which: usize, seed: u64| {
        let radius = RADII[which] * widths.period();
        let noise = Noise { radius, octaves: 1, fold: false, seed }.field(&grid);
        normalised(lengthened(&noise, &along, STEP * widths.period(), PLACES[which], widths.mean[0]), &depths)
    };
    let n = noise(0, seed);
    let u = (by.double > 0.0).then(|| {
        let noise = noise(1, seed ^ SECOND);
        let level = exceeded(&noise, &depths, by.double);
        noise.into_iter().map(|noise| (noise - level) / RISE as f32).collect::<Vec<_>>()
    });
    let fall = 1.0 - STEEPER * ((by.vary + by.double) / STEEP).min(1.0);
    let value = |cell: usize| {
        let open = u.as_ref().map_or(-1.0, |u| f64::from(u[cell]));
        value(&widths, cell, f64::from(depths[cell]), [by.vary * f64::from(n[cell]), open], fall)
    };
    let values = (0..grid.cells()).into_par_iter().map(value).collect();
    let mut out = Field { values, ..stripes.clone() };
    relevel(&mut out, share_above(stripes, EDGE));
    out
}

/// The pattern at a cell of this `depth`, where the width differs by the factor 1 + `wider`, and the stripe opens by `open`. It
/// reaches 0 within the share `fall` of the half of a gap.
fn value(widths: &StripeWidths, cell: usize, depth: f64, [wider, open]: [f64; 2], fall: f64) -> f32 {
    let [half, gap] = [0, 1].map(|side| f64::from(widths.halves[side][cell]));
    let wider = half * (1.0 + wider + OPENED * (open + 0.5).clamp(0.0, 1.0));
    let wider = wider.min(half + ROOM * gap);
    let inner = wider.max(0.0) * open.clamp(-1.0, INNER);
    let from_middle = half - depth;
    let ink = (wider - from_middle).min(from_middle.max(0.0) - inner);
    // Thin stripes and the halves of open ones are as dark in their middle as others, and thin openings nearly as light.
    let thick = if inner > 0.0 { 0.5 * (wider - inner) } else { wider };
    let least = THIN * half;
    let over = if ink > 0.0 {
        thick.clamp(least, half)
    } else if from_middle < inner {
        inner.max(least)
    } else {
        fall * gap
    };
    (0.5 + 0.5 * ink / over).clamp(0.0, 1.0) as f32
}

/// Unit vectors along the stripes at each cell, from the structure tensor of the depths under a bell of `reach` px.
fn directions(depths: &[f32], grid: &Grid, reach: f64) -> Vec<[f32; 2]> {
    let [nx, ny] = grid.size;
    let at = |x: isize, y: isize| depths[grid.edges.index(y, ny) * nx + grid.edges.index(x, nx)];
    let gradient = |cell: usize| {
        let [x, y] = [(cell % nx) as isize, (cell / nx) as isize];
        let across = (at(x + 1, y) - at(x - 1, y)) / grid.cell[0] as f32;
        let down = (at(x, y + 1) - at(x, y - 1)) / grid.cell[1] as f32;
        [across * across - down * down, 2.0 * across * down]
    };
    let doubled: Vec<[f32; 2]> = (0..nx * ny).into_par_iter().map(gradient).collect();
    let radius = ((reach / grid.px_a_cell()).round() as usize).max(1);
    let [cos, sin] = [0, 1].map(|part| {
        let part: Vec<f32> = doubled.iter().map(|of| of[part]).collect();
        boxes(&part, grid.size, grid.edges, radius)
    });
    let along = |(cos, sin): (&f32, &f32)| {
        // The gradient runs across the stripes.
        let angle = 0.5 * atan2(f64::from(*sin), f64::from(*cos)) + std::f64::consts::FRAC_PI_2;
        [libm::cos(angle) as f32, libm::sin(angle) as f32]
    };
    cos.par_iter().zip(&sin).map(along).collect()
}

/// The `noise`, averaged at each cell over 2·`places` + 1 places, `step` px apart, on a line that follows the directions, and over
/// `half` px across it.
fn lengthened(noise: &Field, along: &[[f32; 2]], step: f64, places: usize, half: f64) -> Vec<f32> {
    let grid = noise.grid();
    let canvas = grid.bounds_px();
    let walk = |cell: usize, side: f32| {
        let (mut at, mut way) = (grid.center_px(cell), along[cell].map(|of| side * of));
        let mut sum = 0.0;
        for _ in 0..places {
            at = canvas.inside([0, 1].map(|axis| at[axis] + step * f64::from(way[axis])));
            let here = grid.cell_at(grid.to_cells(at));
            sum += noise.values[here];
            let next = along[here];
            let turned = if next[0] * way[0] + next[1] * way[1] < 0.0 { -1.0 } else { 1.0 };
            way = next.map(|of| turned * of);
        }
        sum
    };
    let mean =
        |cell: usize| (noise.values[cell] + walk(cell, 1.0) + walk(cell, -1.0)) / (2 * places + 1) as f32;
    let means: Vec<f32> = (0..grid.cells()).into_par_iter().map(mean).collect();
    // Both edges of a stripe move alike. Besides, places are rounded to cells.
    let radius = (half / grid.px_a_cell()).round().max(1.0) as usize;
    boxes(&means, grid.size, grid.edges, radius.min(grid.size[0].min(grid.size[1])))
}

/// The noise with the mean 0 and the deviation 1 inside the marks.
fn normalised(mut noise: Vec<f32>, depths: &[f32]) -> Vec<f32> {
    let mean = |of: &dyn Fn(f64) -> f64| {
        let inside = noise.iter().zip(depths).filter(|(_, depth)| **depth > 0.0);
        let (sum, count) =
            inside.fold((0.0, 0.0), |(sum, count), (n, _)| (sum + of(f64::from(*n)), count + 1.0));
        sum / f64::max(count, 1.0)
    };
    let middle = mean(&|n| n);
    let deviation = mean(&|n| (n - middle) * (n - middle)).sqrt().max(1e-6);
    noise.iter_mut().for_each(|n| *n = ((f64::from(*n) - middle) / deviation) as f32);
    noise
}

/// The value that this share of the noise inside the marks exceeds.
fn exceeded(noise: &[f32], depths: &[f32], share: f64) -> f32 {
    let mut inside: Vec<f32> =
        noise.iter().zip(depths).filter(|(_, depth)| **depth > 0.0).map(|(noise, _)| *noise).collect();
    inside.sort_unstable_by(f32::total_cmp);
    let rank = ((1.0 - share) * inside.len() as f64) as usize;
    inside.get(rank).or(inside.last()).copied().unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges as Borders;

    /// Stripes down a tile of 480 × 480 px, 24 px apart and 10 px wide.
    fn stripes() -> Field {
        Field::from_fn([480, 480], [1.0, 1.0], Borders::Wrap, |[x, _]| {
            let from_middle = ((x + 7.3).rem_euclid(24.0) - 12.0).abs();
            (0.5 + (5.0 - from_middle) / 10.0).clamp(0.0, 1.0) as f32
        })
    }

    /// The share of the way between two px that is above the edge.
    fn above(from: f32, to: f32) -> f64 {
        let [from, to] = [from, to].map(|value| f64::from(value - EDGE));
        let (low, high) = (from.min(to), from.max(to));
        if low >= 0.0 { 1.0 } else { high.max(0.0) / (high - low).max(1e-9) }
    }

    /// The ink of each stripe in each row, px, and the number of its pieces.
    fn in_rows(field: &Field) -> Vec<(f64, usize)> {
        let of = |row: &[f32], stripe: usize| {
            let px: Vec<f32> = (0..25).map(|x| row[(stripe * 24 + x + 480 - 7) % 480]).collect();
            let ink = px.windows(2).map(|ends| above(ends[0], ends[1])).sum();
            let begins = |x: usize| px[x] >= EDGE && (x == 0 || px[x - 1] < EDGE);
            (ink, (0..24).filter(|x| begins(*x)).count())
        };
        field.values.chunks(480).flat_map(|row| (0..20).map(move |stripe| of(row, stripe))).collect()
    }

    fn moments(widths: impl Iterator<Item = f64> + Clone) -> [f64; 2] {
        let count = widths.clone().count() as f64;
        let mean = widths.clone().sum::<f64>() / count;
        let square = widths.map(|width| (width - mean) * (width - mean)).sum::<f64>() / count;
        [mean, square.sqrt()]
    }

    #[test]
    fn the_width_varies_along_stripes_as_much_as_is_asked_and_keeps_its_mean() {
        let plain = stripes();
        for vary in [0.15, 0.3] {
            let varied = varied(&plain, &StripeVariation { vary, double: 0.0 }, 5);
            let [mean, deviation] = moments(in_rows(&varied).into_iter().map(|(ink, _)| ink));
            assert!((mean / 10.0 - 1.0).abs() < 0.02, "{vary}: {mean}");
            assert!((deviation / mean / vary - 1.0).abs() < 0.15, "{vary}: {}", deviation / mean);
            assert!((share_above(&varied, EDGE) / share_above(&plain, EDGE) - 1.0).abs() < 5e-3);
        }
    }

    #[test]
    fn stripes_that_vary_much_end_in_points_and_do_not_merge() {
        let varied = varied(&stripes(), &StripeVariation { vary: 0.6, double: 0.0 }, 5);
        let rows = in_rows(&varied);
        let ended = rows.iter().filter(|(ink, _)| *ink == 0.0).count() as f64 / rows.len() as f64;
        assert!((0.01..0.12).contains(&ended), "{ended}");
        assert!(rows.iter().all(|(ink, _)| *ink < 22.0));
    }

    #[test]
    fn the_asked_share_of_the_stripes_opens_into_two() {
        for double in [0.25, 0.5] {
            let varied = varied(&stripes(), &StripeVariation { vary: 0.0, double }, 5);
            let rows = in_rows(&varied);
            let opened = rows.iter().filter(|(_, pieces)| *pieces == 2).count() as f64 / rows.len() as f64;
            assert!((opened - double).abs() < 0.12, "{double}: {opened}");
            assert!((share_above(&varied, EDGE) / (10.0 / 24.0) - 1.0).abs() < 0.01);
        }
    }

    #[test]
    fn nothing_asked_changes_nothing_and_the_seed_decides() {
        let plain = stripes();
        assert_eq!(varied(&plain, &StripeVariation::default(), 5), plain);
        let by = StripeVariation { vary: 0.3, double: 0.2 };
        assert_eq!(varied(&plain, &by, 5), varied(&plain, &by, 5));
        assert_ne!(varied(&plain, &by, 5), varied(&plain, &by, 6));
    }

    #[test]
    fn varied_stripes_have_no_seam_on_a_tile() {
        let varied = varied(&stripes(), &StripeVariation { vary: 0.4, double: 0.3 }, 5);
        let step = |a: usize, b: usize| {
            let of_column =
                |x: usize| f64::from((varied.values[a * 480 + x] - varied.values[b * 480 + x]).abs());
            (0..480).map(of_column).fold(0.0, f64::max)
        };
        let inner = (0..479).map(|y| step(y, y + 1)).fold(0.0, f64::max);
        assert!(step(479, 0) <= inner, "{} {inner}", step(479, 0));
    }
}
