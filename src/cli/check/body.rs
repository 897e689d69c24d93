//! `dapple check` of a document with a model.

use std::fmt::Write;

use serde_json::json;

use super::{Args, summary};
use crate::cli::json::print_json;
use crate::cli::{self, Error};
use crate::document::Document;
use crate::files::read_model;
use crate::synth::Options;
use crate::synth::body::describe;

/// Prints what will grow on the model; `notes` are those on the sketch.
pub fn run(args: &Args, document: &Document, options: &Options, notes: Vec<String>) -> Result<(), Error> {
    let Some(body) = &document.model else { return Ok(()) };
    let model = read_model(&args.file, body, None)?;
    let bytes = model.as_ref().map(|model| model.bytes.as_slice());
    let mut described = describe(document, bytes, options).map_err(Error::grown)?;
    if model.as_ref().is_some_and(|model| model.is_changed) {
        described
            .notes
            .push(format!("{} is not the file that it was when the document was made", body.source));
    }
    described.notes.extend(notes);
    if args.json {
        print_json(
            json!({"document": options.source, "valid": described.refusal.is_none(), "name": document.name,
            "size": document.size, "seed": document.seed, "body": described.json, "notes": described.notes}),
        )?;
    } else {
        let verdict = if described.refusal.is_none() { "valid" } else { "cannot be grown" };
        let mut text = format!("{}: {verdict}\n{}{}", options.source, summary(document), described.text);
        for note in &described.notes {
            // Writing to a String cannot fail.
            let _ = writeln!(text, "{note}");
        }
        cli::print(&text)?;
    }
    described.refusal.map_or(Ok(()), |refusal| Err(Error::grown(refusal)))
}
