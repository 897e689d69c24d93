//! A function of the ratio over many cells that caches its last value: neighbours mostly have equal ratios.

/// The last value of a function of the ratio.
pub struct ByRatio<F> {
    law: F,
    ratio: f32,
    value: f32,
}

impl<F: Fn(f32) -> f32> ByRatio<F> {
    /// A cache with no value yet.
    #[must_use]
    pub fn new(law: F) -> Self {
        Self { law, ratio: f32::NAN, value: 0.0 }
    }

    /// The value at `ratio`.
    #[inline]
    pub fn at(&mut self, ratio: f32) -> f32 {
        if ratio != self.ratio {
            (self.ratio, self.value) = (ratio, (self.law)(ratio));
        }
        self.value
    }
}
