//! The examples: documents inside the program, shown as pictures to choose from.

use egui::{
    Button, ColorImage, Grid, Image, Label, RichText, ScrollArea, TextureHandle, TextureOptions, Ui, vec2,
};

use super::action::Action;
use crate::editor::task::{Task, Tasks, Worker};

/// An example.
pub struct Example {
    /// Its file name without the ending.
    pub name: &'static str,
    /// Its document.
    pub text: &'static str,
    /// A picture of its texture, PNG.
    pub picture: &'static [u8],
}

macro_rules! documents {
    ($folder:literal: $($name:literal),* $(,)?) => {
        &[$(Example {
            name: $name,
            text: include_str!(concat!("../../examples/", $folder, $name, ".dapple")),
            picture: include_bytes!(concat!("../../assets/examples/", $name, ".png")),
        }),*]
    };
}

/// Free examples, in the order of the page.
pub const EXAMPLES: &[Example] = documents![
    "":
    "cheetah-run",
    "bongo",
    "starry-sky",
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

/// Examples drawn after figures of the papers.
pub const GALLERY: &[Example] = documents![
    "gallery/":
    "phan-grimm-01a-turned-dots",
    "phan-grimm-01b-dots-between",
    "phan-grimm-01c-sloping-stripes",
    "phan-grimm-02-growing-spots",
    "phan-grimm-03-turning-spots",
    "phan-grimm-04-far-apart",
    "phan-grimm-05a-yellow-spots",
    "phan-grimm-05b-red-between",
    "phan-grimm-06-stripes",
    "phan-grimm-07a-four-colours-spots",
    "phan-grimm-07b-four-colours-stripes",
    "phan-grimm-08-two-colour-sets",
    "phan-grimm-11-initiators",
    "phan-grimm-12-mixed-spots",
    "phan-grimm-13-leopard",
    "phan-grimm-14-small-inside-large",
    "phan-grimm-16-anisotropic-spots",
    "phan-grimm-17a-changing-spots",
    "phan-grimm-17b-round-a-centre",
    "turk-2-lower-left-cheetah",
    "turk-2-lower-right-leopard",
    "turk-2-upper-left-large-spots",
    "turk-2-upper-right-small-spots",
    "turk-3-lower-left-random-stripes",
    "turk-3-lower-right-lionfish",
    "turk-3-upper-left-irregular-spots",
    "turk-3-upper-right-reticulation",
];

/// The pictures of the examples; they are decoded beside the window when the page is first shown.
#[derive(Default)]
pub struct Gallery {
    textures: Vec<TextureHandle>,
    loading: Option<Task<(usize, ColorImage)>>,
}

impl Gallery {
    /// Shows the page; returns the example that is chosen. Pictures that are not decoded yet are empty.
    pub fn ui(&mut self, ui: &mut Ui, tasks: &Tasks) -> Option<Action> {
        if self.textures.is_empty() {
            self.load(ui, tasks);
        }
        self.listen();
        let (examples, gallery) = self.textures.split_at(EXAMPLES.len());
        let height = (ui.ctx().content_rect().height() - 190.0).clamp(200.0, 700.0);
        let scroll = ScrollArea::vertical().max_height(height).min_scrolled_height(height);
        let shown = scroll.show(ui, |ui| {
            ui.set_width(COLUMNS as f32 * (SIDE + 30.0));
            let example = cards(ui, EXAMPLES, examples);
            ui.add_space(8.0);
            ui.heading("After the papers' figures");
            example.or(cards(ui, GALLERY, gallery))
        });
        shown.inner
    }

    /// Whether pictures are being decoded.
    #[must_use]
    pub fn is_loading(&self) -> bool {
        self.loading.is_some()
    }

    fn load(&mut self, ui: &Ui, tasks: &Tasks) {
        let all = || EXAMPLES.iter().chain(GALLERY).enumerate();
        let empty = |example: &Example| {
            ui.ctx().load_texture(
                example.name,
                ColorImage::filled([1, 1], ui.visuals().faint_bg_color),
                TextureOptions::LINEAR,
            )
        };
        self.textures = all().map(|(_, example)| empty(example)).collect();
        let work = move |worker: &Worker<_>| {
            for (index, example) in all().take_while(|_| !worker.is_cancelled()) {
                worker.send((index, picture(example)));
            }
        };
        self.loading = tasks.start("the pictures of the examples", work).ok();
        if self.loading.is_none() {
            // Without a thread the window waits for them.
            for (index, example) in all() {
                self.textures[index].set(picture(example), TextureOptions::LINEAR);
            }
        }
    }

    fn listen(&mut self) {
        while let Some((index, image)) = self.loading.as_mut().and_then(Task::poll) {
            self.textures[index].set(image, TextureOptions::LINEAR);
        }
        if self.loading.as_ref().is_some_and(Task::has_ended) {
            self.loading = None;
        }
    }
}

/// Pictures a row.
const COLUMNS: usize = 6;

fn cards(ui: &mut Ui, examples: &[Example], textures: &[TextureHandle]) -> Option<Action> {
    let mut chosen = None;
    Grid::new(examples[0].name).spacing(vec2(12.0, 12.0)).show(ui, |ui| {
        for (index, (example, texture)) in examples.iter().zip(textures).enumerate() {
            if card(ui, example, texture) {
                chosen = Some(Action::Example(example.name));
            }
            if index % COLUMNS == COLUMNS - 1 {
                ui.end_row();
            }
        }
    });
    chosen
}

fn card(ui: &mut Ui, example: &Example, texture: &TextureHandle) -> bool {
    let name = example.name.replace('-', " ");
    ui.vertical(|ui| {
        ui.spacing_mut().item_spacing.y = 3.0;
        let picture = Image::new((texture.id(), vec2(SIDE, SIDE))).corner_radius(4);
        let button = ui.add(Button::image(picture));
        let clicked = button.accessible_name(format!("Example: {name}")).on_hover_text(&name).clicked();
        // The papers' names are longer than a picture is wide.
        let short = name.trim_start_matches("phan grimm ").trim_start_matches("turk ");
        ui.allocate_ui(vec2(SIDE + 18.0, 16.0), |ui| {
            ui.vertical_centered(|ui| ui.add(Label::new(RichText::new(short).small()).truncate()));
        });
        clicked
    })
    .inner
}

/// Side of a picture, points.
const SIDE: f32 = 104.0;

fn picture(example: &Example) -> ColorImage {
    let picture = image::load_from_memory(example.picture).unwrap_or_default().into_rgb8();
    let size = [picture.width() as usize, picture.height() as usize];
    ColorImage::from_rgb(size, picture.as_raw())
}
