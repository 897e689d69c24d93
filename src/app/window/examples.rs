//! Opens examples. They are read on another thread, because a browser has to load them first.

use egui::Ui;

use super::Window;
use crate::app::action::Action;
use crate::app::asset::Asset;
use crate::app::examples::{self, Example};
use crate::app::notice::with_causes;
use crate::app::platform;
use crate::document::Document;
use crate::editor::session::Session;
use crate::editor::task::{Task, Worker};
use crate::machine::clock::Instant;

/// A longer wait is reported to the user, seconds.
const LONG: f64 = 0.3;

/// What an example is read for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum ExampleUse {
    /// To be opened.
    Open,
    /// For its marks, which an empty canvas gets.
    Begin,
    /// For all that is on it, which replaces an empty canvas.
    Tile,
}

/// An example that is being read.
pub struct ReadingExample {
    example: &'static Example,
    wanted: ExampleUse,
    task: Task<Result<Document, String>>,
    began: Instant,
    /// The session's revision at that time.
    revision: u64,
    /// Whether the wait was reported.
    told: bool,
}

impl Window {
    /// Reads an example, and opens it or takes its marks once it is read.
    pub(super) fn read_example(&mut self, ui: &Ui, name: &str, wanted: ExampleUse) {
        let Some(example) = examples::named(name) else { return };
        let work = move |worker: &Worker<_>| worker.send(read(example.document));
        match self.tasks.start("reading an example", work) {
            Ok(task) => {
                // The page of examples would cover the message.
                self.page = None;
                let (began, revision) = (Instant::now(), self.session.revision());
                self.files.example =
                    Some(ReadingExample { example, wanted, task, began, revision, told: false });
                ui.ctx().request_repaint_after_secs(LONG as f32);
            }
            Err(error) => self.notices.wrong(error.to_string()),
        }
    }

    pub(super) fn listen_to_example(&mut self) {
        let Some(reading) = &mut self.files.example else { return };
        let read = reading.task.poll();
        if read.is_none() && !reading.task.has_ended() {
            if reading.began.elapsed().as_secs_f64() >= LONG {
                reading.told = true;
                self.notices.done(format!("Loading {} …", reading.example.title));
            }
            return;
        }
        let Some(reading) = self.files.example.take() else { return };
        match read {
            None => {
                self.notices
                    .wrong("Reading the example failed because of an error in dapple. Please report it.");
            }
            Some(Err(why)) => self.notices.wrong(why),
            Some(Ok(document)) if reading.wanted != ExampleUse::Open => self.take(document, reading.wanted),
            // The user has drawn something in the meantime.
            Some(Ok(_)) if reading.revision != self.session.revision() && self.has_unsaved() => {
                self.files.unsaved = Some(Action::Example(reading.example.name));
            }
            Some(Ok(document)) => {
                self.begin(Session::open(document, None));
                if reading.told {
                    self.notices.done(format!("Opened {}", reading.example.title));
                }
            }
        }
    }

    /// Puts the marks of an example, or all that is on it, on the canvas, which is empty unless the user has drawn something in
    /// the meantime.
    fn take(&mut self, document: Document, wanted: ExampleUse) {
        if self.session.is_empty() {
            match wanted {
                ExampleUse::Tile => self.session.begin_as(document),
                ExampleUse::Open | ExampleUse::Begin => self.session.begin_with(document),
            }
            self.session.selection.clear();
        }
    }
}

fn read(document: Asset) -> Result<Document, String> {
    let bytes = platform::asset_read(document).map_err(|error| error.to_string())?;
    Document::from_bytes(&bytes, document.name).map_err(|error| with_causes(&error))
}
