//! New, open, save and drop files.

use std::collections::VecDeque;
use std::path::{Path, PathBuf};

use egui::{Align2, Color32, FontId, Id, Ui, ViewportCommand};

use super::Window;
use super::examples::{ExampleUse, ReadingExample};
use super::links::Unlinked;
use super::palettes::PaletteFiles;
use super::pictures::ReadingPicture;
use crate::app::action::Action;
use crate::app::chooser::Chooser;
use crate::app::exporting::{Dialog, Size};
use crate::app::importing::Importing;
use crate::app::pages::New;
use crate::app::platform;
use crate::app::purpose::Purpose;
use crate::document::Document;
use crate::editor::reading::{self, Content, Dropped, Inspecting, Reading};
use crate::editor::saving::Saving;
use crate::editor::session::Session;
use crate::machine::clock::Instant;
use crate::machine::fs;

/// Files that are read and written, and the dialogs about them.
pub struct Files {
    native: bool,
    pub(super) chooser: Option<Chooser>,
    pub(super) new: Option<New>,
    /// The action that waits for the answer to the question about unsaved changes.
    pub(super) unsaved: Option<Action>,
    /// The question that was shown in the last frame.
    pub(super) asked: Option<&'static str>,
    /// The action that waits for the end of a save.
    pub(super) after_saving: Option<Action>,
    /// The file that is being read, and the revision of the session when the reading began.
    reading: Option<(u64, Reading)>,
    inspecting: Option<Inspecting>,
    /// The example that is being read.
    pub(super) example: Option<ReadingExample>,
    saving: Option<Saving>,
    pub(super) palettes: PaletteFiles,
    /// The picture that is being read for a layer to follow.
    pub(super) picture: Option<ReadingPicture>,
    /// The photograph that is being made a sketch.
    pub(super) photo: Option<Importing>,
    /// Dropped pictures about whose use the user will be asked.
    pub(super) dropped: VecDeque<PathBuf>,
    /// A document whose link is too long, or for which there is no link: a file is offered instead.
    pub(super) unlinked: Option<Unlinked>,
    /// What is being asked about an export.
    pub(super) export: Option<Dialog>,
    /// The dialog of the export that is being written: it opens again where that fails.
    pub(super) exporting: Option<Dialog>,
    /// The time at which an export was cancelled that has not ended yet.
    pub(super) cancelled: Option<Instant>,
    /// Where the open document was last exported to.
    pub(super) exported: Option<PathBuf>,
    /// How large the picture was from which the document was restored.
    pub(super) restored: Option<Size>,
    /// Whether the window may close without a question.
    pub closing: bool,
}

impl Files {
    /// The state at the start. `native`: files are chosen with the system's dialogs.
    #[must_use]
    pub fn new(native: bool) -> Self {
        Self {
            native,
            chooser: None,
            new: None,
            unsaved: None,
            asked: None,
            after_saving: None,
            reading: None,
            inspecting: None,
            example: None,
            saving: None,
            palettes: PaletteFiles::default(),
            picture: None,
            photo: None,
            dropped: VecDeque::new(),
            unlinked: None,
            export: None,
            exporting: None,
            cancelled: None,
            exported: None,
            restored: None,
            closing: false,
        }
    }

    /// Whether a file is being read or written.
    #[must_use]
    pub fn is_busy(&self) -> bool {
        let is_choosing = self.chooser.as_ref().is_some_and(Chooser::is_busy);
        let is_reading = self.reading.is_some()
            || self.inspecting.is_some()
            || self.example.is_some()
            || self.picture.is_some()
            || self.photo.as_ref().is_some_and(Importing::is_reading)
            || self.export.as_ref().is_some_and(Dialog::is_rendering);
        is_choosing || is_reading || self.saving.is_some() || self.palettes.is_busy()
    }

    /// Whether a file of the user is being written.
    fn is_writing(&self) -> bool {
        self.saving.is_some() || self.palettes.is_writing()
    }

    /// Whether something is being asked.
    #[must_use]
    pub fn is_asking(&self) -> bool {
        self.chooser.as_ref().is_some_and(Chooser::is_ours)
            || self.new.is_some()
            || self.unlinked.is_some()
            || self.unsaved.is_some()
            || self.export.is_some()
            || self.photo.is_some()
            || !self.dropped.is_empty()
    }
}

impl Window {
    /// Opens a file as if it were dropped: the user is asked what a picture is for.
    pub(super) fn open_any(&mut self, path: PathBuf) {
        self.inspect(vec![path]);
    }

    /// Reads a document, the document in a picture, or a drawing on another thread, and opens it once it is read.
    pub(super) fn open(&mut self, path: &Path) {
        match reading::read(path, &self.tasks) {
            Ok(task) => self.files.reading = Some((self.session.revision(), task)),
            Err(error) => self.notices.wrong(error.to_string()),
        }
    }

    fn listen_to_reading(&mut self) {
        let Some((revision, task)) = &mut self.files.reading else { return };
        let (revision, read) = (*revision, task.poll());
        if read.is_none() && !task.has_ended() {
            return;
        }
        self.files.reading = None;
        match read {
            None => {
                self.notices
                    .wrong("Reading the file failed because of an error in dapple. Please report it.");
            }
            Some((_, Err(why))) => self.notices.wrong(why),
            // The user has drawn something in the meantime.
            Some((path, Ok(_))) if revision != self.session.revision() && self.has_unsaved() => {
                self.files.unsaved = Some(Action::OpenFile(path));
            }
            Some((path, Ok(content))) => self.show(&path, content),
        }
    }

    /// Opens the content of a file. Only a document's own file becomes the file to save to.
    fn show(&mut self, path: &Path, content: Content) {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        match content {
            Content::Document(document) => {
                self.settings.remember(path);
                self.begin(Session::open(document, Some(path.to_owned())));
            }
            Content::Picture(document, extent) => {
                self.begin(Session::open(document, None));
                self.files.restored = Some(Size { canvas: extent.size, scale: extent.scale });
                self.notices.done(format!("Opened the document in {name}. Saving asks for a file name."));
            }
            Content::Drawing(imported) => {
                self.begin(Session::open_unsaved(imported.document, Document::default(), None));
                let text = format!("{name}: {}", imported.summary);
                // A message about parts that were left out stays until the user closes it.
                if imported.unread.is_empty() { self.notices.done(text) } else { self.notices.wrong(text) }
            }
        }
    }

    pub(super) fn has_unsaved(&self) -> bool {
        self.session.is_changed() && !self.session.finished().layers.is_empty()
    }

    /// Carries out an action at once, or asks first where unsaved changes would be lost. Waits for a save that is not
    /// finished.
    pub(super) fn unless_unsaved(&mut self, ui: &Ui, action: Action) {
        if self.files.is_writing() {
            self.files.after_saving = Some(action);
        } else if self.has_unsaved() {
            self.files.unsaved = Some(action);
        } else {
            self.go_on(ui, action);
        }
    }

    /// Carries out an action that discards the open document.
    pub(super) fn go_on(&mut self, ui: &Ui, action: Action) {
        match action {
            Action::New => self.files.new = Some(self.settings.new.clone()),
            Action::OpenFile(path) => self.open(&path),
            Action::OpenLink(link) => self.open_link(&link),
            Action::Import => self.choose(Purpose::Import, ""),
            Action::Example(name) => self.read_example(ui, name, ExampleUse::Open),
            Action::Restore(id) => self.restore(&id),
            Action::TakePhoto => self.take_photo(),
            Action::Quit => self.close(ui),
            _ => {}
        }
    }

    pub(super) fn choose(&mut self, purpose: Purpose, name: &str) {
        let is_export = matches!(purpose, Purpose::Export(_) | Purpose::ExportInto);
        let last = self.settings.export_folder.as_ref().filter(|folder| is_export && fs::is_dir(folder));
        let at = last.map(|folder| folder.join(name)).or_else(|| self.session.path.clone());
        self.files.chooser = Some(Chooser::new(purpose, at.as_deref(), name, &self.tasks, self.files.native));
    }

    pub(super) fn choose_reference(&mut self) {
        self.choose(Purpose::Reference, "");
    }

    pub(super) fn save_as(&mut self) {
        let name = self
            .session
            .path
            .as_deref()
            .and_then(Path::file_name)
            .map(|name| name.to_string_lossy().into_owned());
        self.choose(Purpose::Save, &name.unwrap_or_else(|| "untitled.dapple".to_owned()));
    }

    /// Saves to `path`, else to the document's file, else asks for one.
    pub(super) fn save(&mut self, path: Option<PathBuf>) {
        let document = self.session.finished();
        if document.layers.is_empty() {
            self.notices.wrong("Nothing to save yet. Draw at least one mark.");
            self.files.after_saving = None;
            return;
        }
        let Some(path) = path.or_else(|| self.session.path.clone()) else {
            self.save_as();
            return;
        };
        if let Some(saving) = &mut self.files.saving {
            // Two saves at the same time could end in the wrong order.
            saving.again = Some(path);
            return;
        }
        self.files.saving = Some(Saving::start(&path, self.session.document(), document, &self.tasks));
    }

    fn listen_to_saving(&mut self, ui: &Ui) {
        let Some(outcome) = self.files.saving.as_mut().and_then(Saving::poll) else { return };
        let Some(mut saving) = self.files.saving.take() else { return };
        let saved = self.saved(&saving, outcome);
        if let (true, Some(path)) = (saved, saving.again.take()) {
            self.save(Some(path));
        } else {
            self.written(ui, saved);
        }
    }

    /// Called when a file was written or could not be written: carries out the action that waited for that.
    fn written(&mut self, ui: &Ui, written: bool) {
        if let Some(action) = self.files.after_saving.take().filter(|_| written) {
            self.unless_unsaved(ui, action);
        }
    }

    fn saved(&mut self, saving: &Saving, outcome: Result<(), String>) -> bool {
        match outcome {
            Ok(()) => {
                self.session.mark_saved(saving.document.clone(), &saving.path);
                self.settings.remember(&saving.path);
                self.recent_sketches.forget(&saving.path);
                platform::hand_over(&saving.path);
                self.notices.done(format!("Saved as {}", platform::shown(&saving.path)));
                true
            }
            Err(why) => {
                self.notices.wrong(why);
                false
            }
        }
    }

    /// Waits for the end of a save, because the session is about to be replaced.
    pub(super) fn finish_saving(&mut self) {
        if let Some(mut saving) = self.files.saving.take() {
            let outcome = saving.wait();
            self.saved(&saving, outcome);
        }
    }

    /// Loads a picture to draw over.
    pub(super) fn load_reference(&mut self, path: &Path) {
        if let Err(error) = self.canvas.reference.load(path, &self.tasks) {
            self.notices.wrong(error.to_string());
        }
    }

    pub(super) fn chosen(&mut self, purpose: Purpose, path: PathBuf) {
        match purpose {
            Purpose::Open => self.open_any(path),
            Purpose::Import => self.open(&path),
            Purpose::Save => self.save(Some(path)),
            Purpose::Export(_) | Purpose::ExportInto => self.export_chosen(&path),
            Purpose::Become => self.become_chosen(path),
            Purpose::Palette => self.open_palette(&path),
            Purpose::PaletteTo => self.save_palette(&path),
            Purpose::Picture(wanted) => self.open_picture(&path, wanted),
            Purpose::Photograph => self.import_photo(&path),
            Purpose::Reference => self.load_reference(&path),
        }
    }

    /// Receives messages from tasks and from the window system.
    pub(super) fn listen(&mut self, ui: &Ui) {
        if let Err(why) = self.canvas.reference.follow(ui.ctx(), &mut self.session) {
            self.notices.wrong(why);
        }
        for why in platform::not_handed_over() {
            self.notices.wrong(why);
        }
        self.recent_sketches.listen();
        self.listen_to_clipboard(ui.ctx());
        self.listen_to_export(ui);
        self.listen_to_reading();
        self.listen_to_example();
        self.listen_to_dropped(ui);
        self.listen_to_photo(ui);
        self.listen_to_picture();
        self.listen_to_saving(ui);
        if let Some(written) = self.listen_to_palettes() {
            self.written(ui, written);
        }
        let close = ui.input(|input| input.viewport().close_requested());
        if close && !self.files.closing && (self.files.is_writing() || self.has_unsaved()) {
            ui.send_viewport_cmd(ViewportCommand::CancelClose);
            self.unless_unsaved(ui, Action::Quit);
        } else if close {
            self.recovery.stop();
        }
    }

    /// Takes dropped files. While files are held over the window, shows what can be dropped.
    pub(super) fn dropped(&mut self, ui: &Ui) {
        let files = platform::dropped(ui);
        let hovering = ui.input(|input| !input.raw.hovered_files.is_empty());
        if hovering {
            let rect = ui.ctx().content_rect();
            let painter =
                ui.ctx().layer_painter(egui::LayerId::new(egui::Order::Foreground, Id::unique("drop")));
            painter.rect_filled(rect, 0.0, Color32::from_black_alpha(120));
            let text = "Drop a document, a PNG that holds one or an SVG to open it, a photograph for a sketch, as tone or to draw over, a palette";
            painter.text(
                rect.center(),
                Align2::CENTER_CENTER,
                text,
                FontId::proportional(20.0),
                Color32::WHITE,
            );
        }
        if !files.is_empty() {
            self.inspect(files);
        }
    }

    /// Finds out on another thread what each of these files is, and opens it accordingly.
    fn inspect(&mut self, files: Vec<PathBuf>) {
        match reading::inspect(files, &self.tasks) {
            Ok(task) => self.files.inspecting = Some(task),
            Err(error) => self.notices.wrong(error.to_string()),
        }
    }

    fn listen_to_dropped(&mut self, ui: &Ui) {
        let Some(task) = &mut self.files.inspecting else { return };
        let found = task.poll();
        if found.is_none() && !task.has_ended() {
            return;
        }
        self.files.inspecting = None;
        for (path, kind) in found.into_iter().flatten() {
            match kind {
                Dropped::Document => self.unless_unsaved(ui, Action::OpenFile(path)),
                Dropped::Palette(palette) => self.take_palette(self.session.active_layer, palette),
                Dropped::Picture => self.files.dropped.push_back(path),
                // Shown before any question about the open document.
                Dropped::Unreadable(why) => self.notices.wrong(why),
            }
        }
    }
}
