//! Frames → a film: GIF, APNG or a folder of PNG files. One frame is held at a time.

mod apng;
mod folder;
mod gif;

use std::fs::File;
use std::path::{Path, PathBuf};

use tempfile::TempDir;

use super::{ExportError, Prepared, Stopped, check_file, has_ending, prepare};

/// The file name endings of films.
pub const FORMATS: [&str; 3] = ["gif", "png", "apng"];
/// Colours in a GIF: one of the 256 indices means an unchanged px.
pub const COLOURS: usize = 255;

/// The format of a film.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// Graphics Interchange Format, version 89a: 255 colours for all frames, durations in hundredths of a second.
    Gif,
    /// Animated PNG (PNG Specification, third edition): all colours.
    Apng,
    /// `frame-0001.png`, … in a folder.
    Folder,
}

impl Kind {
    /// The format of a path: by the ending .gif, .png or .apng; a folder if it has no ending.
    ///
    /// # Errors
    /// Another ending; the problem with the path, and the remedy.
    pub fn from_path(path: &Path) -> Result<Self, ExportError> {
        if path.extension().is_none() {
            return folder::check(path).map(|()| Self::Folder);
        }
        super::check_ending(path, &FORMATS)?;
        check_file(path)?;
        Ok(if has_ending(path, "gif") { Self::Gif } else { Self::Apng })
    }
}

/// The properties of a film.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    /// Width and height of a frame, px; at most 65,535 in a GIF.
    pub size: [usize; 2],
    /// Number of frames.
    pub frames: usize,
    /// Frames a second, 1..1000.
    pub fps: u16,
    /// Extra seconds for the last frame before the film repeats.
    pub hold: f64,
    /// Whether it stops at the last frame instead of repeating.
    pub once: bool,
    /// Up to [`COLOURS`] colours, for a GIF.
    pub palette: Vec<[u8; 3]>,
}

impl Film {
    /// Duration of frame `index` in hundredths of a second. Rounding errors do not accumulate.
    fn hundredths(&self, index: usize) -> u16 {
        let begins = |frame: usize| (100.0 * frame as f64 / f64::from(self.fps)).round();
        let shown = begins(index + 1) - begins(index);
        let held = if index + 1 == self.frames { 100.0 * self.hold } else { 0.0 };
        // The longest duration in a GIF.
        (shown + held).round().min(65_535.0) as u16
    }
}

/// Receives a frame: red, green, blue for each px.
pub type Show<'a> = &'a mut dyn FnMut(&[u8]) -> Result<(), Stopped>;

/// A complete film under a temporary name. Dropping it deletes it.
#[derive(Debug)]
#[must_use = "the film is deleted unless it is kept"]
pub enum PreparedFilm {
    /// In one file.
    File(Prepared),
    /// In a folder.
    Folder {
        /// The temporary folder.
        beside: TempDir,
        /// Its final path.
        target: PathBuf,
        /// Other processes do not remove the folder while this lock is held.
        _lock: Option<File>,
    },
}

impl PreparedFilm {
    /// Renames the film to its final name.
    ///
    /// # Errors
    /// The problem, with the file's name and the remedy.
    pub fn keep(self) -> Result<(), ExportError> {
        match self {
            Self::File(file) => file.keep(),
            Self::Folder { beside, target, _lock } => folder::keep(beside, &target),
        }
    }
}

/// Writes a film to `path`: `play` passes all its frames, one after the other, to its argument.
///
/// # Errors
/// The problem, with the file's name and the remedy; the error of `play`.
pub fn write(
    path: &Path,
    kind: Kind,
    film: &Film,
    play: impl FnOnce(Show) -> Result<(), Stopped>,
) -> Result<PreparedFilm, ExportError> {
    match kind {
        Kind::Gif => prepare(path, |out| gif::write(out, film, play)).map(PreparedFilm::File),
        Kind::Apng => prepare(path, |out| apng::write(out, film, play)).map(PreparedFilm::File),
        Kind::Folder => folder::write(path, film, play),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_errors_do_not_accumulate() {
        let film = Film { size: [1, 1], frames: 31, fps: 30, hold: 2.0, once: false, palette: vec![] };
        let shown: Vec<u16> = (0..30).map(|frame| film.hundredths(frame)).collect();
        assert_eq!((shown[0], shown[1], shown.iter().sum::<u16>()), (3, 4, 100));
        assert_eq!(film.hundredths(30), 203);
    }
}
