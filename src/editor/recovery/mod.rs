//! Keeps unsaved work safe from a crash: each window writes its unsaved work to a recovery file, and the files of
//! windows that have crashed are offered at the next start.

mod backup;
mod format;
mod writer;

use backup::{Found, find};

pub use backup::LostDocument;
pub use format::Backup;

use std::path::PathBuf;
use std::time::Duration;

use crate::editor::session::Session;
use crate::editor::task::{StartError, Task, Tasks, Worker};
use crate::editor::writing::Writing;
use crate::machine::clock::Instant;
use crate::marks::Mark;
use writer::{News, Writer};

/// A mark that takes longer than this to draw is backed up before it is finished, and again after each such time.
const LONG: Duration = Duration::from_millis(1500);

/// The unsaved work of a window, and the documents that other windows have lost.
pub struct Recovery {
    folder: Option<PathBuf>,
    tasks: Tasks,
    writer: Option<Writer>,
    search: Option<Task<Found>>,
    /// Whether the results of the search are offered to the user.
    is_offering: bool,
    /// Discarded documents that are being deleted.
    deleting: Vec<Writing<Result<(), String>>>,
    /// Lost documents that are being offered, the latest first.
    lost: Vec<LostDocument>,
    /// The number of lost documents at the last search.
    undecided: usize,
    /// Restored documents that are not yet in this window's own recovery file.
    restored: Vec<LostDocument>,
    /// The revision at the last update, and whether there was unsaved work.
    seen: Option<(u64, bool)>,
    /// The time of the last update that started a write.
    since: Instant,
    /// Whether that update held an unfinished mark.
    had_pending: bool,
    is_kept: bool,
    is_stopped: bool,
    has_failed: bool,
}

impl Recovery {
    /// Backs up unsaved work in `folder`; `None` = no backups. Does not search yet.
    #[must_use]
    pub fn new(folder: Option<PathBuf>, tasks: Tasks) -> Self {
        Self {
            folder,
            tasks,
            writer: None,
            search: None,
            is_offering: false,
            deleting: Vec::new(),
            lost: Vec::new(),
            undecided: 0,
            restored: Vec::new(),
            seen: None,
            since: Instant::now(),
            had_pending: false,
            is_kept: false,
            is_stopped: false,
            has_failed: false,
        }
    }

    /// Searches for lost documents on a background thread. No other window offers those that are found until
    /// [`Self::postpone`].
    ///
    /// # Errors
    /// Where no thread can be started.
    pub fn search(&mut self) -> Result<(), StartError> {
        self.is_offering = true;
        let Some(folder) = self.folder.clone().filter(|_| self.search.is_none()) else { return Ok(()) };
        let before = std::mem::take(&mut self.lost);
        let work = move |worker: &Worker<_>| {
            // Released first, so that the search finds them again.
            drop(before);
            worker.send(find(&folder));
        };
        self.search = Some(self.tasks.start("the search for unsaved work", work)?);
        Ok(())
    }

    /// Whether lost documents are being searched for.
    #[must_use]
    pub fn is_searching(&self) -> bool {
        self.search.is_some()
    }

    /// Whether lost documents are being searched for or deleted.
    #[must_use]
    pub fn is_busy(&self) -> bool {
        self.is_searching() || !self.deleting.is_empty()
    }

    /// Receives the results of searching and deleting; never blocks. Returns error messages.
    pub fn listen(&mut self) -> Vec<String> {
        let mut errors = Vec::new();
        self.deleting.retain_mut(|deleting| {
            let Some(outcome) = deleting.poll() else { return true };
            let error = outcome.unwrap_or_else(|why| Err(why.to_owned())).err();
            errors.extend(error.map(|error| format!("It could not be discarded: {error}")));
            false
        });
        let Some(search) = &mut self.search else { return errors };
        match search.poll() {
            Some(found) => {
                self.search = None;
                errors.extend(found.errors);
                self.undecided = found.lost.len();
                if self.is_offering {
                    self.lost = found.lost;
                }
            }
            None if search.has_ended() => {
                self.search = None;
                errors.push(
                    "Searching for unsaved work failed because of an error in dapple. Please report it."
                        .to_owned(),
                );
            }
            None => {}
        }
        errors
    }

    /// Ends the offer: the next start, or the next search, offers the documents again.
    pub fn postpone(&mut self) {
        self.is_offering = false;
        if !self.is_searching() {
            self.undecided = self.lost.len();
        }
        self.lost.clear();
    }

    /// The lost documents that are offered, the latest first.
    #[must_use]
    pub fn lost(&self) -> &[LostDocument] {
        &self.lost
    }

    /// The number of lost documents that were neither restored nor discarded.
    #[must_use]
    pub fn undecided(&self) -> usize {
        self.undecided
    }

    /// Restores the lost document `id`: the session to open, and its name. From the next [`Self::update`] on it is
    /// backed up as this window's own work.
    pub fn restore(&mut self, id: &str) -> Option<(Session, String)> {
        let lost = self.lost.remove(self.position(id)?);
        self.postpone();
        let Backup { document, path, name } = lost.backup.clone();
        let saved = lost.saved.clone().unwrap_or_default();
        self.restored.push(lost);
        Some((Session::open_unsaved(document, saved, path), name))
    }

    /// Deletes the lost document `id` on a background thread.
    pub fn discard(&mut self, id: &str) {
        let Some(index) = self.position(id) else { return };
        let lost = self.lost.remove(index);
        self.undecided = self.lost.len();
        let delete = move || lost.delete().map_err(|error| error.to_string());
        self.deleting.push(Writing::start(&self.tasks, "discarding unsaved work", delete));
    }

    fn position(&self, id: &str) -> Option<usize> {
        self.lost.iter().position(|lost| lost.id() == id)
    }

    /// Another document was opened.
    pub fn document_opened(&mut self) {
        self.seen = None;
    }

    /// Whether it is time to back up an unfinished mark.
    #[must_use]
    pub fn is_due(&self) -> bool {
        self.folder.is_some() && self.since.elapsed() >= LONG
    }

    /// Backs up what has changed since the last update: the session, and a mark that is being drawn. Returns how long
    /// the last write took, or why it failed; never blocks.
    pub fn update(&mut self, session: &Session, pending: Option<Mark>) -> Option<Result<Duration, String>> {
        let is_unsaved = (session.is_changed() || pending.is_some()) && !self.is_stopped;
        // By now the unfinished mark is part of the document, or was dropped.
        let was_finished = self.had_pending && pending.is_none() && self.is_due();
        let seen = Some((session.revision(), is_unsaved));
        if self.seen != seen || pending.is_some() || was_finished {
            self.seen = seen;
            self.since = Instant::now();
            self.had_pending = pending.is_some();
            self.keep(session, pending, is_unsaved);
        }
        match self.writer.as_mut()?.news()? {
            News::Written(took) => {
                self.has_failed = false;
                Some(Ok(took))
            }
            // A failure is reported once, until a write succeeds again.
            News::Failed(_) if std::mem::replace(&mut self.has_failed, true) => None,
            News::Failed(why) => Some(Err(why)),
        }
    }

    fn keep(&mut self, session: &Session, pending: Option<Mark>, is_unsaved: bool) {
        let document = match pending {
            Some(mark) => {
                let mut session = session.clone();
                session.add(&[mark]);
                session.finished()
            }
            None => session.finished(),
        };
        if is_unsaved && !document.layers.is_empty() {
            let Some(folder) = &self.folder else { return };
            let backup = Backup { document, path: session.path.clone(), name: session.title() };
            let writer = self.writer.get_or_insert_with(|| Writer::new(folder, self.tasks.clone()));
            writer.write(backup, std::mem::take(&mut self.restored));
            self.is_kept = true;
        } else if let Some(writer) = self.writer.as_mut().filter(|_| self.is_kept) {
            writer.clear();
            self.is_kept = false;
        }
    }

    /// Stops the backups: the work was saved, or the user does not want it.
    pub fn stop(&mut self) {
        self.is_stopped = true;
    }
}

#[cfg(test)]
mod tests;
