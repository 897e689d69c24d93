//! The effect of a change on what is measured.

use dapple_engine::marks::turn;

/// What was measured on one texture, in the order of the names that were asked for; `None` where it could not be measured.
pub type Measured = Vec<Option<f64>>;

/// The effects of one change on all attributes.
pub struct Effects(pub Vec<Effect>);

/// The effect of one change on one attribute: the mean over the seeds, and its standard error. 1 is the effect on itself that was asked
/// for: a factor of 1.2 ÷ 0.8, or a turn of 36°.
#[derive(Clone, Copy)]
pub struct Effect {
    pub mean: f64,
    pub error: f64,
    /// Seeds with which it was measured.
    pub count: usize,
}

/// The turn between the two values of a direction, degrees.
const TURN: f64 = 36.0;

impl Effects {
    /// `pairs` holds, for each seed, what was measured at the lower and at the higher value.
    pub fn new(names: &[&str], pairs: &[[Measured; 2]]) -> Self {
        let of = |(index, name): (usize, &&str)| {
            let both = pairs.iter().filter_map(|[low, high]| Some((low[index]?, high[index]?)));
            Effect::new(&both.map(|(low, high)| change(name, low, high)).collect::<Vec<f64>>())
        };
        Self(names.iter().enumerate().map(of).collect())
    }
}

/// The change of an attribute, as a share of the one that is asked for.
fn change(name: &str, low: f64, high: f64) -> f64 {
    match name.starts_with("angle") {
        true => turn(high, low) / TURN,
        false => (high / low).ln() / (1.2_f64 / 0.8).ln(),
    }
}

impl Effect {
    fn new(changes: &[f64]) -> Self {
        let count = changes.len();
        let mean = changes.iter().sum::<f64>() / count as f64;
        let variance = changes.iter().map(|change| (change - mean) * (change - mean)).sum::<f64>()
            / count.saturating_sub(1).max(1) as f64;
        Self { mean, error: (variance / count as f64).sqrt(), count }
    }
}
