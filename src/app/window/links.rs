//! Documents in links: copied and opened.

use egui::Context;

use super::Window;
use crate::app::notice::with_causes;
use crate::app::pages::Answer;
use crate::document::link::{SHORT, SITE};
use crate::document::{Document, LinkError};
use crate::editor::session::Session;

/// A document that should be sent as a file.
pub struct Unlinked {
    /// The reason.
    pub why: String,
    /// Its link, where there is one.
    pub link: Option<String>,
}

impl Window {
    /// Copies a link that holds the document; offers the file where that is long, or where there is none.
    pub(super) fn copy_link(&mut self, ctx: &Context) {
        let document = self.session.finished();
        if document.layers.is_empty() {
            self.notices.done("There is nothing to link to yet. Draw at least one mark.");
            return;
        }
        match document.fragment() {
            Ok(fragment) if fragment.len() <= SHORT => self.copied_link(ctx, &fragment),
            Ok(fragment) => {
                let why = format!(
                    "The link has {} characters. Many programs that send messages cut links after {SHORT}.",
                    fragment.len()
                );
                self.files.unlinked = Some(Unlinked { why, link: Some(fragment) });
            }
            Err(error) => {
                let why = match &error {
                    LinkError::Model { file } => {
                        format!("The model \"{file}\" is a file, which a link cannot hold.")
                    }
                    LinkError::TooLarge | LinkError::TooLong { .. } => {
                        "The document is too large for a link, as documents with pictures mostly are."
                            .to_owned()
                    }
                    other => with_causes(other),
                };
                self.files.unlinked = Some(Unlinked { why, link: None });
            }
        }
    }

    fn copied_link(&mut self, ctx: &Context, fragment: &str) {
        ctx.copy_text(format!("{}{fragment}", self.settings.site));
        // No browser finds the reserved address.
        let how = if self.settings.site == SITE {
            " Paste it into dapple to open it, or set the address of your page in Preferences."
        } else {
            ""
        };
        let length = fragment.len();
        self.notices.done(format!("Copied a link that holds this document, {length} characters.{how}"));
    }

    /// Carries out the answer to whether the document should rather be sent as a file.
    pub(super) fn answered_about_link(&mut self, ctx: &Context, unlinked: Unlinked, answer: Answer) {
        match (answer, unlinked.link) {
            (Answer::Yes, _) => self.save_as(),
            (Answer::No, Some(fragment)) => self.copied_link(ctx, &fragment),
            _ => {}
        }
    }

    /// Opens the document in a link. Saving asks for a file name.
    pub(super) fn open_link(&mut self, link: &str) {
        match Document::from_link(link) {
            Ok(document) => {
                self.page = None;
                self.begin(Session::open(document, None));
            }
            Err(error) => self.notices.wrong(with_causes(&error)),
        }
    }
}
