//! The dialog: what was found and what can be corrected on the left, the photograph on the right.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use egui::{
    Align, ColorImage, Label, Layout, ProgressBar, RichText, ScrollArea, TextureHandle, TextureOptions, Ui,
    UiBuilder, vec2,
};

use super::job::{self, Found, Known, News, part};
use super::view::View;
use super::{choices, words};
use crate::app::pages::{Answer, choice_of};
use crate::app::small_screen;
use crate::app::theme::Palette;
use crate::editor::task::{StartError, Task, Tasks};
use crate::editor::units::{Ruler, Units};
use crate::synth::import::photo::{ImportedPhoto, PhotoOptions};

/// Width of the column on the left, points.
const COLUMN: f32 = 296.0;
/// The largest size of the dialog, points.
const LARGEST: [f32; 2] = [1180.0, 760.0];

/// What the user asks the dialog for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PhotoAction {
    /// Open the sketch.
    Take,
    /// Close the dialog.
    Cancel,
}

/// The dialog for a photograph from which a sketch is made.
pub struct Importing {
    /// The file of the photograph.
    pub path: PathBuf,
    /// The options that the user has chosen.
    pub options: PhotoOptions,
    known: Known,
    task: Option<(PhotoOptions, Task<News>)>,
    found: Option<Box<Found>>,
    failed: Option<(PhotoOptions, String)>,
    /// The options with which no thread could be started: it is reported once.
    refused: Option<PhotoOptions>,
    /// The largest area that can be chosen for the smallest mark, px².
    largest: f64,
    photo: Option<TextureHandle>,
    overlay: Option<TextureHandle>,
    view: View,
}

impl Importing {
    /// Begins with the photograph `path`.
    #[must_use]
    pub fn new(path: &Path) -> Self {
        Self {
            path: path.to_owned(),
            options: PhotoOptions::default(),
            known: Known::default(),
            task: None,
            found: None,
            failed: None,
            refused: None,
            largest: 100.0,
            photo: None,
            overlay: None,
            view: View::default(),
        }
    }

    /// The name of the file.
    #[must_use]
    pub fn name(&self) -> String {
        self.path.file_name().unwrap_or_default().to_string_lossy().into_owned()
    }

    /// Whether the photograph is being read, or will be.
    #[must_use]
    pub fn is_reading(&self) -> bool {
        self.task.is_some() || !self.is_known() && self.refused != Some(self.wanted())
    }

    /// What was found with the current options.
    #[must_use]
    pub fn found(&self) -> Option<&Found> {
        self.found.as_deref().filter(|found| found.options == self.wanted())
    }

    /// Why nothing was found with the current options.
    #[must_use]
    pub fn failure(&self) -> Option<&str> {
        self.failed.as_ref().filter(|(options, _)| *options == self.wanted()).map(|(_, why)| why.as_str())
    }

    /// The document, and the picture to show under it, where the document can be opened.
    #[must_use]
    pub fn taken(&self) -> Option<(&ImportedPhoto, &Arc<ColorImage>)> {
        let found = self.found().filter(|found| found.neither.is_none() || self.options.take_it)?;
        Some((found.document.as_ref().ok()?, &found.reference))
    }

    /// The place of a corner on the screen, in the last frame: upper left, upper right, lower right, lower left.
    #[must_use]
    pub fn corner(&self, corner: usize) -> egui::Pos2 {
        self.view.corner(corner, self.options.framing.corners)
    }

    /// The options on which a reading depends.
    fn wanted(&self) -> PhotoOptions {
        PhotoOptions { take_it: false, ..self.options }
    }

    fn is_known(&self) -> bool {
        self.found().is_some() || self.failure().is_some()
    }

    /// Receives the results of a reading, and starts to read with the chosen options on another thread.
    ///
    /// # Errors
    /// Where no thread can be started.
    pub fn follow(
        &mut self,
        ctx: &egui::Context,
        tasks: &Tasks,
        threads: Option<usize>,
    ) -> Result<(), StartError> {
        self.listen(ctx);
        let wanted = self.wanted();
        if let Some((options, task)) = &self.task {
            // Other limits do not need another segmentation, so they are shown while a slider is dragged.
            if part(options) != part(&wanted) {
                task.cancel();
            }
            return Ok(());
        }
        if self.is_known() || self.refused == Some(wanted) {
            return Ok(());
        }
        match job::start(&self.path, wanted, self.known.clone(), threads, tasks) {
            Ok(task) => {
                self.task = Some((wanted, task));
                Ok(())
            }
            Err(error) => {
                self.refused = Some(wanted);
                Err(error)
            }
        }
    }

    fn listen(&mut self, ctx: &egui::Context) {
        while let Some((options, task)) = &mut self.task {
            match task.poll() {
                Some(news) => self.hear(ctx, news),
                None if task.has_ended() => {
                    let options = *options;
                    let is_silent = !task.is_cancelled()
                        && self.found.as_ref().is_none_or(|found| found.options != options)
                        && self.failed.as_ref().is_none_or(|(of, _)| *of != options);
                    if is_silent {
                        let why = "Reading it failed because of an error in dapple. Please report it.";
                        self.failed = Some((options, why.to_owned()));
                    }
                    self.task = None;
                }
                None => return,
            }
        }
    }

    fn hear(&mut self, ctx: &egui::Context, news: News) {
        let put = |texture: &mut Option<TextureHandle>, name: &str, image: Arc<ColorImage>| match texture {
            Some(texture) => texture.set(image, TextureOptions::LINEAR),
            None => *texture = Some(ctx.load_texture(name, image, TextureOptions::LINEAR)),
        };
        match news {
            News::Opened(opened, photo) => {
                put(&mut self.photo, "photograph", photo);
                self.view.size = opened.raster.size.map(|side| side as f64);
                self.known.opened = Some(opened);
            }
            News::Segmented(segmented) => self.known.segmented = Some(segmented),
            News::Found(mut found) => {
                let overlay = std::mem::replace(
                    &mut found.overlay,
                    ColorImage::filled([1, 1], egui::Color32::TRANSPARENT),
                );
                put(&mut self.overlay, "found marks", Arc::new(overlay));
                if found.options.framing.limits.smallest.is_none() {
                    self.largest = choices::largest(&found.picture);
                }
                self.found = Some(found);
                self.failed = None;
            }
            News::Failed(options, why) => {
                self.failed = Some((options, why));
                self.found = None;
                self.overlay = None;
            }
        }
    }

    /// Shows it.
    pub fn ui(&mut self, ui: &mut Ui, units: Units) -> Option<PhotoAction> {
        let size = small_screen::dialog_size(ui.ctx(), LARGEST);
        ui.set_width(size.x);
        let enter = ui.input(|input| input.key_pressed(egui::Key::Enter))
            && ui.memory(|memory| memory.focused().is_none());
        ui.horizontal(|ui| {
            ui.heading("Sketch from a photograph");
            ui.add_space(8.0);
            ui.weak(self.name());
        });
        ui.add_space(6.0);
        let height = (size.y - 118.0).max(200.0);
        let (all, _) = ui.allocate_exact_size(vec2(size.x, height), egui::Sense::hover());
        let [left, right] = small_screen::parts(ui.ctx(), all, COLUMN);
        // A fixed rectangle: the size of the dialog does not depend on its content.
        let mut column = ui.new_child(UiBuilder::new().max_rect(left));
        let area = ScrollArea::vertical().auto_shrink([false; 2]).max_height(left.height());
        area.show(&mut column, |ui| {
            ui.set_max_width(left.width() - 14.0);
            self.column(ui, units);
        });
        self.picture(&mut ui.new_child(UiBuilder::new().max_rect(right)));
        ui.add_space(4.0);
        ui.separator();
        let can = self.taken().is_some();
        let mut action = None;
        ui.horizontal(|ui| {
            ui.vertical(|ui| {
                ui.set_width((size.x - 260.0).max(200.0));
                self.foot(ui);
            });
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                action = match choice_of(ui, "Open the sketch", can, None) {
                    Some(Answer::Yes) => Some(PhotoAction::Take),
                    Some(_) => Some(PhotoAction::Cancel),
                    None => None,
                };
            });
        });
        action.or((enter && can).then_some(PhotoAction::Take))
    }

    fn column(&mut self, ui: &mut Ui, units: Units) {
        let dpi = self.found().and_then(|found| Some(found.document.as_ref().ok()?.document.dpi));
        let ruler = Ruler { units, dpi: dpi.unwrap_or(300.0) };
        self.report(ui, ruler);
        ui.add_space(4.0);
        ui.separator();
        // The last result stays, paler, while the photograph is read with other options.
        let last = self.found.as_deref();
        choices::choices(ui, &mut self.options, last, self.largest, ruler);
    }

    /// The result, or the reason why there is none.
    fn report(&mut self, ui: &mut Ui, ruler: Ruler) {
        let wrong = Palette::current(ui.visuals()).wrong;
        if let Some(why) = self.failure() {
            ui.add(Label::new(RichText::new(why).color(wrong)).wrap().selectable(true));
            ui.weak("Another choice of marks, another level or another part of the photograph may help.");
            return;
        }
        let Some(found) = &self.found else {
            ui.label(if self.photo.is_some() {
                "Looking for marks …"
            } else {
                "Opening the photograph …"
            });
            return;
        };
        ui.label(RichText::new(words::heading(found)).strong().size(15.0));
        choices::rows(ui, "found", |ui| {
            for (name, value) in words::numbers(found, ruler) {
                ui.weak(name);
                ui.label(value);
                ui.end_row();
            }
        });
        let neither = found.neither;
        if let Err(why) = &found.document {
            ui.add(Label::new(RichText::new(why).color(wrong)).wrap().selectable(true));
        } else if let Some(why) = neither {
            let text = format!("Neither spots nor stripes: {why}.");
            ui.add(Label::new(RichText::new(text).color(wrong)).wrap().selectable(true));
            ui.checkbox(&mut self.options.take_it, "Take it anyway").on_hover_text(
                "Make a sketch of the marks that were found, although the photograph seems to \
                                show no pattern of spots or stripes",
            );
        }
    }

    fn picture(&mut self, ui: &mut Ui) {
        let room = ui.max_rect();
        let Some(photo) = self.photo.as_ref().map(TextureHandle::id) else {
            ui.painter().rect_filled(room, 4.0, ui.visuals().faint_bg_color);
            return;
        };
        let found = self.found.as_deref();
        // Marks that were found with other corners are not at the places where they would be shown.
        let is_placed = found.is_some_and(|found| part(&found.options) == part(&self.options));
        let overlay = self.overlay.as_ref().filter(|_| is_placed && !self.view.is_dragged());
        let overlay = overlay.map(|overlay| (overlay.id(), if self.found().is_some() { 1.0 } else { 0.6 }));
        let regions = self.found().and_then(|found| found.document.as_ref().ok()?.document.regions);
        self.view.ui(ui, room, photo, overlay, regions, &mut self.options.framing.corners);
    }

    fn foot(&self, ui: &mut Ui) {
        if let (Some((_, task)), false) = (&self.task, self.found().is_some()) {
            ui.add(ProgressBar::new(task.progress() as f32).desired_width(220.0).desired_height(8.0));
            ui.ctx().request_repaint_after(std::time::Duration::from_millis(100));
            return;
        }
        let text = self.found().and_then(words::sketch);
        if let Some(text) = text {
            ui.label(RichText::new(format!("Sketch: {text}")).small().weak());
        }
    }
}
