//! A small picture of a sketch.

use egui::{Color32, Rect, Stroke, StrokeKind, Ui};

use super::canvas::ink::Ink;
use super::canvas::view::View;
use super::theme::Palette;
use crate::marks::Mark;

/// Paints the marks, with the index of their layer, on a canvas of `size` px in `room`.
pub fn paint(ui: &Ui, room: Rect, size: [u32; 2], marks: &[(usize, Mark)]) {
    let colours = Palette::current(ui.visuals());
    let mut view = View::default();
    view.fit(size, room);
    let paper = view.paper(room, size);
    let painter = ui.painter_at(paper.expand(1.0));
    painter.rect(paper, 2.0, colours.paper, Stroke::new(1.0, colours.border), StrokeKind::Inside);
    let ink = Ink { painter: &painter, view: &view, room };
    for (layer, mark) in marks {
        let colour: Color32 = colours.ink(*layer);
        ink.mark(mark, colour.gamma_multiply(0.8), Stroke::NONE);
    }
}
