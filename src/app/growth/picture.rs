//! Pictures of a growth for the screen.

use std::sync::Arc;

use egui::ColorImage;

use super::Texture;
use crate::document::Document;
use crate::synth::Snapshot;
use crate::synth::render::painting::Painting;

/// The longest side of a picture, px: all graphics cards support textures of this size.
const LONGEST: usize = 4096;
/// px for each cell of the grid in pictures of a growing pattern; the graphics card interpolates between them.
const FINENESS: usize = 2;
/// The longest side of a settled picture with several px for each px of the canvas: larger ones take long to load.
const MAGNIFIED: usize = 2048;

/// A picture of a texture.
#[derive(Clone)]
pub struct Picture {
    /// The pixels.
    pub image: Arc<ColorImage>,
    /// Width and height of the canvas that it shows, px.
    pub canvas: [u32; 2],
    /// Whether no px is transparent.
    pub is_opaque: bool,
    /// The fineness that was asked for: [`Growth::set_fineness`](super::Growth::set_fineness).
    pub(super) fineness: usize,
}

impl Picture {
    /// The picture of a pattern that is growing.
    pub(super) fn growing(document: &Document, look: &Snapshot) -> Self {
        let canvas = document.size.map(|side| side as usize);
        let size = fitting(canvas, look.growing.grid.map(|cells| FINENESS * cells));
        Self::from_painting(&Painting::growing(document, look, size), document)
    }

    /// The picture of a settled texture, with `fineness` px for each px of the canvas along a side where that is not too many.
    pub(super) fn settled(texture: &Texture, fineness: usize) -> Self {
        let side = texture.grown.size.map(|side| side as usize).into_iter().fold(1, usize::max);
        let scale = fineness.min(MAGNIFIED / side).max(1);
        let mut painting = Painting::new(&texture.document, &texture.grown, scale);
        painting.size = fitting(painting.size, [LONGEST; 2]);
        Self { fineness, ..Self::from_painting(&painting, &texture.document) }
    }

    /// The picture of the lowest `count` layers of a settled texture, at most `longest` px a side.
    pub fn lowest(texture: &Texture, count: usize, longest: usize) -> Self {
        let mut document = Document::clone(&texture.document);
        document.layers.truncate(count);
        let size = fitting(document.size.map(|side| side as usize), [longest; 2]);
        Self::from_painting(&Painting::sized(&document, &texture.grown, size), &document)
    }

    fn from_painting(painting: &Painting, document: &Document) -> Self {
        let image = Arc::new(image(painting));
        Self { image, canvas: document.size, is_opaque: painting.is_opaque(), fineness: 1 }
    }
}

/// The px of a painting, with their opacity.
#[must_use]
pub fn image(painting: &Painting) -> ColorImage {
    if painting.is_opaque() {
        ColorImage::from_rgb(painting.size, &painting.rgb())
    } else {
        ColorImage::from_rgba_unmultiplied(painting.size, &painting.rgba())
    }
}

/// The size of the canvas, scaled down to at most `most` along either side.
fn fitting(canvas: [usize; 2], most: [usize; 2]) -> [usize; 2] {
    let shrink = (0..2).map(|axis| most[axis] as f64 / canvas[axis] as f64).fold(1.0, f64::min);
    canvas.map(|side| ((side as f64 * shrink).round() as usize).max(1))
}
