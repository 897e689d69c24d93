//! Signs on the sketch, at places that will not grow or did not grow as they were drawn, and their texts.

use egui::{Align2, FontId, Pos2};

use super::ink::Ink;
use super::view::View;
use super::wanted::Wanted;
use crate::app::result::Drawn;
use crate::app::theme::Palette;
use crate::attributes::free::Note;
use crate::document::Kind;
use crate::document::sketch_notes::SketchNote;
use crate::editor::session::Session;
use crate::editor::units::Ruler;

/// Radius of a sign, points.
const RADIUS: f32 = 7.0;
/// Signs of one note at most: more would hide the sketch.
const MOST: usize = 12;

/// A sign: its place, px, and what it says.
#[derive(Clone, Debug, PartialEq)]
pub struct Badge {
    /// The place, px.
    pub place: [f64; 2],
    /// What will not be, or is not, as it was drawn, and what to do.
    pub text: String,
    /// Whether it is about what has grown, and is shown beside the texture as well.
    pub has_grown: bool,
}

/// The signs for: the notes on the sketch, the notes on the lines of the active layer, marks that grew otherwise than
/// drawn, and spots that grew together.
#[must_use]
pub fn badges(
    notes: &[SketchNote],
    wanted: Option<&Wanted>,
    (session, drawn): (&Session, &Drawn),
    ruler: Ruler,
) -> Vec<Badge> {
    let of_note = |note: &SketchNote| {
        let text = note.problem.in_words("", &|area| ruler.area(area));
        let badge = |place: &[f64; 2]| Badge {
            place: *place,
            text: format!("Will not grow as drawn: {text}."),
            has_grown: false,
        };
        note.places.iter().take(MOST).map(badge).collect::<Vec<_>>()
    };
    let mut badges: Vec<Badge> = notes.iter().flat_map(of_note).collect();
    // Crossings are among the notes on the sketch.
    let of_lines = wanted.into_iter().flat_map(|wanted| wanted.map.notes());
    let of_lines = of_lines.filter(|note| !matches!(note, Note::Crossing { .. })).take(MOST);
    badges.extend(of_lines.map(|note| Badge {
        place: note.place(),
        text: format!("Will not grow as drawn: {}.", note.in_words(&|length| ruler.rough(length))),
        has_grown: false,
    }));
    for layer in session.frozen()..session.document().layers.len() {
        badges.extend(grown(session, drawn, layer));
    }
    badges
}

/// The signs of what has grown on a layer.
fn grown(session: &Session, drawn: &Drawn, layer: usize) -> Vec<Badge> {
    let marks = drawn.of_layer(session, layer).iter().filter(|mark| mark.there || mark.off.is_some());
    let reasons = marks.filter_map(|mark| Some((mark.place, mark.reason?)));
    let remedy = remedy(session.kind(layer));
    let mut badges: Vec<Badge> = reasons
        .map(|(place, reason)| Badge {
            place,
            text: format!("Not grown as drawn: {reason}. {remedy}"),
            has_grown: false,
        })
        .collect();
    let merged = drawn.merged(session, layer).iter().take(MOST);
    badges.extend(merged.map(|place| Badge { place: *place, text: MERGED.to_owned(), has_grown: true }));
    badges
}

/// The text of the sign where two spots grew together.
pub const MERGED: &str = "Two spots grew together here. Draw the marks around this place farther apart or \
                          smaller, or try another seed (N).";

/// What to do about a mark that does not grow.
#[must_use]
pub fn remedy(kind: Option<Kind>) -> &'static str {
    match kind {
        Some(Kind::Line) => "Move it away from the other lines, or turn it parallel to them.",
        _ => "Move it to a free place, or make it smaller.",
    }
}

/// The text of the sign at a position on the screen.
#[must_use]
pub fn told<'a>(
    badges: impl IntoIterator<Item = &'a Badge>,
    view: View,
    room: egui::Rect,
    at: Pos2,
) -> Option<&'a str> {
    let is_near = |badge: &&Badge| view.to_screen(room, badge.place).distance(at) <= RADIUS + 2.0;
    badges.into_iter().find(is_near).map(|badge| badge.text.as_str())
}

/// The places on the screen of the signs of what has grown: beside the canvas, which is shown in `paper`, at the height of
/// what they mark, on the nearer side; in order, none on another. Where the canvas fills the `room`, they are at its edge.
pub fn beside<'a>(
    badges: impl IntoIterator<Item = &'a Badge>,
    view: View,
    room: egui::Rect,
    paper: egui::Rect,
) -> Vec<(&'a Badge, Pos2)> {
    const STEP: f32 = 2.0 * RADIUS + 1.0;
    let inner = room.shrink(RADIUS + 1.0);
    let mut badges: Vec<(&Badge, Pos2)> =
        badges.into_iter().map(|badge| (badge, view.to_screen(room, badge.place))).collect();
    badges.retain(|(_, at)| inner.y_range().contains(at.y));
    badges.sort_by(|(_, a), (_, b)| a.y.total_cmp(&b.y));
    let mut free = [f32::NEG_INFINITY; 2];
    for (_, at) in &mut badges {
        let is_right = at.x > paper.center().x;
        let x = if is_right { paper.right() + RADIUS + 3.0 } else { paper.left() - RADIUS - 3.0 };
        let free = &mut free[usize::from(is_right)];
        *at = Pos2::new(x.clamp(inner.left(), inner.right()), at.y.max(*free));
        *free = at.y + STEP;
    }
    badges
}

/// Paints the signs of what has grown beside the texture. Pointing at one, at the position `pointer`, shows its place;
/// gives its text.
pub fn paint_beside<'a>(
    ink: &Ink,
    badges: impl IntoIterator<Item = &'a Badge>,
    paper: egui::Rect,
    pointer: Option<Pos2>,
    colours: &Palette,
) -> Option<&'a str> {
    let mut text = None;
    for (badge, at) in beside(badges, *ink.view, ink.room, paper) {
        sign(ink, at, colours);
        if pointer.is_some_and(|pointer| pointer.distance(at) <= RADIUS + 2.0) {
            let ring = egui::Stroke::new(2.0, colours.wrong);
            ink.painter.circle_stroke(ink.at(badge.place), 2.0 * RADIUS, ring);
            ink.painter.line_segment([at, ink.at(badge.place)], egui::Stroke::new(1.0, colours.wrong));
            text = Some(badge.text.as_str());
        }
    }
    text
}

/// Paints them.
pub fn paint<'a>(ink: &Ink, badges: impl IntoIterator<Item = &'a Badge>, colours: &Palette) {
    for badge in badges {
        sign(ink, ink.at(badge.place), colours);
    }
}

fn sign(ink: &Ink, at: Pos2, colours: &Palette) {
    ink.painter.circle(at, RADIUS, colours.wrong, egui::Stroke::new(1.5, colours.paper));
    ink.painter.text(at, Align2::CENTER_CENTER, "!", FontId::proportional(11.0), colours.paper);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_of_what_has_grown_are_beside_the_canvas_and_not_on_each_other() {
        let room = egui::Rect::from_min_size(Pos2::ZERO, egui::vec2(300.0, 200.0));
        let mut view = View::default();
        view.fit([100, 100], room);
        let paper = view.paper(room, [100, 100]);
        let badge = |place| Badge { place, text: String::new(), has_grown: true };
        let badges = [[80.0, 50.0], [20.0, 50.0], [90.0, 52.0]].map(badge);
        let places: Vec<Pos2> = beside(&badges, view, room, paper).into_iter().map(|(_, at)| at).collect();
        assert!(
            places.iter().all(|at| room.contains(*at) && !paper.expand(RADIUS).contains(*at)),
            "{places:?}"
        );
        assert!(places[0].x > paper.right() && places[1].x < paper.left());
        assert!(places[0].distance(places[2]) >= 2.0 * RADIUS, "{places:?}");
    }
}
