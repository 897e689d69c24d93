//! The window's state, and accessors for the rest of the program and the tests.
//!
//! ```text
//!  start ─▶ frame ─▶ panels ─▶ actions ─▶ dispatch ─▶ edit, files, export, … change the state
//! ```

mod clipboard;
mod columns;
mod context;
mod dialogs;
mod dispatch;
mod edit;
mod examples;
mod export;
mod eyedropper;
mod files;
mod focus;
mod frame;
mod layers;
mod links;
mod palettes;
mod photo;
mod pictures;
mod placement;
mod places;
mod recovery;
mod settings;
mod start;
mod strip;

pub use start::Start;

use std::time::Duration;

use egui::{Pos2, Rect};

use super::action::{Page, Tab};
use super::alternatives::Alternatives;
use super::canvas::Canvas;
use super::canvas::tool::Tool;
use super::canvas::wanted::Glyph;
use super::cloud::Cloud;
use super::examples::Gallery;
use super::exporting::Exporting;
use super::goals::Goals;
use super::growth::{Growth, GrowthState, Texture};
use super::notice::{Notice, Notices};
use super::panels::{ColourPanel, LayersPanel, MenuKeys, ResultPanel};
use super::presentation::Presentation;
use super::result::Results;
use super::settings::Settings;
use super::texture::TextureView;
use super::trace::Trace;
use crate::document::Document;
use crate::editor::backdrop::Placement;
use crate::editor::recent_sketches::RecentSketches;
use crate::editor::recovery::Recovery;
use crate::editor::session::Session;
use crate::editor::task::Tasks;
use crate::editor::units::Ruler;
use crate::machine::clock::Instant;
use files::Files;
use settings::SettingsWriter;

/// The window.
pub struct Window {
    session: Session,
    canvas: Canvas,
    texture: TextureView,
    growth: Growth,
    tasks: Tasks,
    settings: Settings,
    settings_writer: SettingsWriter,
    notices: Notices,
    files: Files,
    clipboard: clipboard::Clipboard,
    recovery: Recovery,
    /// The time at which the search for lost documents began, until its results are offered.
    offer: Option<Instant>,
    /// The lost document for which *Discard* was pressed once; a second press deletes it.
    discard_asked: Option<String>,
    gallery: Gallery,
    recent_sketches: RecentSketches,
    exporting: Option<Exporting>,
    page: Option<Page>,
    presentation: Presentation,
    tab: Tab,
    layers: LayersPanel,
    results: Results,
    cloud: Cloud,
    alternatives: Alternatives,
    goals: Goals,
    colour: ColourPanel,
    result_panel: ResultPanel,
    /// Whether the column on the right is shown on a narrow screen.
    unfolded: bool,
    /// Whether all panels beside sketch and texture are hidden.
    panels_hidden: bool,
    /// Whether the texture is shown over the sketch, instead of beside it.
    over: bool,
    /// The position of the divider between them, 0..1.
    curtain: f32,
    /// Whether sketch and texture are zoomed and panned together.
    linked: bool,
    /// The revision of the session that was grown last, or is growing.
    grown: Option<u64>,
    /// Whether a menu was open in the last frame.
    menu_open: bool,
    menu_keys: MenuKeys,
    /// Whether controls are chosen with the keyboard: the pointer was not used yet, or the keyboard after it.
    by_keys: bool,
    context: context::ContextMenu,
    /// The tool before marks were selected by a key, which changed it to *Select*.
    tool_before: Option<Tool>,
    title: String,
    /// The time that a frame takes, drawing included, seconds: the longest of the last few frames.
    frame_time: f32,
    trace: Trace,
}

impl Window {
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

    /// Whether a file is being read or written.
    #[must_use]
    pub fn is_busy_with_files(&self) -> bool {
        let settings = self.settings.is_due() || self.settings_writer.is_busy();
        self.files.is_busy()
            || self.gallery.is_loading()
            || self.recent_sketches.is_busy()
            || settings
            || self.recovery.is_busy()
            || self.clipboard.is_busy()
            || self.canvas.reference.is_loading()
    }

    /// Whether the sizes and directions between the marks are being computed.
    #[must_use]
    pub fn is_busy_with_sketch(&self) -> bool {
        self.canvas.wanted.is_busy()
    }

    /// Whether the settled texture is being painted in other colours or finer.
    #[must_use]
    pub fn is_painting(&self) -> bool {
        self.growth.is_painting()
    }

    /// What the free marks of the active layer ask for, at the places that are shown.
    #[must_use]
    pub fn wanted(&self) -> &[Glyph] {
        let shown = self.canvas.wanted.of(self.session.active_layer).filter(|_| self.canvas.overlays.wanted);
        shown.map_or(&[], |wanted| &wanted.glyphs)
    }

    /// The state of the growth.
    #[must_use]
    pub fn growth_state(&self) -> &GrowthState {
        &self.growth.state
    }

    /// The growth.
    #[must_use]
    pub fn growth(&self) -> &Growth {
        &self.growth
    }

    /// The screen position of a point of the canvas, px, that is shown in `room`.
    #[must_use]
    pub fn screen(&self, room: Rect, point: [f64; 2]) -> Pos2 {
        self.canvas.view.to_screen(room, point)
    }

    /// Hides the duration of the growth, so that pictures of the window are reproducible.
    pub fn hide_times(&mut self) {
        if let GrowthState::Settled(took) = &mut self.growth.state {
            *took = Duration::ZERO;
        }
    }

    /// The texture that has settled.
    #[must_use]
    pub fn settled(&self) -> Option<&Texture> {
        self.growth.texture.as_ref()
    }

    /// What has grown of the drawn marks, and the results by region. The changes after which unreachable regions can be
    /// reached are computed only while the result tab is shown.
    #[must_use]
    pub fn results(&self) -> &Results {
        &self.results
    }

    /// The region that is shown in detail among the results, (column, row).
    #[must_use]
    pub fn chosen_region(&self) -> Option<[usize; 2]> {
        self.result_panel.chosen
    }

    /// Other textures that fit the same sketch.
    #[must_use]
    pub fn alternatives(&self) -> &Alternatives {
        &self.alternatives
    }

    /// What the active layer can become.
    #[must_use]
    pub fn goals(&self) -> &Goals {
        &self.goals
    }

    /// The training cloud.
    #[must_use]
    pub fn cloud(&self) -> &Cloud {
        &self.cloud
    }

    /// The views of sketch and texture: the centre, px, and the zoom, points per px.
    #[must_use]
    pub fn views(&self) -> [([f64; 2], f32); 2] {
        [self.canvas.view, self.texture.view].map(|view| (view.center, view.zoom))
    }

    /// Whether the texture of frozen layers is shown under the canvas.
    #[must_use]
    pub fn has_underlay(&self) -> bool {
        self.canvas.underlay.is_there()
    }

    /// Whether the texture of the frozen layers is being painted under the canvas.
    #[must_use]
    pub const fn is_painting_frozen_layers(&self) -> bool {
        self.canvas.underlay.is_being_painted()
    }

    /// Whether there is a picture under the canvas.
    #[must_use]
    pub fn has_reference(&self) -> bool {
        self.canvas.reference.is_there()
    }

    /// The placement of the picture under the canvas.
    #[must_use]
    pub fn reference(&self) -> Option<Placement> {
        self.canvas.reference.placement(self.session.document().size)
    }

    /// The messages that are shown.
    #[must_use]
    pub fn notices(&self) -> &[Notice] {
        self.notices.all()
    }

    /// How lengths of this document are shown.
    #[must_use]
    pub fn ruler(&self) -> Ruler {
        Ruler { units: self.settings.units, dpi: self.session.document().dpi }
    }

    /// Opens another document.
    fn begin(&mut self, session: Session) {
        self.finish_saving();
        self.session = session;
        self.clipboard.document_opened();
        self.files.restored = None;
        self.files.exported = None;
        self.files.palettes.document_opened();
        self.files.picture = None;
        self.files.example = None;
        self.recovery.document_opened();
        self.canvas.reference.document_opened();
        self.canvas.view.fitted = true;
        self.canvas.chosen_region = None;
        self.texture.view.fitted = true;
        self.texture.tiled = false;
        self.canvas.analysis.forget();
        self.canvas.wanted.forget();
        self.layers.forget();
        self.growth.forget();
        self.results.forget();
        self.result_panel.chosen = None;
        self.cloud.forget();
        self.alternatives.forget();
        self.goals.forget();
        self.grown = None;
        self.say_what_is_on_a_model();
    }

    /// Tells the user that a document on a model is shown flat.
    fn say_what_is_on_a_model(&mut self) {
        let Some(model) = &self.session.document().model else { return };
        let text = format!(
            "This document grows on {}. The window shows its flat sketch and keeps the model when it saves; \
             the command line draws it: \"dapple grow FILE -o OUT.png\".",
            model.source
        );
        self.notices.wrong(text);
    }
}
