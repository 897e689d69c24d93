//! What the window shows of a growth.

use std::sync::Arc;

use egui::ColorImage;

use super::Texture;
use crate::document::Document;
use crate::synth::Snapshot;
use crate::synth::render::painting::Painting;

/// The longest side of a picture on the screen, px: graphics cards take at least as much.
const LONGEST: usize = 4096;
/// px a cell of the grid at which a growing pattern is shown; between them the card interpolates.
const FINENESS: usize = 2;

/// A picture of a texture.
#[derive(Clone)]
pub struct Picture {
    /// Its px.
    pub image: Arc<ColorImage>,
    /// The canvas it shows, px.
    pub canvas: [u32; 2],
    /// Has the growth settled?
    pub settled: bool,
}

impl Picture {
    /// Of what still grows.
    pub(super) fn growing(document: &Document, look: &Snapshot) -> Self {
        let marks = look.engine.marks();
        let canvas = document.size.map(|side| side as usize);
        let size = fitting(canvas, [FINENESS * marks.width, FINENESS * marks.height]);
        Self::of(&Painting::growing(document, look, size), document, false)
    }

    /// Of what has settled.
    pub(super) fn settled(texture: &Texture) -> Self {
        let mut painting = Painting::new(&texture.document, &texture.grown, 1);
        painting.size = fitting(painting.size, [LONGEST; 2]);
        Self::of(&painting, &texture.document, true)
    }

    /// Of the lowest `count` layers of what has settled, no longer than `longest` px a side.
    pub fn lowest(texture: &Texture, count: usize, longest: usize) -> Self {
        let mut document = Document::clone(&texture.document);
        document.layers.truncate(count);
        let size = fitting(document.size.map(|side| side as usize), [longest; 2]);
        Self::of(&Painting::sized(&document, &texture.grown, size), &document, true)
    }

    fn of(painting: &Painting, document: &Document, settled: bool) -> Self {
        let image = Arc::new(ColorImage::from_rgb(painting.size, &painting.rgb()));
        Self { image, canvas: document.size, settled }
    }
}

/// The canvas' size, made smaller until it is no larger than `most` along either side.
fn fitting(canvas: [usize; 2], most: [usize; 2]) -> [usize; 2] {
    let shrink = (0..2).map(|axis| most[axis] as f64 / canvas[axis] as f64).fold(1.0, f64::min);
    canvas.map(|side| ((side as f64 * shrink).round() as usize).max(1))
}
