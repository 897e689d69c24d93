//! The window as a whole: who stands where, and what happens in a frame.

use std::path::PathBuf;
use std::time::{Duration, Instant};

use egui::{
    CentralPanel, Context, Frame, Margin, Panel, Pos2, Rect, Theme, Ui, UiBuilder, ViewportCommand, pos2,
    vec2,
};

use super::alternatives::Alternatives;
use super::canvas::{Canvas, view::View};
use super::cloud::Cloud;
use super::examples::Gallery;
use super::exporting::Exporting;
use super::files::Files;
use super::growth::{Growth, Phase, Texture};
use super::notice::{Notice, Notices};
use super::result::Results;
use super::settings::Settings;
use super::texture::{self, TextureView};
use super::theme::{self, Palette};
use super::trace::Trace;
use super::{action::Page, panels, shortcuts};
use crate::app::layering::Layering;
use crate::document::Document;
use crate::editor::recovery::Recovery;
use crate::editor::session::Session;
use crate::editor::task::{Spawn, Tasks};

/// With what the window begins.
#[derive(Default)]
pub struct Start {
    /// The document to open.
    pub file: Option<PathBuf>,
    /// What is remembered.
    pub settings: Settings,
    /// Where unsaved work is kept; `None` = nowhere.
    pub recovery: Option<PathBuf>,
    /// Whether files are chosen with the system's own dialogs.
    pub native_dialogs: bool,
    /// How threads are started; tests let it fail.
    pub spawn: Spawn,
}

/// The window.
pub struct Window {
    pub(super) session: Session,
    pub(super) canvas: Canvas,
    pub(super) texture: TextureView,
    pub(super) growth: Growth,
    pub(super) tasks: Tasks,
    pub(super) settings: Settings,
    pub(super) notices: Notices,
    pub(super) files: Files,
    pub(super) recovery: Recovery,
    /// The lost document for which *Discard* was pressed once.
    pub(super) discard_asked: Option<String>,
    pub(super) gallery: Gallery,
    pub(super) exporting: Option<Exporting>,
    pub(super) page: Option<Page>,
    pub(super) tab: panels::Tab,
    pub(super) layering: Layering,
    pub(super) results: Results,
    pub(super) cloud: Cloud,
    pub(super) alternatives: Alternatives,
    pub(super) colour: panels::ColourPanel,
    /// One over the other, instead of side by side.
    pub(super) over: bool,
    /// Where the curtain hangs, 0..1.
    pub(super) curtain: f32,
    /// Do the views move together?
    pub(super) linked: bool,
    /// The revision that is growing.
    grown: Option<u64>,
    /// Was a menu open in the last frame?
    menu_open: bool,
    title: String,
    pub(super) trace: Trace,
}

impl Window {
    /// A window, with what it begins with.
    #[must_use]
    pub fn new(ctx: &Context, start: Start) -> Self {
        theme::dress(ctx);
        ctx.set_theme(start.settings.theme);
        // Ctrl and + or − zoom the canvas, not the buttons.
        ctx.options_mut(|options| {
            options.zoom_with_keyboard = false;
            options.fallback_theme = Theme::Light;
        });
        let wake = ctx.clone();
        let tasks = Tasks::new(move || wake.request_repaint()).with_spawn(start.spawn);
        let first = !start.settings.hint_seen && start.file.is_none();
        let (recovery, errors) = Recovery::new(start.recovery, tasks.clone());
        let page = if recovery.undecided() > 0 { Some(Page::Recovery) } else { first.then_some(Page::Hint) };
        let results = Results::default();
        let mut window = Self {
            session: Session::open(start.settings.new.document(), None),
            canvas: Canvas::default(),
            texture: TextureView::default(),
            growth: Growth::new(tasks.clone()),
            tasks,
            settings: start.settings,
            notices: Notices::default(),
            files: Files::new(start.native_dialogs),
            gallery: Gallery::default(),
            exporting: None,
            page,
            recovery,
            discard_asked: None,
            tab: panels::Tab::default(),
            layering: Layering::default(),
            alternatives: Alternatives::new(results.training.clone()),
            results,
            cloud: Cloud::default(),
            colour: panels::ColourPanel::default(),
            over: false,
            curtain: 0.5,
            linked: true,
            grown: None,
            menu_open: false,
            title: String::new(),
            trace: Trace::asked(),
        };
        window.restore_layout();
        for trouble in window.settings.trouble.take().into_iter().chain(errors) {
            window.notices.wrong(trouble);
        }
        if let Some(file) = start.file {
            window.open(&file);
        }
        window
    }

    /// The document as it is saved and grown.
    #[must_use]
    pub fn document(&self) -> Document {
        self.session.finished()
    }

    /// The open document with its selection and history.
    #[must_use]
    pub fn session(&self) -> &Session {
        &self.session
    }

    /// How far the growth is.
    #[must_use]
    pub fn phase(&self) -> &Phase {
        &self.growth.phase
    }

    /// The growth.
    #[must_use]
    pub fn growth(&self) -> &Growth {
        &self.growth
    }

    /// Where a px of the canvas, which is shown in `room`, is seen.
    #[must_use]
    pub fn screen(&self, room: Rect, point: [f64; 2]) -> Pos2 {
        self.canvas.view.to_screen(room, point)
    }

    /// Shows no more how long something took: for pictures that shall be alike.
    pub fn hide_times(&mut self) {
        if let Phase::Settled(took) = &mut self.growth.phase {
            *took = Duration::ZERO;
        }
    }

    /// What has settled.
    #[must_use]
    pub fn settled(&self) -> Option<&Texture> {
        self.growth.texture.as_ref()
    }

    /// What came of it, region by region: known while the column shows it.
    #[must_use]
    pub fn results(&self) -> &Results {
        &self.results
    }

    /// Other textures that fit the same sketch.
    #[must_use]
    pub fn alternatives(&self) -> &Alternatives {
        &self.alternatives
    }

    /// The training cloud.
    #[must_use]
    pub fn cloud(&self) -> &Cloud {
        &self.cloud
    }

    /// Where the sketch and the texture are looked at: the px in the middle, and points a px.
    #[must_use]
    pub fn views(&self) -> [([f64; 2], f32); 2] {
        [self.canvas.view, self.texture.view].map(|view| (view.center, view.zoom))
    }

    /// Does what has grown of frozen layers lie under the canvas?
    #[must_use]
    pub fn has_underlay(&self) -> bool {
        self.canvas.underlay.is_there()
    }

    /// Does a picture lie under the canvas?
    #[must_use]
    pub fn has_reference(&self) -> bool {
        self.canvas.reference.is_there()
    }

    /// What has to be said.
    #[must_use]
    pub fn notices(&self) -> &[Notice] {
        self.notices.all()
    }

    /// Shows a whole frame.
    pub fn ui(&mut self, ui: &mut Ui) {
        let settling = self.growth.is_growing();
        let first = self.growth.first_picture;
        if self.growth.listen() {
            self.texture.take(ui, self.growth.picture.as_ref());
            if let (None, Some(took)) = (first, self.growth.first_picture) {
                self.trace.event("first picture", took);
            }
            if let (true, Phase::Settled(took)) = (settling, &self.growth.phase) {
                self.trace.event("settled", *took);
            }
        }
        self.canvas.underlay.follow(ui, &self.session, &self.growth);
        self.listen(ui);
        if self.tab == panels::Tab::Result {
            self.results.follow(ui.ctx(), self.growth.texture.as_ref());
        }
        let mut actions = self.keys(ui);
        actions.extend(self.dropped(ui));
        let bar = Frame::side_top_panel(ui.style()).inner_margin(Margin::symmetric(10, 4));
        Panel::top("menu").frame(bar).show(ui, |ui| actions.extend(panels::menu(ui, self)));
        Panel::bottom("status").frame(bar).exact_size(28.0).show(ui, |ui| panels::status(ui, self));
        let strip = Frame::side_top_panel(ui.style()).inner_margin(Margin::symmetric(6, 8));
        let strip = Panel::left("tools").frame(strip).resizable(false).exact_size(50.0);
        strip.show(ui, |ui| actions.extend(panels::strip(ui, self)));
        let column = Frame::side_top_panel(ui.style()).inner_margin(Margin::symmetric(14, 10));
        let column = Panel::right("inspector").frame(column).resizable(false).exact_size(264.0);
        column.show(ui, |ui| actions.extend(panels::inspector(ui, self)));
        let busy = self.canvas.is_busy() || ui.input(|input| input.pointer.any_down());
        self.alternatives.follow(ui.ctx(), &self.session, &self.growth, busy);
        if self.alternatives.shown {
            let strip = Panel::bottom("alternatives").frame(bar).resizable(false).exact_size(panels::HEIGHT);
            strip.show(ui, |ui| actions.extend(panels::alternatives(ui, self)));
        }
        CentralPanel::no_frame().show(ui, |ui| actions.extend(self.middle(ui)));
        self.cloud.ui(ui.ctx());
        actions.extend(self.over_all(ui));
        for action in actions {
            self.perform(ui, action);
        }
        self.grow_what_changed(ui);
        self.keep_unsaved();
        self.note_layout(ui);
        if self.alternatives.is_growing() || self.growth.is_growing() && !self.growth.is_paused() {
            // Between two pictures the bar moves on.
            ui.ctx().request_repaint_after(Duration::from_millis(100));
        }
        self.menu_open = ui.any_popup_open();
        self.entitle(ui);
    }

    /// What the keys ask for.
    fn keys(&mut self, ui: &Ui) -> Vec<super::Action> {
        // A page over the window has all keys.
        if self.files.is_asking() || self.page.is_some() {
            return Vec::new();
        }
        let focused = ui.memory(egui::Memory::focused);
        // An open menu takes Escape and the arrows itself.
        let canvas = focused.is_none_or(|id| self.canvas.id == Some(id)) && !self.menu_open;
        let keys = !ui.text_edit_focused() && (canvas || focused.is_some_and(|id| self.is_button(ui, id)));
        let mut actions = shortcuts::asked(ui.ctx(), keys, canvas);
        let cancelled = actions.contains(&super::Action::Escape)
            && (self.canvas.cancel(&mut self.session) || self.colour.cancel(&mut self.session));
        if cancelled {
            ui.ctx().stop_dragging();
            // Before the canvas sees that the toolkit lets go of the pointer.
            actions.retain(|action| *action != super::Action::Escape);
        }
        actions
    }

    /// A focused button takes Space, Enter and the arrows; letters are free.
    fn is_button(&self, ui: &Ui, id: egui::Id) -> bool {
        ui.ctx()
            .read_response(id)
            .is_some_and(|response| response.sense.senses_click() && !response.sense.senses_drag())
    }

    fn middle(&mut self, ui: &mut Ui) -> Vec<super::Action> {
        let mut actions = Vec::new();
        let all = ui.max_rect();
        let (head, body) = all.split_top_bottom_at_y(all.top() + 38.0);
        ui.painter().rect_filled(head, 0.0, ui.visuals().panel_fill);
        let (left, right) = head.split_left_right_at_fraction(0.5);
        let inside = |rect: Rect| UiBuilder::new().max_rect(rect.shrink2(vec2(14.0, 4.0)));
        ui.scope_builder(inside(left), |ui| actions.extend(panels::sketch_bar(ui, self)));
        ui.scope_builder(inside(right), |ui| actions.extend(panels::growth_bar(ui, self)));
        let before = [self.canvas.view, self.texture.view];
        self.canvas.units = self.settings.units;
        if self.over {
            self.one_over_the_other(ui, body);
        } else {
            self.side_by_side(ui, body);
        }
        self.link(before);
        if let Phase::Failed(why) = &self.growth.phase {
            let room = if self.over { body } else { body.split_left_right_at_fraction(0.5).1 };
            failed(ui, room, why);
        }
        actions
    }

    fn side_by_side(&mut self, ui: &mut Ui, body: Rect) {
        let (left, right) = body.split_left_right_at_fraction(0.5);
        self.canvas.ui(ui, left, &mut self.session);
        let corner = self.canvas.view.to_screen(left, [0.0; 2]);
        self.trace.canvas([corner.x, corner.y], self.canvas.view.zoom);
        self.texture.ui(ui, right, self.session.document().size, &self.growth);
        self.signs(ui, left, self.canvas.view);
        if !self.texture.tiled {
            self.signs(ui, right, self.texture.view);
        }
        let line = ui.visuals().widgets.noninteractive.bg_stroke;
        ui.painter().vline(body.center().x, body.y_range(), line);
    }

    fn one_over_the_other(&mut self, ui: &mut Ui, body: Rect) {
        self.canvas.ui(ui, body, &mut self.session);
        let x = body.left() + self.curtain * body.width();
        let seen = Rect::from_min_max(pos2(x, body.top()), body.max);
        let painter = ui.painter_at(seen);
        painter.rect_filled(seen, 0.0, Palette::of(ui.visuals()).desk);
        self.texture.view = self.canvas.view;
        self.texture.paint(ui, &painter, body, self.session.document().size);
        self.signs(ui, body, self.canvas.view);
        texture::curtain(ui, body, &mut self.curtain);
        texture::paint_curtain(ui, body, self.curtain);
    }

    /// What came of each region, in its corner.
    fn signs(&self, ui: &Ui, room: Rect, view: View) {
        if self.tab == panels::Tab::Result {
            let palette = Palette::of(ui.visuals());
            self.results.paint(&ui.painter_at(room), room, view, &self.session, palette);
        }
    }

    /// Views that move together: the one that was moved takes the other along.
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

    /// Grows what was drawn; makes it a step that can be undone once the hand rests.
    fn grow_what_changed(&mut self, ui: &Ui) {
        let busy = self.canvas.is_busy() || ui.input(|input| input.pointer.any_down());
        if !busy {
            self.session.commit();
        }
        // While the hand still moves, every growth gets as far as its first picture.
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

    /// Another document was opened.
    pub(super) fn begin(&mut self, session: Session) {
        self.session = session;
        self.files.restored = None;
        self.recovery.document_opened();
        self.canvas.view.fitted = true;
        self.texture.view.fitted = true;
        self.texture.tiled = false;
        self.canvas.analysis.forget();
        self.layering.forget();
        self.growth.forget();
        self.results.forget();
        self.cloud.forget();
        self.alternatives.forget();
        self.grown = None;
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

/// Why it cannot be grown, where the texture would be.
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
        Self::ui(self, ui);
        self.trace.frame(began.elapsed(), frame.info().cpu_usage, self.growth.is_growing());
    }

    fn on_exit(&mut self, _: Option<&eframe::glow::Context>) {
        self.leave();
    }
}
