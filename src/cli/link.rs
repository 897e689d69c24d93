//! `dapple link FILE`: a link that holds a document.

use super::settings::Settings;
use super::{Error, note, print};
use crate::document::link::{SHORT, SITE};
use std::path::PathBuf;

/// Arguments of `dapple link`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The document, or a PNG that holds one
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    #[command(flatten)]
    pub settings: Settings,
    /// The address of the window on the web; "" prints only the part of the link after #
    #[arg(long, value_name = "ADDRESS", default_value = SITE)]
    pub site: String,
}

/// Prints the link.
///
/// # Errors
/// The document cannot be read, or is not for a link.
pub fn run(args: &Args) -> Result<(), Error> {
    let (document, _) = args.settings.open(&args.file)?;
    let fragment = document.fragment().map_err(Error::step)?;
    let long = fragment.len();
    if long > SHORT {
        note(&format!(
            "the document takes {long} characters; some programs cut links after {SHORT}: send the file instead"
        ));
    }
    print(&format!("{}{fragment}\n", args.site))
}
