//! Rosettes: patches whose rims break up into blotches, as on leopards and jaguars.
//!
//! In polar coordinates about the centre of a patch of radius r, n blotches lie side by side, each in a sector 2πr ÷ n long. With d
//! the depth inside the outline and f the place in a sector,
//!
//! ```text
//! f = frac(n·(φ + bow·sin(φ + φ₂) + φ₁) / 2π)
//! W = w·size·e^N(0, .25)·(1 + .18·noise),   size = clamp(√(area ÷ mean area), .6, 1.35)
//! ```
//! a blotch is a bar with round corners: W deep from the outline inwards, and as long as its sector but for a gap of .35·w. The
//! outlines of the patches stay where they are, but that noise makes the rims of blotches uneven. Inside, what is no ink has the
//! `tint` of its rosette, below the level of an edge.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;

use super::depth;
use super::labels::normal;
use super::noise::Noise;
use crate::grid::{Bounds, Domain, Edges, Field, UnionFind, atan2, sin_cos_degrees};

/// What rosettes are like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rosettes {
    /// The least and the greatest number of blotches around a rosette.
    pub parts: [u32; 2],
    /// The share of the patches that stay solid; small ones do so more often.
    pub solid: f64,
    /// How deep blotches are, px; `None` = [`Self::WIDTH`] of √area of a mean patch.
    pub width: Option<f64>,
    /// The greatest number of dots inside a rosette, at least one where it is not 0.
    pub dots: u32,
    /// The pattern inside the most tinted rosette, 0 (ground) to below ½ (an edge). That inside another is 0.45 to 1 times as high.
    pub tint: f64,
}

impl Default for Rosettes {
    /// The blotches of a leopard.
    fn default() -> Self {
        Self { parts: [3, 5], solid: 0.25, width: None, dots: 0, tint: 0.3 }
    }
}

impl Rosettes {
    /// Depth of blotches ÷ √area of a patch, where no width is given.
    pub const WIDTH: f64 = 0.22;

    /// The depth of blotches on patches of this mean area, px.
    #[must_use]
    pub fn width_on(&self, area: f64) -> f64 {
        self.width.unwrap_or(Self::WIDTH * area.sqrt())
    }
}

/// The edge of a mark.
const EDGE: f32 = 0.5;
/// Standard deviation of the logarithm of the depth of a blotch.
const DEPTH_SPREAD: f64 = 0.25;
/// Waves of the noise that makes rims uneven, in depths of a blotch.
const UNEVEN_SIZE: f64 = 1.4;
/// How far rims are moved by it, in depths of a blotch.
const UNEVEN: f64 = 0.08;
/// The greatest turn of the places of blotches, radians.
const MOST_BOW: f64 = 0.5;
/// The gap between two blotches, in depths of a blotch.
const GAP: f64 = 0.35;
/// The least length of a blotch, in its sector.
const LEAST_LENGTH: f64 = 0.4;
/// The radius of the corners of a blotch, in half of its shorter side.
const ROUND: f64 = 0.9;
/// How much faster the pattern falls outside of a patch than inside, where its slope shows the tint.
const STEEP: f64 = 5.0;
/// Distance of dots from the middle, and their radius, in √area.
const DOTS: [[f64; 2]; 2] = [[0.13, 0.2], [0.055, 0.09]];
/// Difference between the seeds of marks: an odd number.
const MARK_SEED: u64 = 0x9E37_79B9_7F4A_7C15;

/// A patch that may become a rosette.
struct Mark {
    center: [f64; 2],
    area: f64,
    /// `None` = it stays solid.
    rosette: Option<Rosette>,
}

/// The random numbers of a rosette.
struct Rosette {
    parts: f64,
    /// φ₁ and φ₂, radians.
    phases: [f64; 2],
    bow: f64,
    /// r, px.
    radius: f64,
    /// W of each blotch, without noise, px.
    depths: Vec<f64>,
    /// Middle and radius of each dot, px.
    dots: Vec<([f64; 2], f64)>,
    tint: f64,
}

/// The pattern of rosettes in the outlines of `patches`, 0..1 with its edges at ½.
#[must_use]
pub fn rosettes(patches: &Field, of: &Rosettes, seed: u64) -> Field {
    let grid = patches.grid();
    let (owners, mut marks) = marks(patches);
    if marks.is_empty() {
        return patches.clone();
    }
    let mean = marks.iter().map(|mark| mark.area).sum::<f64>() / marks.len() as f64;
    let width = of.width_on(mean);
    draw(&mut marks, of, width, mean, seed);
    let Some(edges) = depth::Edges::new(patches) else { return patches.clone() };
    let noise = Noise { radius: UNEVEN_SIZE * width, octaves: 1, fold: false, seed };
    let noise = noise.field(&grid);
    let canvas = grid.bounds_px();
    let value = |cell: usize| {
        let Some((depth, beside)) = edges.depth(cell) else { return patches.values[cell] };
        let mark = &marks[owners[if edges.is_inside(cell) { cell } else { beside }] as usize];
        let Some(rosette) = &mark.rosette else { return patches.values[cell] };
        // From 0..1 to −2..2, so that its deviation is about 1.
        let uneven = f64::from(4.0 * noise.values[cell] - 2.0);
        let away = canvas.shortest([0, 1].map(|axis| grid.center_px(cell)[axis] - mark.center[axis]));
        let ink = rosette.ink(away, depth, uneven, width);
        let within = (depth / (0.5 * width)).clamp(0.0, 1.0) * rosette.tint;
        let steep = if depth < 0.0 { STEEP } else { 1.0 };
        (0.5 + steep * ink / width).clamp(within.min(0.5), 1.0) as f32
    };
    let values = (0..grid.cells()).into_par_iter().map(value).collect();
    Field { values, ..patches.clone() }
}

impl Rosette {
    /// How deep a place is in the ink, px; negative outside of it. It is `away` from the centre of the rosette and `depth` inside its
    /// outline.
    fn ink(&self, away: [f64; 2], depth: f64, uneven: f64, width: f64) -> f64 {
        let turn = std::f64::consts::TAU;
        let angle = atan2(away[1], away[0]);
        let bow = self.bow * libm::sin(angle + self.phases[1]);
        let at = self.parts * (angle + bow + self.phases[0]) / turn;
        let (blotch, place) = (at.floor(), at - at.floor());
        let blotch = blotch.rem_euclid(self.parts) as usize % self.depths.len();
        let deep = self.depths[blotch] * (1.0 + 0.18 * uneven);
        let sector = turn * self.radius / self.parts;
        let long = (sector - GAP * width).max(LEAST_LENGTH * sector);
        let depth = depth + UNEVEN * width * uneven;
        let of_blotch = inside_bar([(place - 0.5) * sector, depth - 0.5 * deep], [0.5 * long, 0.5 * deep]);
        let of_dot = |(middle, radius): &([f64; 2], f64)| {
            let [x, y] = [away[0] - middle[0], away[1] - middle[1]];
            (radius - (x * x + y * y).sqrt()).min(depth)
        };
        self.dots.iter().map(of_dot).fold(of_blotch, f64::max)
    }
}

/// How deep a place, from the middle of a bar with round corners, lies inside it; negative outside. The bar has these half sides.
fn inside_bar(at: [f64; 2], half: [f64; 2]) -> f64 {
    let corner = ROUND * half[0].min(half[1]);
    let [x, y] = [0, 1].map(|axis| at[axis].abs() - (half[axis] - corner));
    let beyond = (x.max(0.0) * x.max(0.0) + y.max(0.0) * y.max(0.0)).sqrt();
    corner - beyond - x.max(y).min(0.0)
}

/// The patch of each cell (of cells outside any number), and all patches.
fn marks(patches: &Field) -> (Vec<u32>, Vec<Mark>) {
    let grid = patches.grid();
    let Bounds { size, .. } = grid.bounds_px();
    let mut sets = connected(patches);
    let mut owners = vec![0; patches.values.len()];
    let mut marks: Vec<Mark> = Vec::new();
    let px = grid.cell[0] * grid.cell[1];
    // A root is the lowest cell of its set, so it comes first.
    for cell in (0..owners.len()).filter(|cell| patches.values[*cell] >= EDGE) {
        let (root, canvases) = sets.find(cell as u32);
        if root as usize == cell {
            owners[cell] = marks.len() as u32;
            marks.push(Mark { center: [0.0; 2], area: 0.0, rosette: None });
        }
        owners[cell] = owners[root as usize];
        let mark = &mut marks[owners[cell] as usize];
        let at = grid.center_px(cell);
        for axis in [0, 1] {
            mark.center[axis] += px * (at[axis] + f64::from(canvases[axis]) * size[axis]);
        }
        mark.area += px;
    }
    for mark in &mut marks {
        mark.center = mark.center.map(|sum| sum / mark.area);
    }
    (owners, marks)
}

/// The sets of connected cells of patches.
fn connected(patches: &Field) -> UnionFind {
    let (nx, ny) = (patches.width, patches.height);
    let wraps = patches.edges == Edges::Wrap;
    let inside = |cell: usize| patches.values[cell] >= EDGE;
    let mut sets = UnionFind::new(nx * ny);
    for cell in (0..nx * ny).filter(|cell| inside(*cell)) {
        let (x, y) = (cell % nx, cell / nx);
        let right =
            if x + 1 < nx { Some((cell + 1, [0, 0])) } else { wraps.then_some((cell + 1 - nx, [1, 0])) };
        let below = if y + 1 < ny { Some((cell + nx, [0, 0])) } else { wraps.then_some((x, [0, 1])) };
        for (beside, apart) in [right, below].into_iter().flatten().filter(|(beside, _)| inside(*beside)) {
            sets.join(cell as u32, beside as u32, apart);
        }
    }
    sets
}

/// Draws lots for all marks: which stay solid, and what the others are like.
fn draw(marks: &mut [Mark], of: &Rosettes, width: f64, mean: f64, seed: u64) {
    let mut by_area: Vec<usize> = (0..marks.len()).collect();
    by_area.sort_by(|a, b| marks[*a].area.total_cmp(&marks[*b].area));
    let count = marks.len() as f64;
    for (rank, index) in by_area.into_iter().enumerate() {
        let mut rng = Pcg64Mcg::seed_from_u64(seed.wrapping_add((index as u64 + 1).wrapping_mul(MARK_SEED)));
        // (1 − rank)^k has the mean 1 ÷ (k + 1).
        let rank = (rank as f64 + 0.5) / count;
        let is_solid = of.solid > 0.0 && rng.random::<f64>() < libm::pow(1.0 - rank, 1.0 / of.solid - 1.0);
        if !is_solid {
            marks[index].rosette = Some(drawn(&marks[index], of, width, mean, &mut rng));
        }
    }
}

fn drawn(mark: &Mark, of: &Rosettes, width: f64, mean: f64, rng: &mut Pcg64Mcg) -> Rosette {
    let turn = std::f64::consts::TAU;
    let between = |[low, high]: [f64; 2], rng: &mut Pcg64Mcg| low + (high - low) * rng.random::<f64>();
    // A whole number of a range, as a number.
    let whole = |[low, high]: [u32; 2], rng: &mut Pcg64Mcg| {
        let [low, high] = [low.min(high), low.max(high)].map(f64::from);
        (low + ((high - low + 1.0) * rng.random::<f64>()).floor()).min(high)
    };
    let parts = whole(of.parts, rng);
    let size = (mark.area / mean).sqrt().clamp(0.6, 1.35);
    let depth = |rng: &mut Pcg64Mcg| width * size * libm::exp(DEPTH_SPREAD * normal(rng));
    let depths = (0..parts as usize).map(|_| depth(rng)).collect();
    let phases = [0, 1].map(|_| between([0.0, turn], rng));
    let bow = between([0.0, MOST_BOW], rng);
    let tint = of.tint * between([0.45, 1.0], rng);
    let dots = if of.dots > 0 { whole([1, of.dots], rng) } else { 0.0 };
    let (first, side) = (between([0.0, 360.0], rng), mark.area.sqrt());
    let dot = |index: usize| {
        let (sin, cos) = sin_cos_degrees(first + 360.0 * index as f64 / dots);
        let [away, radius] = DOTS.map(|range| side * between(range, rng));
        ([away * cos, away * sin], radius)
    };
    let dots = (0..dots as usize).map(dot).collect();
    let radius = (mark.area / std::f64::consts::PI).sqrt();
    Rosette { parts, phases, bow, radius, depths, dots, tint }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Grid;

    /// Discs of radius 20 px, 64 px apart, on a tile of 256 × 256 px.
    fn discs() -> Field {
        let grid = Grid::unit([256, 256], Edges::Wrap);
        let value = |cell: usize| {
            let [x, y] = grid.center_px(cell).map(|at| at.rem_euclid(64.0) - 16.0);
            let [x, y] = [x, y].map(|along| if along > 32.0 { along - 64.0 } else { along });
            (0.5 + 0.25 * (20.0 - (x * x + y * y).sqrt())).clamp(0.0, 1.0) as f32
        };
        Field::new(&grid, (0..grid.cells()).map(value).collect())
    }

    fn share(field: &Field) -> f64 {
        field.values.iter().filter(|value| **value >= EDGE).count() as f64 / field.values.len() as f64
    }

    #[test]
    fn a_rosette_has_as_many_blotches_as_are_asked_for_around_a_tinted_centre() {
        let patches = discs();
        for parts in [3, 5] {
            let of = Rosettes { parts: [parts; 2], solid: 0.0, width: Some(9.0), dots: 0, tint: 0.3 };
            let grown = rosettes(&patches, &of, 7);
            let blotches = marks(&grown).1.len() as u32;
            assert!(blotches.abs_diff(16 * parts) <= 4, "{parts}: {blotches} blotches of 16 rosettes");
            let outside = patches
                .values
                .iter()
                .zip(&grown.values)
                .filter(|(patch, ink)| **patch < 0.4 && **ink >= EDGE);
            assert!(outside.count() * 200 < patches.values.len(), "ink beyond the outlines");
            let tints = patches
                .values
                .iter()
                .zip(&grown.values)
                .filter(|(patch, ink)| **patch >= 1.0 && (0.1..0.31).contains(*ink));
            assert!(tints.count() * 50 > patches.values.len(), "no tinted centres");
        }
    }

    #[test]
    fn solid_ones_stay_as_they_are_and_dots_add_ink() {
        let patches = discs();
        let all = Rosettes { solid: 1.0, ..Rosettes::default() };
        assert_eq!(rosettes(&patches, &all, 7).values, patches.values);
        let none = Rosettes { solid: 0.0, ..Rosettes::default() };
        let some = Rosettes { solid: 0.5, ..Rosettes::default() };
        let dotted = Rosettes { dots: 3, ..none };
        let [none, some, dotted] = [none, some, dotted].map(|of| share(&rosettes(&patches, &of, 7)));
        assert!(none < some && some < share(&patches) && dotted > 1.01 * none, "{none} {some} {dotted}");
    }

    #[test]
    fn rosettes_continue_over_the_border_of_a_tile() {
        // Moved by half of the canvas, the tile has its marks across the border.
        let patches = discs();
        let moved = |cell: usize| patches.values[(cell / 256 + 144) % 256 * 256 + (cell % 256 + 144) % 256];
        let moved = Field::new(&patches.grid(), (0..256 * 256).map(moved).collect());
        let of = Rosettes { solid: 0.0, ..Rosettes::default() };
        let grown = rosettes(&moved, &of, 7);
        let jump = |a: usize, b: usize| f64::from((grown.values[a] - grown.values[b]).abs());
        let seam = (0..256).map(|y| jump(y * 256, y * 256 + 255)).fold(0.0, f64::max);
        let inner = (0..256).map(|y| jump(y * 256 + 40, y * 256 + 41)).fold(0.0, f64::max);
        assert!(seam < 0.4 && inner < 0.4, "{seam} {inner}");
    }
}
