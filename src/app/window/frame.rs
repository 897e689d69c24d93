//! One frame: shows the panels, carries out their actions, then grows and keeps what changed.

use std::time::Duration;

use egui::{CentralPanel, Frame, Margin, Panel, Rect, Ui, UiBuilder, ViewportCommand, Visuals, pos2, vec2};

use super::Window;
use super::columns::drawn;
use super::places::Places;
use crate::app::action::{Action, Tab};
use crate::app::canvas::view::View;
use crate::app::growth::GrowthState;
use crate::app::panels::Signs;
use crate::app::presentation::Presentation;
use crate::app::small_screen::is_narrow;
use crate::app::theme::Palette;
use crate::app::{panels, shortcuts, texture};
use crate::editor::task::StartError;
use crate::machine::clock::Instant;

/// Least time between two frames that only the progress bar needs.
const PROGRESS: Duration = Duration::from_millis(100);

impl Window {
    /// Shows a whole frame.
    pub fn ui(&mut self, ui: &mut Ui) {
        self.take_picture(ui);
        self.canvas.between_frames = self.until_next_frame();
        let underlay = self.canvas.underlay.follow(ui, &self.session, &self.growth, &self.tasks);
        self.report(underlay.err());
        self.listen(ui);
        self.listen_to_recovery(ui);
        let is_shown = self.tab == Tab::Result;
        let error = self.results.follow(&self.tasks, self.growth.texture.as_ref(), is_shown);
        self.report(error);
        let waits = self.growth.may_settle_soon() && !self.is_drawing(ui);
        self.canvas.wanted.follow(&self.session, &self.tasks, waits);
        let mut actions = self.keys(ui);
        self.dropped(ui);
        let busy = self.is_drawing(ui);
        let error = self.alternatives.follow(&self.tasks, &self.session, &self.growth, busy);
        self.report(error);
        self.follow_goals(ui, busy);
        if self.presentation == Presentation::Full {
            self.with_panels(ui, &mut actions);
        } else {
            CentralPanel::no_frame().show(ui, |ui| actions.extend(self.without_panels(ui)));
        }
        actions.extend(self.context_menu(ui));
        self.cloud.ui(ui.ctx());
        actions.extend(self.over_all(ui));
        for action in actions {
            self.perform(ui, action);
        }
        self.grow_what_changed(ui);
        self.keep_unsaved();
        self.note_layout(ui);
        self.write_settings();
        if self.is_busy_growing() {
            // The progress bar moves between two pictures.
            ui.ctx().request_repaint_after(self.until_next_frame().max(PROGRESS));
        }
        if self.notices.needs_frame() {
            ui.ctx().request_repaint();
        }
        self.focus_frame(ui);
        self.menu_open = ui.any_popup_open();
        self.entitle(ui);
    }

    /// Sketch and texture, with all panels around them.
    fn with_panels(&mut self, ui: &mut Ui, actions: &mut Vec<Action>) {
        let bar = Frame::side_top_panel(ui.style()).inner_margin(Margin::symmetric(10, 4));
        Panel::top("menu").frame(bar).show(ui, |ui| actions.extend(self.menu(ui)));
        // On a narrow screen, it holds the button that shows the column.
        let status = (!self.panels_hidden || is_narrow(ui.ctx())).then(|| {
            let status = Panel::bottom("status").frame(bar).exact_size(28.0);
            status.show(ui, |ui| ui.available_rect_before_wrap()).inner
        });
        actions.extend(self.tools(ui));
        let column = self.column_place(ui);
        self.strip(ui, bar, actions);
        CentralPanel::no_frame().show(ui, |ui| actions.extend(self.middle(ui)));
        actions.extend(self.beside(ui, column, status));
    }

    /// Whether a mark is being drawn or changed, or the pointer is held down.
    fn is_drawing(&self, ui: &Ui) -> bool {
        self.canvas.is_busy() || ui.input(|input| input.pointer.any_down())
    }

    fn is_busy_growing(&self) -> bool {
        self.alternatives.is_growing() || self.growth.is_growing() && !self.growth.is_paused()
    }

    /// The time to the next frame that only an animation needs.
    fn until_next_frame(&self) -> Duration {
        if self.is_busy_growing() { self.growth.until_next_frame(self.frame_time) } else { Duration::ZERO }
    }

    /// Takes the newest picture of the growth.
    fn take_picture(&mut self, ui: &Ui) {
        self.growth.set_fineness(self.texture.fineness(ui.pixels_per_point()));
        let settling = self.growth.is_growing();
        let first = self.growth.first_picture;
        if self.growth.listen() {
            self.texture.take(ui, self.growth.picture.as_ref());
            if let (None, Some(took)) = (first, self.growth.first_picture) {
                self.trace.event("first picture", took);
            }
            if let (true, GrowthState::Settled(took)) = (settling, &self.growth.state) {
                self.trace.event("settled", *took);
            }
        }
        if self.texture.is_outdated() {
            self.texture.take(ui, self.growth.picture.as_ref());
        }
    }

    /// Shows the column on the right and the status line at their places, after sketch and texture.
    fn beside(&mut self, ui: &mut Ui, column: Option<Rect>, status: Option<Rect>) -> Option<Action> {
        if let Some(place) = column {
            let changes = self.column(ui, place);
            if !changes.is_empty() {
                // Sketch and texture have been shown before.
                ui.ctx().request_repaint();
            }
            changes.into_iter().for_each(|action| self.perform(ui, action));
        }
        let place = UiBuilder::new().max_rect(status?).id_salt("status");
        let shown = ui.scope_builder(place, |ui| {
            let unfolded = is_narrow(ui.ctx()).then_some(self.unfolded);
            let [closed, _] = self.session.closed_strokes(self.session.active_layer);
            panels::status(ui, &self.canvas, closed, self.ruler(), self.exporting.as_ref(), unfolded)
        });
        shown.inner
    }

    /// Reports that a thread could not be started.
    pub(super) fn report(&mut self, error: Option<StartError>) {
        if let Some(error) = error {
            self.notices.wrong(error.to_string());
        }
    }

    /// Whether a page or a question lies over the window and gets all keys.
    pub(super) fn is_asking(&self) -> bool {
        self.files.is_asking() || self.page.is_some() || self.canvas.question.is_some()
    }

    /// The actions of the keys.
    fn keys(&mut self, ui: &Ui) -> Vec<Action> {
        if self.is_asking() || self.presentation == Presentation::Texture {
            return Vec::new();
        }
        let focused = ui.memory(egui::Memory::focused);
        // An open menu handles Escape and the arrow keys itself.
        let canvas = focused.is_none_or(|id| self.canvas.id == Some(id)) && !self.menu_open;
        let keys = !ui.text_edit_focused()
            && !self.menu_open
            && (canvas || focused.is_some_and(|id| self.is_button(ui, id)));
        let mut actions = shortcuts::asked(ui.ctx(), keys, canvas);
        actions.extend(self.panels_key(ui).then_some(Action::TogglePanels));
        self.end_gesture(ui, &mut actions);
        actions
    }

    /// Cancels what is being drawn or dragged where a key asks for that: Escape, or undo, which takes back no earlier step
    /// then. Handled before the canvas notices that the drag has stopped.
    fn end_gesture(&mut self, ui: &Ui, actions: &mut Vec<Action>) {
        let undoes = |action: &Action| matches!(action, Action::Undo | Action::Redo);
        let is_changing = self.canvas.is_changing() || self.colour.is_dragging();
        let asked = |action: &Action| *action == Action::Escape || is_changing && *action == Action::Undo;
        if actions.iter().any(asked) && (self.canvas.cancel(&mut self.session) || self.cancel_colour()) {
            ui.ctx().stop_dragging();
            actions.retain(|action| *action != Action::Escape);
        }
        actions.retain(|action| !is_changing || !undoes(action));
    }

    /// Whether a focused widget is a button: it handles Space, Enter and the arrow keys, but no letters.
    fn is_button(&self, ui: &Ui, id: egui::Id) -> bool {
        ui.ctx()
            .read_response(id)
            .is_some_and(|response| response.sense.senses_click() && !response.sense.senses_drag())
    }

    /// Ends a drag in the colour tab and undoes it. Gives whether there was one.
    fn cancel_colour(&mut self) -> bool {
        let cancelled = self.colour.cancel();
        if cancelled {
            self.session.revert();
        }
        cancelled
    }

    fn menu(&mut self, ui: &mut Ui) -> Vec<Action> {
        let menus = panels::MenuState {
            session: &self.session,
            settings: &self.settings,
            sketches: &self.recent_sketches,
            growth: &self.growth,
            overlays: self.canvas.overlays,
            recovered: self.recovery.undecided(),
            over: self.over,
            tiled: self.texture.tiled,
            goals: self.goals.shown && !self.panels_hidden,
            alternatives: self.alternatives.shown,
            columns: [self.shows_tools(ui.ctx()), self.shows_column(ui.ctx())],
            hidden: self.panels_hidden,
        };
        let keys = !self.is_asking();
        panels::menu(ui, &menus, &mut self.menu_keys, keys)
    }

    fn middle(&mut self, ui: &mut Ui) -> Vec<Action> {
        let mut actions = Vec::new();
        let places = Places::new(ui.ctx(), ui.max_rect(), self.over);
        let inside = |rect: Rect| UiBuilder::new().max_rect(rect.shrink2(vec2(14.0, 4.0)));
        let marks = self.session.marks().count();
        for bar in places.grounds() {
            ui.painter().rect_filled(bar, 0.0, ui.visuals().panel_fill);
        }
        ui.scope_builder(inside(places.bars[0]), |ui| {
            actions.extend(panels::sketch_bar(ui, marks, self.over));
        });
        ui.scope_builder(inside(places.bars[1]), |ui| {
            let (document, alternatives) = (self.session.document(), self.alternatives.shown);
            actions.extend(panels::growth_bar(ui, document, &self.growth, self.texture.tiled, alternatives));
        });
        actions.extend(self.body(ui, &places));
        actions
    }

    /// What is shown where the window is embedded in another page.
    fn without_panels(&mut self, ui: &mut Ui) -> Vec<Action> {
        let room = ui.max_rect();
        if self.presentation == Presentation::Embedded {
            let places = Places::without_bars(ui.ctx(), room, self.over);
            return self.body(ui, &places);
        }
        self.notices.keep_in(room);
        let size = self.session.document().size;
        self.texture.ui(ui, room, size, &self.growth, &[]);
        if let GrowthState::Failed(why) = &self.growth.state {
            failed(ui, room, why);
        }
        Vec::new()
    }

    /// Sketch and texture.
    fn body(&mut self, ui: &mut Ui, places: &Places) -> Vec<Action> {
        let mut actions = Vec::new();
        let [sketch, texture] = places.rooms;
        self.notices.keep_in(sketch.union(texture));
        let before = [self.canvas.view, self.texture.view];
        self.canvas.units = self.settings.units;
        self.canvas.pens = self.settings.pens;
        (self.canvas.wheel, self.texture.wheel) = (self.settings.wheel, self.settings.wheel);
        if self.over {
            self.one_over_the_other(ui, sketch);
        } else {
            actions.extend(self.side_by_side(ui, places));
        }
        let corner = self.canvas.view.to_screen(sketch, [0.0; 2]);
        self.trace.canvas([corner.x, corner.y], self.canvas.view.zoom);
        if self.is_blank() && !self.shows_goals(ui.ctx()) {
            let paper = self.canvas.view.paper(sketch, self.session.document().size);
            actions.extend(panels::starters(ui, sketch, paper));
        }
        actions.extend(self.eyedropper(ui, places));
        if let Some(remark) = self.canvas.remark.take() {
            self.notices.done(remark);
        }
        self.link(before);
        if let GrowthState::Failed(why) = &self.growth.state {
            failed(ui, texture, why);
        }
        actions
    }

    fn show_canvas(&mut self, ui: &mut Ui, room: Rect) {
        let drawn = drawn(&self.results, &self.growth, self.grown == Some(self.session.revision()));
        self.canvas.ui(ui, room, &mut self.session, &drawn);
    }

    fn side_by_side(&mut self, ui: &mut Ui, places: &Places) -> Vec<Action> {
        let [left, right] = places.rooms;
        self.show_canvas(ui, left);
        let size = self.session.document().size;
        let texture = self.texture.ui(ui, right, size, &self.growth, &self.canvas.badges);
        let actions = panels::texture_menu(&texture, &self.growth);
        self.signs(ui, left, left, (self.canvas.view, Signs::Corners));
        if !self.texture.tiled {
            self.signs(ui, right, right, (self.texture.view, Signs::Beside));
        }
        let line = ui.visuals().widgets.noninteractive.bg_stroke;
        ui.painter().line_segment(places.line(), line);
        actions
    }

    fn one_over_the_other(&mut self, ui: &mut Ui, body: Rect) {
        self.show_canvas(ui, body);
        if self.session.is_empty() {
            // There is no texture yet: the whole canvas is for drawing.
            return;
        }
        let x = body.left() + self.curtain * body.width();
        let seen = Rect::from_min_max(pos2(x, body.top()), body.max);
        let painter = ui.painter_at(seen);
        painter.rect_filled(seen, 0.0, Palette::current(ui.visuals()).background);
        self.texture.view = self.canvas.view;
        self.texture.paint(ui, &painter, body, self.session.document().size);
        self.canvas.paint_over(ui, body, seen, &self.session);
        self.signs(ui, body, body.with_max_x(x), (self.canvas.view, Signs::Corners));
        texture::divider(ui, body, &mut self.curtain);
        texture::paint_divider(ui, body, self.curtain);
    }

    /// The results of the regions, as signs, in the part `seen` of the `room` of the canvas.
    fn signs(&self, ui: &Ui, room: Rect, seen: Rect, (view, signs): (View, Signs)) {
        let (painter, palette) = (ui.painter_at(seen), Palette::current(ui.visuals()));
        // A missed region gets its sign on every tab.
        let all = self.tab == Tab::Result && self.result_panel.signs;
        panels::paint_signs(&painter, room, view, (signs, all), (&self.session, &self.results), palette);
    }

    /// Where the views are linked, moves the other view as well.
    fn link(&mut self, before: [View; 2]) {
        if !self.linked || self.over || self.texture.tiled {
            return;
        }
        if self.canvas.view != before[0] {
            self.texture.view = self.canvas.view;
        } else if self.texture.view != before[1] {
            self.canvas.view = self.texture.view;
        }
    }

    /// Grows the changed sketch. The change becomes a step that can be undone once the pointer is released.
    fn grow_what_changed(&mut self, ui: &Ui) {
        let busy = self.is_drawing(ui);
        if !busy {
            self.session.commit();
        }
        // During a gesture, each growth runs at least until its first picture.
        let in_time = !busy || !self.growth.is_growing() || self.growth.first_picture.is_some();
        if in_time && self.grown != Some(self.session.revision()) {
            self.grown = Some(self.session.revision());
            self.growth.use_threads(self.settings.threads);
            self.growth.grow(&self.session.finished());
            if self.growth.picture.is_none() {
                self.texture.take(ui, None);
            }
        }
    }

    fn entitle(&mut self, ui: &Ui) {
        let changed = if self.session.is_changed() { "*" } else { "" };
        let title = format!("{changed}{} – dapple", self.session.title());
        if title != self.title {
            ui.send_viewport_cmd(ViewportCommand::Title(title.clone()));
            self.title = title;
        }
    }
}

/// Shows why the document cannot be grown, in place of the texture.
fn failed(ui: &mut Ui, room: Rect, why: &str) {
    let rect = Rect::from_center_size(room.center(), vec2((room.width() - 60.0).min(380.0), 150.0));
    ui.scope_builder(UiBuilder::new().max_rect(rect), |ui| {
        Frame::window(ui.style()).inner_margin(16).show(ui, |ui| {
            ui.strong("This cannot be grown");
            ui.add(egui::Label::new(why).wrap().selectable(true));
            if ui.button("Copy").on_hover_text("Copy the text").clicked() {
                ui.ctx().copy_text(why.to_owned());
            }
        });
    });
}

impl eframe::App for Window {
    fn ui(&mut self, ui: &mut Ui, frame: &mut eframe::Frame) {
        let began = Instant::now();
        // The time between two successive frames is the duration of a frame, drawing included.
        let took = ui.input(|input| input.stable_dt).min(2.0);
        self.frame_time = took.max(0.9 * self.frame_time);
        self.growth.set_pace(self.frame_time);
        Self::ui(self, ui);
        if self.trace.dialog(self.open_dialog()) {
            ui.ctx().request_repaint();
        }
        self.trace.frame(began.elapsed(), frame.info().cpu_usage, self.growth.is_growing());
    }

    /// The background of canvas and texture. These do not paint it themselves: that took a software renderer a quarter
    /// of the time of a frame.
    fn clear_color(&self, visuals: &Visuals) -> [f32; 4] {
        Palette::current(visuals).background.to_normalized_gamma_f32()
    }

    fn on_exit(&mut self, _: Option<&eframe::glow::Context>) {
        self.leave();
    }
}
