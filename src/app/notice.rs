//! What has to be said: read, copied, put away.

use std::path::{Path, PathBuf};

use egui::{Align2, Area, Context, Frame, Id, Label, Order, RichText, vec2};

pub use crate::document::with_causes;

use super::theme::Palette;

/// Notices that are not put away yet.
#[derive(Default)]
pub struct Notices {
    all: Vec<Notice>,
    /// When the last thing that was done was first seen, seconds.
    seen: Option<f64>,
}

/// Something that has to be said.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Notice {
    /// What.
    pub text: String,
    /// Did something go wrong?
    pub wrong: bool,
    /// The file or folder that it is about.
    pub place: Option<PathBuf>,
}

/// Notices that are shown at most; the oldest go.
const MOST: usize = 4;
/// Seconds after which nobody needs to be told any more what was done.
const DONE: f64 = 4.0;
/// The same where there is something to be looked at.
const WRITTEN: f64 = 15.0;

impl Notices {
    /// Something went wrong.
    pub fn wrong(&mut self, text: impl Into<String>) {
        self.push(Notice { text: text.into(), wrong: true, place: None });
    }

    /// Something was done.
    pub fn done(&mut self, text: impl Into<String>) {
        // What was done is known by the next thing that is.
        self.all.retain(|notice| notice.wrong);
        self.seen = None;
        self.push(Notice { text: text.into(), wrong: false, place: None });
    }

    /// A file or a folder was written.
    pub fn written(&mut self, place: &Path, text: impl Into<String>) {
        self.done(text);
        if let Some(notice) = self.all.last_mut() {
            notice.place = Some(place.to_owned());
        }
    }

    fn push(&mut self, notice: Notice) {
        self.all.retain(|other| *other != notice);
        self.all.push(notice);
        if self.all.len() > MOST {
            self.all.remove(0);
        }
    }

    /// All of them, the oldest first.
    #[must_use]
    pub fn all(&self) -> &[Notice] {
        &self.all
    }

    /// Shows them in the lower middle.
    pub fn ui(&mut self, ctx: &Context) {
        if self.all.iter().any(|notice| !notice.wrong) {
            let now = ctx.time();
            let since = *self.seen.get_or_insert(now);
            let stays = |notice: &Notice| if notice.place.is_some() { WRITTEN } else { DONE };
            self.all.retain(|notice| notice.wrong || now - since < stays(notice));
            ctx.request_repaint_after_secs(1.0);
        }
        if self.all.is_empty() {
            return;
        }
        let mut away = None;
        Area::new(Id::unique("notices"))
            .order(Order::Foreground)
            .anchor(Align2::CENTER_BOTTOM, vec2(0.0, -44.0))
            .show(ctx, |ui| {
                for (index, notice) in self.all.iter().enumerate() {
                    Frame::window(ui.style()).inner_margin(12).show(ui, |ui| {
                        ui.set_max_width(520.0);
                        ui.horizontal_top(|ui| {
                            let colours = Palette::current(ui.visuals());
                            let text = RichText::new(&notice.text);
                            let text = if notice.wrong { text.color(colours.wrong) } else { text };
                            ui.vertical(|ui| {
                                ui.set_max_width(400.0);
                                ui.add(Label::new(text).wrap().selectable(true));
                            });
                            if notice.wrong && ui.button("Copy").on_hover_text("Copy the text").clicked() {
                                ctx.copy_text(notice.text.clone());
                            }
                            if let Some(place) = &notice.place
                                && ui
                                    .button("Show")
                                    .on_hover_text("Show the folder in which it lies")
                                    .clicked()
                            {
                                show_folder(place);
                            }
                            if ui.button("OK").on_hover_text("Put this notice away").clicked() {
                                away = Some(index);
                            }
                        });
                    });
                }
            });
        if let Some(index) = away {
            self.all.remove(index);
        }
    }
}

/// Opens the folder of `place` in the system's file manager. Where that fails, the notice still says where it is.
fn show_folder(place: &Path) {
    let folder = if place.is_dir() { place } else { place.parent().unwrap_or(place) };
    let _ = open::that_detached(folder);
}
