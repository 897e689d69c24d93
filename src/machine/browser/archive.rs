//! Packs a folder into one file, because browsers only save files.

use std::io::{self, Seek, Write};
use std::path::Path;

use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

use super::fs;

/// Writes the files of a folder as a ZIP archive, each with the folder's name before its own. They are pictures, which are compressed
/// already.
///
/// # Errors
/// The folder is missing, or the archive does not fit.
pub fn write(folder: &Path, out: impl Write + Seek) -> io::Result<()> {
    let stored = SimpleFileOptions::default().compression_method(CompressionMethod::Stored);
    let name = folder.file_name().unwrap_or_default().to_string_lossy();
    let mut archive = ZipWriter::new(out);
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        archive.start_file(format!("{name}/{}", entry.file_name().to_string_lossy()), stored)?;
        archive.write_all(&fs::read(entry.path())?)?;
    }
    archive.finish()?;
    Ok(())
}
