//! Random numbers and smooth noise that repeat with the canvas.
//!
//! Hash: C. Wellons, "Prospecting for hash functions" (2018), `lowbias32`. Noise: K. Perlin, "Improving noise", SIGGRAPH 2002, with
//! hashed unit gradients. Both use only whole numbers, additions and multiplications, so all machines give the same bits.

use crate::grid::sin_cos_degrees;

/// A well mixed number of 32 bits.
#[inline]
#[must_use]
pub fn mixed(mut bits: u32) -> u32 {
    bits ^= bits >> 16;
    bits = bits.wrapping_mul(0x7feb_352d);
    bits ^= bits >> 15;
    bits = bits.wrapping_mul(0x846c_a68b);
    bits ^ (bits >> 16)
}

/// Independent random numbers of the cell at [column, row] of a lattice.
#[derive(Clone, Copy, Debug)]
pub struct Random(u32);

impl Random {
    /// The numbers of a cell of the lattice with this seed.
    #[inline]
    #[must_use]
    pub fn of(seed: u32, [column, row]: [u32; 2]) -> Self {
        Self(mixed(seed ^ mixed(column.wrapping_mul(0x9e37_79b1) ^ mixed(row.wrapping_add(0x85eb_ca6b)))))
    }

    /// The numbers of a cell of a lattice in space.
    #[inline]
    #[must_use]
    pub fn in_space(seed: u32, [x, y, z]: [i32; 3]) -> Self {
        let deep = mixed((z as u32).wrapping_add(0x27d4_eb2f));
        Self(mixed(seed ^ mixed((x as u32).wrapping_mul(0x9e37_79b1) ^ mixed((y as u32).wrapping_add(deep)))))
    }

    /// Its present bits.
    #[inline]
    #[must_use]
    pub fn bits(self) -> u32 {
        self.0
    }

    /// The next number, 0 to below 1.
    #[inline]
    pub fn number(&mut self) -> f32 {
        self.0 = mixed(self.0.wrapping_add(0x9e37_79b9));
        // 24 bits are exact in single precision.
        (self.0 >> 8) as f32 * (1.0 / 16_777_216.0)
    }

    /// The next number, −1 to below 1.
    #[inline]
    pub fn signed(&mut self) -> f32 {
        2.0 * self.number() - 1.0
    }
}

/// The seed of part `index` of a finish.
#[must_use]
pub fn part_seed(seed: u64, index: u32) -> u32 {
    mixed(mixed(seed as u32) ^ mixed((seed >> 32) as u32).rotate_left(16) ^ index.wrapping_mul(0x27d4_eb2f))
}

/// The whole number of cells of about `cell` px along each side of a canvas, at least 1.
#[must_use]
pub fn whole_cells(canvas: [f32; 2], cell: f32) -> [usize; 2] {
    canvas.map(|side| ((side / cell).round() as usize).max(1))
}

/// The cell in 0..`cells` that stands for cell `index` of a lattice that repeats.
#[inline]
#[must_use]
pub fn wrapped(index: i32, cells: usize) -> usize {
    let cells = cells as i32;
    let index = match index {
        _ if (0..cells).contains(&index) => index,
        _ if (-cells..0).contains(&index) => index + cells,
        _ => index.rem_euclid(cells),
    };
    index as usize
}

/// The largest whole number that is not above `value`. Faster than the library's function on processors without an instruction for it.
#[inline]
#[must_use]
pub fn floor(value: f32) -> i32 {
    let towards_zero = value as i32;
    towards_zero - i32::from(value < towards_zero as f32)
}

/// Smooth noise over a canvas, which continues seamlessly at the other side. Its mean is 0, its standard deviation about ½.
#[derive(Clone, Debug)]
pub struct Noise {
    cells: [usize; 2],
    /// Cells a px.
    per_px: [f32; 2],
    gradients: Vec<[f32; 2]>,
}

impl Noise {
    /// Noise over a canvas of these px; from a light place to the next one are about two times `size` px.
    #[must_use]
    pub fn new(canvas: [f32; 2], size: f32, seed: u32) -> Self {
        let cells = whole_cells(canvas, size);
        let gradient = |index: usize| {
            let turn = Random::of(seed, [(index % cells[0]) as u32, (index / cells[0]) as u32]).number();
            let (sin, cos) = sin_cos_degrees(360.0 * f64::from(turn));
            [cos as f32, sin as f32]
        };
        Self {
            cells,
            per_px: [0, 1].map(|axis| cells[axis] as f32 / canvas[axis]),
            gradients: (0..cells[0] * cells[1]).map(gradient).collect(),
        }
    }

    /// The noise at a point, px of the canvas.
    #[inline]
    #[must_use]
    pub fn at(&self, point: [f32; 2]) -> f32 {
        let [x, y] = [point[0] * self.per_px[0], point[1] * self.per_px[1]];
        let (left, top) = (floor(x), floor(y));
        let (u, v) = (x - left as f32, y - top as f32);
        let columns = [wrapped(left, self.cells[0]), wrapped(left + 1, self.cells[0])];
        let rows = [wrapped(top, self.cells[1]), wrapped(top + 1, self.cells[1])];
        let corner = |i: usize, j: usize| {
            let gradient = self.gradients[rows[j] * self.cells[0] + columns[i]];
            gradient[0] * (u - i as f32) + gradient[1] * (v - j as f32)
        };
        let fade = |t: f32| t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
        let (across, down) = (fade(u), fade(v));
        let upper = corner(0, 0) + across * (corner(1, 0) - corner(0, 0));
        let lower = corner(0, 1) + across * (corner(1, 1) - corner(0, 1));
        2.0 * (upper + down * (lower - upper))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_continues_at_the_other_side_and_has_a_mean_of_0_and_a_deviation_of_a_half() {
        let noise = Noise::new([120.0, 90.0], 7.0, 3);
        let (mut sum, mut squares, mut count) = (0.0, 0.0, 0.0);
        for y in 0..90 {
            for x in 0..120 {
                let point = [x as f32 + 0.3, y as f32 + 0.6];
                let value = noise.at(point);
                let moved = noise.at([point[0] - 120.0, point[1] + 90.0]);
                assert!((value - moved).abs() < 1e-3, "{point:?}: {value} {moved}");
                (sum, squares, count) = (sum + value, squares + value * value, count + 1.0);
            }
        }
        let deviation = (squares / count).sqrt();
        assert!(
            (sum / count).abs() < 0.05 && (0.35..0.65).contains(&deviation),
            "{} {deviation}",
            sum / count
        );
    }

    #[test]
    fn random_numbers_of_neighbouring_cells_are_independent() {
        let rows = 400;
        let numbers: Vec<f32> =
            (0..rows * rows).map(|i| Random::of(9, [i % rows, i / rows]).signed()).collect();
        let mean = |by: usize| {
            let pairs = numbers.iter().zip(&numbers[by..]);
            pairs.map(|(a, b)| a * b).sum::<f32>() / (numbers.len() - by) as f32
        };
        assert!((mean(0) - 1.0 / 3.0).abs() < 0.01);
        assert!(mean(1).abs() < 0.01 && mean(rows as usize).abs() < 0.01);
    }
}
