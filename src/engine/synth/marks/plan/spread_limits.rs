//! The largest spread of spots, and their natural spread.

use std::f64::consts::PI;

use crate::attributes::{Attribute, Spots, Spread};
use crate::document::limits::{SPREAD_ANGLE, SPREAD_AREA};
use crate::learn::NARROWEST;
use crate::rd::OwnVariation;
use crate::rd::{SpotLimits, System, Variation};

/// The spread that will be grown instead of the one asked for, and the reason.
#[derive(Clone, Debug, PartialEq)]
pub struct Limited {
    /// The spread that can be reached.
    pub spread: Spread,
    /// The reason for the difference, in words and numbers.
    pub notes: Vec<String>,
}

/// Range of the aspects of single spots: narrower ones are not looked up, and no grown spot is rounder.
pub const ASPECTS: [f64; 2] = [NARROWEST, 0.99];
/// Standard deviation of aspects that differ from their mean by at most d, ÷ d.
const WITHIN: f64 = 0.6;
/// area ÷ spacing² where the spacing is not known.
const USUAL_DENSITY: f64 = 0.122;
/// Coefficient of variation of the distances of round spots.
const EVEN: f64 = 0.093;
/// Share of the stretch of long spots that remains in the distances of their neighbours, see [`least_spacing`].
const STRETCHED: f64 = 0.8;

/// The largest spread of spots whose mean is `wanted`.
#[must_use]
pub fn most(system: System, wanted: &Spots) -> Spread {
    let room = WITHIN * (wanted.aspect - ASPECTS[0]).min(ASPECTS[1] - wanted.aspect).max(0.0);
    let Some(SpotLimits { variation, .. }) = system.definition().spots else { return Spread::ZERO };
    let (free_density, area_by_density, turn, uneven) = match variation {
        Variation::Fixed(most) => {
            return Spread { aspect: room, angle: most.angle.max(by_itself(system, wanted).angle), ..most };
        }
        Variation::ByDensity { free_density, area_by_density, turn, spacing } => {
            (free_density, area_by_density, turn, spacing)
        }
    };
    let packing = wanted.spacing.map_or(USUAL_DENSITY, |spacing| wanted.area / (spacing * spacing));
    let length = 2.0 * (packing / (PI * wanted.aspect)).sqrt();
    Spread {
        area: (SPREAD_AREA.high - area_by_density * (packing - free_density).max(0.0)).max(0.0),
        angle: (turn.degrees * libm::pow(turn.length / length, turn.power)).min(SPREAD_ANGLE.high),
        aspect: room,
        // At least the natural value of long spots.
        spacing: uneven.max(least_spacing(wanted)),
    }
}

/// Coefficient of variation of the distances of equal spots: long spots stand farther apart along their direction.
///
/// A ring of neighbours stretched by 1/√ρ along and √ρ across, of which the share [`STRETCHED`] remains, plus [`EVEN`]: 0.11,
/// 0.136, 0.17, 0.21, 0.24, 0.29 were measured at aspect 0.8, 0.7, 0.6, 0.5, 0.4, 0.3.
fn least_spacing(wanted: &Spots) -> f64 {
    const DIRECTIONS: usize = 64;
    let squares = (0..DIRECTIONS).map(|k| {
        let c = libm::cos(PI * k as f64 / DIRECTIONS as f64);
        c * c / wanted.aspect + (1.0 - c * c) * wanted.aspect
    });
    let (sum, square) = squares.fold((0.0, 0.0), |(sum, square), one| (sum + one.sqrt(), square + one));
    let (mean, square) = (sum / DIRECTIONS as f64, square / DIRECTIONS as f64);
    let stretched = STRETCHED * STRETCHED * (square / (mean * mean) - 1.0).max(0.0);
    (stretched + EVEN * EVEN).sqrt()
}

/// The possible part of the spread `asked` of spots whose mean is `wanted`. If the spread was `given` as a number, a larger natural
/// spread is noted.
#[must_use]
pub fn limited(system: System, wanted: &Spots, asked: &Spread, given: bool) -> Limited {
    let most = most(system, wanted);
    let least = Spread { spacing: least_spacing(wanted), ..by_itself(system, wanted) };
    let mut notes = Vec::new();
    for (((attribute, asked), (_, most)), (_, least)) in
        asked.named().into_iter().zip(most.named()).zip(least.named())
    {
        let shown = |value: f64| {
            if attribute == Attribute::Angle { format!("{value:.0}°") } else { format!("{value:.2}") }
        };
        let (asked_shown, most_shown, least_shown) = (shown(asked), shown(most), shown(least));
        if asked > most && asked_shown != most_shown {
            let why = if attribute == Attribute::Aspect {
                "which fits around their mean"
            } else {
                "which keeps them apart"
            };
            notes.push(format!(
                "the {attribute} of spots varies by {asked_shown}, more than the {most_shown} {why}; growing at {most_shown}"
            ));
        } else if given && asked > 0.0 && asked < least && asked_shown != least_shown {
            notes.push(format!(
                "the {attribute} of spots varies by {asked_shown}, less than the {least_shown} by which such spots vary naturally"
            ));
        }
    }
    Limited { spread: asked.with(&most, f64::min), notes }
}

/// The natural spread of equal spots, except that of their spacing; measured on patches of 130 and 200 spots.
///
/// Shape and direction form one vector −ln aspect · (cos 2θ, sin 2θ), whose noise is equal for all aspects.
#[must_use]
pub fn by_itself(system: System, wanted: &Spots) -> Spread {
    let own = system.definition().spots.map(|spots| spots.own_variation);
    let OwnVariation { area, shape } = own.unwrap_or_default();
    let long = -libm::log(wanted.aspect.min(0.99));
    Spread {
        area,
        angle: (0.5 * shape / long).to_degrees().min(SPREAD_ANGLE.high),
        aspect: shape * wanted.aspect,
        spacing: 0.0,
    }
}

/// Standard deviation to be added to `own` for a total of `asked`.
#[must_use]
pub fn beyond(asked: f64, own: f64) -> f64 {
    (asked * asked - own * own).max(0.0).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spots(aspect: f64, packing: f64) -> Spots {
        Spots { area: 100.0, aspect, angle: 0.0, spacing: Some((100.0 / packing).sqrt()) }
    }

    #[test]
    fn a_possible_spread_is_unchanged() {
        let asked = Spread { area: 0.3, angle: 10.0, aspect: 0.1, spacing: 0.15 };
        let limited = limited(System::MEINHARDT_SPOTS, &spots(0.7, 0.1), &asked, false);
        assert_eq!(limited, Limited { spread: asked, notes: Vec::new() });
    }

    #[test]
    fn too_large_a_spread_is_reduced_with_a_note_that_has_the_numbers() {
        let asked = Spread { area: 0.5, angle: 20.0, ..Spread::ZERO };
        let limited = limited(System::MEINHARDT_SPOTS, &spots(0.4, 0.2), &asked, false);
        assert!((limited.spread.area - 0.3416).abs() < 1e-9 && (limited.spread.angle - 10.3).abs() < 0.1);
        assert_eq!(
            limited.notes,
            [
                "the area of spots varies by 0.50, more than the 0.34 which keeps them apart; growing at 0.34",
                "the angle of spots varies by 20°, more than the 10° which keeps them apart; growing at 10°",
            ]
        );
    }

    #[test]
    fn spots_without_room_to_vary_are_equal_and_rounding_gives_no_note() {
        let asked = Spread { area: 1e-17, ..Spread::ZERO };
        let limited = limited(System::MEINHARDT_SPOTS, &spots(0.6, 0.45), &asked, false);
        assert_eq!(limited, Limited { spread: Spread::ZERO, notes: Vec::new() });
    }

    #[test]
    fn a_note_about_the_uneven_spacing_of_long_spots_needs_a_given_number() {
        let asked = Spread { spacing: 0.1, ..Spread::ZERO };
        let notes = |given| limited(System::MEINHARDT_SPOTS, &spots(0.5, 0.1), &asked, given).notes;
        let note =
            "the spacing of spots varies by 0.10, less than the 0.20 by which such spots vary naturally";
        assert_eq!((notes(true), notes(false)), (vec![note.to_owned()], Vec::new()));
    }

    #[test]
    fn round_spots_are_spaced_as_evenly_as_a_relaxed_lattice_and_long_ones_are_not() {
        assert!((least_spacing(&spots(1.0, 0.1)) - EVEN).abs() < 1e-9);
        let [long, longer] = [0.6, 0.4].map(|aspect| least_spacing(&spots(aspect, 0.1)));
        assert!(long > 0.15 && longer > long && longer < 0.28, "{long} {longer}");
    }

    #[test]
    fn only_the_missing_part_of_a_spread_is_added() {
        assert_eq!((beyond(0.5, 0.3), beyond(0.1, 0.3)), (0.4, 0.0));
    }
}
