//! Checks a plan: each quantity with its unit and its range.

use dapple_engine::rd::{SweepQuantity, System};
use dapple_engine::synth::ProbePatch;

use crate::allowed::{check_values, same_unit, within};
use crate::pairs;
use crate::plan::{MOST_RUNS, Plan, Range, Set};
use crate::swept::Swept;

/// Largest side of a patch, cells: larger patches would take hours and gigabytes.
const MOST_CELLS: usize = 4096;
/// Range of the number of spots, or wavelengths, of a patch. Means over fewer are too uncertain.
const GROWN: [f64; 2] = [6.0, 10_000.0];
/// Largest seed of a plan: every JSON parser represents it exactly.
const MOST_SEED: u64 = 1 << 53;

/// Checks that this plan can be run.
pub fn check(plan: &Plan) -> Result<(), String> {
    if plan.sets.is_empty() {
        return Err("the plan has no sets".to_owned());
    }
    for (number, set) in plan.sets.iter().enumerate() {
        check_set(set).map_err(|problem| format!("set '{}', {problem}", set.name))?;
        for before in &plan.sets[..number] {
            if before.name == set.name {
                return Err(format!("two sets are called '{}'", set.name));
            }
            if before.seed < set.seed + set.runs && set.seed < before.seed + before.runs {
                return Err(format!(
                    "set '{}', seed: the seeds {} to {} are also those of '{}', {} to {}; keep the seeds of two sets apart",
                    set.name,
                    set.seed,
                    set.seed + set.runs - 1,
                    before.name,
                    before.seed,
                    before.seed + before.runs - 1
                ));
            }
        }
    }
    Ok(())
}

fn check_set(set: &Set) -> Result<(), String> {
    let system = set.system.name();
    let more = set.name.strip_prefix(system);
    let plain = set.name.bytes().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == b'-');
    if !plain || !more.is_some_and(|more| more.is_empty() || more.starts_with('-')) {
        return Err(format!(
            "name: a set of {system} is called {system} or {system}-MORE, in small letters, digits and hyphens"
        ));
    }
    within("runs", set.runs as f64, [1.0, MOST_RUNS as f64])?;
    if set.seed > MOST_SEED - MOST_RUNS {
        return Err(format!("seed: {} is more than {}", set.seed, MOST_SEED - MOST_RUNS));
    }
    let system = match set.system {
        Swept::System(system) => system,
        Swept::Pairs(_) => return pairs::check(set),
    };
    let unit = if system.is_striped() { "wavelengths" } else { "spots" };
    same_unit("patch", &set.patch.unit, unit)?;
    within("patch.grown", set.patch.grown, GROWN)?;
    within("patch.least", set.patch.least, [1.0, set.patch.grown])?;
    check_sweep(set, system)?;
    let side = largest_side(set, system);
    if side > MOST_CELLS {
        return Err(format!(
            "patch: its largest runs take {side} cells along a side, at most {MOST_CELLS} can be; lower patch.grown, the size or the ratio"
        ));
    }
    Ok(())
}

fn check_sweep(set: &Set, system: System) -> Result<(), String> {
    let quantities = system.definition().sweep;
    let names: Vec<&str> = quantities.iter().map(|quantity| quantity.name).collect();
    let s = &set.sweep;
    let given = [
        ("area", s.area.as_ref()),
        ("width", s.width.as_ref()),
        ("ratio", s.ratio.as_ref()),
        ("level", s.level.as_ref()),
        ("stretch", s.stretch.as_ref()),
        ("direction", s.direction.as_ref()),
        ("directions", s.directions.as_ref()),
        ("duty", s.duty.as_ref()),
        ("others", s.others.as_ref()),
        ("unequal", s.unequal.as_ref()),
        ("between", s.between.as_ref()),
        ("long", s.long.as_ref()),
        ("decay", s.decay.as_ref()),
        ("sparse", s.sparse.as_ref()),
        ("aspect", s.aspect.as_ref()),
    ];
    for (name, range) in given {
        let key = format!("sweep.{name}");
        match (quantities.iter().find(|quantity| quantity.name == name), range) {
            (Some(quantity), Some(range)) => check_range(&key, quantity, range)?,
            (Some(_), None) => {
                return Err(format!("{key}: it is missing; {} needs {}", system.name(), names.join(", ")));
            }
            (None, Some(_)) => {
                return Err(format!("{key}: {} has no {name}; it has {}", system.name(), names.join(", ")));
            }
            (None, None) => {}
        }
    }
    let both = s.ratio.as_ref().is_some_and(Range::varies) && s.level.as_ref().is_some_and(Range::varies);
    for (name, range) in given {
        let share = range.and_then(|range| range.share);
        match share {
            Some(_) if name != "level" || !both => {
                return Err(format!(
                    "sweep.{name}.share: only of a level that varies where the ratio varies too"
                ));
            }
            Some(share) => within("sweep.level.share", share, [0.0, 1.0])?,
            None if name == "level" && both => {
                return Err("sweep.level.share: it is missing; where both vary, it says in which share of the runs the level does (with the ratio at its lowest)".to_owned());
            }
            None => {}
        }
    }
    Ok(())
}

fn check_range(key: &str, quantity: &SweepQuantity, range: &Range) -> Result<(), String> {
    same_unit(key, &range.unit, quantity.unit)?;
    check_values(key, quantity.allowed, range)
}

/// Cells along the side of the largest patch of a set.
fn largest_side(set: &Set, system: System) -> usize {
    let corners = [[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let side = |[size, packing]: [f64; 2]| {
        let parameters = set.parameters_at([size, packing, 1.0, 0.0]);
        ProbePatch { system, parameters, extent: set.patch.grown, seed: 0 }.side()
    };
    corners.into_iter().map(side).max().unwrap_or(0)
}
