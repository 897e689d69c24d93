//! The colours of the document, to be used again.

use egui::{Rect, RichText, Role, Sense, Stroke, StrokeKind, Ui, WidgetInfo, vec2};

use super::{ColourPanel, shown};
use crate::app::checkerboard;
use crate::app::theme::Palette;
use crate::document::{Colours, Stop};
use crate::editor::session::Session;

/// Side of a swatch, points.
const SIDE: f32 = 20.0;
/// The largest number of swatches; further colours of a palette are not looked for.
const MOST: usize = 40;

/// The colours of all stops of all layers, each once, the lowest layer first.
fn of_document(session: &Session) -> Vec<Stop> {
    let mut found: Vec<Stop> = Vec::new();
    for layer in 0..session.document().layers.len() {
        for stop in session.colours(layer).stops {
            if found.iter().all(|other| other.rgba() != stop.rgba()) && found.len() < MOST {
                found.push(stop);
            }
        }
    }
    found
}

/// Shows them; a click gives the selected stop a colour.
pub fn swatches(ui: &mut Ui, session: &Session, panel: &mut ColourPanel, colours: &mut Colours) {
    let found = of_document(session);
    if found.len() < 2 {
        return;
    }
    ui.label(RichText::new("In this document").small().weak());
    panel.retain_existing(colours);
    let mut chosen = None;
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = vec2(4.0, 4.0);
        for stop in found {
            let (rect, response) = ui.allocate_exact_size(vec2(SIDE, SIDE), Sense::click());
            let name = format!("Use {}", stop.hex());
            let is_used = colours.stops[panel.stop].rgba() == stop.rgba();
            response.widget_info(|| WidgetInfo::selected(Role::Button, true, is_used, &name));
            paint(ui, rect, stop, response.hovered() || response.has_focus(), is_used);
            if response.on_hover_text(format!("{name} for the selected stop")).clicked() {
                chosen = Some(stop);
            }
        }
    });
    if let Some(stop) = chosen {
        colours.stops[panel.stop].set_rgba(stop.rgba());
        panel.hex = None;
    }
}

fn paint(ui: &Ui, rect: Rect, stop: Stop, is_marked: bool, is_used: bool) {
    let palette = Palette::current(ui.visuals());
    if stop.alpha < u8::MAX {
        checkerboard::paint(ui.painter(), rect);
    }
    ui.painter().rect_filled(rect, 3.0, shown(stop.rgba()));
    let stroke = if is_marked || is_used {
        Stroke::new(2.0, palette.accent)
    } else {
        Stroke::new(1.0, palette.border)
    };
    ui.painter().rect_stroke(rect, 3.0, stroke, StrokeKind::Inside);
}
