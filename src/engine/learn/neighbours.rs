//! The rows that an answer is computed from, for display.

use super::local::Local;
use super::training_set::Regressions;
use super::{InCells, Parameters, TrainingSet};
use crate::attributes::Attributes;
use crate::learn::small_vector::SmallVector;
use crate::marks::axial;

/// A row that an answer is computed from, as it is or as one of its mirror images.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Neighbour {
    /// Its number among the rows.
    pub row: usize,
    /// The attributes that were measured.
    pub attributes: InCells<Attributes>,
    /// The parameters that were set.
    pub parameters: Parameters,
    /// Its weight in the regression, 0..1.
    pub weight: f64,
}

/// An axis whose double angle has its cosine and sine multiplied by `signs`, degrees.
fn mirrored(angle: f64, [c, s]: [f64; 2]) -> f64 {
    axial(match (c < 0.0, s < 0.0) {
        (false, false) => angle,
        (false, true) => -angle,
        (true, false) => 90.0 - angle,
        (true, true) => 90.0 + angle,
    })
}

impl TrainingSet {
    /// The rows that the answer to `asked` is computed from, the nearest first. A question beyond the rows
    /// should be moved first: [`Answer::nearest`](super::Answer::nearest). Empty for attributes of the other kind.
    #[must_use]
    pub fn neighbours(&self, asked: &InCells<Attributes>) -> Vec<Neighbour> {
        let near = match (&self.map, &asked.0) {
            (Regressions::Spots(map), Attributes::Spots(spots)) => map.near(spots),
            (Regressions::Stripes(map), Attributes::Stripes(stripes)) => map.near(stripes),
            _ => return Vec::new(),
        };
        let neighbour = |(row, signs, weight): (usize, [f64; 2], f64)| {
            let known = self.rows.get(row)?;
            let (mut attributes, mut parameters) = (known.attributes, known.parameters);
            match &mut attributes.0 {
                Attributes::Spots(spots) => {
                    spots.angle = mirrored(spots.angle, signs);
                    parameters.direction = mirrored(parameters.direction, signs);
                }
                // A mirror image of stripes reverses 4θ and 2Δ together: it is the one at −θ.
                Attributes::Stripes(stripes) if signs[1] < 0.0 => {
                    stripes.angle = axial(-stripes.angle);
                    parameters.direction = axial(-parameters.direction);
                }
                Attributes::Stripes(_) => {}
            }
            Some(Neighbour { row, attributes, parameters, weight })
        };
        near.into_iter().filter_map(neighbour).collect()
    }
}

impl Local {
    /// Row, mirror image and weight of each sample of the regression at `q`.
    pub(super) fn weights(&self, q: &SmallVector) -> Vec<(usize, [f64; 2], f64)> {
        let q = self.standardised(q);
        let near = self.near(&q, self.neighbours(), None);
        let h = near.last().map_or(1.0, |last| last.squared().sqrt()).max(1e-9);
        let weight = |squared: f64| {
            let d = 1.5 * squared.sqrt() / h;
            libm::exp(-d * d)
        };
        near.iter().map(|near| (near.row(), self.image(near.image()), weight(near.squared()))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::laws::{MEASURED, TURING, turing};
    use super::*;
    use crate::attributes::Spots;

    #[test]
    fn the_neighbours_of_a_row_begin_with_itself_at_full_weight() {
        let set = TrainingSet::from_rows(&TURING, turing(60, MEASURED)).unwrap();
        let row = set.rows()[17];
        let near = set.neighbours(&row.attributes);
        assert_eq!((near[0].row, near[0].weight), (17, 1.0));
        assert_eq!(near[0].parameters.rate, row.parameters.rate);
        assert!(near.windows(2).all(|two| two[0].weight >= two[1].weight));
        assert!(near.iter().all(|near| near.weight > 0.1));
    }

    #[test]
    fn mirror_images_are_shown_at_their_own_places() {
        let set = TrainingSet::from_rows(&TURING, turing(60, MEASURED)).unwrap();
        let InCells(Attributes::Spots(spots)) = set.rows()[3].attributes else { panic!() };
        for angle in [-spots.angle, 90.0 - spots.angle, 90.0 + spots.angle] {
            let angle = axial(angle);
            let near = set.neighbours(&InCells(Attributes::Spots(Spots { angle, ..spots })));
            let InCells(Attributes::Spots(found)) = near[0].attributes else { panic!() };
            assert_eq!(near[0].row, 3);
            assert!((found.angle - angle).abs() < 1e-9, "{} {angle}", found.angle);
        }
    }

    #[test]
    fn attributes_of_the_other_kind_have_no_neighbours() {
        let set = TrainingSet::from_rows(&TURING, turing(60, MEASURED)).unwrap();
        let stripes = crate::attributes::Stripes { width: 8.0, angle: 0.0, wavelength: None };
        assert!(set.neighbours(&InCells(Attributes::Stripes(stripes))).is_empty());
    }
}
