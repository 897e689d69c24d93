//! What a file is chosen for.

use std::path::{Path, PathBuf};

use crate::editor::picture_use::PictureUse;
use crate::export::has_ending;

/// The endings of all exported files.
const EXPORTED: [&str; 12] =
    ["png", "tif", "tiff", "exr", "jpg", "jpeg", "webp", "svg", "dxf", "gif", "apng", "dapple"];

/// What a file is chosen for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// A document to open.
    Open,
    /// Where to save the document.
    Save,
    /// Where to write an export: the allowed file name endings, the default first.
    Export(&'static [&'static str]),
    /// The folder to write an export into.
    ExportInto,
    /// The document that a film ends with.
    Become,
    /// A drawing that becomes a document.
    Import,
    /// A photograph that becomes a document.
    Photograph,
    /// Choose a reference picture.
    Reference,
    /// Colours for the active layer.
    Palette,
    /// Where to write colours.
    PaletteTo,
    /// A picture that the active layer follows.
    Picture(PictureUse),
}

impl Purpose {
    /// Its heading.
    #[must_use]
    pub fn title(self) -> &'static str {
        match self {
            Self::Open => "Open a document or a picture",
            Self::Save => "Save the document",
            Self::Export(_) => "Export",
            Self::ExportInto => "Export into a folder",
            Self::Become => "Choose the last document of the film",
            Self::Import => "Import an SVG",
            Self::Photograph => "Import a photograph",
            Self::Reference => "Choose a reference picture",
            Self::Palette => "Open a palette",
            Self::PaletteTo => "Save the palette",
            Self::Picture(_) => "Choose a picture",
        }
    }

    /// What its button says.
    #[must_use]
    pub fn verb(self) -> &'static str {
        match self {
            Self::Open | Self::Reference | Self::Palette => "Open",
            Self::Become | Self::Picture(_) => "Choose",
            Self::Import | Self::Photograph => "Import",
            Self::Save | Self::PaletteTo => "Save",
            Self::Export(_) | Self::ExportInto => "Export",
        }
    }

    /// The endings of its files, the default first.
    #[must_use]
    pub fn endings(self) -> &'static [&'static str] {
        match self {
            // What can be dropped as well.
            Self::Open => &[
                "dapple", "json", "png", "jpg", "jpeg", "webp", "tif", "tiff", "bmp", "gif", "svg", "svgz",
                "gpl",
            ],
            Self::Save => &["dapple", "json"],
            Self::Become => &["dapple"],
            Self::Import => &["svg"],
            Self::Export(endings) => endings,
            Self::ExportInto => &[],
            Self::Palette | Self::PaletteTo => &["json", "gpl"],
            Self::Photograph | Self::Picture(_) => {
                &["jpg", "jpeg", "png", "webp", "tif", "tiff", "bmp", "gif"]
            }
            Self::Reference => &["png", "jpg", "jpeg", "webp", "tif", "tiff", "bmp"],
        }
    }

    /// Whether the ending of `path` is one of its endings. An export also leaves the endings of other formats as they
    /// are: it reports which one it would need.
    fn fits(self, path: &Path) -> bool {
        let others: &[&str] = if matches!(self, Self::Export(_)) { &EXPORTED } else { &[] };
        self.endings().iter().chain(others).any(|ending| has_ending(path, ending))
    }

    /// The path that is written where this one is chosen: with the default ending, unless it has an ending that fits. A
    /// document is never written into a file that is called a picture.
    #[must_use]
    pub fn with_ending(self, path: PathBuf) -> PathBuf {
        match self.endings().first().filter(|_| self.writes() && !self.fits(&path)) {
            Some(ending) => {
                let mut name = path.into_os_string();
                name.push(".");
                name.push(ending);
                name.into()
            }
            None => path,
        }
    }

    /// Whether something is written.
    #[must_use]
    pub fn writes(self) -> bool {
        matches!(self, Self::Save | Self::Export(_) | Self::ExportInto | Self::PaletteTo)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_get_the_ending_of_what_is_written_unless_theirs_fits() {
        for (purpose, name, written) in [
            (Purpose::Save, "cat", "cat.dapple"),
            (Purpose::Save, "cat v1.2", "cat v1.2.dapple"),
            (Purpose::Save, "cat.DAPPLE", "cat.DAPPLE"),
            (Purpose::Save, "cat.json", "cat.json"),
            (Purpose::Save, "cat.png", "cat.png.dapple"),
            (Purpose::PaletteTo, "cat.png", "cat.png.json"),
            (Purpose::PaletteTo, "cat.gpl", "cat.gpl"),
            (Purpose::Export(&["tif", "tiff"]), "cat 2.0", "cat 2.0.tif"),
            (Purpose::Export(&["tif", "tiff"]), "cat.png", "cat.png"),
            (Purpose::Open, "cat", "cat"),
            (Purpose::ExportInto, "cat 2.0", "cat 2.0"),
        ] {
            assert_eq!(purpose.with_ending(name.into()), Path::new(written), "{purpose:?} {name}");
        }
    }

    #[test]
    fn what_is_saved_is_listed_when_a_document_is_opened() {
        let listed = Purpose::Open.endings();
        assert!(Purpose::Save.endings().iter().all(|ending| listed.contains(ending)));
    }
}
