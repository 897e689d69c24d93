//! Pictures of heights in files.

use std::io::BufReader;
use std::path::Path;
use std::sync::Arc;

use crate::document::{Document, ParametricSurface};
use crate::machine::fs::File;
use crate::photo::{decode, heights};

/// Reads the heights that a document in the file `document` names. Where that fails the document keeps the reason, which is told when it is grown.
pub fn read_heights(document: &mut Document, file: &Path) {
    let Some(ParametricSurface::Heights(relief)) = &mut document.parametric else { return };
    let path = file.parent().unwrap_or(Path::new("")).join(&relief.path);
    let shown = path.display();
    relief.heights = (|| {
        let opened = File::open(&path).map_err(|error| format!("{shown}, which cannot be read ({error})"))?;
        let decoded = decode(&mut BufReader::new(opened))
            .map_err(|error| format!("{shown}, which is no picture that can be read ({error})"))?;
        let found =
            heights(&decoded).ok_or_else(|| format!("{shown}, which has heights that are no numbers"))?;
        Ok(Arc::new(found))
    })();
}
