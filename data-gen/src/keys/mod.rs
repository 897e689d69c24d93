//! What each key of a document changes: a small document is grown with two values of the key, and both pictures are measured.
//!
//! ```text
//!  pairs.json ─▶ table ─▶ document ─▶ grown ─▶ effect, sheet ─▶ page
//! ```

mod document;
mod effect;
mod grown;
mod page;
mod pictures;
mod place;
mod quantity;
mod sheet;
mod table;
#[cfg(test)]
mod tests;

use std::io::Write;
use std::path::{Path, PathBuf};

use dapple::files;
use rayon::prelude::*;

use crate::files::make_folder;
use effect::Effect;
use grown::Grown;
use table::{Pair, Row, Table};

/// Where to write.
#[derive(clap::Args)]
pub struct Args {
    /// The page of the keys
    #[arg(long = "keys", value_name = "KEYS.md", default_value = "docs/keys.md")]
    page: PathBuf,
    /// The folder of its pictures
    #[arg(long, value_name = "DIR", default_value = "assets/keys")]
    pictures: PathBuf,
}

/// Grows all pairs, and writes their pictures and the page.
pub fn run(args: &Args) -> Result<(), String> {
    let table = Table::built_in()?;
    make_folder(&args.pictures)?;
    let rows: Vec<Row> = table.rows().collect();
    let effects: Vec<_> = rows.par_iter().map(|row| shown(&table, row, &args.pictures)).collect();
    let failed: Vec<&str> =
        effects.iter().filter_map(|effect| effect.as_ref().err().map(String::as_str)).collect();
    if !failed.is_empty() {
        return Err(failed.join("\n"));
    }
    let effects: Vec<Effect> = effects.into_iter().flatten().collect();
    let text = page::text(&table, &rows, &effects);
    files::save(&args.page, |out| Ok(out.write_all(text.as_bytes())?)).map_err(|error| error.to_string())
}

/// Grows a pair, writes its pictures into a folder and measures them.
fn shown(table: &Table, row: &Row, folder: &Path) -> Result<Effect, String> {
    let failed = |error: String| format!("{}: {error}", row.file());
    let grown = |which: usize| -> Result<Grown, String> {
        Grown::new(&document::parsed(&table.document(row, which)?, &row.file())?)
    };
    let pair = [grown(0).map_err(failed)?, grown(1).map_err(failed)?];
    sheet::write(&folder.join(row.file()), &pair)?;
    let Pair { shows, .. } = row.pair;
    let effect = Effect::new(shows, row.layer(), &pair).map_err(failed)?;
    crate::say(&format!("{}: {effect}", row.name()))?;
    Ok(effect)
}
