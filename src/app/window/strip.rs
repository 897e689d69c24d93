//! The row of small pictures below sketch and texture: the alternatives, or else what the active layer can become, or what
//! an empty sketch can begin with.

use egui::{Context, Frame, Panel, Ui};

use super::Window;
use crate::app::action::Action;
use crate::app::panels;
use crate::app::presentation::Presentation;
use crate::app::small_screen::is_narrow;

/// Least height of a window in which pictures of what the layer can become have room, points.
const ROOM_FOR_GOALS: f32 = 560.0;

impl Window {
    /// The row of small pictures below sketch and texture: the alternatives, or else what the layer can become.
    pub(super) fn strip(&mut self, ui: &mut Ui, bar: Frame, actions: &mut Vec<Action>) {
        if self.alternatives.shown && !self.panels_hidden {
            let strip = Panel::bottom("alternatives").frame(bar).resizable(false);
            strip.exact_size(panels::ALTERNATIVES).show(ui, |ui| {
                actions.extend(panels::alternatives(ui, &mut self.alternatives, &self.growth));
            });
        } else if self.shows_goals(ui.ctx()) {
            let strip = Panel::bottom("goals").frame(bar).resizable(false).exact_size(panels::GOALS);
            strip.show(ui, |ui| {
                if self.is_blank() {
                    let room = ui.available_rect_before_wrap();
                    actions.extend(panels::starters(ui, room, room.with_max_y(room.top())));
                } else {
                    actions.extend(panels::goals(ui, &mut self.goals, &self.session, &self.growth));
                }
            });
        }
    }

    /// Whether nothing is drawn, nor being drawn.
    pub(super) fn is_blank(&self) -> bool {
        self.session.is_empty() && !self.canvas.is_busy()
    }

    /// Whether there are pictures of what the layer can become: not in a low window, nor in place of the alternatives.
    pub(super) fn shows_goals(&self, ctx: &Context) -> bool {
        let has_room = !is_narrow(ctx) && ctx.content_rect().height() >= ROOM_FOR_GOALS;
        let is_free = !self.alternatives.shown && !self.panels_hidden;
        self.goals.shown && has_room && is_free && self.presentation == Presentation::Full
    }

    pub(super) fn follow_goals(&mut self, ui: &Ui, busy: bool) {
        let states = [self.shows_goals(ui.ctx()), self.canvas.is_busy(), busy];
        let (wait, error) = self.goals.follow(&self.tasks, (&self.session, &self.growth), states);
        self.report(error);
        if let Some(wait) = wait {
            ui.ctx().request_repaint_after(wait);
        }
    }
}
