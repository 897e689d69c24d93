//! A contact sheet: one document with many seeds.

use super::layout::{Layout, Shape};
use super::paper::Paper;
use super::text::{self, Pen};
use super::{MAX_PX, SUPERSAMPLING};
use crate::cli::Error;
use crate::document::Document;
use crate::export::{downscale, png};
use crate::files;
use crate::synth::Grown;
use crate::synth::render::film::fitted;
use crate::synth::render::painting::Painting;
use std::path::Path;

/// A small picture.
pub struct Thumbnail {
    size: [usize; 2],
    rgb: Vec<u8>,
}

impl Thumbnail {
    /// A picture of `size` px: red, green, blue for each px, row by row from the top.
    pub fn from_rgb(size: [usize; 2], rgb: Vec<u8>) -> Self {
        Self { size, rgb }
    }

    /// A picture of a growth; its longer side has `side` px.
    pub fn new(document: &Document, grown: &Grown, side: usize) -> Self {
        let size = fitted(grown.size, side);
        let fine = size.map(|side| SUPERSAMPLING * side);
        Self { size, rgb: downscale(&Painting::sized(document, grown, fine).rgb(), fine, size) }
    }
}

/// Small pictures with their names.
pub struct Contact {
    title: Option<String>,
    side: usize,
    pictures: Vec<(String, Thumbnail)>,
}

impl Contact {
    /// An empty sheet for pictures whose longer side has `side` px; `title` precedes each name.
    pub fn new(title: Option<String>, side: usize) -> Self {
        Self { title, side, pictures: Vec::new() }
    }

    /// Adds a picture at the end.
    pub fn add(&mut self, name: String, picture: Thumbnail) {
        self.pictures.push((name, picture));
    }

    /// Whether it has no pictures.
    pub fn is_empty(&self) -> bool {
        self.pictures.is_empty()
    }
}

/// Lays the pictures out with their names and writes the sheet.
///
/// # Errors
/// The sheet cannot be written, or would be too large.
pub fn write(contact: &Contact, output: &Path) -> Result<(), Error> {
    let pen = Pen::for_pictures_of(contact.side);
    let shape = |(_, thumb): &(String, Thumbnail)| Shape { picture: thumb.size, name: pen.line };
    let shapes: Vec<Shape> = contact.pictures.iter().map(shape).collect();
    let columns = super::layout::columns(shapes.len(), 1);
    let layout = Layout::new(&shapes, columns, contact.side, 1, 0);
    let [wide, high] = layout.size;
    if wide.saturating_mul(high) > MAX_PX {
        return Err(Error::Usage(format!(
            "the sheet would be {wide} × {high} px; allowed: {MAX_PX} px in all; choose fewer --variations"
        )));
    }
    let mut paper = Paper::blank(layout.size);
    for (spot, (name, thumb)) in layout.spots.iter().zip(&contact.pictures) {
        paper.place(&thumb.rgb, thumb.size, [spot.pictures[0], spot.top]);
        let name = contact.title.as_ref().map_or_else(|| name.clone(), |title| format!("{title}, {name}"));
        for line in pen.wrap(&name, contact.side, 1) {
            pen.write(&mut paper, &line, spot.name, text::INK);
        }
    }
    files::save(output, |out| png::rgb8(out, paper.size, None, &paper.rgb)).map_err(Error::exported)
}
