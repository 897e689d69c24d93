//! Pictures of a growth in files, under temporary names until they are complete.

use std::io::Write;
use std::path::Path;

use super::save::{Prepared, Unfinished, begin, check_content, prepare};
use crate::export::material::{Failed, Set};
use crate::export::{ExportError, Format};
use crate::machine::aside::aside;
use crate::synth::render::painting::{self, Channel, Making, Painting, Style, plane};
use crate::synth::{Grown, Watch};

/// Checks that a picture of `channel` and `size` px can be written to `path` in this `style`; returns its format.
///
/// # Errors
/// What is wrong with the path or its format, and the remedy.
pub fn check_picture(
    style: &Style,
    path: &Path,
    channel: Channel,
    size: [usize; 2],
) -> Result<Format, ExportError> {
    let format = check_content(path, channel.content())?;
    style.check(path, format, channel, size)?;
    Ok(format)
}

/// Pictures in files.
pub trait SavePicture {
    /// Writes a picture of `channel`, in the format of the ending of `path`, to a temporary file.
    ///
    /// # Errors
    /// The file cannot be written; or it was cancelled.
    fn prepare(
        &self,
        path: &Path,
        channel: Channel,
        style: &Style,
        watch: &Watch,
    ) -> Result<Prepared, ExportError>;

    /// Writes all maps of `set` and a glTF plane into the existing `folder`, as temporary files.
    ///
    /// # Errors
    /// A file cannot be written; or it was cancelled.
    fn prepare_material(
        &self,
        folder: &Path,
        set: &Set,
        making: &Making,
        watch: &Watch,
    ) -> Result<Vec<Prepared>, ExportError>;
}

impl SavePicture for Painting<'_> {
    fn prepare(
        &self,
        path: &Path,
        channel: Channel,
        style: &Style,
        watch: &Watch,
    ) -> Result<Prepared, ExportError> {
        let format = check_picture(style, path, channel, self.size)?;
        prepare(path, |out| self.write(out, format, channel, style, aside, watch))
    }

    fn prepare_material(
        &self,
        folder: &Path,
        set: &Set,
        making: &Making,
        watch: &Watch,
    ) -> Result<Vec<Prepared>, ExportError> {
        let paths = set.maps().into_iter().map(|map| folder.join(map.file(set.name)));
        let mut files = paths.map(|path| begin(&path)).collect::<Result<Vec<_>, _>>()?;
        if let Err(Failed { at, why }) = self.material(&mut files, set, making, watch) {
            // The error names the file that failed; the others are deleted too.
            return Err(files.swap_remove(at).stopped(why));
        }
        let mut prepared = files.into_iter().map(Unfinished::finish).collect::<Result<Vec<_>, _>>()?;
        for (name, bytes) in plane(set, making) {
            prepared.push(prepare(&folder.join(name), |out| Ok(out.write_all(&bytes)?))?);
        }
        Ok(prepared)
    }
}

/// Writes the concentrations of `grown` (grown with [`crate::synth::Options::concentrations`]) at `size` px to a
/// temporary file, in the form of [`painting::concentrations`].
///
/// # Errors
/// The file cannot be written; or it was cancelled.
pub fn prepare_concentrations(
    grown: &Grown,
    path: &Path,
    size: [usize; 2],
    dpi: f64,
    watch: &Watch,
) -> Result<Prepared, ExportError> {
    prepare(path, |out| painting::concentrations(grown, out, size, dpi, watch))
}
