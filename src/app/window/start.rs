//! Opening the window.

use std::path::PathBuf;

use egui::{Context, Theme};

use super::Window;
use super::clipboard::Clipboard;
use super::context::ContextMenu;
use super::files::Files;
use super::settings::SettingsWriter;
use crate::app::action::Tab;
use crate::app::alternatives::Alternatives;
use crate::app::canvas::Canvas;
use crate::app::cloud::Cloud;
use crate::app::examples::Gallery;
use crate::app::goals::Goals;
use crate::app::growth::Growth;
use crate::app::notice::Notices;
use crate::app::panels::{ColourPanel, LayersPanel, MenuKeys, ResultPanel};
use crate::app::platform;
use crate::app::presentation::Presentation;
use crate::app::result::Results;
use crate::app::settings::Settings;
use crate::app::texture::TextureView;
use crate::app::theme;
use crate::app::trace::Trace;
use crate::editor::recent_sketches::RecentSketches;
use crate::editor::recovery::Recovery;
use crate::editor::session::Session;
use crate::editor::task::{Spawn, Tasks};
use crate::machine::clock::Instant;

/// What the window starts with.
#[derive(Default)]
pub struct Start {
    /// The document to open.
    pub file: Option<PathBuf>,
    /// A link to the document to open.
    pub link: Option<String>,
    /// Which parts of the window are shown.
    pub presentation: Presentation,
    /// The settings.
    pub settings: Settings,
    /// The folder where unsaved work is kept; `None` = it is not kept.
    pub recovery: Option<PathBuf>,
    /// Whether files are chosen with the system's own dialogs.
    pub native_dialogs: bool,
    /// How threads are started; tests make this fail.
    pub spawn: Spawn,
}

impl Window {
    /// A window with a document from a file, or an empty one.
    #[must_use]
    pub fn new(ctx: &Context, start: Start) -> Self {
        set_up(ctx, &start.settings);
        let tasks = Tasks::new(platform::waker(ctx)).with_spawn(start.spawn);
        let results = Results::default();
        let mut window = Self {
            session: Session::open(start.settings.new.document(), None),
            canvas: Canvas::default(),
            texture: TextureView::default(),
            growth: Growth::new(tasks.clone()),
            tasks: tasks.clone(),
            settings: start.settings,
            settings_writer: SettingsWriter::default(),
            notices: Notices::default(),
            files: Files::new(start.native_dialogs),
            clipboard: Clipboard::default(),
            gallery: Gallery::default(),
            recent_sketches: RecentSketches::default(),
            exporting: None,
            page: None,
            presentation: start.presentation,
            recovery: Recovery::new(start.recovery, tasks.clone()),
            offer: Some(Instant::now()),
            discard_asked: None,
            tab: Tab::default(),
            layers: LayersPanel::default(),
            alternatives: Alternatives::new(results.training.clone()),
            goals: Goals::new(results.training.clone()),
            results,
            cloud: Cloud::default(),
            colour: ColourPanel::default(),
            result_panel: ResultPanel::default(),
            unfolded: false,
            panels_hidden: false,
            over: false,
            curtain: 0.5,
            linked: true,
            grown: None,
            menu_open: false,
            menu_keys: MenuKeys::default(),
            by_keys: true,
            context: ContextMenu::default(),
            tool_before: None,
            title: String::new(),
            frame_time: 0.0,
            trace: Trace::asked(),
        };
        window.restore_layout();
        if let Some(error) = window.settings.error.take() {
            window.notices.wrong(error);
        }
        let searching = window.recovery.search();
        window.report(searching.err());
        if let Some(file) = start.file {
            window.open_any(file);
        }
        if let Some(link) = start.link {
            window.open_link(&link);
        }
        window
    }
}

/// Sets the look of the window.
fn set_up(ctx: &Context, settings: &Settings) {
    theme::apply(ctx);
    ctx.set_theme(settings.theme);
    ctx.set_zoom_factor(settings.scale);
    // Ctrl with + or − zooms the canvas, not the controls.
    ctx.options_mut(|options| {
        options.zoom_with_keyboard = false;
        options.fallback_theme = Theme::Light;
    });
}
