//! Folders that are written as a whole.

use std::path::Path;

use super::abandon::naming;
use super::save::{explain, folder_of};
use super::stale_files::new_folder;
use crate::export::ExportError;
use crate::machine::fs;

/// Writes a folder with these files: into a temporary folder beside it, which is renamed once all files are complete. Where another
/// process has written the folder meanwhile, its files are kept.
///
/// # Errors
/// The problem, with the folder's name and the remedy.
pub fn write_folder(path: &Path, files: &[(&str, Vec<u8>)]) -> Result<(), ExportError> {
    let parent = folder_of(path);
    let wrong = |source| explain(path, &parent, source);
    let (folder, lock) = new_folder(&parent).map_err(wrong)?;
    for (name, bytes) in files {
        fs::write(folder.path().join(name), bytes).map_err(wrong)?;
    }
    naming(|| {
        if fs::is_dir(path) {
            return Ok(());
        }
        let named = fs::rename(folder.path(), path);
        // Another process may have been faster.
        if named.is_err() && fs::is_dir(path) { Ok(()) } else { named }
    })
    .map_err(wrong)?;
    drop(lock);
    // Deletes the temporary folder, if it is still there.
    drop(folder);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_is_written_whole_and_one_that_is_there_is_kept() {
        let place = tempfile::tempdir().unwrap();
        let path = place.path().join("item");
        write_folder(&path, &[("a.txt", b"one".to_vec()), ("b.txt", b"two".to_vec())]).unwrap();
        write_folder(&path, &[("a.txt", b"other".to_vec())]).unwrap();
        assert_eq!(fs::read(path.join("a.txt")).unwrap(), b"one");
        assert_eq!(fs::read(path.join("b.txt")).unwrap(), b"two");
        // Nothing temporary is left.
        assert_eq!(fs::read_dir(place.path()).unwrap().count(), 1);
        let error = write_folder(&place.path().join("no/item"), &[]).unwrap_err();
        assert!(error.to_string().contains("no"), "{error}");
    }
}
