//! The pictures of a growth: texture, pattern, labels, concentrations, material.

use super::Args;
use super::body::holds_model;
use super::outlines::holds_outlines;
use crate::cli::Error;
use crate::document::{Document, Extent};
use crate::export::Content;
use crate::files::{self, Prepared, SavePicture, check_picture, prepare_concentrations};
use crate::machine::free_memory;
use crate::synth::render::painting::{Channel, Painting};
use crate::synth::{Grown, Watch, memory};
use std::path::Path;

/// The requested pictures of the canvas.
fn requested(args: &Args) -> impl Iterator<Item = (&Path, Channel)> {
    let only = args.layer.map(|layer| layer as usize - 1);
    let pictures = [
        (args.output.as_deref().filter(|path| !holds_outlines(path) && !holds_model(path)), Channel::Texture),
        (args.pattern.as_deref(), Channel::Pattern(only)),
        (args.labels.as_deref(), Channel::Labels),
        (args.mask.as_deref(), Channel::Mask),
    ];
    pictures.into_iter().filter_map(|(path, channel)| Some((path?, channel)))
}

/// Checks whether all requested pictures can be written at `size` px, before the growth starts.
pub fn check(args: &Args, size: [usize; 2]) -> Result<(), Error> {
    let style = args.look.style();
    for (path, channel) in requested(args) {
        let format = check_picture(&style, path, channel, size).map_err(Error::step)?;
        memory::check_picture(size, format.writer_bytes_per_px(), Some(free_memory()))
            .map_err(Error::step)?;
    }
    if let Some(path) = &args.concentrations {
        files::check_content(path, Content::Channels).map_err(Error::step)?;
    }
    args.material.check(size)
}

/// Writes all requested pictures under temporary names.
pub fn prepare(
    args: &Args,
    document: &Document,
    grown: &Grown,
    extent: Extent,
    watch: &Watch,
) -> Result<Vec<Prepared>, Error> {
    let painting = Painting::new(document, grown, extent.scale as usize);
    let refined = grown.settings.refine.unwrap_or(document.growth.refine);
    let style = args.look.style_for(document, refined, extent);
    let mut prepared = requested(args)
        .map(|(path, channel)| painting.prepare(path, channel, &style, watch).map_err(Error::exported))
        .collect::<Result<Vec<_>, _>>()?;
    if let Some(path) = &args.concentrations {
        let file = prepare_concentrations(grown, path, painting.size, style.dpi, watch);
        prepared.push(file.map_err(Error::exported)?);
    }
    prepared.extend(args.material.prepare(&painting, document, &args.file, extent, &style, watch)?);
    Ok(prepared)
}
