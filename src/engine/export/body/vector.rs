//! Vectors of three numbers.

pub use crate::surface::vector::{Vector, cross, dot, minus};

/// `a` + `times` · `b`.
pub fn plus(a: Vector, times: f64, b: Vector) -> Vector {
    [a[0] + times * b[0], a[1] + times * b[1], a[2] + times * b[2]]
}

/// The vector scaled to length 1; upwards if its length is 0.
pub fn unit(vector: Vector) -> Vector {
    let length = dot(vector, vector).sqrt();
    if length > 0.0 && length.is_finite() { vector.map(|value| value / length) } else { [0.0, 1.0, 0.0] }
}
