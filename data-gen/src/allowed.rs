//! Checks of one value, unit or range of a plan.

use crate::plan::{Range, Scale};

/// Checks that a value lies within what is allowed.
pub fn within(key: &str, value: f64, [low, high]: [f64; 2]) -> Result<(), String> {
    if low <= value && value <= high {
        Ok(())
    } else if low == high {
        Err(format!("{key}: {value} is not {low}, the only value that the program grows"))
    } else {
        Err(format!("{key}: {value} is not from {low} to {high}"))
    }
}

/// Checks that a unit is the expected one.
pub fn same_unit(key: &str, unit: &str, expected: &str) -> Result<(), String> {
    if unit == expected { Ok(()) } else { Err(format!("{key}.unit: it is '{expected}', not '{unit}'")) }
}

/// Checks that a range lies within what is `allowed`.
pub fn check_values(key: &str, allowed: [f64; 2], range: &Range) -> Result<(), String> {
    let [low, high] = range.range;
    within(&format!("{key}.range"), low, allowed)?;
    within(&format!("{key}.range"), high, allowed)?;
    if low > high {
        return Err(format!("{key}.range: {low} is more than {high}; the lower number comes first"));
    }
    if range.scale != Scale::Linear && low <= 0.0 {
        return Err(format!("{key}.scale: a log or reciprocal scale cannot begin at {low}"));
    }
    Ok(())
}
