//! The lit preview of a material: on a plane, a sphere or a cylinder that can be turned.

use egui::{
    Color32, ColorImage, Id, Key, Rect, Sense, TextureHandle, TextureOptions, Ui, Vec2, WidgetInfo,
    accesskit::Role, pos2,
};

use crate::export::material::Map;
use crate::synth::render::lit::{Body, Maps, Pictures, Pose, render};

/// The name of the lit view among those of the maps.
pub const LIT: &str = "Lit";
/// The largest side of the view, px of the screen.
const MOST: f32 = 720.0;
/// Points that an arrow key turns by.
const STEP: f32 = 20.0;

/// The maps that are lit, from the pictures of a material and their names; `None` where one is missing.
pub fn maps(pictures: &[(String, ColorImage)], wraps: bool) -> Option<Maps> {
    let of = |map: Map| pictures.iter().find(|(name, _)| name == map.suffix()).map(|(_, image)| image);
    let [colour, normal, roughness, occlusion] =
        [Map::BaseColour, Map::NormalGl, Map::Roughness, Map::Occlusion].map(of);
    let (colour, normal, roughness, occlusion) = (colour?, normal?, roughness?, occlusion?);
    let is_alike = [normal, roughness, occlusion].iter().all(|image| image.size == colour.size);
    is_alike.then(|| {
        let rgb = |image: &ColorImage, px: usize| {
            let [red, green, blue, _] = image.pixels[px].to_array();
            [red, green, blue]
        };
        let pictures = Pictures {
            size: colour.size,
            colour: &|px| colour.pixels[px].to_srgba_unmultiplied(),
            normal: &|px| rgb(normal, px),
            roughness: &|px| roughness.pixels[px].r(),
            occlusion: &|px| occlusion.pixels[px].r(),
        };
        Maps::new(&pictures, wraps)
    })
}

/// What was rendered last: which preview, how, at which size.
type Rendered = (usize, Body, Pose, usize, usize);

/// The view.
#[derive(Default)]
pub struct LitView {
    /// The body.
    pub body: Body,
    pose: Pose,
    rendered: Option<Rendered>,
    texture: Option<TextureHandle>,
}

impl LitView {
    /// Shows the material in `room`; a drag or the arrow keys turn it, a double click turns it back.
    ///
    /// `made`: a number that differs from preview to preview.
    pub fn ui(&mut self, ui: &Ui, room: Rect, made: usize, maps: &Maps) {
        let response = ui.interact(room, Id::unique("lit preview"), Sense::click_and_drag());
        let what = format!("Lit preview, {}", name(self.body));
        response.widget_info(|| WidgetInfo::labeled(Role::Image, true, &what));
        let by = response.drag_delta() + if response.has_focus() { arrows(ui) } else { Vec2::ZERO };
        if response.clicked() || response.drag_started() {
            response.request_focus();
        }
        if by != Vec2::ZERO {
            self.pose = self.pose.turned(by.into());
        }
        if response.double_clicked() {
            self.pose = Pose::default();
        }
        let points = room.width().min(room.height());
        let side = (points * ui.pixels_per_point()).min(MOST).round().max(16.0) as usize;
        // While it turns, fewer rays: it follows the hand. Once more with all of them when it rests.
        let samples = if response.dragged() { 1 } else { 2 };
        let wanted = (made, self.body, self.pose, side, samples);
        if self.rendered != Some(wanted) {
            self.rendered = Some(wanted);
            let pixels = render(maps, self.body, self.pose, side, samples);
            let image = ColorImage::from_rgba_unmultiplied([side, side], &pixels);
            match &mut self.texture {
                Some(texture) => texture.set(image, TextureOptions::LINEAR),
                None => self.texture = Some(ui.ctx().load_texture("lit", image, TextureOptions::LINEAR)),
            }
        }
        let painter = ui.painter_at(room);
        painter.rect_filled(room, 4.0, Color32::from_gray(64));
        if let Some(texture) = &self.texture {
            let square = Rect::from_center_size(room.center(), Vec2::splat(points));
            let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
            painter.image(texture.id(), square, whole, Color32::WHITE);
        }
        response
            .on_hover_cursor(egui::CursorIcon::Grab)
            .on_hover_text("Drag to turn it, or use the arrow keys; double-click to turn it back");
    }

    /// The choice of the body.
    pub fn bodies(&mut self, ui: &mut Ui) {
        for (body, name) in Body::ALL {
            ui.selectable_value(&mut self.body, body, name);
        }
    }
}

fn name(body: Body) -> &'static str {
    Body::ALL.iter().find(|(other, _)| *other == body).map_or("", |(_, name)| name)
}

/// The turn that the arrow keys ask for, points.
fn arrows(ui: &Ui) -> Vec2 {
    ui.input(|input| {
        let pressed = |key| input.num_presses(key) as f32;
        STEP * egui::vec2(
            pressed(Key::ArrowRight) - pressed(Key::ArrowLeft),
            pressed(Key::ArrowDown) - pressed(Key::ArrowUp),
        )
    })
}
