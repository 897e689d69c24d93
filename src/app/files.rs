//! Documents in and out: new, open, save, drop, and what is asked on the way.

use std::path::{Path, PathBuf};

use eframe::egui::{Align2, Color32, FontId, Id, Key, Modal, Ui, ViewportCommand};

use super::action::{Action, Page};
use super::chooser::{Choice, Chooser, Purpose};
use super::desk::Desk;
use super::examples::{EXAMPLES, GALLERY};
use super::exporting::{Exporting, Size};
use super::pages::{self, Answer, New};
use super::shortcuts;
use super::window::Window;
use crate::synth::recipe::Document;

/// What is asked about files.
pub struct Files {
    native: bool,
    chooser: Option<Chooser>,
    new: Option<New>,
    /// What is to be done once the unsaved changes are saved, or not.
    unsaved: Option<Action>,
    /// What is to be done once it is saved.
    after_saving: Option<Action>,
    export: Option<Size>,
    size: Size,
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
            size: Size::default(),
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

    /// Asks how large the export shall be.
    pub fn ask_export_size(&mut self) {
        self.export = Some(Size::default());
    }
}

impl Window {
    /// Opens a document; where it cannot be read, says why and keeps what there is.
    pub(super) fn open(&mut self, path: &Path) {
        match Document::read(path) {
            Ok(document) => {
                self.settings.remember(path);
                self.begin(Desk::open(document, Some(path.to_owned())));
            }
            Err(error) => self.notices.wrong(with_causes(&error)),
        }
    }

    /// Does it at once, or asks first where unsaved changes would be lost.
    pub(super) fn unless_unsaved(&mut self, ui: &Ui, action: Action) {
        if self.desk.is_changed() && !self.desk.finished().layers.is_empty() {
            self.files.unsaved = Some(action);
        } else {
            self.go_on(ui, action);
        }
    }

    /// Does what would lose unsaved changes.
    fn go_on(&mut self, ui: &Ui, action: Action) {
        match action {
            Action::New => self.files.new = Some(New::default()),
            Action::Open => self.choose(ui, Purpose::Open, ""),
            Action::OpenFile(path) => self.open(&path),
            Action::Example(name) => self.open_example(name),
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
                self.begin(Desk::open(document, None));
            }
            Err(error) => self.notices.wrong(with_causes(&error)),
        }
    }

    pub(super) fn choose(&mut self, ui: &Ui, purpose: Purpose, name: &str) {
        let at = self.desk.path.clone();
        self.files.chooser = Some(Chooser::new(purpose, at.as_deref(), name, self.files.native, ui.ctx()));
    }

    pub(super) fn choose_reference(&mut self, ui: &Ui) {
        self.choose(ui, Purpose::Reference, "");
    }

    pub(super) fn save_as(&mut self, ui: &Ui) {
        let name = self
            .desk
            .path
            .as_deref()
            .and_then(Path::file_name)
            .map(|name| name.to_string_lossy().into_owned());
        self.choose(ui, Purpose::Save, &name.unwrap_or_else(|| "untitled.dapple".to_owned()));
    }

    /// Saves to `path`, or where it was saved before, or asks where.
    pub(super) fn save(&mut self, ui: &Ui, path: Option<PathBuf>) {
        let document = self.desk.finished();
        if document.layers.is_empty() {
            self.notices.wrong("There is nothing to save yet: draw at least one mark.");
            self.files.after_saving = None;
            return;
        }
        let Some(path) = path.or_else(|| self.desk.path.clone()) else {
            self.save_as(ui);
            return;
        };
        match document.write(&path) {
            Ok(()) => {
                self.desk.mark_saved(&path);
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

    /// Writes the texture to `path`, of a canvas of `canvas` px or the document's, with `scale` times the px.
    pub fn export(&mut self, path: &Path, canvas: Option<[u32; 2]>, scale: u32) {
        let settled = self.growth.texture.clone();
        let size = Size { canvas, scale };
        self.exporting = Some(Exporting::new(path, &self.desk.finished(), size, settled));
    }

    fn chosen(&mut self, ui: &Ui, purpose: Purpose, path: PathBuf) {
        match purpose {
            Purpose::Open => self.open(&path),
            Purpose::Save => self.save(ui, Some(path)),
            Purpose::Export => self.export(&path, self.files.size.canvas, self.files.size.scale),
            Purpose::Palette => self.open_palette(&path),
            Purpose::PaletteTo => self.save_palette(&path),
            Purpose::Reference => self.canvas.reference.load(&path, ui.ctx()),
        }
    }

    /// Takes in what threads and the window system have to tell.
    pub(super) fn listen(&mut self, ui: &Ui) {
        if let Err(why) = self.canvas.reference.listen(ui.ctx()) {
            self.notices.wrong(why);
        }
        if let Some((outcome, job)) = self.exporting.as_ref().and_then(|job| Some((job.outcome()?, job))) {
            match outcome {
                Ok(()) => self.notices.done(format!("Written: {}", job.path.display())),
                Err(_) if job.is_cancelled() => {
                    self.notices.done("The export was given up; nothing was written.");
                }
                Err(why) => self.notices.wrong(why),
            }
            self.exporting = None;
        } else if self.exporting.is_some() {
            ui.ctx().request_repaint_after(std::time::Duration::from_millis(100));
        }
        let close = ui.input(|input| input.viewport().close_requested());
        if close && !self.files.closing && self.desk.is_changed() && !self.desk.finished().layers.is_empty() {
            ui.send_viewport_cmd(ViewportCommand::CancelClose);
            self.files.unsaved = Some(Action::Quit);
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
            let painter = ui.ctx().layer_painter(eframe::egui::LayerId::new(
                eframe::egui::Order::Foreground,
                Id::unique("drop"),
            ));
            painter.rect_filled(rect, 0.0, Color32::from_black_alpha(120));
            let text = "Drop a document to open it, a picture to draw over it, a palette for its colours";
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
            if ["png", "jpg", "jpeg", "webp", "tif", "tiff", "bmp"].contains(&ending.as_str()) {
                self.canvas.reference.load(&path, ui.ctx());
            } else if ["gpl", "json"].contains(&ending.as_str()) {
                self.open_palette(&path);
            } else if let Err(error) = Document::read(&path) {
                // Said before anything is asked about what lies on the desk.
                self.notices.wrong(with_causes(&error));
            } else {
                actions.push(Action::OpenFile(path));
            }
        }
        actions
    }

    /// Pages over the window.
    pub(super) fn over_all(&mut self, ui: &mut Ui) -> Vec<Action> {
        let mut actions = Vec::new();
        self.choosing(ui);
        self.asking(ui);
        if let Some(page) = self.page
            && !self.files.is_asking()
        {
            actions.extend(self.page_ui(ui, page));
        }
        self.notices.ui(ui.ctx());
        actions
    }

    fn page_ui(&mut self, ui: &Ui, page: Page) -> Option<Action> {
        let modal = Modal::new(Id::unique("page"))
            .frame(eframe::egui::Frame::window(&ui.global_style()).inner_margin(22));
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
            }
            if page != Page::Hint {
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
                .frame(eframe::egui::Frame::window(&ui.global_style()).inner_margin(20))
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
        let frame = eframe::egui::Frame::window(&ui.global_style()).inner_margin(20);
        let title = self.desk.title();
        let document = self.desk.finished();
        // Enter that ends the typing of a number is no answer yet.
        let enter =
            ui.input(|input| input.key_pressed(Key::Enter)) && ui.memory(|memory| memory.focused().is_none());
        let files = &mut self.files;
        let modal = Modal::new(Id::unique("asking")).frame(frame);
        let shown = if files.unsaved.is_some() {
            modal.show(ui.ctx(), |ui| pages::unsaved(ui, &title))
        } else if let Some(new) = &mut files.new {
            modal.show(ui.ctx(), |ui| new.ui(ui))
        } else if let Some(size) = &mut files.export {
            modal.show(ui.ctx(), |ui| pages::export(ui, size, &document))
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
        } else if let Some(new) = self.files.new.take() {
            if answer == Answer::Yes {
                self.create(&new);
            }
        } else if let Some(size) = self.files.export.take()
            && answer == Answer::Yes
        {
            self.files.size = size;
            let name = Path::new(&self.desk.title()).with_extension("png");
            self.choose(ui, Purpose::Export, &name.to_string_lossy());
        }
    }
}

/// A message and those of its causes, on one line.
pub(super) fn with_causes(error: &dyn std::error::Error) -> String {
    let mut text = error.to_string();
    let mut cause = error.source();
    while let Some(error) = cause {
        let said = error.to_string();
        if !text.ends_with(&said) {
            text = format!("{text}: {said}");
        }
        cause = error.source();
    }
    text
}
