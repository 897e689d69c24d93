//! A place where a spot begins, with the metric of its surroundings.

use super::maps::{Maps, Parameters};
use super::selling::Tensor;

/// One point, in cells, with its local metric.
#[derive(Clone, Copy, Debug)]
pub struct Nucleus {
    /// Position, cells.
    pub at: [f64; 2],
    /// M = [[xx, xy], [xy, yy]] with ds² = Δᵀ M Δ in units of the pitch.
    pub metric: [f64; 3],
    /// Reach of one pitch in any direction, cells.
    pub reach: f64,
    /// See [`Parameters::apart`].
    pub apart: f64,
}

impl Nucleus {
    /// The point `at`, cells, with the metric of the parameters there.
    #[must_use]
    pub fn at(maps: &Maps, at: [f64; 2], pitch: &(dyn Fn(&Parameters) -> f64 + Sync)) -> Self {
        let p = maps.at(at);
        Self::new(&p, maps.grid.cell, at, pitch(&p))
    }

    /// The point `at`, cells, with the metric of the parameters `p`, whose pitch is `pitch` cells.
    #[must_use]
    pub fn new(p: &Parameters, cell: [f64; 2], at: [f64; 2], pitch: f64) -> Self {
        let stretch = f64::from(p.stretch);
        let t = Tensor::oriented(stretch, 1.0 / stretch, f64::from(p.direction));
        let [cx, cy] = [(cell[0] / cell[1]).sqrt(), (cell[1] / cell[0]).sqrt()];
        let scale = 1.0 / (pitch * pitch);
        let metric = [t.xx * cx * cx * scale, t.xy * scale, t.yy * cy * cy * scale];
        Self { at, metric, reach: 1.05 * pitch / stretch.sqrt(), apart: p.apart() }
    }

    /// The same point with only the room that its own spot needs, also where spots are placed farther apart.
    #[must_use]
    pub fn alone(self) -> Self {
        let metric = self.metric.map(|part| part * self.apart * self.apart);
        Self { metric, reach: self.reach / self.apart, apart: 1.0, ..self }
    }

    /// Length of one cell along the shortest way to a wall across this axis, in pitches of the room that its own spot needs.
    #[must_use]
    pub fn pitches_to_wall(&self, axis: usize) -> f64 {
        let [xx, xy, yy] = self.metric;
        self.apart * ((xx * yy - xy * xy) / [yy, xx][axis]).sqrt()
    }

    /// Squared distance of a point at `delta` cells from here, in pitches.
    #[must_use]
    pub fn distance2(&self, [x, y]: [f64; 2]) -> f64 {
        let [xx, xy, yy] = self.metric;
        xx * x * x + 2.0 * xy * x * y + yy * y * y
    }
}
