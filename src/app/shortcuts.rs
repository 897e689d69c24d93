//! Keyboard shortcuts, and the page that lists them.

use std::sync::Arc;

use egui::{Context, Event, Key, KeyboardShortcut, Modifiers, RichText, ScrollArea, Ui, vec2};

use super::action::{Action, Page, WIDER};
use super::canvas::tool::Tool;
use super::platform::CAN_QUIT;
use super::small_screen::is_small;
use crate::editor::layer_action::LayerAction;

/// Factor of a step of zooming.
pub const ZOOM: f32 = 1.1;

const CTRL: Modifiers = Modifiers::COMMAND;
const CTRL_SHIFT: Modifiers = CTRL.plus(Modifiers::SHIFT);

/// A keyboard shortcut.
pub struct Shortcut {
    /// The keys.
    pub keys: KeyboardShortcut,
    /// Its action.
    pub action: fn() -> Action,
    /// Its description on the page.
    pub text: &'static str,
    /// Its group on the page.
    pub group: &'static str,
}

const fn with(
    modifiers: Modifiers,
    key: Key,
    text: &'static str,
    group: &'static str,
    action: fn() -> Action,
) -> Shortcut {
    Shortcut { keys: KeyboardShortcut::new(modifiers, key), action, text, group }
}

/// All shortcuts, in the order of the page.
pub const SHORTCUTS: &[Shortcut] = &[
    with(CTRL, Key::N, "New document", "Document", || Action::New),
    with(CTRL, Key::O, "Open", "Document", || Action::Open),
    with(CTRL_SHIFT, Key::S, "Save as", "Document", || Action::SaveAs),
    with(CTRL, Key::S, "Save", "Document", || Action::Save),
    with(CTRL, Key::E, "Export", "Document", || Action::Export),
    with(CTRL, Key::I, "Import a photograph", "Document", || Action::ImportPhoto),
    with(CTRL_SHIFT, Key::E, "Examples", "Document", || Action::Page(Page::Examples)),
    with(CTRL, Key::Comma, "Preferences", "Document", || Action::Page(Page::Preferences)),
    with(CTRL, Key::Q, "Quit", "Document", || Action::Quit),
    with(CTRL_SHIFT, Key::Z, "Redo", "Edit", || Action::Redo),
    with(CTRL, Key::Z, "Undo", "Edit", || Action::Undo),
    with(CTRL, Key::Y, "Redo", "Edit", || Action::Redo),
    with(CTRL, Key::D, "Duplicate", "Edit", || Action::Duplicate),
    with(CTRL_SHIFT, Key::C, "Copy the texture as a picture", "Edit", || Action::CopyPicture),
    with(CTRL, Key::A, "Select all", "Edit", || Action::SelectAll),
    with(Modifiers::NONE, Key::Delete, "Delete", "Edit", || Action::Delete),
    with(Modifiers::NONE, Key::Backspace, "Delete", "Edit", || Action::Delete),
    with(Modifiers::NONE, Key::Escape, "Cancel, or clear the selection", "Edit", || Action::Escape),
    with(CTRL, Key::CloseBracket, "Select the next mark", "Edit", || Action::Next(1)),
    with(CTRL, Key::OpenBracket, "Select the previous mark", "Edit", || Action::Next(-1)),
    with(Modifiers::NONE, Key::CloseBracket, "Wider line, larger ellipse", "Edit", || Action::Widen(WIDER)),
    with(Modifiers::NONE, Key::OpenBracket, "Narrower line, smaller ellipse", "Edit", || {
        Action::Widen(1.0 / WIDER)
    }),
    with(Modifiers::SHIFT, Key::F10, "Menu of the selected marks", "Edit", || Action::ContextMenu),
    with(Modifiers::NONE, Key::Period, "Turn by 5°", "Edit", || Action::Turn(5.0)),
    with(Modifiers::NONE, Key::Comma, "Turn back by 5°", "Edit", || Action::Turn(-5.0)),
    with(Modifiers::NONE, Key::Plus, "Larger", "Edit", || Action::Scale(1.1)),
    with(Modifiers::NONE, Key::Equals, "Larger", "Edit", || Action::Scale(1.1)),
    with(Modifiers::NONE, Key::Minus, "Smaller", "Edit", || Action::Scale(1.0 / 1.1)),
    with(Modifiers::SHIFT, Key::E, "Add ellipse at centre", "Draw", || Action::Insert(true)),
    with(Modifiers::SHIFT, Key::L, "Add line at centre", "Draw", || Action::Insert(false)),
    with(Modifiers::NONE, Key::V, "Select", "Draw", || Action::Tool(Tool::Select)),
    with(Modifiers::NONE, Key::B, "Freehand", "Draw", || Action::Tool(Tool::Pen)),
    with(Modifiers::NONE, Key::E, "Ellipse", "Draw", || Action::Tool(Tool::Ellipse)),
    with(Modifiers::NONE, Key::L, "Line", "Draw", || Action::Tool(Tool::Line)),
    with(Modifiers::NONE, Key::X, "Eraser", "Draw", || Action::Tool(Tool::Eraser)),
    with(Modifiers::NONE, Key::H, "Pan", "Draw", || Action::Tool(Tool::Hand)),
    with(CTRL_SHIFT, Key::N, "New layer", "Layers", || Action::Layer(LayerAction::Add)),
    with(Modifiers::NONE, Key::F, "Freeze layer and start the next", "Layers", || {
        Action::Layer(LayerAction::SketchNext)
    }),
    with(Modifiers::SHIFT, Key::F, "Unfreeze layer", "Layers", || Action::Layer(LayerAction::Unfreeze)),
    with(Modifiers::NONE, Key::PageUp, "Select layer above", "Layers", || {
        Action::Layer(LayerAction::Step(1))
    }),
    with(Modifiers::NONE, Key::PageDown, "Select layer below", "Layers", || {
        Action::Layer(LayerAction::Step(-1))
    }),
    with(CTRL, Key::PageUp, "Raise layer", "Layers", || Action::Layer(LayerAction::Shift(1))),
    with(CTRL, Key::PageDown, "Lower layer", "Layers", || Action::Layer(LayerAction::Shift(-1))),
    with(CTRL, Key::J, "Duplicate layer", "Layers", || Action::Layer(LayerAction::Duplicate)),
    with(Modifiers::SHIFT, Key::H, "Hide or show layer", "Layers", || Action::Layer(LayerAction::Hide)),
    with(Modifiers::NONE, Key::F2, "Rename layer", "Layers", || Action::Layer(LayerAction::Rename)),
    with(Modifiers::NONE, Key::A, "Alternatives", "View", || Action::ToggleAlternatives),
    with(Modifiers::NONE, Key::W, "Sizes and directions between marks", "View", || Action::ToggleWanted),
    with(CTRL, Key::Num0, "Show the whole canvas", "View", || Action::Fit),
    with(CTRL, Key::Num1, "Actual size", "View", || Action::ActualSize),
    with(CTRL, Key::Plus, "Zoom in", "View", || Action::Zoom(ZOOM)),
    with(CTRL, Key::Equals, "Zoom in", "View", || Action::Zoom(ZOOM)),
    with(CTRL, Key::Minus, "Zoom out", "View", || Action::Zoom(1.0 / ZOOM)),
    with(Modifiers::NONE, Key::F9, "Right column", "View", || Action::ToggleColumn),
    with(Modifiers::NONE, Key::F11, FULL_SCREEN, "View", || Action::FullScreen),
    with(Modifiers::NONE, Key::P, "Pause or resume", "Growth", || Action::Pause),
    with(Modifiers::NONE, Key::N, "Another seed", "Growth", || Action::AnotherSeed),
    with(CTRL, Key::R, "Grow again", "Growth", || Action::Grow),
    with(CTRL, Key::Period, "Stop", "Growth", || Action::Stop),
    with(Modifiers::NONE, Key::F1, "Keyboard shortcuts", "Help", || Action::Page(Page::Shortcuts)),
];

/// The description of a shortcut that only a window of its own has: a browser has its own.
const FULL_SCREEN: &str = "Full screen";

/// The arrow keys and their directions.
const ARROWS: [(Key, [f64; 2]); 4] = [
    (Key::ArrowLeft, [-1.0, 0.0]),
    (Key::ArrowRight, [1.0, 0.0]),
    (Key::ArrowUp, [0.0, -1.0]),
    (Key::ArrowDown, [0.0, 1.0]),
];

/// The actions of the pressed keys. `canvas`: the canvas or nothing has the focus; otherwise keys without Ctrl belong
/// to the widget that has it. `arrows`: the arrow keys move marks.
pub fn asked(ctx: &Context, canvas: bool, arrows: bool) -> Vec<Action> {
    let mut actions = Vec::new();
    // In a text field Ctrl+A selects the text, and Ctrl+Z undoes what was typed there.
    let typing = ctx.text_edit_focused();
    ctx.input_mut(|input| {
        if canvas {
            for event in &input.events {
                match event {
                    Event::Copy => actions.push(Action::Copy),
                    Event::Cut => actions.push(Action::Cut),
                    Event::Paste(text) => actions.push(Action::Paste(text.clone())),
                    Event::PasteImage(picture) => actions.push(Action::PastePicture(Arc::clone(picture))),
                    _ => {}
                }
            }
        }
        // Shortcuts with Shift come first: one without Shift would match their keys too.
        let shift = |shortcut: &&Shortcut| shortcut.keys.modifiers.shift;
        // Alt and a letter open menus.
        let alt = input.modifiers.alt;
        let ordered = SHORTCUTS.iter().filter(shift).chain(SHORTCUTS.iter().filter(|one| !shift(one)));
        for shortcut in ordered {
            let plain = !shortcut.keys.modifiers.command;
            let function = matches!(shortcut.keys.logical_key, Key::F1 | Key::F9 | Key::F11);
            if !is_available(shortcut)
                || alt
                || (typing && !function && shortcut.group != "Document")
                || (plain && !canvas && !function)
            {
                continue;
            }
            while input.consume_shortcut(&shortcut.keys) {
                actions.push((shortcut.action)());
            }
        }
        if arrows {
            for (key, [x, y]) in ARROWS {
                for (modifiers, by) in [(Modifiers::SHIFT, 10.0), (Modifiers::NONE, 1.0)] {
                    let times = input.count_and_consume_key(modifiers, key);
                    actions.extend((0..times).map(|_| Action::Nudge([by * x, by * y])));
                }
            }
        }
    });
    actions
}

/// The keys of an action, as this system writes them.
#[must_use]
pub fn shortcut_text(ctx: &Context, action: &Action) -> Option<String> {
    let shortcut = SHORTCUTS.iter().find(|shortcut| (shortcut.action)() == *action)?;
    Some(spelled(ctx, shortcut.keys))
}

/// The text of a shortcut, such as `Ctrl+[`.
fn spelled(ctx: &Context, keys: KeyboardShortcut) -> String {
    let sign = match keys.logical_key {
        Key::OpenBracket => "[",
        Key::CloseBracket => "]",
        Key::Period => ".",
        Key::Comma => ",",
        Key::Plus => "+",
        Key::Minus => "-",
        other => other.name(),
    };
    match ctx.format_modifiers(keys.modifiers) {
        none if none.is_empty() => sign.to_owned(),
        modifiers => format!("{modifiers}+{sign}"),
    }
}

/// Shows the page.
pub fn page(ui: &mut Ui) {
    let columns = [&["Document", "View", "Layers", "Help"][..], &["Draw", "Edit", "Growth"]];
    ScrollArea::vertical().max_height(600.0).show(ui, |ui| {
        ui.spacing_mut().item_spacing = vec2(28.0, 0.5);
        ui.spacing_mut().interact_size.y = 18.0;
        let beside = if is_small(ui.ctx()) { 1 } else { columns.len() };
        ui.columns(beside, |uis| {
            for (index, groups) in columns.into_iter().enumerate() {
                let ui = &mut uis[index % beside];
                for group in groups {
                    ui.label(RichText::new(*group).strong());
                    for (text, keys) in rows(ui, group) {
                        row(ui, text, &keys);
                    }
                    ui.add_space(10.0);
                }
            }
        });
    });
}

/// The rows of a group: the description of each action and its first shortcut.
fn rows(ui: &Ui, group: &str) -> Vec<(&'static str, String)> {
    let mut rows: Vec<(&str, String)> = Vec::new();
    for shortcut in SHORTCUTS.iter().filter(|shortcut| shortcut.group == group && is_available(shortcut)) {
        if rows.iter().all(|(text, _)| *text != shortcut.text) {
            rows.push((shortcut.text, spelled(ui.ctx(), shortcut.keys)));
        }
    }
    let others = OTHERS.iter().filter(|(of, ..)| *of == group);
    rows.extend(others.map(|(_, text, keys)| (*text, (*keys).to_owned())));
    rows
}

/// Whether this platform has the action of a shortcut.
fn is_available(shortcut: &Shortcut) -> bool {
    CAN_QUIT || !["Quit", FULL_SCREEN].contains(&shortcut.text)
}

/// Gestures and keys that are not a single shortcut.
const OTHERS: &[(&str, &str, &str)] = &[
    ("View", "Panels", "Tab"),
    ("View", "Zoom", "Ctrl + wheel, pinch"),
    ("View", "Pan", "wheel, middle button, Space + drag"),
    ("Edit", "Move by 1 px, by 10 px", "arrows, Shift + arrows"),
    ("Edit", "Copy, cut, paste", "Ctrl+C, Ctrl+X, Ctrl+V"),
    ("Draw", "Circle; steps of 15°", "Shift while dragging"),
    ("Draw", "Copy a mark", "Alt or Ctrl + drag"),
    ("Help", "Menus", "F10, Alt + letter, arrows"),
    ("Help", "Previous, next control", "Shift + Tab, Tab"),
];

fn row(ui: &mut Ui, text: &str, keys: &str) {
    ui.horizontal(|ui| {
        ui.label(text);
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            ui.label(RichText::new(keys).small().weak());
        });
    });
}
