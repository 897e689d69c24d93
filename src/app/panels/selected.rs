//! The selected marks: their numbers, and buttons to duplicate or delete them.

use egui::{Button, DragValue, RichText, Ui};

use super::form::{presets, rows};
use super::typed_rows::typed_rows;
use crate::app::action::Action;
use crate::app::units::number_field;
use crate::document::AreaKind;
use crate::editor::edit::Edit;
use crate::editor::selection::Place;
use crate::editor::session::Session;
use crate::editor::shape;
use crate::editor::typed;
use crate::editor::units::Ruler;
use crate::marks::{Ellipse, Line, Mark, Path};

/// Shows them. A number that is changed gives the marks that replace the selected ones.
pub fn selected(ui: &mut Ui, session: &Session, ruler: Ruler) -> Vec<Action> {
    let marks: Vec<(Place, Mark)> = session.selected().collect();
    let changed = match &marks[..] {
        [(place, Mark::Ellipse(ellipse))] => self::ellipse(ui, session, ruler, *place, *ellipse),
        [(place, Mark::Line(line))] => self::line(ui, ruler, *place, *line),
        [(place, Mark::Path(path))] => self::path(ui, ruler, *place, path.clone()),
        several => self::several(ui, session, ruler, several),
    };
    let mut actions: Vec<Action> =
        changed.map(|marks| Action::Edit(Edit::Marks(marks))).into_iter().collect();
    ui.horizontal(|ui| {
        for (text, action) in [("Duplicate", Action::Duplicate), ("Delete", Action::Delete)] {
            if ui.add(Button::new(text)).clicked() {
                actions.push(action);
            }
        }
    });
    actions
}

/// A number that can be typed or dragged.
fn number(ui: &mut Ui, name: &str, value: &mut f64, unit: &'static str) -> bool {
    ui.add(number_field(DragValue::new(value).speed(0.2).max_decimals(1), unit))
        .accessible_name(name)
        .changed()
}

/// A length that can be typed or dragged.
fn length(ui: &mut Ui, name: &str, value: &mut f64, ruler: Ruler) -> bool {
    ui.add(ruler.field(value)).accessible_name(name).changed()
}

/// A share above 0 and at most 1 that can be typed or dragged.
fn share(ui: &mut Ui, name: &str, value: &mut f64) -> bool {
    let field =
        DragValue::new(value).range(0.05..=1.0).clamp_existing_to_range(false).speed(0.005).max_decimals(2);
    ui.add(number_field(field, "")).accessible_name(name).changed()
}

fn width_field(ui: &mut Ui, name: &str, value: &mut f64, ruler: Ruler) -> bool {
    ui.add(ruler.field(value).suffix(ruler.unit())).accessible_name(name).changed()
}

fn area_field(ui: &mut Ui, name: &str, value: &mut f64, ruler: Ruler) -> bool {
    ui.add(ruler.field_of_area(value).suffix(ruler.unit_of_area())).accessible_name(name).changed()
}

fn point(ui: &mut Ui, name: &str, value: &mut [f64; 2], ruler: Ruler) -> bool {
    ui.label(name);
    let changed = ui
        .horizontal(|ui| {
            let [x, y] = value;
            let changed =
                length(ui, &format!("{name} x"), x, ruler) | length(ui, &format!("{name} y"), y, ruler);
            ui.weak(ruler.unit().trim_start());
            changed
        })
        .inner;
    ui.end_row();
    changed
}

fn ellipse(
    ui: &mut Ui,
    session: &Session,
    ruler: Ruler,
    place: Place,
    mut ellipse: Ellipse,
) -> Option<Vec<(Place, Mark)>> {
    let title = match session.areas(place.layer) {
        Some(AreaKind::Polygons) => "Cell",
        Some(AreaKind::Patches) => "Patch",
        None => "Ellipse",
    };
    ui.label(RichText::new(title).strong());
    let before = ellipse;
    rows(ui, "ellipse", |ui| {
        point(ui, "Centre", &mut ellipse.center, ruler);
        ui.label("Radii").on_hover_text("Along its direction, and across it");
        ui.horizontal(|ui| {
            length(ui, "Radius along", &mut ellipse.radii[0], ruler);
            length(ui, "Radius across", &mut ellipse.radii[1], ruler);
            ui.weak(ruler.unit().trim_start());
        });
        ui.end_row();
        ui.label("Direction").on_hover_text("Degrees: 0 is to the right, 90 is down");
        number(ui, "Direction", &mut ellipse.angle, "°");
        ui.end_row();
        ui.label("Aspect").on_hover_text("Minor ÷ major radius; 1 is round. Changing it keeps the area");
        let mut aspect = ellipse.aspect();
        if share(ui, "Aspect", &mut aspect) {
            ellipse = typed::ellipse_with_aspect(&ellipse, aspect);
        }
        ui.end_row();
        ui.label("Area").on_hover_text("Changing the area keeps the shape");
        let mut area = ellipse.area();
        if area_field(ui, "Area", &mut area, ruler) && area > 0.0 {
            let factor = (area / ellipse.area()).sqrt();
            ellipse.radii = ellipse.radii.map(|radius| factor * radius);
        }
        ui.end_row();
    });
    (ellipse != before).then(|| vec![(place, Mark::Ellipse(ellipse))])
}

fn line(ui: &mut Ui, ruler: Ruler, place: Place, mut line: Line) -> Option<Vec<(Place, Mark)>> {
    ui.label(RichText::new("Line").strong());
    let before = line;
    rows(ui, "line", |ui| {
        point(ui, "From", &mut line.from, ruler);
        point(ui, "To", &mut line.to, ruler);
        ui.label("Direction");
        let mut angle = line.angle();
        if number(ui, "Direction", &mut angle, "°") {
            let by = angle - before.angle();
            if let Mark::Line(turned) = shape::turned(&Mark::Line(before), by, before.center()) {
                line = turned;
            }
        }
        ui.end_row();
        ui.label("Width").on_hover_text("Width of the stripe that the line stands for");
        width_field(ui, "Width", &mut line.width, ruler);
        ui.end_row();
    });
    presets(ui, &mut line.width, ruler);
    (line != before).then(|| vec![(place, Mark::Line(line))])
}

fn path(ui: &mut Ui, ruler: Ruler, place: Place, mut path: Path) -> Option<Vec<(Place, Mark)>> {
    ui.label(RichText::new("Path").strong());
    let before = path.clone();
    rows(ui, "path", |ui| {
        ui.label("Length").on_hover_text("Along the path; drag its points to bend it");
        ui.label(ruler.length(path.length()));
        ui.end_row();
        ui.label("Width").on_hover_text("Width of the stripe that the path stands for");
        width_field(ui, "Width", &mut path.width, ruler);
        ui.end_row();
    });
    presets(ui, &mut path.width, ruler);
    (path != before).then(|| vec![(place, Mark::Path(path))])
}

fn several(
    ui: &mut Ui,
    session: &Session,
    ruler: Ruler,
    marks: &[(Place, Mark)],
) -> Option<Vec<(Place, Mark)>> {
    ui.label(RichText::new(format!("{} marks", marks.len())).strong());
    let mut changed = None;
    let layer = marks.first().and_then(|(place, _)| session.document().layers.get(place.layer));
    let duty = layer.and_then(|layer| layer.options.duty.given());
    rows(ui, "many", |ui| changed = typed_rows(ui, ruler, marks, duty, " of all"));
    let first = marks.iter().find_map(|(_, mark)| typed::width_of(mark));
    if let Some(mut width) = first
        && presets(ui, &mut width, ruler)
    {
        changed = Some(typed::with_width(marks, width));
    }
    changed
}
