//! The rows of a system in a folder of training sets.

use std::io;

use super::TrainingError;
use super::folder::Folder;
use super::manifest::Manifest;
use crate::attributes::system::Description;

/// The files of `system` in `folder`, by name; `known` are all existing systems.
fn files_of(
    folder: &dyn Folder,
    system: &str,
    known: &[&'static Description],
) -> Result<Vec<String>, TrainingError> {
    let dir = folder.path();
    let is_of = |stem: &str, system: &str| {
        let set = stem.strip_prefix(system);
        set.is_some_and(|set| set.is_empty() || set.starts_with('-')) && !stem.ends_with(".rejected")
    };
    let (mut names, mut others) = (Vec::new(), Vec::new());
    let all = folder.names().map_err(|source| TrainingError::Open { path: dir.to_owned(), source })?;
    for name in all {
        let Some(stem) = name.strip_suffix(".csv") else { continue };
        others.extend(known.iter().map(|other| other.name).filter(|other| is_of(stem, other)));
        if is_of(stem, system) {
            names.push(name);
        }
    }
    others.sort_unstable();
    others.dedup();
    names.sort();
    if names.is_empty() {
        return Err(TrainingError::NoFiles { dir: dir.to_owned(), system: system.to_owned(), others });
    }
    Ok(names)
}

/// The rows of `system` in `folder`, which `read` converts from a file's name and bytes, and the names of the files; see
/// [`super::TrainingSet::load`].
pub(super) fn rows_of_folder<T>(
    folder: &dyn Folder,
    system: &'static Description,
    known: &[&'static Description],
    read: impl Fn(&str, &[u8]) -> Result<Vec<T>, TrainingError>,
) -> Result<(Vec<T>, Vec<String>), TrainingError> {
    let (mut rows, mut names) = (Vec::new(), Vec::new());
    for file in files_of(folder, system.name, known)? {
        let path = folder.path().join(&file);
        let manifest = Manifest::beside(folder, &file)?;
        let name = path.display().to_string();
        let bytes = folder.read(&file).and_then(|bytes| bytes.ok_or(io::ErrorKind::NotFound.into()));
        let bytes = bytes.map_err(|source| TrainingError::Open { path, source })?;
        let of_file = read(&name, &bytes)?;
        manifest.map_or(Ok(()), |manifest| manifest.check(&name, of_file.len()))?;
        rows.extend(of_file);
        names.push(name);
    }
    Ok((rows, names))
}
