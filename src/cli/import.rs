//! `dapple import`: a drawing or a photograph → a document.

use super::json::print_json;
use super::{Error, values};
use crate::document::Stop;
use crate::files::{self, WriteFile, import_photo, import_svg, is_svg};
use crate::finish::Kind as FinishKind;
use crate::photo::{Corners, Crop, Limits, Wanted};
use crate::synth::import::measured_picture::Framing;
use crate::synth::import::photo::{ImportedPhoto, PhotoOptions};
use crate::synth::import::svg::{ImportError, Imported};
use serde_json::{Value, json};
use std::path::PathBuf;

/// Arguments of `dapple import`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// An SVG, whose ellipses, circles, lines, rectangles and paths become marks and whose groups become layers; or a
    /// photograph of spots or stripes (JPEG, PNG, WebP, TIFF), from which a sketch is made
    #[arg(value_name = "IN")]
    pub file: PathBuf,
    /// Where to write the document
    #[arg(short, long, value_name = "OUT.dapple")]
    pub output: PathBuf,
    /// Resolution of the canvas, px per inch [default: for an SVG 96 (its size is in mm, or in px of 1/96 inch); for
    /// outlines that dapple wrote, the dpi of their document; for a photograph what it says, or else 300]
    #[arg(long, value_name = "N", value_parser = values::dpi)]
    pub dpi: Option<f64>,
    /// Photograph: columns and rows of regions [default: as few as describe how the marks change]
    #[arg(long, value_name = "CxR", value_parser = values::regions, help_heading = "Photographs")]
    pub regions: Option<[usize; 2]>,
    /// Photograph: draw all marks, without regions, instead of a few that represent them
    #[arg(long, conflicts_with = "regions", help_heading = "Photographs")]
    pub all_marks: bool,
    /// Photograph: number of sizes of spots that become separate layers [default: 2 where large and small spots are
    /// clearly different]
    #[arg(long, value_name = "N", value_parser = values::whole(1..=2u8), help_heading = "Photographs")]
    pub layers: Option<u8>,
    /// Photograph: read a 16-bit gray picture from black to white as an ordinary picture, not as a pattern that dapple
    /// wrote
    #[arg(long, help_heading = "Photographs")]
    pub no_pattern: bool,
    /// Photograph: the marks are the part that covers more of the picture, not the part that covers less
    #[arg(long, help_heading = "Photographs")]
    pub invert: bool,
    /// Photograph: where the edge of a mark lies, from 0 (the tone of the ground) to 1 (that of the marks); the lower,
    /// the larger the marks [default: about where the picture changes most]
    #[arg(long, value_name = "N", value_parser = values::edge_level, help_heading = "Photographs")]
    pub level: Option<f32>,
    /// Photograph: smallest area of a mark, px²; smaller ones are left out [default: 5 % of the usual area]
    #[arg(long, value_name = "AREA", value_parser = values::positive, help_heading = "Photographs")]
    pub smallest: Option<f64>,
    /// Photograph: make a sketch although it shows neither spots nor stripes
    #[arg(long, help_heading = "Photographs")]
    pub take_it: bool,
    /// Photograph: read only this part, px from the upper left corner (after --corners, if that is given)
    #[arg(long, value_name = "X,Y,W,H", value_parser = values::crop, help_heading = "Photographs")]
    pub crop: Option<Crop>,
    /// Photograph: make a rectangle of the part between four corners: upper left, upper right, lower right, lower left,
    /// px
    #[arg(long, value_name = "X,Y,X,Y,X,Y,X,Y", value_parser = values::corners, help_heading = "Photographs")]
    pub corners: Option<Corners>,
    /// Photograph: the finish of the document, such as fur; hair lies as in the photograph, where its fine detail has a
    /// direction [default: none]
    #[arg(long, value_name = "KIND", value_parser = values::finish, help_heading = "Photographs")]
    pub finish: Option<FinishKind>,
    /// Print what was read as one JSON object
    #[arg(long)]
    pub json: bool,
    /// Do not print a note about what was read
    #[arg(short, long)]
    pub quiet: bool,
}

/// Reads the drawing or the photograph and writes the document.
///
/// # Errors
/// It cannot be read or has no marks, or the document cannot be written.
pub fn run(args: &Args) -> Result<(), Error> {
    if args.json && files::is_standard_output(&args.output) {
        return Err(Error::Usage(
            "--json and --output: found standard output twice; allowed: a file for one of them".to_owned(),
        ));
    }
    super::paths::check_apart("IN", &args.file, &args.output)?;
    files::check_ending(&args.output, &["dapple"]).map_err(Error::step)?;
    let unreadable = |source| Error::File { file: args.file.display().to_string(), done: "read", source };
    let (summary, notes, json) =
        if is_svg(&args.file).map_err(unreadable)? { drawing(args)? } else { photograph(args)? };
    if args.json {
        print_json(json)?;
    } else if !args.quiet {
        super::note(&format!("{}: {summary}", args.file.display()));
        notes.iter().for_each(|text| super::note(&format!("{}: {text}", args.file.display())));
    }
    Ok(())
}

/// Writes the document of an SVG; returns a description of what was read, as text and as JSON.
fn drawing(args: &Args) -> Result<(String, Vec<String>, Value), Error> {
    let of_photographs = [
        ("--regions", args.regions.is_some()),
        ("--all-marks", args.all_marks),
        ("--layers", args.layers.is_some()),
        ("--no-pattern", args.no_pattern),
        ("--invert", args.invert),
        ("--level", args.level.is_some()),
        ("--smallest", args.smallest.is_some()),
        ("--take-it", args.take_it),
        ("--crop", args.crop.is_some()),
        ("--corners", args.corners.is_some()),
        ("--finish", args.finish.is_some()),
    ];
    if let Some((option, _)) = of_photographs.iter().find(|(_, given)| *given) {
        let file = args.file.display();
        return Err(Error::Usage(format!("{option}: {file} is an SVG; allowed: with a photograph")));
    }
    let imported = import_svg(&args.file, args.dpi).map_err(|error| match error {
        ImportError::Unreadable { file, source } => Error::File { file, done: "read", source },
        other => Error::step(other),
    })?;
    imported.document.write(&args.output)?;
    let json = of_drawing(args, &imported);
    Ok((imported.summary, Vec::new(), json))
}

/// Writes the document of a photograph; returns a description of what was read, as text and as JSON.
fn photograph(args: &Args) -> Result<(String, Vec<String>, Value), Error> {
    let options = PhotoOptions {
        framing: Framing {
            invert: args.invert,
            crop: args.crop,
            corners: args.corners,
            no_pattern: args.no_pattern,
            limits: Limits { level: args.level, smallest: args.smallest, ..Limits::default() },
        },
        wanted: Wanted {
            regions: args.regions,
            layers: args.layers.map(usize::from),
            all_marks: args.all_marks,
        },
        take_it: args.take_it,
        finish: args.finish,
    };
    let mut imported = import_photo(&args.file, &options).map_err(Error::step)?;
    if let Some(dpi) = args.dpi {
        imported.document.dpi = dpi;
    }
    imported.document.write(&args.output)?;
    let json = of_photograph(args, &imported);
    Ok((imported.summary, imported.notes, json))
}

/// What was read of a drawing, as JSON.
fn of_drawing(args: &Args, Imported { document, unread, ground, .. }: &Imported) -> Value {
    let layers =
        document.layers.iter().map(|layer| json!({"name": layer.name, "marks": layer.strokes.len()}));
    let marks: usize = document.layers.iter().map(|layer| layer.strokes.len()).sum();
    json!({
        "file": args.file.display().to_string(), "document": args.output.display().to_string(),
        "size": document.size, "dpi": document.dpi, "marks": marks, "layers": layers.collect::<Vec<_>>(),
        "unread": unread, "ground": ground.map(|ground| Stop::opaque(0.0, ground).hex()),
    })
}

/// What was read of a photograph, as JSON.
fn of_photograph(args: &Args, imported: &ImportedPhoto) -> Value {
    let document = &imported.document;
    let layers = document
        .layers
        .iter()
        .zip(&imported.found)
        .map(|(layer, found)| json!({"name": layer.name, "marks": layer.strokes.len(), "found": found}));
    let marks: usize = document.layers.iter().map(|layer| layer.strokes.len()).sum();
    json!({
        "file": args.file.display().to_string(), "document": args.output.display().to_string(),
        "kind": imported.kind, "size": document.size, "dpi": document.dpi, "regions": document.regions,
        "marks": marks, "layers": layers.collect::<Vec<_>>(),
        "neither": imported.neither.map(|why| why.to_string()),
        "notes": imported.notes,
    })
}
