//! Light from the upper left on the heights of a finish.

use rayon::prelude::*;

use super::surfel::{Source, Surfel};

/// The direction to the light, of length 1: left, up, out of the picture.
const LIGHT: [f32; 3] = [-0.5, -0.5, std::f32::consts::FRAC_1_SQRT_2];
/// The least and the greatest factor of the light.
const RANGE: [f32; 2] = [0.35, 1.6];

/// Sets the light of each px by the slope of the heights (J. H. Lambert, 1760), 1 where they are level. A `gloss` of 0..1 adds a
/// highlight where the slope mirrors the light upwards.
pub fn apply(picture: &mut [Surfel], source: &Source, gloss: f32) {
    let [width, height] = source.size;
    let heights: Vec<f32> = picture.iter().map(|surfel| surfel.height).collect();
    let scale = source.scale();
    picture.par_chunks_mut(width).enumerate().for_each(|(y, row)| {
        let above = source.edges.index(y as isize - 1, height) * width;
        let below = source.edges.index(y as isize + 1, height) * width;
        for (x, surfel) in row.iter_mut().enumerate() {
            let left = y * width + source.edges.index(x as isize - 1, width);
            let right = y * width + source.edges.index(x as isize + 1, width);
            let across = 0.5 * scale[0] * (heights[right] - heights[left]);
            let down = 0.5 * scale[1] * (heights[below + x] - heights[above + x]);
            surfel.light = light([across, down], gloss);
        }
    });
}

/// The factor of the light on a surface that rises by these px a px to the right and down.
#[inline]
fn light([across, down]: [f32; 2], gloss: f32) -> f32 {
    let per_length = 1.0 / (1.0 + across * across + down * down).sqrt();
    let towards = (LIGHT[2] - LIGHT[0] * across - LIGHT[1] * down) * per_length;
    // Half-way between the light and the eye, which looks straight down (J. F. Blinn, 1977).
    let half = [LIGHT[0], LIGHT[1], LIGHT[2] + 1.0];
    let long = (half[0] * half[0] + half[1] * half[1] + half[2] * half[2]).sqrt();
    let mirrored = ((half[2] - half[0] * across - half[1] * down) * per_length / long).max(0.0);
    let sharp = |cosine: f32| {
        let fourth = (cosine * cosine) * (cosine * cosine);
        let sixteenth = (fourth * fourth) * (fourth * fourth);
        sixteenth * sixteenth
    };
    let level = sharp(half[2] / long);
    let lit = towards / LIGHT[2] + gloss * (sharp(mirrored) - level);
    lit.clamp(RANGE[0], RANGE[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slopes_towards_the_light_are_brighter_and_level_ground_is_unchanged() {
        assert!((light([0.0, 0.0], 0.5) - 1.0).abs() < 1e-6);
        let [towards, away] = [[0.3, 0.3], [-0.3, -0.3]].map(|slope| light(slope, 0.0));
        assert!(towards > 1.1 && away < 0.9, "{towards} {away}");
        assert!(light([0.3, 0.3], 0.5) > towards);
    }
}
