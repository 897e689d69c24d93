//! The coordinates in which the factors of a system of pairs are learnt.

/// How a column becomes a coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// The value x itself.
    Plain,
    /// The logarithm ln x.
    Log,
    /// (cos 4x, sin 4x) of an angle x in degrees: the grid is the same after a quarter turn.
    Quarter,
}

impl Scale {
    /// The coordinates of a value.
    pub fn of(self, value: f64) -> impl Iterator<Item = f64> {
        let [first, second] = match self {
            Self::Plain => [Some(value), None],
            Self::Log => [Some(libm::log(value)), None],
            Self::Quarter => {
                let (s, c) = libm::sincos(4.0 * value.to_radians());
                [Some(c), Some(s)]
            }
        };
        first.into_iter().chain(second)
    }

    /// The value of a coordinate.
    #[must_use]
    pub fn back(self, coordinate: f64) -> f64 {
        if self == Self::Log { libm::exp(coordinate) } else { coordinate }
    }
}

/// The coordinates of a system: columns with their scales.
#[derive(Debug)]
pub struct Coordinates {
    /// Whether rows of two directions and of more are learnt apart.
    pub by_directions: bool,
    /// The columns that are asked, with their scales.
    pub asked: &'static [(&'static str, Scale)],
    /// The columns that are answered, with their scales.
    pub answered: &'static [(&'static str, Scale)],
    /// Lowest and highest duty of the random targets of `learn`: of two directions, and of three.
    pub duty: [[f64; 2]; 2],
}

impl Coordinates {
    /// ln of the factor by which a law is off.
    pub const FACTOR: (&'static str, Scale) = ("factor", Scale::Log);
}
