//! Height and roughness of a material: of the ground and of the marks of each layer.

/// Height and roughness of a material.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// Height of the centre of a mark above the ground, px, for each layer; negative for hollows. The last value holds for all
    /// further layers.
    pub relief: Vec<f64>,
    /// Roughness of the ground, then of the marks of each layer, 0 = mirror, 1 = chalk. The last value holds for all further
    /// layers.
    pub roughness: Vec<f64>,
}

impl Default for Surface {
    /// Marks as high as those of embossed leather, and smoother than the ground.
    fn default() -> Self {
        Self { relief: vec![6.0], roughness: vec![0.8, 0.5] }
    }
}

/// Replaces patterns by the share of each px that belongs to the marks of each layer, 0..1. All layers have the same number of
/// px.
///
/// Each layer has only the space that the layers beneath leave free: with P the largest share beneath, pₖ becomes pₖ·w(P), w(P) = 1
/// − `smoothstep`(4P − 1): 1 up to P = ¼, 0 from ½ (a mark's edge) on, smooth between. Therefore no map has a step where a frozen
/// mark ends.
pub fn shares(patterns: &mut [Vec<f32>]) {
    let px = patterns.first().map_or(0, Vec::len);
    for i in 0..px {
        let mut beneath = 0.0_f32;
        for pattern in &mut *patterns {
            let left = 1.0 - smoothstep(4.0 * beneath - 1.0);
            pattern[i] = pattern[i].clamp(0.0, 1.0) * left;
            beneath = beneath.max(pattern[i]);
        }
    }
}

/// S(s) = s²(3 − 2s), with S′ = 0 at 0 and at 1.
///
/// Patterns are clipped at 0 and 1. A height proportional to them would have a crease there, which light shows as a ring around
/// a mark's foot and top.
fn smoothstep(share: f32) -> f32 {
    let share = share.clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}

impl Surface {
    /// The lowest and the highest height that `layers` layers can reach, px; the ground is at 0.
    #[must_use]
    pub fn range(&self, layers: usize) -> [f64; 2] {
        let reliefs = (0..layers).map(|layer| by_layer(&self.relief, layer));
        reliefs.fold([0.0, 0.0], |[low, high], relief| [low.min(relief), high.max(relief)])
    }

    /// Height of each px above the ground, px: Σ S(shareₖ)·reliefₖ, S(s) = s²(3 − 2s), so that a mark's foot and top
    /// are round.
    #[must_use]
    pub fn height(&self, shares: &[Vec<f32>]) -> Vec<f32> {
        sum(shares, 0.0, &|layer| by_layer(&self.relief, layer) as f32, smoothstep)
    }

    /// Roughness of each px: r₀ + Σ shareₖ(rₖ − r₀).
    #[must_use]
    pub fn roughness(&self, shares: &[Vec<f32>]) -> Vec<f32> {
        let (ground, marks) = self.roughness.split_first().map_or((0.8, &[][..]), |(g, m)| (*g, m));
        let rough = |layer| if marks.is_empty() { ground } else { by_layer(marks, layer) };
        sum(shares, ground as f32, &|layer| (rough(layer) - ground) as f32, |share| share)
    }

    /// `height` as a picture value: 0 = the lowest possible, 1 = the highest possible; ½ if the surface is flat.
    #[must_use]
    pub fn normalised(&self, height: f32, layers: usize) -> f32 {
        share_of(height, self.range(layers))
    }
}

/// `height` as a picture value: 0 = `low`, 1 = `high`; ½ if these are equal.
#[must_use]
pub fn share_of(height: f32, [low, high]: [f64; 2]) -> f32 {
    if high > low { ((f64::from(height) - low) / (high - low)) as f32 } else { 0.5 }
}

fn by_layer(values: &[f64], layer: usize) -> f64 {
    values.get(layer).or(values.last()).copied().unwrap_or(0.0)
}

fn sum(
    shares: &[Vec<f32>],
    ground: f32,
    weight: &dyn Fn(usize) -> f32,
    profile: impl Fn(f32) -> f32,
) -> Vec<f32> {
    let mut values = vec![ground; shares.first().map_or(0, Vec::len)];
    for (layer, share) in shares.iter().enumerate() {
        let weight = weight(layer);
        values.iter_mut().zip(share).for_each(|(value, share)| *value += weight * profile(*share));
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_layer_has_the_space_that_the_layers_beneath_leave_free() {
        let mut patterns = vec![vec![0.0, 0.2, 0.375, 0.5, 1.0], vec![0.8; 5]];
        shares(&mut patterns);
        assert_eq!(patterns[0], [0.0, 0.2, 0.375, 0.5, 1.0]);
        assert_eq!(patterns[1], [0.8, 0.8, 0.4, 0.0, 0.0]);
    }

    #[test]
    fn a_mark_has_no_crease_at_its_foot_or_its_top() {
        // A pattern that is cut off at both ends, as patterns are, and rises by 1/100 a px between.
        let pattern: Vec<f32> = (-50..150).map(|i| (i as f32 / 100.0).clamp(0.0, 1.0)).collect();
        let height = Surface::default().height(&[pattern]);
        let slopes: Vec<f32> = height.windows(2).map(|pair| pair[1] - pair[0]).collect();
        // 6 px · S″ ≤ 36 px ÷ 100²; in proportion to the pattern, the slope would jump by 0.06.
        assert!(slopes.windows(2).all(|pair| (pair[1] - pair[0]).abs() < 0.0037), "{slopes:?}");
        assert_eq!([height[0], height[100], height[199]], [0.0, 3.0, 6.0]);
        // A layer that ends beneath a flank of another.
        let flank: Vec<f32> = (0..400).map(|i| i as f32 / 400.0).collect();
        let mut patterns = [flank, vec![0.5; 400]];
        shares(&mut patterns);
        let slopes: Vec<f32> = patterns[1].windows(2).map(|pair| pair[1] - pair[0]).collect();
        assert!(slopes.windows(2).all(|pair| (pair[1] - pair[0]).abs() < 0.0004), "{slopes:?}");
    }

    #[test]
    fn heights_and_roughness_are_those_of_each_layer() {
        let surface = Surface { relief: vec![4.0, -2.0], roughness: vec![0.9, 0.5, 0.1] };
        let shares = [vec![0.0, 1.0, 0.0, 0.5], vec![0.0, 0.0, 1.0, 0.0]];
        assert_eq!(surface.height(&shares), [0.0, 4.0, -2.0, 2.0]);
        let rough = surface.roughness(&shares);
        assert!(
            rough.iter().zip([0.9, 0.5, 0.1, 0.7]).all(|(a, b): (&f32, f32)| (a - b).abs() < 1e-6),
            "{rough:?}"
        );
        assert_eq!([-2.0, 0.0, 4.0].map(|height| surface.normalised(height, 2)), [0.0, 1.0 / 3.0, 1.0]);
        assert_eq!(surface.range(5), [-2.0, 4.0]);
        let flat = Surface { relief: vec![0.0], ..surface };
        assert_eq!(flat.normalised(0.0, 1), 0.5);
    }
}
