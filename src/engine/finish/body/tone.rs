//! The tone of a material on a surface: as bright as what it is made of, and mottled.

use super::solid::SolidNoise;
use crate::finish::kind::Finish;
use crate::finish::mottling::{OCTAVES, PART, factor};
use crate::finish::noise::part_seed;

/// A factor of the tone at each place in space.
pub(super) struct Tone {
    exposure: f32,
    /// The octaves of the mottling with their weights.
    octaves: Vec<(SolidNoise, f32)>,
}

impl Tone {
    pub fn new(finish: &Finish, seed: u64) -> Self {
        let octave = |((times, weight), part): (&(f32, f32), u32)| {
            let noise = SolidNoise::new(times * finish.size as f32, part_seed(seed, part));
            (noise, weight * factor(finish.mottle as f32))
        };
        let octaves =
            if finish.mottle > 0.0 { OCTAVES.iter().zip(PART..).map(octave).collect() } else { Vec::new() };
        Self { exposure: finish.kind.exposure(), octaves }
    }

    /// The factor at a place, px.
    pub fn at(&self, place: [f32; 3]) -> f32 {
        let noise: f32 = self.octaves.iter().map(|(noise, weight)| weight * noise.at(place)).sum();
        self.exposure * (1.0 + noise).max(0.0)
    }
}
