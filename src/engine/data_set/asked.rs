//! What the sketch asks for at each place: fields of size and direction.

use crate::attributes::{Attribute, AttributeMap, Attributes};
use crate::grid::{Edges, Field};
use crate::marks::axial;

/// px from one node to the next; between them fields are interpolated.
const NODE: usize = 8;

/// What the sketch asks for at each px.
pub struct AskedFields {
    /// The area of spots, px², or the width of stripes, px.
    pub size: Field,
    /// Degrees in [0, 180), from +x towards +y.
    pub direction: Field,
}

impl AskedFields {
    /// The fields of a map on a canvas of `side` px.
    pub(super) fn new(map: &AttributeMap, side: usize) -> Self {
        let nodes = side.div_ceil(NODE) + 1;
        let wanted: Vec<Attributes> = (0..nodes * nodes)
            .map(|node| map.at([node % nodes, node / nodes].map(|along| (along * NODE).min(side) as f64)))
            .collect();
        let sizes: Vec<f64> = wanted.iter().map(|at| libm::log(size(at))).collect();
        let vectors: Vec<[f64; 2]> = wanted
            .iter()
            .map(|at| {
                let (s, c) = libm::sincos((2.0 * at.angle()).to_radians());
                [c, s]
            })
            .collect();
        let blend = |value: &dyn Fn(usize) -> f64, [x, y]: [f64; 2]| {
            let at = [x, y].map(|along| along / NODE as f64);
            let low = at.map(|along| (along as usize).min(nodes - 2));
            let [u, v] = [0, 1].map(|axis| at[axis] - low[axis] as f64);
            let row = |row: usize| {
                let first = (low[1] + row) * nodes + low[0];
                (1.0 - u) * value(first) + u * value(first + 1)
            };
            (1.0 - v) * row(0) + v * row(1)
        };
        let field = |value: &dyn Fn([f64; 2]) -> f64| {
            Field::from_fn([side, side], [1.0, 1.0], Edges::Closed, |at| value(at) as f32)
        };
        Self {
            size: field(&|at| libm::exp(blend(&|node| sizes[node], at))),
            direction: field(&|at| {
                let [c, s] = [0, 1].map(|part| blend(&|node| vectors[node][part], at));
                axial(0.5 * libm::atan2(s, c).to_degrees())
            }),
        }
    }
}

/// Area or width.
fn size(wanted: &Attributes) -> f64 {
    wanted.get(Attribute::Area).or_else(|| wanted.get(Attribute::Width)).unwrap_or(1.0).max(1e-3)
}
