//! A place where a spot begins, with the metric of its surroundings.

use super::parameter_field::{ParameterField, Parameters};
use super::selling::Tensor;
use crate::grid::Domain;

/// One point of a domain whose places are `P`, with its local metric. Lengths are in cells.
#[derive(Clone, Copy, Debug)]
pub struct Nucleus<P = [f64; 2]> {
    /// Position.
    pub at: P,
    /// The cell in whose frame the metric is given.
    pub cell: usize,
    /// M = [[xx, xy], [xy, yy]] with ds² = Δᵀ M Δ in units of the pitch.
    pub metric: [f64; 3],
    /// Reach of one pitch in any direction, cells.
    pub reach: f64,
    /// Factor by which spots are laid farther apart than they need: [`Parameters::apart`], ≥ 1.
    pub apart: f64,
}

/// The metric of the most recent parameters: many points have equal parameters.
pub struct Metrics<'a, D: Domain> {
    maps: &'a ParameterField<D>,
    pitch: &'a (dyn Fn(&Parameters) -> f64 + Sync),
    last: Option<(Parameters, Nucleus<D::Place>)>,
}

impl<'a, D: Domain> Metrics<'a, D> {
    /// A cache with no metric yet.
    pub fn new(maps: &'a ParameterField<D>, pitch: &'a (dyn Fn(&Parameters) -> f64 + Sync)) -> Self {
        Self { maps, pitch, last: None }
    }

    /// The point `at` with the metric of the parameters there.
    #[inline]
    pub fn at(&mut self, at: D::Place) -> Nucleus<D::Place> {
        let cell = self.maps.domain.cell_at(at);
        let p = &self.maps.parameters[cell];
        if let Some((same, nucleus)) = &self.last
            && same == p
        {
            return Nucleus { at, cell, ..*nucleus };
        }
        let nucleus = Nucleus::new(p, &self.maps.domain, cell, at, (self.pitch)(p));
        self.last = Some((*p, nucleus));
        nucleus
    }
}

impl<P> Nucleus<P> {
    /// The point `at` with the metric of the parameters there.
    #[must_use]
    pub fn at<D: Domain<Place = P>>(
        maps: &ParameterField<D>,
        at: P,
        pitch: &(dyn Fn(&Parameters) -> f64 + Sync),
    ) -> Self
    where
        P: Copy,
    {
        let cell = maps.domain.cell_at(at);
        let p = &maps.parameters[cell];
        Self::new(p, &maps.domain, cell, at, pitch(p))
    }

    /// The point `at` with the metric of the parameters `p`, whose pitch is `pitch` cells and whose direction is given in
    /// the frame of `cell`.
    #[must_use]
    pub fn new<D: Domain<Place = P>>(p: &Parameters, domain: &D, cell: usize, at: P, pitch: f64) -> Self {
        let stretch = f64::from(p.stretch);
        let t = Tensor::oriented(stretch, 1.0 / stretch, f64::from(p.direction));
        let [wide, high] = domain.units();
        let [cx, cy] = [(wide / high).sqrt(), (high / wide).sqrt()];
        let scale = 1.0 / (pitch * pitch);
        let metric = [t.xx * cx * cx * scale, t.xy * scale, t.yy * cy * cy * scale];
        Self { at, cell, metric, reach: 1.05 * pitch / stretch.sqrt(), apart: p.apart() }
    }

    /// This point with only the room that its own spot needs, even if spots are placed farther apart.
    #[must_use]
    pub fn alone(self) -> Self {
        let metric = self.metric.map(|part| part * self.apart * self.apart);
        Self { metric, reach: self.reach / self.apart, apart: 1.0, ..self }
    }

    /// Length of one cell along the shortest displacement to a wall, in pitches of the room that its own spot needs. `inward` is the
    /// unit vector away from the wall.
    #[must_use]
    pub fn pitches_to_wall(&self, inward: [f64; 2]) -> f64 {
        let ([xx, xy, yy], [x, y]) = (self.metric, inward);
        let along = xx * y * y - 2.0 * xy * x * y + yy * x * x;
        self.apart * ((xx * yy - xy * xy) / along).sqrt()
    }

    /// The shortest and the longest distance, pitches, of a point `away` cells from here, over all directions.
    #[must_use]
    pub fn bounds(&self, away: f64) -> [f64; 2] {
        let [xx, xy, yy] = self.metric;
        let (mean, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
        let apart = (half * half + xy * xy).sqrt();
        [(mean - apart).max(0.0).sqrt() * away, (mean + apart).sqrt() * away]
    }

    /// Largest distance, cells, of points of reach `longest` or less that are within `pitches` by the mean of both metrics.
    ///
    /// In a metric of reach r a displacement of length l is l ÷ r pitches or more: a mean of squares below `pitches`² bounds l.
    #[must_use]
    pub fn reach_among(&self, longest: f64, pitches: f64) -> f64 {
        let [own, others] = [self.reach, longest].map(|reach| 1.0 / (reach * reach));
        (2.0 / (own + others)).sqrt().min(1.5 * self.reach) * pitches
    }

    /// Squared distance of a point at `delta` cells from here, in pitches.
    #[inline]
    #[must_use]
    pub fn distance2(&self, [x, y]: [f64; 2]) -> f64 {
        let [xx, xy, yy] = self.metric;
        xx * x * x + 2.0 * xy * x * y + yy * y * y
    }
}
