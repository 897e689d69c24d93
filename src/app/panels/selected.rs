//! The selected marks: their numbers, and buttons to duplicate or delete them.

use egui::{Button, DragValue, RichText, Ui};

use super::form::{presets, rows};
use crate::app::action::Action;
use crate::app::units::number_field;
use crate::editor::edit::Edit;
use crate::editor::selection::Place;
use crate::editor::session::Session;
use crate::editor::shape;
use crate::editor::units::Ruler;
use crate::marks::{Ellipse, Line, Mark, Path};

/// Shows them. A number that is changed gives the marks that replace the selected ones.
pub fn selected(ui: &mut Ui, session: &Session, ruler: Ruler) -> Vec<Action> {
    let marks: Vec<(Place, Mark)> = session.selected().collect();
    let changed = match &marks[..] {
        [(place, Mark::Ellipse(ellipse))] => self::ellipse(ui, ruler, *place, *ellipse),
        [(place, Mark::Line(line))] => self::line(ui, ruler, *place, *line),
        [(place, Mark::Path(path))] => self::path(ui, ruler, *place, path.clone()),
        several => self::several(ui, ruler, several),
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
    let field = DragValue::new(value).range(0.05..=1.0).speed(0.005).max_decimals(2);
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

fn ellipse(ui: &mut Ui, ruler: Ruler, place: Place, mut ellipse: Ellipse) -> Option<Vec<(Place, Mark)>> {
    ui.label(RichText::new("Ellipse").strong());
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
        ui.label("Direction").on_hover_text("Degrees, from right towards down");
        number(ui, "Direction", &mut ellipse.angle, "°");
        ui.end_row();
        ui.label("Aspect").on_hover_text("Minor ÷ major radius; 1 is round. Changing it keeps the area");
        let mut aspect = ellipse.aspect();
        if share(ui, "Aspect", &mut aspect) {
            ellipse = with_aspect(&ellipse, aspect);
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

fn several(ui: &mut Ui, ruler: Ruler, marks: &[(Place, Mark)]) -> Option<Vec<(Place, Mark)>> {
    ui.label(RichText::new(format!("{} marks", marks.len())).strong());
    let areas: Vec<f64> = marks.iter().filter_map(|(_, mark)| area(mark)).collect();
    let widths: Vec<f64> = marks.iter().filter_map(|(_, mark)| width(mark)).collect();
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let mut changed = None;
    rows(ui, "many", |ui| {
        if !areas.is_empty() {
            ui.label("Mean area").on_hover_text("Scales all selected marks about their centres");
            let before = mean(&areas);
            let mut area = before;
            if area_field(ui, "Mean area", &mut area, ruler) && area > 0.0 {
                changed = Some(scaled(marks, (area / before).sqrt()));
            }
            ui.end_row();
            ui.label("Aspect").on_hover_text("Minor ÷ major radius of all selected ellipses; 1 is round");
            let aspects: Vec<f64> = ellipses(marks).map(|(_, ellipse)| ellipse.aspect()).collect();
            let mut aspect = mean(&aspects);
            if share(ui, "Aspect of all", &mut aspect) {
                let each = ellipses(marks);
                changed = Some(
                    each.map(|(place, one)| (place, Mark::Ellipse(with_aspect(&one, aspect)))).collect(),
                );
            }
            ui.end_row();
            ui.label("Direction").on_hover_text("One direction for all selected ellipses, degrees");
            let mut angle = ellipses(marks).next().map_or(0.0, |(_, ellipse)| ellipse.major_angle());
            if number(ui, "Direction of all", &mut angle, "°") {
                let turned = |(place, one): (Place, Ellipse)| {
                    let by = angle - one.major_angle();
                    (place, shape::turned(&Mark::Ellipse(one), by, one.center))
                };
                changed = Some(ellipses(marks).map(turned).collect());
            }
            ui.end_row();
        }
        changed = spacing_row(ui, ruler, marks).or(changed.take());
        if !widths.is_empty() {
            ui.label("Width").on_hover_text("One width for all selected lines");
            let mut width = mean(&widths);
            if width_field(ui, "Width of all", &mut width, ruler) {
                changed = Some(with_width(marks, width));
            }
            ui.end_row();
        }
    });
    if let Some(first) = widths.first() {
        let mut width = *first;
        if presets(ui, &mut width, ruler) {
            changed = Some(with_width(marks, width));
        }
    }
    changed
}

/// The distance of the marks to their nearest; a number that is changed gives the marks that replace them.
fn spacing_row(ui: &mut Ui, ruler: Ruler, marks: &[(Place, Mark)]) -> Option<Vec<(Place, Mark)>> {
    let before = nearest_neighbours(marks)?;
    let mut changed = None;
    ui.label("Spacing").on_hover_text(
        "Mean distance to the nearest neighbour, from centre to centre. Changing it moves the selected marks apart or \
         together; their sizes stay",
    );
    let mut spacing = before;
    if width_field(ui, "Spacing", &mut spacing, ruler) && spacing > 0.0 {
        changed = Some(spread(marks, spacing / before));
    }
    ui.end_row();
    changed
}

/// The ellipses among the marks.
fn ellipses(marks: &[(Place, Mark)]) -> impl Iterator<Item = (Place, Ellipse)> + '_ {
    marks.iter().filter_map(|(place, mark)| Some((*place, mark.ellipse()?)))
}

/// The ellipse with this aspect and the same area.
fn with_aspect(ellipse: &Ellipse, aspect: f64) -> Ellipse {
    Ellipse::from_area(ellipse.center, ellipse.area(), aspect, ellipse.major_angle())
}

/// The mean distance of the marks to their nearest, px; `None` of fewer than two, or where all are at one place.
fn nearest_neighbours(marks: &[(Place, Mark)]) -> Option<f64> {
    let centers: Vec<[f64; 2]> = marks.iter().map(|(_, mark)| mark.center()).collect();
    let nearest = |index: usize| {
        let others = centers.iter().enumerate().filter(|(other, _)| *other != index);
        let far = |(_, at): (usize, &[f64; 2])| (at[0] - centers[index][0]).hypot(at[1] - centers[index][1]);
        others.map(far).fold(f64::INFINITY, f64::min)
    };
    let mean = (0..centers.len()).map(nearest).sum::<f64>() / centers.len() as f64;
    (mean.is_finite() && mean > 0.0).then_some(mean)
}

/// The marks moved apart by a factor, about the mean of their centres.
fn spread(marks: &[(Place, Mark)], factor: f64) -> Vec<(Place, Mark)> {
    let mean =
        |axis: usize| marks.iter().map(|(_, mark)| mark.center()[axis]).sum::<f64>() / marks.len() as f64;
    let middle = [mean(0), mean(1)];
    let moved = |(place, mark): &(Place, Mark)| {
        let center = mark.center();
        (*place, shape::moved(mark, [0, 1].map(|axis| (factor - 1.0) * (center[axis] - middle[axis]))))
    };
    marks.iter().map(moved).collect()
}

fn area(mark: &Mark) -> Option<f64> {
    mark.ellipse().map(|ellipse| ellipse.area())
}

fn width(mark: &Mark) -> Option<f64> {
    match mark {
        Mark::Ellipse(_) => None,
        Mark::Line(line) => Some(line.width),
        Mark::Path(path) => Some(path.width),
    }
}

fn scaled(marks: &[(Place, Mark)], factor: f64) -> Vec<(Place, Mark)> {
    marks.iter().map(|(place, mark)| (*place, shape::scaled(mark, factor, shape::center(mark)))).collect()
}

/// The lines and paths among the marks, with this width.
fn with_width(marks: &[(Place, Mark)], width: f64) -> Vec<(Place, Mark)> {
    let with_width = |(place, mark): &(Place, Mark)| match mark {
        Mark::Line(line) => Some((*place, Mark::Line(Line { width, ..*line }))),
        Mark::Path(path) => Some((*place, Mark::Path(Path { width, ..path.clone() }))),
        Mark::Ellipse(_) => None,
    };
    marks.iter().filter_map(with_width).collect()
}
