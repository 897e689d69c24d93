//! The system of a layer whose `system` is `"auto"`.

use rayon::prelude::*;

use crate::attributes::{AttributeMap, Attributes, Polarity};
use crate::document::SystemChoice;
use crate::rd::System;
use crate::synth::error::PlanError;
use crate::synth::marks::plan::answers::Answers;
use crate::synth::marks::plan::free_spacing;
use crate::synth::marks::plan::layer_grid::{finest_cell, grid_of};
use crate::synth::training::Training;

/// Spots count as reached if the sum of the errors of ln area, ln spacing and aspect is below this.
const MET: f64 = 0.05;

/// Regions that are looked up together.
const AT_ONCE: usize = 64;

/// Lines get a system of stripes; if a wavelength is given, one that grows any wavelength. Ellipses get a system of spots with any
/// spacing, unless it cannot reach the attributes and another one can. The attributes are looked up on the grid on which that
/// system would grow, so that these answers are used again once the system is chosen.
pub(super) fn choose_system(
    answers: &Answers,
    training: &Training,
    map: &AttributeMap,
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
                let has_duty = stripes.wavelength.is_some();
                return Ok(SystemChoice::system_of_stripes(has_duty).unwrap_or(preferred));
            }
        };
        if spots.spacing.is_none() {
            spots.spacing = Some(free_spacing(training, preferred, spots));
        }
        all.push(wanted);
    }
    for system in free.into_iter().chain(others) {
        let cell = grid_of(map, finest_cell((system, Polarity::Positive), map)).px_a_cell();
        if reaches(answers, system, cell, &all)? {
            return Ok(system);
        }
    }
    Ok(preferred)
}

/// Whether `system` reaches `all` spots, on a grid of `cell` px a cell. After the first miss the others are not looked up.
fn reaches(answers: &Answers, system: System, cell: f64, all: &[Attributes]) -> Result<bool, PlanError> {
    let meets = |wanted: &Attributes| {
        let asked = answers.ask(system, wanted, cell)?;
        Ok(distance(wanted, &asked.predict().predicted) <= MET)
    };
    for some in all.chunks(AT_ONCE) {
        if some.par_iter().map(meets).collect::<Result<Vec<bool>, PlanError>>()?.contains(&false) {
            return Ok(false);
        }
    }
    Ok(true)
}

/// Distance of two sets of spots: |Δ ln area| + |Δ ln spacing| + |Δ aspect|.
fn distance(a: &Attributes, b: &Attributes) -> f64 {
    let (Attributes::Spots(a), Attributes::Spots(b)) = (a, b) else { return f64::INFINITY };
    let ln = |x: f64, y: f64| libm::log(x / y).abs();
    let spacing = a.spacing.zip(b.spacing).map_or(0.0, |(a, b)| ln(a, b));
    ln(a.area, b.area) + spacing + (a.aspect - b.aspect).abs()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;
    use crate::marks::{Ellipse, Mark};

    #[test]
    fn the_answers_for_choosing_a_system_are_used_again_for_growing_it() {
        // Three sizes, so that the grid is finer than two of them need.
        let marks: Vec<Mark> = (0..3)
            .flat_map(|region| {
                let area = 60.0 + 30.0 * f64::from(region);
                [0.0, (area / 0.11).sqrt()].map(|right| {
                    let center = [15.0 + right + 64.0 * f64::from(region), 30.0];
                    Mark::Ellipse(Ellipse::from_area(center, area, 0.7, 20.0))
                })
            })
            .collect();
        let map =
            AttributeMap::from_marks(&marks, [192.0, 64.0], Some([3, 1]), Edges::Closed).expect("a map");
        let training = Training::built_in();
        let answers = Answers::new(training);
        let system = choose_system(&answers, training, &map).expect("a system");
        let asked = answers.count();
        assert_eq!((system, asked), (System::MEINHARDT_SPOTS, 3));
        let cell = grid_of(&map, finest_cell((system, Polarity::Positive), &map)).px_a_cell();
        for wanted in map.of_regions() {
            answers.ask(system, &wanted, cell).expect("an answer");
        }
        assert_eq!(answers.count(), asked);
    }
}
