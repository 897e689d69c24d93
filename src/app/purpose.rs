//! What a file is chosen for.

use crate::editor::picture_use::PictureUse;

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
            Self::Open => "Open a document",
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
            Self::Open => &["dapple", "png", "json"],
            Self::Save | Self::Become => &["dapple"],
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

    /// Whether something is written.
    #[must_use]
    pub fn writes(self) -> bool {
        matches!(self, Self::Save | Self::Export(_) | Self::ExportInto | Self::PaletteTo)
    }
}
