//! Palettes in and out.

use std::path::Path;

use super::Window;
use crate::app::action::Tab;
use crate::app::chooser::Purpose;
use crate::app::notice::with_causes;
use crate::document::palette::Palette;
use crate::editor::edit::Edit;

impl Window {
    pub(super) fn choose_palette(&mut self) {
        self.choose(Purpose::Palette, "");
    }

    pub(super) fn save_palette_as(&mut self) {
        let name = self.session.layer_name(self.session.active_layer);
        // Names of layers may hold what a file's cannot.
        let name = name.replace(['/', '\\', ':', '\0'], " ");
        self.choose(Purpose::PaletteTo, &format!("{name}.json"));
    }

    /// The layer at hand takes the colours of a file; where it cannot be read, says why and keeps its own.
    pub(super) fn open_palette(&mut self, path: &Path) {
        match Palette::read(path) {
            Ok(palette) => {
                let layer = self.session.active_layer;
                self.session.change(Edit::Colours(vec![layer], Some(palette.colours)));
                self.tab = Tab::Colour;
            }
            Err(error) => self.notices.wrong(with_causes(&error)),
        }
    }

    pub(super) fn save_palette(&mut self, path: &Path) {
        let palette = Palette {
            name: self.session.layer_name(self.session.active_layer),
            colours: self.session.colours(self.session.active_layer),
        };
        match palette.write(path) {
            Ok(()) => self.notices.done(format!("Saved as {}", path.display())),
            Err(error) => self.notices.wrong(with_causes(&error)),
        }
    }
}
