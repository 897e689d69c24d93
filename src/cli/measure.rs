//! `dapple measure`: a picture → the attributes of its spots or stripes.

use super::Error;
use std::path::PathBuf;

/// What to measure.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The picture
    #[arg(value_name = "IMAGE")]
    pub image: PathBuf,
    /// Take the larger phase for the marks instead of the smaller one
    #[arg(long)]
    pub invert: bool,
    /// Answer in JSON
    #[arg(long)]
    pub json: bool,
}

/// Measures a picture.
///
/// # Errors
/// Where the picture cannot be read or has neither spots nor stripes.
pub fn run(args: &Args) -> Result<(), Error> {
    let _ = args;
    Err(Error::Missing("measure"))
}
