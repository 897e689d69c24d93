//! The menu bar.

use egui::containers::menu::MenuButton;
use egui::text::{LayoutJob, TextFormat};
use egui::{Context, Key, MenuBar, Modifiers, Popup, RichText, Stroke, TextStyle, ThemePreference, Ui};

use super::entries::Entries;
use super::recent;
use crate::app::action::{Action, Page};
use crate::app::canvas::Overlays;
use crate::app::growth::Growth;
use crate::app::platform;
use crate::app::settings::Settings;
use crate::app::shortcuts;
use crate::editor::layer_action::LayerAction;
use crate::editor::recent_sketches::RecentSketches;
use crate::editor::session::Session;
use crate::grid::Edges;

/// What the menus show.
pub struct MenuState<'a> {
    /// The open document.
    pub session: &'a Session,
    /// Recent documents and the theme.
    pub settings: &'a Settings,
    /// Small sketches of the recent documents.
    pub sketches: &'a RecentSketches,
    /// The growth.
    pub growth: &'a Growth,
    /// What is shown over the sketch.
    pub overlays: Overlays,
    /// Recovered documents that are neither restored nor discarded yet.
    pub recovered: usize,
    /// Whether the texture is shown over the sketch.
    pub over: bool,
    /// Whether the texture is shown two by two.
    pub tiled: bool,
    /// Whether it is shown what the layer can become.
    pub goals: bool,
    /// Whether the alternatives are shown.
    pub alternatives: bool,
    /// Whether the tools and the column on the right are shown.
    pub columns: [bool; 2],
    /// Whether all panels are hidden.
    pub hidden: bool,
}

/// Shows the entries of a menu.
type Content = fn(&mut Ui, &MenuState, &mut Entries);

/// The menus, and the letters that open them with Alt.
const MENUS: [(&str, Key, Content); 6] = [
    ("File", Key::F, file),
    ("Edit", Key::E, edit),
    ("Layer", Key::L, layer),
    ("View", Key::V, view),
    ("Growth", Key::G, growth),
    ("Help", Key::H, help),
];

/// The menu that a key has opened and whose first entry gets the keyboard focus when it is shown.
#[derive(Clone, Copy, Debug, Default)]
pub struct MenuKeys(Option<usize>);

/// Shows the menus on the left and the document's name on the right. `keys`: whether keys open menus now.
pub fn menu(ui: &mut Ui, state: &MenuState, opened: &mut MenuKeys, keys: bool) -> Vec<Action> {
    let mut actions = Vec::new();
    MenuBar::new().ui(ui, |ui| {
        let mut popups = Vec::with_capacity(MENUS.len());
        for (index, (name, _, content)) in MENUS.iter().enumerate() {
            let (button, _) = MenuButton::new(title(ui, name)).ui(ui, |ui| {
                let mut entries = Entries::new(&mut actions);
                content(ui, state, &mut entries);
                if entries.navigate(ui, opened.0 == Some(index)) {
                    opened.0 = None;
                }
            });
            popups.push(Popup::default_response_id(&button));
        }
        let open = popups.iter().position(|id| Popup::is_id_open(ui.ctx(), *id));
        if let Some(next) = asked(ui.ctx(), open).filter(|_| keys) {
            Popup::open_id(ui.ctx(), popups[next]);
            opened.0 = Some(next);
            ui.ctx().request_repaint();
        }
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            let changed = if state.session.is_changed() { "  (changed)" } else { "" };
            ui.label(RichText::new(format!("{}{changed}", state.session.title())).weak());
        });
    });
    actions
}

/// The menu that the pressed keys ask for: by Alt and its letter, by F10, or by the arrow keys from the menu that is
/// `open`.
fn asked(ctx: &Context, open: Option<usize>) -> Option<usize> {
    ctx.input_mut(|input| {
        let letter = MENUS.iter().position(|(_, letter, _)| input.consume_key(Modifiers::ALT, *letter));
        let first = |input: &mut egui::InputState| {
            input.modifiers.is_none() && input.consume_key(Modifiers::NONE, Key::F10)
        };
        if letter.is_some() || first(input) {
            return letter.or(Some(0));
        }
        let open = open?;
        let by = input.num_presses(Key::ArrowRight) as isize - input.num_presses(Key::ArrowLeft) as isize;
        (by != 0).then(|| (open as isize + by).rem_euclid(MENUS.len() as isize) as usize)
    })
}

/// The title of a menu; its first letter is underlined while Alt is held.
fn title(ui: &Ui, name: &str) -> LayoutJob {
    let is_marked = ui.input(|input| input.modifiers.alt);
    let font_id = TextStyle::Button.resolve(ui.style());
    let color = egui::Color32::PLACEHOLDER;
    let underline = if is_marked { Stroke::new(1.0, ui.visuals().text_color()) } else { Stroke::NONE };
    let (first, rest) = name.split_at(1);
    let mut job = LayoutJob::default();
    job.append(
        first,
        0.0,
        TextFormat { font_id: font_id.clone(), color, underline, ..TextFormat::default() },
    );
    job.append(rest, 0.0, TextFormat { font_id, color, ..TextFormat::default() });
    job
}

fn file(ui: &mut Ui, state: &MenuState, entries: &mut Entries) {
    ui.set_min_width(210.0);
    entries.item(ui, "New…", &Action::New, true);
    entries.item(ui, "Open…", &Action::Open, true);
    let paths = &state.settings.recent;
    let submenu = ui.add_enabled_ui(!paths.is_empty(), |ui| {
        let shown = ui.menu_button("Open recent", |ui| {
            recent::recent(ui, paths, state.sketches, entries.actions);
        });
        shown.response
    });
    entries.reach(&submenu.inner);
    entries.item(ui, "Examples…", &Action::Page(Page::Examples), true);
    entries.item(ui, "Recover unsaved work…", &Action::Page(Page::Recovery), state.recovered > 0);
    ui.separator();
    entries.item(ui, "Save", &Action::Save, true);
    entries.item(ui, "Save as…", &Action::SaveAs, true);
    entries.item(ui, "Import SVG…", &Action::Import, true);
    entries.item(ui, "Import a photograph…", &Action::ImportPhoto, true);
    entries.item(ui, "Export…", &Action::Export, !state.growth.is_empty());
    if platform::CAN_QUIT {
        ui.separator();
        entries.item(ui, "Quit", &Action::Quit, true);
    }
}

fn edit(ui: &mut Ui, state: &MenuState, entries: &mut Entries) {
    ui.set_min_width(230.0);
    let [undo, redo] = state.session.can_undo_redo();
    let some = !state.session.selection.is_empty();
    entries.item(ui, "Undo", &Action::Undo, undo);
    entries.item(ui, "Redo", &Action::Redo, redo);
    ui.separator();
    clipboard(ui, some, entries);
    copy_picture(ui, state.growth.texture.is_some(), entries);
    copy_link(ui, !state.session.is_empty(), entries);
    entries.item(ui, "Select all", &Action::SelectAll, true);
    ui.separator();
    entries.item(ui, "Add ellipse at centre", &Action::Insert(true), true);
    entries.item(ui, "Add line at centre", &Action::Insert(false), true);
    ui.separator();
    entries.item(ui, "Preferences…", &Action::Page(Page::Preferences), true);
}

/// Cut, copy, paste, duplicate, delete; `some`: whether marks are selected.
pub(super) fn clipboard(ui: &mut Ui, some: bool, entries: &mut Entries) {
    let keys = |ui: &Ui, letter| format!("{}+{letter}", ui.ctx().format_modifiers(Modifiers::COMMAND));
    for (text, action, letter, enabled) in [
        ("Cut", Action::Cut, "X", some),
        ("Copy", Action::Copy, "C", some),
        ("Paste", Action::AskPaste, "V", true),
    ] {
        let keys = keys(ui, letter);
        entries.item_with(ui, text, &keys, &action, enabled);
    }
    entries.item(ui, "Duplicate", &Action::Duplicate, some);
    entries.item(ui, "Delete", &Action::Delete, some);
}

/// The entry that copies the texture; `can`: the texture is finished.
pub(super) fn copy_picture(ui: &mut Ui, can: bool, entries: &mut Entries) {
    entries.item(ui, "Copy the texture as a picture", &Action::CopyPicture, can);
}

/// The entry that copies a link; `can`: the document is not empty.
pub(super) fn copy_link(ui: &mut Ui, can: bool, entries: &mut Entries) {
    entries.item(ui, "Copy link", &Action::CopyLink, can);
}

fn layer(ui: &mut Ui, state: &MenuState, entries: &mut Entries) {
    ui.set_min_width(260.0);
    for (text, action) in LayerAction::MENU {
        entries.item(ui, text, &Action::Layer(action), state.session.allows(action));
    }
}

fn view(ui: &mut Ui, state: &MenuState, entries: &mut Entries) {
    ui.set_min_width(210.0);
    entries.check(ui, "Texture over the sketch", state.over, &Action::Over(!state.over), true);
    let wrap = state.session.document().edges == Edges::Wrap;
    entries.check(ui, "Two by two tiles", state.tiled, &Action::Tiled(!state.tiled), wrap);
    let overlays = state.overlays;
    let free = state.session.document().regions.is_none();
    entries.check(ui, "Region grid", overlays.regions, &Action::Regions(!overlays.regions), !free);
    let text = "Sizes and directions between marks";
    entries.check(ui, text, overlays.wanted, &Action::Wanted(!overlays.wanted), free);
    let analysis = overlays.analysis;
    entries.check(ui, "Analysis of the sketch", analysis, &Action::Analysis(!analysis), true);
    entries.check(ui, "What it can become", state.goals, &Action::Goals(!state.goals), true);
    let alternatives = state.alternatives;
    entries.check(ui, "Alternatives", alternatives, &Action::Alternatives(!alternatives), true);
    let [tools, column] = state.columns;
    entries.check(ui, "Tools", tools, &Action::Tools(!tools), true);
    entries.check(ui, "Right column", column, &Action::Column(!column), true);
    entries.item_with(
        ui,
        if state.hidden { "Show panels" } else { "Hide panels" },
        "Tab",
        &Action::TogglePanels,
        true,
    );
    if platform::CAN_QUIT {
        entries.item(ui, "Full screen", &Action::FullScreen, true);
    }
    entries.item(ui, "Reference picture…", &Action::ChooseReference, true);
    ui.separator();
    entries.item(ui, "Show the whole canvas", &Action::Fit, true);
    entries.item(ui, "Actual size", &Action::ActualSize, true);
    entries.item(ui, "Zoom in", &Action::Zoom(shortcuts::ZOOM), true);
    entries.item(ui, "Zoom out", &Action::Zoom(1.0 / shortcuts::ZOOM), true);
    ui.separator();
    for (text, theme) in [
        ("System theme", ThemePreference::System),
        ("Light theme", ThemePreference::Light),
        ("Dark theme", ThemePreference::Dark),
    ] {
        entries.radio(ui, text, state.settings.theme == theme, &Action::Theme(theme));
    }
}

fn growth(ui: &mut Ui, state: &MenuState, entries: &mut Entries) {
    ui.set_min_width(180.0);
    let text = if state.growth.is_paused() { "Resume" } else { "Pause" };
    entries.item(ui, text, &Action::Pause, state.growth.is_growing());
    entries.item(ui, "Stop", &Action::Stop, state.growth.is_growing());
    entries.item(ui, "Grow again", &Action::Grow, !state.growth.is_empty());
    entries.item(ui, "Another seed", &Action::AnotherSeed, true);
}

fn help(ui: &mut Ui, _: &MenuState, entries: &mut Entries) {
    entries.item(ui, "First steps", &Action::Page(Page::Hint), true);
    entries.item(ui, "Keyboard shortcuts", &Action::Page(Page::Shortcuts), true);
    entries.item(ui, "About dapple", &Action::Page(Page::About), true);
}
