//! The columns beside sketch and texture: the tools on the left; tabs and layers on the right. Both can be hidden, the right
//! one has a width that the user sets.

use egui::{Context, Frame, Margin, Panel, Rect, Sense, Ui, UiBuilder};

use super::Window;
use crate::app::action::{Action, Tab};
use crate::app::growth::Growth;
use crate::app::panels;
use crate::app::result::{Drawn, Outcome, Results};
use crate::app::settings::COLUMN_WIDTHS;
use crate::app::small_screen::is_narrow;

impl Window {
    /// The tools.
    pub(super) fn tools(&self, ui: &mut Ui) -> Option<Action> {
        if !self.shows_tools(ui.ctx()) {
            return None;
        }
        let frame = Frame::side_top_panel(ui.style()).inner_margin(Margin::symmetric(6, 8));
        let tools = Panel::left("tools").frame(frame).resizable(false).exact_size(50.0);
        tools.show(ui, |ui| panels::tools(ui, self.canvas.tool, &self.session)).inner
    }

    /// Whether the tools are shown: on a narrow screen, not beside the column on the right.
    pub(super) fn shows_tools(&self, ctx: &Context) -> bool {
        let has_room = !(is_narrow(ctx) && self.unfolded);
        self.settings.layout.tools && has_room && !self.panels_hidden
    }

    /// Shows the tools, or hides them.
    pub(super) fn show_tools(&mut self, shown: bool) {
        self.settings.layout.tools = shown;
        self.panels_hidden &= !shown;
    }

    /// Whether the column on the right is shown: on a narrow screen only while it is unfolded.
    pub(super) fn shows_column(&self, ctx: &Context) -> bool {
        let is_chosen = if is_narrow(ctx) { self.unfolded } else { self.settings.layout.column };
        is_chosen && !self.panels_hidden
    }

    /// Shows the column on the right, or hides it.
    pub(super) fn show_column(&mut self, ctx: &Context, shown: bool) {
        self.panels_hidden &= !shown;
        let column = if is_narrow(ctx) { &mut self.unfolded } else { &mut self.settings.layout.column };
        *column = shown;
    }

    /// Reserves the place of the column on the right. Its content is shown after sketch and texture, so that the Tab
    /// key goes from left to right. The width is the one in the settings, until the user drags its edge.
    pub(super) fn column_place(&mut self, ui: &mut Ui) -> Option<Rect> {
        if !self.shows_column(ui.ctx()) {
            return None;
        }
        let frame = Frame::side_top_panel(ui.style()).inner_margin(Margin::symmetric(14, 10));
        let width = self.settings.layout.column_width;
        let [low, high] = COLUMN_WIDTHS;
        let column = Panel::right("inspector").frame(frame).resizable(true).default_size(width);
        let shown = column.size_range(low..=high).show(ui, |ui| {
            let room = ui.available_rect_before_wrap();
            ui.allocate_rect(room, Sense::hover());
            room
        });
        self.settings.layout.column_width = shown.response.rect.width();
        Some(shown.inner)
    }

    /// The content of the column at its place.
    pub(super) fn column(&mut self, ui: &mut Ui, place: Rect) -> Vec<Action> {
        // A separate area: content that is too wide is cut off, and does not widen the column.
        let mut inside = ui.new_child(UiBuilder::new().max_rect(place).id_salt("column"));
        inside.shrink_clip_rect(place.expand(2.0));
        self.column_content(&mut inside)
    }

    fn column_content(&mut self, ui: &mut Ui) -> Vec<Action> {
        let (session, canvas, ruler) = (&self.session, &self.canvas, self.ruler());
        let layers = |ui: &mut Ui| panels::layers(ui, session, &mut self.layers);
        let content = |ui: &mut Ui| match self.tab {
            Tab::Draw => {
                let drawn = drawn(&self.results, &self.growth, self.grown == Some(session.revision()));
                panels::draw(ui, &panels::DrawState { session, canvas, drawn, ruler })
            }
            Tab::Canvas => {
                let (tiled, linked) = (self.texture.tiled, self.linked);
                let (document, overlays, reference) =
                    (session.document(), canvas.overlays, &canvas.reference);
                let snap = canvas.snap;
                panels::canvas(
                    ui,
                    &panels::CanvasState { document, overlays, reference, snap, ruler, tiled, linked },
                )
            }
            Tab::Colour => panels::colour(ui, session, &mut self.colour),
            Tab::Result => {
                let pointer = canvas.pointer.or(self.texture.pointer);
                let (growth, results) = (&self.growth, &self.results);
                let shown = panels::ResultState { session, growth, results, pointer, ruler };
                panels::result(ui, &shown, &mut self.result_panel)
            }
        };
        let outcome = self.results.for_texture(self.growth.texture.as_ref());
        let is_missed = outcome.is_some_and(Outcome::is_missed);
        panels::column(ui, self.tab, is_missed, layers, content)
    }
}

/// What has grown of the drawn marks; nothing where the sketch has changed since it was grown.
pub(super) fn drawn<'a>(results: &'a Results, growth: &'a Growth, is_current: bool) -> Drawn<'a> {
    if is_current {
        Drawn::new(results.for_texture(growth.texture.as_ref()), growth)
    } else {
        Drawn::default()
    }
}
