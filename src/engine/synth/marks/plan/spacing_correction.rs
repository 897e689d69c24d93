//! Spacing correction: the initial distances of spots and lines with which the final ones are those asked for.
//!
//! Spots move from their first places by only a per cent of the spacing, so the spacing can be measured before anything has grown:
//! the nuclei are placed, measured as `docs/format.md` defines *spacing*, and placed again. The crests of lines are treated
//! likewise. The training rows contain how patterns differ from the distance of their system, so that the distances of the first
//! places are compared with the looked-up ones.

use crate::attributes::{Attributes, Stripes};
use crate::marks::Ellipse;
use crate::measure::{Spot, Target, spot_errors, stripe_errors};
use crate::rd::{ParameterField, initial_marks, nuclei};
use crate::synth::marks::plan::laid_out::Plan;
use crate::synth::marks::plan::layer_lookup::Lookup;

/// Rounds of correction. A third one changes less than the noise of a dozen spots.
const ROUNDS: usize = 2;
/// Range of the pitch ÷ the system's own: beyond it spots vanish or split (`pitch` 0.8 and 1.3 were tried).
const PITCHES: [f64; 2] = [0.88, 1.2];
/// With more nuclei one round is enough: with 150 and more the error after the first is half a per cent.
const SEVERAL: usize = 300;
/// With more nuclei the law alone gives the spacing to a per cent.
const MANY: usize = 20_000;

/// Rounds of correction for this number of nuclei.
#[must_use]
pub fn corrections(nuclei: usize) -> usize {
    match nuclei {
        ..SEVERAL => ROUNDS,
        SEVERAL..=MANY => 1,
        _ => 0,
    }
}

/// Factors of the system's own pitch, by region, with which the final distances of marks are those asked for.
#[must_use]
pub fn pitches(plan: &Plan, seed: u64) -> Vec<f64> {
    let Lookup { system, map, .. } = &plan.lookup;
    let mut pitch = vec![1.0; map.layout().len()];
    // Lines along curves have the distances of the curves, marks at given places those of the places, and other stripes the
    // wavelength of their system.
    let is_given = plan.curves().is_some() || plan.places().is_some();
    if is_given || system.is_striped() && !system.description().free_spacing {
        return pitch;
    }
    let maps = &plan.unpitched_maps();
    if system.is_striped() {
        for _ in 0..ROUNDS {
            let errors = wavelength_errors(plan, maps, &pitch, seed);
            for (pitch, error) in pitch.iter_mut().zip(errors) {
                *pitch = corrected(*pitch, error);
            }
        }
        return pitch;
    }
    let mut round = 0;
    loop {
        let points = nuclei(*system, &plan.lookup.repitched(maps, &pitch), seed, &[]).inside;
        let rounds = corrections(points.len());
        if rounds == 0 {
            return pitch;
        }
        let spots = spots_at(plan, &points);
        for (pitch, found) in pitch.iter_mut().zip(plan.on_canvas(|target| spot_errors(&spots, target))) {
            *pitch = corrected(*pitch, found.spacing);
        }
        round += 1;
        if round >= rounds {
            return pitch;
        }
    }
}

/// Excess of the initial distance of lines over the system's own distance (got ÷ own − 1), by region.
fn wavelength_errors(plan: &Plan, maps: &ParameterField, pitch: &[f64], seed: u64) -> Vec<Option<f64>> {
    // Without the obstacles, since only distances are measured here.
    let maps = ParameterField { obstacles: Vec::new(), ..plan.lookup.repitched(maps, pitch).into_owned() };
    let crests = initial_marks(plan.lookup.system, &maps, seed);
    plan.on_canvas(|target| {
        let own = |point: [f64; 2]| {
            let wavelength = plan.lookup.system.spacing(&plan.lookup.lattice.at(point).parameters(1.0))
                * plan.lookup.px_a_cell();
            Attributes::Stripes(Stripes { width: 1.0, angle: 0.0, wavelength: Some(wavelength) })
        };
        let target = Target { wanted: &own, covered: &|_| false, ..*target };
        stripe_errors(&crests, 0.5, &target).iter().map(|error| error.wavelength).collect()
    })
}

/// The pitch that compensates for this error of the spacing (got ÷ wanted − 1).
#[must_use]
pub fn corrected(pitch: f64, error: Option<f64>) -> f64 {
    error.map_or(pitch, |error| (pitch / (1.0 + error)).clamp(PITCHES[0], PITCHES[1]))
}

/// Spots at these places (cells), to measure distances; sizes and shapes do not matter.
#[must_use]
pub fn spots_at(plan: &Plan, places: &[[f64; 2]]) -> Vec<Spot> {
    let spot = |center: [f64; 2]| {
        let ellipse = Ellipse::from_area(center, 1.0, 1.0, 0.0);
        Spot { ellipse, whole: true, endless: false, contour: 0.0, fill: 1.0, peak: 1.0 }
    };
    plan.lookup.all_to_px(places).into_iter().map(spot).collect()
}
