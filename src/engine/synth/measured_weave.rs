//! Measures the threads of a weave in its picture.
//!
//! The picture is used as the reaction R of a system of pairs, one for each direction. The differences at equilibrium each show the
//! threads of one direction. The thresholds of their edges follow from the law of threads, whose widths and periods are measured at
//! these thresholds: a few rounds converge.

use rayon::prelude::*;

use crate::grid::resample::Spline;
use crate::grid::{Field, Grid};
use crate::measure::{edge_directions, stripes};
use crate::rd::pairs::{
    Blurs, Combination, Course, MOST_PAIRS, PairField, PairGrowth, PairModel, PairParameterField, PairStart,
    Threads,
};

/// The threads of one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WovenThreads {
    /// Their direction, degrees in [0, 180).
    pub angle: f64,
    /// Mean width, px.
    pub width: f64,
    /// Distance from one thread to the next, px.
    pub period: f64,
}

/// The pair that shows the threads of one direction.
const MODEL: PairModel = PairModel {
    combination: Combination::Maximum,
    ratio: 1.5,
    threshold: Course::Constant(0.0),
    softness: 1.0,
    weights: [1.0; MOST_PAIRS],
    gain: Course::Constant(1.0),
};
/// Length ÷ width of its blurs: they are long, so that they average over the threads that they cross.
const BLURS: Blurs = Blurs::Along(6.0);
/// Period ÷ wavelength of a pair: with smaller pairs the widths of thin threads are less accurate.
const APART: f64 = 0.92;
/// Cells per size of a pair: with fewer, the grid becomes visible.
const CELLS: f64 = 2.5;
/// Most rounds in which sizes follow the measured periods: the first begins with an estimate.
const SIZE_ROUNDS: usize = 4;
/// A change of the period by less than this share needs no further round.
const SAME_PERIOD: f64 = 0.1;
/// Rounds in which thresholds follow the widths.
const LEVEL_ROUNDS: usize = 8;

/// The threads of the weave in `pattern`, which is above ½ on the threads. `None` if there are fewer than two directions, or more
/// than five, or a direction without threads.
#[must_use]
pub fn measure_weave(pattern: &Field) -> Option<Vec<WovenThreads>> {
    let mut angles = edge_directions(pattern);
    angles.sort_by(f64::total_cmp);
    if !(2..=MOST_PAIRS).contains(&angles.len()) {
        return None;
    }
    let rough = stripes(pattern, 0.5)?;
    // Initial threads that cover a third each.
    let mut threads = vec![Threads { width: rough.width, period: 3.0 * rough.width }; angles.len()];
    let mut found = Vec::new();
    for _ in 0..SIZE_ROUNDS {
        found = separated(pattern, 1.0 - rough.share, &angles, &threads)?;
        let mut moved: f64 = 0.0;
        for (threads, found) in threads.iter_mut().zip(&found) {
            moved = moved.max((found.period / threads.period - 1.0).abs());
            *threads = Threads { width: found.width, period: found.period };
        }
        if moved < SAME_PERIOD {
            break;
        }
    }
    Some(found)
}

/// Measures the threads of each direction with pairs of the sizes that suit `threads`; `free` is the share that no thread covers.
fn separated(pattern: &Field, free: f64, angles: &[f64], threads: &[Threads]) -> Option<Vec<WovenThreads>> {
    let size = |threads: &Threads| threads.period / (APART * MODEL.wavelength());
    let shown = angles.iter().zip(threads).map(|(angle, threads)| difference(pattern, *angle, size(threads)));
    let differences = shown.collect::<Option<Vec<Field>>>()?;
    let woven = |(angle, threads): (&f64, &Threads)| WovenThreads {
        angle: *angle,
        width: threads.width,
        period: threads.period,
    };
    let mut found: Vec<WovenThreads> = angles.iter().zip(threads).map(woven).collect();
    for _ in 0..LEVEL_ROUNDS {
        let before: Vec<Threads> =
            found.iter().map(|woven| Threads { width: woven.width, period: woven.period }).collect();
        for (index, difference) in differences.iter().enumerate() {
            // The share that is free of all directions together is known exactly.
            let uncovered = (free / (1.0 - before[index].duty().min(0.9))).min(1.0);
            let level = before[index].difference_at_edge(&MODEL, size(&threads[index]), uncovered);
            let measured = stripes(difference, level as f32)?;
            found[index] =
                WovenThreads { angle: measured.angle, width: measured.width, period: measured.wavelength };
        }
    }
    Some(found)
}

/// The difference of a pair of this size (px) and direction, at rest, with the pattern as its reaction.
fn difference(pattern: &Field, angle: f64, size: f64) -> Option<Field> {
    let extent = pattern.extent();
    let cells = extent.map(|side| (CELLS * side / size).round().max(16.0) as usize);
    let grid = Grid {
        cell: [0, 1].map(|axis| extent[axis] / cells[axis] as f64),
        ..Grid::unit(cells, pattern.edges)
    };
    let in_cells = size / (grid.cell[0] * grid.cell[1]).sqrt();
    let pair = PairField::uniform(cells[0] * cells[1], angle as f32, in_cells as f32, BLURS);
    let maps = PairParameterField { grid, pairs: vec![pair], obstacles: Vec::new(), raised: Vec::new() };
    let start = PairStart::Drawn(covered(pattern, cells));
    PairGrowth::new(&maps, &MODEL, &start)?.differences().pop()
}

/// Values farther than this from ½ are not interpolated between px. Next to its edges the ground of a pattern is cut off at 0, its
/// threads are not: a surface through all values makes threads of 3 px 2 % too narrow, one through these 0.3 %.
const NEAR_EDGE: f32 = 0.2;

/// The share of each of this number of cells that lies above ½.
fn covered(pattern: &Field, [nx, ny]: [usize; 2]) -> Vec<f32> {
    // Samples along each side of a cell: no farther apart than the px of the pattern.
    let samples = pattern.width.div_ceil(nx).max(pattern.height.div_ceil(ny));
    let [wide, high] = [samples * nx, samples * ny];
    let near = pattern.values.iter().map(|value| value.clamp(0.5 - NEAR_EDGE, 0.5 + NEAR_EDGE)).collect();
    let values = Spline::new(&Field { values: near, ..pattern.clone() }).rows(0..high, wide, high);
    let at = |x: isize, y: isize| values[pattern.edges.index(y, high) * wide + pattern.edges.index(x, wide)];
    let sample = |x: usize, y: usize| {
        let (x, y) = (x as isize, y as isize);
        let [gx, gy] = [0.5 * (at(x + 1, y) - at(x - 1, y)), 0.5 * (at(x, y + 1) - at(x, y - 1))];
        let slope = (gx * gx + gy * gy).sqrt().max(1e-6);
        (0.5 + (at(x, y) - 0.5) / slope).clamp(0.0, 1.0)
    };
    let cell = |index: usize| {
        let [x, y] = [samples * (index % nx), samples * (index / nx)];
        let of_row = |dy: usize| (0..samples).map(move |dx| (x + dx, y + dy));
        let sum: f32 = (0..samples).flat_map(of_row).map(|(x, y)| sample(x, y)).sum();
        sum / (samples * samples) as f32
    };
    (0..nx * ny).into_par_iter().map(cell).collect()
}
