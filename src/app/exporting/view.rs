//! The preview on the screen: a picture over a checkerboard, fitted or at actual size; a film that plays.

use std::sync::Arc;

use egui::{
    Color32, ColorImage, Id, Rect, Response, Sense, Slider, Stroke, StrokeKind, TextureHandle,
    TextureOptions, Ui, Vec2, WidgetInfo, accesskit::Role, pos2, vec2,
};
use image::{RgbaImage, imageops};

use super::lit::LitView;
use super::preview::FinishedPreview;
use crate::app::checkerboard;
use crate::app::theme::Palette;

/// What is shown, and how.
#[derive(Default)]
pub struct View {
    /// The name of the picture that is shown.
    pub chosen: String,
    /// Whether a px of the picture is shown as a px of the screen.
    pub close: bool,
    /// The centre of the visible part at actual size, as a share 0..1 of the picture.
    center: Vec2,
    /// The content of the texture: which preview, which picture or frame, and whether its px are shown without
    /// interpolation.
    held: Option<(usize, usize, bool)>,
    texture: Option<TextureHandle>,
    /// The time in the film, seconds.
    pub time: f64,
    /// Whether the film plays.
    pub plays: bool,
    /// The lit view of a material.
    pub lit: LitView,
}

impl View {
    /// A view of a whole picture, or a film that plays.
    #[must_use]
    pub fn new() -> Self {
        Self { plays: true, center: vec2(0.5, 0.5), ..Self::default() }
    }

    fn show(
        &mut self,
        ui: &Ui,
        made: &Arc<FinishedPreview>,
        (index, image): (usize, &ColorImage),
        scale: f32,
    ) {
        // Interpolates only where several px share one px of the screen.
        let sharp = scale * ui.pixels_per_point() >= 1.0;
        let what = (Arc::as_ptr(made) as usize, index, sharp);
        if self.held == Some(what) {
            return;
        }
        self.held = Some(what);
        let options = if sharp { TextureOptions::NEAREST } else { TextureOptions::LINEAR };
        let image = fitting(image, ui.input(|input| input.max_texture_side));
        match &mut self.texture {
            Some(texture) => texture.set(image, options),
            None => self.texture = Some(ui.ctx().load_texture("export", image, options)),
        }
    }

    /// Shows the preview in `room`. It is paler where it is not up to date (not `fresh`).
    pub fn ui(&mut self, ui: &mut Ui, room: Rect, made: &Arc<FinishedPreview>, fresh: bool) -> Response {
        let frames = made.frames();
        let (index, image) = if frames.is_empty() {
            let pictures = made.pictures();
            let index = pictures.iter().position(|(name, _)| *name == self.chosen).unwrap_or(0);
            (index, pictures.get(index).map(|(_, image)| image))
        } else {
            let index = self.frame(ui, frames);
            (index, frames.get(index).map(|(image, _)| image))
        };
        let response = ui.interact(room, Id::unique("export preview"), Sense::click_and_drag());
        let Some(image) = image else { return response };
        let size = vec2(image.size[0] as f32, image.size[1] as f32);
        let fit = (room.width() / size.x).min(room.height() / size.y);
        let close = 1.0 / ui.pixels_per_point();
        let scale = if self.close { close } else { fit.min(4.0 * close) };
        self.show(ui, made, (index, image), scale);
        let seen = size * scale;
        if response.clicked() {
            self.close = !self.close;
            if let Some(at) = response.interact_pointer_pos() {
                let place = (at - (room.center() - seen / 2.0)) / seen;
                self.center = place.clamp(Vec2::ZERO, Vec2::splat(1.0));
            }
        } else if response.dragged() && self.close {
            self.center = (self.center - response.drag_delta() / seen).clamp(Vec2::ZERO, Vec2::splat(1.0));
        }
        let center = if self.close { self.within(room, seen) } else { vec2(0.5, 0.5) };
        let rect = Rect::from_min_size(room.center() - center * seen, seen);
        self.paint(ui, room, rect, fresh);
        let what = if frames.is_empty() { "Preview" } else { "Preview of the film" };
        response.widget_info(|| WidgetInfo::labeled(Role::Image, true, what));
        response.on_hover_text_at_pointer(if self.close {
            "Click to show all of it; drag to move"
        } else {
            "Click to show it at actual size"
        })
    }

    /// The centre of the visible part, limited so that the room is filled as far as possible.
    fn within(&self, room: Rect, seen: Vec2) -> Vec2 {
        let side = |center: f32, room: f32, seen: f32| {
            let half = (room / seen / 2.0).min(0.5);
            center.clamp(half, 1.0 - half)
        };
        vec2(side(self.center.x, room.width(), seen.x), side(self.center.y, room.height(), seen.y))
    }

    fn paint(&mut self, ui: &Ui, room: Rect, rect: Rect, fresh: bool) {
        let painter = ui.painter_at(room.expand(1.0));
        let whole = Rect::from_min_size(pos2(0.0, 0.0), vec2(1.0, 1.0));
        let shown = rect.intersect(room);
        checkerboard::paint(&painter, shown);
        if let Some(texture) = &self.texture {
            let tint = if fresh { Color32::WHITE } else { Color32::WHITE.gamma_multiply(0.5) };
            painter.with_clip_rect(room).image(texture.id(), rect, whole, tint);
        }
        let border = Palette::current(ui.visuals()).border;
        painter.rect_stroke(shown, 0.0, Stroke::new(1.0, border), StrokeKind::Outside);
    }

    /// The index of the current frame.
    fn frame(&mut self, ui: &Ui, frames: &[(ColorImage, f64)]) -> usize {
        let length: f64 = frames.iter().map(|(_, seconds)| seconds).sum();
        if self.plays {
            self.time =
                (self.time + f64::from(ui.input(|input| input.stable_dt.min(0.2)))) % length.max(1e-3);
        }
        let mut ends = 0.0;
        let mut left = 0.0;
        let shown = frames.iter().position(|(_, seconds)| {
            ends += seconds;
            left = ends - self.time;
            left > 0.0
        });
        if self.plays {
            ui.ctx().request_repaint_after_secs(left.clamp(0.01, 1.0) as f32);
        }
        shown.unwrap_or(frames.len().saturating_sub(1))
    }

    /// The controls of a film: play, and the time.
    pub fn player(&mut self, ui: &mut Ui, made: &FinishedPreview) {
        let length: f64 = made.frames().iter().map(|(_, seconds)| seconds).sum();
        let text = if self.plays { "Pause film" } else { "Play film" };
        if ui.small_button(text).clicked() {
            self.plays = !self.plays;
        }
        ui.spacing_mut().slider_width = (ui.available_width() - 70.0).max(60.0);
        let slider = Slider::new(&mut self.time, 0.0..=length).fixed_decimals(1).suffix(" s");
        let slider = ui.add(slider);
        slider.widget_info(|| WidgetInfo::slider(true, self.time, "Snapshot of the film"));
        if slider.dragged() || slider.changed() {
            self.plays = false;
        }
    }
}

/// The picture, smaller where a side is longer than the `most` px that the graphics card takes.
fn fitting(image: &ColorImage, most: usize) -> ColorImage {
    let longest = image.size[0].max(image.size[1]);
    if longest <= most {
        return image.clone();
    }
    let size = image.size.map(|side| (side * most / longest).max(1));
    let [[wide, high], [width, height]] = [image.size, size].map(|size| size.map(|side| side as u32));
    let bytes = image.pixels.iter().flat_map(Color32::to_array).collect();
    let whole = RgbaImage::from_raw(wide, high, bytes).expect("four bytes a px");
    ColorImage::from_rgba_premultiplied(size, imageops::thumbnail(&whole, width, height).as_raw())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_too_large_for_the_graphics_card_is_reduced_and_others_are_not() {
        let halves = |px: usize| if px % 6 < 3 { Color32::BLACK } else { Color32::WHITE };
        let image = ColorImage::new([6, 4], (0..24).map(halves).collect());
        assert_eq!(fitting(&image, 6), image);
        let reduced = fitting(&image, 2);
        assert_eq!((reduced.size, reduced.pixels), ([2, 1], vec![Color32::BLACK, Color32::WHITE]));
    }
}
