//! Unsaved work in the window: it is backed up while it changes, and offered at the next start.

use egui::Ui;

use super::Window;
use crate::app::action::Page;

impl Window {
    /// Receives the results of searching and deleting, and offers what was found at the start.
    pub(super) fn listen_to_recovery(&mut self, ui: &Ui) {
        for error in self.recovery.listen() {
            self.notices.wrong(error);
        }
        let Some(began) = self.offer.filter(|_| !self.recovery.is_searching()) else { return };
        // Does not interrupt what the user has begun in the meantime.
        let is_free = matches!(self.page, None | Some(Page::Hint)) && !self.files.is_asking();
        let is_busy = self.canvas.is_busy() || self.menu_open || ui.input(|input| input.pointer.any_down());
        if !self.recovery.lost().is_empty() && self.page != Some(Page::Recovery) {
            if !is_free || is_busy {
                return;
            }
            self.page = Some(Page::Recovery);
        }
        self.offer = None;
        self.trace.event("searched", began.elapsed());
    }

    /// Offers lost documents, or ends the offer.
    pub(super) fn show_lost(&mut self, shown: bool) {
        self.discard_asked = None;
        if shown {
            let searching = self.recovery.search();
            self.report(searching.err());
        } else {
            self.recovery.postpone();
        }
    }

    /// Opens a lost document; it is not saved yet.
    pub(super) fn restore(&mut self, id: &str) {
        let Some((session, name)) = self.recovery.restore(id) else { return };
        self.begin(session);
        self.page = None;
        self.discard_asked = None;
        self.notices.done(format!("{name} is restored. It is not saved yet."));
    }

    /// Deletes a lost document.
    pub(super) fn discard(&mut self, id: &str) {
        self.recovery.discard(id);
        if self.recovery.lost().is_empty() && self.page == Some(Page::Recovery) {
            self.page = None;
        }
    }

    /// Backs up unsaved work, in case of a crash.
    pub(super) fn keep_unsaved(&mut self) {
        self.trace.marks(self.session.marks().count());
        let pending = self.recovery.is_due().then(|| self.canvas.pending_mark()).flatten();
        match self.recovery.update(&self.session, pending) {
            Some(Ok(took)) => self.trace.event("kept", took),
            Some(Err(why)) => {
                self.notices.wrong(format!("Unsaved changes cannot be backed up: {why}. Save often."));
            }
            None => {}
        }
    }
}
