//! The maps of a material, read at any point of a surface.

/// The longest side of the stored maps, px: about what a view can show.
const LONGEST: usize = 640;

/// A px of the maps. Numbers 0..1, colours linear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Texel {
    /// Red, green, blue.
    pub(super) colour: [f32; 3],
    /// 0 = transparent.
    pub(super) opacity: f32,
    /// x to the right, y up, z out of the surface; not normalised between px.
    pub(super) normal: [f32; 3],
    /// 0 = a mirror, 1 = chalk.
    pub(super) roughness: f32,
    /// The share of the sky that is visible.
    pub(super) open: f32,
}

/// The maps of a material, ready to be lit.
#[derive(Clone, Debug)]
pub struct Maps {
    pub(super) size: [usize; 2],
    texels: Vec<Texel>,
    /// Whether its border continues on the other side; if not, repetitions are mirrored, so that there are no seams.
    wraps: bool,
}

/// The pictures of a material, 8 bits a channel, `size` px each: colour with opacity, the normal map (green up), roughness,
/// occlusion.
pub struct Pictures<'a> {
    /// Width and height, px.
    pub size: [usize; 2],
    /// Red, green, blue, opacity.
    pub colour: &'a (dyn Fn(usize) -> [u8; 4] + Sync),
    /// x, y, z as red, green, blue.
    pub normal: &'a (dyn Fn(usize) -> [u8; 3] + Sync),
    /// 0 = a mirror, 255 = chalk.
    pub roughness: &'a (dyn Fn(usize) -> u8 + Sync),
    /// 255 = open to the sky.
    pub occlusion: &'a (dyn Fn(usize) -> u8 + Sync),
}

impl Pictures<'_> {
    /// A px; `linear` is [`linear_table`].
    pub(super) fn texel(&self, px: usize, linear: &[f32]) -> Texel {
        let share = |part: u8| f32::from(part) / 255.0;
        let [red, green, blue, opacity] = (self.colour)(px);
        Texel {
            colour: [red, green, blue].map(|channel| linear[usize::from(channel)]),
            opacity: share(opacity),
            normal: (self.normal)(px).map(|part| f32::from(part) / 127.5 - 1.0),
            roughness: share((self.roughness)(px)),
            open: share((self.occlusion)(px)),
        }
    }
}

impl Maps {
    /// The maps of `pictures`; larger ones are reduced by the mean of their px.
    #[must_use]
    pub fn new(pictures: &Pictures, wraps: bool) -> Self {
        let [width, height] = pictures.size;
        let step = width.max(height).div_ceil(LONGEST).max(1);
        let size = [(width / step).max(1), (height / step).max(1)];
        let linear = linear_table();
        let texel = |at: usize| {
            let (x, y) = (at % size[0] * step, at / size[0] * step);
            let mut sum = [0.0f32; 9];
            let mut count = 0.0;
            for row in y..(y + step).min(height) {
                for column in x..(x + step).min(width) {
                    let px = row * width + column;
                    let Texel { colour, opacity, normal, roughness, open } = pictures.texel(px, &linear);
                    let all = colour.into_iter().chain(normal).chain([opacity, roughness, open]);
                    sum.iter_mut().zip(all).for_each(|(sum, part)| *sum += part);
                    count += 1.0;
                }
            }
            let [r, g, b, x, y, z, opacity, roughness, open] = sum.map(|part| part / f32::max(count, 1.0));
            Texel { colour: [r, g, b], opacity, normal: [x, y, z], roughness, open }
        };
        Self { size, texels: (0..size[0] * size[1]).map(texel).collect(), wraps }
    }

    /// The maps at surface coordinates, one repetition each from 0 to 1, between four px.
    pub(super) fn at(&self, [u, v]: [f32; 2]) -> Texel {
        let place = |share: f32, side: usize| {
            let whole = if self.wraps {
                share.rem_euclid(1.0)
            } else {
                // Forwards and backwards.
                let twice = share.rem_euclid(2.0);
                if twice > 1.0 { 2.0 - twice } else { twice }
            };
            let at = whole * side as f32 - 0.5;
            let low = at.floor();
            let index = |offset: isize| {
                let index = low as isize + offset;
                let side = side as isize;
                (if self.wraps { index.rem_euclid(side) } else { index.clamp(0, side - 1) }) as usize
            };
            ([index(0), index(1)], at - low)
        };
        let ((columns, x), (rows, y)) = (place(u, self.size[0]), place(v, self.size[1]));
        let texel = |column: usize, row: usize| &self.texels[rows[row] * self.size[0] + columns[column]];
        let mix = |of: &dyn Fn(&Texel) -> f32| {
            let row = |row: usize| (1.0 - x) * of(texel(0, row)) + x * of(texel(1, row));
            (1.0 - y) * row(0) + y * row(1)
        };
        Texel {
            colour: [0, 1, 2].map(|channel| mix(&|texel| texel.colour[channel])),
            opacity: mix(&|texel| texel.opacity),
            normal: [0, 1, 2].map(|part| mix(&|texel| texel.normal[part])),
            roughness: mix(&|texel| texel.roughness),
            open: mix(&|texel| texel.open),
        }
    }

    /// Numbers of repetitions around a body and up it that keep the maps' proportions; around it a whole number, so that a seamless
    /// material has no seam there.
    pub(super) fn repeats(&self, around: f32, up: f32) -> [f32; 2] {
        let aspect = self.size[0] as f32 / self.size[1] as f32;
        let rows = if around / up > 2.0 { 1.0 } else { 1.0f32.max((up / around).round()) };
        let columns = (around / up * rows / aspect).round().max(1.0);
        // Mirrored maps are periodic after two repetitions.
        let columns = if self.wraps { columns } else { 2.0 * (0.5 * columns).round().max(1.0) };
        [columns, rows]
    }
}

/// 8-bit sRGB → linear light.
pub(super) fn linear_table() -> Vec<f32> {
    let linear = |channel: f32| {
        if channel <= 0.04045 { channel / 12.92 } else { libm::powf((channel + 0.055) / 1.055, 2.4) }
    };
    (0..=255u8).map(|channel| linear(f32::from(channel) / 255.0)).collect()
}
