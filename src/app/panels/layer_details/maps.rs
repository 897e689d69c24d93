//! Variation over the canvas by noise or by a picture: a row for each attribute that can vary.

use egui::{CollapsingHeader, ComboBox, DragValue, Grid, Response, Ui, vec2};

use super::{CONTROL, fields};
use crate::app::action::Action;
use crate::app::fields::reset;
use crate::app::units::number_field;
use crate::document::limits::{self, Range};
use crate::document::{Layer, LayerMap, LayerMaps, MapChange, MapKey, MapSource};
use crate::editor::edit::Edit;
use crate::editor::layer_choices::has_map;
use crate::editor::picture_use::PictureUse;
use crate::editor::session::Session;

const NONE: &str = "No";
const NOISE: &str = "By noise";
const PICTURE: &str = "By a picture…";

/// The rows of the active layer; folded unless an attribute varies.
pub(super) fn rows(ui: &mut Ui, session: &Session, layer: &Layer) -> Vec<Action> {
    let kind = session.kind(session.active_layer);
    let keys: Vec<MapKey> = MapKey::ALL.into_iter().filter(|key| has_map(layer, kind, *key)).collect();
    if keys.is_empty() {
        return Vec::new();
    }
    let mut actions = Vec::new();
    let mut maps = layer.maps.clone();
    let header =
        CollapsingHeader::new("Varies over the canvas").id_salt("maps").default_open(!maps.is_empty());
    // Not indented: the reset buttons would lie under the scroll bar.
    let shown = header.show_unindented(ui, |ui| {
        Grid::new("maps").num_columns(3).min_col_width(0.0).spacing(vec2(7.0, 5.0)).show(ui, |ui| {
            for key in keys {
                actions.extend(row(ui, &mut maps, key));
            }
        });
    });
    shown.header_response.on_hover_text(
        "Noise or a gray picture changes the texture from place to place: sizes, distances, directions, colours",
    );
    if maps != layer.maps {
        actions.push(Action::Edit(Edit::LayerMaps(session.active_layer, Box::new(maps))));
    }
    actions
}

/// The name of the attribute in the window.
fn title(key: MapKey) -> &'static str {
    match key {
        MapKey::Area => "Size",
        MapKey::Spacing => "Distance",
        MapKey::Direction => "Direction",
        MapKey::Aspect => "Roundness",
        MapKey::Duty => "Width",
        MapKey::Colour => "Colour",
        MapKey::Growth => "Growth",
        MapKey::Ground => "Ground",
    }
}

/// What varies, in one sentence.
fn help(key: MapKey) -> &'static str {
    match key {
        MapKey::Area => "The area of the marks; in a field of points, also the share that is dark",
        MapKey::Spacing => {
            "The distance between marks or points; for stripes and threads, the distance from one to the \
             next, together with their width"
        }
        MapKey::Direction => "The direction of the marks",
        MapKey::Aspect => "Minor ÷ major radius of the marks: 1 is round",
        MapKey::Duty => "The width of stripes or threads, as a share of the distance from one to the next",
        MapKey::Colour => {
            "The place in the gradient: ground and marks get other colours, their edges do not move"
        }
        MapKey::Growth => "The growth of Turing's system: 18 grows dots, 20 worms, 25 holes",
        MapKey::Ground => {
            "The share of the second colour of the ground, such as that of a pale belly. The tab Colour has that colour"
        }
    }
}

/// The rows about one attribute.
fn row(ui: &mut Ui, maps: &mut LayerMaps, key: MapKey) -> Option<Action> {
    let mut asked = false;
    ui.label(title(key)).on_hover_text(help(key));
    source(ui, maps, key, &mut asked);
    if reset(ui, &format!("{} map", title(key)), maps.get(key).is_none()) {
        maps.set(key, None);
    }
    ui.end_row();
    if let Some(mut map) = maps.get(key).cloned() {
        numbers(ui, &mut map, key);
        maps.set(key, Some(map));
    }
    asked.then_some(Action::ChoosePicture(PictureUse::Map(key)))
}

/// The source of the variation of an attribute.
fn source(ui: &mut Ui, maps: &mut LayerMaps, key: MapKey, asked: &mut bool) {
    let now = match maps.get(key).map(|map| &map.source) {
        None => NONE,
        Some(MapSource::Noise { .. }) => NOISE,
        Some(MapSource::Image { .. }) => PICTURE,
    };
    let combo = ComboBox::from_id_salt(("map", key.name())).selected_text(now).width(CONTROL).truncate();
    let combo = combo.show_ui(ui, |ui| {
        if ui.selectable_label(now == NONE, NONE).clicked() {
            maps.set(key, None);
        }
        if ui.selectable_label(now == NOISE, NOISE).clicked() && now != NOISE {
            maps.set(key, Some(LayerMap::noise(key)));
        }
        *asked = ui.selectable_label(now == PICTURE, PICTURE).clicked();
    });
    combo.response.accessible_name(format!("{} varies", title(key))).on_hover_text(help(key));
}

/// A row of a map: its name, and a control.
fn number(ui: &mut Ui, name: &str, help: &str, control: impl FnOnce(&mut Ui) -> Response) {
    ui.weak(format!("  {name}")).on_hover_text(help);
    control(ui).on_hover_text(help);
    ui.end_row();
}

/// The unit that is written behind the numbers of a range.
fn unit(key: MapKey, change: MapChange) -> &'static str {
    match (change, key) {
        (MapChange::Multiply, _) => " ×",
        (_, MapKey::Direction) => "°",
        (MapChange::Replace, MapKey::Area) => " px²",
        (MapChange::Replace, MapKey::Spacing) => " px",
        (MapChange::Replace | MapChange::Add, _) => "",
    }
}

/// The numbers of a map.
fn numbers(ui: &mut Ui, map: &mut LayerMap, key: MapKey) {
    let title = title(key);
    match &mut map.source {
        MapSource::Noise { size, octaves } => {
            number(ui, "noise size", "Distance from a light place of the noise to the next dark one", |ui| {
                let Range { low, high, .. } = limits::MAP_SIZE;
                let field = DragValue::new(size).range(low..=high).speed(1.0).max_decimals(0);
                ui.add(number_field(field, " px")).accessible_name(format!("{title}, noise size"))
            });
            let help = "Number of layers of noise: each further one has half the size and half the weight, \
                        and adds finer detail";
            number(ui, "octaves", help, |ui| {
                fields::whole(ui, &format!("{title}, octaves"), octaves, [1, limits::MAP_OCTAVES])
            });
        }
        // The picture is the share itself.
        MapSource::Image { .. } if key == MapKey::Ground => {}
        MapSource::Image { factor, .. } => {
            let before = *factor;
            let help = "On: the picture changes the values of the drawn marks. Off: it replaces them";
            number(ui, "changes it", help, |ui| {
                ui.checkbox(factor, "").accessible_name(format!("{title}, changes what is drawn"))
            });
            if *factor != before {
                map.range = key.usual(map.change(key));
            }
        }
    }
    let change = map.change(key);
    let help = match change {
        MapChange::Replace => "The value where the picture is black, and where it is white",
        MapChange::Multiply => {
            "The factor where the noise or the picture is darkest, and where it is lightest"
        }
        MapChange::Add => {
            "What is added where the noise or the picture is darkest, and where it is lightest: degrees to a \
             direction, a shift to the place in the gradient"
        }
    };
    number(ui, "from, to", help, |ui| {
        fields::two(ui, &format!("{title}, from"), &mut map.range, |ui, name, value| {
            let Range { low, high, .. } = key.allowed(change);
            let (speed, decimals) = if high - low > 50.0 { (1.0, 0) } else { (0.01, 2) };
            let field = DragValue::new(value).range(low..=high).speed(speed).max_decimals(decimals);
            ui.add(number_field(field, unit(key, change))).accessible_name(name)
        })
    });
}
