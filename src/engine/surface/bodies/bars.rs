//! Bodies made of round bars, as implicit functions that are negative inside.

use super::curve::curve;

/// Bars between two points of a chain.
const STEPS: usize = 8;

/// A round bar from one point to another, with a radius at each end. In the direction of z it is `flat` times as thick.
#[derive(Clone, Copy, Debug)]
pub struct Bar {
    from: [f64; 3],
    along: [f64; 3],
    /// 1 ÷ the square of the length; 0 for a ball.
    inverse: f64,
    radii: [f64; 2],
    flat: f64,
    middle: [f64; 3],
    /// Distance of the farthest point of the bar from its middle.
    reach: f64,
}

impl Bar {
    pub fn new(from: [f64; 3], to: [f64; 3], radii: [f64; 2], flat: f64) -> Self {
        let along: [f64; 3] = [0, 1, 2].map(|axis| to[axis] - from[axis]);
        let square = dot(along, along);
        let inverse = if square > 0.0 { 1.0 / square } else { 0.0 };
        let middle = [0, 1, 2].map(|axis| from[axis] + 0.5 * along[axis]);
        let reach = 0.5 * square.sqrt() + radii[0].max(radii[1]) * flat.max(1.0);
        Self { from, along, inverse, radii, flat, middle, reach }
    }

    /// Approximate distance from its surface; negative inside.
    pub fn distance(&self, place: [f64; 3]) -> f64 {
        let from: [f64; 3] = [0, 1, 2].map(|axis| place[axis] - self.from[axis]);
        let t = (dot(from, self.along) * self.inverse).clamp(0.0, 1.0);
        let mut off: [f64; 3] = [0, 1, 2].map(|axis| from[axis] - t * self.along[axis]);
        off[2] /= self.flat;
        (dot(off, off).sqrt() - (self.radii[0] + t * (self.radii[1] - self.radii[0]))) * self.flat.min(1.0)
    }

    /// Whether its distance may be less than this one.
    pub fn may_be_nearer(&self, place: [f64; 3], than: f64) -> bool {
        let off: [f64; 3] = [0, 1, 2].map(|axis| place[axis] - self.middle[axis]);
        // The computed distance of a flat bar is smaller than the true one by at most its flatness.
        let limit = than.max(0.0) / self.flat.min(1.0) + self.reach;
        dot(off, off) < limit * limit
    }
}

/// Bars that follow each other along a curve.
#[derive(Clone, Debug)]
pub struct Chain {
    bars: Vec<Bar>,
    low: [f64; 3],
    high: [f64; 3],
    /// The width of the fillet at the joint with the chains before it.
    fillet: f64,
}

impl Chain {
    /// A chain through points: x, y, z, radius, and the thickness in the direction of z as a share of the other.
    pub fn new(fillet: f64, points: &[[f64; 5]]) -> Self {
        let curve = curve(points, STEPS);
        let bar = |pair: &[[f64; 5]]| {
            let [[x, y, z, thick, flat], [to_x, to_y, to_z, thin, _]] = [pair[0], pair[1]];
            Bar::new([x, y, z], [to_x, to_y, to_z], [thick, thin], flat)
        };
        let bars: Vec<Bar> = curve.windows(2).map(bar).collect();
        let bound = |sign: f64| {
            let reach = |axis: usize| {
                bars.iter().map(|bar| sign * bar.middle[axis] + bar.reach).fold(f64::MIN, f64::max)
            };
            [0, 1, 2].map(|axis| sign * reach(axis))
        };
        Self { low: bound(-1.0), high: bound(1.0), bars, fillet }
    }

    /// The distance, or `most` if it is greater.
    fn distance(&self, place: [f64; 3], most: f64) -> f64 {
        self.bars.iter().fold(most, |least, bar| {
            if bar.may_be_nearer(place, least) { least.min(bar.distance(place)) } else { least }
        })
    }

    /// The distance of this chain joined with a body at the distance `body`.
    fn joined_with(&self, body: f64, place: [f64; 3]) -> f64 {
        let off =
            [0, 1, 2].map(|axis| (self.low[axis] - place[axis]).max(place[axis] - self.high[axis]).max(0.0));
        // A flat bar's computed distance may be half the true one.
        let far = 2.0 * (body + self.fillet).max(0.0);
        if dot(off, off) > far * far {
            body
        } else {
            joined(body, self.distance(place, body + self.fillet), self.fillet)
        }
    }
}

/// Approximate distance from chains that are joined in this order; negative inside.
pub fn distance(chains: &[Chain], place: [f64; 3]) -> f64 {
    chains.iter().fold(FAR, |body, chain| chain.joined_with(body, place))
}

/// Larger than any distance.
const FAR: f64 = 1e9;

/// The distance from the union of two bodies with a fillet of about this width (Quílez's polynomial).
pub fn joined(a: f64, b: f64, fillet: f64) -> f64 {
    let near = (fillet - (a - b).abs()).max(0.0);
    a.min(b) - 0.25 * near * near / fillet
}

pub fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
