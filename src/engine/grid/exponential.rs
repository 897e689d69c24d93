//! eˣ and ln x for values of cells: inlined and vectorised, where the library's functions are a call a cell.
//!
//! eˣ = 2ⁿ·eʳ with n the whole number nearest to x ÷ ln 2, |r| ≤ ½ ln 2, and eʳ by its Taylor polynomial of degree 9, whose
//! remainder is below 3·10⁻¹². Only additions and multiplications, so that all machines give the same bits.

/// 1 ÷ k! from k = 2 on.
const TAYLOR: [f64; 8] = [
    1.0 / 2.0,
    1.0 / 6.0,
    1.0 / 24.0,
    1.0 / 120.0,
    1.0 / 720.0,
    1.0 / 5_040.0,
    1.0 / 40_320.0,
    1.0 / 362_880.0,
];
/// Added to a number below 2⁵¹ and taken away again, it leaves the nearest whole number, which the lowest bits of the
/// sum show.
pub(super) const ROUND: f64 = 6_755_399_441_055_744.0;
/// ln 2 in two parts: the first times a whole number below 2¹¹ is exact.
const LN_2: [f64; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];

/// eˣ to a relative 10⁻¹¹, for x from −700 to 700; beyond that the value at the end of the range.
#[inline]
#[must_use]
pub fn exp(x: f64) -> f64 {
    let x = x.clamp(-700.0, 700.0);
    let rounded = x * std::f64::consts::LOG2_E + ROUND;
    let n = rounded - ROUND;
    let r = (x - n * LN_2[0]) - n * LN_2[1];
    let high = TAYLOR.iter().rev().fold(0.0, |sum, term| sum * r + term);
    let root = 1.0 + r + r * r * high;
    // The lowest bits of the sum are those of n; the exponent of a double begins at bit 52.
    root * f64::from_bits(rounded.to_bits().wrapping_add(1_023) << 52)
}

/// 1 ÷ (2k + 1) from k = 1 on.
const ARTANH: [f64; 8] =
    [1.0 / 3.0, 1.0 / 5.0, 1.0 / 7.0, 1.0 / 9.0, 1.0 / 11.0, 1.0 / 13.0, 1.0 / 15.0, 1.0 / 17.0];
/// Bits of √½.
const ROOT_HALF: u64 = 0x3FE6_A09E_667F_3BCD;

/// ln x to 10⁻¹², for positive normal x.
///
/// ln x = n ln 2 + 2 artanh s, s = (m − 1) ÷ (m + 1), with x = 2ⁿ·m, √½ ≤ m < √2; |s| ≤ 0.1716.
#[inline]
#[must_use]
pub fn ln(x: f64) -> f64 {
    let above = x.to_bits().wrapping_sub(ROOT_HALF) as i64;
    let n = above >> 52;
    let m = f64::from_bits(x.to_bits().wrapping_sub((n << 52) as u64));
    let s = (m - 1.0) / (m + 1.0);
    let square = s * s;
    let high = ARTANH.iter().rev().fold(0.0, |sum, term| sum * square + term);
    let n = n as f64;
    2.0 * (s + s * square * high) + n * LN_2[1] + n * LN_2[0]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_logarithm_is_exact_to_twelve_digits() {
        for k in -70_000..=70_000 {
            let x = libm::exp(f64::from(k) * 0.009_98);
            let (found, exact) = (ln(x), libm::log(x));
            assert!((found - exact).abs() < 1e-12 * exact.abs().max(1.0), "{x}: {found} {exact}");
        }
        assert_eq!(ln(1.0), 0.0);
    }

    #[test]
    fn it_is_the_exponential_function_to_eleven_digits() {
        for k in -70_000..=70_000 {
            let x = f64::from(k) * 0.009_98;
            let (found, exact) = (exp(x), libm::exp(x));
            assert!((found / exact - 1.0).abs() < 1e-11, "{x}: {found} {exact}");
        }
    }

    #[test]
    fn it_is_exact_at_0_and_bounded_far_away() {
        assert_eq!(exp(0.0), 1.0);
        assert!(exp(-1e9) < 1e-300 && exp(1e9).is_finite());
    }
}
