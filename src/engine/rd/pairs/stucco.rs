//! Stucco: blotches from noise by one isotropic pair; a decrease of the gain breaks them up.
//!
//! A. Witkin & M. Kass let k fall from 3 to 0.6 in a time of 40/b while θ = 0.03 stays. Counted in K₀k, the threshold rises from
//! θ₀ to θ₀ ÷ (1 − decay), decay = 1 − the last k ÷ the first: worms break up into dots.

use super::Course;
use super::shared_description::{THREADS, USUAL_DUTY};
use crate::attributes::Attribute;
use crate::attributes::coordinates::{Coordinates, Scale};
use crate::attributes::pair_columns;
use crate::attributes::system::{Description, Keys, LookupBy, picture};
use crate::rd::systems::embedded;

/// The description of stucco.
pub static STUCCO: Description = Description {
    name: "stucco",
    title: "Stucco",
    noun: "stucco",
    help: "Dots and worms without a direction, as wide as the drawn marks",
    picture: picture!("stucco"),
    // Blotches and worms are as wide as marks of either kind.
    either_marks: true,
    directed: false,
    option_keys: &["decay"],
    own_keys: &[Keys {
        keys: &["options.decay"],
        reason: "Only stucco has this option: set \"system\" to \"stucco\"",
    }],
    refused_keys: &[Keys {
        keys: &["maps.area", "maps.direction", "maps.aspect", "maps.duty"],
        reason: "Blotches of stucco have no direction, and `options.decay` determines their coverage; their spacing can have a map",
    }],
    lookup: LookupBy::Pairs(&Coordinates {
        by_directions: false,
        asked: &[("decay", Scale::Plain)],
        answered: &[Coordinates::FACTOR],
        duty: USUAL_DUTY,
    }),
    grown_errors: &[(Attribute::Width, [6.0, 15.0])],
    columns: &pair_columns::STUCCO,
    training: embedded!["stucco"],
    ..THREADS
};

/// The gain of stucco.
pub struct Stucco;

impl Stucco {
    /// The decay of the paper: 1 − 0.6 ÷ 3.
    pub const DECAY: f64 = 0.8;
    /// The largest decay: above it the last blotches vanish.
    pub const MOST_DECAY: f64 = 0.85;
    /// θ₀/K₀k: 0.03 ÷ (0.2 · 3).
    const FIRST: f64 = 0.05;
    /// Duration of the decrease of the gain, in 1/b.
    const FALLING: f64 = 8.0;

    /// θ/K₀k by time.
    #[must_use]
    pub fn threshold(decay: f64) -> Course {
        let rate = (libm::log(1.0 - decay) / Self::FALLING) as f32;
        Course::Decay { from: Self::FIRST as f32, rate, until: Self::FALLING as f32 }
    }

    /// θ/K₀k at the end.
    #[must_use]
    pub fn last_threshold(decay: f64) -> f64 {
        Self::FIRST / (1.0 - decay)
    }
}
