//! The direction of hair over the sketch while it is combed: its strokes, and arrows along the flow between them.

use egui::{Stroke, vec2};

use super::ink::Ink;
use crate::app::theme::Palette;
use crate::document::Document;
use crate::editor::session::Session;
use crate::finish::Flow;
use crate::synth::render::painting::flow_of;

/// Distance and length of the arrows, points.
const ARROWS: [f32; 2] = [28.0, 15.0];

/// The flow of a document, as it was computed last.
#[derive(Default)]
pub struct Combed {
    of: Option<Document>,
    flow: Option<Flow>,
}

impl Combed {
    /// Computes the flow anew where the document has changed.
    pub fn update(&mut self, document: &Document) {
        if self.of.as_ref() != Some(document) {
            (self.flow, self.of) = (flow_of(document), Some(document.clone()));
        }
    }

    /// Paints the flow and the strokes of hair.
    pub fn paint(&self, ink: &Ink, session: &Session, colours: &Palette) {
        let Some(flow) = &self.flow else { return };
        let size = session.document().size.map(f64::from);
        let [apart, length] = ARROWS;
        let step = f64::from(apart / ink.view.zoom);
        let count = size.map(|side| (side / step).round().max(1.0) as usize);
        let thin = Stroke::new(1.0, colours.accent);
        for node in 0..count[0] * count[1] {
            let place = [node % count[0], node / count[0]];
            let point = [0, 1].map(|axis| (place[axis] as f64 + 0.5) * size[axis] / count[axis] as f64);
            let middle = ink.at(point);
            if ink.room.contains(middle) {
                let [x, y] = flow.at(point.map(|part| part as f32));
                let way = length * vec2(x, y);
                ink.painter.arrow(middle - 0.5 * way, way, thin);
            }
        }
        let wide = Stroke::new(2.5, colours.pen);
        for path in session.hair() {
            ink.path(&path.points, wide);
            if let [.., before, last] = path.points[..] {
                let [before, last] = [ink.at(before), ink.at(last)];
                let way = 9.0 * (last - before).normalized();
                ink.painter.arrow(last - way, way, wide);
            }
        }
    }
}
