//! Vectors in space.

/// A point or a vector.
pub type Vector = [f64; 3];

pub fn plus(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub fn times(a: Vector, by: f64) -> Vector {
    [a[0] * by, a[1] * by, a[2] * by]
}

pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

pub fn distance(a: Vector, b: Vector) -> f64 {
    length(minus(a, b))
}

/// The vector of length 1 in this direction; `None` for a vector without direction.
pub fn unit(a: Vector) -> Option<Vector> {
    let length = length(a);
    (length > f64::MIN_POSITIVE && length.is_finite()).then(|| times(a, 1.0 / length))
}

/// The part of a vector at right angles to a unit vector.
pub fn across(a: Vector, normal: Vector) -> Vector {
    minus(a, times(normal, dot(a, normal)))
}

/// The point halfway.
pub fn middle(a: Vector, b: Vector) -> Vector {
    times(plus(a, b), 0.5)
}

/// The coordinate axis at the smallest angle to a plane: one that is certainly not along its `normal`.
pub fn axis_beside(normal: Vector) -> Vector {
    let [x, y, z] = normal.map(f64::abs);
    if x <= y && x <= z {
        [1.0, 0.0, 0.0]
    } else if y <= z {
        [0.0, 1.0, 0.0]
    } else {
        [0.0, 0.0, 1.0]
    }
}
