//! The lit preview of a material: on a plane, a sphere or a cylinder that can be turned.

use std::sync::Arc;

use egui::{
    Color32, ColorImage, Id, Key, Rect, Response, Sense, TextureHandle, TextureOptions, Ui, Vec2, WidgetInfo,
    accesskit::Role, pos2,
};

use crate::editor::task::{Task, Tasks, Worker};
use crate::export::material::Map;
use crate::synth::render::lit::{Body, Maps, Pictures, Pose, render};

/// The name of the lit view among those of the maps.
pub const LIT: &str = "Lit";
/// The largest side of the view, px of the screen.
const MOST: f32 = 720.0;
/// The rotation by one press of an arrow key, as a drag of this many points.
const STEP: f32 = 20.0;
/// The magnification by one press of a key, and by a turn of the wheel that would scroll this many points.
const ZOOM: f32 = 1.25;
const WHEEL: f32 = 200.0;

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

/// What is rendered: which maps, how, at which size.
#[derive(Clone)]
struct Wanted {
    maps: Arc<Maps>,
    body: Body,
    pose: Pose,
    /// Side of the picture, px.
    side: usize,
    /// Rays a px, along each side.
    samples: usize,
}

impl Wanted {
    fn render(&self) -> ColorImage {
        let pixels = render(&self.maps, self.body, self.pose, self.side, self.samples);
        ColorImage::from_rgba_unmultiplied([self.side, self.side], &pixels)
    }

    fn is(&self, other: &Self) -> bool {
        let how = |wanted: &Self| (wanted.body, wanted.pose, wanted.side, wanted.samples);
        Arc::ptr_eq(&self.maps, &other.maps) && how(self) == how(other)
    }
}

/// The view.
#[derive(Default)]
pub struct LitView {
    /// The body.
    pub body: Body,
    pose: Pose,
    /// What the texture shows.
    shown: Option<Wanted>,
    texture: Option<TextureHandle>,
    /// The view that is being rendered on another thread.
    rendering: Option<(Wanted, Task<ColorImage>)>,
}

impl LitView {
    /// Shows the last rendered view of the material in `room`. A drag or the arrow keys turn the body, the wheel or + and −
    /// magnify it, a double click shows it as at first.
    pub fn ui(&mut self, ui: &Ui, room: Rect, maps: &Arc<Maps>, tasks: &Tasks) {
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
        self.pose = self.pose.zoomed(zoom(ui, &response));
        if response.double_clicked() {
            self.pose = Pose::default();
        }
        let points = room.width().min(room.height());
        let side = (points * ui.pixels_per_point()).min(MOST).round().max(16.0) as usize;
        // Fewer rays while the body turns, so that the view follows the pointer; all rays once it rests.
        let samples = if response.dragged() { 1 } else { 2 };
        self.listen(ui);
        let wanted = Wanted { maps: Arc::clone(maps), body: self.body, pose: self.pose, side, samples };
        self.follow(ui, wanted, tasks);
        let painter = ui.painter_at(room);
        painter.rect_filled(room, 4.0, Color32::from_gray(64));
        if let Some(texture) = &self.texture {
            let square = Rect::from_center_size(room.center(), Vec2::splat(points));
            let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
            painter.image(texture.id(), square, whole, Color32::WHITE);
        }
        response
            .on_hover_cursor(egui::CursorIcon::Grab)
            .on_hover_text(
                "Drag to turn the body, or use the arrow keys; wheel, + and − magnify it; double-click to show it as at first",
            );
    }

    /// Whether it is being rendered.
    #[must_use]
    pub fn is_rendering(&self) -> bool {
        self.rendering.is_some()
    }

    /// Starts to render `wanted` once the view before it is finished and shown, so that a turning body is shown in as
    /// many steps as can be rendered.
    fn follow(&mut self, ui: &Ui, wanted: Wanted, tasks: &Tasks) {
        if self.rendering.is_some() || self.shown.as_ref().is_some_and(|shown| shown.is(&wanted)) {
            return;
        }
        let now = wanted.clone();
        match tasks.start("the lit preview", move |worker: &Worker<_>| worker.send(now.render())) {
            Ok(task) => self.rendering = Some((wanted, task)),
            // Where no thread can be started, the window blocks until the view is rendered.
            Err(_) => {
                let image = wanted.render();
                self.show(ui, wanted, image);
            }
        }
    }

    fn listen(&mut self, ui: &Ui) {
        let Some((_, task)) = &mut self.rendering else { return };
        let image = task.poll();
        if image.is_none() && !task.has_ended() {
            return;
        }
        if let (Some((wanted, _)), Some(image)) = (self.rendering.take(), image) {
            self.show(ui, wanted, image);
        }
    }

    fn show(&mut self, ui: &Ui, wanted: Wanted, image: ColorImage) {
        self.shown = Some(wanted);
        match &mut self.texture {
            Some(texture) => texture.set(image, TextureOptions::LINEAR),
            None => self.texture = Some(ui.ctx().load_texture("lit", image, TextureOptions::LINEAR)),
        }
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

/// The magnification that the wheel, two fingers or keys ask for, as a factor.
fn zoom(ui: &Ui, response: &Response) -> f32 {
    let keys = ui.input(|input| {
        let pressed = |key| input.num_presses(key) as f32;
        pressed(Key::Plus) + pressed(Key::Equals) - pressed(Key::Minus)
    });
    let by_keys = if response.has_focus() { ZOOM.powf(keys) } else { 1.0 };
    if !response.contains_pointer() {
        return by_keys;
    }
    let (scroll, pinch) = ui.input(|input| (input.smooth_scroll_delta().y, input.zoom_delta()));
    by_keys * pinch * (scroll / WHEEL).exp()
}

/// The rotation that the arrow keys ask for, points.
fn arrows(ui: &Ui) -> Vec2 {
    ui.input(|input| {
        let pressed = |key| input.num_presses(key) as f32;
        STEP * egui::vec2(
            pressed(Key::ArrowRight) - pressed(Key::ArrowLeft),
            pressed(Key::ArrowDown) - pressed(Key::ArrowUp),
        )
    })
}

#[cfg(test)]
mod tests {
    use std::io;
    use std::sync::Mutex;

    use super::*;
    use crate::editor::task::{Body as Work, Spawn};
    use crate::machine::threads::{self, JoinHandle};

    /// The work that was to run on threads.
    static HELD: Mutex<Vec<Work>> = Mutex::new(Vec::new());

    fn hold(name: &'static str, work: Work) -> io::Result<JoinHandle<()>> {
        HELD.lock().unwrap().push(work);
        threads::start(name, || {})
    }

    /// Does the held work; returns how many pieces it was.
    fn done() -> usize {
        HELD.lock().unwrap().drain(..).map(|work| work()).count()
    }

    fn flat() -> Arc<Maps> {
        let pictures = Pictures {
            size: [4, 4],
            colour: &|_| [120, 120, 120, 255],
            normal: &|_| [128, 128, 255],
            roughness: &|_| 255,
            occlusion: &|_| 255,
        };
        Arc::new(Maps::new(&pictures, true))
    }

    #[test]
    fn the_wheel_and_keys_magnify_the_body_and_a_double_click_shows_it_as_at_first() {
        let (maps, tasks) = (flat(), Tasks::default());
        let room = Rect::from_min_size(pos2(0.0, 0.0), Vec2::splat(64.0));
        let show = move |ui: &mut Ui, view: &mut LitView| view.ui(ui, room, &maps, &tasks);
        // Two clicks are a double click within 0.3 s.
        let builder = egui_kittest::Harness::builder().with_step_dt(1.0 / 60.0);
        let mut harness = builder.build_ui_state(show, LitView::default());
        let zoom = |harness: &egui_kittest::Harness<'_, LitView>| harness.state().pose.zoom;
        harness.hover_at(pos2(30.0, 30.0));
        harness.run_steps(2);
        harness.event(egui::Event::MouseWheel {
            unit: egui::MouseWheelUnit::Point,
            delta: egui::vec2(0.0, 80.0),
            phase: egui::TouchPhase::Move,
            modifiers: egui::Modifiers::NONE,
            source: egui::MouseWheelSource::Wheel,
        });
        harness.run_steps(30);
        let by_wheel = zoom(&harness);
        assert!(by_wheel > 1.2, "{by_wheel}");
        for _ in 0..2 {
            harness.drag_at(pos2(30.0, 30.0));
            harness.drop_at(pos2(30.0, 30.0));
            harness.run_steps(1);
        }
        assert_eq!(harness.state().pose, Pose::default());
        harness.key_press(Key::Plus);
        harness.run_steps(2);
        assert_eq!(zoom(&harness), ZOOM, "the click gave it the focus");
    }

    #[test]
    fn the_last_view_is_shown_until_a_thread_has_rendered_the_next_one() {
        let tasks = Tasks::default().with_spawn(Spawn(hold));
        let maps = flat();
        let poses =
            [Pose::default(), Pose::default().turned([40.0, 0.0]), Pose::default().turned([80.0, 0.0])];
        let mut view = LitView::default();
        let mut shown = |pose: Pose| {
            let mut shown = None;
            egui::__run_test_ui(|ui| {
                view.pose = pose;
                view.ui(ui, Rect::from_min_size(pos2(0.0, 0.0), Vec2::splat(64.0)), &maps, &tasks);
                shown = view.shown.as_ref().map(|shown| shown.pose);
                assert_eq!(view.texture.is_some(), shown.is_some());
            });
            shown
        };
        assert_eq!(shown(poses[0]), None);
        assert_eq!(done(), 1);
        assert_eq!((shown(poses[0]), done()), (Some(poses[0]), 0));
        assert_eq!(shown(poses[1]), Some(poses[0]), "the window does not wait for the render");
        assert_eq!(shown(poses[2]), Some(poses[0]));
        assert_eq!(done(), 1, "one render at a time");
        assert_eq!(shown(poses[2]), Some(poses[1]));
        assert_eq!(done(), 1);
        assert_eq!(shown(poses[2]), Some(poses[2]));
    }
}
