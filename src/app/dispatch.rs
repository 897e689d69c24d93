//! What each action does.

use egui::{Ui, ViewportCommand};

use crate::app::action::{Action, Page};
use crate::app::alternatives;
use crate::app::canvas::tool::Tool;
use crate::app::pages;
use crate::app::result;
use crate::app::window::Window;
use crate::document::{Document, Layer};
use crate::editor::selection::{Place, Selection};
use crate::editor::session::Session;
use crate::editor::shape;
use crate::marks::{Ellipse, Line, Mark};

/// How far a copy lies from what was copied, px of the screen.
const ASIDE: f64 = 14.0;

impl Window {
    /// Does it.
    pub fn perform(&mut self, ui: &Ui, action: Action) {
        match action {
            Action::New
            | Action::Open
            | Action::OpenFile(_)
            | Action::Import
            | Action::Example(_)
            | Action::Restore(_)
            | Action::Quit => self.unless_unsaved(ui, action),
            Action::Discard(id) => self.discard(&id),
            Action::Save => self.save(ui, None),
            Action::SaveAs => self.save_as(ui),
            Action::Export => self.ask_export(),
            Action::Reference => self.choose_reference(ui),
            Action::OpenPalette => self.choose_palette(ui),
            Action::SavePalette => self.save_palette_as(ui),
            Action::Undo => self.session.undo(),
            Action::Redo => self.session.redo(),
            Action::Cut => {
                self.copy(ui);
                self.delete();
            }
            Action::Copy => self.copy(ui),
            Action::Paste(text) => self.paste(&text),
            Action::Page(page) => self.turn_to(page),
            Action::Layer(action) => self.layer(action),
            Action::Tab(tab) => self.tab = tab,
            Action::Reach(layer, place) => self.draw_what_can_be_reached(layer, place),
            Action::Alternatives(shown) => self.alternatives.shown = shown,
            Action::ToggleAlternatives => self.alternatives.shown = !self.alternatives.shown,
            Action::TakeAlternative(id) => self.take_alternative(id),
            Action::KeepAlternative(id, kept) => self.alternatives.keep(id, kept),
            Action::StopAlternatives(stopped) => self.alternatives.stop(stopped),
            Action::Cloud(asked) => self.show_cloud(ui, asked),
            Action::Pause => self.growth.pause(!self.growth.is_paused()),
            Action::Stop => self.growth.stop(),
            Action::Grow => self.growth.again(&self.session.finished()),
            Action::AnotherSeed => self.another_seed(),
            other => self.edit_or_look(ui, other),
        }
    }

    fn edit_or_look(&mut self, ui: &Ui, action: Action) {
        match action {
            Action::Duplicate => self.duplicate(),
            Action::Delete => self.delete(),
            Action::SelectAll => {
                self.session.selection =
                    Selection::new(self.session.editable_marks().map(|(place, _)| place));
                self.canvas.tool = Tool::Select;
            }
            Action::Escape => self.escape(),
            Action::Next(step) => self.next(step),
            Action::Nudge(by) => self.session.nudge(by),
            Action::Turn(by) => self.each(|mark, middle| shape::turned(mark, by, middle)),
            Action::Scale(by) => self.each(|mark, middle| shape::scaled(mark, by, middle)),
            Action::Insert(ellipse) => self.insert(ellipse),
            Action::Tool(tool) => self.canvas.tool = tool,
            Action::Over(over) => self.over = over,
            Action::Tiled(tiled) => {
                self.texture.tiled = tiled;
                self.texture.view.fitted = true;
            }
            Action::Regions(shown) => self.canvas.overlays.regions = shown,
            Action::Analysis(shown) => self.canvas.overlays.analysis = shown,
            other => self.look(ui, &other),
        }
    }

    fn look(&mut self, ui: &Ui, action: &Action) {
        for view in [&mut self.canvas.view, &mut self.texture.view] {
            match action {
                Action::Fit => view.fitted = true,
                Action::ActualSize => view.actual_size(ui.pixels_per_point()),
                Action::Zoom(by) => {
                    let room = egui::Rect::ZERO;
                    view.zoom_at(room, room.center(), *by);
                }
                _ => {}
            }
        }
    }

    fn turn_to(&mut self, page: Page) {
        let open = self.page == Some(page);
        if self.page == Some(Page::Hint) && !self.settings.hint_seen {
            self.settings.hint_seen = true;
            self.settings.write();
        }
        if page == Page::Recovery {
            self.show_lost(!open);
        }
        if open && page == Page::Preferences {
            self.settings.write();
        }
        self.page = (!open).then_some(page);
    }

    fn escape(&mut self) {
        if !self.canvas.cancel(&mut self.session) {
            self.session.selection.clear();
        }
    }

    fn delete(&mut self) {
        let places: Vec<Place> = self.session.selection.places().collect();
        self.session.remove(&places);
    }

    fn duplicate(&mut self) {
        let by = ASIDE / f64::from(self.canvas.view.zoom);
        let marks: Vec<(Place, Mark)> = self.session.selected().collect();
        let by = self.session.limit_move(&marks, [by, by]);
        let copies: Vec<Mark> = marks.iter().map(|(_, mark)| shape::moved(mark, by)).collect();
        if !copies.is_empty() {
            self.session.add(&copies);
        }
    }

    fn next(&mut self, step: isize) {
        let places: Vec<Place> = self.session.editable_marks().map(|(place, _)| place).collect();
        if places.is_empty() {
            return;
        }
        let now = self.session.selection.places().next();
        let index = now.and_then(|now| places.iter().position(|place| *place == now));
        let n = places.len() as isize;
        let next =
            index.map_or(if step > 0 { 0 } else { n - 1 }, |index| (index as isize + step).rem_euclid(n));
        self.session.selection = Selection::new([places[next as usize]]);
        self.session.active_layer = places[next as usize].layer;
        self.canvas.tool = Tool::Select;
    }

    /// Changes each selected mark around its own middle.
    fn each(&mut self, change: impl Fn(&Mark, [f64; 2]) -> Mark) {
        let marks: Vec<_> = self.session.selected().collect();
        let changed: Vec<_> =
            marks.iter().map(|(place, mark)| (*place, change(mark, shape::center(mark)))).collect();
        self.session.replace(&changed);
    }

    fn insert(&mut self, ellipse: bool) {
        let nib = self.canvas.nib;
        let size = self.session.document().size;
        let center = [0, 1].map(|axis| self.canvas.view.center[axis].clamp(0.0, f64::from(size[axis])));
        let mark = if ellipse {
            Mark::Ellipse(Ellipse { center, radii: nib.radii, angle: 0.0 })
        } else {
            let half = 0.1 * f64::from(size[0]);
            let [from, to] = [-half, half].map(|by| [center[0] + by, center[1]]);
            Mark::Line(Line { from, to, width: nib.width })
        };
        self.session.add(&[mark]);
        self.canvas.tool = Tool::Select;
    }

    /// Changes a region's marks as far as needed to be grown as they are drawn.
    fn draw_what_can_be_reached(&mut self, layer: usize, place: [usize; 2]) {
        let outcome = self.results.of(self.growth.texture.as_ref());
        let regions = outcome.and_then(|outcome| outcome.layers.get(layer)).map(|layer| &layer.regions);
        let region = regions.and_then(|all| all.iter().find(|region| region.report.place == place));
        let reach = region.and_then(|region| region.reach.clone());
        let Some((reach, layer)) = reach.zip(result::on_desk(&self.session, layer)) else { return };
        self.session.commit();
        let at = |(stroke, mark): (usize, Mark)| (Place { layer, stroke }, mark);
        self.session.replace(&reach.marks.into_iter().map(at).collect::<Vec<_>>());
        if let Some(duty) = reach.duty {
            self.session.edit(|document| document.layers[layer].options.duty = duty);
        }
        self.session.commit();
    }

    fn show_cloud(&mut self, ui: &Ui, asked: Option<(usize, [usize; 2])>) {
        self.cloud.asked = None;
        let Some((layer, place)) = asked else { return };
        let Some(of) = self.results.outcome().and_then(|outcome| outcome.layers.get(layer)) else { return };
        if let Some(region) = of.regions.iter().find(|region| region.report.place == place) {
            self.cloud.ask(ui.ctx(), (layer, place), of.system, region, &self.results.training);
        }
    }

    /// Opens an alternative; it has grown already.
    fn take_alternative(&mut self, id: u64) {
        let Some(one) = self.alternatives.get(id) else { return };
        if let Some(grown) = &one.grown {
            self.growth.know(grown);
        }
        let size = self.session.document().size;
        alternatives::put(&mut self.session, &one.document);
        if self.session.document().size != size {
            self.canvas.view.fitted = true;
            self.texture.view.fitted = true;
        }
    }

    fn another_seed(&mut self) {
        // Neighbouring seeds share nothing (see `Document::layer_seed`).
        self.session.edit(|document| document.seed = document.seed.wrapping_add(1));
    }

    /// Copies what is selected as a document of its own.
    fn copy(&mut self, ui: &Ui) {
        let source = self.session.document();
        let mut document = Document { layers: Vec::new(), ..source.clone() };
        for (index, layer) in source.layers.iter().enumerate() {
            let held =
                |stroke: &usize| self.session.selection.contains(Place { layer: index, stroke: *stroke });
            let strokes: Vec<_> =
                (0..layer.strokes.len()).filter(held).map(|stroke| layer.strokes[stroke].clone()).collect();
            if !strokes.is_empty() {
                document.layers.push(Layer { strokes, ..layer.clone() });
            }
        }
        if !document.layers.is_empty() {
            ui.ctx().copy_text(document.to_json());
        }
    }

    fn paste(&mut self, text: &str) {
        let document = match Document::parse(text, "the clipboard") {
            Ok(document) => document,
            Err(_) => {
                self.notices
                    .wrong("The clipboard holds no marks; copy some from dapple, or the text of a document.");
                return;
            }
        };
        let pasted = Session::open(document, None);
        let by = ASIDE / f64::from(self.canvas.view.zoom);
        let marks: Vec<Mark> = pasted.marks().map(|(_, mark)| shape::moved(&mark, [by, by])).collect();
        self.session.add(&marks);
        self.canvas.tool = Tool::Select;
    }

    /// The new document that was described.
    pub(super) fn create(&mut self, new: &pages::New) {
        self.begin(Session::open(new.document(), None));
    }

    /// Closes for good.
    pub(super) fn close(&mut self, ui: &Ui) {
        self.files.closing = true;
        // What is there is saved, or nobody wants it.
        self.recovery.stop();
        ui.send_viewport_cmd(ViewportCommand::Close);
    }
}
