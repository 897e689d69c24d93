//! The list of layers, the highest first; below it, how the active layer grows.

use egui::text::CCursorRange;
use egui::text_edit::TextEditState;
use egui::{
    Align, Align2, Button, Color32, EventFilter, Id, Key, Layout, Modifiers, Rect, Response, RichText, Role,
    ScrollArea, Sense, Stroke, TextEdit, Ui, UiBuilder, WidgetInfo, pos2, vec2,
};

use super::layer_details;
use crate::app::action::Action;
use crate::app::icons::Icon;
use crate::app::shortcuts;
use crate::app::theme::Palette;
use crate::document::Kind;
use crate::editor::edit::Edit;
use crate::editor::layer_action::LayerAction;
use crate::editor::session::Session;

/// Height of a row, points.
const ROW: f32 = 28.0;
/// Rows that are visible at once; more are scrolled.
const ROWS: f32 = 6.0;
/// Longest name that can be typed, characters.
const NAME: usize = 60;

/// What the layer panel remembers from frame to frame.
#[derive(Clone, Debug, Default)]
pub struct LayersPanel {
    /// The layer whose name is being typed, and the name so far.
    pub naming: Option<(usize, String)>,
    /// Whether the settings of the active layer are unfolded.
    pub unfolded: bool,
    /// Whether the row of that layer had the keyboard focus and shall get it back.
    pub from_row: bool,
}

impl LayersPanel {
    /// Another document was opened.
    pub fn forget(&mut self) {
        self.naming = None;
    }
}

/// Shows the list and the settings of the active layer.
pub fn layers(ui: &mut Ui, session: &Session, panel: &mut LayersPanel) -> Vec<Action> {
    let mut actions = Vec::new();
    ui.spacing_mut().item_spacing.y = 4.0;
    ui.horizontal(|ui| {
        ui.strong("Layers");
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| buttons(ui, session, &mut actions));
    });
    if session.document().layers.is_empty() {
        ui.weak("The first mark opens a layer.");
        return actions;
    }
    ScrollArea::vertical().id_salt("layers").max_height(ROWS * ROW).min_scrolled_height(ROWS * ROW).show(
        ui,
        |ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            list(ui, session, panel, &mut actions);
        },
    );
    next(ui, session, &mut actions);
    actions.extend(layer_details::details(ui, session, &mut panel.unfolded));
    actions
}

/// The buttons for the active layer, from right to left.
fn buttons(ui: &mut Ui, session: &Session, actions: &mut Vec<Action>) {
    ui.spacing_mut().item_spacing.x = 0.0;
    for (icon, name, help, action) in [
        (Icon::Bin, "Delete layer", "Deletes the active layer with its marks", LayerAction::Delete),
        (Icon::Copies, "Duplicate layer", "Puts a copy of the active layer above it", LayerAction::Duplicate),
        (
            Icon::Down,
            "Lower layer",
            "Moves the active layer below the next lower one",
            LayerAction::Shift(-1),
        ),
        (Icon::Up, "Raise layer", "Moves the active layer above the next higher one", LayerAction::Shift(1)),
        (Icon::Add, "New layer", "Adds an empty layer above the active one", LayerAction::Add),
    ] {
        ui.add_enabled_ui(session.allows(action), |ui| {
            let action = Action::Layer(action);
            let keys = shortcuts::told(ui.ctx(), &action).map_or(String::new(), |keys| format!(" ({keys})"));
            let button = icon.sized_button(ui, name, false, vec2(27.0, 26.0));
            if button.on_hover_text(format!("{help}{keys}")).clicked() {
                actions.push(action);
            }
        });
    }
}

/// The button that freezes the active layer and goes on with the one above.
fn next(ui: &mut Ui, session: &Session, actions: &mut Vec<Action>) {
    let action = LayerAction::SketchNext;
    let last = session.active_layer + 1 == session.document().layers.len();
    let text = if last { "Freeze it, sketch the next" } else { "Freeze it, go to the next" };
    let help = "Freezes what is drawn so far: it is not changed and not grown again. Its texture is shown under the \
                canvas while you draw the layer above. (F)";
    let size = vec2(ui.available_width(), 26.0);
    let button = ui.add_enabled_ui(session.allows(action), |ui| ui.add_sized(size, Button::new(text))).inner;
    let button = button.on_hover_text(help);
    if button.on_disabled_hover_text("The active layer is empty: draw in it first").clicked() {
        actions.push(Action::Layer(action));
    }
}

fn list(ui: &mut Ui, session: &Session, panel: &mut LayersPanel, actions: &mut Vec<Action>) {
    let layers = session.document().layers.len();
    let top = ui.cursor().top();
    let mut dragged = None;
    for layer in (0..layers).rev() {
        let response = row(ui, session, panel, layer, actions);
        if response.dragged() || response.drag_stopped() {
            dragged = Some((layer, response));
        }
    }
    let Some((from, response)) = dragged else { return };
    let Some(at) = response.interact_pointer_pos().or(ui.input(|input| input.pointer.latest_pos())) else {
        return;
    };
    // The gap nearest to the pointer, counted from the top.
    let gap = (((at.y - top) / ROW).round().max(0.0) as usize).min(layers);
    let above = layers - 1 - from;
    let place = if gap > above { gap - 1 } else { gap };
    let to = layers - 1 - place;
    if response.drag_stopped() {
        if to != from {
            actions.push(Action::Layer(LayerAction::Move(from, to)));
        }
    } else if to != from {
        let accent = Palette::current(ui.visuals()).accent;
        ui.painter().hline(ui.max_rect().x_range(), top + gap as f32 * ROW, Stroke::new(2.0, accent));
    }
}

/// The id of a layer's row.
fn id(ui: &Ui, layer: usize) -> Id {
    ui.scope_id().with(("layer", layer))
}

/// The accessible label of a layer.
fn label(session: &Session, layer: usize) -> String {
    let mut text = format!("Layer {}, {}", session.layer_name(layer), counted(session, layer));
    if layer < session.frozen() {
        text.push_str(", frozen");
    }
    if !session.document().layers[layer].visible {
        text.push_str(", hidden");
    }
    text
}

fn counted(session: &Session, layer: usize) -> String {
    let marks = session.document().layers[layer].strokes.len();
    let many = if marks == 1 { "" } else { "s" };
    match session.kind(layer) {
        None => "empty".to_owned(),
        Some(Kind::Ellipse) => format!("{marks} ellipse{many}"),
        Some(Kind::Line) => format!("{marks} line{many}"),
    }
}

fn row(
    ui: &mut Ui,
    session: &Session,
    panel: &mut LayersPanel,
    layer: usize,
    actions: &mut Vec<Action>,
) -> Response {
    let (_, rect) = ui.allocate_space(vec2(ui.available_width(), ROW));
    let id = id(ui, layer);
    let response = ui.interact(rect, id, Sense::click_and_drag());
    let at_hand = session.active_layer == layer;
    let name = label(session, layer);
    response.widget_info(|| WidgetInfo::selected(Role::Button, true, at_hand, &name));
    back(ui, &response, at_hand);
    let [eye, rest] = [pos2(rect.left() + 26.0, rect.bottom()), pos2(rect.left() + 28.0, rect.top())];
    let eye = Rect::from_min_max(pos2(rect.left() + 4.0, rect.top()), eye);
    let rest = Rect::from_min_max(rest, pos2(rect.right() - 6.0, rect.bottom()));
    ui.scope_builder(UiBuilder::new().max_rect(eye), |ui| shown(ui, session, layer, actions));
    let count = mark_count(ui, session, layer, rest);
    let left = thaw(ui, session, layer, rest.with_max_x(count), actions);
    let named = rest.with_max_x(left).with_min_x(rest.left() + 22.0);
    if panel.naming.as_ref().is_some_and(|(named, _)| *named == layer) {
        naming(ui, session, panel, named, actions);
        return response;
    }
    let colour = if session.document().layers[layer].visible {
        ui.visuals().text_color()
    } else {
        ui.visuals().weak_text_color()
    };
    let mut text = RichText::new(session.layer_name(layer)).color(colour);
    if at_hand {
        text = text.strong();
    }
    let label = egui::Label::new(text).truncate().selectable(false).sense(Sense::hover());
    ui.scope_builder(
        UiBuilder::new().max_rect(named).layout(Layout::left_to_right(Align::Center)).sense(Sense::hover()),
        |ui| ui.add(label),
    );
    let response = response.on_hover_ui(|ui| {
        ui.strong(session.layer_name(layer));
        ui.label(counted(session, layer));
        ui.weak("Click: draw in this layer. Double-click or F2: rename it. Drag, or Alt + arrows: move it.");
    });
    if response.double_clicked() {
        actions.extend([LayerAction::Take(layer), LayerAction::Rename].map(Action::Layer));
    } else if response.clicked() {
        actions.push(Action::Layer(LayerAction::Take(layer)));
    }
    if response.has_focus() {
        keys(ui, session, panel, &response, layer, actions);
    }
    response
}

/// The background of a row: marked where it is active, framed where it has the keyboard focus.
fn back(ui: &Ui, response: &Response, at_hand: bool) {
    let colours = Palette::current(ui.visuals());
    let widgets = &ui.visuals().widgets;
    let fill = if at_hand {
        widgets.inactive.weak_bg_fill
    } else if response.hovered() {
        ui.visuals().faint_bg_color
    } else {
        Color32::TRANSPARENT
    };
    ui.painter().rect_filled(response.rect, 5.0, fill);
    if at_hand {
        let bar = response.rect.shrink2(vec2(0.0, 5.0));
        ui.painter().rect_filled(bar.with_max_x(bar.left() + 3.0), 1.5, colours.accent);
    }
    if response.has_focus() {
        let stroke = Stroke::new(1.0, colours.accent);
        ui.painter().rect_stroke(response.rect, 5.0, stroke, egui::StrokeKind::Inside);
    }
}

/// The button that hides a layer, or shows it.
fn shown(ui: &mut Ui, session: &Session, layer: usize, actions: &mut Vec<Action>) {
    let visible = session.document().layers[layer].visible;
    let (icon, verb) = if visible { (Icon::Eye, "Hide") } else { (Icon::Shut, "Show") };
    let name = format!("{verb} {}", session.layer_name(layer));
    let help = if visible {
        "Hides it: it still grows and keeps its space free of the others, but it is not painted"
    } else {
        "Hidden: it grows and keeps its space free of the others, but it is not painted. Click to show it"
    };
    if icon.sized_button(ui, &name, false, vec2(22.0, ROW)).on_hover_text(help).clicked() {
        actions.push(Action::Layer(LayerAction::HideThis(layer)));
    }
}

/// Shows how many marks a layer has, and of what kind; gives the left end of the number.
fn mark_count(ui: &Ui, session: &Session, layer: usize, rest: Rect) -> f32 {
    let colours = Palette::current(ui.visuals());
    let middle = pos2(rest.left() + 10.0, rest.center().y);
    let icon = Rect::from_center_size(middle, vec2(16.0, 16.0));
    match session.kind(layer) {
        Some(Kind::Ellipse) => Icon::Ellipse.paint(ui.painter(), icon, colours.ink(layer)),
        Some(Kind::Line) => Icon::Line.paint(ui.painter(), icon, colours.ink(layer)),
        None => {
            ui.painter().circle_stroke(middle, 3.0, Stroke::new(1.0, ui.visuals().weak_text_color()));
        }
    }
    let text = match session.document().layers[layer].strokes.len() {
        0 => "empty".to_owned(),
        marks => marks.to_string(),
    };
    let font = egui::TextStyle::Small.resolve(ui.style());
    let weak = ui.visuals().weak_text_color();
    let right = pos2(rest.right(), rest.center().y);
    ui.painter().text(right, Align2::RIGHT_CENTER, text, font, weak).left() - 6.0
}

/// The button that thaws a frozen layer; gives its left end.
fn thaw(ui: &mut Ui, session: &Session, layer: usize, rest: Rect, actions: &mut Vec<Action>) -> f32 {
    if layer >= session.frozen() {
        return rest.right();
    }
    let place = rest.with_min_x(rest.right() - 22.0);
    ui.scope_builder(UiBuilder::new().max_rect(place), |ui| {
        let name = format!("Thaw {}", session.layer_name(layer));
        let help = "Frozen: its marks cannot be changed. Click to make it active again; the layers above are thawed as well";
        let button = Icon::Frozen.sized_button(ui, &name, false, vec2(22.0, ROW));
        if button.on_hover_text(help).clicked() {
            actions.push(Action::Layer(LayerAction::Take(layer)));
        }
    });
    place.left()
}

/// The field in which a name is typed. Enter, Tab and a click elsewhere accept it, Escape does not.
fn naming(ui: &mut Ui, session: &Session, panel: &mut LayersPanel, place: Rect, actions: &mut Vec<Action>) {
    let Some((layer, mut name)) = panel.naming.take() else { return };
    let field = ui.scope_id().with("name of layer");
    let edit = TextEdit::singleline(&mut name)
        .id(field)
        .char_limit(NAME)
        .hint_text(session.layer_name(layer))
        .margin(vec2(4.0, 3.0));
    let response = ui.put(place.shrink2(vec2(0.0, 2.0)), edit).accessible_name("Layer name");
    let [enter, tab] = [Key::Enter, Key::Tab].map(|key| ui.input(|input| input.key_pressed(key)));
    if response.lost_focus() {
        if enter || tab || ui.input(|input| input.pointer.any_down()) {
            let name = name.trim().to_owned();
            actions.push(Action::Edit(Edit::LayerName(layer, name)));
        }
        if std::mem::take(&mut panel.from_row) && !tab {
            ui.memory_mut(|memory| memory.request_focus(id(ui, layer)));
        }
        return;
    }
    if !response.has_focus() {
        response.request_focus();
        let mut state = TextEditState::load(ui.ctx(), field).unwrap_or_default();
        state.cursor.set_char_range(Some(CCursorRange::select_all_str(&name)));
        state.store(ui.ctx(), field);
    }
    panel.naming = Some((layer, name));
}

/// The keys of the row that has the keyboard focus.
fn keys(
    ui: &Ui,
    session: &Session,
    panel: &mut LayersPanel,
    response: &Response,
    layer: usize,
    actions: &mut Vec<Action>,
) {
    let filter = EventFilter { tab: false, horizontal_arrows: false, vertical_arrows: true, escape: false };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
    let pressed = |modifiers, key| ui.input_mut(|input| input.consume_key(modifiers, key));
    let layers = session.document().layers.len();
    for (key, by) in [(Key::ArrowUp, 1), (Key::ArrowDown, -1)] {
        let Some(to) = layer.checked_add_signed(by).filter(|to| *to < layers) else { continue };
        if pressed(Modifiers::ALT, key) {
            actions.push(Action::Layer(LayerAction::Move(layer, to)));
        } else if pressed(Modifiers::NONE, key) {
            actions.push(Action::Layer(LayerAction::Take(to)));
        } else {
            continue;
        }
        ui.memory_mut(|memory| memory.request_focus(id(ui, to)));
        return;
    }
    for (key, action) in [(Key::F2, LayerAction::Rename), (Key::Delete, LayerAction::Delete)] {
        if pressed(Modifiers::NONE, key) {
            actions.extend([LayerAction::Take(layer), action].map(Action::Layer));
            panel.from_row = true;
        }
    }
}
