//! One wave of the noise of stripes: (1 − r²)² cos(2π (x − xᵢ)·nᵢ/λᵢ + φᵢ), r² = (along/A)² + (across/B)².

use std::f64::consts::TAU;
use std::ops::Range;

use multiversion::multiversion;

use super::parameter_field::Parameters;
use crate::grid::{Edges, Grid, sin_cos_degrees};

/// The unit vector across the stripes that have these parameters.
pub(super) fn across(p: &Parameters) -> [f64; 2] {
    let (sin, cos) = sin_cos_degrees(f64::from(p.direction) + 90.0);
    [cos, sin]
}

/// One wave under its window.
pub(super) struct Wave {
    at: [f64; 2],
    /// Unit vector across.
    pub(super) n: [f64; 2],
    /// a, b, c of the window 1 − (a·dx² + 2b·dx·dy + c·dy²).
    window: [f64; 3],
    /// Increase of its phase per cell along x and y, radians.
    turns: [f64; 2],
    /// Cosines and sines of the increase of its phase along x within a block.
    turned: [[f32; BLOCK]; 2],
    /// Cosine and sine of the increase of its phase along a whole block.
    leap: [f64; 2],
    /// The phase at its middle, radians.
    phase: f64,
}

impl Wave {
    /// A wave of these parameters, `length` cells long, that reaches `far` cells along its crests and `near` across. The `phase` is
    /// a share of a period. The wave is stored in cells that are `scale` times as long along x and y.
    pub(super) fn new(
        at: [f64; 2],
        p: &Parameters,
        [far, near]: [f64; 2],
        length: f64,
        phase: f64,
        scale: [f64; 2],
    ) -> Self {
        let n = across(p);
        let window = [
            scale[0] * scale[0] * (n[1] * n[1] / (far * far) + n[0] * n[0] / (near * near)),
            scale[0] * scale[1] * n[0] * n[1] * (1.0 / (near * near) - 1.0 / (far * far)),
            scale[1] * scale[1] * (n[0] * n[0] / (far * far) + n[1] * n[1] / (near * near)),
        ];
        let at = [0, 1].map(|axis| at[axis] / scale[axis]);
        let turns = [0, 1].map(|axis| TAU / length * n[axis] * scale[axis]);
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

    /// The cells within reach in the rows from `y` on, which may lie beyond the border of the canvas.
    #[inline(always)]
    fn chords(&self, y: isize, grid: &Grid) -> Chords {
        let ([a, b, c], [kx, ky]) = (self.window, self.turns);
        let last = match grid.edges {
            Edges::Closed => [0.0, grid.size[0] as f64 - 1.0],
            Edges::Wrap => [f64::NEG_INFINITY, f64::INFINITY],
        };
        let mut chords = Chords { dy: [0.0; ABREAST], ends: [[0.0; ABREAST]; 2], turn: [[0.0; ABREAST]; 2] };
        let ([left, right], [cos, sin]) = (&mut chords.ends, &mut chords.turn);
        for k in 0..ABREAST {
            let dy = (y + k as isize) as f64 + 0.5 - self.at[1];
            let midpoint = -b * dy / a;
            let half = (midpoint * midpoint - (c * dy * dy - 1.0) / a).max(0.0).sqrt();
            left[k] = (self.at[0] - 0.5 + midpoint - half).ceil().max(last[0]);
            right[k] = (self.at[0] - 0.5 + midpoint + half).floor().min(last[1]);
            let dx = left[k] + 0.5 - self.at[0];
            (sin[k], cos[k]) = sin_cos_degrees((self.phase + dx * kx + dy * ky).to_degrees());
            chords.dy[k] = dy;
        }
        chords
    }
}

/// Rows of a wave whose ends and phases are computed side by side. Not tuned.
const ABREAST: usize = 8;

/// The cells of rows that a wave reaches.
struct Chords {
    /// Offset of each row from the middle of the wave, cells.
    dy: [f64; ABREAST],
    /// The first and the last column in each row.
    ends: [[f64; ABREAST]; 2],
    /// Cosine and sine of the phase at the first column.
    turn: [[f64; ABREAST]; 2],
}

impl Chords {
    fn chord(&self, k: usize) -> Chord {
        let [first, last] = self.ends.map(|ends| ends[k] as isize);
        Chord { dy: self.dy[k], columns: first..last + 1, turn: self.turn.map(|turn| turn[k]) }
    }
}

/// Cells of a row that are computed side by side. Not tuned.
const BLOCK: usize = 16;

/// Calls `sum` with runs of the cells that `wave` reaches in the rows `rows` (counted from the first of them): its values under the
/// window, and those of the wave a quarter of a period behind.
#[multiversion(targets("x86_64+avx2"))]
pub(super) fn add(
    wave: &Wave,
    rows: Range<isize>,
    grid: &Grid,
    mut sum: impl FnMut(Range<usize>, &[f32], &[f32]),
) {
    let [a, b, c] = wave.window;
    let tall = (a / (a * c - b * b)).sqrt();
    let [first, last] =
        [(wave.at[1] - 0.5 - tall).ceil() as isize, (wave.at[1] - 0.5 + tall).floor() as isize];
    let [nx, ny] = grid.size.map(|side| side as isize);
    // On a tile a row also stands for the rows that lie a whole number of tiles above and below.
    let tiles = match grid.edges {
        Edges::Closed => 0..=0,
        Edges::Wrap => first.div_euclid(ny)..=last.div_euclid(ny),
    };
    for tile in tiles {
        let shift = tile * ny;
        let reached = rows.start.max(first - shift)..rows.end.min(last + 1 - shift);
        for start in reached.clone().step_by(ABREAST) {
            let chords = wave.chords(start + shift, grid);
            for (k, row) in (start..reached.end).take(ABREAST).enumerate() {
                add_chord(wave, &chords.chord(k), ((row - rows.start) * nx) as usize, grid, &mut sum);
            }
        }
    }
}

/// Calls `sum` for the run of cells of one row that `wave` reaches; the row begins at cell `first` of those that are summed.
#[inline(always)]
fn add_chord(
    wave: &Wave,
    chord: &Chord,
    first: usize,
    grid: &Grid,
    sum: &mut impl FnMut(Range<usize>, &[f32], &[f32]),
) {
    let nx = grid.size[0];
    let Chord { dy, columns, turn: [mut cos, mut sin] } = chord.clone();
    // The window along the row is 1 − (a·dx² + linear·dx + constant).
    let [a, b, c] = wave.window;
    let [a, linear, constant] = [a, 2.0 * b * dy, c * dy * dy].map(|part| part as f32);
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
        // On a tile, cells beyond a border are cells at the opposite border.
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
#[derive(Clone)]
struct Chord {
    /// Offset of the row from the middle of the wave, cells.
    dy: f64,
    columns: Range<isize>,
    /// Cosine and sine of the phase at the first of them.
    turn: [f64; 2],
}
