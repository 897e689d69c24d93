//! Patches that differ from each other by a wanted amount: each has its own area, aspect and direction.
//!
//! Patches with more room are larger more often than by chance. Otherwise large ones would be cramped between close centres.

use rand::Rng;

use super::Wanted;
use super::laws::own_spread;
use crate::attributes::Spread;
use crate::points::centers::LONGEST;
use crate::points::labels::normal;

/// Correlation of the size of a patch with its room. Not tuned: at 1 sizes would depend on the room alone, at 0 large patches were
/// cramped.
const BY_ROOM: f64 = 0.7;

/// Wanted properties for each patch: `wanted` gives the means and spreads, `room` the free area around each patch, px².
pub fn varied(wanted: &[Wanted], room: &[f64], detail: f64, rng: &mut impl Rng) -> Vec<Wanted> {
    let mut scores: Vec<f64> = standardised(wanted.iter().map(|_| normal(rng)).collect());
    scores.sort_by(f64::total_cmp);
    let ease =
        wanted.iter().zip(room).map(|(wanted, room)| libm::log(room.max(f64::MIN_POSITIVE) / wanted.area));
    let ease = standardised(ease.collect());
    let chance = (1.0 - BY_ROOM * BY_ROOM).sqrt();
    let key: Vec<f64> = ease.iter().map(|ease| BY_ROOM * ease + chance * normal(rng)).collect();
    let mut order: Vec<usize> = (0..wanted.len()).collect();
    order.sort_by(|a, b| key[*a].total_cmp(&key[*b]).then(a.cmp(b)));
    let mut all = wanted.to_vec();
    for (index, score) in order.into_iter().zip(scores) {
        let Wanted { spread, .. } = wanted[index];
        let own = own_spread(&wanted[index], detail);
        let Spread { area, angle, aspect, .. } = spread.with(&own, beyond);
        let sigma = libm::log(1.0 + area * area).sqrt();
        let patch = &mut all[index];
        patch.area *= libm::exp(sigma * score - 0.5 * sigma * sigma);
        patch.aspect = (patch.aspect + aspect * normal(rng)).clamp(LONGEST, 1.0);
        patch.angle += angle * normal(rng);
    }
    // The mean of few random values differs from the wanted mean.
    let asked: f64 = wanted.iter().map(|wanted| wanted.area).sum();
    let factor = asked / all.iter().map(|patch| patch.area).sum::<f64>();
    all.iter_mut().filter(|_| factor.is_finite()).for_each(|patch| patch.area *= factor);
    all
}

/// Standard deviation that must be added to `own` for a total of `asked`; 0 if `asked` is 0.
fn beyond(asked: f64, own: f64) -> f64 {
    (asked * asked - own * own).max(0.0).sqrt()
}

/// The values shifted and scaled to mean 0 and standard deviation 1; zeros if all are equal.
fn standardised(mut values: Vec<f64>) -> Vec<f64> {
    let count = values.len().max(1) as f64;
    let mean = values.iter().sum::<f64>() / count;
    let deviation = (values.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / count).sqrt();
    let scale = if deviation > 1e-12 { 1.0 / deviation } else { 0.0 };
    values.iter_mut().for_each(|value| *value = (*value - mean) * scale);
    values
}

#[cfg(test)]
mod tests {
    use rand::SeedableRng;
    use rand_pcg::Pcg64Mcg;

    use super::*;

    const PATCH: Wanted = Wanted {
        area: 900.0,
        spacing: 45.0,
        aspect: 0.6,
        angle: 20.0,
        raggedness: 1.0,
        spread: Spread::ZERO,
    };

    #[test]
    fn areas_vary_as_wanted_and_large_patches_have_more_room() {
        let spread = Spread { area: 0.4, ..Spread::ZERO };
        let wanted = vec![Wanted { spread, ..PATCH }; 400];
        let room: Vec<f64> = (0..400).map(|k| 1000.0 + f64::from(k)).collect();
        let all = varied(&wanted, &room, 24.0, &mut Pcg64Mcg::seed_from_u64(5));
        let mean = all.iter().map(|patch| patch.area).sum::<f64>() / 400.0;
        let square = all.iter().map(|patch| (patch.area - mean) * (patch.area - mean)).sum::<f64>() / 400.0;
        let (found, own) = (square.sqrt() / mean, own_spread(&PATCH, 24.0).area);
        assert!((mean - 900.0).abs() < 1e-6, "{mean}");
        assert!((found - beyond(0.4, own)).abs() < 0.03, "{found}");
        let half = |from: usize| all[from..from + 200].iter().map(|patch| patch.area).sum::<f64>();
        assert!(half(200) > 1.4 * half(0));
    }

    #[test]
    fn without_a_spread_all_patches_have_the_wanted_values() {
        let wanted = vec![PATCH; 30];
        let room = vec![1500.0; 30];
        assert_eq!(varied(&wanted, &room, 24.0, &mut Pcg64Mcg::seed_from_u64(5)), wanted);
    }
}
