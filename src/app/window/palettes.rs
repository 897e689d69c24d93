//! Palettes in and out.

use std::path::{Path, PathBuf};

use super::Window;
use crate::app::action::Tab;
use crate::app::platform;
use crate::app::purpose::Purpose;
use crate::document::palette::Palette;
use crate::document::with_causes;
use crate::editor::edit::Edit;
use crate::editor::reading::{self, ReadingPalette};
use crate::editor::writing::Writing;
use crate::files::WriteFile;

/// The palette files that are being read and written.
#[derive(Default)]
pub struct PaletteFiles {
    /// The palette that is being read, and the position and name of the layer that it is for.
    reading: Option<((usize, String), ReadingPalette)>,
    writing: Option<(PathBuf, Writing<Result<(), String>>)>,
}

impl PaletteFiles {
    /// Whether a palette is being read or written.
    #[must_use]
    pub fn is_busy(&self) -> bool {
        self.reading.is_some() || self.is_writing()
    }

    /// Whether a palette is being written.
    #[must_use]
    pub fn is_writing(&self) -> bool {
        self.writing.is_some()
    }

    /// Another document is open: a palette that is still being read was not meant for its layers.
    pub fn document_opened(&mut self) {
        self.reading = None;
    }
}

impl Window {
    pub(super) fn choose_palette(&mut self) {
        self.choose(Purpose::Palette, "");
    }

    pub(super) fn save_palette_as(&mut self) {
        let name = self.session.layer_name(self.session.active_layer);
        // Names of layers may hold characters that file names cannot.
        let name = name.replace(['/', '\\', ':', '\0'], " ");
        self.choose(Purpose::PaletteTo, &format!("{name}.json"));
    }

    /// Reads a palette for the active layer; where it cannot be read, the layer keeps its colours.
    pub(super) fn open_palette(&mut self, path: &Path) {
        let layer = self.session.active_layer;
        match reading::read_palette(path, &self.tasks) {
            Ok(task) => {
                self.files.palettes.reading = Some(((layer, self.session.layer_name(layer)), task));
            }
            Err(error) => self.notices.wrong(error.to_string()),
        }
    }

    /// Gives a layer the colours of a palette.
    pub(super) fn take_palette(&mut self, layer: usize, palette: Palette) {
        self.session.change(Edit::Colours(vec![layer], Some(palette.colours)));
        self.tab = Tab::Colour;
    }

    /// Writes the colours of the active layer.
    pub(super) fn save_palette(&mut self, path: &Path) {
        let palette = Palette {
            name: self.session.layer_name(self.session.active_layer),
            colours: self.session.colours(self.session.active_layer),
        };
        // Two palettes that are written at the same time could be for the same file and end in the wrong order.
        self.finish_palette();
        let file = path.to_owned();
        let write = move || palette.write(&file).map_err(|error| with_causes(&error));
        let writing = Writing::start(&self.tasks, "saving a palette", write);
        self.files.palettes.writing = Some((path.to_owned(), writing));
    }

    /// Receives palettes that were read. Returns whether a palette was written, once writing has ended.
    pub(super) fn listen_to_palettes(&mut self) -> Option<bool> {
        self.listen_to_read_palette();
        let outcome = self.files.palettes.writing.as_mut()?.1.poll()?;
        let (path, _) = self.files.palettes.writing.take()?;
        Some(self.palette_written(&path, outcome))
    }

    fn listen_to_read_palette(&mut self) {
        let Some((_, task)) = &mut self.files.palettes.reading else { return };
        let read = task.poll();
        if read.is_none() && !task.has_ended() {
            return;
        }
        let Some(((layer, name), _)) = self.files.palettes.reading.take() else { return };
        let there = layer < self.session.document().layers.len().max(1);
        match read {
            None => self
                .notices
                .wrong("Reading the palette failed because of an error in dapple. Please report it."),
            Some(Err(why)) => self.notices.wrong(why),
            Some(Ok(palette)) if there && self.session.layer_name(layer) == name => {
                self.take_palette(layer, palette);
            }
            Some(Ok(_)) => {
                self.notices.wrong(format!("{name} has changed: open the palette once more for its layer."));
            }
        }
    }

    fn palette_written(&mut self, path: &Path, outcome: Result<Result<(), String>, &str>) -> bool {
        match outcome {
            Ok(Ok(())) => {
                platform::hand_over(path);
                self.notices.done(format!("Saved as {}", platform::shown(path)));
                return true;
            }
            Ok(Err(why)) => self.notices.wrong(why),
            Err(why) => self.notices.wrong(format!("{}: saving: {why}", path.display())),
        }
        false
    }

    /// Waits for the palette that is being written.
    pub(super) fn finish_palette(&mut self) {
        let Some((path, writing)) = self.files.palettes.writing.take() else { return };
        if let Some(outcome) = writing.wait() {
            self.palette_written(&path, outcome);
        }
    }
}
