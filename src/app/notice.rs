//! Messages to the user, at the bottom of the window, centred.

use std::path::{Path, PathBuf};

use egui::{Align2, Area, Context, Frame, Id, Label, Order, Rect, RichText, vec2};

pub use crate::document::with_causes;

use super::platform;
use super::theme::Palette;

/// The notices that are shown.
#[derive(Default)]
pub struct Notices {
    all: Vec<Notice>,
    /// When the last notice of success was first shown, seconds.
    seen: Option<f64>,
    /// Whether a notice has not been drawn yet.
    unshown: bool,
    /// Where they are shown, at the bottom; `None` = in the whole window.
    room: Option<Rect>,
}

/// A message to the user.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Notice {
    /// The message.
    pub text: String,
    /// Whether it reports an error.
    pub wrong: bool,
    /// The file or folder that it is about, which *Show* opens.
    pub place: Option<PathBuf>,
}

/// Most notices at a time; the oldest are removed.
const MOST: usize = 4;
/// Width that is reserved for the buttons beside the text, points.
const BUTTONS: f32 = 120.0;
/// Seconds for which a notice of success is shown.
const DONE: f64 = 4.0;
/// Seconds for which a notice of success is shown that has a file or folder to open.
const WRITTEN: f64 = 15.0;

impl Notices {
    /// Reports an error; it stays until the user removes it.
    pub fn wrong(&mut self, text: impl Into<String>) {
        self.push(Notice { text: text.into(), wrong: true, place: None });
    }

    /// Reports success; it replaces the last such notice.
    pub fn done(&mut self, text: impl Into<String>) {
        self.all.retain(|notice| notice.wrong);
        self.seen = None;
        self.push(Notice { text: text.into(), wrong: false, place: None });
    }

    /// Reports that a file or folder was written.
    pub fn written(&mut self, place: &Path, text: impl Into<String>) {
        self.done(text);
        if let Some(notice) = self.all.last_mut() {
            notice.place = platform::HAS_FOLDERS.then(|| place.to_owned());
        }
    }

    fn push(&mut self, notice: Notice) {
        self.unshown = true;
        self.all.retain(|other| *other != notice);
        self.all.push(notice);
        if self.all.len() > MOST {
            self.all.remove(0);
        }
    }

    /// All notices, the oldest first.
    #[must_use]
    pub fn all(&self) -> &[Notice] {
        &self.all
    }

    /// Whether a notice has come since they were last drawn, so that another frame is needed.
    #[must_use]
    pub fn needs_frame(&self) -> bool {
        self.unshown
    }

    /// Sets the part of the window in which notices are shown, so that they do not cover the panels.
    pub fn keep_in(&mut self, room: Rect) {
        self.room = Some(room);
    }

    /// Shows them.
    pub fn ui(&mut self, ctx: &Context) {
        self.unshown = false;
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
        let room = self.room.unwrap_or_else(|| ctx.content_rect());
        let wide = (room.width() - 16.0).min(520.0);
        Area::new(Id::unique("notices"))
            .order(Order::Foreground)
            .pivot(Align2::CENTER_BOTTOM)
            .fixed_pos(room.center_bottom() - vec2(0.0, 16.0))
            .show(ctx, |ui| {
                for (index, notice) in self.all.iter().enumerate() {
                    Frame::window(ui.style()).inner_margin(12).show(ui, |ui| {
                        ui.set_max_width(wide);
                        ui.horizontal_top(|ui| {
                            let colours = Palette::current(ui.visuals());
                            let text = RichText::new(&notice.text);
                            let text = if notice.wrong { text.color(colours.wrong) } else { text };
                            ui.vertical(|ui| {
                                ui.set_max_width(wide - BUTTONS);
                                ui.add(Label::new(text).wrap().selectable(true));
                            });
                            if notice.wrong && ui.button("Copy").on_hover_text("Copy the text").clicked() {
                                ctx.copy_text(notice.text.clone());
                            }
                            if let Some(place) = &notice.place
                                && ui.button("Show").on_hover_text("Show its folder").clicked()
                            {
                                platform::show_folder(place);
                            }
                            if ui.button("OK").on_hover_text("Remove this notice").clicked() {
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
