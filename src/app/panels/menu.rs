//! The menu bar.

use egui::{Button, MenuBar, RichText, ThemePreference, Ui};

use crate::app::action::{Action, Page};
use crate::app::canvas::Overlays;
use crate::app::growth::Growth;
use crate::app::settings::Settings;
use crate::app::shortcuts;
use crate::editor::layer_action::LayerAction;
use crate::editor::session::Session;
use crate::grid::Edges;

/// What the menus show.
pub struct MenuState<'a> {
    /// The open document.
    pub session: &'a Session,
    /// Recent documents and the theme.
    pub settings: &'a Settings,
    /// The growth.
    pub growth: &'a Growth,
    /// What is shown over the sketch.
    pub overlays: Overlays,
    /// Recovered documents that were neither restored nor discarded yet.
    pub recovered: usize,
    /// Whether the texture is shown over the sketch.
    pub over: bool,
    /// Whether the texture is shown two by two.
    pub tiled: bool,
    /// Whether the alternatives are shown.
    pub alternatives: bool,
}

/// Shows the menus on the left and the document's name on the right.
pub fn menu(ui: &mut Ui, state: &MenuState) -> Vec<Action> {
    let mut actions = Vec::new();
    MenuBar::new().ui(ui, |ui| {
        ui.menu_button("File", |ui| file(ui, state, &mut actions));
        ui.menu_button("Edit", |ui| edit(ui, state, &mut actions));
        ui.menu_button("Layer", |ui| layer(ui, state, &mut actions));
        ui.menu_button("View", |ui| view(ui, state, &mut actions));
        ui.menu_button("Growth", |ui| growth(ui, state, &mut actions));
        ui.menu_button("Help", |ui| {
            item(ui, "First steps", &Action::Page(Page::Hint), true, &mut actions);
            item(ui, "Keys", &Action::Page(Page::Shortcuts), true, &mut actions);
            item(ui, "About dapple", &Action::Page(Page::About), true, &mut actions);
        });
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            let changed = if state.session.is_changed() { "  (changed)" } else { "" };
            ui.label(RichText::new(format!("{}{changed}", state.session.title())).weak());
        });
    });
    actions
}

fn item(ui: &mut Ui, text: &str, action: &Action, enabled: bool, actions: &mut Vec<Action>) {
    let keys = shortcuts::shortcut_text(ui.ctx(), action).unwrap_or_default();
    let button = Button::new(text).shortcut_text(keys);
    if ui.add_enabled(enabled, button).clicked() {
        actions.push(action.clone());
        ui.close();
    }
}

fn check(ui: &mut Ui, text: &str, on: bool, action: &Action, actions: &mut Vec<Action>) {
    let mut value = on;
    if ui.checkbox(&mut value, text).clicked() {
        actions.push(action.clone());
        ui.close();
    }
}

fn file(ui: &mut Ui, state: &MenuState, actions: &mut Vec<Action>) {
    ui.set_min_width(210.0);
    item(ui, "New…", &Action::New, true, actions);
    item(ui, "Open…", &Action::Open, true, actions);
    let recent = &state.settings.recent;
    ui.add_enabled_ui(!recent.is_empty(), |ui| {
        ui.menu_button("Open recent", |ui| {
            for path in recent {
                let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
                if ui.button(name).on_hover_text(path.display().to_string()).clicked() {
                    actions.push(Action::OpenFile(path.clone()));
                    ui.close();
                }
            }
            ui.separator();
            if ui.button("Forget these").clicked() {
                actions.push(Action::ForgetRecent);
                ui.close();
            }
        });
    });
    item(ui, "Examples…", &Action::Page(Page::Examples), true, actions);
    item(ui, "Recover unsaved work…", &Action::Page(Page::Recovery), state.recovered > 0, actions);
    ui.separator();
    item(ui, "Save", &Action::Save, true, actions);
    item(ui, "Save as…", &Action::SaveAs, true, actions);
    item(ui, "Import SVG…", &Action::Import, true, actions);
    item(ui, "Export…", &Action::Export, !state.growth.is_empty(), actions);
    ui.separator();
    item(ui, "Quit", &Action::Quit, true, actions);
}

fn edit(ui: &mut Ui, state: &MenuState, actions: &mut Vec<Action>) {
    ui.set_min_width(210.0);
    let [undo, redo] = state.session.can_undo_redo();
    let some = !state.session.selection.is_empty();
    item(ui, "Undo", &Action::Undo, undo, actions);
    item(ui, "Redo", &Action::Redo, redo, actions);
    ui.separator();
    for (text, action, keys) in [("Cut", Action::Cut, "X"), ("Copy", Action::Copy, "C")] {
        if ui.add_enabled(some, Button::new(text).shortcut_text(format!("Ctrl+{keys}"))).clicked() {
            actions.push(action);
            ui.close();
        }
    }
    item(ui, "Duplicate", &Action::Duplicate, some, actions);
    item(ui, "Delete", &Action::Delete, some, actions);
    item(ui, "Select all", &Action::SelectAll, true, actions);
    ui.separator();
    item(ui, "Put an ellipse in the middle", &Action::Insert(true), true, actions);
    item(ui, "Put a line in the middle", &Action::Insert(false), true, actions);
    ui.separator();
    item(ui, "Preferences…", &Action::Page(Page::Preferences), true, actions);
}

fn layer(ui: &mut Ui, state: &MenuState, actions: &mut Vec<Action>) {
    ui.set_min_width(230.0);
    for (text, action) in LayerAction::MENU {
        item(ui, text, &Action::Layer(action), state.session.allows(action), actions);
    }
}

fn view(ui: &mut Ui, state: &MenuState, actions: &mut Vec<Action>) {
    ui.set_min_width(210.0);
    check(ui, "One over the other", state.over, &Action::Over(!state.over), actions);
    let wrap = state.session.document().edges == Edges::Wrap;
    ui.add_enabled_ui(wrap, |ui| {
        check(ui, "Tiles, two by two", state.tiled, &Action::Tiled(!state.tiled), actions);
    });
    let overlays = state.overlays;
    let free = state.session.document().regions.is_none();
    ui.add_enabled_ui(!free, |ui| {
        check(ui, "Region grid", overlays.regions, &Action::Regions(!overlays.regions), actions);
    });
    ui.add_enabled_ui(free, |ui| {
        let text = "Wanted sizes and directions";
        check(ui, text, overlays.wanted, &Action::Wanted(!overlays.wanted), actions);
    });
    check(ui, "What dapple sees", overlays.analysis, &Action::Analysis(!overlays.analysis), actions);
    let alternatives = state.alternatives;
    check(ui, "Alternatives", alternatives, &Action::Alternatives(!alternatives), actions);
    item(ui, "Reference picture…", &Action::ChooseReference, true, actions);
    ui.separator();
    item(ui, "Show the whole canvas", &Action::Fit, true, actions);
    item(ui, "Actual size", &Action::ActualSize, true, actions);
    item(ui, "Zoom in", &Action::Zoom(1.25), true, actions);
    item(ui, "Zoom out", &Action::Zoom(0.8), true, actions);
    ui.separator();
    for (text, theme) in [
        ("As the system", ThemePreference::System),
        ("Light", ThemePreference::Light),
        ("Dark", ThemePreference::Dark),
    ] {
        let is_current = state.settings.theme == theme;
        if ui.radio(is_current, text).clicked() && !is_current {
            actions.push(Action::Theme(theme));
        }
    }
}

fn growth(ui: &mut Ui, state: &MenuState, actions: &mut Vec<Action>) {
    ui.set_min_width(180.0);
    let text = if state.growth.is_paused() { "Go on" } else { "Pause" };
    item(ui, text, &Action::Pause, state.growth.is_growing(), actions);
    item(ui, "Stop", &Action::Stop, state.growth.is_growing(), actions);
    item(ui, "Grow again", &Action::Grow, !state.growth.is_empty(), actions);
    item(ui, "Another seed", &Action::AnotherSeed, true, actions);
}
