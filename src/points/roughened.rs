//! Ragged edges on any pattern: noise at the scale of the marks, added where the pattern has its edges.
//!
//! ```text
//! p′ = p + amp·n·4·p·(1 − p),  n = 2·T − 1
//! ```
//! T is noise of two octaves, of wavelength .7·radius·2 and half of it, where radius is that of the marks. The level that is
//! to be the edge is then found anew, so that the area stays. Measured on round spots: amp .08 → contour² ÷ 4πA 1.36, .16 →
//! 1.77 (aspect .88 → .75), .30 tears them. Noise that moves the places instead loses area.

use super::noise::Noise;
use crate::grid::Field;

/// The highest amplitude: from .30 on marks fall to pieces.
pub const MOST: f32 = 0.25;
/// Radius of the discs of the noise, radii of the marks: half of the wavelength.
const SCALE: f64 = 0.7;
/// The standard deviation of the first octave is a fifth of its range; noise of unit deviation would be 2.5 times this.
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

/// Brings noise of two octaves about to unit deviation.
const NORMALISED: f32 = 2.4;
