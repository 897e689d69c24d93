//! Pictures of a document on a model.

use std::path::Path;

use super::Args;
use crate::cli::Error;
use crate::export::body::View;
use crate::export::png::{Header, Samples};
use crate::export::{Format, Stopped, picture};
use crate::files::{self, Prepared};
use crate::machine::aside::aside;
use crate::machine::free_memory;
use crate::synth::body::{GrownBody, Shown};
use crate::synth::{Stage, Watch, memory};

/// Width and height of a picture of a model, px.
const SIZE: [u32; 2] = [1_024, 1_024];
/// From where a model is seen: azimuth and elevation, degrees.
const VIEW: [f64; 2] = [-30.0, 18.0];
/// Bytes of memory that a px of a picture takes while it is drawn: three times what 5000 × 5000 px took.
const PX: f64 = 16.0;

/// Width and height of the picture, px.
fn size(args: &Args) -> [u32; 2] {
    let scale = args.scale.unwrap_or(1);
    args.size.unwrap_or(SIZE).map(|side| side.saturating_mul(scale))
}

/// Checks whether a picture fits into memory.
///
/// # Errors
/// It does not: how much it needs.
pub fn check_picture(args: &Args) -> Result<(), Error> {
    let px = size(args).map(|side| side as usize);
    memory::check_picture(px, PX, Some(free_memory())).map_err(Error::step)
}

/// Writes a picture of a model under a temporary name.
///
/// # Errors
/// It cannot be written.
pub fn prepare_picture(
    path: &Path,
    args: &Args,
    grown: &GrownBody,
    watch: &Watch,
) -> Result<Prepared, Error> {
    let format = Format::from_path(path).unwrap_or(Format::Png);
    let size = size(args);
    let px = size.map(|side| side as usize);
    check_picture(args)?;
    let [azimuth, elevation] = args.body.view.unwrap_or(VIEW);
    let is_clear = args.look.transparent && format != Format::Jpeg;
    let mut view = View::new(azimuth, elevation, size);
    if is_clear {
        view.background = None;
    }
    let drawn = Shown::new(grown, &view, watch).picture(&view);
    watch.step(Stage::Write, 1.0).map_err(|_| Error::Interrupted)?;
    let style = args.look.style_for(&grown.document, true, crate::document::Extent::default());
    let samples = if is_clear { Samples::Rgba8 } else { Samples::Rgb8 };
    let header = Header { texts: &style.texts, ..Header::new(px, samples) };
    let encoding = picture::Encoding { quality: style.quality, aside };
    let written = files::prepare(path, |out| {
        picture::write(out, format, encoding, header, |rows, band| {
            let px_of_rows = drawn.rgba[4 * rows.start * px[0]..4 * rows.end * px[0]].chunks_exact(4);
            for (to, from) in band.chunks_exact_mut(samples.bytes()).zip(px_of_rows) {
                to.copy_from_slice(&from[..samples.bytes()]);
            }
            Ok::<(), Stopped>(())
        })
    });
    written.map_err(Error::exported)
}
