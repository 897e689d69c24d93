//! In which coordinates the factors of each system of pairs are learnt.

use crate::attributes::system::Description;

/// How a column becomes a coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scale {
    /// x.
    Plain,
    /// ln x.
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
    pub fn back(self, coordinate: f64) -> f64 {
        if self == Self::Log { libm::exp(coordinate) } else { coordinate }
    }
}

/// The coordinates of a system: columns with their scales.
#[derive(Debug)]
pub(super) struct Coordinates {
    /// Whether rows of two directions and of more are learnt apart.
    pub by_directions: bool,
    /// What is asked.
    pub asked: &'static [(&'static str, Scale)],
    /// What is answered.
    pub answered: &'static [(&'static str, Scale)],
}

const FACTOR: (&str, Scale) = ("factor", Scale::Log);

/// Those of `system`; `None` where it has no rows of pairs.
pub(super) fn coordinates(system: &Description) -> Option<&'static Coordinates> {
    Some(match system.name {
        "weave" => &Coordinates {
            by_directions: true,
            asked: &[
                ("duty", Scale::Log),
                ("others", Scale::Plain),
                ("unequal", Scale::Log),
                ("between", Scale::Plain),
            ],
            answered: &[FACTOR],
        },
        "maze" => &Coordinates {
            by_directions: true,
            asked: &[("duty", Scale::Plain), ("long", Scale::Log), ("between", Scale::Plain)],
            answered: &[FACTOR, ("level", Scale::Plain)],
        },
        "pair-stripes" => &Coordinates {
            by_directions: false,
            asked: &[("duty", Scale::Log), ("angle", Scale::Quarter)],
            answered: &[FACTOR],
        },
        "stucco" => {
            &Coordinates { by_directions: false, asked: &[("decay", Scale::Plain)], answered: &[FACTOR] }
        }
        "cells" => &Coordinates {
            by_directions: false,
            asked: &[("sparse", Scale::Log), ("aspect", Scale::Plain)],
            answered: &[FACTOR, ("apart", Scale::Log)],
        },
        _ => return None,
    })
}
