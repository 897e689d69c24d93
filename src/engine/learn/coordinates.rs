//! Attributes and parameters ↔ the coordinates in which the map between them is almost linear.
//!
//! The laws of scale are factored out (rate·A and A/L² hardly vary), so that the quantities to learn vary little, even beyond the
//! range of the rows.

use super::Parameters;
use crate::attributes::{Spots, Stripes};
use crate::learn::small_vector::SmallVector;
use crate::marks::axial;

/// −ln(minor/major) along the double angle: an axis as a vector that vanishes for a circle.
pub(super) fn elongation(aspect: f64, angle: f64) -> [f64; 2] {
    let length = -libm::log(aspect);
    let [c, s] = harmonic(angle, 2.0);
    [length * c, length * s]
}

/// (cos nθ, sin nθ) of an angle in degrees.
pub(super) fn harmonic(angle: f64, n: f64) -> [f64; 2] {
    let angle = (n * axial(angle)).to_radians();
    [libm::cos(angle), libm::sin(angle)]
}

/// Half the direction of a double-angle vector, degrees in [0, 180).
pub(super) fn axis([x, y]: [f64; 2]) -> f64 {
    axial(0.5 * libm::atan2(y, x).to_degrees())
}

/// |v|.
pub(super) fn length([x, y]: [f64; 2]) -> f64 {
    (x * x + y * y).sqrt()
}

/// ln(A/L²).
pub(super) fn log_density(area: f64, spacing: f64) -> f64 {
    libm::log(area) - 2.0 * libm::log(spacing)
}

/// The features of a question about spots: (ln A, ln(A/L²) where `density`, v).
pub(super) fn spot_question(log_area: f64, density: Option<f64>, v: [f64; 2]) -> SmallVector {
    SmallVector::new(std::iter::once(log_area).chain(density).chain(v))
}

/// The outputs of an answer about spots: (ln(rate·A), ln ratio, level, w).
pub(super) fn spot_answer(spots: &Spots, p: &Parameters) -> SmallVector {
    let [x, y] = elongation(p.stretch, p.direction);
    let ratio = libm::log(p.ratio.unwrap_or(1.0));
    SmallVector::new([libm::log(p.rate) + libm::log(spots.area), ratio, p.level.unwrap_or(0.5), x, y])
}

/// The parameters in the outputs `answered` for spots of area e^`log_area`.
pub(super) fn spot_parameters(log_area: f64, answered: &[f64]) -> Parameters {
    let w = [answered[3], answered[4]];
    Parameters {
        rate: libm::exp(answered[0] - log_area),
        ratio: Some(libm::exp(answered[1])),
        stretch: libm::exp(-length(w)),
        direction: axis(w),
        level: Some(answered[2]),
    }
}

/// The features of parameters of spots: (ln rate, ln ratio, level, w), without those that do not vary in the set.
pub(super) fn spot_features(p: &Parameters, ratio: bool, level: bool) -> SmallVector {
    let mut features = SmallVector::new([libm::log(p.rate)]);
    features.extend(ratio.then(|| libm::log(p.ratio.unwrap_or(1.0))));
    features.extend(level.then(|| p.level.unwrap_or(0.5)));
    features.extend(elongation(p.stretch, p.direction));
    features
}

/// The features of parameters of spots for outputs that a mirror image does not change: (ln rate, ln ratio, level, |w|, |w| cos
/// 4φ).
///
/// As a function of w such an output has a kink at 0 (aspect ≈ e^−|w|), which a local line would smooth; as a function of
/// |w| it has none. cos 4φ is the influence of the grid's axes. Where w = 0, v has a random direction, so the mean of v is
/// no estimate of the aspect: isotropic Turing spots measure 0.88 and not 1.
pub(super) fn spot_features_even(p: &Parameters, ratio: bool, level: bool) -> SmallVector {
    let mut features = spot_features(p, ratio, level);
    let w = -libm::log(p.stretch);
    let n = features.len();
    features[n - 2] = w;
    features[n - 1] = w * harmonic(p.direction, 4.0)[0];
    features
}

/// The corresponding outputs that a mirror image does not change: (ln(rate·A), ln(rate·L²), −ln(aspect)).
pub(super) fn spot_outcomes_even(spots: &Spots, p: &Parameters) -> SmallVector {
    let rate = libm::log(p.rate);
    let log_spacing = libm::log(spots.spacing.unwrap_or(1.0));
    SmallVector::new([rate + libm::log(spots.area), rate + 2.0 * log_spacing, -libm::log(spots.aspect)])
}

/// The features of a question about stripes: (ln W, ln(W/λ) where `duty`, cos 4θ, sin 4θ).
///
/// The fourth harmonic is used because a grid does not change under a rotation by 90°.
pub(super) fn stripe_question(log_width: f64, duty: Option<f64>, angle: f64) -> SmallVector {
    SmallVector::new(std::iter::once(log_width).chain(duty).chain(harmonic(angle, 4.0)))
}

/// The outputs of an answer about stripes: (ln(rate·W²), −ln stretch, ln ratio where it has one, cos 2Δ, sin 2Δ), Δ = direction −
/// angle.
pub(super) fn stripe_answer(stripes: &Stripes, p: &Parameters) -> SmallVector {
    let mut answered =
        SmallVector::new([libm::log(p.rate) + 2.0 * libm::log(stripes.width), -libm::log(p.stretch)]);
    answered.extend(p.ratio.map(libm::log));
    answered.extend(harmonic(p.direction - stripes.angle, 2.0));
    answered
}

/// The parameters in the outputs `answered` for stripes of width e^`log_width` and this angle.
pub(super) fn stripe_parameters(log_width: f64, angle: f64, answered: &[f64]) -> Parameters {
    let n = answered.len();
    Parameters {
        rate: libm::exp(answered[0] - 2.0 * log_width),
        ratio: (n > 4).then(|| libm::exp(answered[2])),
        stretch: libm::exp(-answered[1]),
        direction: axial(angle + axis([answered[n - 2], answered[n - 1]])),
        level: None,
    }
}

/// The features of parameters of stripes: (ln rate, ln ratio where it has one, −ln stretch where it varies, cos 4φ, sin 4φ).
pub(super) fn stripe_features(p: &Parameters, stretch: bool) -> SmallVector {
    let mut features = SmallVector::new([libm::log(p.rate)]);
    features.extend(p.ratio.map(libm::log));
    features.extend(stretch.then(|| -libm::log(p.stretch)));
    features.extend(harmonic(p.direction, 4.0));
    features
}

/// The corresponding outputs: (ln(rate·W²), ln(rate·λ²) where it is free, cos 2Δ, sin 2Δ).
pub(super) fn stripe_outcomes(stripes: &Stripes, p: &Parameters) -> SmallVector {
    let rate = libm::log(p.rate);
    let mut seen = SmallVector::new([rate + 2.0 * libm::log(stripes.width)]);
    seen.extend(stripes.wavelength.map(|wavelength| rate + 2.0 * libm::log(wavelength)));
    seen.extend(harmonic(p.direction - stripes.angle, 2.0));
    seen
}
