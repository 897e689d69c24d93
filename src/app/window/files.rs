//! Documents in and out: new, open, save, drop, and what is asked on the way.

use std::path::{Path, PathBuf};

use egui::{Align2, Color32, FontId, Id, Key, Modal, Ui, ViewportCommand};

use super::Window;
use super::opening::is_palette;
use crate::app::action::{Action, Page};
use crate::app::chooser::{Choice, Chooser, Purpose};
use crate::app::examples::{EXAMPLES, GALLERY};
use crate::app::exporting::{Dialog, Size};
use crate::app::notice::with_causes;
use crate::app::pages::{self, Answer, New};
use crate::app::{preferences, recovery, shortcuts};
use crate::document::{Document, in_picture, open};
use crate::editor::session::Session;
use crate::export::has_ending;

/// What is asked about files.
pub struct Files {
    native: bool,
    chooser: Option<Chooser>,
    new: Option<New>,
    /// What is to be done once the unsaved changes are saved, or not.
    unsaved: Option<Action>,
    /// What is to be done once it is saved.
    after_saving: Option<Action>,
    /// What is being asked about an export.
    pub(super) export: Option<Dialog>,
    /// How large the picture was from which the document was restored.
    pub(super) restored: Option<Size>,
    /// The window may go.
    pub closing: bool,
}

impl Files {
    /// Files are chosen with the system's dialogs, or with ours.
    #[must_use]
    pub fn new(native: bool) -> Self {
        Self {
            native,
            chooser: None,
            new: None,
            unsaved: None,
            after_saving: None,
            export: None,
            restored: None,
            closing: false,
        }
    }

    /// Is something being asked?
    #[must_use]
    pub fn is_asking(&self) -> bool {
        self.chooser.as_ref().is_some_and(Chooser::is_ours)
            || self.new.is_some()
            || self.unsaved.is_some()
            || self.export.is_some()
    }
}

impl Window {
    /// Opens a document, the document in a picture, or a drawing; where it cannot be read, says why and keeps what there
    /// is. What does not come from a document's file has no file yet.
    pub(super) fn open(&mut self, path: &Path) {
        if has_ending(path, "svg") {
            self.import(path);
            return;
        }
        let pictured = !has_ending(path, "dapple") && in_picture(path).is_ok_and(|found| found.is_some());
        match open(path) {
            Ok((document, extent)) if pictured => {
                self.begin(Session::open(document, None));
                self.files.restored = Some(Size { canvas: extent.size, scale: extent.scale });
                let name = path.file_name().unwrap_or_default().to_string_lossy();
                self.notices.done(format!("{name} held its document. Saving it asks for a new name."));
            }
            Ok((document, _)) => {
                self.settings.remember(path);
                self.begin(Session::open(document, Some(path.to_owned())));
            }
            Err(error) => self.notices.wrong(with_causes(&error)),
        }
    }

    /// Does it at once, or asks first where unsaved changes would be lost.
    pub(super) fn unless_unsaved(&mut self, ui: &Ui, action: Action) {
        if self.session.is_changed() && !self.session.finished().layers.is_empty() {
            self.files.unsaved = Some(action);
        } else {
            self.go_on(ui, action);
        }
    }

    /// Does what would lose unsaved changes.
    fn go_on(&mut self, ui: &Ui, action: Action) {
        match action {
            Action::New => self.files.new = Some(self.settings.new.clone()),
            Action::Open => self.choose(ui, Purpose::Open, ""),
            Action::OpenFile(path) => self.open(&path),
            Action::Import => self.choose(ui, Purpose::Import, ""),
            Action::Example(name) => self.open_example(name),
            Action::Restore(id) => self.restore(&id),
            Action::Quit => self.close(ui),
            _ => {}
        }
    }

    fn open_example(&mut self, name: &str) {
        let Some(example) = EXAMPLES.iter().chain(GALLERY).find(|example| example.name == name) else {
            return;
        };
        match Document::parse(example.text, name) {
            Ok(document) => {
                self.page = None;
                self.begin(Session::open(document, None));
            }
            Err(error) => self.notices.wrong(with_causes(&error)),
        }
    }

    pub(super) fn choose(&mut self, ui: &Ui, purpose: Purpose, name: &str) {
        let at = self.session.path.clone();
        self.files.chooser = Some(Chooser::new(purpose, at.as_deref(), name, self.files.native, ui.ctx()));
    }

    pub(super) fn choose_reference(&mut self, ui: &Ui) {
        self.choose(ui, Purpose::Reference, "");
    }

    pub(super) fn save_as(&mut self, ui: &Ui) {
        let name = self
            .session
            .path
            .as_deref()
            .and_then(Path::file_name)
            .map(|name| name.to_string_lossy().into_owned());
        self.choose(ui, Purpose::Save, &name.unwrap_or_else(|| "untitled.dapple".to_owned()));
    }

    /// Saves to `path`, or where it was saved before, or asks where.
    pub(super) fn save(&mut self, ui: &Ui, path: Option<PathBuf>) {
        let document = self.session.finished();
        if document.layers.is_empty() {
            self.notices.wrong("There is nothing to save yet: draw at least one mark.");
            self.files.after_saving = None;
            return;
        }
        let Some(path) = path.or_else(|| self.session.path.clone()) else {
            self.save_as(ui);
            return;
        };
        match document.write(&path) {
            Ok(()) => {
                self.session.mark_saved(&path);
                self.settings.remember(&path);
                self.notices.done(format!("Saved as {}", path.display()));
                if let Some(action) = self.files.after_saving.take() {
                    self.go_on(ui, action);
                }
            }
            Err(error) => {
                self.files.after_saving = None;
                self.notices.wrong(with_causes(&error));
            }
        }
    }

    /// Loads a picture to draw over.
    fn load_reference(&mut self, path: &Path) {
        if let Err(error) = self.canvas.reference.load(path, &self.tasks) {
            self.notices.wrong(error.to_string());
        }
    }

    fn chosen(&mut self, ui: &Ui, purpose: Purpose, path: PathBuf) {
        match purpose {
            Purpose::Open | Purpose::Import => self.open(&path),
            Purpose::Save => self.save(ui, Some(path)),
            Purpose::Export(_) | Purpose::ExportInto => self.export_chosen(&path),
            Purpose::Become => self.become_chosen(path),
            Purpose::Palette => self.open_palette(&path),
            Purpose::PaletteTo => self.save_palette(&path),
            Purpose::Reference => self.load_reference(&path),
        }
    }

    /// Takes in what threads and the window system have to tell.
    pub(super) fn listen(&mut self, ui: &Ui) {
        if let Err(why) = self.canvas.reference.listen(ui.ctx()) {
            self.notices.wrong(why);
        }
        self.listen_to_export(ui);
        let close = ui.input(|input| input.viewport().close_requested());
        if close
            && !self.files.closing
            && self.session.is_changed()
            && !self.session.finished().layers.is_empty()
        {
            ui.send_viewport_cmd(ViewportCommand::CancelClose);
            self.files.unsaved = Some(Action::Quit);
        } else if close {
            self.recovery.stop();
        }
    }

    /// Files that were dropped: documents are opened, pictures lie under the canvas.
    pub(super) fn dropped(&mut self, ui: &Ui) -> Vec<Action> {
        let (files, hovering) = ui.input(|input| {
            let paths = input.raw.dropped_files.iter().map(|file| file.path().to_owned());
            (paths.collect::<Vec<_>>(), !input.raw.hovered_files.is_empty())
        });
        if hovering {
            let rect = ui.ctx().content_rect();
            let painter =
                ui.ctx().layer_painter(egui::LayerId::new(egui::Order::Foreground, Id::unique("drop")));
            painter.rect_filled(rect, 0.0, Color32::from_black_alpha(120));
            let text = "Drop a document, a PNG that holds one or an SVG to open it, a picture to draw over, a palette";
            painter.text(
                rect.center(),
                Align2::CENTER_CENTER,
                text,
                FontId::proportional(20.0),
                Color32::WHITE,
            );
        }
        let mut actions = Vec::new();
        for path in files {
            let ending =
                path.extension().map(|ending| ending.to_string_lossy().to_lowercase()).unwrap_or_default();
            if ["png", "jpg", "jpeg", "webp", "tif", "tiff", "bmp", "gif"].contains(&ending.as_str()) {
                actions.extend(self.picture_dropped(path));
            } else if ending == "gpl" || ending == "json" && is_palette(&path) {
                self.open_palette(&path);
            } else if ending == "svg" {
                actions.push(Action::OpenFile(path));
            } else if let Err(error) = Document::read(&path) {
                // Reported before any question about the open document.
                self.notices.wrong(with_causes(&error));
            } else {
                actions.push(Action::OpenFile(path));
            }
        }
        actions
    }

    /// A picture that holds its document restores it; another lies under the canvas.
    fn picture_dropped(&mut self, path: PathBuf) -> Option<Action> {
        match in_picture(&path) {
            Ok(Some(_)) => return Some(Action::OpenFile(path)),
            Ok(None) => {
                self.load_reference(&path);
                let name = path.file_name().unwrap_or_default().to_string_lossy();
                let text = "holds no document: it lies under the canvas, to draw over";
                self.notices.done(format!("{name} {text}"));
            }
            Err(error) => self.notices.wrong(with_causes(&error)),
        }
        None
    }

    /// Pages over the window.
    pub(super) fn over_all(&mut self, ui: &mut Ui) -> Vec<Action> {
        let mut actions = Vec::new();
        // The key that ends the choosing of a file is no answer to the dialog behind it.
        let choosing = self.files.chooser.is_some();
        self.choosing(ui);
        self.asking(ui);
        if !choosing && self.files.chooser.is_none() {
            self.export_ui(ui);
        }
        if let Some(page) = self.page
            && !self.files.is_asking()
        {
            actions.extend(self.page_ui(ui, page));
        }
        self.notices.ui(ui.ctx());
        actions
    }

    fn page_ui(&mut self, ui: &Ui, page: Page) -> Option<Action> {
        let modal =
            Modal::new(Id::unique("page")).frame(egui::Frame::window(&ui.global_style()).inner_margin(22));
        let mut action = None;
        let mut close = false;
        let shown = modal.show(ui.ctx(), |ui| {
            match page {
                Page::Hint => action = pages::hint(ui),
                Page::Examples => {
                    ui.heading("Examples");
                    action = self.gallery.ui(ui);
                }
                Page::Shortcuts => {
                    ui.set_width(620.0);
                    ui.heading("Keys");
                    shortcuts::page(ui);
                }
                Page::About => pages::about(ui),
                Page::Recovery => action = recovery::page(ui, &self.recovery, &mut self.discard_asked),
                Page::Preferences => preferences::page(ui, &mut self.settings),
            }
            if !matches!(page, Page::Hint | Page::Recovery) {
                ui.add_space(6.0);
                close = ui.button("Close").clicked();
            }
        });
        if close || shown.should_close() {
            action = Some(Action::Page(page));
        }
        action
    }

    fn choosing(&mut self, ui: &Ui) {
        let Some(chooser) = &mut self.files.chooser else { return };
        let mut choice = chooser.listen();
        if chooser.is_ours() {
            let shown = Modal::new(Id::unique("chooser"))
                .frame(egui::Frame::window(&ui.global_style()).inner_margin(20))
                .show(ui.ctx(), |ui| chooser.ui(ui));
            choice = if shown.should_close() { Choice::Nothing } else { shown.inner };
        }
        let purpose = chooser.purpose;
        match choice {
            Choice::Waiting => {}
            Choice::Nothing => {
                self.files.chooser = None;
                self.files.after_saving = None;
            }
            Choice::Chosen(path) => {
                self.files.chooser = None;
                self.chosen(ui, purpose, path);
            }
        }
    }

    fn asking(&mut self, ui: &Ui) {
        let frame = egui::Frame::window(&ui.global_style()).inner_margin(20);
        let title = self.session.title();
        // Enter that ends the typing of a number is no answer yet.
        let enter =
            ui.input(|input| input.key_pressed(Key::Enter)) && ui.memory(|memory| memory.focused().is_none());
        let units = self.settings.units;
        let files = &mut self.files;
        let modal = Modal::new(Id::unique("asking")).frame(frame);
        let shown = if files.unsaved.is_some() {
            modal.show(ui.ctx(), |ui| pages::unsaved(ui, &title))
        } else if let Some(new) = &mut files.new {
            modal.show(ui.ctx(), |ui| new.ui(ui, units))
        } else {
            return;
        };
        let answer = shown.inner.or(enter.then_some(Answer::Yes));
        let answer = if shown.should_close() { Some(Answer::Cancel) } else { answer };
        if let Some(answer) = answer {
            self.answered(ui, answer);
        }
    }

    fn answered(&mut self, ui: &Ui, answer: Answer) {
        if let Some(action) = self.files.unsaved.take() {
            match answer {
                Answer::Yes => {
                    self.files.after_saving = Some(action);
                    self.save(ui, None);
                }
                Answer::No => self.go_on(ui, action),
                Answer::Cancel => {}
            }
        } else if let Some(new) = self.files.new.take()
            && answer == Answer::Yes
        {
            self.create(&new);
        }
    }
}
