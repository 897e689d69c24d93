//! `dapple grow`: a document → its texture.

use super::{Error, values};
use crate::synth::recipe::Document;
use std::path::PathBuf;

/// What to grow, how, and where to write it.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The document to grow
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Where to write the picture
    #[arg(short, long, value_name = "OUT.png")]
    pub output: PathBuf,
    /// More texture: a canvas of W x H px with features of the same size
    #[arg(long, value_name = "WxH", value_parser = values::size)]
    pub size: Option<[u32; 2]>,
    /// The same texture with K times the px along each side
    #[arg(long, value_name = "K", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=64))]
    pub scale: u32,
    /// Use this seed instead of the document's
    #[arg(long, value_name = "N")]
    pub seed: Option<u64>,
    /// Also write the pattern: 16-bit gray, 0 = ground, half = a mark's edge
    #[arg(long, value_name = "P.png")]
    pub pattern: Option<PathBuf>,
    /// Write the pattern of layer K alone (1 = the lowest)
    #[arg(
        long, value_name = "K", requires = "pattern",
        value_parser = clap::value_parser!(u32).range(1..=255)
    )]
    pub layer: Option<u32>,
    /// Also write which layer's mark covers each px: 8-bit gray, 0 = none
    #[arg(long, value_name = "L.png")]
    pub labels: Option<PathBuf>,
    /// Also write what was asked and what has grown, as JSON
    #[arg(long, value_name = "R.json")]
    pub report: Option<PathBuf>,
    /// Take the parameters as looked up; do not correct them by what has grown
    #[arg(long)]
    pub no_refine: bool,
    /// Use the training sets in this folder instead of those built in
    #[arg(long, value_name = "DIR")]
    pub training: Option<PathBuf>,
    /// Threads to use [default: all cores]
    #[arg(long, value_name = "N", value_parser = values::threads)]
    pub threads: Option<usize>,
    /// Show no progress
    #[arg(short, long)]
    pub quiet: bool,
}

impl Args {
    /// Refuses to write two things to one file, or to write over the document.
    ///
    /// # Errors
    /// [`Error::Usage`] that names the file.
    pub fn check_outputs(&self) -> Result<(), Error> {
        let named = [
            ("FILE", Some(&self.file)),
            ("--output", Some(&self.output)),
            ("--pattern", self.pattern.as_ref()),
            ("--labels", self.labels.as_ref()),
            ("--report", self.report.as_ref()),
        ];
        let paths: Vec<_> = named.into_iter().filter_map(|(name, path)| Some((name, path?))).collect();
        for (i, (name, path)) in paths.iter().enumerate() {
            if let Some((other, _)) = paths[..i].iter().find(|(_, other)| other == path) {
                let file = path.display();
                return Err(Error::Usage(format!(
                    "{name} and {other}: found {file} twice; allowed: two files"
                )));
            }
        }
        Ok(())
    }
}

/// Grows a document.
///
/// # Errors
/// Where the document is not valid, cannot be grown, or a file cannot be written.
pub fn run(args: &Args) -> Result<(), Error> {
    args.check_outputs()?;
    let _document = Document::read(&args.file)?;
    Err(Error::Missing("grow"))
}
