//! Colours → pattern values.

use std::collections::HashMap;

use super::Gradient;

/// Pattern values whose colours are compared.
const STEPS: u16 = 1024;
/// A picture with more colours has not been painted with one gradient.
const COLOURS: usize = 1 << 14;
/// Largest mean distance of the px from the colours of the gradient, of 255.
const DISTANCE: f64 = 4.0;

impl Gradient {
    /// The pattern values whose colours are nearest to those of a picture (red, green, blue for each px); of several equal colours
    /// the middle one. `None` if the picture has many other colours than the gradient.
    #[must_use]
    pub fn pattern_of(&self, rgb: &[u8]) -> Option<Vec<f32>> {
        let mut tones: Vec<(f32, [u8; 3])> = Vec::new();
        let value = |step: u16| f32::from(step) / f32::from(STEPS);
        let colours = self.colours((0..=STEPS).map(value));
        let mut first = 0;
        for (step, colour) in colours.iter().enumerate() {
            if colours.get(step + 1) != Some(colour) {
                tones.push((0.5 * (value(first as u16) + value(step as u16)), *colour));
                first = step + 1;
            }
        }
        let mut known: HashMap<[u8; 3], (f32, f64)> = HashMap::new();
        let mut off = 0.0;
        let mut values = Vec::with_capacity(rgb.len() / 3);
        for px in rgb.chunks_exact(3) {
            let px = [px[0], px[1], px[2]];
            let (value, distance) = *known.entry(px).or_insert_with(|| nearest(&tones, px));
            if known.len() > COLOURS {
                return None;
            }
            off += distance;
            values.push(value);
        }
        (off <= DISTANCE * values.len() as f64).then_some(values)
    }
}

/// The value of the nearest colour, and its distance.
fn nearest(tones: &[(f32, [u8; 3])], px: [u8; 3]) -> (f32, f64) {
    let distance = |colour: &[u8; 3]| -> i32 {
        colour.iter().zip(px).map(|(a, b)| (i32::from(*a) - i32::from(b)).pow(2)).sum()
    };
    let each = tones.iter().map(|(value, colour)| (*value, distance(colour)));
    let (value, distance) = each.min_by_key(|(_, distance)| *distance).unwrap_or((0.0, 0));
    (value, f64::from(distance).sqrt())
}

#[cfg(test)]
mod tests {
    use super::super::{BY_LAYER, Bend, Stop};
    use super::*;

    #[test]
    fn painted_values_are_found_again() {
        // Three tones; the middle one is at the edge of the marks.
        let stops = [(0.0, [176, 128, 73]), (0.5, [217, 176, 116]), (1.0, [253, 236, 203])];
        let stops = stops.map(|(at, colour)| Stop::opaque(at, colour)).to_vec();
        let ripples = Gradient { stops, bends: vec![Bend([0.3, 0.0, 0.7, 1.0]); 2] };
        for gradient in [BY_LAYER[0].gradient(), ripples] {
            let painted = [0.0, 0.45, 0.5, 0.55, 0.8, 1.0];
            let found = gradient.pattern_of(&gradient.colours(painted).concat()).unwrap();
            for (painted, found) in painted.iter().zip(found) {
                assert!((painted - found).abs() < 0.04, "{painted} {found}");
            }
        }
    }

    #[test]
    fn a_picture_in_other_colours_is_not_of_the_gradient() {
        let gradient = BY_LAYER[0].gradient();
        assert_eq!(gradient.pattern_of(&[20, 200, 90, 90, 20, 200]), None);
    }
}
