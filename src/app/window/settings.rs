//! Writes the settings on another thread, one write after the other.

use super::Window;
use crate::editor::settings_file::Merged;
use crate::editor::writing::Writing;

/// The write of the settings that is running.
#[derive(Default)]
pub struct SettingsWriter {
    writing: Option<Writing<Merged>>,
    /// Whether a write has failed; that is reported once.
    has_failed: bool,
}

impl SettingsWriter {
    /// Whether a write is being done.
    #[must_use]
    pub fn is_busy(&self) -> bool {
        self.writing.is_some()
    }
}

impl Window {
    /// Starts to write the changed settings, once the earlier write has ended; never blocks.
    pub(super) fn write_settings(&mut self) {
        if let Some(writing) = &mut self.settings_writer.writing {
            let Some(outcome) = writing.poll() else { return };
            self.settings_writer.writing = None;
            self.settings_written(outcome);
        }
        if let Some(change) = self.settings.take_change() {
            let writing = Writing::start(&self.tasks, "saving the settings", || change.write());
            self.settings_writer.writing = Some(writing);
        }
    }

    fn settings_written(&mut self, outcome: Result<Merged, &str>) {
        let error = match outcome {
            Ok(Merged { recent, error }) => {
                self.settings.take_recent(recent);
                error
            }
            Err(why) => Some(format!("The settings cannot be saved: {why}")),
        };
        if let Some(error) = error
            && !std::mem::replace(&mut self.settings_writer.has_failed, true)
        {
            self.notices.wrong(error);
        }
    }

    /// Waits for the running write, and writes what has changed since, for example the placement of the window. An
    /// error is not shown, because the window is closed.
    pub(super) fn finish_settings(&mut self) {
        if let Some(Ok(merged)) = self.settings_writer.writing.take().and_then(Writing::wait) {
            self.settings.take_recent(merged.recent);
        }
        self.settings.write();
    }
}
