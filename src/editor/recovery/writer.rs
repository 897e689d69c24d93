//! Writes recovery files on a background thread: where several documents wait, only the newest is written, and the
//! window never waits for the disk.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use super::backup::{BackupFile, LostDocument};
use super::format::Backup;
use crate::editor::task::{Task, Tasks, Worker};
use crate::machine::clock::Instant;
use crate::machine::sync::{Mutex, MutexGuard, PoisonError};

/// Least time between two writes. Together with the time that a slow disk takes, it is well below the five seconds of
/// work that a crash may cost.
const BETWEEN: Duration = Duration::from_millis(1500);

/// The result of a write.
#[derive(Debug)]
pub enum News {
    /// The backup is on the disk; writing it took this time.
    Written(Duration),
    /// The backup could not be written: why.
    Failed(String),
}

enum Job {
    Write(Box<Backup>),
    Clear,
}

#[derive(Default)]
struct Inbox {
    job: Option<Job>,
    /// Restored documents: the next backup holds them, after which their own files are deleted.
    restored: Vec<LostDocument>,
    /// Whether a task is taking jobs from this inbox.
    served: bool,
    /// The next write starts no earlier than this.
    not_before: Option<Instant>,
}

/// What the window and the task share.
struct Shared {
    folder: PathBuf,
    inbox: Mutex<Inbox>,
    file: Mutex<Option<BackupFile>>,
}

/// Writes the recovery file of one window.
pub struct Writer {
    tasks: Tasks,
    shared: Arc<Shared>,
    task: Option<Task<News>>,
    /// Results that earlier tasks sent and that were not read yet.
    unread: Vec<News>,
}

impl Writer {
    /// Writes to a file in `folder`.
    #[must_use]
    pub fn new(folder: &Path, tasks: Tasks) -> Self {
        let (inbox, file) = (Mutex::default(), Mutex::default());
        Self {
            tasks,
            shared: Arc::new(Shared { folder: folder.to_owned(), inbox, file }),
            task: None,
            unread: Vec::new(),
        }
    }

    /// Writes this backup instead of the last one. The files of `restored` are deleted once it is on the disk.
    pub fn write(&mut self, backup: Backup, restored: Vec<LostDocument>) {
        self.put(Job::Write(Box::new(backup)), restored);
    }

    /// Deletes the backup: there is no unsaved work any more.
    pub fn clear(&mut self) {
        self.put(Job::Clear, Vec::new());
    }

    fn put(&mut self, job: Job, restored: Vec<LostDocument>) {
        let mut inbox = self.shared.inbox();
        inbox.job = Some(job);
        inbox.restored.extend(restored);
        let served = std::mem::replace(&mut inbox.served, true);
        drop(inbox);
        if served && self.task.as_ref().is_some_and(|task| !task.is_finished()) {
            return;
        }
        if let Some(task) = self.task.take() {
            // The task takes no more jobs and ends at once.
            self.unread.extend(task.join());
        }
        let shared = Arc::clone(&self.shared);
        match self.tasks.start("recovery", move |worker| shared.serve(worker)) {
            Ok(task) => self.task = Some(task),
            Err(error) => {
                self.shared.inbox().served = false;
                self.unread.push(News::Failed(error.to_string()));
            }
        }
    }

    /// The results of the writes so far, one at a time; never blocks.
    pub fn news(&mut self) -> Option<News> {
        if self.unread.is_empty() {
            return self.task.as_mut().and_then(Task::poll);
        }
        Some(self.unread.remove(0))
    }
}

impl Drop for Writer {
    /// Does the jobs that are still waiting.
    fn drop(&mut self) {
        if let Some(task) = self.task.take() {
            // This ends the waiting of the task, not its work.
            task.cancel();
            task.join();
        }
        while let Ok(Some((job, restored))) = self.shared.take(false) {
            let failed = matches!(self.shared.carry_out(job, restored), Some(News::Failed(_)));
            if failed {
                return;
            }
        }
    }
}

impl Shared {
    fn inbox(&self) -> MutexGuard<'_, Inbox> {
        self.inbox.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The next job. `Ok(None)` = there is none, and no task serves the inbox any more. An error = the time before
    /// which no job may start.
    fn take(&self, may_wait: bool) -> Result<Option<(Job, Vec<LostDocument>)>, Instant> {
        let mut inbox = self.inbox();
        let not_before = inbox.not_before.filter(|time| may_wait && Instant::now() < *time);
        // Clearing need not wait.
        if let (Some(Job::Write(_)), Some(time)) = (&inbox.job, not_before) {
            return Err(time);
        }
        inbox.served = inbox.job.is_some();
        Ok(inbox.job.take().map(|job| (job, std::mem::take(&mut inbox.restored))))
    }

    /// Does one job after the other until there is none.
    fn serve(&self, worker: &Worker<News>) {
        loop {
            match self.take(!worker.is_cancelled()) {
                Err(until) => worker.sleep_until(until),
                Ok(None) => return,
                Ok(Some((job, restored))) => {
                    if let Some(news) = self.carry_out(job, restored) {
                        worker.send(news);
                    }
                }
            }
        }
    }

    fn carry_out(&self, job: Job, restored: Vec<LostDocument>) -> Option<News> {
        match job {
            Job::Clear => {
                delete(restored);
                let file = self.file.lock().unwrap_or_else(PoisonError::into_inner);
                let error = file.as_ref()?.clear().err()?;
                Some(News::Failed(format!("'{}': {error}", self.folder.display())))
            }
            Job::Write(backup) => {
                let began = Instant::now();
                let written = self.write(&backup);
                let mut inbox = self.inbox();
                inbox.not_before = Some(Instant::now() + BETWEEN);
                Some(match written {
                    Ok(()) => {
                        drop(inbox);
                        delete(restored);
                        News::Written(began.elapsed())
                    }
                    Err(why) => {
                        // Until a write succeeds, only their own files hold these documents.
                        inbox.restored.extend(restored);
                        News::Failed(why)
                    }
                })
            }
        }
    }

    fn write(&self, backup: &Backup) -> Result<(), String> {
        let mut file = self.file.lock().unwrap_or_else(PoisonError::into_inner);
        let file = match &mut *file {
            Some(file) => file,
            none => {
                let made = BackupFile::new(&self.folder);
                none.insert(made.map_err(|error| format!("'{}': {error}", self.folder.display()))?)
            }
        };
        file.write(backup).map_err(|error| error.to_string())
    }
}

fn delete(restored: Vec<LostDocument>) {
    for lost in restored {
        // A file that cannot be deleted is offered again, which is better than losing it.
        let _ = lost.delete();
    }
}
