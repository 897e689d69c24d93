//! Angles of vectors and vectors of angles, for values of cells: inlined and without branches, where the library's functions are
//! a call a cell. Only additions, multiplications and divisions, so that all machines give the same bits.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use super::exponential::ROUND;

/// tan(π ÷ 8): slopes beyond this are counted from the diagonal.
const STEEP: f64 = 0.414_213_562_373_095_03;
/// (−1)ᵏ ÷ (2k + 1) from k = 1 on.
const ARCTAN: [f64; 13] = [
    -1.0 / 3.0,
    1.0 / 5.0,
    -1.0 / 7.0,
    1.0 / 9.0,
    -1.0 / 11.0,
    1.0 / 13.0,
    -1.0 / 15.0,
    1.0 / 17.0,
    -1.0 / 19.0,
    1.0 / 21.0,
    -1.0 / 23.0,
    1.0 / 25.0,
    -1.0 / 27.0,
];

/// The angle of the vector (x, y) from +x towards +y, −π..π, to 10⁻¹²; 0 of no vector.
#[inline]
#[must_use]
pub fn atan2(y: f64, x: f64) -> f64 {
    let (short, long) = (x.abs().min(y.abs()), x.abs().max(y.abs()));
    let steep = short > STEEP * long;
    let (rise, run) = if steep { (short - long, short + long) } else { (short, long.max(f64::MIN_POSITIVE)) };
    let slope = rise / run;
    let square = slope * slope;
    let high = ARCTAN.iter().rev().fold(0.0, |sum, term| sum * square + term);
    let of_slope = slope + slope * square * high;
    let from_axis = if steep { FRAC_PI_4 + of_slope } else { of_slope };
    let from_x = if y.abs() > x.abs() { FRAC_PI_2 - from_axis } else { from_axis };
    let upper = if x < 0.0 { PI - from_x } else { from_x };
    upper.copysign(y)
}

/// (−1)ᵏ ÷ (2k + 1)! from k = 1 on.
const SINE: [f64; 7] = [
    -1.0 / 6.0,
    1.0 / 120.0,
    -1.0 / 5_040.0,
    1.0 / 362_880.0,
    -1.0 / 39_916_800.0,
    1.0 / 6_227_020_800.0,
    -1.0 / 1_307_674_368_000.0,
];
/// (−1)ᵏ ÷ (2k)! from k = 1 on.
const COSINE: [f64; 8] = [
    -1.0 / 2.0,
    1.0 / 24.0,
    -1.0 / 720.0,
    1.0 / 40_320.0,
    -1.0 / 3_628_800.0,
    1.0 / 479_001_600.0,
    -1.0 / 87_178_291_200.0,
    1.0 / 20_922_789_888_000.0,
];
/// (sin, cos) of an angle in degrees, to 10⁻¹⁵, exact at whole quarter turns; below 2⁵⁰ degrees.
#[inline]
#[must_use]
pub fn sin_cos_degrees(degrees: f64) -> (f64, f64) {
    let rounded = degrees * (1.0 / 90.0) + ROUND;
    let quarters = rounded.to_bits();
    let r = (degrees - 90.0 * (rounded - ROUND)).to_radians();
    let square = r * r;
    let sine = r + r * square * SINE.iter().rev().fold(0.0, |sum, term| sum * square + term);
    let cosine = 1.0 + square * COSINE.iter().rev().fold(0.0, |sum, term| sum * square + term);
    let (sine, cosine) = if quarters & 1 == 0 { (sine, cosine) } else { (cosine, -sine) };
    if quarters & 2 == 0 { (sine, cosine) } else { (-sine, -cosine) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_are_exact_to_twelve_digits() {
        for k in -7_200..=7_200 {
            let angle = (f64::from(k) * 0.025).to_radians();
            let (sin, cos) = libm::sincos(angle);
            for length in [1e-6, 1.0, 37.5] {
                let (y, x) = (length * sin, length * cos);
                let (found, exact) = (atan2(y, x), libm::atan2(y, x));
                assert!((found - exact).abs() < 1e-12, "{y} {x}: {found} {exact}");
            }
        }
        assert_eq!([atan2(0.0, 0.0), atan2(0.0, 2.0), atan2(3.0, 0.0)], [0.0, 0.0, FRAC_PI_2]);
        assert_eq!([atan2(0.0, -2.0), atan2(-3.0, 0.0)], [PI, -FRAC_PI_2]);
    }

    #[test]
    fn sines_and_cosines_are_exact_to_fifteen_digits_and_at_quarter_turns() {
        for k in -40_000..=40_000 {
            let degrees = f64::from(k) * 0.025;
            let ((sin, cos), exact) = (sin_cos_degrees(degrees), libm::sincos(degrees.to_radians()));
            assert!((sin - exact.0).abs() < 4e-15 && (cos - exact.1).abs() < 4e-15, "{degrees}: {sin} {cos}");
        }
        let quarters = [-90.0, 0.0, 90.0, 180.0, 270.0, 360.0].map(sin_cos_degrees);
        assert_eq!(quarters, [(-1.0, 0.0), (0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0), (0.0, 1.0)]);
    }
}
