//! Errors in attributes: random targets are looked up, grown and measured.

use super::bounds::bounds;
use super::outcome::{Of, Outcome};
use super::targets::{Target, targets};
use super::way::Way;
use super::{Setting, bar};
use crate::attributes::{Attributes, Stripes};
use crate::cli::Error;
use crate::grid::Field;
use crate::learn::{self, InCells, Method, evenly, summaries};
use crate::measure;
use crate::rd::System;
use crate::synth::marks::plan::{cell_for, free_spacing};
use crate::synth::{ProbePatch, Training};
use rayon::prelude::*;

/// Spots on a patch.
const SPOTS: f64 = 160.0;
/// Wavelengths along the side of a patch of stripes.
const WAVELENGTHS: f64 = 20.0;
/// Rows of the reduced training set.
const FEW: usize = 100;
/// The methods whose parameters are grown.
const WAYS: [Way; 3] = [Way::Learnt(Method::ScaleLaw), Way::REGRESSION, Way::Refined];
/// The most measurements while the level is corrected, and the allowed relative error of the size; both as in `grow`.
const ROUNDS: usize = 5;
const NEAR: f64 = 0.001;
/// Range of the level's correction factor.
const CORRECTIONS: [f64; 2] = [0.6, 1.5];

/// The outcome of each method with few rows and with all rows.
pub fn outcomes(setting: &Setting, system: System) -> Result<Vec<Outcome>, Error> {
    let mut targets = targets(system, setting.targets, setting.seed);
    if !system.is_striped() && !system.description().free_spacing {
        for target in &mut targets {
            if let Attributes::Spots(spots) = &mut target.wanted {
                spots.spacing = Some(free_spacing(setting.training, system, spots));
            }
        }
    }
    let all = setting.training.set(system).map_err(Error::step)?.rows();
    let few = Training::from_rows(system, evenly(all, FEW)).map_err(Error::step)?;
    let sets = [(&few, FEW.min(all.len()), false), (setting.training, all.len(), true)];
    let bar = bar(format!("{}, grown anew", system.name()), sets.len() * targets.len());
    let mut outcomes: Vec<Vec<Outcome>> = vec![Vec::new(); WAYS.len()];
    for (training, rows, all) in sets {
        let regrown = |target: &Target| {
            let regrown = regrown(setting, system, training, target);
            bar.inc(1);
            regrown
        };
        let mut found = targets.par_iter().map(regrown).collect::<Result<Vec<_>, Error>>()?;
        for (way, outcomes) in WAYS.into_iter().zip(&mut outcomes).rev() {
            let of_way: Vec<Found> = found.iter_mut().filter_map(Vec::pop).collect();
            let failed = of_way.iter().filter_map(|found| found.as_ref().err().cloned()).collect();
            let errors = summaries(of_way.into_iter().flatten().flatten());
            let asked = targets.len();
            outcomes.push(Outcome {
                system: system.name(),
                of: Of::Grown,
                way: way.name(),
                bounds: bounds(system, way),
                rows,
                all,
                asked,
                failed,
                errors,
            });
        }
    }
    bar.finish_and_clear();
    Ok(outcomes.into_iter().flatten().collect())
}

/// The errors of a growth for a target; or the target with the reason why it failed.
type Found = Result<Vec<learn::Error>, String>;

/// The result of each method for a target.
fn regrown(
    setting: &Setting,
    system: System,
    training: &Training,
    target: &Target,
) -> Result<Vec<Found>, Error> {
    let cell = cell_for(system, &target.wanted);
    let wanted = InCells::from_px(target.wanted, cell);
    let failed = |why: String| format!("{}: {why}", described(&target.wanted));
    // A patch with the same parameters as the one before is not grown again.
    let mut last: Option<(ProbePatch, Field)> = None;
    let mut found = Vec::with_capacity(WAYS.len());
    for way in WAYS {
        if let Some(why) = way.refusal(training, system, &target.wanted, cell)? {
            found.push(Err(failed(why)));
            continue;
        }
        let parameters =
            way.parameters(training, system, &target.wanted, cell, setting.when, setting.watch)?;
        let extent = if system.is_striped() { WAVELENGTHS } else { SPOTS };
        let patch = ProbePatch { system, parameters, extent, seed: target.seed };
        let marks = match last.take().filter(|(before, _)| *before == patch) {
            Some((_, marks)) => marks,
            None => patch.grow(setting.watch).map_err(|_| Error::Interrupted)?.0,
        };
        let got = match way {
            Way::Refined => levelled(&patch, &marks, &wanted),
            Way::Learnt(_) => measured(&patch, &marks, 1.0),
        };
        found.push(got.map(|got| learn::Error::of_attributes(&got.0, &wanted.0)).map_err(failed));
        last = Some((patch, marks));
    }
    Ok(found)
}

/// The target as text, for example `area 300 px², aspect 0.512, angle 33°, centres 61 px apart`.
fn described(wanted: &Attributes) -> String {
    match wanted {
        Attributes::Spots(spots) => {
            let apart = spots.spacing.map_or(String::new(), |apart| format!(", centres {apart:.1} px apart"));
            format!(
                "area {:.0} px², aspect {:.3}, angle {:.0}°{apart}",
                spots.area, spots.aspect, spots.angle
            )
        }
        Attributes::Stripes(stripes) => format!("width {:.2} px, angle {:.0}°", stripes.width, stripes.angle),
    }
}

/// The attributes on a patch whose level is multiplied by `correction`; or why the patch is not a texture.
fn measured(patch: &ProbePatch, marks: &Field, correction: f64) -> Result<InCells<Attributes>, String> {
    let mut parameters = patch.parameters;
    parameters.level = parameters.level.map(|level| level * correction);
    let attributes =
        ProbePatch { parameters, ..*patch }.measure(marks).map_err(|reason| reason.to_string())?.attributes;
    if let (InCells(Attributes::Stripes(stripes)), true) = (attributes, correction != 1.0) {
        // The edge of these marks is at ½. Their direction does not depend on the level.
        let found = measure::stripes(marks, (0.5 * correction) as f32);
        let width = found.map_or(stripes.width, |found| found.width);
        return Ok(InCells(Attributes::Stripes(Stripes { width, ..stripes })));
    }
    Ok(attributes)
}

/// The attributes on a patch at the level that gives the wanted size; or why the patch is not a texture.
fn levelled(
    patch: &ProbePatch,
    marks: &Field,
    wanted: &InCells<Attributes>,
) -> Result<InCells<Attributes>, String> {
    let off = |got: &InCells<Attributes>| match (&got.0, &wanted.0) {
        (Attributes::Spots(got), Attributes::Spots(wanted)) => libm::log(got.area / wanted.area),
        (Attributes::Stripes(got), Attributes::Stripes(wanted)) => libm::log(got.width / wanted.width),
        _ => 0.0,
    };
    let mut correction = 1.0;
    let mut got = measured(patch, marks, correction)?;
    // The first estimate of d ln size / d ln level is that of a Gaussian bell, or of a sinusoidal stripe
    // (`synth::marks::grow::levelled`).
    let stripes = patch.system.is_striped();
    let mut slope = if stripes { -2.0 / std::f64::consts::PI } else { -1.44 };
    for _ in 1..ROUNDS {
        let before = off(&got);
        if before.abs() < NEAR {
            break;
        }
        let next = (correction * libm::exp(-before / slope)).clamp(CORRECTIONS[0], CORRECTIONS[1]);
        let Ok(moved) = measured(patch, marks, next) else { break };
        let seen = (off(&moved) - before) / libm::log(next / correction);
        if seen.is_finite() {
            slope = seen.clamp(2.0 * slope, 0.5 * slope);
        }
        (correction, got) = (next, moved);
    }
    Ok(got)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::learn::Parameters;
    use crate::synth::Watch;

    #[test]
    fn the_level_gives_the_wanted_area() {
        let parameters =
            Parameters { rate: 3.0, ratio: Some(15.0), stretch: 0.6, direction: 30.0, level: Some(0.5) };
        let patch = ProbePatch { system: System::MEINHARDT_SPOTS, parameters, extent: 16.0, seed: 3 };
        let (marks, _) = patch.grow(&Watch::NONE).unwrap();
        let open = measured(&patch, &marks, 1.0).unwrap();
        let InCells(Attributes::Spots(spots)) = open else { panic!() };
        let wanted = InCells(Attributes::Spots(crate::attributes::Spots { area: 1.1 * spots.area, ..spots }));
        let InCells(Attributes::Spots(got)) = levelled(&patch, &marks, &wanted).unwrap() else { panic!() };
        assert!((got.area / spots.area - 1.1).abs() < 0.0015, "{got:?}");
        assert!((got.spacing.unwrap() / spots.spacing.unwrap() - 1.0).abs() < 0.01);
    }

    #[test]
    fn the_level_gives_the_wanted_width() {
        let parameters = Parameters { rate: 25.0, ratio: None, stretch: 0.5, direction: 30.0, level: None };
        let patch = ProbePatch { system: System::MEINHARDT_STRIPES, parameters, extent: 5.0, seed: 3 };
        let (marks, _) = patch.grow(&Watch::NONE).unwrap();
        let InCells(Attributes::Stripes(open)) = measured(&patch, &marks, 1.0).unwrap() else { panic!() };
        let wanted = InCells(Attributes::Stripes(Stripes { width: 0.95 * open.width, ..open }));
        let InCells(Attributes::Stripes(got)) = levelled(&patch, &marks, &wanted).unwrap() else { panic!() };
        assert!((got.width / open.width - 0.95).abs() < 0.0015, "{got:?}");
        assert_eq!(got.angle, open.angle);
    }
}
