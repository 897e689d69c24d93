//! Marks, drawn or measured: ellipses and lines; and how points become one.

mod ellipse;
pub mod fit;
mod line;

pub use ellipse::Ellipse;
pub use line::Line;

/// An ellipse or a line, drawn or measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mark {
    /// A spot.
    Ellipse(Ellipse),
    /// A piece of a stripe.
    Line(Line),
}

/// The axial angle in [0, 180) that any finite `degrees` stands for.
#[must_use]
pub fn axial(degrees: f64) -> f64 {
    let angle = degrees.rem_euclid(180.0);
    if angle >= 180.0 { 0.0 } else { angle }
}

/// How far the axial angle `a` lies from `b`, degrees in −90..90.
#[must_use]
pub fn turn(a: f64, b: f64) -> f64 {
    axial(a - b + 90.0) - 90.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_are_axial() {
        assert_eq!(axial(-10.0), 170.0);
        assert_eq!(axial(540.0), 0.0);
        assert_eq!(axial(-1e-18), 0.0);
        assert_eq!(turn(175.0, 5.0), -10.0);
        assert_eq!(turn(5.0, 175.0), 10.0);
    }
}
