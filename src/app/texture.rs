//! The texture beside the canvas.

use egui::{
    Align2, Color32, FontId, Id, Painter, Rect, Response, Role, Sense, Shape, Stroke, StrokeKind,
    TextureHandle, TextureOptions, Ui, WidgetInfo, epaint::Mesh, pos2, vec2,
};

use super::canvas::badges::{self, Badge};
use super::canvas::ink::Ink;
use super::canvas::navigate;
use super::canvas::view::View;
use super::checkerboard;
use super::growth::{Growth, GrowthState, Picture};
use super::theme::Palette;
use crate::editor::wheel::Wheel;

/// The view of the texture.
#[derive(Default)]
pub struct TextureView {
    texture: Option<TextureHandle>,
    /// Whether a part of it is transparent.
    is_see_through: bool,
    /// Whether the texture continues beyond its sides, as a seamless tile does.
    repeats: bool,
    /// Which part is shown.
    pub view: View,
    /// Whether it is shown two by two, to check for seams.
    pub tiled: bool,
    /// What the wheel does.
    pub wheel: Wheel,
    /// The position of the pointer, px of the canvas.
    pub pointer: Option<[f64; 2]>,
}

impl TextureView {
    /// Loads a picture to the graphics card.
    pub fn take(&mut self, ui: &Ui, picture: Option<&Picture>) {
        let Some(picture) = picture else {
            self.texture = None;
            return;
        };
        self.is_see_through = !picture.is_opaque;
        let wraps_as_before = !self.is_outdated();
        self.repeats = self.tiled;
        // A single tile must not repeat: each side would show through at the opposite one.
        let options = if self.repeats { TextureOptions::LINEAR_REPEAT } else { TextureOptions::LINEAR };
        let image = picture.image.clone();
        match &mut self.texture {
            Some(texture) if texture.size() == image.size && wraps_as_before => {
                texture.set_partial([0, 0], image, options);
            }
            _ => self.texture = Some(ui.ctx().load_texture("texture", image, options)),
        }
    }

    /// Whether the texture was loaded for the other way to show it: as one tile, or two by two.
    #[must_use]
    pub fn is_outdated(&self) -> bool {
        self.texture.is_some() && self.repeats != self.tiled
    }

    /// px of the picture for each px of the canvas, along a side, at which no px is magnified on the screen; at most 4.
    #[must_use]
    pub fn fineness(&self, pixels_per_point: f32) -> usize {
        ((self.view.zoom * pixels_per_point - 0.25).ceil() as usize).clamp(1, 4)
    }

    /// Shows the texture of a canvas of `size` px in `room`.
    ///
    /// `badges`: signs at what has not grown as it was drawn.
    pub fn ui(
        &mut self,
        ui: &mut Ui,
        room: Rect,
        size: [u32; 2],
        growth: &Growth,
        badges: &[Badge],
    ) -> Response {
        let response = ui.interact(room, ui.scope_id().with("texture"), Sense::click_and_drag());
        let name = format!("Texture, {}", state(&growth.state));
        response.widget_info(|| WidgetInfo::labeled(Role::Image, true, &name));
        let shown = if self.tiled { size.map(|side| 2 * side) } else { size };
        if self.view.fitted {
            self.view.fit(shown, room);
        }
        self.pointer = response.hover_pos().map(|at| self.view.to_canvas(room, at));
        navigate(ui, &response, room, &mut self.view, self.wheel, true);
        let painter = ui.painter_at(room);
        self.paint(ui, &painter, room, size);
        if self.texture.is_none() {
            empty(ui, &painter, self.view.paper(room, shown), &growth.state);
        }
        if self.tiled {
            return response;
        }
        let grown = badges.iter().filter(|badge| badge.has_grown);
        let ink = Ink { painter: &painter, view: &self.view, room };
        let (paper, colours) = (self.view.paper(room, size), Palette::current(ui.visuals()));
        match badges::paint_beside(&ink, grown, paper, response.hover_pos(), colours) {
            Some(text) => response.on_hover_text_at_pointer(text),
            None => response,
        }
    }

    /// Paints the texture where the canvas is shown in `room`.
    pub fn paint(&self, ui: &Ui, painter: &Painter, room: Rect, size: [u32; 2]) {
        let Some(texture) = &self.texture else { return };
        let tiles = if self.tiled { 2.0 } else { 1.0 };
        let shown = if self.tiled { size.map(|side| 2 * side) } else { size };
        let rect = self.view.paper(room, shown);
        if self.is_see_through {
            checkerboard::paint(painter, rect);
        }
        let mut mesh = Mesh::with_texture(texture.id());
        mesh.add_rect_with_uv(rect, Rect::from_min_size(pos2(0.0, 0.0), vec2(tiles, tiles)), Color32::WHITE);
        painter.add(Shape::mesh(mesh));
        let border = Palette::current(ui.visuals()).border;
        painter.rect_stroke(rect, 2.0, Stroke::new(1.0, border), StrokeKind::Outside);
    }
}

/// The state of a growth, as text.
#[must_use]
pub fn state(state: &GrowthState) -> &'static str {
    match state {
        GrowthState::Idle => "empty",
        GrowthState::Growing(..) => "growing",
        GrowthState::Stopped => "stopped",
        GrowthState::Settled(_) => "finished",
        GrowthState::Failed(_) => "cannot be grown",
    }
}

fn empty(ui: &Ui, painter: &Painter, paper: Rect, state: &GrowthState) {
    let colours = Palette::current(ui.visuals());
    let stroke = Stroke::new(1.0, colours.border);
    let [a, b, c, d] = [paper.left_top(), paper.right_top(), paper.right_bottom(), paper.left_bottom()];
    painter.extend(Shape::dashed_line(&[a, b, c, d, a], stroke, 5.0, 5.0));
    let text = match state {
        GrowthState::Idle => "The texture grows here",
        GrowthState::Growing(..) => "Preparing the growth …",
        _ => return,
    };
    let weak = ui.visuals().weak_text_color();
    painter.text(paper.center(), Align2::CENTER_CENTER, text, FontId::proportional(15.0), weak);
}

/// Shows the divider between sketch and texture, where one lies over the other. `share`: its position, 0..1 of the
/// width.
pub fn divider(ui: &mut Ui, room: Rect, share: &mut f32) -> Response {
    let x = room.left() + *share * room.width();
    let bar = Rect::from_center_size(pos2(x, room.center().y), vec2(16.0, room.height()));
    let response = ui.interact(bar, Id::unique("divider"), Sense::drag());
    response.widget_info(|| WidgetInfo::slider(true, f64::from(*share), "Sketch over texture"));
    if response.dragged() {
        *share = (*share + response.drag_delta().x / room.width()).clamp(0.0, 1.0);
    }
    if response.has_focus() {
        let step = ui.input(|input| {
            let pressed = |key| input.num_presses(key) as f32;
            0.05 * (pressed(egui::Key::ArrowRight) - pressed(egui::Key::ArrowLeft))
        });
        *share = (*share + step).clamp(0.0, 1.0);
    }
    response.on_hover_and_drag_cursor(egui::CursorIcon::ResizeHorizontal)
}

/// Paints the divider.
pub fn paint_divider(ui: &Ui, room: Rect, share: f32) {
    let colours = Palette::current(ui.visuals());
    let x = room.left() + share * room.width();
    let painter = ui.painter_at(room);
    painter.vline(x, room.y_range(), Stroke::new(2.0, colours.accent));
    painter.circle(pos2(x, room.center().y), 9.0, colours.paper, Stroke::new(2.0, colours.accent));
    for side in [-1.0, 1.0] {
        let tip = pos2(x + side * 5.0, room.center().y);
        let back = vec2(-side * 3.0, 3.0);
        painter.line_segment([tip, tip + back], Stroke::new(1.5, colours.accent));
        painter.line_segment([tip, tip + vec2(back.x, -back.y)], Stroke::new(1.5, colours.accent));
    }
}
