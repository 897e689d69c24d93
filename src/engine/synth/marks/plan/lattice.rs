//! Parameters between the regions, on a lattice.
//!
//! Attributes are bilinear between region centres, parameters are not: they are looked up on a lattice a few
//! times finer than the regions and interpolated in the coordinates in which the map is near-linear
//! (ln rate, ln ratio, −ln stretch · (cos 2φ, sin 2φ), ln pitch, level).

use rayon::prelude::*;

use crate::attributes::regions::RegionGrid;
use crate::attributes::{AttributeMap, Polarity};
use crate::grid::{atan2, exp, turned};
use crate::rd;
use crate::synth::error::PlanError;
use crate::synth::marks::plan::answers::Ask;
use crate::synth::marks::plan::offset::Offset;
use crate::synth::marks::plan::setting::Setting;

/// Parameters at one node, or between nodes, in coordinates that can be interpolated.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Node {
    /// The logarithm of the rate.
    pub ln_rate: f64,
    /// The logarithm of R.
    pub ln_ratio: f64,
    /// −ln stretch · (cos 2φ, sin 2φ).
    pub shape: [f64; 2],
    /// The logarithm of the pitch.
    pub ln_pitch: f64,
    /// Share of the peak that is the mark's edge.
    pub level: f64,
}

impl Node {
    /// Looked-up parameters; a system without a ratio or a level gets neutral ones.
    #[must_use]
    pub fn from_setting(setting: &Setting) -> Self {
        let p = &setting.parameters;
        let stretch = -libm::log(p.stretch);
        let double = (2.0 * p.direction).to_radians();
        Self {
            ln_rate: libm::log(p.rate),
            ln_ratio: libm::log(p.ratio.unwrap_or(1.0)),
            shape: [stretch * libm::cos(double), stretch * libm::sin(double)],
            ln_pitch: libm::log(setting.pitch),
            level: p.level.unwrap_or(0.5),
        }
    }

    /// The offset for a spot whose rate and stretch are multiplied by e to these powers, and which is rotated by `turn` degrees.
    #[must_use]
    pub fn offset(&self, ln_rate: f64, ln_stretch: f64, turn: f64) -> NodeOffset {
        let [c, s] = self.shape;
        let length = (c * c + s * s).sqrt();
        let double = libm::atan2(s, c) + (2.0 * turn).to_radians();
        let long = (length - ln_stretch).max(0.0);
        [ln_rate, long * libm::cos(double) - c, long * libm::sin(double) - s, 0.0]
    }

    /// The values that are interpolated between spots: ln rate, the two components of the shape, ln ratio; and 1, their weight.
    #[must_use]
    pub fn weighted(&self) -> WeightedNode {
        [self.ln_rate, self.shape[0], self.shape[1], self.ln_ratio, 1.0]
    }

    /// Weighted values in a frame to which directions have these degrees added.
    #[must_use]
    pub fn turned_weighted([ln_rate, c, s, ln_ratio, weight]: &WeightedNode, degrees: f64) -> WeightedNode {
        let [c, s] = turned([*c, *s], 2.0 * degrees);
        [*ln_rate, c, s, *ln_ratio, *weight]
    }

    /// The weighted sum of the nodes of spots, and the `ground` with the weight that is left.
    #[must_use]
    pub fn among([ln_rate, c, s, ln_ratio, weight]: WeightedNode, ground: &Self) -> Self {
        let left = 1.0 - weight;
        Self {
            ln_rate: left * ground.ln_rate + ln_rate,
            ln_ratio: left * ground.ln_ratio + ln_ratio,
            shape: [left * ground.shape[0] + c, left * ground.shape[1] + s],
            ..*ground
        }
    }

    /// R; 1 for a system without a ratio.
    #[must_use]
    pub fn ratio(&self) -> f64 {
        libm::exp(self.ln_ratio)
    }

    /// The [`NodeOffset`] from `other` to this node.
    #[must_use]
    pub fn minus(&self, other: &Self) -> NodeOffset {
        let [c, s] = [0, 1].map(|part| self.shape[part] - other.shape[part]);
        [self.ln_rate - other.ln_rate, c, s, self.ln_ratio - other.ln_ratio]
    }

    /// The node with an offset added.
    #[must_use]
    pub fn plus(&self, [ln_rate, c, s, ln_ratio]: NodeOffset) -> Self {
        let shape = [self.shape[0] + c, self.shape[1] + s];
        Self { ln_rate: self.ln_rate + ln_rate, shape, ln_ratio: self.ln_ratio + ln_ratio, ..*self }
    }

    /// Parameters of the simulation, the pitch multiplied by this factor.
    #[must_use]
    pub fn parameters(&self, pitch: f64) -> rd::Parameters {
        let [c, s] = self.shape;
        rd::Parameters {
            rate: exp(self.ln_rate) as f32,
            ratio: exp(self.ln_ratio) as f32,
            stretch: exp(-(c * c + s * s).sqrt()) as f32,
            direction: (0.5 * atan2(s, c)).to_degrees() as f32,
            pitch: (pitch * exp(self.ln_pitch)) as f32,
        }
    }
}

/// The difference of two nodes: of ln rate, of the two components of the shape, of ln ratio.
pub type NodeOffset = [f64; 4];

/// The values that are interpolated between spots, times a weight, and the weight 0..1.
pub type WeightedNode = [f64; 5];

/// Nodes over the canvas.
#[derive(Clone, Debug)]
pub struct Lattice {
    /// A grid with one cell for each node.
    pub layout: RegionGrid,
    /// The nodes, by index of `layout`.
    pub nodes: Vec<Node>,
}

impl Lattice {
    /// Looks up the lines or spots that `map` wants at every node, with the `offsets` of the regions around it subtracted.
    ///
    /// # Errors
    /// Those of `ask`.
    pub(super) fn looked_up(
        (map, polarity): (&AttributeMap, Polarity),
        cell: f64,
        offsets: &[Offset],
        ask: Ask,
    ) -> Result<Self, PlanError> {
        let layout = map.nodes();
        let node = |index: usize| {
            let point = layout.center(layout.place(index));
            let corners = map.layout().corners(point);
            let offset = corners
                .iter()
                .fold(Offset::default(), |sum, &(region, weight)| sum.plus(weight, offsets[region]));
            let asked = offset.applied(-1.0, &polarity.lines(&map.at(point)));
            Ok(Node::from_setting(&ask(&asked, cell)?.setting()))
        };
        let nodes = (0..layout.len()).into_par_iter().map(node).collect::<Result<Vec<_>, PlanError>>()?;
        Ok(Self { layout, nodes })
    }

    /// Parameters at a point, px.
    #[must_use]
    pub fn at(&self, point: [f64; 2]) -> Node {
        self.between(&self.layout.corners(point))
    }

    /// Parameters between nodes with these weights.
    #[inline]
    #[must_use]
    pub fn between(&self, corners: &[(usize, f64); 4]) -> Node {
        let mut sum = Node::default();
        for &(index, weight) in corners {
            let node = &self.nodes[index];
            sum.ln_rate += weight * node.ln_rate;
            sum.ln_ratio += weight * node.ln_ratio;
            sum.shape[0] += weight * node.shape[0];
            sum.shape[1] += weight * node.shape[1];
            sum.ln_pitch += weight * node.ln_pitch;
            sum.level += weight * node.level;
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_a_spot_its_own_parameters_hold_and_far_from_all_spots_those_of_the_ground() {
        let spot = Node { ln_rate: 2.0, ln_ratio: 3.0, shape: [0.5, -0.5], ln_pitch: 0.7, level: 0.3 };
        let ground = Node { ln_rate: 1.0, ln_ratio: 2.0, shape: [0.0, 0.5], ln_pitch: 0.1, level: 0.5 };
        let among = |weight: f64| Node::among(spot.weighted().map(|value| weight * value), &ground);
        assert_eq!(among(0.0), ground);
        assert_eq!(among(1.0), Node { ln_pitch: 0.1, level: 0.5, ..spot });
        assert_eq!((among(0.5).ln_rate, among(0.5).shape), (1.5, [0.25, 0.0]));
    }

    #[test]
    fn the_shape_turns_with_the_frame_and_the_rest_does_not() {
        let [ln_rate, c, s, ln_ratio, weight] = Node::turned_weighted(&[1.0, 0.4, 0.0, 2.0, 1.0], 45.0);
        assert_eq!([ln_rate, ln_ratio, weight], [1.0, 2.0, 1.0]);
        assert!(c.abs() < 1e-12 && (s - 0.4).abs() < 1e-12, "{c} {s}");
    }
}
