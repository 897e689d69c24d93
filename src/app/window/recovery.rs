//! Unsaved work in the window: it is kept while it changes, and offered at the next start.

use super::Window;
use crate::app::action::Page;

impl Window {
    /// Offers lost documents, or ends the offer.
    pub(super) fn show_lost(&mut self, shown: bool) {
        self.discard_asked = None;
        if shown {
            for error in self.recovery.search() {
                self.notices.wrong(error);
            }
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
        self.notices.done(format!("{name} is back as it was. It is not saved yet."));
    }

    /// Deletes a lost document.
    pub(super) fn discard(&mut self, id: &str) {
        if let Err(error) = self.recovery.discard(id) {
            self.notices.wrong(format!("It could not be discarded: {error}"));
        }
        if self.recovery.lost().is_empty() && self.page == Some(Page::Recovery) {
            self.page = None;
        }
    }

    /// Keeps unsaved work against a crash.
    pub(super) fn keep_unsaved(&mut self) {
        self.trace.marks(self.session.marks().count());
        let pending = self.recovery.is_due().then(|| self.canvas.pending_mark()).flatten();
        match self.recovery.update(&self.session, pending) {
            Some(Ok(took)) => self.trace.event("kept", took),
            Some(Err(why)) => self.notices.wrong(format!(
                "Unsaved changes cannot be kept safe against a crash: {why}. Save them yourself now and then."
            )),
            None => {}
        }
    }
}
