//! Examples, as a menu of pictures.

use eframe::egui::{Button, ColorImage, Grid, Image, ScrollArea, TextureHandle, TextureOptions, Ui, vec2};

use super::action::Action;

/// An example.
pub struct Example {
    /// Its file's name without the ending.
    pub name: &'static str,
    /// Its document.
    pub text: &'static str,
    /// A picture of what grows from it.
    pub picture: &'static [u8],
}

macro_rules! examples {
    ($($name:literal),* $(,)?) => {
        /// All of them, in the order of the menu.
        pub const EXAMPLES: &[Example] = &[$(Example {
            name: $name,
            text: include_str!(concat!("../../examples/", $name, ".dapple")),
            picture: include_bytes!(concat!("../../assets/examples/", $name, ".png")),
        }),*];
    };
}

examples![
    "cheetah-run",
    "zebra",
    "tiger",
    "fallow-deer",
    "ladybird",
    "whale-shark",
    "dart-frog",
    "guinea-fowl",
    "arctic-char",
    "mackerel",
    "pebbles",
    "river-stones",
    "willow-leaves",
    "barley",
    "poppy-seeds",
    "wood-grain",
    "sand-ripples",
    "turned-ellipses",
    "growing-spots",
    "turning-spots",
    "sloping-lines",
    "line-stripes",
    "tile-petals",
    "tile-waves",
];

/// The pictures, once they were shown.
#[derive(Default)]
pub struct Gallery(Vec<TextureHandle>);

impl Gallery {
    /// The menu. Gives what is chosen.
    pub fn ui(&mut self, ui: &mut Ui) -> Option<Action> {
        if self.0.is_empty() {
            self.0 = EXAMPLES.iter().map(|example| load(ui, example)).collect();
        }
        let mut chosen = None;
        ScrollArea::vertical().max_height(570.0).show(ui, |ui| {
            Grid::new("examples").spacing(vec2(12.0, 12.0)).show(ui, |ui| {
                for (index, (example, texture)) in EXAMPLES.iter().zip(&self.0).enumerate() {
                    if card(ui, example, texture) {
                        chosen = Some(Action::Example(example.name));
                    }
                    if index % 6 == 5 {
                        ui.end_row();
                    }
                }
            });
        });
        chosen
    }
}

fn card(ui: &mut Ui, example: &Example, texture: &TextureHandle) -> bool {
    let name = example.name.replace('-', " ");
    ui.vertical(|ui| {
        ui.spacing_mut().item_spacing.y = 3.0;
        let picture = Image::new((texture.id(), vec2(SIDE, SIDE))).corner_radius(4);
        let button = ui.add(Button::image(picture));
        let clicked = button.accessible_name(format!("Example: {name}")).on_hover_text(&name).clicked();
        ui.vertical_centered(|ui| ui.small(&name));
        clicked
    })
    .inner
}

/// Side of a picture, points.
const SIDE: f32 = 104.0;

fn load(ui: &Ui, example: &Example) -> TextureHandle {
    let picture = image::load_from_memory(example.picture).unwrap_or_default().into_rgb8();
    let size = [picture.width() as usize, picture.height() as usize];
    let image = ColorImage::from_rgb(size, picture.as_raw());
    ui.ctx().load_texture(example.name, image, TextureOptions::LINEAR)
}
