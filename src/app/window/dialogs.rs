//! Pages and questions over the window: examples, shortcuts, preferences, file choosers, unsaved changes.

use egui::{Event, Key, Ui};

use super::Window;
use crate::app::action::{Action, Page};
use crate::app::chooser::Choice;
use crate::app::pages::{self, Answer};
use crate::app::small_screen::{dialog, fit_width};
use crate::app::{preferences, recovery, shortcuts};

impl Window {
    /// Pages over the window.
    pub(super) fn over_all(&mut self, ui: &mut Ui) -> Vec<Action> {
        let mut actions = Vec::new();
        // The key that closes a file dialog must not answer the dialog behind it.
        let choosing = self.files.chooser.is_some();
        self.choosing(ui);
        self.asking(ui);
        if !choosing && self.files.chooser.is_none() {
            self.export_ui(ui);
            if self.files.asked.is_none() {
                actions.extend(self.photo_ui(ui));
            }
        }
        if let Some(page) = self.page
            && !self.files.is_asking()
        {
            actions.extend(self.page_ui(ui, page));
        }
        self.notices.ui(ui.ctx());
        actions
    }

    /// The dialog that is open, for the log.
    pub(super) fn open_dialog(&self) -> &'static str {
        if self.files.chooser.is_some() {
            return "file";
        }
        match (self.files.asked, self.page) {
            (Some(question), _) => question,
            _ if self.files.export.is_some() => "export",
            _ if self.files.photo.is_some() => "photograph",
            (None, Some(Page::Recovery)) => "recovery",
            (None, Some(_)) => "page",
            (None, None) => "none",
        }
    }

    fn page_ui(&mut self, ui: &Ui, page: Page) -> Option<Action> {
        let mut action = None;
        let mut close = false;
        let shown = dialog(ui.ctx(), "page", 22, |ui| {
            match page {
                Page::Hint => action = pages::hint(ui),
                Page::Examples => {
                    ui.heading("Examples");
                    action = self.gallery.ui(ui, &self.tasks);
                }
                Page::Shortcuts => {
                    fit_width(ui, 620.0);
                    ui.heading("Keyboard shortcuts");
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
            let shown = dialog(ui.ctx(), "chooser", 20, |ui| chooser.ui(ui));
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
                self.chosen(purpose, path);
            }
        }
    }

    fn asking(&mut self, ui: &Ui) {
        let title = self.session.title();
        let units = self.settings.units;
        let files = &mut self.files;
        let question = if files.unsaved.is_some() {
            Some("unsaved changes")
        } else if self.canvas.question.is_some() {
            Some("another layer")
        } else if files.unlinked.is_some() {
            Some("link")
        } else if !files.dropped.is_empty() {
            Some("dropped picture")
        } else {
            files.new.is_some().then_some("new document")
        };
        // Enter must not answer the question where it ends the typing of a number, or where it was pressed before the
        // question appeared.
        let is_seen = std::mem::replace(&mut files.asked, question) == question;
        let enter = is_seen && enter(ui) && ui.memory(|memory| memory.focused().is_none());
        let Some(question) = question else { return };
        let shown = if files.unsaved.is_some() {
            dialog(ui.ctx(), question, 20, |ui| pages::unsaved(ui, &title))
        } else if let Some(drawn) = &self.canvas.question {
            dialog(ui.ctx(), question, 20, |ui| pages::another_layer(ui, &drawn.mark))
        } else if let Some(unlinked) = &files.unlinked {
            dialog(ui.ctx(), question, 20, |ui| pages::unlinked(ui, &unlinked.why, unlinked.link.is_some()))
        } else if let Some(path) = files.dropped.front() {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            dialog(ui.ctx(), question, 20, |ui| pages::dropped_picture(ui, &name))
        } else if let Some(new) = &mut files.new {
            dialog(ui.ctx(), question, 20, |ui| new.ui(ui, units))
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
                    self.save(None);
                }
                Answer::No => self.go_on(ui, action),
                Answer::Third | Answer::Cancel => {}
            }
        } else if let Some(drawn) = self.canvas.question.take() {
            if answer == Answer::Yes {
                self.session.add_freehand(drawn.mark, &drawn.points);
            }
        } else if let Some(unlinked) = self.files.unlinked.take() {
            self.answered_about_link(ui.ctx(), unlinked, answer);
        } else if let Some(path) = self.files.dropped.pop_front() {
            self.dropped_picture(&path, answer);
        } else if let Some(new) = self.files.new.take()
            && answer == Answer::Yes
        {
            self.create(&new);
        }
    }
}

/// Whether Enter was pressed in this frame, and not held since an earlier one.
fn enter(ui: &Ui) -> bool {
    let is_enter =
        |event: &Event| matches!(event, Event::Key { key: Key::Enter, pressed: true, repeat: false, .. });
    ui.input(|input| input.events.iter().any(is_enter))
}
