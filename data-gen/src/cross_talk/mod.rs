//! Cross-talk: one attribute of a sketch is changed, and all attributes of what grows are measured. Beside it a plain simulation of the
//! Gray–Scott model, whose parameters are changed likewise. And each key of a document is changed, with pictures.

mod effect;
mod gray_scott;
mod page;
mod subjects;

use std::io::Write;
use std::path::PathBuf;

use dapple::files;
use rayon::prelude::*;

use crate::keys;
use effect::{Effects, Measured};
use subjects::{SUBJECTS, Subject};

/// How many growths, and where to write the pages.
#[derive(clap::Args)]
pub struct Args {
    /// Write one of the two pages; that of the keys, docs/keys.md with assets/keys, at the root of the repository
    #[arg(long)]
    only: Option<Page>,
    /// Seeds for each value
    #[arg(long, default_value_t = 20)]
    seeds: u64,
    /// The page of the attributes
    #[arg(short, long, value_name = "OUT.md", default_value = "docs/cross-talk.md")]
    output: PathBuf,
}

/// A page.
#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Page {
    /// What else changes with an attribute
    Attributes,
    /// What each key changes
    Keys,
}

/// The factors by which an attribute is multiplied. Directions are turned by 90° × (factor − 1).
const FACTORS: [f64; 2] = [0.8, 1.2];

/// Grows all and writes the pages.
pub fn run(args: &Args) -> Result<(), String> {
    if args.only != Some(Page::Keys) {
        attributes(args)?;
    }
    if args.only != Some(Page::Attributes) {
        keys::run()?;
    }
    Ok(())
}

/// Writes the page of the attributes.
fn attributes(args: &Args) -> Result<(), String> {
    let mut matrices = Vec::new();
    for subject in &SUBJECTS {
        crate::say(subject.title)?;
        matrices.push((subject, matrix(subject, args.seeds)?));
    }
    crate::say("Gray–Scott")?;
    let plain = gray_scott::matrix(args.seeds);
    let text = page::text(&matrices, &plain, args.seeds);
    files::save(&args.output, |out| Ok(out.write_all(text.as_bytes())?)).map_err(|error| error.to_string())
}

/// Rows: the attribute that is changed; columns: those that are measured.
fn matrix(subject: &Subject, seeds: u64) -> Result<Vec<Effects>, String> {
    let row = |knob: usize| {
        let grown = |seed: u64| -> Result<[Measured; 2], String> {
            let [low, high] = FACTORS.map(|factor| subject.grown(Some((knob, factor)), seed));
            Ok([low?, high?])
        };
        let pairs: Result<Vec<_>, String> = (1..=seeds).into_par_iter().map(grown).collect();
        Ok(Effects::new(subject.attributes, &pairs?))
    };
    (0..subject.attributes.len()).map(row).collect()
}
