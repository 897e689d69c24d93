//! The pictures of a growth: the texture, the pattern, the labels.

use super::Args;
use super::outlines::holds_outlines;
use crate::cli::Error;
use crate::export::Prepared;
use crate::synth::painting::{Channel, Painting};
use crate::synth::recipe::Document;
use crate::synth::{Grown, Watch};

/// Writes all pictures that were asked for, none of which has its name yet.
pub fn prepare(
    args: &Args,
    document: &Document,
    grown: &Grown,
    watch: &Watch,
) -> Result<Vec<Prepared>, Error> {
    let painting = Painting::of(document, grown, args.scale as usize);
    let dpi = document.dpi * f64::from(args.scale);
    let only = args.layer.map(|layer| layer as usize - 1);
    let pictures = [
        (args.output.as_ref().filter(|path| !holds_outlines(path)), Channel::Texture),
        (args.pattern.as_ref(), Channel::Pattern(only)),
        (args.labels.as_ref(), Channel::Labels),
    ];
    let asked = pictures.into_iter().filter_map(|(path, channel)| Some((path?, channel)));
    asked
        .map(|(path, channel)| painting.prepare(path, channel, dpi, watch).map_err(Error::exported))
        .collect()
}
