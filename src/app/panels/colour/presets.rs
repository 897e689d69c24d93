//! Preset colours, as small pictures.

use egui::{
    ColorImage, Image, RichText, Role, Sense, Stroke, StrokeKind, TextureOptions, Ui, WidgetInfo, vec2,
};

use super::{ColourPanel, shown};
use crate::app::theme::Palette;
use crate::colour::{Group, Marking, PRESETS, Preset};
use crate::document::Colours;

/// Size of a picture, px.
const SIZE: [usize; 2] = [34, 24];

/// Shows the presets; returns the colours of the one that is clicked. `colours`: those of the active layer.
pub fn presets(ui: &mut Ui, panel: &mut ColourPanel, colours: &Colours) -> Option<Colours> {
    let mut chosen = None;
    if panel.samples.is_empty() {
        let sample =
            |preset: &Preset| ui.ctx().load_texture(preset.set.name, picture(preset), TextureOptions::LINEAR);
        panel.samples = PRESETS.iter().map(sample).collect();
    }
    for (group, name) in [(Group::Animal, "Animals"), (Group::Material, "Materials")] {
        ui.label(RichText::new(name).small().weak());
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing = vec2(4.0, 4.0);
            for index in (0..PRESETS.len()).filter(|index| PRESETS[*index].group == group) {
                chosen = chosen.take().or(preset(ui, panel, colours, index));
            }
        });
    }
    chosen
}

fn preset(ui: &mut Ui, panel: &mut ColourPanel, colours: &Colours, index: usize) -> Option<Colours> {
    let preset = &PRESETS[index];
    let own = Colours { ground: colours.ground, halo: colours.halo, ..Colours::from(&preset.set.gradient()) };
    let is_chosen = *colours == own;
    let size = vec2(SIZE[0] as f32, SIZE[1] as f32);
    let (room, response) = ui.allocate_exact_size(size, Sense::click());
    let name = format!("Colours: {}", preset.set.name);
    response.widget_info(|| WidgetInfo::selected(Role::Button, true, is_chosen, &name));
    Image::new(&panel.samples[index]).corner_radius(3).paint_at(ui, room);
    let palette = Palette::current(ui.visuals());
    if is_chosen || response.hovered() || response.has_focus() {
        ui.painter().rect_stroke(room, 3.0, Stroke::new(2.0, palette.accent), StrokeKind::Outside);
    }
    let response = response.on_hover_ui(|ui| {
        ui.label(RichText::new(preset.set.name).strong());
        ui.label(preset.source);
    });
    if response.gained_focus() {
        response.scroll_to_me(None);
    }
    response.clicked().then(|| {
        panel.choose(0, &own);
        own
    })
}

/// A pattern that looks like grown spots or stripes, but is computed from waves.
fn picture(preset: &Preset) -> ColorImage {
    const SHADES: usize = 64;
    let shades = preset.set.gradient().rgbas((0..SHADES).map(|i| i as f32 / (SHADES - 1) as f32));
    let pixel = |x: usize, y: usize| {
        let (x, y) = (x as f32, y as f32);
        let wave = match preset.marking {
            // Three waves that cross at 60°.
            Marking::Spots => {
                let waves = [0.7 * x, 0.35 * x + 0.606 * y, 0.35 * x - 0.606 * y];
                waves.map(f32::cos).into_iter().sum::<f32>() / 2.0 - 0.35
            }
            Marking::Stripes => (0.75 * x + 0.9 * (0.2 * y).sin()).sin() - 0.05,
        };
        // A grown pattern is steep at the edges of its marks.
        let value = (0.5 + 0.9 * wave).clamp(0.0, 1.0);
        shown(shades[(value * (SHADES - 1) as f32).round() as usize])
    };
    let [width, height] = SIZE;
    let pixels = (0..width * height).map(|px| pixel(px % width, px / width)).collect();
    ColorImage::new(SIZE, pixels)
}
