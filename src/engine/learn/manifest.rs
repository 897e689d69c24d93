//! The manifest `SET.json` that data-gen writes beside the rows `SET.csv`: checks their number and version. Rows without a
//! manifest are not checked.

use serde_json::Value;

use super::TrainingError;
use super::folder::Folder;

const FORMAT: &str = "dapple training set";
/// The newest version that is supported.
const VERSION: u64 = 1;

/// The content of a manifest.
pub(super) struct Manifest {
    /// Its path.
    file: String,
    /// Rows that were written.
    rows: u64,
}

impl Manifest {
    /// The manifest of the rows `csv` in `folder`; `None` if there is none.
    ///
    /// # Errors
    /// It is damaged, of another kind, or of a version that is not supported.
    pub fn beside(folder: &dyn Folder, csv: &str) -> Result<Option<Self>, TrainingError> {
        let name = format!("{}.json", csv.strip_suffix(".csv").unwrap_or(csv));
        let file = folder.path().join(&name).display().to_string();
        let wrong = |problem: String| TrainingError::Manifest { file: file.clone(), problem };
        let bytes = folder.read(&name).map_err(|error| wrong(format!("cannot be read: {error}")))?;
        let Some(bytes) = bytes else { return Ok(None) };
        let value: Value = serde_json::from_slice(&bytes)
            .map_err(|error| wrong(format!("it is damaged, line {}: {error}", error.line())))?;
        if value["format"] != FORMAT {
            return Err(wrong(format!("format: found {}; allowed: \"{FORMAT}\"", value["format"])));
        }
        match value["version"].as_u64() {
            Some(1..=VERSION) => {}
            Some(newer) if newer > VERSION => {
                return Err(wrong(format!(
                    "version: found {newer}, written by a newer data-gen; allowed: up to {VERSION}"
                )));
            }
            _ => return Err(wrong(format!("version: found {}; allowed: 1 to {VERSION}", value["version"]))),
        }
        let rows = value["counts"]["accepted"].as_u64();
        let rows = rows.ok_or_else(|| wrong("counts.accepted: the number of rows is missing".to_owned()))?;
        Ok(Some(Self { file, rows }))
    }

    /// Checks that the number of rows is the one that was written.
    ///
    /// # Errors
    /// The number of rows and the expected number.
    pub fn check(&self, csv: &str, rows: usize) -> Result<(), TrainingError> {
        if rows as u64 == self.rows {
            return Ok(());
        }
        let problem = format!("{csv} holds {rows} rows, and {} were written", self.rows);
        Err(TrainingError::Manifest { file: self.file.clone(), problem })
    }
}
