//! File dialogs: the system's own where it has one, else one that dapple shows.

use std::path::{Path, PathBuf};

use egui::text::{CCursor, CCursorRange};
use egui::text_edit::TextEditState;
use egui::{Button, Id, Key, ScrollArea, TextEdit, Ui, vec2};

use crate::app::platform;
use crate::app::purpose::Purpose;
use crate::editor::folder::{self, Kind, Listing};
use crate::editor::task::{StartError, Task, Tasks};

/// The state of a dialog.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Choice {
    /// This file was chosen.
    Chosen(PathBuf),
    /// It was closed without a choice.
    Nothing,
    /// It is open.
    Waiting,
}

/// Width of the dialog that dapple shows, points.
const WIDTH: f32 = 480.0;

/// A file dialog.
pub struct Chooser {
    /// What the file is for.
    pub purpose: Purpose,
    /// The system's dialog; without one, our own is shown.
    system: Option<Task<Option<PathBuf>>>,
    tasks: Tasks,
    folder: PathBuf,
    name: String,
    entries: Vec<(String, bool)>,
    /// The folder that is being listed.
    listing: Option<Task<Listing>>,
    /// The path that was chosen, while dapple checks what is there.
    checking: Option<(PathBuf, Task<Kind>)>,
    /// Why a folder cannot be listed.
    problem: Option<String>,
    /// The existing file about which the user was asked. If it is chosen again, it is replaced.
    replaces: Option<PathBuf>,
    fresh: bool,
}

impl Chooser {
    /// Begins in the folder of `at`. `native` starts the system's dialog; without it, or where the system has none, our
    /// own dialog is shown.
    #[must_use]
    pub fn new(purpose: Purpose, at: Option<&Path>, name: &str, tasks: &Tasks, native: bool) -> Self {
        let folder = platform::folder_of(at);
        let native = native && platform::has_dialog_to(purpose.writes());
        let system = native.then(|| platform::system_dialog(purpose, &folder, name, tasks).ok()).flatten();
        let mut chooser = Self {
            purpose,
            system,
            tasks: tasks.clone(),
            folder,
            name: name.to_owned(),
            entries: Vec::new(),
            listing: None,
            checking: None,
            problem: None,
            replaces: None,
            fresh: true,
        };
        if chooser.is_ours() {
            chooser.follow(folder::list_resolved(&chooser.folder, purpose.endings(), tasks));
        }
        chooser
    }

    /// Whether the dialog is shown by dapple, not by the system.
    #[must_use]
    pub fn is_ours(&self) -> bool {
        self.system.is_none()
    }

    /// The state of the system's dialog; never waits.
    pub fn listen(&mut self) -> Choice {
        let Some(task) = &mut self.system else { return Choice::Waiting };
        match task.poll() {
            Some(Some(path)) => self.named(path),
            None if !task.has_ended() => Choice::Waiting,
            Some(None) | None => Choice::Nothing,
        }
    }

    /// The choice, where the system's dialog gives `path`. Where an ending is added to it, the system has not asked whether
    /// a file of that name is replaced: our own dialog does, if there is one.
    fn named(&mut self, path: PathBuf) -> Choice {
        let written = self.purpose.with_ending(path.clone());
        if written == path {
            return Choice::Chosen(path);
        }
        self.system = None;
        self.name = written.file_name().unwrap_or_default().to_string_lossy().into_owned();
        self.enter(written.parent().unwrap_or(Path::new(".")).to_owned());
        self.check(written)
    }

    /// Whether a folder or file is being read.
    #[must_use]
    pub fn is_busy(&self) -> bool {
        self.listing.is_some() || self.checking.is_some()
    }

    fn enter(&mut self, folder: PathBuf) {
        (self.replaces, self.checking) = (None, None);
        self.entries.clear();
        let listing = folder::list(&folder, self.purpose.endings(), &self.tasks);
        self.folder = folder;
        self.follow(listing);
    }

    fn follow(&mut self, listing: Result<Task<Listing>, StartError>) {
        self.problem = listing.as_ref().err().map(ToString::to_string);
        self.listing = listing.ok();
    }

    fn listen_to_listing(&mut self) {
        let Some(task) = &mut self.listing else { return };
        if let Some(listing) = task.poll() {
            (self.folder, self.entries, self.listing) = (listing.folder, listing.entries, None);
        } else if task.has_ended() {
            self.listing = None;
        }
    }

    /// Shows the contents of dapple's own dialog.
    pub fn ui(&mut self, ui: &mut Ui) -> Choice {
        self.listen_to_listing();
        let mut choice = self.checked();
        ui.set_width(WIDTH.min(ui.ctx().content_rect().width() - 60.0));
        ui.heading(self.purpose.title());
        ui.add_space(4.0);
        let mut chosen = platform::HAS_FOLDERS && self.folder_ui(ui);
        ui.horizontal(|ui| {
            let label = ui.label(if self.purpose == Purpose::ExportInto { "Folder" } else { "File" });
            let edit = TextEdit::singleline(&mut self.name).desired_width(ui.available_width());
            let shown = edit.show(ui);
            let edit = shown.response.response.labelled_by(label.id);
            if std::mem::take(&mut self.fresh) {
                edit.request_focus();
                select_stem(ui, edit.id, shown.state, &self.name);
            }
            if edit.changed() {
                (self.replaces, self.checking) = (None, None);
            }
            let is_elsewhere = ui.memory(|memory| memory.focused().is_some()) && !edit.lost_focus();
            chosen |= !is_elsewhere && ui.input(|input| input.key_pressed(Key::Enter));
        });
        let path = self.path();
        if let Some(there) = &self.replaces {
            let name = there.file_name().unwrap_or_default().to_string_lossy().into_owned();
            let text = match self.purpose {
                Purpose::ExportInto => {
                    format!("{name} is not empty. Files of the same name will be replaced.")
                }
                _ => format!("{name} already exists. Replace it?"),
            };
            ui.colored_label(ui.visuals().warn_fg_color, text);
        }
        if let Some(problem) = &self.problem {
            ui.colored_label(ui.visuals().error_fg_color, problem);
        }
        ui.add_space(4.0);
        let buttons = vec2(ui.available_width(), 28.0);
        ui.allocate_ui_with_layout(buttons, egui::Layout::right_to_left(egui::Align::Center), |ui| {
            let verb = if self.replaces.is_some() { "Replace" } else { self.purpose.verb() };
            let button =
                ui.add_enabled(!self.name.trim().is_empty(), Button::new(verb).min_size(vec2(90.0, 28.0)));
            chosen |= button.clicked();
            if ui.add(Button::new("Cancel").min_size(vec2(80.0, 28.0))).clicked() {
                choice = Choice::Nothing;
            }
        });
        if chosen && choice == Choice::Waiting && !self.name.trim().is_empty() {
            choice = self.check(path);
        }
        choice
    }

    /// The folder and its files. Returns whether a file was chosen.
    fn folder_ui(&mut self, ui: &mut Ui) -> bool {
        ui.horizontal(|ui| {
            let up = self.folder.parent().map(Path::to_owned);
            let button = ui.add_enabled(up.is_some(), Button::new("Up")).on_hover_text("The folder above");
            if let (true, Some(up)) = (button.clicked(), up) {
                self.enter(up);
            }
            ui.weak(self.folder.display().to_string());
        });
        self.entries_ui(ui)
    }

    fn entries_ui(&mut self, ui: &mut Ui) -> bool {
        let mut chosen = false;
        let mut enter = None;
        let height = 240.0;
        ScrollArea::vertical().max_height(height).min_scrolled_height(height).auto_shrink([false; 2]).show(
            ui,
            |ui| {
                if self.entries.is_empty() && self.listing.is_none() {
                    ui.weak("No matching files in this folder.");
                }
                for (name, folder) in &self.entries {
                    let text = if *folder { format!("{name}/") } else { name.clone() };
                    let row = ui.selectable_label(!folder && *name == self.name, text);
                    if row.clicked() {
                        if *folder {
                            enter = Some(self.folder.join(name));
                        } else {
                            self.name.clone_from(name);
                            self.replaces = None;
                        }
                    }
                    chosen |= !folder && row.double_clicked();
                }
            },
        );
        if let Some(folder) = enter {
            self.enter(folder);
        }
        chosen
    }

    /// The path of the typed name, which may be a whole path.
    fn path(&self) -> PathBuf {
        self.purpose.with_ending(self.folder.join(self.name.trim()))
    }

    /// Checks what is at `path`; [`Self::checked`] continues. Where no thread can be started, the window blocks until
    /// that is done.
    fn check(&mut self, path: PathBuf) -> Choice {
        match folder::look_at(&path, &self.tasks) {
            Ok(task) => {
                self.checking = Some((path, task));
                Choice::Waiting
            }
            Err(_) => {
                let kind = folder::kind(&path);
                self.choose(path, kind)
            }
        }
    }

    /// The choice, once the check of the chosen path has ended.
    fn checked(&mut self) -> Choice {
        let Some((_, task)) = &mut self.checking else { return Choice::Waiting };
        let kind = task.poll();
        if kind.is_none() && !task.has_ended() {
            return Choice::Waiting;
        }
        match (self.checking.take(), kind) {
            (Some((path, _)), Some(kind)) => self.choose(path, kind),
            _ => Choice::Waiting,
        }
    }

    fn choose(&mut self, path: PathBuf, kind: Kind) -> Choice {
        let is_folder = matches!(kind, Kind::Folder | Kind::EmptyFolder);
        if is_folder && self.purpose != Purpose::ExportInto {
            self.name.clear();
            self.enter(path);
            return Choice::Waiting;
        }
        let would_replace = if self.purpose == Purpose::ExportInto {
            kind == Kind::Folder
        } else {
            self.purpose.writes() && kind == Kind::File
        };
        if would_replace && self.replaces.as_ref() != Some(&path) {
            self.replaces = Some(path);
            return Choice::Waiting;
        }
        Choice::Chosen(path)
    }
}

/// Selects the proposed `name` in the field `id`, without its ending, so that typing replaces it.
fn select_stem(ui: &Ui, id: Id, mut state: TextEditState, name: &str) {
    let stem = Path::new(name).file_stem().unwrap_or_default().to_string_lossy().chars().count();
    state.cursor.set_char_range(Some(CCursorRange::two(CCursor::new(0), CCursor::new(stem))));
    state.store(ui.ctx(), id);
}
