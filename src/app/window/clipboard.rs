//! The system's clipboard: text, SVG, links and pictures are pasted; marks, links and the texture are copied.

use std::io;
use std::sync::Arc;

use egui::{ColorImage, Context, Ui};

use super::Window;
use crate::app::action::Action;
use crate::app::growth::image;
use crate::app::platform::{self, Copied};
use crate::document::Document;
use crate::document::link::is_link;
use crate::editor::reading::{self, ReadingSvg};
use crate::editor::task::{Task, Worker};
use crate::synth::render::painting::Painting;

/// The size of a picture, px, and what is copied of it.
type Painted = ([usize; 2], io::Result<Copied>);

/// Pictures and drawings that are being copied or pasted.
#[derive(Default)]
pub struct Clipboard {
    /// The texture that is being painted, to be copied.
    painting: Option<Task<Painted>>,
    /// A pasted SVG that is being read, and the place for its marks, px.
    drawing: Option<(ReadingSvg, Option<[f64; 2]>)>,
}

impl Clipboard {
    /// Whether a picture or drawing is being copied or pasted.
    #[must_use]
    pub fn is_busy(&self) -> bool {
        self.painting.is_some() || self.drawing.is_some()
    }

    /// Another document is open: an SVG that is still being read was not meant for it.
    pub fn document_opened(&mut self) {
        self.drawing = None;
    }
}

impl Window {
    /// Copies the selected marks to the system's clipboard.
    pub(super) fn copy(&mut self, ui: &Ui) {
        if let Some(text) = self.session.copy() {
            ui.ctx().copy_text(text);
        }
    }

    /// Copies the settled texture as a picture. It is painted on another thread.
    pub(super) fn copy_picture(&mut self) {
        let Some(texture) = self.growth.texture.clone() else {
            self.notices.done("There is no finished texture to copy yet.");
            return;
        };
        let work = move |worker: &Worker<_>| {
            let painting = Painting::new(&texture.document, &texture.grown, 1);
            let picture = image(&painting);
            worker.send((picture.size, platform::for_clipboard(picture)));
        };
        match self.tasks.start("copying the texture", work) {
            Ok(task) => self.clipboard.painting = Some(task),
            Err(error) => self.notices.wrong(error.to_string()),
        }
    }

    /// Opens the document of a link. Adds the marks of a document or of an SVG that is given as text: at the pointer, or where the menu
    /// was opened.
    pub(super) fn paste(&mut self, ui: &Ui, text: &str) {
        if is_link(text) {
            self.unless_unsaved(ui, Action::OpenLink(text.to_owned()));
            return;
        }
        if !self.can_add() {
            return;
        }
        let at = self.context.at.take().or(self.canvas.pointer);
        if reading::is_svg(text) {
            match reading::read_svg(text.to_owned(), &self.tasks) {
                Ok(task) => self.clipboard.drawing = Some((task, at)),
                Err(error) => self.notices.wrong(error.to_string()),
            }
        } else if self.session.paste(text, at, self.copy_offset()).is_ok() {
            self.use_select();
        } else {
            self.notices.wrong(
                "The clipboard holds no marks. What can be pasted: marks copied in dapple, the text of a document, a link to one, an \
                 SVG, a picture to draw over.",
            );
        }
    }

    /// Takes a picture from the clipboard as reference picture.
    pub(super) fn paste_picture(&mut self, picture: Arc<ColorImage>) {
        let loading = self.canvas.reference.take_picture(picture, "Pasted picture", false, &self.tasks);
        self.report(loading.err());
    }

    /// Receives pictures that were painted and drawings that were read.
    pub(super) fn listen_to_clipboard(&mut self, ctx: &Context) {
        self.listen_to_painting(ctx);
        let Some((task, at)) = &mut self.clipboard.drawing else { return };
        let (read, at) = (task.poll(), *at);
        if read.is_none() && !task.has_ended() {
            return;
        }
        self.clipboard.drawing = None;
        match read {
            Some(Ok((document, unread))) => self.add_drawing(document, at, &unread),
            Some(Err(why)) => self.notices.wrong(why),
            None => self
                .notices
                .wrong("Reading the clipboard failed because of an error in dapple. Please report it."),
        }
    }

    fn listen_to_painting(&mut self, ctx: &Context) {
        let Some(task) = &mut self.clipboard.painting else { return };
        let painted = task.poll();
        if painted.is_none() && !task.has_ended() {
            return;
        }
        self.clipboard.painting = None;
        match painted {
            Some(([width, height], Ok(picture))) => {
                platform::copy(ctx, picture);
                self.notices.done(format!("Copied the texture as a picture, {width} × {height} px."));
            }
            Some((_, Err(error))) => self.notices.wrong(format!("The texture cannot be copied: {error}")),
            None => self
                .notices
                .wrong("Painting the texture failed because of an error in dapple. Please report it."),
        }
    }

    fn add_drawing(&mut self, document: Document, at: Option<[f64; 2]>, unread: &str) {
        if !self.can_add() {
            return;
        }
        let marks = self.session.paste_document(document, at, self.copy_offset());
        self.use_select();
        let many = if marks == 1 { "mark" } else { "marks" };
        let text = format!("Pasted {marks} {many} from an SVG{unread}.");
        // A message about parts that were left out stays until the user closes it.
        if unread.is_empty() { self.notices.done(text) } else { self.notices.wrong(text) }
    }
}
