//! A photograph becomes a sketch, the tone of a layer, or the reference picture.

use std::path::Path;

use egui::Ui;

use super::Window;
use crate::app::action::Action;
use crate::app::importing::{Importing, PhotoAction};
use crate::app::pages::Answer;
use crate::app::small_screen::dialog;
use crate::document::Document;
use crate::editor::picture_use::PictureUse;
use crate::editor::session::Session;

impl Window {
    /// Opens the dialog for a photograph.
    pub(super) fn import_photo(&mut self, path: &Path) {
        self.page = None;
        self.files.photo = Some(Importing::new(path));
    }

    /// The photograph that is being made a sketch.
    #[must_use]
    pub fn importing(&self) -> Option<&Importing> {
        self.files.photo.as_ref()
    }

    /// Receives what was read of the dialog's photograph, whatever is shown over the dialog.
    pub(super) fn listen_to_photo(&mut self, ui: &Ui) {
        let Some(photo) = &mut self.files.photo else { return };
        let followed = photo.follow(ui.ctx(), &self.tasks, self.settings.threads);
        self.report(followed.err());
    }

    /// Shows the dialog.
    pub(super) fn photo_ui(&mut self, ui: &Ui) -> Option<Action> {
        let photo = self.files.photo.as_mut()?;
        let units = self.settings.units;
        let shown = dialog(ui.ctx(), "photograph", 20, |ui| photo.ui(ui, units));
        match if shown.should_close() { Some(PhotoAction::Cancel) } else { shown.inner } {
            Some(PhotoAction::Cancel) => self.files.photo = None,
            Some(PhotoAction::Take) => return Some(Action::TakePhoto),
            None => {}
        }
        None
    }

    /// Opens the sketch of the dialog as a new document, with the photograph under it.
    pub(super) fn take_photo(&mut self) {
        let Some(photo) = self.files.photo.take() else { return };
        let Some((imported, picture)) = photo.taken() else {
            // The photograph is being read again, so the dialog stays open.
            self.files.photo = Some(photo);
            return;
        };
        self.begin(Session::open_unsaved(imported.document.clone(), Document::default(), None));
        let loading = self.canvas.reference.take_picture(picture.clone(), &photo.name(), true, &self.tasks);
        self.report(loading.err());
        self.notices.done(format!("{}: {}", photo.name(), imported.summary));
    }

    /// Carries out the answer about a dropped picture: a sketch (yes), the reference picture (no), or a tone (third).
    pub(super) fn dropped_picture(&mut self, path: &Path, answer: Answer) {
        match answer {
            Answer::Yes => self.import_photo(path),
            Answer::No => self.load_reference(path),
            Answer::Third => self.open_picture(path, PictureUse::Tone),
            Answer::Cancel => {}
        }
    }
}
