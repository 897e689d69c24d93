//! Carries out actions.

use egui::{Rect, Ui, ViewportCommand};

use super::Window;
use crate::app::action::{Action, Page};
use crate::app::alternatives;
use crate::app::canvas::tool::Tool;
use crate::app::canvas::view::View;
use crate::app::pages;
use crate::app::purpose::Purpose;
use crate::app::result;
use crate::document::{DutyChoice, limits};
use crate::editor::selection::Place;
use crate::editor::session::Session;
use crate::editor::shape;
use crate::marks::Mark;

impl Window {
    /// Carries out an action.
    #[expect(
        clippy::too_many_lines,
        reason = "one arm for each action: one that nobody handles does not compile"
    )]
    pub fn perform(&mut self, ui: &Ui, action: Action) {
        match action {
            Action::New
            | Action::OpenFile(_)
            | Action::OpenLink(_)
            | Action::Import
            | Action::TakePhoto
            | Action::Example(_)
            | Action::Restore(_)
            | Action::Quit => self.unless_unsaved(ui, action),
            // Whether something unsaved would be lost is asked once the file is known: a picture may be drawn over.
            Action::Open => self.choose(Purpose::Open, ""),
            Action::Discard(id) => self.discard(&id),
            Action::ReadRecent => {
                let reading = self.recent_sketches.read(&self.settings.recent, &self.tasks);
                self.report(reading.err());
            }
            Action::ForgetRecent => self.settings.forget(),
            Action::Save => self.save(None),
            Action::SaveAs => self.save_as(),
            Action::ImportPhoto => self.choose(Purpose::Photograph, ""),
            Action::Export => self.ask_export(),
            Action::CancelExport => self.cancel_export(),
            Action::OpenPalette => self.choose_palette(),
            Action::ChoosePicture(wanted) => self.choose(Purpose::Picture(wanted), ""),
            Action::SavePalette => self.save_palette_as(),
            Action::Page(page) => self.turn_to(page),
            Action::Goals(shown) => {
                self.goals.shown = shown;
                self.panels_hidden &= !shown;
            }
            Action::Alternatives(shown) => self.show_alternatives(shown),
            Action::ToggleAlternatives => self.show_alternatives(!self.shows_alternatives()),
            Action::TakeAlternative(id) => self.take_alternative(id),
            Action::KeepAlternative(id, kept) => self.keep_alternative(id, kept),
            Action::StopAlternatives(stopped) => self.alternatives.stop(stopped),
            Action::Cloud(asked) => self.show_cloud(asked),
            Action::Pause => self.growth.pause(!self.growth.is_paused()),
            Action::Stop => self.growth.stop(),
            Action::Grow => self.growth.again(&self.session.finished()),
            Action::Undo => self.session.undo(),
            Action::Redo => self.session.redo(),
            Action::Cut => {
                self.copy(ui);
                self.delete();
            }
            Action::Copy => self.copy(ui),
            Action::Paste(text) => self.paste(ui, &text),
            Action::PastePicture(picture) => self.paste_picture(picture),
            Action::CopyPicture => self.copy_picture(),
            Action::CopyLink => self.copy_link(ui.ctx()),
            Action::Duplicate => self.duplicate(),
            Action::AskPaste => ui.send_viewport_cmd(ViewportCommand::RequestPaste),
            Action::Delete => self.delete(),
            Action::SelectAll => self.select_all(),
            Action::SelectMarks(places) => self.select_marks(places),
            Action::Escape => self.escape(),
            Action::Next(step) => self.select_next(step),
            Action::Nudge(by) => self.session.nudge(by),
            Action::Turn(by) => self.session.change_each(|mark, center| shape::turned(mark, by, center)),
            Action::Scale(by) => self.session.change_each(|mark, center| shape::scaled(mark, by, center)),
            Action::Widen(by) => self.widen(by),
            Action::Align(axis) => self.session.align(axis),
            Action::Distribute(axis) => self.session.distribute(axis),
            Action::Begin(beginning) => self.begin_with(ui, beginning),
            Action::ContextMenu => self.open_context_menu(),
            Action::Insert(ellipse) => self.insert(ellipse),
            Action::AnotherSeed => self.another_seed(),
            Action::Edit(edit) => self.edit(edit),
            Action::Layer(action) => self.layer(action),
            Action::Reach(layer, place) => self.draw_what_can_be_reached(layer, place),
            Action::Tool(tool) => {
                self.canvas.tool = tool;
                self.tool_before = None;
            }
            Action::Column(shown) => self.show_column(ui.ctx(), shown),
            Action::ToggleColumn => self.show_column(ui.ctx(), !self.shows_column(ui.ctx())),
            Action::Tools(shown) => self.show_tools(shown),
            Action::TogglePanels => self.panels_hidden = !self.panels_hidden,
            Action::FullScreen => {
                let is_full = ui.input(|input| input.viewport().fullscreen == Some(true));
                ui.send_viewport_cmd(ViewportCommand::Fullscreen(!is_full));
            }
            Action::Nib(nib) => self.canvas.nib = nib,
            Action::Tab(tab) => self.tab = tab,
            Action::Over(over) => self.over = over,
            Action::Linked(linked) => self.linked = linked,
            Action::Tiled(tiled) => {
                self.texture.tiled = tiled;
                self.texture.view.fitted = true;
            }
            Action::Regions(shown) => self.canvas.overlays.regions = shown,
            Action::Analysis(shown) => self.canvas.overlays.analysis = shown,
            Action::Wanted(shown) => self.canvas.overlays.wanted = shown,
            Action::ToggleWanted => self.canvas.overlays.wanted = !self.canvas.overlays.wanted,
            Action::Snap(snap) => self.canvas.snap = snap,
            Action::ChooseReference => self.choose_reference(),
            Action::ShowReference(shown) => self.canvas.reference.shown = shown,
            Action::ReferenceOpacity(opacity) => self.canvas.reference.opacity = opacity,
            Action::LockReference(locked) => {
                self.canvas.reference.locked = locked;
                if !locked {
                    self.canvas.tool = Tool::Select;
                }
            }
            Action::PlaceReference(placement) => {
                self.canvas.reference.place(&mut self.session, Some(placement));
            }
            Action::FitReference => self.canvas.reference.place(&mut self.session, None),
            Action::RemoveReference => self.session.set_backdrop(None),
            Action::Theme(theme) => {
                self.settings.theme = theme;
                ui.ctx().set_theme(theme);
                self.settings.write_soon();
            }
            Action::Fit => self.each_view(|view| view.fitted = true),
            Action::ActualSize => self.each_view(|view| view.actual_size(ui.pixels_per_point())),
            Action::Zoom(by) => self.each_view(|view| view.zoom_at(Rect::ZERO, Rect::ZERO.center(), by)),
        }
    }

    /// Changes the view of the sketch and that of the texture.
    fn each_view(&mut self, change: impl Fn(&mut View)) {
        change(&mut self.canvas.view);
        change(&mut self.texture.view);
    }

    fn turn_to(&mut self, page: Page) {
        let open = self.page == Some(page);
        if page == Page::Recovery {
            self.show_lost(!open);
        }
        if open && page == Page::Preferences {
            self.settings.write_soon();
        }
        self.page = (!open).then_some(page);
    }

    /// Cancels what is being drawn; else clears the selection; else closes a panel.
    fn escape(&mut self) {
        if self.canvas.cancel(&mut self.session) || std::mem::take(&mut self.colour.picking) {
        } else if !self.session.selection.is_empty() {
            self.session.selection.clear();
            self.use_tool_before();
        } else if self.cloud.asked.is_some() {
            self.cloud.asked = None;
        } else {
            self.alternatives.shown = false;
        }
    }

    /// Replaces the marks of a region by the most similar ones that can be grown.
    fn draw_what_can_be_reached(&mut self, layer: usize, place: [usize; 2]) {
        let outcome = self.results.for_texture(self.growth.texture.as_ref());
        let regions = outcome.and_then(|outcome| outcome.layers.get(layer)).map(|layer| &layer.regions);
        let region = regions.and_then(|all| all.iter().find(|region| region.report.place == place));
        let reach = region.and_then(|region| region.reach.clone());
        let Some((reach, layer)) = reach.zip(result::session_layer(&self.session, layer)) else { return };
        self.session.commit();
        let at = |(stroke, mark): (usize, Mark)| (Place { layer, stroke }, mark);
        self.session.replace(&reach.marks.into_iter().map(at).collect::<Vec<_>>());
        if let Some(duty) = reach.duty {
            self.session.edit(|document| document.layers[layer].options.duty = DutyChoice::Given(duty));
        }
        self.session.commit();
    }

    fn show_cloud(&mut self, asked: Option<(usize, [usize; 2])>) {
        self.cloud.asked = None;
        let Some((layer, place)) = asked else { return };
        let Some(of) = self.results.outcome().and_then(|outcome| outcome.layers.get(layer)) else { return };
        if let Some(growth) = &of.growth {
            self.cloud.ask_growth((layer, place), growth.range);
            return;
        }
        let region = of.regions.iter().find(|region| region.report.place == place);
        if let (Some(region), Some(system)) = (region, of.trained) {
            let training = &self.results.training;
            if let Err(error) = self.cloud.ask(&self.tasks, (layer, place), system, region, training) {
                self.notices.wrong(error.to_string());
            }
        }
    }

    /// Stars an alternative in the document, or removes its star.
    fn keep_alternative(&mut self, id: u64, kept: bool) {
        let Some(one) = self.alternatives.get(id) else { return };
        if !alternatives::star(&mut self.session, one, kept) {
            let most = limits::MAX_STARRED;
            self.notices.wrong(format!(
                "A document keeps at most {most} alternatives: remove the star of another first."
            ));
        }
    }

    /// Opens an alternative, which has grown already.
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

    fn shows_alternatives(&self) -> bool {
        self.alternatives.shown && !self.panels_hidden
    }

    fn show_alternatives(&mut self, shown: bool) {
        self.alternatives.shown = shown;
        self.panels_hidden &= !shown;
    }

    /// Opens a new document.
    pub(super) fn create(&mut self, new: &pages::New) {
        self.begin(Session::open(new.document(), None));
    }

    /// Closes the window.
    pub(super) fn close(&mut self, ui: &Ui) {
        self.files.closing = true;
        // No question here: the document is saved, or the user chose not to save it.
        self.recovery.stop();
        ui.send_viewport_cmd(ViewportCommand::Close);
    }
}
