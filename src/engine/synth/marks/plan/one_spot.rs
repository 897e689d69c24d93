//! How one spot differs from the mean of its region.

use crate::rd::Parameters;
use crate::synth::marks::plan::lattice::{Node, NodeOffset};
use crate::synth::marks::plan::layer_lookup::Lookup;

/// How one spot differs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviation {
    /// Its area ÷ the mean.
    pub area: f64,
    /// Its direction − the mean, degrees.
    pub turn: f64,
    /// Its aspect − the mean.
    pub aspect: f64,
}

/// How far the room that a spot takes has its own shape and direction, not those of its surroundings: of 1,160 spots
/// turned by 10° (aspect 0.4, area/spacing² 0.2) seven merged at 0, none at 0.5, six at 1.
const OWN_SHAPE: f64 = 0.6;

/// The change of the parameters of a spot at a place (px) that deviates like this.
pub fn deviating(lookup: &Lookup, px: [f64; 2], deviation: &Deviation) -> NodeOffset {
    let node: Node = lookup.lattice.at(px);
    let wanted = lookup.spots_at(px);
    let rounder = libm::log((wanted.aspect + deviation.aspect) / wanted.aspect);
    node.offset(-libm::log(deviation.area), rounder, deviation.turn)
}

/// The parameters of the room that a spot at a place (px) takes whose parameters differ by `offset`. `pitch` is by region.
pub fn room_of(lookup: &Lookup, px: [f64; 2], pitch: &[f64], [rate, c, s, ratio]: NodeOffset) -> Parameters {
    let room = lookup.lattice.at(px).plus([rate, OWN_SHAPE * c, OWN_SHAPE * s, ratio]);
    room.parameters(lookup.between_regions(pitch, px))
}
