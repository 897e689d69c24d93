//! Checks a set of pairs: each quantity with its unit and its range.

use super::draw::{QUANTITIES, quantities};
use crate::allowed::{check_values, same_unit, within};
use crate::plan::Set;

/// Range of the number of periods along a side of a patch, and of the cells per period.
const GROWN: [f64; 2] = [6.0, 1_000.0];

/// Checks that this set of a system of pairs can be run.
pub fn check(set: &Set) -> Result<(), String> {
    let unit = if set.system.description().is_striped() { "periods" } else { "cells" };
    same_unit("patch", &set.patch.unit, unit)?;
    within("patch.grown", set.patch.grown, GROWN)?;
    within("patch.least", set.patch.least, [1.0, set.patch.grown])?;
    let names: Vec<&str> = quantities(set).map(|quantity| quantity.name).collect();
    for quantity in &QUANTITIES {
        let (key, name) = (format!("sweep.{}", quantity.name), set.system.name());
        match ((quantity.range)(set), names.contains(&quantity.name)) {
            (Some(range), true) => {
                same_unit(&key, &range.unit, quantity.unit)?;
                check_values(&key, quantity.allowed, range)?;
            }
            (None, true) => return Err(format!("{key}: it is missing; {name} needs {}", names.join(", "))),
            (Some(_), false) => {
                return Err(format!("{key}: {name} has no {}; it has {}", quantity.name, names.join(", ")));
            }
            (None, false) => {}
        }
    }
    let s = &set.sweep;
    let others = [("area", &s.area), ("width", &s.width), ("ratio", &s.ratio), ("stretch", &s.stretch)];
    match others.iter().find(|(_, range)| range.is_some()) {
        Some((key, _)) => {
            Err(format!("sweep.{key}: {} has no {key}; it has {}", set.system.name(), names.join(", ")))
        }
        None => Ok(()),
    }
}
