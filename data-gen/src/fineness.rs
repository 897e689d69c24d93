//! Measures the effect of a coarse mesh on spots: their area ÷ spacing² and their aspect, for several numbers of
//! vertices per spacing.

mod lattice;
mod patch;
mod rows;

use std::io::Write;
use std::path::PathBuf;

use dapple::files;

/// Where to write the table.
#[derive(clap::Args)]
pub struct Args {
    /// The rows
    #[arg(short, long, value_name = "OUT.csv", default_value = "training/fineness.csv")]
    output: PathBuf,
}

/// Grows all patches and writes their rows.
pub fn run(args: &Args) -> Result<(), String> {
    let mut text = String::from(rows::HEADER);
    for patch in rows::patches() {
        text.push_str(&rows::of_patch(patch).ok_or("spots do not grow on surfaces")?);
        crate::say(&format!("{patch:?}"))?;
    }
    files::save(&args.output, |out| Ok(out.write_all(text.as_bytes())?)).map_err(|error| error.to_string())
}
