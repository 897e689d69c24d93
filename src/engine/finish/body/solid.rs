//! Smooth noise in space.
//!
//! K. Perlin, "Improving noise", SIGGRAPH 2002, with a hash instead of a table: it does not repeat.

use crate::finish::noise::{Random, floor};

/// Makes the standard deviation about ½, as that of noise on a canvas.
const AMPLITUDE: f32 = 1.8;

/// Smooth noise in space. Its mean is 0, its standard deviation about ½.
#[derive(Clone, Copy, Debug)]
pub(super) struct SolidNoise {
    per_px: f32,
    seed: u32,
}

impl SolidNoise {
    /// From a light place to the next one are about two times `size` px.
    pub fn new(size: f32, seed: u32) -> Self {
        Self { per_px: 1.0 / size, seed }
    }

    /// The noise at a place, px.
    pub fn at(&self, place: [f32; 3]) -> f32 {
        let place = place.map(|part| part * self.per_px);
        let base = place.map(floor);
        let within = [0, 1, 2].map(|axis| place[axis] - base[axis] as f32);
        let corner = |i: i32, j: i32, k: i32| {
            let hash = Random::in_space(self.seed, [base[0] + i, base[1] + j, base[2] + k]).bits();
            let [x, y, z] = [within[0] - i as f32, within[1] - j as f32, within[2] - k as f32];
            sloped(hash, [x, y, z])
        };
        let [u, v, w] = within.map(|t| t * t * t * (t * (t * 6.0 - 15.0) + 10.0));
        let mix = |a: f32, b: f32, share: f32| a + share * (b - a);
        let along = |j: i32, k: i32| mix(corner(0, j, k), corner(1, j, k), u);
        let plane = |k: i32| mix(along(0, k), along(1, k), v);
        AMPLITUDE * mix(plane(0), plane(1), w)
    }
}

/// The height of a plane whose slope is one of the twelve directions to the edges of a cube.
fn sloped(hash: u32, [x, y, z]: [f32; 3]) -> f32 {
    let case = hash & 15;
    let first = if case < 8 { x } else { y };
    let second = match case {
        0..4 => y,
        12 | 14 => x,
        _ => z,
    };
    let signed = |value: f32, bit: u32| if hash & bit == 0 { value } else { -value };
    signed(first, 1) + signed(second, 2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_in_space_has_a_mean_of_0_and_a_deviation_of_a_half_and_no_steps() {
        let noise = SolidNoise::new(5.0, 7);
        let (mut sum, mut squares, mut step) = (0.0, 0.0, 0.0_f32);
        let side = 40;
        for at in 0..side * side * side {
            let place = [at % side, at / side % side, at / side / side].map(|part| part as f32 - 17.3);
            let value = noise.at(place);
            (sum, squares) = (sum + value, squares + value * value);
            step = step.max((noise.at([place[0] + 0.01, place[1], place[2]]) - value).abs());
        }
        let count = (side * side * side) as f32;
        let deviation = (squares / count).sqrt();
        assert!((sum / count).abs() < 0.05 && (0.4..0.6).contains(&deviation), "{} {deviation}", sum / count);
        assert!(step < 0.02, "{step}");
    }
}
