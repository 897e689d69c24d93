//! How the active layer grows: how it meets the layers beneath, its system, its options.

mod fields;
mod maps;
mod options;
mod points;
mod rosette;
pub mod small_picture;
mod spread;
mod tone;

use egui::{
    Align, Button, ComboBox, DragValue, Grid, Image, Label, Layout, Rect, RichText, ScrollArea,
    TextureHandle, Ui, pos2, vec2,
};

use super::meets;
use crate::app::action::Action;
use crate::app::assets;
use crate::app::fields::reset;
use crate::app::icons::Icon;
use crate::app::units::number_field;
use crate::document::limits::Range;
use crate::document::{After, Layer, LayerOptions, OptionKey, SystemChoice};
use crate::editor::edit::Edit;
use crate::editor::layer_choices::{after_refusal, has_option, system_refusal};
use crate::editor::session::Session;

/// The largest share of the window's height that the details take; more is scrolled.
const SHARE: f32 = 0.32;
/// Width of the controls, points: leaves room for the reset button and a scroll bar on the right.
const CONTROL: f32 = 110.0;
/// Width of the list of systems, points.
const SYSTEM: f32 = 138.0;
/// The largest height of that list, points; more is scrolled.
const LIST: f32 = 540.0;

/// Shows the details, or only their summary where they are not `unfolded`.
pub fn details(ui: &mut Ui, session: &Session, unfolded: &mut bool) -> Vec<Action> {
    let mut actions = Vec::new();
    let Some(layer) = session.document().layers.get(session.active_layer) else { return Vec::new() };
    ui.horizontal(|ui| {
        let button = Button::new(RichText::new("How it grows").strong()).frame_when_inactive(false);
        let button = button.left_text(RichText::new("     ")).min_size(vec2(112.0, 24.0));
        let fold = ui.add(button).accessible_name("How it grows");
        let icon = if *unfolded { Icon::Unfolded } else { Icon::Folded };
        let place = pos2(fold.rect.left() + 10.0, fold.rect.center().y);
        let colour = ui.style().interact(&fold).text_color();
        icon.paint(ui.painter(), Rect::from_center_size(place, vec2(16.0, 16.0)), colour);
        if fold
            .on_hover_text(
                "Where the active layer grows relative to the layers beneath, its system, its options",
            )
            .clicked()
        {
            *unfolded = !*unfolded;
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            ui.add(Label::new(RichText::new(summary(session, layer)).small().weak()).truncate());
        });
    });
    if !*unfolded {
        return Vec::new();
    }
    let highest = (SHARE * ui.content_rect().height()).round();
    let area = ScrollArea::vertical().id_salt("details").max_height(highest).min_scrolled_height(highest);
    area.show(ui, |ui| {
        ui.spacing_mut().item_spacing.y = 6.0;
        if session.is_active_frozen() {
            ui.weak("Frozen: click the snowflake to change it.");
            ui.disable();
        }
        actions.extend(meeting(ui, session, layer).map(Action::Edit));
        actions.extend(ui.horizontal(|ui| system(ui, session, layer)).inner.map(Action::Edit));
        Grid::new("how it grows").num_columns(3).min_col_width(0.0).spacing(vec2(7.0, 5.0)).show(ui, |ui| {
            let kind = session.kind(session.active_layer);
            for choice in OptionKey::ALL {
                if has_option(layer, kind, choice) {
                    actions.extend(options::option(ui, session, layer, choice).map(Action::Edit));
                }
            }
            if let Some(points) = layer.point_field() {
                actions.extend(points::rows(ui, session, &points));
            }
            actions.extend(tone::rows(ui, session, layer));
        });
        actions.extend(maps::rows(ui, session, layer));
        if layer.point_field().is_none() && !layer.is_driven() && session.kind(session.active_layer).is_none()
        {
            ui.weak("Draw a mark to see its options.");
        }
    });
    actions
}

/// A summary of the settings in a few words: where the marks grow, unless this is the lowest layer; the system; whether
/// options differ from their defaults.
fn summary(session: &Session, layer: &Layer) -> String {
    let place = match session.beneath(session.active_layer) {
        None => String::new(),
        Some(_) => format!("{}, ", layer.after.name()),
    };
    let system = if layer.system == SystemChoice::Auto { "automatic" } else { layer.system.title() };
    let options = if layer.options == LayerOptions::default() { "" } else { ", changed options" };
    format!("{place}{system}{options}")
}

/// Where the marks grow relative to those beneath: a button with a picture for each choice.
fn meeting(ui: &mut Ui, session: &Session, layer: &Layer) -> Option<Edit> {
    let mut edit = None;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        let lowest = session.beneath(session.active_layer).is_none();
        for (_, after) in After::NAMES {
            let refused = after_refusal(session, session.active_layer, after);
            let chosen = if lowest { after == After::Between } else { layer.after == after };
            if meets::button(ui, after, chosen, refused).clicked() {
                edit = Some(Edit::LayerAfter(session.active_layer, after));
            }
        }
    });
    edit
}

/// A row of a list: a small picture of what the choice grows, and its label.
fn picture_row(ui: &mut Ui, picture: Option<TextureHandle>, label: &str, chosen: bool) -> egui::Response {
    match picture {
        Some(texture) => {
            let picture = Image::new(&texture).fit_to_exact_size(small_picture::SIZE);
            ui.add(Button::selectable(chosen, (picture, label)))
        }
        None => ui.selectable_label(chosen, label),
    }
}

fn system(ui: &mut Ui, session: &Session, layer: &Layer) -> Option<Edit> {
    let help = "The kind of growth that makes the marks of this layer";
    ui.label("System").on_hover_text(help);
    let mut chosen = layer.system;
    let combo =
        ComboBox::from_id_salt("system").selected_text(chosen.title()).width(SYSTEM).height(LIST).truncate();
    let combo = combo.show_ui(ui, |ui| {
        for (name, system) in SystemChoice::names() {
            let refused = system_refusal(session, session.active_layer, system);
            ui.add_enabled_ui(refused.is_none(), |ui| {
                let picture = (system != SystemChoice::Auto)
                    .then(|| small_picture::of_system(name, system.picture()))
                    .and_then(|asset| assets::texture(ui.ctx(), asset));
                let row = picture_row(ui, picture, system.title(), chosen == system);
                if row.clicked() {
                    chosen = system;
                }
                row.on_hover_text(system.help()).on_disabled_hover_text(refused.unwrap_or_default());
            });
        }
    });
    combo.response.accessible_name("System").on_hover_text(layer.system.help());
    if reset(ui, "System", layer.system == SystemChoice::Auto) {
        chosen = SystemChoice::Auto;
    }
    (chosen != layer.system).then_some(Edit::LayerSystem(session.active_layer, chosen))
}

/// A field for a share 0..1, shown in per cent.
fn share(ui: &mut Ui, name: &str, value: &mut f64, range: &Range) -> egui::Response {
    let mut percent = 100.0 * *value;
    let field = DragValue::new(&mut percent)
        .range(100.0 * range.low..=100.0 * range.high)
        .speed(0.25)
        .max_decimals(0);
    let field = ui.add(number_field(field, " %")).accessible_name(name);
    if field.changed() {
        // Rounded to a tenth of a per cent, so that documents hold short numbers.
        *value = ((10.0 * percent).round() / 1000.0).clamp(range.low, range.high);
    }
    field
}
