//! The spacing of spots that is left to their system.

use crate::attributes::{Attributes, Spots};
use crate::rd::System;
use crate::synth::marks::plan::answers::Answers;
use crate::synth::marks::plan::cell_size::{FREE_DENSITY, cell_for};
use crate::synth::training::Training;

/// The spacing of such spots, px, where it is left to the system.
#[must_use]
pub fn free_spacing(training: &Training, system: System, spots: &Spots) -> f64 {
    let free = Attributes::Spots(Spots { spacing: None, ..*spots });
    // Where any spacing can be grown, spots are evenest at the smallest ratio.
    let given = if system.description().free_spacing {
        None
    } else {
        Answers::new(training).ask(system, &free, cell_for(system, &free)).ok()
    };
    match given.map(|asked| asked.predict().predicted) {
        Some(Attributes::Spots(Spots { spacing: Some(spacing), .. })) => spacing,
        _ => (spots.area / FREE_DENSITY).sqrt(),
    }
}
