//! A growth at one moment.

use crate::synth::grow::engine::Engine;
use crate::synth::grow::layer::GrownLayer;
use crate::synth::plan::Plan;

/// A document at one moment of its growth.
pub struct Snapshot<'a> {
    /// The layers that have grown.
    pub beneath: &'a [GrownLayer],
    /// The plan of the layer that grows on top of them.
    pub plan: &'a Plan,
    /// Its growth.
    pub engine: &'a Engine,
}
