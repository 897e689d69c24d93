//! Skin and leather: irregular grains of two sizes with creases between them.

use super::cells::Cells;
use super::light;
use super::noise::{Noise, part_seed};
use super::surfel::{Source, Surfel};

/// What tells skin and leather apart.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hide {
    /// The share of a grain's colour that is that of its centre.
    pub from_centre: f32,
    /// Irregularity of the grains, 0..1.
    pub jitter: f32,
    /// Half the width of a crease ÷ size of a grain.
    crease: f32,
    /// Height of a grain ÷ its size.
    dome: f32,
    /// Weight of the grains of half the size.
    fine: f32,
    /// Range of the brightness of grains.
    tint: f32,
    roughness: f32,
    gloss: f32,
}

/// The granular skin of a gecko: each grain has nearly one colour.
pub(super) const SKIN: Hide = Hide {
    from_centre: 0.8,
    jitter: 0.55,
    crease: 0.07,
    dome: 0.2,
    fine: 0.25,
    tint: 0.12,
    roughness: 0.6,
    gloss: 0.15,
};
/// Dyed leather: the colours run over the grains.
pub(super) const LEATHER: Hide = Hide {
    from_centre: 0.2,
    jitter: 0.95,
    crease: 0.055,
    dome: 0.11,
    fine: 0.6,
    tint: 0.07,
    roughness: 0.45,
    gloss: 0.35,
};

/// Granular skin with grains of `size` px.
#[must_use]
pub fn skin(source: &Source, size: f32) -> Vec<Surfel> {
    finished(source, size, &SKIN)
}

/// Leather with grains of `size` px.
#[must_use]
pub fn leather(source: &Source, size: f32) -> Vec<Surfel> {
    finished(source, size, &LEATHER)
}

fn finished(source: &Source, size: f32, hide: &Hide) -> Vec<Surfel> {
    let mut picture = source.shaded(surfel(source, size, *hide));
    light::apply(&mut picture, source, hide.gloss);
    picture
}

pub(super) fn surfel<'a>(
    source: &'a Source,
    size: f32,
    hide: Hide,
) -> impl Fn([f32; 2]) -> Surfel + Sync + 'a {
    let part = |index| part_seed(source.seed, index);
    let grains = Cells::new(source.canvas, size, hide.jitter, part(48));
    let fine = Cells::new(source.canvas, 0.45 * size, hide.jitter, part(49));
    let pores = Noise::new(source.canvas, 0.11 * size, part(50));
    let folds = Noise::new(source.canvas, 5.0 * size, part(51));
    let bend =
        [Noise::new(source.canvas, 0.6 * size, part(52)), Noise::new(source.canvas, 0.6 * size, part(53))];
    move |point| {
        // Creases are not straight.
        let bent = [0, 1].map(|axis| point[axis] + 0.09 * size * bend[axis].at(point));
        let (grain, small) = (grains.at(bent), fine.at(bent));
        let [red, green, blue, ink] = source.carried(point, grain.to_point, 0.8 * size, hide.from_centre);
        let noises = [folds.at(point), pores.at(point)];
        hide.surfel(size, [grain.edge, small.edge, grain.random], noises, [red, green, blue, ink])
    }
}

impl Hide {
    /// The lowest and the highest height of grains of `size` px.
    pub(super) fn heights(&self, size: f32) -> [f32; 2] {
        [-0.14, self.dome + 0.06 + 0.04 * self.fine + 0.14].map(|share| share * size)
    }

    /// A place in a grain of `size` px: distances of the nearest edges of the grain and of the small one in it, px, and a random number
    /// of the grain; noise of folds and of pores; colour and share of ink.
    #[inline]
    pub(super) fn surfel(
        &self,
        size: f32,
        [edge, small_edge, random]: [f32; 3],
        [fold, pore]: [f32; 2],
        [red, green, blue, ink]: [f32; 4],
    ) -> Surfel {
        let depth = |edge: f32, width: f32| {
            let t = (edge / width).min(1.0);
            t * t * (3.0 - 2.0 * t)
        };
        let open = depth(edge, self.crease * size * (1.0 + 0.6 * fold));
        let little = depth(small_edge, 0.5 * self.crease * size);
        let inside = (edge / (0.4 * size)).min(1.0);
        Surfel {
            colour: [red, green, blue],
            tint: (1.0 + self.tint * (2.0 * random - 1.0) + 0.04 * fold)
                * (0.5 + 0.5 * open)
                * (1.0 - 0.18 * self.fine * (1.0 - little))
                * (1.0 + 0.035 * pore),
            light: 1.0,
            height: size
                * (self.dome * inside * (2.0 - inside)
                    + 0.06 * open
                    + 0.04 * self.fine * little
                    + 0.008 * pore)
                + 0.1 * size * fold,
            roughness: self.roughness + 0.2 * (1.0 - open) + 0.05 * pore,
            ink,
        }
    }
}
