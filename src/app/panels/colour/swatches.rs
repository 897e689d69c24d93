//! The colours of the document, to be used again.

use egui::{Rect, RichText, Role, Sense, Stroke, StrokeKind, Ui, WidgetInfo, vec2};

use super::{ColourPanel, hex, shown};
use crate::app::theme::Palette;
use crate::document::Colours;
use crate::editor::session::Session;

/// Side of a swatch, points.
const SIDE: f32 = 20.0;
/// Swatches at most; a palette of more colours is not looked through.
const MOST: usize = 40;

/// The colours of all stops of all layers, each once, the lowest layer first.
fn of_document(session: &Session) -> Vec<[u8; 3]> {
    let mut found: Vec<[u8; 3]> = Vec::new();
    for layer in 0..session.document().layers.len() {
        for stop in session.colours(layer).stops {
            if !found.contains(&stop.colour) && found.len() < MOST {
                found.push(stop.colour);
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
        for colour in found {
            let (rect, response) = ui.allocate_exact_size(vec2(SIDE, SIDE), Sense::click());
            let name = format!("Use {}", hex(colour));
            let is_used = colours.stops[panel.stop].colour == colour;
            response.widget_info(|| WidgetInfo::selected(Role::Button, true, is_used, &name));
            paint(ui, rect, colour, response.hovered() || response.has_focus(), is_used);
            if response.on_hover_text(format!("{name} for the selected stop")).clicked() {
                chosen = Some(colour);
            }
        }
    });
    if let Some(colour) = chosen {
        colours.stops[panel.stop].colour = colour;
        panel.hex = None;
    }
}

fn paint(ui: &Ui, rect: Rect, colour: [u8; 3], is_marked: bool, is_used: bool) {
    let palette = Palette::current(ui.visuals());
    ui.painter().rect_filled(rect, 3.0, shown(colour));
    let stroke = if is_marked || is_used {
        Stroke::new(2.0, palette.accent)
    } else {
        Stroke::new(1.0, palette.border)
    };
    ui.painter().rect_stroke(rect, 3.0, stroke, StrokeKind::Inside);
}
