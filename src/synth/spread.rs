//! How far apart spots begin, so that they end as far apart as asked.
//!
//! Spots keep the places they begin at but for a per cent of the spacing, so the spacing can be measured before
//! anything has grown: the nuclei are laid, measured by the contract's rule, and laid again.

use super::plan::Plan;
use crate::marks::Ellipse;
use crate::measure::{Spot, spot_errors};
use crate::rd::{System, nuclei};

/// Rounds of laying nuclei before they are laid to stay; a third changes nothing that the noise of a dozen spots would
/// not hide.
const ROUNDS: usize = 2;
/// How far the pitch may leave the system's own: beyond it spots die or split (`pitch` 0.8 and 1.3 were tried).
const PITCHES: [f64; 2] = [0.88, 1.2];
/// Nuclei above which regions are so full that the law alone meets the spacing to a per cent.
const MANY: usize = 20_000;

/// What the system's own pitch is multiplied by, by region.
#[must_use]
pub fn pitches(plan: &Plan, seed: u64) -> Vec<f64> {
    let layout = plan.map.layout();
    let mut pitch = vec![1.0; layout.len()];
    if plan.system == System::MeinhardtStripes {
        return pitch;
    }
    for _ in 0..ROUNDS {
        let points = nuclei(plan.system, &plan.maps(&pitch), layout.edges, seed);
        if points.len() > MANY {
            break;
        }
        let spots: Vec<Spot> =
            points.iter().map(|at| spot([at[0] * plan.cell[0], at[1] * plan.cell[1]])).collect();
        for (pitch, found) in pitch.iter_mut().zip(plan.on_canvas(|canvas| spot_errors(&spots, canvas))) {
            if let Some(error) = found.spacing {
                *pitch = (*pitch / (1.0 + error)).clamp(PITCHES[0], PITCHES[1]);
            }
        }
    }
    pitch
}

/// A spot of which only the place counts.
fn spot(center: [f64; 2]) -> Spot {
    let ellipse = Ellipse::of(center, 1.0, 1.0, 0.0);
    Spot { ellipse, whole: true, endless: false, contour: 0.0, fill: 1.0, peak: 1.0 }
}
