//! How much spots can vary, and how much they vary by themselves.

use crate::attributes::{Spots, Spread};
use crate::rd::System;
use crate::synth::recipe::limits::{SPREAD_ANGLE, SPREAD_AREA, SPREAD_SPACING};

/// The spread that will be grown instead of one that was asked, and why it differs.
#[derive(Clone, Debug, PartialEq)]
pub struct Limited {
    /// What can be had.
    pub spread: Spread,
    /// What cannot, in words and numbers.
    pub notes: Vec<String>,
}

/// The aspects between which spots of a system vary: below, tensors reach too far; above, even the roundest are not.
fn aspects(system: System) -> [f64; 2] {
    match system {
        System::TuringSpots => [0.27, 0.87],
        _ => [0.27, 0.99],
    }
}

/// Aspects that vary on both sides of their mean by at most d have a standard deviation of at most this share of d:
/// some nearer than the farthest there must be.
const WITHIN: f64 = 0.6;

/// What of `asked` can be had of spots that are `wanted` on the mean.
#[must_use]
pub fn limited(system: System, wanted: &Spots, asked: &Spread) -> Limited {
    let mut notes = Vec::new();
    let mut at_most = |what: &str, asked: f64, most: f64, why: &str, shown: &dyn Fn(f64) -> String| {
        if asked > most {
            let (asked, most) = (shown(asked), shown(most));
            notes.push(format!("{what} varies by {asked}, more than {most}, {why}; growing at {most}"));
        }
        asked.min(most)
    };
    let plain = |value: f64| format!("{value:.2}");
    let degrees = |value: f64| format!("{value:.0}°");
    let [low, high] = aspects(system);
    let room = (WITHIN * (wanted.aspect - low).min(high - wanted.aspect)).max(0.0);
    let most = "the most that grows without spots that merge";
    let spread = Spread {
        area: at_most("the area", asked.area, SPREAD_AREA.high, most, &plain),
        angle: at_most("the angle", asked.angle, SPREAD_ANGLE.high, most, &degrees),
        aspect: at_most(
            "the aspect",
            asked.aspect,
            room,
            &format!("as much as fits around {:.2} between {low} and {high}", wanted.aspect),
            &plain,
        ),
        spacing: at_most("the spacing", asked.spacing, SPREAD_SPACING.high, most, &plain),
    };
    Limited { spread, notes }
}

/// How much spots vary of which none was told to differ, measured on patches of 130 and 200 spots.
///
/// Shape and direction are one vector −ln aspect · (cos 2θ, sin 2θ), whose noise is the same for all aspects.
#[must_use]
pub fn by_itself(system: System, wanted: &Spots) -> Spread {
    let (area, shape) = match system {
        System::TuringSpots => (0.045, 0.065),
        _ => (0.03, 0.005),
    };
    let long = -libm::log(wanted.aspect.min(0.99));
    Spread {
        area,
        angle: (0.5 * shape / long).to_degrees().min(SPREAD_ANGLE.high),
        aspect: shape * wanted.aspect,
        spacing: 0.0,
    }
}

/// Standard deviation that is to be added for a total of `asked` where there is `own`.
#[must_use]
pub fn beyond(asked: f64, own: f64) -> f64 {
    (asked * asked - own * own).max(0.0).sqrt()
}
