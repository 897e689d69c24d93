//! Random targets in the ranges of attributes that a system must be able to grow.

use crate::attributes::{Attributes, Spots, Stripes};
use crate::rd::System;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

/// Range of the areas of spots, px².
const AREA: [f64; 2] = [40.0, 1_500.0];
const ASPECT: [f64; 2] = [0.3, 1.0];
/// Range of area ÷ spacing² of Meinhardt's spots; Turing's spots have their own.
const DENSITY: [f64; 2] = [0.02, 0.2];
/// Range of the widths of stripes, px.
const WIDTH: [f64; 2] = [3.0, 40.0];

/// Range of stripe width ÷ period, for Meinhardt's lines.
const DUTY: [f64; 2] = [0.2, 0.5];

/// A target; lengths in px.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Target {
    /// The attributes that are asked for; without a spacing for Turing's spots.
    pub wanted: Attributes,
    /// The seed of its growth.
    pub seed: u64,
}

/// `count` targets: sizes and densities uniform on a logarithmic scale, aspects and angles uniform.
pub fn targets(system: System, count: usize, seed: u64) -> Vec<Target> {
    let mut rng = Pcg64::seed_from_u64(seed);
    (0..count)
        .map(|_| {
            let mut uniform = |[low, high]: [f64; 2]| low + (high - low) * rng.random::<f64>();
            let mut log = |range: [f64; 2]| libm::exp(uniform(range.map(libm::log)));
            let wanted = if system.is_striped() {
                let width = log(WIDTH);
                let duty = system.description().free_spacing.then(|| uniform(DUTY));
                let wavelength = duty.map(|duty| width / duty);
                Attributes::Stripes(Stripes { width, angle: uniform([0.0, 180.0]), wavelength })
            } else {
                let (area, density) = (log(AREA), log(DENSITY));
                let spacing = system.description().free_spacing.then(|| (area / density).sqrt());
                Attributes::Spots(Spots {
                    area,
                    aspect: uniform(ASPECT),
                    angle: uniform([0.0, 180.0]),
                    spacing,
                })
            };
            Target { wanted, seed: rng.random() }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn targets_fill_the_ranges_and_are_the_same_for_a_seed() {
        let of = |seed| targets(System::MEINHARDT_SPOTS, 1_000, seed);
        assert_eq!(of(7), of(7));
        assert_ne!(of(7), of(8));
        let spots: Vec<Spots> = of(7)
            .iter()
            .map(|target| match target.wanted {
                Attributes::Spots(spots) => spots,
                Attributes::Stripes(stripes) => panic!("{stripes:?}"),
            })
            .collect();
        let span = |of: fn(&Spots) -> f64| {
            spots.iter().map(of).fold([f64::INFINITY, 0.0], |[low, high], x| [low.min(x), f64::max(high, x)])
        };
        let inside = |[low, high]: [f64; 2], range: [f64; 2]| {
            let slack = 0.05 * (range[1] - range[0]);
            range[0] <= low && low < range[0] + slack && range[1] - slack < high && high <= range[1]
        };
        assert!(inside(span(|s| s.area), AREA));
        assert!(inside(span(|s| s.aspect), ASPECT));
        assert!(inside(span(|s| s.angle), [0.0, 180.0]));
        assert!(inside(span(|s| s.area / s.spacing.unwrap().powi(2)), DENSITY));
    }

    #[test]
    fn turing_s_spots_have_their_own_spacing() {
        let own = |target: &Target| matches!(target.wanted, Attributes::Spots(Spots { spacing: None, .. }));
        assert!(targets(System::TURING_SPOTS, 9, 1).iter().all(own));
    }
}
