//! Finishes: the material that a grown texture is made of, as colour, height and roughness at any resolution.
//!
//! ```text
//! colours, labels, flow ─▶ reach ─▶ fur | scales | skin | cloth | ink | print ─▶ light ─▶ mottling ─▶ mask
//!                          how far    colour, tint, height, roughness of each px          tone        marks without crumbs
//! ```
//!
//! A finish comes after everything that is measured: pattern, labels and outlines do not know it. It has a picture of its own marks,
//! [`Finished::mask`]. All sizes are in px of the document, so that a picture with more px shows finer details of the same hairs.
//! A canvas that wraps has a finish that wraps. The same seed gives the same bytes on every machine and with any number of threads.

pub mod body;
pub mod cells;
pub mod cloth;
pub mod flow;
pub mod fur;
mod hair;
pub mod ink;
mod kind;
pub mod light;
pub mod mask;
pub mod mottling;
pub mod noise;
pub mod print;
pub mod reach;
pub mod scales;
pub mod skin;
pub mod surfel;
#[cfg(test)]
mod tests;

use rayon::prelude::*;

pub use flow::Flow;
pub use kind::{Finish, Kind};
pub use reach::Reach;
pub use surfel::{Source, Surfel};

use cloth::Weave;

/// A finished picture.
#[derive(Clone, Debug)]
pub struct Finished {
    /// Width and height, px.
    pub size: [usize; 2],
    /// Each px, row by row from the top.
    pub surfels: Vec<Surfel>,
    /// For each px the layer whose mark covers it after the finish; 0 = none.
    pub mask: Vec<u8>,
    /// The lowest and the highest of its heights, px of the document.
    pub heights: [f32; 2],
}

impl Finished {
    /// The picture with fewer px: each is the mean of those that it covers, and has the label of the one in its middle.
    #[must_use]
    pub fn reduced(&self, size: [usize; 2]) -> Self {
        let [width, _] = self.size;
        let covered = |at: usize, axis: usize| {
            let first = at * self.size[axis] / size[axis];
            first..((at + 1) * self.size[axis] / size[axis]).max(first + 1)
        };
        let px = |index: usize| {
            let (columns, rows) = (covered(index % size[0], 0), covered(index / size[0], 1));
            let middle = (rows.start + rows.end) / 2 * width + (columns.start + columns.end) / 2;
            let (mut mean, mut count) = (Surfel::default(), 0.0);
            for row in rows {
                for surfel in &self.surfels[row * width + columns.start..row * width + columns.end] {
                    count += 1.0;
                    mean = mean.covered(surfel, 1.0 / count);
                }
            }
            (mean, self.mask[middle])
        };
        let (surfels, mask) = (0..size[0] * size[1]).map(px).unzip();
        Self { size, surfels, mask, heights: self.heights }
    }
}

impl Finish {
    /// Bytes that [`Self::paint`] takes for each px of the picture: surfels, heights, the mask, and two sets of pieces.
    pub const BYTES_A_PX: f64 = 56.0;

    /// The reach of this finish for the `labels` of a canvas of `size` px.
    #[must_use]
    pub fn reach(&self, labels: &[u8], size: [usize; 2], edges: crate::grid::Edges) -> Reach {
        // The longest hair is 1.55 times as long as the mean.
        Reach::of(labels, size, edges, 1.55 / reach::SHARE * self.size as f32)
    }

    /// The finish of a painted texture.
    #[must_use]
    pub fn paint(&self, source: &Source) -> Finished {
        let mut surfels = self.surfels(source);
        let exposure = self.kind.exposure();
        surfels.par_iter_mut().for_each(|surfel| surfel.tint *= exposure);
        if self.mottle > 0.0 {
            mottling::mottle(&mut surfels, source, self.size as f32, self.mottle as f32);
        }
        let mask = mask::settled(&mut surfels, source);
        let heights = surfels.iter().map(|surfel| surfel.height);
        let heights = heights.fold([0.0_f32; 2], |[low, high], height| [low.min(height), high.max(height)]);
        Finished { size: source.size, surfels, mask, heights }
    }

    /// The px before crumbs are removed.
    fn surfels(&self, source: &Source) -> Vec<Surfel> {
        let size = self.size as f32;
        match self.kind {
            Kind::Fur => fur::paint(source, size),
            Kind::FishScales => scales::fish(source, size),
            Kind::ReptileScales => scales::reptile(source, size),
            Kind::Skin => skin::skin(source, size),
            Kind::Leather => skin::leather(source, size),
            Kind::Cloth => cloth::woven(source, size, Weave::Plain),
            Kind::Twill => cloth::woven(source, size, Weave::Twill),
            Kind::Ink => ink::on_paper(source, size),
            Kind::Print => print::halftone(source, size),
        }
    }

    /// The px without light, before crumbs are removed, computed one after the other; not of fur.
    #[cfg(test)]
    fn shaded_plainly(&self, source: &Source) -> Vec<Surfel> {
        let size = self.size as f32;
        match self.kind {
            Kind::Fur => Vec::new(),
            Kind::FishScales => source.shaded_plainly(scales::fish_surfel(source, size)),
            Kind::ReptileScales => source.shaded_plainly(scales::reptile_surfel(source, size)),
            Kind::Skin => source.shaded_plainly(skin::surfel(source, size, skin::SKIN)),
            Kind::Leather => source.shaded_plainly(skin::surfel(source, size, skin::LEATHER)),
            Kind::Cloth => source.shaded_plainly(cloth::surfel(source, size, Weave::Plain)),
            Kind::Twill => source.shaded_plainly(cloth::surfel(source, size, Weave::Twill)),
            Kind::Ink => source.shaded_plainly(ink::surfel(source, size)),
            Kind::Print => source.shaded_plainly(print::surfel(source, size)),
        }
    }
}
