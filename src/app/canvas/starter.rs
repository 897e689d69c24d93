//! What an empty canvas shows: faint marks to trace. Also the marks that a new sketch can begin with.

use egui::text::{LayoutJob, TextFormat};
use egui::{Align, FontId, Stroke, pos2};

use super::ink::Ink;
use crate::app::theme::Palette;
use crate::marks::{Ellipse, Line, Mark};

/// The first line of text on an empty canvas.
const TITLE: &str = "Draw a few spots here, each with one stroke";

/// The unit of lengths of the first marks, px.
fn unit(size: [u32; 2]) -> f64 {
    0.1 * f64::from(size[0].min(size[1]))
}

/// A few spots, or a few lines, in the middle of a canvas of `size` px.
#[must_use]
pub fn starter(size: [u32; 2], spots: bool) -> Vec<Mark> {
    let [width, height] = size.map(f64::from);
    let unit = unit(size);
    let at = |x: f64, y: f64| [0.5 * width + x * unit, 0.5 * height + y * unit];
    if spots {
        let spot = |[x, y]: [f64; 2]| {
            Mark::Ellipse(Ellipse { center: at(x, y), radii: [0.34 * unit, 0.24 * unit], angle: 25.0 })
        };
        [[-1.0, -0.8], [0.2, -1.0], [1.2, -0.5], [-0.6, 0.3], [0.6, 0.4], [-0.1, 1.2]].map(spot).into()
    } else {
        let line = |k: f64| Mark::Line(Line { from: at(-1.6, k), to: at(1.6, k - 0.5), width: 0.24 * unit });
        [-0.75, -0.15, 0.45, 1.05].map(line).into()
    }
}

/// Paints faint marks to trace, and how to begin.
pub fn paint(ink: &Ink, size: [u32; 2], colours: &Palette, text: egui::Color32) {
    for mark in starter(size, true) {
        ink.dashed_outline(&mark, Stroke::new(1.0, colours.border));
    }
    let seen = ink.view.paper(ink.room, size).intersect(ink.room);
    let wide = seen.width() - 32.0;
    if wide < 120.0 {
        return;
    }
    let mut job = LayoutJob { halign: Align::Center, ..LayoutJob::default() };
    job.wrap.max_width = wide;
    let format = |size, colour| TextFormat::simple(FontId::proportional(size), colour);
    job.append(TITLE, 0.0, format(16.0, colours.ink(0)));
    let more = "\nAn open stroke grows stripes. Everything can be undone.";
    job.append(more, 0.0, format(12.5, text));
    let galley = ink.painter.layout_job(job);
    // Above the faint marks; where there is no room for both lines, only the first one.
    let traces = ink.at([0.5 * f64::from(size[0]), f64::from(size[1]) * 0.5 - 1.35 * unit(size)]).y - 10.0;
    let room = traces - seen.top();
    let galley = if galley.size().y + 8.0 <= room {
        galley
    } else {
        let first = LayoutJob::simple(TITLE.to_owned(), FontId::proportional(13.0), colours.ink(0), wide);
        ink.painter.layout_job(LayoutJob { halign: Align::Center, ..first })
    };
    let top = (seen.top() + 0.14 * seen.height()).min(traces - galley.size().y).max(seen.top() + 4.0);
    ink.painter.galley(pos2(seen.center().x, top), galley, text);
}
