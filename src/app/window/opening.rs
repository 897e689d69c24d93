//! What is opened beside documents: drawings, and .json files that may hold a palette.

use std::path::Path;

use super::Window;
use crate::app::notice::with_causes;
use crate::document::Document;
use crate::document::palette::Palette;
use crate::editor::session::Session;
use crate::synth::import::{DPI, import};

impl Window {
    /// A drawing becomes a document, which has no file yet.
    pub(super) fn import(&mut self, path: &Path) {
        match import(path, DPI) {
            Ok(imported) => {
                self.begin(Session::open_unsaved(imported.document, Document::default(), None));
                let name = path.file_name().unwrap_or_default().to_string_lossy();
                let told = format!("{name}: {}", imported.summary);
                // What was left out stays until it is read.
                if imported.unread.is_empty() { self.notices.done(told) } else { self.notices.wrong(told) }
            }
            Err(error) => self.notices.wrong(with_causes(&error)),
        }
    }
}

/// Does a .json hold a palette, rather than a document?
pub fn is_palette(path: &Path) -> bool {
    Palette::read(path).is_ok() || Document::read(path).is_err_and(|_| mentions_palette(path))
}

/// What calls itself a palette is told about as one, also where it is wrong.
fn mentions_palette(path: &Path) -> bool {
    std::fs::read_to_string(path).is_ok_and(|text| text.contains("dapple palette"))
}
