//! Measurement of the agreement of a pattern with the picture that drives it.

use crate::grid::blur::gaussian;
use crate::photo::tone::{directions_of, structure};
use crate::synth::tone::plan::TonePlan;

use crate::grid::{Edges, Field};

/// Blurs after which tones are compared, wavelengths.
pub const BLURS: [f64; 2] = [0.5, 1.0];
/// σ of the structure tensor that gives the directions of the grown pattern, wavelengths.
const SIGMAS: [f64; 2] = [0.12, 0.4];
/// Least coherence of the picture's tensor for directions to be compared.
const COHERENT: f64 = 0.3;

/// Errors against a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct ToneErrors {
    /// The correlation of ink and tone, after blurring both by half a wavelength and by one; `None` for an even tone.
    pub correlation: Option<[f64; 2]>,
    /// Mean absolute difference of ink and tone.
    pub difference: [f64; 2],
    /// The median angle between the lines and the wanted directions, degrees; `None` without wanted directions.
    pub direction: Option<f64>,
}

/// The errors of a pattern whose `ink` is 1 and 0 at the px of the plan's tone, if it has one; `relief` is the relief of the grown
/// pattern.
#[must_use]
pub fn measure(plan: &TonePlan, ink: &[f32], relief: &Field) -> Option<ToneErrors> {
    if plan.tone.is_empty() {
        return None;
    }
    let (size, edges) = (plan.fine, plan.grid.edges);
    let found = BLURS.map(|blur| compared(ink, &plan.tone, size, blur * plan.px_a_wavelength(), edges));
    Some(ToneErrors {
        correlation: found[0].0.zip(found[1].0).map(<[f64; 2]>::from),
        difference: found.map(|(_, difference)| difference),
        direction: turned(plan, relief),
    })
}

/// Correlation and mean absolute difference of two pictures after a blur of `sigma` px.
#[must_use]
pub fn compared(ink: &[f32], tone: &[f32], size: [usize; 2], sigma: f64, edges: Edges) -> (Option<f64>, f64) {
    let [ink, tone] = [ink, tone].map(|values| gaussian(values, size, sigma, edges));
    let count = ink.len().max(1) as f64;
    let mean = |values: &[f32]| values.iter().map(|value| f64::from(*value)).sum::<f64>() / count;
    let (of_ink, of_tone) = (mean(&ink), mean(&tone));
    let (mut both, mut inks, mut tones, mut difference) = (0.0, 0.0, 0.0, 0.0);
    for (ink, tone) in ink.iter().zip(&tone) {
        let (ink, tone) = (f64::from(*ink), f64::from(*tone));
        both += (ink - of_ink) * (tone - of_tone);
        inks += (ink - of_ink) * (ink - of_ink);
        tones += (tone - of_tone) * (tone - of_tone);
        difference += (ink - tone).abs();
    }
    // An even tone has no correlation with ink.
    let varies = inks > 1e-9 * count && tones > 1e-6 * count;
    (varies.then(|| both / (inks * tones).sqrt()), difference / count)
}

/// The median angle between the grown lines and the wanted directions, degrees.
fn turned(plan: &TonePlan, relief: &Field) -> Option<f64> {
    if !plan.directed {
        return None;
    }
    let wavelength = plan.wavelength / plan.px_a_cell();
    let size = [relief.width, relief.height];
    let tensors = structure(&relief.values, size, SIGMAS.map(|sigma| sigma * wavelength), relief.edges);
    let grown = directions_of(&tensors);
    let coherent = plan.directions.iter().zip(&grown).filter(|((_, coherence), _)| *coherence >= COHERENT);
    let mut turns: Vec<f64> =
        coherent.map(|((wanted, _), (got, _))| crate::marks::turn(*got, *wanted).abs()).collect();
    let middle = turns.len() / 2;
    (!turns.is_empty()).then(|| *turns.select_nth_unstable_by(middle, f64::total_cmp).1)
}
