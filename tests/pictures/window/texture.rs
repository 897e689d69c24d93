//! A texture and its colour at any place.

use egui::epaint::textures::{TextureFilter, TextureOptions, TextureWrapMode};
use egui::epaint::{ImageData, ImageDelta};

/// Colours multiplied by their opacity, 0–1, row by row.
pub struct Texture {
    size: [usize; 2],
    texels: Vec<[f32; 4]>,
    options: TextureOptions,
}

/// Size and texels of a whole texture, or of a part of one.
fn content(change: &ImageDelta) -> ([usize; 2], impl Iterator<Item = [f32; 4]>) {
    let ImageData::Color(image) = &change.image;
    (image.size, image.pixels.iter().map(|colour| colour.to_array().map(|part| f32::from(part) / 255.0)))
}

impl Texture {
    /// The texture that `whole` describes.
    pub fn new(whole: &ImageDelta) -> Self {
        let (size, texels) = content(whole);
        Self { size, texels: texels.collect(), options: whole.options }
    }

    /// Replaces a rectangle whose first texel is `left`, `top`.
    pub fn replace(&mut self, [left, top]: [usize; 2], part: &ImageDelta) {
        let ([width, _], texels) = content(part);
        for (index, texel) in texels.enumerate() {
            self.texels[(top + index / width) * self.size[0] + left + index % width] = texel;
        }
    }

    /// The colour at a place; the whole texture is 0–1 along each side.
    pub fn at(&self, place: [f32; 2]) -> [f32; 4] {
        let [x, y] = [place[0] * self.size[0] as f32, place[1] * self.size[1] as f32];
        if self.options.magnification == TextureFilter::Nearest {
            return self.texel([x.floor() as i64, y.floor() as i64]);
        }
        let [x, y] = [x - 0.5, y - 0.5];
        let [left, top] = [x.floor() as i64, y.floor() as i64];
        let row = |y| mix(self.texel([left, y]), self.texel([left + 1, y]), x - x.floor());
        mix(row(top), row(top + 1), y - y.floor())
    }

    fn texel(&self, at: [i64; 2]) -> [f32; 4] {
        let [x, y]: [usize; 2] = std::array::from_fn(|axis| {
            let size = self.size[axis] as i64;
            let inside = match self.options.wrap_mode {
                TextureWrapMode::ClampToEdge => at[axis].clamp(0, size - 1),
                TextureWrapMode::Repeat => at[axis].rem_euclid(size),
                TextureWrapMode::MirroredRepeat => {
                    let phase = at[axis].rem_euclid(2 * size);
                    phase.min(2 * size - 1 - phase)
                }
            };
            inside as usize
        });
        self.texels[y * self.size[0] + x]
    }
}

fn mix(from: [f32; 4], to: [f32; 4], share: f32) -> [f32; 4] {
    std::array::from_fn(|part| from[part] + (to[part] - from[part]) * share)
}
