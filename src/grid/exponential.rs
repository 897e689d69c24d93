//! eˣ for values of cells: inlined and vectorised, where the library's function is a call a cell.
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
/// Added to a number below 2⁵¹ and taken away again, it leaves the nearest whole number.
const ROUND: f64 = 6_755_399_441_055_744.0;
/// ln 2 in two parts: the first times a whole number below 2¹¹ is exact.
const LN_2: [f64; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];

/// eˣ to a relative 10⁻¹¹, for x from −700 to 700; beyond that the value at the end of the range.
#[inline]
#[must_use]
pub fn exp(x: f64) -> f64 {
    let x = x.clamp(-700.0, 700.0);
    let n = (x * std::f64::consts::LOG2_E + ROUND) - ROUND;
    let r = (x - n * LN_2[0]) - n * LN_2[1];
    let high = TAYLOR.iter().rev().fold(0.0, |sum, term| sum * r + term);
    let root = 1.0 + r + r * r * high;
    // The exponent of a double begins at bit 52.
    root * f64::from_bits(((n as i64 + 1_023) as u64) << 52)
}

#[cfg(test)]
mod tests {
    use super::*;

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
