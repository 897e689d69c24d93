//! Saves the document on a background thread. A save that has started is finished, even if the window closes meanwhile.

use std::path::{Path, PathBuf};

use super::task::Tasks;
use super::writing::Writing;
use crate::document::{Document, with_causes};
use crate::files::WriteFile;

/// A save that is being done. Dropping it waits for its end.
pub struct Saving {
    /// The file.
    pub path: PathBuf,
    /// The document as it was edited when the save started. It may have empty layers; the file has none.
    pub document: Document,
    /// Where the document is to be saved again afterwards; `None` = it is not.
    pub again: Option<PathBuf>,
    /// The running save; `None` once its end was waited for.
    work: Option<Writing<Result<(), String>>>,
}

impl Saving {
    /// Writes `finished` to `path`; `document` is what it was made from.
    #[must_use]
    pub fn start(path: &Path, document: &Document, finished: Document, tasks: &Tasks) -> Self {
        let file = path.to_owned();
        let work = Writing::start(tasks, "saving", move || write(&finished, &file));
        Self { path: path.to_owned(), document: document.clone(), again: None, work: Some(work) }
    }

    /// The outcome, once it is over; never waits.
    pub fn poll(&mut self) -> Option<Result<(), String>> {
        let outcome = self.work.as_mut()?.poll()?;
        Some(self.with_file(outcome))
    }

    /// Waits for its end.
    pub fn wait(&mut self) -> Result<(), String> {
        let outcome = self.work.take().and_then(Writing::wait);
        outcome.map_or(Ok(()), |outcome| self.with_file(outcome))
    }

    /// The outcome; an error is preceded by the file's name.
    fn with_file(&self, outcome: Result<Result<(), String>, &str>) -> Result<(), String> {
        outcome.unwrap_or_else(|why| Err(format!("{}: saving: {why}", self.path.display())))
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
    use crate::files::ReadFile;
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
        drop(Saving::start(&path, &document(), document(), &Tasks::default()));
        assert_eq!(Document::read(&path).unwrap(), document());
    }

    #[test]
    fn a_document_is_saved_where_no_thread_starts_and_errors_are_reported() {
        let folder = tempfile::tempdir().unwrap();
        let tasks = Tasks::default().with_spawn(Spawn(|_, _| Err(std::io::Error::other("none left"))));
        for tasks in [tasks, Tasks::default()] {
            let path = folder.path().join("a.dapple");
            Saving::start(&path, &document(), document(), &tasks).wait().unwrap();
            assert_eq!(Document::read(&path).unwrap(), document());
            let nowhere = folder.path().join("nowhere/a.dapple");
            let why = Saving::start(&nowhere, &document(), document(), &tasks).wait().unwrap_err();
            assert!(why.contains("a.dapple"), "{why}");
        }
    }
}
