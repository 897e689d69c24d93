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
use std::path::Path;

use dapple::files;
use rayon::prelude::*;

use crate::files::make_folder;
use effect::Effect;
use grown::Grown;
use table::{Pair, Row, Table};

/// The page.
const PAGE: &str = "docs/keys.md";
/// The folder of its pictures.
const PICTURES: &str = "assets/keys";

/// Grows all pairs, and writes their pictures and the page, at the root of the repository.
pub fn run() -> Result<(), String> {
    let table = Table::built_in()?;
    let folder = Path::new(PICTURES);
    make_folder(folder)?;
    let rows: Vec<Row> = table.rows().collect();
    let effect = |row: &Row| -> Result<Effect, String> {
        let effect = shown(&table, row, folder)?;
        crate::say(&format!("{}: {effect}", row.name()))?;
        Ok(effect)
    };
    let effects: Vec<_> = rows.par_iter().map(effect).collect();
    let failed: Vec<&str> =
        effects.iter().filter_map(|effect| effect.as_ref().err().map(String::as_str)).collect();
    if !failed.is_empty() {
        return Err(failed.join("\n"));
    }
    let effects: Vec<Effect> = effects.into_iter().flatten().collect();
    let text = page::text(&table, &rows, &effects);
    files::save(Path::new(PAGE), |out| Ok(out.write_all(text.as_bytes())?)).map_err(|error| error.to_string())
}

/// Grows a pair, writes its pictures into a folder and measures them.
fn shown(table: &Table, row: &Row, folder: &Path) -> Result<Effect, String> {
    let failed = |error: String| format!("{}: {error}", row.file());
    let grown = |which: usize| -> Result<Grown, String> {
        Grown::new(&document::parsed(&table.document(row, which)?, "its document")?)
    };
    let pair = [grown(0).map_err(failed)?, grown(1).map_err(failed)?];
    sheet::write(&folder.join(row.file()), &pair)?;
    let Pair { shows, .. } = row.pair;
    Effect::new(shows, row.layer(), &pair).map_err(failed)
}
