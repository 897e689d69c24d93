//! Grows a document and makes the files that `dapple grow FILE -o PICTURE.png --pattern PATTERN.png` writes; for a
//! model, the picture with `--size 512x512`, and the `.ply`, which holds the value of each vertex.

use std::io::Cursor;

use dapple_engine::document::embedded::embedded;
use dapple_engine::document::{Document, Extent, with_causes};
use dapple_engine::export::body::View;
use dapple_engine::export::picture::{self, Encoding};
use dapple_engine::export::png::{Header, Samples};
use dapple_engine::export::web::at_once;
use dapple_engine::export::{Format, Stopped};
use dapple_engine::synth::body::BodyGrowth;
use dapple_engine::synth::render::painting::{Channel, Painting, Style};
use dapple_engine::synth::{Growth, Options, Watch};

/// Azimuth and elevation of the picture of a model, degrees: those of `dapple grow`.
const VIEW: [f64; 2] = [-30.0, 18.0];
/// Width and height of the picture of a model, px.
const SIZE: [u32; 2] = [512, 512];

/// The kind of a file.
#[derive(Clone, Copy)]
pub enum Kind {
    Error,
    Picture,
    Pattern,
    Model,
}

/// A file that was written.
pub struct Written {
    pub kind: Kind,
    pub bytes: Vec<u8>,
}

/// An error message, as a file.
pub fn error(text: &str) -> Written {
    Written { kind: Kind::Error, bytes: text.as_bytes().to_vec() }
}

/// The files of a document.
///
/// # Errors
/// Why it cannot be grown.
pub fn files(document: &[u8]) -> Result<Vec<Written>, String> {
    let document = Document::from_bytes(document, "the document").map_err(|error| with_causes(&error))?;
    if document.model.is_some() { on_model(&document) } else { flat(&document) }
}

fn flat(document: &Document) -> Result<Vec<Written>, String> {
    let grown =
        Growth::begin(document, &Options::default(), None).run().map_err(|error| with_causes(&error))?;
    let painting = Painting::new(document, &grown, 1);
    let texts = embedded(document, Extent::default());
    let style = Style { dpi: document.dpi, texts, ..Style::default() };
    let write = |kind, channel| {
        let written = |out: &mut Cursor<Vec<u8>>| {
            painting.write(out, Format::Png, channel, &style, at_once, &Watch::NONE)
        };
        file(kind, written)
    };
    Ok(vec![write(Kind::Picture, Channel::Texture)?, write(Kind::Pattern, Channel::Pattern(None))?])
}

fn on_model(document: &Document) -> Result<Vec<Written>, String> {
    let growth =
        BodyGrowth::begin(document, None, &Options::default()).map_err(|error| with_causes(&error))?;
    let grown = growth.run().map_err(|error| with_causes(&error))?;
    let drawn = grown.picture(&View::new(VIEW[0], VIEW[1], SIZE));
    let texts = embedded(&grown.document, Extent::default());
    let size = SIZE.map(|side| side as usize);
    let header = Header { texts: &texts, ..Header::new(size, Samples::Rgb8) };
    let picture = file(Kind::Picture, |out| {
        picture::write(out, Format::Png, Encoding::default(), header, |rows, band| {
            let px = drawn.rgba[4 * rows.start * size[0]..4 * rows.end * size[0]].chunks_exact(4);
            for (to, from) in band.chunks_exact_mut(3).zip(px) {
                to.copy_from_slice(&from[..3]);
            }
            Ok(())
        })
    });
    Ok(vec![picture?, file(Kind::Model, |out| grown.write_ply(out))?])
}

fn file(
    kind: Kind,
    write: impl FnOnce(&mut Cursor<Vec<u8>>) -> Result<(), Stopped>,
) -> Result<Written, String> {
    let mut out = Cursor::new(Vec::new());
    write(&mut out).map_err(|error| with_causes(&error))?;
    Ok(Written { kind, bytes: out.into_inner() })
}
