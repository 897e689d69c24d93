//! Isolated spots: farther apart than the natural spacing of their system.
//!
//! If the ground of a system is inert, spots appear only at initial marks, and a spot without neighbours has one shape at any
//! spacing: a law replaces the rows. A tensor of determinant 1 only stretches the spot: aspect = stretch, angle = direction. At the
//! ratio of [`IsolatedSpots`]
//!
//! ```text
//! A·rate = K · (ln l ÷ ln ½)^k · (1 − c·exp(−a·q − b·q²))     q = p − 1     p = L·√rate ÷ (S · (d₁ + d₂ · ln² stretch))
//!
//! A area, l level, L spacing; p pitch, the spacing ÷ the natural spacing; S natural distance of initial places
//! × √rate; d the spacing ÷ the distance of initial places
//! ```

use crate::attributes::system::Crowding;
use crate::attributes::system::IsolatedSpots;
use crate::attributes::{Attribute, Attributes, Spots};
use crate::learn::answer::{Prediction, checked};
use crate::learn::coverage::{Coverage, Judgement};
use crate::learn::note::{Note, Quantity};
use crate::learn::spot_ranges::SpotRanges;
use crate::learn::training_set::{Regressions, TrainingSet};
use crate::learn::{AskError, Found, InCells, Parameters};

/// Rate and pitch of such spots at `level`. Lengths are cells.
fn rate_and_pitch(law: &IsolatedSpots, spots: &Spots, spacing: f64, level: f64) -> [f64; 2] {
    let area = law.area * libm::pow(libm::log(level) / libm::log(0.5), law.foot);
    let stretched = libm::log(spots.aspect);
    let own = law.spacing * (law.round + law.by_stretch * stretched * stretched);
    let pitch = |rate: f64| spacing * rate.sqrt() / own;
    let rate = |pitch: f64| {
        let Crowding { c, a, b } = law.crowding;
        let q = (pitch - 1.0).max(0.0);
        area * (1.0 - c * libm::exp(-a * q - b * q * q)) / spots.area
    };
    // The iteration starts from spots without neighbours. Neighbours reduce the area, and so the distance in pitches.
    let mut found = rate(f64::INFINITY);
    for _ in 0..16 {
        found = rate(pitch(found));
    }
    [found, pitch(found)]
}

/// The highest level at which spots have enough room, of which only the share `room` of the spacing is available.
fn level(law: &IsolatedSpots, spots: &Spots, spacing: f64, room: f64) -> Option<f64> {
    let pitch = |level: f64| room * rate_and_pitch(law, spots, spacing, level)[1];
    let (mut high, mut low) = (law.highest_level, law.lowest_level);
    let IsolatedSpots { alone, merging, .. } = *law;
    if pitch(high) >= alone {
        return Some(high);
    }
    if pitch(low) < alone {
        return (pitch(low) >= merging).then_some(low);
    }
    for _ in 0..20 {
        let mean = 0.5 * (low + high);
        *if pitch(mean) >= alone { &mut low } else { &mut high } = mean;
    }
    Some(low)
}

impl TrainingSet {
    /// The parameters for spots `wanted` at given places, farther apart than the natural spacing; `None`
    /// if they are too close for that, or if the system has no isolated spots. In the direction with the least room only the
    /// share `room` of the spacing, 0..1, is available; it is 1 where the places suit the shape of the spots.
    ///
    /// # Errors
    /// Those of [`Self::ask`].
    pub fn ask_apart(&self, wanted: &InCells<Attributes>, room: f64) -> Result<Option<Found>, AskError> {
        let (Regressions::Spots(map), Attributes::Spots(spots)) = (&self.map, checked(wanted)?) else {
            return Ok(None);
        };
        let law = self.system.isolated.as_ref().filter(|_| map.usual().dense());
        Ok(law.zip(spots.spacing).and_then(|(law, spacing)| apart(law, map, &spots, spacing, room)))
    }
}

fn apart(law: &IsolatedSpots, map: &SpotRanges, spots: &Spots, spacing: f64, room: f64) -> Option<Found> {
    let mut judgement = Judgement::new();
    let area = libm::exp(judgement.clamp(&map.usual().area, libm::log(spots.area)));
    let aspect = libm::exp(-judgement.clamp(&map.elongation, -libm::log(spots.aspect)));
    // Spots rounder than any row are no extrapolation.
    let aspect = aspect.max(spots.aspect);
    let grown = Spots { area, aspect, spacing: Some(spacing), ..*spots };
    let level = level(law, &grown, spacing, room)?;
    let [rate, pitch] = rate_and_pitch(law, &grown, spacing, level);
    let Judgement { coverage, mut notes } = judgement;
    let share = |density: f64| Quantity::new(Attribute::Density, density);
    notes.push(Note::Apart {
        asked: share(area / (spacing * spacing)),
        sparsest: share(libm::exp(map.usual().density.span[0])),
        pitch,
    });
    let sure = law.intervals;
    let within = |value: f64, sure: f64| [value * (1.0 - sure), value * (1.0 + sure)];
    let [low, high] = within(aspect, sure.aspect);
    let interval = vec![
        (Attribute::Area, within(area, sure.area)),
        (Attribute::Aspect, [low, high.min(1.0)]),
        (Attribute::Angle, [grown.angle - sure.angle, grown.angle + sure.angle]),
        (Attribute::Spacing, within(spacing, sure.spacing)),
    ];
    let prediction = Prediction { attributes: Attributes::Spots(grown), interval };
    Some(Found {
        parameters: Parameters {
            rate,
            ratio: Some(law.ratio),
            stretch: aspect,
            direction: grown.angle,
            level: Some(level),
        },
        pitch,
        coverage: coverage.max(Coverage::Edge),
        nearest: InCells(Attributes::Spots(grown)),
        notes: InCells(notes),
        prediction: InCells(prediction).into(),
    })
}

#[cfg(test)]
mod tests {
    use super::super::Answer;
    use super::super::laws::{ISOLATED, MEINHARDT, TURING};
    use super::*;

    fn asked(area: f64, aspect: f64, spacing: f64) -> Option<Answer> {
        let set = TrainingSet::embedded(&MEINHARDT).unwrap();
        let spots = Spots { area, aspect, angle: 160.0, spacing: Some(spacing) };
        Some(set.ask_apart(&InCells(Attributes::Spots(spots)), 1.0).unwrap()?.predict(&set).0)
    }

    #[test]
    fn spots_twenty_diameters_apart_have_the_area_of_spots_without_neighbours() {
        let answer = asked(48.0, 0.5, 156.0).unwrap();
        assert!((answer.parameters.rate * 48.0 / ISOLATED.area - 1.0).abs() < 1e-6, "{answer:?}");
        assert_eq!((answer.parameters.stretch, answer.parameters.direction), (0.5, 160.0));
        assert!(answer.pitch > 8.0 && answer.coverage == Coverage::Edge, "{answer:?}");
        assert_eq!(answer.predicted, answer.nearest);
    }

    #[test]
    fn closer_spots_are_read_at_lower_levels_until_they_are_too_close() {
        let found = [120.0, 28.0, 26.0, 20.0].map(|spacing| asked(48.0, 1.0, spacing).unwrap());
        let levels = found.each_ref().map(|answer| answer.parameters.level.unwrap());
        assert!(levels[0] == ISOLATED.highest_level && levels[3] == ISOLATED.lowest_level, "{levels:?}");
        assert!(levels.windows(2).all(|pair| pair[1] < pair[0]), "{levels:?}");
        // At spacings between these the pitch is exactly the required one.
        let enough = |answer: &Answer| (answer.pitch - ISOLATED.alone).abs() < 0.01;
        assert!(found[1..3].iter().all(enough) && found[3].pitch >= ISOLATED.merging, "{found:?}");
        assert!(asked(48.0, 1.0, 12.0).is_none());
    }

    #[test]
    fn only_spots_with_a_spacing_and_an_inert_ground_can_be_isolated() {
        let turing = TrainingSet::embedded(&TURING).unwrap();
        let spots = Spots { area: 48.0, aspect: 0.7, angle: 0.0, spacing: Some(200.0) };
        assert!(turing.ask_apart(&InCells(Attributes::Spots(spots)), 1.0).unwrap().is_none());
        let set = TrainingSet::embedded(&MEINHARDT).unwrap();
        let free = Attributes::Spots(Spots { spacing: None, ..spots });
        assert!(set.ask_apart(&InCells(free), 1.0).unwrap().is_none());
        let wrong = Attributes::Spots(Spots { area: -1.0, ..spots });
        assert!(set.ask_apart(&InCells(wrong), 1.0).is_err());
    }
}
