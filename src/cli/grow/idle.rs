//! Options that have no effect on the files that are written.

use std::path::Path;

use super::outlines::{self, holds_outlines};
use super::{Args, batch};
use crate::cli::values::StylePart;
use crate::export::{Format, has_ending};

/// One note for each given option that changes none of the files that are written.
pub fn notes(args: &Args) -> Vec<String> {
    let texture = match &args.output {
        _ if batch::is_requested(args) => Some(Format::Png),
        Some(path) if !holds_outlines(path) => Format::from_path(path),
        _ => None,
    };
    let is_painted = texture.is_some() || args.material.material.is_some();
    let is_deep = args.material.material.is_some() || texture.is_some_and(Format::is_deep);
    let outlines = outlines::files(args);
    let is_drawn = |ending| outlines.iter().any(|path: &&Path| has_ending(path, ending));
    let has_svg = is_drawn("svg");
    let shows_pen = |part: &StylePart| match part {
        StylePart::Fill => false,
        StylePart::Stroke => has_svg,
        StylePart::Hatch { .. } => true,
    };
    let shows_pen = args.outlines.style.iter().any(shows_pen);
    let given = [
        ("--quality", args.look.quality.is_some() && texture != Some(Format::Jpeg), "a .jpg"),
        (
            "--no-document",
            args.look.no_document && texture != Some(Format::Png),
            "a .png, which holds the document",
        ),
        ("--depth", args.look.depth == 16 && !is_deep, "a .png, a .tif or a material"),
        ("--transparent", args.look.transparent && !is_painted, "a picture or a material"),
        ("--ground", args.outlines.ground && !has_svg, "an .svg"),
        ("--pen", args.outlines.pen.is_some() && !shows_pen, "--style hatch, and --style stroke in an .svg"),
    ];
    let idle = given.into_iter().filter(|(_, is_idle, _)| *is_idle);
    idle.map(|(option, _, files)| {
        format!("{option} has no effect on the files that are written; it is for {files}")
    })
    .collect()
}
