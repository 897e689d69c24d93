//! The pictures of a growth: the texture, the pattern, the labels.

use super::Args;
use crate::cli::Error;
use crate::export::Prepared;
use crate::export::png::Samples;
use crate::synth::painting::Painting;
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
    let texture = painting.prepare(&args.output, (Samples::Rgb8, dpi), watch, |band, rgb| band.paint(rgb));
    let mut pictures = vec![texture.map_err(Error::exported)?];
    if let Some(path) = &args.pattern {
        let only = args.layer.map(|layer| layer as usize - 1);
        let pattern =
            painting.prepare(path, (Samples::Gray16, dpi), watch, |band, gray| band.pattern(only, gray));
        pictures.push(pattern.map_err(Error::exported)?);
    }
    if let Some(path) = &args.labels {
        let labels = painting.prepare(path, (Samples::Gray8, dpi), watch, |band, labels| band.labels(labels));
        pictures.push(labels.map_err(Error::exported)?);
    }
    Ok(pictures)
}
