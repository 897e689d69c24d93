//! Unsaved work outlives a crash: what is not in a file yet is kept in a slot of the window's own, and what a window
//! that is no more had kept is offered at the next start.

mod keeper;
mod page;
mod slot;

pub use page::page;

use std::path::PathBuf;
use std::time::{Duration, Instant};

use egui::{Context, Ui};

use super::Window;
use super::action::Page;
use crate::document::Document;
use crate::editor::session::Session;
use crate::marks::Mark;
use keeper::{Keeper, News};
use slot::{Kept, Lost};

/// A stroke that takes longer is kept before it is finished, and again after as long.
const LONG: Duration = Duration::from_millis(1500);

/// What a window keeps, and what others had kept.
pub struct Recovery {
    folder: Option<PathBuf>,
    keeper: Option<Keeper>,
    /// What was lost and is not decided on, the latest first.
    lost: Vec<Lost>,
    /// How many they were when they were last looked at.
    left: usize,
    /// The one that is about to be discarded for good.
    doubt: Option<String>,
    /// Restored documents that this window has to keep from now on.
    settling: Vec<Lost>,
    /// Revision that was last handed over, and whether there was something to keep.
    seen: Option<(u64, bool)>,
    /// When it was; is a stroke in it that was not finished then?
    since: Instant,
    is_pending: bool,
    is_kept: bool,
    /// Whatever comes, nothing is kept any more.
    is_over: bool,
    has_failed: bool,
}

impl Recovery {
    /// Keeps in `folder`; without one, nothing is kept. Gives what has to be said too.
    #[must_use]
    pub fn new(folder: Option<PathBuf>) -> (Self, Vec<String>) {
        let mut recovery = Self {
            folder,
            keeper: None,
            lost: Vec::new(),
            left: 0,
            doubt: None,
            settling: Vec::new(),
            seen: None,
            since: Instant::now(),
            is_pending: false,
            is_kept: false,
            is_over: false,
            has_failed: false,
        };
        let troubles = recovery.look();
        (recovery, troubles)
    }

    /// Looks for what was lost; it is ours until [`Self::later`].
    pub fn look(&mut self) -> Vec<String> {
        self.lost.clear();
        let Some(folder) = &self.folder else { return Vec::new() };
        let found = slot::find(folder);
        self.lost = found.lost;
        self.left = self.lost.len();
        found.troubles
    }

    /// Nothing is decided: the next start, or the next look, offers it again.
    pub fn later(&mut self) {
        self.left = self.lost.len();
        self.lost.clear();
        self.doubt = None;
    }

    /// How many there are to decide on.
    #[must_use]
    pub fn left(&self) -> usize {
        self.left
    }

    /// Another document was opened.
    pub fn begin(&mut self) {
        self.seen = None;
    }

    /// Is it time to keep a stroke that is not finished?
    #[must_use]
    pub fn is_due(&self) -> bool {
        self.folder.is_some() && self.since.elapsed() >= LONG
    }

    /// Hands what has changed to the thread: the document, and with it a mark that is `pending` in the hand.
    /// Gives how long the last writing took, or why it failed.
    pub fn watch(
        &mut self,
        ctx: &Context,
        session: &Session,
        pending: Option<Mark>,
    ) -> Option<Result<Duration, String>> {
        let changed = (session.is_changed() || pending.is_some()) && !self.is_over;
        // The unfinished mark is in the document by now, or was dropped.
        let let_go = self.is_pending && pending.is_none() && self.is_due();
        if self.seen != Some((session.revision(), changed)) || pending.is_some() || let_go {
            self.seen = Some((session.revision(), changed));
            self.since = Instant::now();
            self.is_pending = pending.is_some();
            let document = match pending {
                Some(mark) => {
                    let mut session = session.clone();
                    session.add(&[mark]);
                    session.finished()
                }
                None => session.finished(),
            };
            if changed && !document.layers.is_empty() {
                let kept = Kept { document, path: session.path.clone(), name: session.title() };
                self.start(ctx);
                if let Some(keeper) = &self.keeper {
                    keeper.keep(kept, std::mem::take(&mut self.settling));
                    self.is_kept = true;
                }
            } else if self.is_kept
                && let Some(keeper) = &self.keeper
            {
                keeper.clear();
                self.is_kept = false;
            }
        }
        match self.keeper.as_ref()?.news()? {
            News::Kept(took) => {
                self.has_failed = false;
                Some(Ok(took))
            }
            // Said once, until it works again.
            News::Failed(_) if std::mem::replace(&mut self.has_failed, true) => None,
            News::Failed(why) => Some(Err(why)),
        }
    }

    /// The open document need not be kept any more.
    pub fn end(&mut self) {
        self.is_over = true;
    }

    /// Starts the thread, if it does not run yet.
    fn start(&mut self, ctx: &Context) {
        if let (None, Some(folder)) = (&self.keeper, &self.folder) {
            let ctx = ctx.clone();
            self.keeper = Keeper::start(folder, move || ctx.request_repaint());
        }
    }

    fn position(&self, id: &str) -> Option<usize> {
        self.lost.iter().position(|lost| lost.id() == id)
    }
}

impl Window {
    /// Shows what was lost, or puts the page away.
    pub(super) fn show_lost(&mut self, shown: bool) {
        if shown {
            for trouble in self.recovery.look() {
                self.notices.wrong(trouble);
            }
        } else {
            self.recovery.later();
        }
    }

    /// Opens a recovered document; it is kept by this window from now on.
    pub(super) fn restore(&mut self, id: &str) {
        let Some(index) = self.recovery.position(id) else { return };
        let lost = self.recovery.lost.remove(index);
        let Kept { document, path, .. } = lost.kept.clone();
        let saved = path.as_deref().and_then(|path| Document::read(path).ok()).unwrap_or_default();
        let name = lost.kept.name.clone();
        self.begin(Session::open_unsaved(document, saved, path));
        self.recovery.settling.push(lost);
        self.page = None;
        self.recovery.later();
        self.notices.done(format!("{name} is back as it was. It is not saved yet."));
    }

    /// Forgets what was lost, for good.
    pub(super) fn discard(&mut self, id: &str) {
        let Some(index) = self.recovery.position(id) else { return };
        if let Err(error) = self.recovery.lost.remove(index).remove() {
            self.notices.wrong(format!("It could not be discarded: {error}"));
        }
        self.recovery.left = self.recovery.lost.len();
        if self.recovery.lost.is_empty() && self.page == Some(Page::Recovery) {
            self.page = None;
        }
    }

    /// Hands what changed to the thread that keeps it.
    pub(super) fn keep_unsaved(&mut self, ui: &Ui) {
        self.trace.marks(self.session.marks().count());
        let pending = self.recovery.is_due().then(|| self.canvas.in_the_making()).flatten();
        match self.recovery.watch(ui.ctx(), &self.session, pending) {
            Some(Ok(took)) => self.trace.event("kept", took),
            Some(Err(why)) => self.notices.wrong(format!(
                "Unsaved changes cannot be kept safe against a crash: {why}. Save them yourself now and then."
            )),
            None => {}
        }
    }
}
