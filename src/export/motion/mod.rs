//! Frames → a film: GIF, APNG, or a folder of PNG. One frame is held at a time.

mod apng;
mod folder;
mod gif;

use std::fs::File;
use std::path::{Path, PathBuf};

use tempfile::TempDir;

use super::{ExportError, Prepared, Stopped, check_file, has_ending, prepare};

/// The endings of films in one file.
pub const FORMATS: [&str; 3] = ["gif", "png", "apng"];
/// Colours that a GIF has: one of 256 says that a px stays.
pub const COLOURS: usize = 255;

/// How a film is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Graphics Interchange Format, version 89a: 255 colours for all frames, times in hundredths of a second.
    Gif,
    /// Animated PNG (PNG Specification, third edition): all colours.
    Apng,
    /// `frame-0001.png`, … in a folder.
    Folder,
}

impl Kind {
    /// What the name of a film says: .gif, .png or .apng; without an ending, a folder.
    ///
    /// # Errors
    /// Another ending; what is wrong with the path, and the remedy.
    pub fn of(path: &Path) -> Result<Self, ExportError> {
        if path.extension().is_none() {
            return folder::check(path).map(|()| Self::Folder);
        }
        super::check_ending(path, &FORMATS)?;
        check_file(path)?;
        Ok(if has_ending(path, "gif") { Self::Gif } else { Self::Apng })
    }
}

/// What is told about a film before its first frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    /// Width and height of a frame, px; at most 65,535 in a GIF.
    pub size: [usize; 2],
    /// How many frames.
    pub frames: usize,
    /// Frames a second, 1..1000.
    pub fps: u16,
    /// Seconds that the last frame stays before it begins again.
    pub hold: f64,
    /// Whether it stays at the last frame for good instead of beginning again.
    pub once: bool,
    /// Up to [`COLOURS`] colours of a GIF.
    pub palette: Vec<[u8; 3]>,
}

impl Film {
    /// Hundredths of a second that frame `index` is seen. Rounding does not add up.
    fn hundredths(&self, index: usize) -> u16 {
        let begins = |frame: usize| (100.0 * frame as f64 / f64::from(self.fps)).round();
        let shown = begins(index + 1) - begins(index);
        let held = if index + 1 == self.frames { 100.0 * self.hold } else { 0.0 };
        // A GIF cannot wait for longer.
        (shown + held).round().min(65_535.0) as u16
    }
}

/// Takes a frame: red, green, blue a px.
pub type Show<'a> = &'a mut dyn FnMut(&[u8]) -> Result<(), Stopped>;

/// A film that is written but does not have its name yet. Dropped, it is gone.
#[derive(Debug)]
#[must_use = "the film goes unless it is kept"]
pub enum PreparedFilm {
    /// In one file.
    File(Prepared),
    /// In a folder.
    Folder {
        /// Where it lies.
        beside: TempDir,
        /// Where it is to lie.
        target: PathBuf,
        /// Nobody takes it away while this is held.
        _lock: Option<File>,
    },
}

impl PreparedFilm {
    /// Gives it its name.
    ///
    /// # Errors
    /// What went wrong, with the file's name and the remedy.
    pub fn keep(self) -> Result<(), ExportError> {
        match self {
            Self::File(file) => file.keep(),
            Self::Folder { beside, target, _lock } => folder::keep(beside, &target),
        }
    }
}

/// Writes a film to `path`: `play` shows all its frames, one after the other.
///
/// # Errors
/// What went wrong, with the file's name and the remedy; what `play` fails with.
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
    fn rounding_to_hundredths_does_not_add_up() {
        let film = Film { size: [1, 1], frames: 31, fps: 30, hold: 2.0, once: false, palette: vec![] };
        let shown: Vec<u16> = (0..30).map(|frame| film.hundredths(frame)).collect();
        assert_eq!((shown[0], shown[1], shown.iter().sum::<u16>()), (3, 4, 100));
        assert_eq!(film.hundredths(30), 203);
    }
}
