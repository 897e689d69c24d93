//! Ragged edges on any pattern: noise at the scale of the marks, added where the pattern has its edges.
//!
//! ```text
//! p′ = p + amp·n·4·p·(1 − p),  n = 2·T − 1
//! ```
//! T is noise of two octaves, of wavelength .7·radius·2 and half of it, where radius is that of the marks; n is brought to unit
//! deviation. The level that is to be the edge is then found anew, so that the area stays. Round spots of 28 px whose pattern
//! rises by .03 a px had, with amp 0 / .08 / .16 / .25, raggedness 1.00 / 1.05 / 1.18 / 1.31, aspect 1 / .90 / .83 / .79 and area
//! +0 / −.0 / −.1 / −.7 %; flatter patterns get more ragged. Noise that moves the places instead loses area.

use super::noise::Noise;
use crate::grid::Field;

/// The highest amplitude: beyond it marks fall to pieces.
pub const MOST: f32 = 0.25;
/// Radius of the discs of the noise, radii of the marks: half of the wavelength.
const SCALE: f64 = 0.7;
/// One octave makes lobes, a third one shows no more.
const OCTAVES: u32 = 2;

/// `pattern`, 0..1 with its edges at ½, with edges roughened by `amount`, 0–[`MOST`], for marks of `radius` px.
#[must_use]
pub fn roughened(pattern: &Field, amount: f32, radius: f64, seed: u64) -> Field {
    let noise = Noise { radius: SCALE * radius, octaves: OCTAVES, fold: false, seed }.field(&pattern.grid());
    let amount = amount.clamp(0.0, MOST);
    let mut out = pattern.clone();
    for (value, noise) in out.values.iter_mut().zip(&noise.values) {
        let p = value.clamp(0.0, 1.0);
        *value += amount * NORMALISED * (2.0 * noise - 1.0) * 4.0 * p * (1.0 - p);
    }
    super::level::relevel(&mut out, super::level::share_above(pattern, 0.5));
    out
}

/// 2·T − 1 has a standard deviation of .33, in noise of one octave .45.
const NORMALISED: f32 = 3.0;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;
    use crate::points::level::share_above;

    /// 36 round spots of 20 px, 70 px apart.
    fn spots() -> Field {
        Field::from_fn([420, 420], [1.0, 1.0], Edges::Wrap, |at| {
            let [x, y] = at.map(|at| at.rem_euclid(70.0) - 35.0);
            (0.5 + (20.0 - libm::hypot(x, y)) / 24.0).clamp(0.0, 1.0) as f32
        })
    }

    /// Length of the level line ½, in steps between cells.
    fn contour(field: &Field) -> usize {
        let above = |x: usize, y: usize| field.get(x as isize, y as isize) > 0.5;
        let cells = (0..field.height).flat_map(|y| (0..field.width).map(move |x| (x, y)));
        cells
            .map(|(x, y)| {
                usize::from(above(x, y) != above(x + 1, y)) + usize::from(above(x, y) != above(x, y + 1))
            })
            .sum()
    }

    #[test]
    fn edges_get_longer_with_the_amount_while_the_area_stays() {
        let plain = spots();
        let lengths = [0.0, 0.08, 0.16].map(|amount| {
            let rough = roughened(&plain, amount, 20.0, 3);
            assert!((share_above(&rough, 0.5) / share_above(&plain, 0.5) - 1.0).abs() < 5e-3);
            contour(&rough)
        });
        assert!(lengths[1] * 100 > lengths[0] * 101 && lengths[2] * 100 > lengths[0] * 106, "{lengths:?}");
    }

    #[test]
    fn places_far_from_edges_stay() {
        let plain = spots();
        let rough = roughened(&plain, 0.0, 20.0, 3);
        let apart = plain.values.iter().zip(&rough.values).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
        assert!(apart < 2e-3, "{apart}");
        let rough = roughened(&plain, 0.16, 20.0, 3);
        assert_eq!(rough.values[0], 0.0);
    }
}
