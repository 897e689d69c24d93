//! The system of a layer whose `system` is `"auto"`.

use rayon::prelude::*;

use crate::attributes::AttributeMap;
use crate::attributes::Attributes;
use crate::rd::System;
use crate::synth::plan::answers::Answers;
use crate::synth::plan::error::PlanError;
use crate::synth::plan::lookup::free_spacing;
use crate::synth::training::Training;

/// Spots count as reached where area, spacing and aspect together differ by less than this.
const MET: f64 = 0.05;

/// Regions that are asked about at once.
const AT_ONCE: usize = 64;

/// Lines take a system of stripes; those with a wavelength take one with any wavelength. Ellipses take a system of spots with
/// any spacing, unless it misses what is asked and another one reaches it on the grid on which it would grow, whose cells are
/// `px_a_cell` wide: the answers are those that are needed once the system is chosen.
pub(super) fn choose_system(
    answers: &Answers,
    training: &Training,
    map: &AttributeMap,
    px_a_cell: impl Fn(System) -> f64,
) -> Result<System, PlanError> {
    let spotted = System::ALL.into_iter().filter(|system| !system.is_striped());
    let (free, others): (Vec<_>, Vec<_>) = spotted.partition(|system| system.description().free_spacing);
    let preferred = free[0];
    let mut all: Vec<Attributes> = Vec::with_capacity(map.layout().len());
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
        all.push(wanted);
    }
    for system in free.into_iter().chain(others) {
        if reaches(answers, system, px_a_cell(system), &all)? {
            return Ok(system);
        }
    }
    Ok(preferred)
}

/// Whether `system` reaches `all` these spots, on a grid of `cell` px a cell. Where it misses some, those after them are not asked.
fn reaches(answers: &Answers, system: System, cell: f64, all: &[Attributes]) -> Result<bool, PlanError> {
    let meets = |wanted: &Attributes| {
        let answer = answers.ask(system, wanted, cell)?;
        Ok(distance(wanted, &answer.predicted) <= MET)
    };
    for some in all.chunks(AT_ONCE) {
        if some.par_iter().map(meets).collect::<Result<Vec<bool>, PlanError>>()?.contains(&false) {
            return Ok(false);
        }
    }
    Ok(true)
}

/// How far two sets of spots differ: |Δ ln area| + |Δ ln spacing| + |Δ aspect|.
fn distance(a: &Attributes, b: &Attributes) -> f64 {
    let (Attributes::Spots(a), Attributes::Spots(b)) = (a, b) else { return f64::INFINITY };
    let ln = |x: f64, y: f64| libm::log(x / y).abs();
    let spacing = a.spacing.zip(b.spacing).map_or(0.0, |(a, b)| ln(a, b));
    ln(a.area, b.area) + spacing + (a.aspect - b.aspect).abs()
}
