//! The attributes that the marks ask for: in a region, or at a place between free marks.

use egui::{RichText, Ui};

use super::form::{heading, rows};
use super::typed_rows::typed_rows;
use crate::app::action::Action;
use crate::app::canvas::Canvas;
use crate::attributes::Attributes;
use crate::editor::edit::Edit;
use crate::editor::selection::Place;
use crate::editor::session::Session;
use crate::editor::units::Ruler;
use crate::marks::Mark;

/// Shows what the free marks of the active layer ask for at the pointer; while the pointer is elsewhere, the mean of
/// the marks.
pub fn here(ui: &mut Ui, session: &Session, canvas: &Canvas, ruler: Ruler) {
    let Some(wanted) = canvas.wanted.of(session.active_layer) else { return };
    let size = session.document().size.map(f64::from);
    let on_canvas = |at: &[f64; 2]| (0..2).all(|axis| (0.0..=size[axis]).contains(&at[axis]));
    let at = canvas.pointer.filter(on_canvas);
    heading(ui, if at.is_some() { "Asked for at the pointer" } else { "Asked for on average" });
    let attributes = at.map_or_else(|| wanted.map.mean(), |at| wanted.map.at(at));
    rows(ui, "here", |ui| rows_of(ui, &attributes, ruler));
}

/// Shows the attributes of the chosen region, else of the region under the pointer, else of the region in the centre.
/// Those of its marks can be typed; a number that is changed gives the marks that replace them.
pub fn region(ui: &mut Ui, session: &Session, canvas: &Canvas, ruler: Ruler) -> Option<Action> {
    let center = session.document().size.map(|side| 0.5 * f64::from(side));
    let layer = session.active_layer;
    let map = canvas.analysis.map(session, layer)?;
    let grid = session.document().region_grid();
    let chosen = canvas.chosen_region.filter(|place| (0..2).all(|axis| place[axis] < grid[axis]));
    let place = chosen.unwrap_or_else(|| map.region_of(canvas.pointer.unwrap_or(center)));
    heading(ui, &format!("Region {}, {}", place[0] + 1, place[1] + 1));
    let region = map.region(place);
    let marks =
        session.marks().filter(|(at, mark)| at.layer == layer && map.region_of(mark.center()) == place);
    let marks: Vec<(Place, Mark)> = marks.collect();
    let mut changed = None;
    let is_own = region.own.is_some();
    rows(ui, "region", |ui| {
        let count = if is_own { marks.len().to_string() } else { "none (nearest used)".to_owned() };
        row(
            ui,
            "Marks",
            count,
            "Number of marks whose centre is in this region. A region without marks grows like the nearest \
             region that has some",
        );
        if is_own && !session.is_active_frozen() {
            let duty = session.document().layers.get(layer).and_then(|layer| layer.options.duty.given());
            changed = typed_rows(ui, ruler, &marks, duty, " of the region");
        } else {
            rows_of(ui, &map.at(map.layout().center(place)), ruler);
        }
    });
    if chosen.is_none() {
        let help = "Click a region with the tool Select to keep it here and type its numbers.";
        ui.label(RichText::new(help).small().weak());
    }
    changed.map(|marks| Action::Edit(Edit::Marks(marks)))
}

/// A row for each attribute that is asked for.
fn rows_of(ui: &mut Ui, wanted: &Attributes, ruler: Ruler) {
    match wanted {
        Attributes::Spots(spots) => {
            row(ui, "Area", ruler.area(spots.area), "Area of the ellipses");
            row(ui, "Aspect", format!("{:.2}", spots.aspect), "Minor ÷ major radius; 1 is round");
            row(ui, "Direction", format!("{:.0}°", spots.angle), "Direction of the major axes");
            let spacing = spots.spacing.map_or("free".to_owned(), |spacing| ruler.rough(spacing));
            row(ui, "Spacing", spacing, "Distance between neighbours. Free: dapple chooses it");
        }
        Attributes::Stripes(stripes) => {
            row(ui, "Width", ruler.length(stripes.width), "Width of the stripes");
            row(ui, "Direction", format!("{:.0}°", stripes.angle), "Direction of the stripes");
            if let Some(period) = stripes.wavelength {
                row(ui, "Period", ruler.rough(period), "From the middle of a stripe to that of the next");
            }
        }
    }
}

fn row(ui: &mut Ui, name: &str, value: String, help: &str) {
    ui.label(name).on_hover_text(help);
    ui.label(RichText::new(value).weak());
    ui.end_row();
}
