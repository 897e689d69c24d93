//! Documents and palettes in files.

use std::io::{self, Read, Write};
use std::path::Path;

use super::heights::read_heights;
use super::input::input;
use super::save::save;
use crate::document::embedded::in_stream;
use crate::document::link::is_link;
use crate::document::palette::{MAX_FILE, Palette, PaletteError, PaletteForm};
use crate::document::{Document, DocumentError, Extent, limits};
use crate::export::Format;
use crate::machine::fs;

/// Types that can be read from a file.
pub trait ReadFile: Sized {
    /// Why it cannot be read.
    type Error;

    /// Reads a file.
    ///
    /// # Errors
    /// The file cannot be read, or does not hold what is wanted.
    fn read(path: impl AsRef<Path>) -> Result<Self, Self::Error>;
}

/// Types that can be written to a file.
pub trait WriteFile {
    /// Why it cannot be written.
    type Error;

    /// Writes a file. If that fails, an older file of this name is kept as it was.
    ///
    /// # Errors
    /// It is not valid, or the file cannot be written.
    fn write(&self, path: impl AsRef<Path>) -> Result<(), Self::Error>;
}

impl ReadFile for Document {
    type Error = DocumentError;

    fn read(path: impl AsRef<Path>) -> Result<Self, DocumentError> {
        let path = path.as_ref();
        if let Some(link) = as_link(path) {
            return Self::from_link(link).map_err(|error| DocumentError::Link(Box::new(error)));
        }
        let file = path.display().to_string();
        if fs::is_dir(path) {
            return Err(DocumentError::Folder { file });
        }
        let bytes = bytes(path).map_err(|source| DocumentError::Unreadable { file: file.clone(), source })?;
        let mut document = Self::from_bytes(&bytes, &file)?;
        read_heights(&mut document, path);
        Ok(document)
    }
}

impl WriteFile for Document {
    type Error = DocumentError;

    fn write(&self, path: impl AsRef<Path>) -> Result<(), DocumentError> {
        let path = path.as_ref();
        self.check(&path.display().to_string())?;
        Ok(save(path, |out| Ok(out.write_all(self.to_json().as_bytes())?))?)
    }
}

/// The link, where one is given in place of a path.
#[must_use]
pub fn as_link(path: &Path) -> Option<&str> {
    path.to_str().filter(|text| is_link(text))
}

/// The name of a document in messages, for the path from which it is read.
#[must_use]
pub fn source(path: &Path) -> String {
    as_link(path).map_or_else(|| path.display().to_string(), |_| "the link".to_owned())
}

/// The bytes of a document's file, at most one more than the limit.
fn bytes(path: &Path) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    input(path)?.take(limits::MAX_FILE + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}

impl ReadFile for Palette {
    type Error = PaletteError;

    fn read(path: impl AsRef<Path>) -> Result<Self, PaletteError> {
        let path = path.as_ref();
        let file = path.display().to_string();
        let form = PaletteForm::from_path(path)?;
        let unreadable = |source| PaletteError::Unreadable { file: file.clone(), source };
        if fs::metadata(path).map_err(unreadable)?.len() > MAX_FILE {
            return Err(PaletteError::TooLarge { file });
        }
        let bytes = fs::read(path).map_err(unreadable)?;
        Self::from_bytes(form, &bytes, &file)
    }
}

impl WriteFile for Palette {
    type Error = PaletteError;

    fn write(&self, path: impl AsRef<Path>) -> Result<(), PaletteError> {
        let path = path.as_ref();
        let text = self.text(PaletteForm::from_path(path)?);
        Ok(save(path, |out| Ok(out.write_all(text.as_bytes())?))?)
    }
}

/// Reads a document, or a PNG that holds one: the same picture grows from what is returned.
///
/// # Errors
/// The errors of reading a document; a picture that holds no document, or a damaged one.
pub fn open(path: impl AsRef<Path>) -> Result<(Document, Extent), DocumentError> {
    let path = path.as_ref();
    if let Some(found) = in_picture(path)? {
        return Ok(found);
    }
    if Format::from_path(path).is_some() {
        return Err(DocumentError::NoDocument { file: path.display().to_string() });
    }
    Ok((Document::read(path)?, Extent::default()))
}

/// The document in the picture `path`; `None` if the file is not a PNG, or a PNG without a document, such as a photo.
///
/// # Errors
/// The file cannot be read, the PNG is damaged, or its document is not valid.
pub fn in_picture(path: impl AsRef<Path>) -> Result<Option<(Document, Extent)>, DocumentError> {
    let path = path.as_ref();
    let file = path.display().to_string();
    if fs::is_dir(path) || as_link(path).is_some() {
        return Ok(None);
    }
    let stream = input(path).map_err(|source| DocumentError::Unreadable { file: file.clone(), source })?;
    let mut found = in_stream(stream, &file)?;
    if let Some((document, _)) = &mut found {
        read_heights(document, path);
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Colours;

    #[test]
    fn a_link_is_read_in_place_of_a_file() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/zebra.dapple");
        let document = Document::read(&path).unwrap();
        let link = format!("https://a.example/?view{}", document.fragment().unwrap());
        assert_eq!(open(&link).unwrap(), (document, Extent::default()));
        assert_eq!(
            (source(Path::new(&link)).as_str(), source(&path)),
            ("the link", path.display().to_string())
        );
        let cut = Document::read(&link[..link.len() - 9]).unwrap_err().to_string();
        assert!(cut.contains("cut off"), "{cut}");
    }

    #[test]
    fn the_file_ending_gives_the_kind_of_palette() {
        let folder = tempfile::tempdir().unwrap();
        let palette = Palette { name: "coat".to_owned(), colours: Colours::default_for_layer(0) };
        for name in ["a.json", "a.gpl", "A.GPL"] {
            let path = folder.path().join(name);
            palette.write(&path).unwrap();
            let read = Palette::read(&path).unwrap();
            assert_eq!((&read.name, &read.colours.stops), (&palette.name, &palette.colours.stops), "{name}");
        }
        let wrong = palette.write(folder.path().join("a.png")).unwrap_err().to_string();
        assert!(wrong.contains("found the ending \"png\"; allowed: .json"), "{wrong}");
        assert!(matches!(Palette::read(folder.path().join("no.gpl")), Err(PaletteError::Unreadable { .. })));
    }
}
