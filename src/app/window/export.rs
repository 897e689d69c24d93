//! Export: the dialog, the file, the message when it is written.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use egui::Ui;

use super::Window;
use crate::app::exporting::{self, DialogAction, ExportContext};
use crate::app::exporting::{
    Choices, Dialog, ExportKind, ExportRequest, Exporting, Film, FinishedPreview, Size,
};
use crate::app::platform;
use crate::app::purpose::Purpose;
use crate::app::small_screen;
use crate::machine::clock::Instant;
use crate::synth::Grown;

impl Window {
    /// Opens the export dialog.
    pub(super) fn ask_export(&mut self) {
        let size = self.files.restored.unwrap_or_default();
        let choices = Choices { size, layer: None, ..self.settings.export.clone() };
        self.files.export = Some(Dialog::new(choices));
    }

    /// The preview of the export dialog, once it is finished.
    #[must_use]
    pub fn previewed(&self) -> Option<Arc<FinishedPreview>> {
        let dialog = self.files.export.as_ref()?;
        dialog.preview.finished(&self.request(&dialog.choices)).cloned()
    }

    /// The choices in the export dialog.
    #[must_use]
    pub fn choices(&self) -> Option<&Choices> {
        self.files.export.as_ref().map(|dialog| &dialog.choices)
    }

    fn request(&self, choices: &Choices) -> ExportRequest {
        ExportRequest { document: self.session.finished(), choices: choices.clone(), title: self.stem() }
    }

    /// The file name of exports, without an ending.
    fn stem(&self) -> String {
        match self.session.path.as_deref().and_then(Path::file_stem) {
            Some(stem) => file_name(&stem.to_string_lossy()),
            None => file_name(&self.session.title()),
        }
    }

    fn grown(&self) -> Option<Arc<Grown>> {
        self.growth.texture.as_ref().map(|texture| Arc::clone(&texture.grown))
    }

    /// Shows the dialog.
    pub(super) fn export_ui(&mut self, ui: &Ui) {
        let Some(mut dialog) = self.files.export.take() else { return };
        dialog.choices.make_consistent();
        let request = self.request(&dialog.choices);
        let grown = self.grown();
        let context = ExportContext {
            request: &request,
            grown: grown.as_ref(),
            growing: self.growth.is_growing(),
            tasks: &self.tasks,
            threads: self.settings.threads,
            units: self.settings.units,
        };
        let shown = small_screen::dialog(ui.ctx(), "export", 20, |ui| dialog.ui(ui, &context));
        let action = if shown.should_close() { Some(DialogAction::Cancel) } else { shown.inner };
        match action {
            Some(DialogAction::Cancel) => return,
            Some(DialogAction::Export) => self.choose_export(&dialog.choices),
            Some(DialogAction::ChooseOther) => self.choose(Purpose::Become, ""),
            None => {}
        }
        self.files.export = Some(dialog);
    }

    fn choose_export(&mut self, choices: &Choices) {
        let exported = self.files.exported.as_deref().filter(|_| choices.ending().is_some());
        let stem = exported.and_then(Path::file_stem).map(|stem| stem.to_string_lossy().into_owned());
        let stem = stem.unwrap_or_else(|| self.stem());
        match choices.ending() {
            Some(ending) => {
                let endings = match ending {
                    "tif" => &["tif", "tiff"][..],
                    "jpg" => &["jpg", "jpeg"],
                    "apng" => &["png", "apng"],
                    "png" => &["png"],
                    "exr" => &["exr"],
                    "webp" => &["webp"],
                    "svg" => &["svg"],
                    "dxf" => &["dxf"],
                    _ => &["gif"],
                };
                let name = format!("{stem}.{}", endings[0]);
                self.choose(Purpose::Export(endings), &name);
            }
            None => {
                let kind = if choices.what == ExportKind::Material { "material" } else { "frames" };
                self.choose(Purpose::ExportInto, &format!("{stem}-{kind}"));
            }
        }
    }

    /// Exports to `path` with the choices of the dialog, and remembers them.
    pub(super) fn export_chosen(&mut self, path: &Path) {
        let Some(dialog) = self.files.export.take() else { return };
        let request = self.request(&dialog.choices);
        if let Err(why) = self.nothing_is_written().and_then(|()| exporting::check(path, &request)) {
            // Another place or format can be chosen.
            self.notices.wrong(why);
            self.files.export = Some(dialog);
            return;
        }
        self.settings.export_folder = path.parent().map(Path::to_owned);
        self.files.exported = Some(path.to_owned());
        self.settings.export = Choices {
            size: Size::default(),
            layer: None,
            film: Film { to: None, change: false, ..dialog.choices.film.clone() },
            ..dialog.choices.clone()
        };
        self.settings.write_soon();
        let grown = self.grown();
        let made = dialog.preview.finished(&request).cloned();
        let grown = dialog.preview.grown(&request, grown.as_ref());
        self.files.exporting = Some(dialog);
        self.exporting = Some(Exporting::new(path, request, made, grown, self.settings.threads, &self.tasks));
    }

    /// An error while an export is being written: another one would cancel it.
    fn nothing_is_written(&self) -> Result<(), String> {
        self.exporting.as_ref().map_or(Ok(()), |job| {
            Err(format!(
                "{} is still being written. Wait for it, or cancel it in the line at the bottom.",
                platform::shown(&job.path)
            ))
        })
    }

    /// Sets the document with which a film ends.
    pub(super) fn become_chosen(&mut self, path: PathBuf) {
        if let Some(dialog) = &mut self.files.export {
            dialog.choices.film.to = Some(path);
            dialog.choices.film.change = true;
        }
    }

    /// Writes the texture to `path`: of a canvas of `canvas` px (`None` = the document's), with `scale` times the px.
    pub fn export(&mut self, path: &Path, canvas: Option<[u32; 2]>, scale: u32) {
        let request = self.request(&Choices::plain(Size { canvas, scale }));
        let grown = self.grown().filter(|grown| request.takes(grown));
        self.exporting = Some(Exporting::new(path, request, None, grown, self.settings.threads, &self.tasks));
    }

    /// Cancels the export that is being written.
    pub(super) fn cancel_export(&mut self) {
        if let Some(exporting) = &self.exporting {
            exporting.cancel();
            self.files.cancelled = Some(Instant::now());
        }
    }

    /// Shows a message once the export has ended.
    pub(super) fn listen_to_export(&mut self, ui: &Ui) {
        let Some(job) = &mut self.exporting else { return };
        let Some(outcome) = job.outcome() else {
            ui.ctx().request_repaint_after(std::time::Duration::from_millis(100));
            return;
        };
        match outcome {
            Ok(message) => {
                let message = message.map(|message| format!("\n{message}")).unwrap_or_default();
                platform::hand_over(&job.path);
                let text = format!("Written: {}{message}", platform::shown(&job.path));
                self.notices.written(&job.path, text);
            }
            Err(_) if job.is_cancelled() => {
                self.notices.done("Export cancelled. Nothing was written.");
                if let Some(since) = self.files.cancelled.take() {
                    self.trace.event("cancelled", since.elapsed());
                }
            }
            Err(why) => {
                self.notices.wrong(why);
                // Another place or format can be chosen.
                if !self.is_asking() {
                    self.files.export = self.files.exporting.take();
                }
            }
        }
        (self.exporting, self.files.exporting) = (None, None);
    }
}

/// A name as that of a file or a folder: without quotes and brackets, which have a meaning in command lines, without
/// characters that file names cannot hold, and with single blanks.
fn file_name(name: &str) -> String {
    let is_quote = |c: &char| "\"'`“”„‟‘’‚‛«»‹›".contains(*c);
    let is_blank = |c: char| "()[]{}<>/\\:*?|".contains(c) || c.is_control();
    let left = name.chars().filter(|c| !is_quote(c));
    let plain: String = left.map(|c| if is_blank(c) { ' ' } else { c }).collect();
    let words: Vec<&str> = plain.split_whitespace().collect();
    let tidy = words.join(" ").replace(" ,", ",").trim_matches(['.', ',', ' ']).to_owned();
    if tidy.is_empty() { "untitled".to_owned() } else { tidy }
}

#[cfg(test)]
mod tests {
    use super::file_name;

    #[test]
    fn names_of_exports_have_no_quotes_brackets_or_double_blanks() {
        for (name, written) in [
            ("leopard: rosettes (Turk 1991, fig. 2)", "leopard rosettes Turk 1991, fig. 2"),
            ("the \"best\"  one [2]", "the best one 2"),
            ("‘a’ {b}, <c>/d\\e", "a b, c d e"),
            ("cat's coat", "cats coat"),
            ("()", "untitled"),
            ("plain-name_1.2", "plain-name_1.2"),
        ] {
            assert_eq!(file_name(name), written);
        }
    }
}
