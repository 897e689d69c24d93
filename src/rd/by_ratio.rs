//! A function of the ratio over many cells, with a cache of one value: neighbours mostly have the same ratio.

/// The last value of a function of the ratio.
pub struct ByRatio {
    law: fn(f32) -> f32,
    ratio: f32,
    value: f32,
}

impl ByRatio {
    /// Nothing computed yet.
    #[must_use]
    pub fn new(law: fn(f32) -> f32) -> Self {
        Self { law, ratio: f32::NAN, value: 0.0 }
    }

    /// The value at `ratio`.
    pub fn at(&mut self, ratio: f32) -> f32 {
        if ratio != self.ratio {
            (self.ratio, self.value) = (ratio, (self.law)(ratio));
        }
        self.value
    }
}
