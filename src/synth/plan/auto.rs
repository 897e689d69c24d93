//! The system that `"auto"` takes.

use crate::attributes::regions::RegionMap;
use crate::attributes::{Attributes, Stripes};
use crate::rd::System;
use crate::synth::plan::error::PlanError;
use crate::synth::plan::lookup::{ask, cell_for, free_spacing};
use crate::synth::training::Training;

/// What is asked counts as met where area, spacing and aspect together are nearer than this.
const MET: f64 = 0.05;

/// Lines want stripes, thin ones on wide ground [`System::MeinhardtLines`]; ellipses want Meinhardt's system, whose spots
/// are rounder and stand as far apart as asked, unless Turing's meets what is asked and Meinhardt's does not.
pub(super) fn choose_system(training: &Training, map: &RegionMap) -> Result<System, PlanError> {
    let mut miss = [0.0f64; 2];
    for (place, _) in map.regions() {
        let mut wanted = map.at(map.layout().center(place));
        let spots = match &mut wanted {
            Attributes::Spots(spots) => spots,
            Attributes::Stripes(Stripes { wavelength: None, .. }) => return Ok(System::MeinhardtStripes),
            Attributes::Stripes(_) => return Ok(System::MeinhardtLines),
        };
        if spots.spacing.is_none() {
            spots.spacing = Some(free_spacing(training, System::MeinhardtSpots, spots));
        }
        let cell = cell_for(&wanted);
        for (worst, system) in miss.iter_mut().zip([System::MeinhardtSpots, System::TuringSpots]) {
            let answer = ask(training, system, &wanted, cell)?;
            *worst = worst.max(distance(&wanted, &answer.predicted));
        }
    }
    let [meinhardt, turing] = miss;
    Ok(if turing < MET && MET < meinhardt { System::TuringSpots } else { System::MeinhardtSpots })
}

/// How far two sets of spots differ: |Δ ln area| + |Δ ln spacing| + |Δ aspect|.
fn distance(a: &Attributes, b: &Attributes) -> f64 {
    let (Attributes::Spots(a), Attributes::Spots(b)) = (a, b) else { return f64::INFINITY };
    let ln = |x: f64, y: f64| libm::log(x / y).abs();
    let spacing = a.spacing.zip(b.spacing).map_or(0.0, |(a, b)| ln(a, b));
    ln(a.area, b.area) + spacing + (a.aspect - b.aspect).abs()
}
