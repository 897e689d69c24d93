//! The maps of a texture in files.

use std::path::Path;

use super::save::{Prepared, Unfinished, begin};
use crate::export::ExportError;
use crate::export::material::{Failed, Map, Set};
use crate::synth::Watch;
use crate::synth::body::Texture;

/// Writes some of the `maps` of a texture into a folder under temporary names; their final names begin with that of the `set`.
///
/// # Errors
/// A file cannot be written; or it was cancelled.
pub fn prepare_maps(
    texture: &Texture,
    folder: &Path,
    set: &Set,
    maps: &[Map],
    watch: &Watch,
) -> Result<Vec<Prepared>, ExportError> {
    let paths = maps.iter().map(|map| folder.join(map.file(set.name)));
    let mut files = paths.map(|path| begin(&path)).collect::<Result<Vec<_>, _>>()?;
    if let Err(Failed { at, why }) = texture.write(&mut files, set, maps, watch) {
        // The error names the file that failed; the others are deleted too.
        return Err(files.swap_remove(at).stopped(why));
    }
    files.into_iter().map(Unfinished::finish).collect()
}
