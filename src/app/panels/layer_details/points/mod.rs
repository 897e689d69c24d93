//! What a field of points is made of: one row each.

mod labels;

use egui::{ComboBox, Response, Ui};

use super::fields::row;
use super::{CONTROL, LIST, fields, share};
use crate::app::action::Action;
use crate::document::{Interpolation, Labels, Points, Progression, Towards, limits};
use crate::editor::edit::Edit;
use crate::editor::picture_use::PictureUse;
use crate::editor::session::Session;

/// The rows of the active layer, a field of these `points`.
pub(super) fn rows(ui: &mut Ui, session: &Session, before: &Points) -> Vec<Action> {
    let mut points = before.clone();
    let mut actions = Vec::new();
    let is_drawn = session.kind(session.active_layer).is_some();
    actions.extend(labels::labels(ui, &mut points.labels));
    distance(ui, session, is_drawn, &mut points.distance);
    if varies(&points) {
        actions.extend(progression(ui, &mut points.progression));
    }
    let help = "Number of sets of points: each further one has half the distance and half the weight, and \
                adds finer detail";
    whole(ui, "Octaves", help, &mut points.octaves, 1, [1, limits::POINT_OCTAVES]);
    fold(ui, &mut points.fold);
    interpolation(ui, &mut points.interpolation);
    weights(ui, &mut points);
    if points.has_level() {
        level(ui, is_drawn, &mut points.share);
    } else {
        points.share = None;
    }
    if points != *before {
        actions.push(Action::Edit(Edit::LayerPoints(session.active_layer, points)));
    }
    actions
}

/// The row of a whole number.
fn whole(ui: &mut Ui, name: &str, help: &str, value: &mut u32, default: u32, range: [u32; 2]) {
    if row(ui, name, help, *value == default, |ui| fields::whole(ui, name, value, range)) {
        *value = default;
    }
}

/// The row of two numbers.
fn between<T: Copy + PartialEq>(
    ui: &mut Ui,
    name: &str,
    help: &str,
    values: &mut [T; 2],
    default: [T; 2],
    control: fn(&mut Ui, &str, &mut [T; 2]) -> Response,
) {
    if row(ui, name, help, *values == default, |ui| control(ui, name, values)) {
        *values = default;
    }
}

/// Whether distances or probabilities change along the canvas.
fn varies(points: &Points) -> bool {
    let distances = points.distance.is_some_and(|[first, last]| first != last);
    distances || matches!(points.labels, Labels::Random { dark: [first, last] } if first != last)
}

fn distance(ui: &mut Ui, session: &Session, is_drawn: bool, distance: &mut Option<[f64; 2]>) {
    let name = "Distance";
    let help = "The least distance between two points; the two numbers are for the two ends of the canvas. As \
                drawn: the distance of the drawn ellipses";
    let longer = session.document().size.into_iter().max().map_or(0.0, f64::from);
    let begin = (longer / Points::ACROSS).round().max(limits::POINT_DISTANCE.low);
    let is_default = distance.is_none();
    let control = |ui: &mut Ui| match distance {
        None => automatic(ui, name, is_drawn, distance, [begin; 2]),
        Some(given) => fields::two(ui, name, given, fields::px),
    };
    if row(ui, name, help, is_default, control) {
        *distance = None;
    }
}

/// The box that is ticked where a value follows the drawn marks, or is chosen by dapple where there are none.
fn automatic<T>(ui: &mut Ui, name: &str, is_drawn: bool, value: &mut Option<T>, begin: T) -> Response {
    let mut ticked = value.is_none();
    let text = if is_drawn { "as drawn" } else { "automatic" };
    let field = ui.checkbox(&mut ticked, text).accessible_name(format!("{name} {text}"));
    if field.changed() {
        *value = (!ticked).then_some(begin);
    }
    field
}

fn progression(ui: &mut Ui, progression: &mut Progression) -> Option<Action> {
    const PICTURE: &str = "By a picture…";
    const ALONG: [(&str, Progression); 3] =
        [("Across", Progression::Across), ("Down", Progression::Down), ("Outward", Progression::Outward)];
    let help = "The way along which the first number changes into the second: from left to right, from top to \
                bottom, from the middle to the corners, or from black to white of a picture";
    let mut asked = false;
    let default = *progression == Progression::Across;
    let control = |ui: &mut Ui| {
        let now = ALONG.iter().find(|(_, along)| along == progression).map_or(PICTURE, |(name, _)| name);
        let combo = ComboBox::from_id_salt("progression").selected_text(now).width(CONTROL).truncate();
        let combo = combo.show_ui(ui, |ui| {
            for (name, along) in ALONG {
                if ui.selectable_label(now == name, name).clicked() {
                    *progression = along;
                }
            }
            asked = ui.selectable_label(now == PICTURE, PICTURE).clicked();
        });
        combo.response.accessible_name("Along")
    };
    if row(ui, "Along", help, default, control) {
        *progression = Progression::Across;
    }
    asked.then_some(Action::ChoosePicture(PictureUse::PointProgression))
}

fn fold(ui: &mut Ui, fold: &mut bool) {
    let help = "Values above the middle gray are mirrored at it: this makes dark creases, as in marble";
    if row(ui, "Fold", help, !*fold, |ui| ui.checkbox(fold, "").accessible_name("Fold")) {
        *fold = false;
    }
}

fn interpolation(ui: &mut Ui, interpolation: &mut Interpolation) {
    const READ: [(&str, Interpolation); 2] =
        [("Smooth", Interpolation::Smooth), ("Sharp", Interpolation::Nearest)];
    let help = "Between points. Smooth: a mixture of the values of the points around. Sharp: one cell around \
                each point, with sharp borders";
    let default = *interpolation == Interpolation::Smooth;
    let control = |ui: &mut Ui| {
        let now = READ.iter().find(|(_, one)| one == interpolation).map_or("", |(name, _)| name);
        let combo = ComboBox::from_id_salt("interpolation").selected_text(now).width(CONTROL).truncate();
        let combo = combo.show_ui(ui, |ui| {
            for (name, one) in READ {
                ui.selectable_value(interpolation, one, name);
            }
        });
        combo.response.accessible_name("Borders")
    };
    if row(ui, "Borders", help, default, control) {
        *interpolation = Interpolation::Smooth;
    }
}

/// The rows about how far the weight of a point reaches, and to which side it leans.
fn weights(ui: &mut Ui, points: &mut Points) {
    let default = Points::default();
    let help =
        "How far the value of a point reaches, in distances between neighbours: the farther, the smoother";
    let is_default = points.axis == default.axis;
    let control = |ui: &mut Ui| fields::number(ui, "Reach", &mut points.axis, &limits::AXIS);
    if row(ui, "Reach", help, is_default, control) {
        points.axis = default.axis;
    }
    let help = "How far points reach to one side more than to the other: this bends the borders between them";
    let is_default = points.shift == default.shift;
    let control = |ui: &mut Ui| fields::number(ui, "Lean", &mut points.shift, &limits::SHIFT);
    if row(ui, "Lean", help, is_default, control) {
        points.shift = default.shift;
    }
    if points.shift > 0.0 {
        towards(ui, &mut points.towards);
    }
}

fn towards(ui: &mut Ui, towards: &mut Towards) {
    /// The angle that is set first, degrees.
    const ANGLE: f64 = 0.0;
    let help =
        "The side to which points lean: each to a random side, all away from the middle, or all at an angle";
    let default = *towards == Towards::Random;
    let control = |ui: &mut Ui| {
        let now = match towards {
            Towards::Random => "Random sides",
            Towards::Outward => "Outward",
            Towards::Angle(_) => "An angle",
        };
        let combo = ComboBox::from_id_salt("towards").selected_text(now).width(CONTROL).truncate();
        let combo = combo.show_ui(ui, |ui| {
            ui.selectable_value(towards, Towards::Random, "Random sides");
            ui.selectable_value(towards, Towards::Outward, "Outward");
            if ui.selectable_label(now == "An angle", "An angle").clicked() {
                *towards = Towards::Angle(ANGLE);
            }
        });
        combo.response.accessible_name("Towards")
    };
    if row(ui, "Towards", help, default, control) {
        *towards = Towards::Random;
    }
    if let Towards::Angle(angle) = towards {
        let (name, help) = ("Angle", "0° is to the right, 90° is down");
        let is_default = angle.to_bits() == ANGLE.to_bits();
        if row(ui, name, help, is_default, |ui| fields::degrees(ui, name, angle)) {
            *angle = ANGLE;
        }
    }
}

fn level(ui: &mut Ui, is_drawn: bool, value: &mut Option<f64>) {
    /// The value that the field begins with.
    const BEGIN: f64 = 0.5;
    let name = "Dark area";
    let help = "The share of the canvas that is dark. Automatic: the share that follows from the values of \
                the points. As drawn: the share that the drawn ellipses cover";
    let is_default = value.is_none();
    let control = |ui: &mut Ui| match value {
        None => automatic(ui, name, is_drawn, value, BEGIN),
        Some(given) => share(ui, name, given, &limits::POINT_SHARE),
    };
    if row(ui, name, help, is_default, control) {
        *value = None;
    }
}
