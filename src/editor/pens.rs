//! What distinguishes a pen from other pointers: its pressure, and its barrel button.

use serde::{Deserialize, Serialize};

/// How pens are used.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Pens {
    /// Whether pressure sets the width of lines and the size of clicked ellipses.
    pub pressure: bool,
    /// Whether a drag with the barrel button, which systems report as the secondary one, erases instead of moving the view.
    pub erases: bool,
}

impl Default for Pens {
    fn default() -> Self {
        Self { pressure: true, erases: false }
    }
}

/// The pressure during a stroke.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pressure {
    sum: f64,
    count: f64,
}

impl Pressure {
    /// Adds the pressure at a point of the stroke, 0..1.
    pub fn add(&mut self, force: f32) {
        if force.is_finite() {
            self.sum += f64::from(force.clamp(0.0, 1.0));
            self.count += 1.0;
        }
    }

    /// The factor for widths and radii: ½ without pressure, 1 at half of the full pressure, at most 2. It is 1 where no
    /// pressure is known, for example for a mouse or a finger.
    #[must_use]
    pub fn factor(&self) -> f64 {
        if self.count == 0.0 { 1.0 } else { libm::exp2(2.0 * self.sum / self.count - 1.0) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_the_pressure_keeps_the_width_and_more_widens_it() {
        let factor = |forces: &[f32]| {
            let mut pressure = Pressure::default();
            forces.iter().for_each(|force| pressure.add(*force));
            pressure.factor()
        };
        assert_eq!(factor(&[]), 1.0, "a mouse has none");
        assert_eq!(factor(&[f32::NAN]), 1.0);
        assert_eq!(factor(&[0.5, 0.5]), 1.0);
        assert_eq!((factor(&[0.0]), factor(&[1.0, 7.0])), (0.5, 2.0));
        assert!(factor(&[0.8, 0.9]) > 1.5 && factor(&[0.1, 0.2]) < 0.7);
    }
}
