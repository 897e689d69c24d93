//! Direct least squares ellipse.

use nalgebra::{Matrix3, Schur, Vector3};

use super::covariance;
use crate::marks::{Ellipse, axial};

/// Below this ratio of variances across and along, points lie on a line. Rounding of centred
/// coordinates leaves some 1e-26 of exactly straight points; a drawn ellipse of aspect 0.01 has 1e-4.
const FLAT: f64 = 1e-10;

/// The ellipse that lies closest to `points` (px) by algebraic distance.
///
/// Minimises ‖D·a‖² over conics a = (a, b, c, d, e, f), a·u² + b·uv + c·v² + d·u + e·v + f = 0, under
/// aᵀC·a = 4ac − b² = 1, which only ellipses meet. The stable form of that eigenproblem splits
/// D = [D₁ D₂] and a = (a₁, a₂) into the quadratic and the linear part:
///
/// S₁ = D₁ᵀD₁, S₂ = D₁ᵀD₂, S₃ = D₂ᵀD₂, a₂ = −S₃⁻¹S₂ᵀ·a₁, C₁⁻¹(S₁ − S₂S₃⁻¹S₂ᵀ)·a₁ = λ·a₁
///
/// (Halír & Flusser, "Numerically stable direct least squares fitting of ellipses", WSCG 1998, eqs. 20–29,
/// after Fitzgibbon, Pilu & Fisher 1996.) The fit is the same in any affine frame, so (u, v) are the points
/// with their mean taken away and their covariance made the unit matrix: a thin ellipse is fitted as well as
/// a round one, and S₃ = n·1.
///
/// `radii[0]` of the answer is the major one. `None` where the points do not determine an ellipse: fewer than
/// five different ones, all on a line, not finite, or spread like a parabola.
///
/// ```
/// use dapple_engine::marks::fit;
///
/// let drawn: Vec<[f64; 2]> = (0..40)
///     .map(|k| (f64::from(k) / 40.0 * std::f64::consts::TAU).sin_cos())
///     .map(|(sin, cos)| [50.0 + 12.0 * cos, 40.0 + 6.0 * sin])
///     .collect();
/// let fitted = fit::ellipse(&drawn).unwrap();
/// assert!((fitted.aspect() - 0.5).abs() < 0.02 && (fitted.center[0] - 50.0).abs() < 0.1);
/// ```
#[must_use]
pub fn ellipse(points: &[[f64; 2]]) -> Option<Ellipse> {
    if points.len() < 5 {
        return None;
    }
    let (mean, [cxx, cxy, cyy]) = covariance(points)?;
    let flat = cxx * cyy - cxy * cxy <= FLAT * (cxx + cyy) * (cxx + cyy);
    if flat || !(cxx * cyy).is_normal() {
        return None;
    }
    // Covariance = L·Lᵀ; (u, v) = L⁻¹·(x − mean).
    let lxx = cxx.sqrt();
    let lyx = cxy / lxx;
    let lyy = (cyy - lyx * lyx).sqrt();
    let whitened = points.iter().map(|[x, y]| {
        let u = (x - mean[0]) / lxx;
        [u, ((y - mean[1]) - lyx * u) / lyy]
    });
    let ([u, v], [puu, puv, pvv]) = centre_and_shape(conic(whitened, points.len())?)?;
    // Back to px: centre = mean + L·(u, v), shape = L·P·Lᵀ.
    let center = [mean[0] + lxx * u, mean[1] + lyx * u + lyy * v];
    let pxx = lxx * lxx * puu;
    let pxy = lxx * (lyx * puu + lyy * puv);
    let pyy = lyx * lyx * puu + 2.0 * lyx * lyy * puv + lyy * lyy * pvv;
    from_shape_matrix(center, [pxx, pxy, pyy])
}

/// The ellipse with this centre (px) and these second moments, [xx, xy, yy], px².
///
/// A filled ellipse has the covariance P/4, where P is the matrix of its (x − c)ᵀP⁻¹(x − c) = 1.
/// `None` where they are those of a line or a point.
#[must_use]
pub fn ellipse_from_moments(center: [f64; 2], moments: [f64; 3]) -> Option<Ellipse> {
    from_shape_matrix(center, moments.map(|moment| 4.0 * moment))
}

/// The conic (a, b, c, d, e, f) of `n` centred, whitened points.
fn conic(points: impl Iterator<Item = [f64; 2]>, n: usize) -> Option<[f64; 6]> {
    let n = n as f64;
    let (mut s1, mut s2) = (Matrix3::zeros(), Matrix3::zeros());
    for [u, v] in points {
        let quadratic = Vector3::new(u * u, u * v, v * v);
        s1 += quadratic * quadratic.transpose() / n;
        s2 += quadratic * Vector3::new(u, v, 1.0).transpose() / n;
    }
    let s = s1 - s2 * s2.transpose();
    // C₁⁻¹ = [0 0 ½; 0 −1 0; ½ 0 0]
    let m = Matrix3::from_rows(&[0.5 * s.row(2), -s.row(1), 0.5 * s.row(0)]);
    // S is positive and C has one positive direction, so of the three eigenvalues only the ellipse's is
    // not negative. 100 rounds of QR: a 3×3 matrix takes some five.
    let eigenvalues = Schur::try_new(m, f64::EPSILON, 100)?.complex_eigenvalues();
    let lambda = eigenvalues.iter().map(|value| value.re).fold(f64::NEG_INFINITY, f64::max);
    let a1 = kernel(&(m - Matrix3::from_diagonal_element(lambda)))?;
    let a2 = -(s2.transpose() * a1);
    Some([a1[0], a1[1], a1[2], a2[0], a2[1], a2[2]])
}

/// The unit vector that a matrix of rank 2 takes to 0; `None` where its rank is lower.
fn kernel(m: &Matrix3<f64>) -> Option<Vector3<f64>> {
    let rows = [m.row(0).transpose(), m.row(1).transpose(), m.row(2).transpose()];
    let longest = [(0, 1), (0, 2), (1, 2)]
        .map(|(i, j)| rows[i].cross(&rows[j]))
        .into_iter()
        .fold(Vector3::zeros(), |best: Vector3<f64>, v| if v.norm() > best.norm() { v } else { best });
    (longest.norm() > 1e-10 * m.norm_squared()).then(|| longest / longest.norm())
}

/// Centre and shape P = [uu, uv, vv] of an ellipse's conic, (x − c)ᵀP⁻¹(x − c) = 1.
fn centre_and_shape([a, b, c, d, e, f]: [f64; 6]) -> Option<([f64; 2], [f64; 3])> {
    let det = 4.0 * a * c - b * b;
    if det.is_nan() || det <= 0.0 {
        return None;
    }
    let (u, v) = ((b * e - 2.0 * c * d) / det, (b * d - 2.0 * a * e) / det);
    let k = -(f + 0.5 * (d * u + e * v));
    let scale = 4.0 * k / det;
    Some(([u, v], [scale * c, -0.5 * scale * b, scale * a]))
}

/// The ellipse (x − c)ᵀP⁻¹(x − c) = 1 of P = [pxx, pxy, pyy], whose eigenvalues are the squared radii.
fn from_shape_matrix(center: [f64; 2], [pxx, pxy, pyy]: [f64; 3]) -> Option<Ellipse> {
    let (half_sum, half_difference) = (0.5 * (pxx + pyy), 0.5 * (pxx - pyy));
    let major = half_sum + (half_difference * half_difference + pxy * pxy).sqrt();
    // The product of the eigenvalues, not a difference: it keeps the digits of a thin ellipse.
    let minor = (pxx * pyy - pxy * pxy) / major;
    let radii = [major.sqrt(), minor.sqrt()];
    let angle = axial(0.5 * libm::atan2(pxy, half_difference).to_degrees());
    let sound = minor > FLAT * major && radii.iter().chain(&center).all(|number| number.is_finite());
    sound.then_some(Ellipse { center, radii, angle })
}

#[cfg(test)]
mod tests;
