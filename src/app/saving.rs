//! Saves the document beside the window. A save that has begun is finished, whatever becomes of the window.

use std::path::{Path, PathBuf};

use super::notice::with_causes;
use crate::document::Document;
use crate::editor::task::{Task, Tasks, Worker};

/// A save that is being done. Dropping it waits for its end.
pub struct Saving {
    /// The file.
    pub path: PathBuf,
    /// The document as it was edited when the save began; it may have empty layers, which the file has not.
    pub document: Document,
    /// Whether the document shall be saved again afterwards, and where.
    pub again: Option<PathBuf>,
    task: Option<Task<Result<(), String>>>,
    /// What came of it where no thread could be started.
    outcome: Option<Result<(), String>>,
}

impl Saving {
    /// Writes `finished` to `path`; `document` is what it was made from.
    #[must_use]
    pub fn start(path: &Path, document: &Document, finished: &Document, tasks: &Tasks) -> Self {
        let (file, copy) = (path.to_owned(), finished.clone());
        let work = move |worker: &Worker<_>| worker.send(write(&copy, &file));
        let task = tasks.start("saving", work).ok();
        // Without a thread the window waits: the work is saved all the same.
        let outcome = task.is_none().then(|| write(finished, path));
        Self { path: path.to_owned(), document: document.clone(), again: None, task, outcome }
    }

    /// What came of it, once it is over; never waits.
    pub fn poll(&mut self) -> Option<Result<(), String>> {
        let Some(task) = &mut self.task else { return self.outcome.take() };
        let outcome = task.poll();
        if outcome.is_none() && task.has_ended() {
            return Some(Err(format!("{}: saving it failed inside dapple", self.path.display())));
        }
        outcome
    }

    /// Waits for its end.
    pub fn wait(&mut self) -> Result<(), String> {
        if let Some(task) = &mut self.task {
            task.wait();
        }
        self.poll().unwrap_or(Ok(()))
    }
}

impl Drop for Saving {
    fn drop(&mut self) {
        if let Some(task) = &mut self.task {
            task.wait();
        }
    }
}

fn write(document: &Document, path: &Path) -> Result<(), String> {
    document.write(path).map_err(|error| with_causes(&error))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Layer, Stroke};
    use crate::editor::task::Spawn;
    use crate::marks::Ellipse;

    fn document() -> Document {
        let ellipse = Ellipse { center: [50.0, 40.0], radii: [12.0, 6.0], angle: 30.0 };
        let layer =
            Layer { name: "a".to_owned(), strokes: vec![Stroke::Ellipse(ellipse)], ..Layer::default() };
        Document { layers: vec![layer], ..Document::default() }
    }

    #[test]
    fn a_save_that_is_dropped_at_once_is_finished() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.dapple");
        drop(Saving::start(&path, &document(), &document(), &Tasks::default()));
        assert_eq!(Document::read(&path).unwrap(), document());
    }

    #[test]
    fn it_is_saved_where_no_thread_starts_and_errors_are_reported() {
        let folder = tempfile::tempdir().unwrap();
        let tasks = Tasks::default().with_spawn(Spawn(|_, _| Err(std::io::Error::other("none left"))));
        for tasks in [tasks, Tasks::default()] {
            let path = folder.path().join("a.dapple");
            Saving::start(&path, &document(), &document(), &tasks).wait().unwrap();
            assert_eq!(Document::read(&path).unwrap(), document());
            let nowhere = folder.path().join("nowhere/a.dapple");
            let why = Saving::start(&nowhere, &document(), &document(), &tasks).wait().unwrap_err();
            assert!(why.contains("a.dapple"), "{why}");
        }
    }
}
