//! The examples: documents of the program, shown as pictures to choose from.

use egui::{
    Button, Color32, ColorImage, Context, Grid, Image, Label, RichText, ScrollArea, TextureHandle,
    TextureOptions, Ui, vec2,
};

use super::action::Action;
use super::assets::{self, Asset, asset, document};
use super::small_screen::is_small;
use crate::editor::task::{Task, Tasks, Worker};

/// An example.
pub struct Example {
    /// Its file name without the ending.
    pub name: &'static str,
    /// What it shows.
    pub title: &'static str,
    /// The figure that it is drawn after; empty where there is none.
    pub source: &'static str,
    /// Its document.
    pub document: Asset,
    /// A picture of its texture.
    pub picture: Asset,
}

macro_rules! documents {
    ($folder:literal: $($name:literal $title:literal $source:literal),* $(,)?) => {
        &[$(Example {
            name: $name,
            title: $title,
            source: $source,
            document: document!($folder, $name),
            picture: asset!("examples", $name),
        }),*]
    };
}

/// Free examples, in the order of the page: animals first.
pub const EXAMPLES: &[Example] = documents![
    "examples":
    "cheetah-run" "Cheetah" "",
    "zebra" "Zebra" "",
    "plains-zebra" "Plains zebra" "",
    "zebra-drift" "Drifting zebra" "",
    "tiger" "Tiger" "",
    "bongo" "Bongo" "",
    "holstein" "Holstein" "",
    "masai-giraffe" "Masai giraffe (seamless)" "",
    "reticulated-giraffe" "Giraffe cells (seamless)" "",
    "serval" "Serval" "",
    "spotted-hyena" "Spotted hyena" "",
    "brindle" "Brindle" "",
    "fallow-deer" "Fallow deer" "",
    "ladybird" "Ladybird" "",
    "dart-frog" "Dart frog" "",
    "dart-frog-skin" "Dart frog's skin" "",
    "reptile" "Reptile" "",
    "whale-shark" "Whale shark" "",
    "guinea-fowl" "Guinea fowl" "",
    "arctic-char" "Arctic char" "",
    "mackerel" "Mackerel" "",
    "starry-sky" "Starry sky" "",
    "river-stones" "River stones" "",
    "pebbles" "Pebbles" "",
    "willow-leaves" "Willow leaves" "",
    "barley" "Barley" "",
    "poppy-seeds" "Poppy seeds" "",
    "wood-grain" "Wood grain" "",
    "sand-ripples" "Sand ripples" "",
    "basket" "Basket" "",
    "maze" "Maze (seamless)" "",
    "parquet" "Parquet" "",
    "stucco" "Stucco (seamless)" "",
    "cracked-mud" "Cracked mud (seamless)" "",
    "portrait" "Portrait" "",
    "stipples" "Stipples" "",
    "camouflage" "Camouflage (seamless)" "",
    "tile-petals" "Petals (seamless)" "",
    "tile-waves" "Waves (seamless)" "",
    "turned-ellipses" "Turned ellipses" "",
    "growing-spots" "Growing spots" "",
    "turning-spots" "Turning spots" "",
    "sloping-lines" "Sloping lines" "",
    "line-stripes" "Stripes from lines" "",
];

/// Coats with a finish, in the order of the page.
pub const COATS: &[Example] = documents![
    "examples/coats":
    "leopard-coat" "Leopard (fur)" "",
    "jaguar-coat" "Jaguar (fur)" "",
    "ocelot-coat" "Ocelot (fur)" "",
    "cheetah-coat" "Cheetah (fur)" "",
    "tiger-coat" "Tiger (fur)" "",
    "plains-zebra-coat" "Plains zebra (fur)" "",
    "masai-giraffe-coat" "Masai giraffe (fur)" "",
    "reticulated-giraffe-coat" "Reticulated giraffe (fur)" "",
    "holstein-coat" "Holstein (fur)" "",
    "tabby-coat" "Tabby (fur)" "",
    "spotted-hyena-coat" "Spotted hyena (fur)" "",
    "whale-shark-coat" "Whale shark (skin)" "",
    "reef-fish-coat" "Reef fish (scales)" "",
    "ball-python-coat" "Ball python (scales)" "",
    "gecko-coat" "Leopard gecko (skin)" "",
    "denim" "Denim (twill)" "",
    "linoleum" "Linoleum (leather)" "",
];

/// Examples drawn after figures of the papers, in the order of the page.
pub const GALLERY: &[Example] = documents![
    "examples/gallery":
    "turk-2-lower-right-leopard" "Leopard" "Turk, fig. 2",
    "turk-3-upper-right-reticulation" "Giraffe" "Turk, fig. 3",
    "turk-3-lower-right-lionfish" "Lionfish" "Turk, fig. 3",
    "phan-grimm-13-leopard" "Leopard" "Phan & Grimm, fig. 13",
    "turk-2-lower-left-cheetah" "Cheetah" "Turk, fig. 2",
    "phan-grimm-07a-four-colours-spots" "Spots, four colours" "Phan & Grimm, fig. 7a",
    "phan-grimm-07b-four-colours-stripes" "Stripes, four colours" "Phan & Grimm, fig. 7b",
    "phan-grimm-08-two-colour-sets" "Two colour sets" "Phan & Grimm, fig. 8",
    "phan-grimm-11-initiators" "Radiating stripes" "Phan & Grimm, fig. 11",
    "phan-grimm-17b-round-a-centre" "Round a centre" "Phan & Grimm, fig. 17b",
    "phan-grimm-17a-changing-spots" "Changing spots" "Phan & Grimm, fig. 17a",
    "turk-3-lower-left-random-stripes" "Random stripes" "Turk, fig. 3",
    "turk-3-upper-left-irregular-spots" "Irregular spots" "Turk, fig. 3",
    "turk-2-upper-left-large-spots" "Large spots" "Turk, fig. 2",
    "turk-2-upper-right-small-spots" "Small spots" "Turk, fig. 2",
    "phan-grimm-01a-turned-dots" "Turned dots" "Phan & Grimm, fig. 1a",
    "phan-grimm-01b-dots-between" "Dots between" "Phan & Grimm, fig. 1b",
    "phan-grimm-01c-sloping-stripes" "Sloping stripes" "Phan & Grimm, fig. 1c",
    "phan-grimm-02-growing-spots" "Growing spots" "Phan & Grimm, fig. 2",
    "phan-grimm-03-turning-spots" "Turning spots" "Phan & Grimm, fig. 3",
    "phan-grimm-04-far-apart" "Spots far apart" "Phan & Grimm, fig. 4",
    "phan-grimm-05a-yellow-spots" "Yellow spots" "Phan & Grimm, fig. 5a",
    "phan-grimm-05b-red-between" "Red between" "Phan & Grimm, fig. 5b",
    "phan-grimm-06-stripes" "Stripes" "Phan & Grimm, fig. 6",
    "phan-grimm-12-mixed-spots" "Mixed spots" "Phan & Grimm, fig. 12",
    "phan-grimm-14-small-inside-large" "Small in large" "Phan & Grimm, fig. 14",
    "phan-grimm-16-anisotropic-spots" "Long spots" "Phan & Grimm, fig. 16",
];

/// The pictures of the examples; they are decoded on another thread when the page is first shown.
#[derive(Default)]
pub struct Gallery {
    textures: Vec<TextureHandle>,
    loading: Option<Task<(usize, ColorImage)>>,
}

impl Gallery {
    /// Shows the page; returns the example that was clicked. Pictures that are not decoded yet are empty.
    pub fn ui(&mut self, ui: &mut Ui, tasks: &Tasks) -> Option<Action> {
        if self.textures.is_empty() {
            self.load(ui, tasks);
        }
        self.listen();
        let (examples, others) = self.textures.split_at(EXAMPLES.len());
        let (coats, gallery) = others.split_at(COATS.len());
        let height = (ui.ctx().content_rect().height() - 190.0).clamp(200.0, 700.0);
        let scroll = ScrollArea::vertical().max_height(height).min_scrolled_height(height);
        let shown = scroll.show(ui, |ui| {
            ui.set_width(columns(ui.ctx()) as f32 * CELL);
            let example = cards(ui, EXAMPLES, examples);
            ui.add_space(8.0);
            ui.heading("Coats, with fur, scales, skin");
            let coat = cards(ui, COATS, coats);
            ui.add_space(8.0);
            ui.heading("From the papers");
            example.or(coat).or(cards(ui, GALLERY, gallery))
        });
        shown.inner
    }

    /// Whether pictures are being decoded.
    #[must_use]
    pub fn is_loading(&self) -> bool {
        self.loading.is_some()
    }

    fn load(&mut self, ui: &Ui, tasks: &Tasks) {
        let all = || all().enumerate();
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
            // Where no thread can be started, the window blocks until they are decoded.
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

/// All examples, in the order of the page.
fn all() -> impl Iterator<Item = &'static Example> {
    EXAMPLES.iter().chain(COATS).chain(GALLERY)
}

/// The example of this name.
pub fn named(name: &str) -> Option<&'static Example> {
    all().find(|example| example.name == name)
}

/// The picture of an example, for use outside of the page; `None` where there is no example of this name.
pub fn thumbnail(ctx: &Context, name: &str) -> Option<TextureHandle> {
    assets::texture(ctx, named(name)?.picture)
}

/// The largest number of pictures in a row.
const COLUMNS: usize = 6;
/// Width of a picture with what is around it, points.
const CELL: f32 = SIDE + 30.0;

/// The number of pictures in a row: fewer on a small screen.
fn columns(ctx: &Context) -> usize {
    let fit = (ctx.content_rect().width() - 40.0) / CELL;
    if is_small(ctx) { (fit as usize).clamp(1, COLUMNS) } else { COLUMNS }
}

fn cards(ui: &mut Ui, examples: &[Example], textures: &[TextureHandle]) -> Option<Action> {
    let mut chosen = None;
    let columns = columns(ui.ctx());
    Grid::new(examples[0].name).spacing(vec2(12.0, 12.0)).show(ui, |ui| {
        for (index, (example, texture)) in examples.iter().zip(textures).enumerate() {
            if card(ui, example, texture) {
                chosen = Some(Action::Example(example.name));
            }
            if index % columns == columns - 1 {
                ui.end_row();
            }
        }
    });
    chosen
}

fn card(ui: &mut Ui, example: &Example, texture: &TextureHandle) -> bool {
    ui.vertical(|ui| {
        ui.spacing_mut().item_spacing.y = 3.0;
        let picture = Image::new((texture.id(), vec2(SIDE, SIDE))).corner_radius(4);
        let button = ui.add(Button::image(picture));
        let clicked = button.accessible_name(format!("Example: {}", example.title)).clicked();
        for text in [RichText::new(example.title).small(), RichText::new(example.source).small().weak()] {
            if !text.is_empty() {
                ui.allocate_ui(vec2(SIDE + 18.0, 16.0), |ui| {
                    ui.vertical_centered(|ui| ui.add(Label::new(text).truncate()));
                });
            }
        }
        clicked
    })
    .inner
}

/// Side of a picture, points.
const SIDE: f32 = 104.0;

/// The picture of an example; an empty one where it cannot be loaded.
fn picture(example: &Example) -> ColorImage {
    assets::image(example.picture).unwrap_or_else(|_| ColorImage::filled([1, 1], Color32::TRANSPARENT))
}
