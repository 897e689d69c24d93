//! Differences between one spot and the mean of its region.

use crate::rd::Parameters;
use crate::synth::marks::plan::lattice::{Node, NodeOffset};
use crate::synth::marks::plan::layer_lookup::Lookup;

/// The difference between a spot and the mean of its region.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviation {
    /// Its area ÷ the mean.
    pub area: f64,
    /// Its direction − the mean, degrees.
    pub turn: f64,
    /// Its aspect − the mean.
    pub aspect: f64,
}

/// The share of its own shape and direction, against those of the surroundings, in the shape of the room of a spot: of 1,160 spots
/// rotated by 10° (aspect 0.4, area/spacing² 0.2) seven merged at 0, none at 0.5, six at 1.
pub const OWN_SHAPE: f64 = 0.6;

/// The change of the parameters for a spot at a place (px) with this deviation.
pub fn deviating(lookup: &Lookup, px: [f64; 2], deviation: &Deviation) -> NodeOffset {
    let node: Node = lookup.lattice.at(px);
    let wanted = lookup.spots_at(px);
    let rounder = libm::log((wanted.aspect + deviation.aspect) / wanted.aspect);
    node.offset(-libm::log(deviation.area), rounder, deviation.turn)
}

/// The parameters of the room of a spot at a place (px) whose parameters differ by `offset`. `pitch` is by region.
pub fn room_of(lookup: &Lookup, px: [f64; 2], pitch: &[f64], [rate, c, s, ratio]: NodeOffset) -> Parameters {
    let room = lookup.lattice.at(px).plus([rate, OWN_SHAPE * c, OWN_SHAPE * s, ratio]);
    room.parameters(lookup.between_regions(pitch, px))
}
