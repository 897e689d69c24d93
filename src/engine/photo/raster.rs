//! The px of a photograph.

use rayon::prelude::*;

/// A picture of 8 bits a channel.
#[derive(Clone, Debug, PartialEq)]
pub struct Raster {
    /// Width and height, px.
    pub size: [usize; 2],
    /// Red, green, blue (sRGB) of each px, row by row from the top.
    pub rgb: Vec<u8>,
    /// px an inch, if the file states it.
    pub dpi: Option<f64>,
}

/// A part of a picture, px from its upper left corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Crop {
    /// Left and upper border.
    pub from: [usize; 2],
    /// Width and height.
    pub size: [usize; 2],
}

impl Raster {
    /// Red, green, blue of the px at column `x`, row `y`.
    #[must_use]
    pub fn px(&self, x: usize, y: usize) -> [u8; 3] {
        let at = 3 * (y * self.size[0] + x);
        [self.rgb[at], self.rgb[at + 1], self.rgb[at + 2]]
    }

    /// The part that `crop` names; `None` if it has no px, or some outside of the picture.
    #[must_use]
    pub fn cropped(&self, crop: Crop) -> Option<Self> {
        let fits = |axis: usize| {
            let end = crop.from[axis].checked_add(crop.size[axis]);
            crop.size[axis] > 0 && end.is_some_and(|end| end <= self.size[axis])
        };
        if !fits(0) || !fits(1) {
            return None;
        }
        let row = |y: usize| {
            let start = 3 * (y * self.size[0] + crop.from[0]);
            &self.rgb[start..start + 3 * crop.size[0]]
        };
        let rows = crop.from[1]..crop.from[1] + crop.size[1];
        Some(Self { size: crop.size, rgb: rows.flat_map(row).copied().collect(), dpi: self.dpi })
    }

    /// The picture whose px at (x + ½, y + ½) lies at `place` in this one, px; by bilinear interpolation between px, and with the
    /// px of the border beyond it.
    #[must_use]
    pub fn warped(&self, size: [usize; 2], place: impl Fn([f64; 2]) -> [f64; 2] + Sync) -> Self {
        let mut rgb = vec![0; 3 * size[0] * size[1]];
        rgb.par_chunks_mut(3 * size[0].max(1)).enumerate().for_each(|(y, row)| {
            for (x, px) in row.chunks_exact_mut(3).enumerate() {
                px.copy_from_slice(&self.between(place([x as f64 + 0.5, y as f64 + 0.5])));
            }
        });
        Self { size, rgb, dpi: self.dpi }
    }

    fn between(&self, point: [f64; 2]) -> [u8; 3] {
        let near = |axis: usize| {
            let last = self.size[axis] as f64 - 1.0;
            let at = (point[axis] - 0.5).clamp(0.0, last.max(0.0));
            let low = at.floor();
            (low as usize, ((low + 1.0).min(last)) as usize, at - low)
        };
        let ((left, right, u), (top, bottom, v)) = (near(0), near(1));
        let four = [self.px(left, top), self.px(right, top), self.px(left, bottom), self.px(right, bottom)];
        let mix = |k: usize| {
            let [a, b, c, d] = four.map(|px| f64::from(px[k]));
            ((a + u * (b - a)) * (1.0 - v) + (c + u * (d - c)) * v + 0.5) as u8
        };
        [mix(0), mix(1), mix(2)]
    }
}
