//! `dapple measure IMAGE`: the attributes of the spots or stripes in a picture.

use super::json::known;
use super::{Error, note, print, values};
use crate::attributes::Attribute;
use crate::files::{measure_file, measure_patches};
use crate::measure::Picture;
use crate::photo::{Crop, Limits};
use crate::synth::import::measured_picture::{Framing, MeasuredPicture};
use serde_json::{Map, Value, json};
use std::path::PathBuf;

/// Attributes of the spots or stripes in a picture.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// The picture (PNG, JPEG, WebP, TIFF, BMP, GIF); - is standard input.
    pub image: PathBuf,
    /// Measure the part that covers more of the picture, not the part that covers less.
    #[arg(long)]
    pub invert: bool,
    /// Read only this part, px from the upper left corner
    #[arg(long, value_name = "X,Y,W,H", value_parser = values::crop)]
    pub crop: Option<Crop>,
    /// Smallest area of a mark, px²; smaller ones are left out [default: 5 % of the usual area]
    #[arg(long, value_name = "AREA", value_parser = values::positive)]
    pub smallest: Option<f64>,
    /// Read a 16-bit gray picture from black to white as an ordinary picture, not as a pattern that dapple wrote
    #[arg(long)]
    pub no_pattern: bool,
    /// The marks are patches: spots with outlines of any shape.
    #[arg(long)]
    pub patches: bool,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Measures the picture and prints the attributes.
///
/// # Errors
/// The picture cannot be read, or has neither spots nor stripes.
pub fn run(args: &Args) -> Result<(), Error> {
    let measured = if args.patches { measure_patches } else { measure_file };
    let limits = Limits { smallest: args.smallest, ..Limits::default() };
    let framing =
        Framing { invert: args.invert, crop: args.crop, limits, no_pattern: args.no_pattern, corners: None };
    let MeasuredPicture { picture, notes } = measured(&args.image, &framing).map_err(Error::step)?;
    if args.json {
        let mut object = as_json(&picture);
        if !notes.is_empty() {
            object["notes"] = json!(notes);
        }
        return print(&format!("{}\n", known(object)));
    }
    notes.iter().for_each(|text| note(&format!("{}: {text}", args.image.display())));
    print(&as_text(&picture))
}

/// The JSON object of `measure --json` (`docs/format.md`), with the keys that apply.
fn as_json(found: &Picture) -> Value {
    match found {
        Picture::Spots { marks, got, spread, raggedness } => {
            let mut object = Map::new();
            object.insert("kind".into(), json!("spots"));
            object.insert("marks".into(), json!(marks));
            object.insert("area".into(), json!(got.area));
            object.insert("aspect".into(), json!(got.aspect));
            object.insert("angle".into(), json!(got.angle));
            let mut spreads = Map::new();
            for (attribute, value) in spread.named() {
                if attribute != Attribute::Spacing || got.spacing.is_some() {
                    spreads.insert(attribute.name().into(), json!(value));
                }
            }
            if let Some(spacing) = got.spacing {
                object.insert("spacing".into(), json!(spacing));
            }
            object.insert("spread".into(), Value::Object(spreads));
            if let Some(raggedness) = raggedness {
                object.insert("raggedness".into(), json!(raggedness));
            }
            Value::Object(object)
        }
        Picture::Stripes { marks, got } => json!({
            "kind": "stripes",
            "marks": marks,
            "width": got.width,
            "angle": got.angle,
            "wavelength": got.wavelength,
            "coherence": got.coherence,
        }),
    }
}

fn as_text(found: &Picture) -> String {
    match found {
        Picture::Spots { marks, got, spread, raggedness } => {
            let spacing = |spacing| format!("{spacing:.2} px (varies by {:.0} %)", 100.0 * spread.spacing);
            let spacing = got.spacing.map_or_else(|| "-".to_owned(), spacing);
            let ragged = raggedness.map_or_else(|| "-".to_owned(), |ragged| format!("{ragged:.2}"));
            format!(
                "spots    {marks} whole\narea     {:.2} px² (varies by {:.0} %)\naspect   {:.3} (by {:.3})\nangle    {:.1}° (by {:.1}°)\nspacing  {spacing}\nragged   {ragged}\n",
                got.area,
                100.0 * spread.area,
                got.aspect,
                spread.aspect,
                got.angle,
                spread.angle,
            )
        }
        Picture::Stripes { marks, got } => format!(
            "stripes     {marks}\nwidth       {:.2} px\nangle       {:.1}°\nwavelength  {:.2} px\ncoherence   {:.2}\n",
            got.width, got.angle, got.wavelength, got.coherence,
        ),
    }
}
