//! Small sketches of the recent documents, read on another thread when their list is shown.

use std::path::{Path, PathBuf};

use super::session::Session;
use super::task::{StartError, Task, Tasks, Worker};
use crate::document::Document;
use crate::files::ReadFile;
use crate::marks::Mark;

/// The most marks that a small sketch has: more could not be told apart.
const MARKS: usize = 200;

/// A small sketch.
pub struct RecentSketch {
    /// Width and height of the canvas, px.
    pub size: [u32; 2],
    /// The marks, with the index of their layer.
    pub marks: Vec<(usize, Mark)>,
}

/// A document of the list, and its sketch; `None` where it cannot be read.
type Read = (PathBuf, Option<RecentSketch>);

/// The sketches that are known, and those that are being read.
#[derive(Default)]
pub struct RecentSketches {
    known: Vec<Read>,
    reading: Option<Task<Read>>,
}

impl RecentSketches {
    /// Reads the sketches of these documents that are not known.
    ///
    /// # Errors
    /// Where no thread can be started.
    pub fn read(&mut self, paths: &[PathBuf], tasks: &Tasks) -> Result<(), StartError> {
        self.known.retain(|(path, _)| paths.contains(path));
        let paths: Vec<PathBuf> = paths.iter().filter(|path| self.of(path).is_none()).cloned().collect();
        let work = move |worker: &Worker<Read>| {
            for path in paths.into_iter().take_while(|_| !worker.is_cancelled()) {
                let sketch = sketch(&path);
                worker.send((path, sketch));
            }
        };
        self.reading = Some(tasks.start("reading the recent documents", work)?);
        Ok(())
    }

    /// Forgets the sketch of a document that has changed.
    pub fn forget(&mut self, path: &Path) {
        self.known.retain(|(known, _)| known != path);
    }

    /// Receives sketches that were read; never waits.
    pub fn listen(&mut self) {
        while let Some((path, sketch)) = self.reading.as_mut().and_then(Task::poll) {
            self.forget(&path);
            self.known.push((path, sketch));
        }
        if self.reading.as_ref().is_some_and(Task::has_ended) {
            self.reading = None;
        }
    }

    /// Whether sketches are being read.
    #[must_use]
    pub fn is_busy(&self) -> bool {
        self.reading.is_some()
    }

    /// The sketch of a document; `None` while it is not known, `Some(None)` where the document cannot be read.
    #[must_use]
    pub fn of(&self, path: &Path) -> Option<Option<&RecentSketch>> {
        self.known.iter().find(|(known, _)| known == path).map(|(_, sketch)| sketch.as_ref())
    }
}

fn sketch(path: &Path) -> Option<RecentSketch> {
    let session = Session::open(Document::read(path).ok()?, None);
    let marks = session.marks().take(MARKS).map(|(place, mark)| (place.layer, mark)).collect();
    Some(RecentSketch { size: session.document().size, marks })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sketches_are_read_and_files_that_are_gone_are_known_to_be() {
        let here = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/zebra.dapple");
        let paths = [here.clone(), PathBuf::from("/nowhere/at/all.dapple")];
        let mut sketches = RecentSketches::default();
        assert!(sketches.of(&here).is_none());
        sketches.read(&paths, &Tasks::default()).unwrap();
        while sketches.is_busy() {
            sketches.listen();
        }
        assert!(!sketches.of(&here).unwrap().unwrap().marks.is_empty());
        assert!(sketches.of(&paths[1]).unwrap().is_none());
        sketches.forget(&here);
        assert!(sketches.of(&here).is_none(), "it is read again");
    }
}
