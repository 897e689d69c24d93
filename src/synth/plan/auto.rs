//! The system of a layer whose `system` is `"auto"`.

use crate::attributes::AttributeMap;
use crate::attributes::Attributes;
use crate::rd::System;
use crate::synth::plan::error::PlanError;
use crate::synth::plan::lookup::{ask, cell_for, free_spacing};
use crate::synth::training::Training;

/// Spots count as reached where area, spacing and aspect together differ by less than this.
const MET: f64 = 0.05;

/// Lines take a system of stripes; those with a wavelength take one with any wavelength. Ellipses take a system of spots with
/// any spacing, unless it misses what is asked and another one reaches it.
pub(super) fn choose_system(training: &Training, map: &AttributeMap) -> Result<System, PlanError> {
    let spotted = System::ALL.into_iter().filter(|system| !system.is_striped());
    let (free, others): (Vec<_>, Vec<_>) = spotted.partition(|system| system.description().free_spacing);
    let candidates: Vec<System> = free.into_iter().chain(others).collect();
    let preferred = candidates[0];
    let mut misses = vec![0.0f64; candidates.len()];
    for (place, _) in map.regions() {
        let mut wanted = map.of_region(place);
        let spots = match &mut wanted {
            Attributes::Spots(spots) => spots,
            Attributes::Stripes(stripes) => {
                let free = stripes.wavelength.is_some();
                let fitting = System::first(|system| system.is_striped() && system.free_spacing == free);
                return Ok(fitting.unwrap_or(preferred));
            }
        };
        if spots.spacing.is_none() {
            spots.spacing = Some(free_spacing(training, preferred, spots));
        }
        let cell = cell_for(preferred, &wanted);
        for (worst, system) in misses.iter_mut().zip(&candidates) {
            let answer = ask(training, *system, &wanted, cell)?;
            *worst = worst.max(distance(&wanted, &answer.predicted));
        }
    }
    if misses[0] <= MET {
        return Ok(preferred);
    }
    let other = candidates.iter().zip(&misses).find(|(_, miss)| **miss < MET);
    Ok(other.map_or(preferred, |(system, _)| *system))
}

/// How far two sets of spots differ: |Δ ln area| + |Δ ln spacing| + |Δ aspect|.
fn distance(a: &Attributes, b: &Attributes) -> f64 {
    let (Attributes::Spots(a), Attributes::Spots(b)) = (a, b) else { return f64::INFINITY };
    let ln = |x: f64, y: f64| libm::log(x / y).abs();
    let spacing = a.spacing.zip(b.spacing).map_or(0.0, |(a, b)| ln(a, b));
    ln(a.area, b.area) + spacing + (a.aspect - b.aspect).abs()
}
