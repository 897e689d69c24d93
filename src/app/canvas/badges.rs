//! Signs at the places of the sketch that will not grow as they were drawn, and what they say.

use egui::{Align2, FontId, Pos2};

use super::ink::Ink;
use super::view::View;
use crate::app::result::Drawn;
use crate::app::theme::Palette;
use crate::document::sketch_notes::SketchNote;
use crate::editor::session::Session;

/// Radius of a sign, points.
const RADIUS: f32 = 7.0;
/// Signs of one note at most: more would hide the sketch.
const MOST: usize = 12;

/// A sign: its place, px, and what it says.
pub struct Badge {
    place: [f64; 2],
    text: String,
}

/// The signs of the notes on the sketch, and of the marks that grew otherwise than drawn.
#[must_use]
pub fn badges(notes: &[SketchNote], session: &Session, drawn: &Drawn) -> Vec<Badge> {
    let of_note = |note: &SketchNote| {
        let badge = |place: &[f64; 2]| Badge {
            place: *place,
            text: format!("Will not grow as drawn: {}.", note.text),
        };
        note.places.iter().take(MOST).map(badge).collect::<Vec<_>>()
    };
    let mut badges: Vec<Badge> = notes.iter().flat_map(of_note).collect();
    for layer in session.frozen()..session.document().layers.len() {
        let marks = drawn.of_layer(session, layer).iter().filter(|mark| mark.there || mark.off.is_some());
        let reasons = marks.filter_map(|mark| Some((mark.place, mark.reason?)));
        badges.extend(
            reasons.map(|(place, reason)| Badge { place, text: format!("Not grown as drawn: {reason}.") }),
        );
    }
    badges
}

/// What the sign at a position on the screen says.
#[must_use]
pub fn told(badges: &[Badge], view: View, room: egui::Rect, at: Pos2) -> Option<&str> {
    let is_near = |badge: &&Badge| view.to_screen(room, badge.place).distance(at) <= RADIUS + 2.0;
    badges.iter().find(is_near).map(|badge| badge.text.as_str())
}

/// Paints them.
pub fn paint(ink: &Ink, badges: &[Badge], colours: &Palette) {
    for badge in badges {
        let at = ink.at(badge.place);
        ink.painter.circle(at, RADIUS, colours.wrong, egui::Stroke::new(1.5, colours.paper));
        ink.painter.text(at, Align2::CENTER_CENTER, "!", FontId::proportional(11.0), colours.paper);
    }
}
