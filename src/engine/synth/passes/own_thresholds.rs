//! The threshold of each drawn spot, for the last per cents of its area. Factors of single spots change the mean of their region,
//! which the factors of the other spots compensate.

use super::thresholds::{Moved, NEAR};

/// Rounds of measuring and moving.
const ROUNDS: usize = 3;

/// The area of a drawn spot that has grown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpotArea {
    /// ln(got ÷ drawn).
    pub error: f64,
    /// Whether it has not merged with another spot. The error of a merged spot gives no information about its slope.
    pub alone: bool,
}

/// A pattern whose spots can have thresholds of their own.
pub trait OwnThresholds {
    /// Number of drawn spots.
    fn drawn_count(&self) -> usize;

    /// The areas of the drawn spots; `None` for those that have not grown.
    fn drawn_areas(&self) -> Vec<Option<SpotArea>>;

    /// ln(got ÷ wanted) of the mean area of the other spots, by region; `None` if they are too few.
    fn other_areas(&self) -> Vec<Option<f64>>;

    /// d ln area / d ln threshold.
    fn own_slope(&self) -> f64;

    /// Gives the drawn spots, and the others by region, these factors, and measures again.
    fn set_own(&mut self, drawn: &[f64], others: &[f64]);
}

/// Thresholds of single spots that are moved in rounds.
pub struct OwnLevelling {
    /// Logarithms of the factors of the drawn spots.
    drawn: Vec<f64>,
    /// Logarithm of the factor of each at the last measurement, and the excess of ln area.
    before: Vec<Option<[f64; 2]>>,
    /// Logarithms of the factors of the other spots, by region.
    others: Vec<f64>,
    range: [f64; 2],
    round: usize,
}

impl OwnLevelling {
    /// The state before the first round. Factors stay in `range`.
    pub fn new(of: &impl OwnThresholds, regions: usize, range: [f64; 2]) -> Self {
        let drawn = of.drawn_count();
        Self {
            drawn: vec![1.0; drawn],
            before: vec![None; drawn],
            others: vec![1.0; regions],
            range,
            round: 0,
        }
    }

    /// Moves the thresholds of the drawn spots towards the drawn areas, and those of the others so that their mean does not change.
    /// Returns what was moved, with the errors.
    pub fn advance(&mut self, of: &mut impl OwnThresholds) -> Option<Moved> {
        if self.drawn.is_empty() || self.round == ROUNDS {
            return None;
        }
        let (slope, [least, largest]) = (of.own_slope(), self.range);
        let moved =
            |factor: f64, error: f64, slope: f64| (factor * libm::exp(-error / slope)).clamp(least, largest);
        for (factor, error) in self.others.iter_mut().zip(of.other_areas()) {
            if let Some(error) = error {
                *factor = moved(*factor, error, slope);
            }
        }
        let mut step = Moved { largest: 0.0, count: 0 };
        for (index, area) in of.drawn_areas().into_iter().enumerate() {
            let Some(SpotArea { error, alone }) = area else { continue };
            let slope = self.slope(index, error, alone, slope);
            if error.abs() >= NEAR {
                self.drawn[index] = moved(self.drawn[index], error, slope);
                step = Moved { largest: step.largest.max(error.abs()), count: step.count + 1 };
            }
        }
        if step.count == 0 {
            return None;
        }
        of.set_own(&self.drawn, &self.others);
        self.round += 1;
        Some(step)
    }

    /// d ln area / d ln threshold of drawn spot `index`, whose ln area exceeds the drawn one by `error`: `slope`, or a steeper one
    /// if the last correction was too large. A flatter one would lead to larger corrections, which can make neighbours touch.
    fn slope(&mut self, index: usize, error: f64, alone: bool, slope: f64) -> f64 {
        let now = alone.then_some([libm::log(self.drawn[index]), error]);
        let before = std::mem::replace(&mut self.before[index], now);
        let (Some(now), Some(before)) = (now, before) else { return slope };
        let [factor, area] = [0, 1].map(|k| now[k] - before[k]);
        if factor.abs() > 1e-3 { (area / factor).clamp(2.0 * slope, slope) } else { slope }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Drawn spots and others of one region, whose areas are powers of their thresholds. The true slope of the drawn ones is twice
    /// the given one.
    struct Areas {
        drawn: Vec<f64>,
        other: f64,
        first: (Vec<f64>, f64),
    }

    const SLOPE: f64 = -1.2;

    impl OwnThresholds for Areas {
        fn drawn_count(&self) -> usize {
            self.drawn.len()
        }

        fn drawn_areas(&self) -> Vec<Option<SpotArea>> {
            self.drawn.iter().map(|error| Some(SpotArea { error: *error, alone: true })).collect()
        }

        fn other_areas(&self) -> Vec<Option<f64>> {
            vec![Some(self.other)]
        }

        fn own_slope(&self) -> f64 {
            SLOPE
        }

        fn set_own(&mut self, drawn: &[f64], others: &[f64]) {
            let (first, other) = &self.first;
            self.drawn =
                first.iter().zip(drawn).map(|(first, by)| first + 2.0 * SLOPE * libm::log(*by)).collect();
            self.other = other + SLOPE * libm::log(others[0]);
        }
    }

    #[test]
    fn drawn_spots_get_their_areas_and_the_others_keep_their_mean() {
        let first = (vec![0.2, -0.1], 0.04);
        let mut areas = Areas { drawn: first.0.clone(), other: first.1, first };
        let mut levelling = OwnLevelling::new(&areas, 1, [0.6, 1.5]);
        let rounds = std::iter::from_fn(|| levelling.advance(&mut areas)).count();
        assert!(rounds == 2 || rounds == 3, "{rounds}");
        assert!(areas.drawn.iter().all(|error| error.abs() < 0.002) && areas.other.abs() < 1e-9);
    }
}
