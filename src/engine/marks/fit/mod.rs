//! Points → an ellipse (direct least squares, or by its second moments) or a line (total least squares).

mod ellipse;
mod line;

pub use ellipse::{ellipse, ellipse_from_moments};
pub use line::line;

/// Mean and covariance of points: x̄, ȳ and [cxx, cxy, cyy]. `None` without points or where they are not finite.
fn covariance(points: &[[f64; 2]]) -> Option<([f64; 2], [f64; 3])> {
    let n = points.len() as f64;
    let mean = [0, 1].map(|axis| points.iter().map(|point| point[axis]).sum::<f64>() / n);
    let mut moments = [0.0; 3];
    for [x, y] in points {
        let (x, y) = (x - mean[0], y - mean[1]);
        moments[0] += x * x;
        moments[1] += x * y;
        moments[2] += y * y;
    }
    let moments = moments.map(|sum| sum / n);
    (mean.iter().chain(&moments).all(|number| number.is_finite())).then_some((mean, moments))
}
