//! A small picture in a row of choices: the picture or words in its place, a border where it is the one that is open, a bar while it
//! grows.

use egui::{
    Align2, Color32, FontId, Rect, Response, Shape, Stroke, StrokeKind, TextureHandle, Ui, epaint::Mesh,
    pos2, vec2,
};

use crate::app::theme::Palette;

/// Size of the words in place of a picture, points.
const WORDS: f32 = 11.5;
/// Space around them, points.
const MARGIN: f32 = 5.0;

/// What a card shows.
pub struct Card<'a> {
    /// The picture.
    pub texture: Option<&'a TextureHandle>,
    /// The words in its place.
    pub words: &'a str,
    /// Whether it is the one that is open.
    pub is_open: bool,
    /// Whether it can be chosen; others are paler.
    pub is_there: bool,
    /// How far it has grown, 0..1.
    pub progress: Option<f32>,
}

/// Paints a card.
pub fn paint(ui: &Ui, rect: Rect, card: &Card) {
    let palette = Palette::current(ui.visuals());
    let painter = ui.painter();
    painter.rect_filled(rect, 4.0, palette.background);
    if let Some(texture) = card.texture {
        let size = texture.size_vec2();
        let shown = Rect::from_center_size(rect.center(), size * (rect.size() / size).min_elem());
        let mut mesh = Mesh::with_texture(texture.id());
        let tint = if card.is_there { Color32::WHITE } else { Color32::from_white_alpha(90) };
        mesh.add_rect_with_uv(shown, Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0)), tint);
        painter.add(Shape::mesh(mesh));
    } else {
        let weak = ui.visuals().weak_text_color();
        let wide = rect.width() - 2.0 * MARGIN;
        let words = painter.layout(card.words.to_owned(), FontId::proportional(WORDS), weak, wide);
        let corner = Align2::CENTER_CENTER.anchor_size(rect.center(), words.size()).min;
        painter.galley(corner, words, weak);
    }
    if let Some(share) = card.progress {
        let bar = Rect::from_min_size(rect.left_bottom() - vec2(0.0, 4.0), vec2(rect.width() * share, 4.0));
        painter.rect_filled(bar, 2.0, palette.accent);
    }
    let border =
        if card.is_open { Stroke::new(2.5, palette.accent) } else { Stroke::new(1.0, palette.border) };
    painter.rect_stroke(rect, 4.0, border, StrokeKind::Inside);
}

/// Frames a card that is pointed at or has the keyboard focus, and scrolls to it then.
pub fn mark(ui: &Ui, rect: Rect, response: &Response) {
    if response.has_focus() || response.hovered() {
        let stroke = Stroke::new(1.5, Palette::current(ui.visuals()).accent);
        ui.painter().rect_stroke(rect.expand(1.0), 4.0, stroke, StrokeKind::Outside);
    }
    if response.has_focus() {
        response.scroll_to_me(None);
    }
}
