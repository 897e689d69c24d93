//! What a finish makes of one px, and the picture that it is made from.

use rayon::prelude::*;

use super::flow::Flow;
use super::noise::floor;
use super::reach::Reach;
use crate::grid::Edges;

/// Pictures with so many px along each px of the document have one point a px.
const FINE: f32 = 2.0;

/// Appearance of one px of a finished picture.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Surfel {
    /// Colour of the pattern there: red, green, blue in the coding of sRGB, 0..1.
    pub colour: [f32; 3],
    /// Factor of the colour by the material: of a single hair, a gap between scales.
    pub tint: f32,
    /// Factor of the colour by the light, from the upper left.
    pub light: f32,
    /// Height, px of the document.
    pub height: f32,
    /// Roughness: 0 = mirror, 1 = chalk.
    pub roughness: f32,
    /// The share of the colour that comes from marks, 0..1.
    pub ink: f32,
}

impl Surfel {
    /// This px covered by `other` with the weight `by`, 0..1.
    #[inline]
    #[must_use]
    pub fn covered(&self, other: &Self, by: f32) -> Self {
        let mix = |below: f32, above: f32| below + by * (above - below);
        Self {
            colour: [0, 1, 2].map(|channel| mix(self.colour[channel], other.colour[channel])),
            tint: mix(self.tint, other.tint),
            light: mix(self.light, other.light),
            height: mix(self.height, other.height),
            roughness: mix(self.roughness, other.roughness),
            ink: mix(self.ink, other.ink),
        }
    }

    /// Its colour without light: red, green, blue, 0..1.
    #[must_use]
    pub fn albedo(&self) -> [f32; 3] {
        self.colour.map(|channel| (channel * self.tint).clamp(0.0, 1.0))
    }

    /// Its colour in the light: red, green, blue, 0..1.
    #[must_use]
    pub fn lit(&self) -> [f32; 3] {
        self.colour.map(|channel| (channel * self.tint * self.light).clamp(0.0, 1.0))
    }
}

/// The painted texture that gets a finish.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    /// Width and height of the picture, px.
    pub size: [usize; 2],
    /// Width and height of the canvas, px of the document.
    pub canvas: [f32; 2],
    /// What lies beyond its border.
    pub edges: Edges,
    /// Red, green, blue for each px of the picture.
    pub rgb: &'a [u8],
    /// For each px of the picture the layer whose mark covers it; 0 = none.
    pub labels: &'a [u8],
    /// The direction of hair, scales and threads.
    pub flow: &'a Flow,
    /// The distance by which colours may move.
    pub reach: &'a Reach,
    /// Seed of all random numbers.
    pub seed: u64,
}

impl Source<'_> {
    /// px of the picture along each px of the canvas.
    #[must_use]
    pub fn scale(&self) -> [f32; 2] {
        [0, 1].map(|axis| self.size[axis] as f32 / self.canvas[axis])
    }

    /// Colour and share of ink at a point, px of the canvas.
    #[inline]
    #[must_use]
    pub fn at(&self, point: [f32; 2]) -> [f32; 4] {
        let scale = self.scale();
        let [x, y] =
            [0, 1].map(|axis| self.edges.index(floor(point[axis] * scale[axis]) as isize, self.size[axis]));
        self.px(y * self.size[0] + x)
    }

    /// Colour and share of ink at `point` of a scale, a cell or a thread. The colour of `share` of it is that of its centre, which is
    /// `by` px from there, or as far towards it as marks allow. It reaches `radius` px from its centre.
    #[inline]
    #[must_use]
    pub fn carried(&self, point: [f32; 2], by: [f32; 2], radius: f32, share: f32) -> [f32; 4] {
        let own = self.at(point);
        let centre = [point[0] + by[0], point[1] + by[1]];
        let part = self.reach.at(centre, radius) / radius;
        let other = self.at([point[0] + part * by[0], point[1] + part * by[1]]);
        [0, 1, 2, 3].map(|channel| own[channel] + share * (other[channel] - own[channel]))
    }

    /// The surfels of all px: `surfel` gives that of a point, px of the canvas. Pictures with few px have the mean of four points a
    /// px.
    #[must_use]
    pub fn shaded(&self, surfel: impl Fn([f32; 2]) -> Surfel + Sync) -> Vec<Surfel> {
        let width = self.size[0];
        let mut picture = vec![Surfel::default(); width * self.size[1]];
        picture.par_chunks_mut(width).enumerate().for_each(|(y, row)| {
            row.iter_mut().enumerate().for_each(|(x, px)| *px = self.mean([x, y], &surfel));
        });
        picture
    }

    /// The surfels of all px, computed one after the other: what [`Self::shaded`] is compared with.
    #[cfg(test)]
    pub fn shaded_plainly(&self, surfel: impl Fn([f32; 2]) -> Surfel) -> Vec<Surfel> {
        let [width, height] = self.size;
        (0..width * height).map(|px| self.mean([px % width, px / width], &surfel)).collect()
    }

    /// The surfel of one px.
    #[inline]
    fn mean(&self, [x, y]: [usize; 2], surfel: &impl Fn([f32; 2]) -> Surfel) -> Surfel {
        let scale = self.scale();
        let at = |dx: f32, dy: f32| surfel([(x as f32 + dx) / scale[0], (y as f32 + dy) / scale[1]]);
        if scale[0] >= FINE {
            return at(0.5, 0.5);
        }
        let [left, right] = [0.25, 0.75].map(|dx| at(dx, 0.25).covered(&at(dx, 0.75), 0.5));
        left.covered(&right, 0.5)
    }

    /// Colour and share of ink of a px of the picture.
    #[inline]
    #[must_use]
    pub fn px(&self, px: usize) -> [f32; 4] {
        let channel = |channel: usize| f32::from(self.rgb[3 * px + channel]) * (1.0 / 255.0);
        [channel(0), channel(1), channel(2), f32::from(u8::from(self.labels[px] > 0))]
    }
}
