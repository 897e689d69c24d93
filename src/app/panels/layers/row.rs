//! One row of the list of layers.

use egui::{
    Align, Align2, Color32, EventFilter, Key, Layout, Modifiers, Rect, Response, RichText, Role, Sense,
    Stroke, Ui, UiBuilder, WidgetInfo, pos2, vec2,
};

use super::menu::layer_menu;
use super::name_field::name_field;
use super::{LayersPanel, ROW, row_id};
use crate::app::action::Action;
use crate::app::icons::Icon;
use crate::app::theme::Palette;
use crate::document::{Kind, Layer};
use crate::editor::layer_action::LayerAction;
use crate::editor::session::Session;

pub(super) fn row(
    ui: &mut Ui,
    session: &Session,
    panel: &mut LayersPanel,
    layer: usize,
    actions: &mut Vec<Action>,
) -> Response {
    let (_, rect) = ui.allocate_space(vec2(ui.available_width(), ROW));
    let id = row_id(ui, layer);
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
    let left = unfreeze(ui, session, layer, rest.with_max_x(count), actions);
    let named = rest.with_max_x(left).with_min_x(rest.left() + 22.0);
    if panel.naming.as_ref().is_some_and(|(named, _)| *named == layer) {
        name_field(ui, session, panel, named, actions);
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
    layer_menu(&response, session, layer, actions);
    if response.double_clicked() {
        actions.extend([LayerAction::Select(layer), LayerAction::Rename].map(Action::Layer));
    } else if response.clicked() {
        actions.push(Action::Layer(LayerAction::Select(layer)));
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
        "Hide it. It still grows and keeps its space, but it is not painted"
    } else {
        "Hidden: it grows and keeps its space, but it is not painted. Click to show it"
    };
    if icon.sized_button(ui, &name, false, vec2(22.0, ROW)).on_hover_text(help).clicked() {
        actions.push(Action::Layer(LayerAction::HideThis(layer)));
    }
}

/// Shows how many marks a layer has, and of what kind; returns the x of the left end of the number.
fn mark_count(ui: &Ui, session: &Session, layer: usize, rest: Rect) -> f32 {
    let colours = Palette::current(ui.visuals());
    let center = pos2(rest.left() + 10.0, rest.center().y);
    let icon = Rect::from_center_size(center, vec2(16.0, 16.0));
    match session.kind(layer) {
        Some(Kind::Ellipse) => Icon::Ellipse.paint(ui.painter(), icon, colours.ink(layer)),
        Some(Kind::Line) => Icon::Line.paint(ui.painter(), icon, colours.ink(layer)),
        None => {
            ui.painter().circle_stroke(center, 3.0, Stroke::new(1.0, ui.visuals().weak_text_color()));
        }
    }
    let text = match session.document().layers[layer].strokes.len() {
        0 => unmarked(&session.document().layers[layer]).to_owned(),
        marks => marks.to_string(),
    };
    let font = egui::TextStyle::Small.resolve(ui.style());
    let weak = ui.visuals().weak_text_color();
    let right = pos2(rest.right(), rest.center().y);
    ui.painter().text(right, Align2::RIGHT_CENTER, text, font, weak).left() - 6.0
}

/// The button that unfreezes a layer; gives its left end.
fn unfreeze(ui: &mut Ui, session: &Session, layer: usize, rest: Rect, actions: &mut Vec<Action>) -> f32 {
    if layer >= session.frozen() {
        return rest.right();
    }
    let place = rest.with_min_x(rest.right() - 22.0);
    ui.scope_builder(UiBuilder::new().max_rect(place), |ui| {
        let name = format!("Unfreeze {}", session.layer_name(layer));
        let help = "Frozen: its marks cannot be changed. Click to unfreeze it and the layers above it";
        let button = Icon::Frozen.sized_button(ui, &name, false, vec2(22.0, ROW));
        if button.on_hover_text(help).clicked() {
            actions.push(Action::Layer(LayerAction::UnfreezeThis(layer)));
        }
    });
    place.left()
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
    let [one, many] = session.closed_strokes(layer);
    let kinds: Vec<Kind> = session.marks_of(layer).iter().map(Kind::from).collect();
    let counted =
        [Kind::Ellipse, Kind::Line].map(|kind| (kind, kinds.iter().filter(|of| **of == kind).count()));
    let named =
        counted.into_iter().filter(|(_, count)| *count > 0).map(|(kind, count)| match (kind, count) {
            (Kind::Ellipse, 1) => format!("1 {}", one.split_once(' ').map_or(one, |(_, name)| name)),
            (Kind::Ellipse, _) => format!("{count} {many}"),
            (_, 1) => format!("1 {}", kind.name()),
            _ => format!("{count} {}s", kind.name()),
        });
    let named: Vec<String> = named.collect();
    if named.is_empty() { unmarked(&session.document().layers[layer]).to_owned() } else { named.join(", ") }
}

/// The text for a layer without marks.
fn unmarked(layer: &Layer) -> &'static str {
    match layer {
        Layer { tone: Some(_), .. } => "a picture",
        layer if layer.is_blank() => "empty",
        _ => "points",
    }
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
            actions.push(Action::Layer(LayerAction::Select(to)));
        } else {
            continue;
        }
        ui.memory_mut(|memory| memory.request_focus(row_id(ui, to)));
        return;
    }
    for (key, action) in [(Key::F2, LayerAction::Rename), (Key::Delete, LayerAction::Delete)] {
        if pressed(Modifiers::NONE, key) {
            actions.extend([LayerAction::Select(layer), action].map(Action::Layer));
            panel.from_row = true;
        }
    }
}
