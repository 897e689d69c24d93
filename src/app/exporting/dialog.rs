//! The export dialog: choices on the left, a preview on the right.

use std::sync::Arc;

use egui::{Align, Button, ComboBox, Layout, ProgressBar, Rect, RichText, ScrollArea, Ui, UiBuilder, vec2};

use super::lit::LIT;
use super::pages::{DialogAction, ExportContext};
use super::preview::{FinishedPreview, Preview};
use super::view::View;
use super::{Choices, ExportKind, pages};
use crate::app::pages::{Answer, choice};
use crate::app::small_screen;
use crate::synth::estimate::in_words;

/// Width of the column of choices, points.
const COLUMN: f32 = 336.0;

/// The dialog.
pub struct Dialog {
    /// The choices.
    pub choices: Choices,
    /// The preview.
    pub preview: Preview,
    view: View,
}

impl Dialog {
    /// Begins with these choices.
    #[must_use]
    pub fn new(choices: Choices) -> Self {
        Self { choices, preview: Preview::default(), view: View::new() }
    }

    /// Shows it.
    pub fn ui(&mut self, ui: &mut Ui, context: &ExportContext) -> Option<DialogAction> {
        self.preview.follow(context.tasks, context.request, context.grown, context.threads);
        let size = small_screen::dialog_size(ui.ctx(), [920.0, 620.0]);
        ui.set_width(size.x);
        // Enter that ends the typing of a number must not close the dialog.
        let enter = ui.input(|input| input.key_pressed(egui::Key::Enter))
            && ui.memory(|memory| memory.focused().is_none());
        self.head(ui);
        ui.add_space(6.0);
        let height = (size.y - 118.0).max(200.0);
        let (all, _) = ui.allocate_exact_size(vec2(size.x, height), egui::Sense::hover());
        let [left, right] = small_screen::parts(ui.ctx(), all, COLUMN);
        let mut action = None;
        // A fixed rectangle: the size of the dialog does not depend on its content.
        let mut column = ui.new_child(UiBuilder::new().max_rect(left));
        let area = ScrollArea::vertical().auto_shrink([false; 2]).max_height(left.height());
        area.show(&mut column, |ui| {
            ui.set_max_width(left.width() - 14.0);
            action = pages::page(ui, &mut self.choices, context);
        });
        self.right(&mut ui.new_child(UiBuilder::new().max_rect(right)), context);
        ui.add_space(4.0);
        ui.separator();
        ui.horizontal(|ui| {
            ui.vertical(|ui| {
                ui.set_width((size.x - 260.0).max(200.0));
                ui.label(RichText::new(self.summary(context)).small().weak());
            });
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| match choice(ui, "Export…", None) {
                Some(Answer::Yes) => action = Some(DialogAction::Export),
                Some(_) => action = Some(DialogAction::Cancel),
                None => {}
            });
        });
        if enter && action.is_none() {
            action = Some(DialogAction::Export);
        }
        action.map(|action| self.checked(action))
    }

    /// Whether the lit view is being rendered.
    #[must_use]
    pub fn is_rendering(&self) -> bool {
        self.view.lit.is_rendering()
    }

    /// The kinds of exports.
    fn head(&mut self, ui: &mut Ui) {
        ui.horizontal(|ui| {
            ui.heading("Export");
            ui.add_space(14.0);
            for (what, text, explained) in KINDS {
                let chosen = self.choices.what == what;
                let tab =
                    ui.selectable_label(chosen, RichText::new(text).size(14.5)).on_hover_text(explained);
                if tab.clicked() {
                    self.choices.what = what;
                }
            }
        });
    }

    /// Where the other document of a film is missing, asks for it first.
    fn checked(&self, action: DialogAction) -> DialogAction {
        let film = &self.choices.film;
        let lacks = self.choices.what == ExportKind::Film && film.change && film.to.is_none();
        if action == DialogAction::Export && lacks { DialogAction::ChooseOther } else { action }
    }

    /// The preview.
    fn right(&mut self, ui: &mut Ui, context: &ExportContext) {
        let room = ui.max_rect();
        let fresh = self.preview.finished(context.request).is_some();
        let made = self
            .preview
            .latest()
            .filter(|made| made.request.choices.what == context.request.choices.what)
            .cloned();
        let foot = 30.0;
        let picture = Rect::from_min_max(room.min, room.max - vec2(0.0, foot + 4.0));
        let under = Rect::from_min_max(room.min + vec2(0.0, room.height() - foot), room.max);
        match (&made, self.preview.failure(context.request)) {
            (_, Some(why)) => {
                ui.scope_builder(UiBuilder::new().max_rect(picture.shrink(12.0)), |ui| {
                    ui.colored_label(ui.visuals().error_fg_color, why);
                });
            }
            (Some(made), None) => match &made.maps {
                Some(maps) if self.is_lit() => {
                    self.view.lit.ui(ui, picture, maps, context.tasks);
                }
                _ => {
                    self.view.ui(ui, picture, made, fresh);
                }
            },
            (None, None) => self.nothing(ui, picture),
        }
        ui.scope_builder(UiBuilder::new().max_rect(under), |ui| {
            ui.horizontal_centered(|ui| self.foot(ui, context, made.as_ref(), fresh));
        });
    }

    fn nothing(&self, ui: &Ui, room: Rect) {
        let fill = ui.visuals().faint_bg_color;
        ui.painter().rect_filled(room, 4.0, fill);
        let text = if self.preview.progress().is_some() {
            "Making the preview …"
        } else {
            "There is no preview yet"
        };
        let font = egui::FontId::proportional(14.0);
        let colour = ui.visuals().weak_text_color();
        ui.painter().text(room.center(), egui::Align2::CENTER_CENTER, text, font, colour);
    }

    fn foot(
        &mut self,
        ui: &mut Ui,
        context: &ExportContext,
        made: Option<&Arc<FinishedPreview>>,
        fresh: bool,
    ) {
        if let Some(progress) = self.preview.progress() {
            let width = (ui.available_width() - 90.0).max(60.0);
            ui.add(ProgressBar::new(progress).desired_width(width).desired_height(8.0));
            if ui.small_button("Stop").on_hover_text("Cancel the preview").clicked() {
                self.preview.stop();
            }
            ui.ctx().request_repaint_after(std::time::Duration::from_millis(100));
            return;
        }
        match made.filter(|_| fresh) {
            None => {
                let waits =
                    context.growing && !context.request.is_film() && context.request.options().size.is_none();
                let lacks = context.request.choices.film.change && context.request.choices.film.to.is_none();
                let can = !(context.request.is_film() && lacks);
                let text = if context.request.is_film() { "Preview the film" } else { "Show preview" };
                let explained = "Compute the whole export, to check it before it is written";
                let button = ui.add_enabled(can && !waits, Button::new(text)).on_hover_text(explained);
                if button.clicked() {
                    self.preview.make(context.tasks, context.request, context.grown, context.threads);
                }
                if waits {
                    ui.weak("The texture is still growing.");
                }
            }
            Some(made) if !made.frames().is_empty() => self.view.player(ui, made),
            Some(made) => {
                let pictures = made.pictures();
                let lit = made.maps.as_ref().map(|_| LIT);
                if pictures.len() > 1 {
                    let names = pictures.iter().map(|(name, _)| name.as_str());
                    self.which(ui, lit.into_iter().chain(names).collect());
                }
                if lit.is_some() && self.is_lit() {
                    self.view.lit.bodies(ui);
                }
                let [width, height] = pictures.first().map_or([0; 2], |(_, image)| image.size);
                if !made.whole {
                    ui.label(RichText::new(format!("reduced: {width} × {height} px")).small().weak());
                }
            }
        }
    }

    /// Whether the lit view of a material is chosen; it is the first choice.
    fn is_lit(&self) -> bool {
        self.view.chosen == LIT || self.view.chosen.is_empty()
    }

    fn which(&mut self, ui: &mut Ui, names: Vec<&str>) {
        if !names.contains(&self.view.chosen.as_str()) {
            names[0].clone_into(&mut self.view.chosen);
        }
        let combo =
            ComboBox::from_id_salt("which").selected_text(&self.view.chosen).width(190.0).show_ui(ui, |ui| {
                for name in names {
                    ui.selectable_value(&mut self.view.chosen, name.to_owned(), name);
                }
            });
        let what = self.view.chosen.clone();
        combo.response.widget_info(|| {
            let role = egui::accesskit::Role::ComboBox;
            egui::WidgetInfo::labeled(role, true, format!("Preview shows: {what}"))
        });
    }

    /// Size, time and memory of the export.
    fn summary(&self, context: &ExportContext) -> String {
        let request = context.request;
        let mut parts = Vec::new();
        let [width, height] = request.choices.size.in_px(&request.document);
        if !request.is_film() {
            let mm =
                |px: u64| px as f64 * 25.4 / (request.document.dpi * f64::from(request.choices.size.scale));
            parts.push(format!("{width} × {height} px, {:.1} × {:.1} mm", mm(width), mm(height)));
        }
        match self.preview.finished(request) {
            Some(made) => {
                parts.extend(made.message.clone());
                if made.whole {
                    let files = if made.files.len() > 1 {
                        format!(" in {} files", made.files.len())
                    } else {
                        String::new()
                    };
                    parts.push(format!("{}{files}", size_of(made.bytes)));
                }
            }
            None if !self.preview.is_ready(request, context.grown) => match self.preview.needs(request) {
                Some(needs) => {
                    let film = &request.choices.film;
                    let frames = film.clip.frames(film.kind).map_or(0.0, |frames| frames as f64);
                    let [times, pictures] = if request.is_film() { [2.0, frames] } else { [1.0, 1.0] };
                    let memory = size_of(needs.bytes as u64);
                    parts.push(format!(
                        "growing it takes {} and {memory} of memory",
                        in_words(times * needs.seconds + pictures * needs.finish)
                    ));
                }
                None => parts.push("it will be grown in the background".to_owned()),
            },
            None => {}
        }
        parts.join("  ·  ")
    }
}

/// The kinds of exports.
const KINDS: [(ExportKind, &str, &str); 4] = [
    (ExportKind::Picture, "Picture", "PNG, TIFF, OpenEXR, JPEG or WebP"),
    (
        ExportKind::Material,
        "Material",
        "Height, normals, roughness, occlusion, colours and a glTF plane, in a folder",
    ),
    (ExportKind::Outlines, "Outlines", "SVG or DXF, for drawing programs, plotters and cutters"),
    (
        ExportKind::Film,
        "Film",
        "The growth, or the change into another document, as GIF, animated PNG or single pictures",
    ),
];

/// A number of bytes in a suitable unit.
fn size_of(bytes: u64) -> String {
    match bytes as f64 {
        b if b < 1e4 => format!("{b:.0} bytes"),
        b if b < 1e6 => format!("{:.0} kB", b / 1e3),
        b if b < 1e9 => format!("{:.1} MB", b / 1e6),
        b => format!("{:.1} GB", b / 1e9),
    }
}
