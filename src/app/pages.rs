//! Pages over the window: the new document, the question about unsaved work, about, the first hint.

use egui::{Button, Checkbox, Grid, RichText, Ui, vec2};

use super::action::{Action, Page};
use super::fields::{DPI, REGIONS, SEAMLESS, SIDES, regions, resolution, sides};
use super::small_screen::{fit_width, is_small};
use crate::document::{Document, limits};
use crate::editor::units::{Ruler, Units};
use crate::grid::Edges;
use crate::marks::Mark;

/// The properties of a new document.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct New {
    /// Width and height, px.
    pub size: [u32; 2],
    /// Columns and rows of regions; `None` = free marks.
    pub regions: Option<[u32; 2]>,
    /// Whether it is a seamless tile.
    pub seamless: bool,
    /// Resolution, dots per inch.
    pub dpi: f64,
}

impl Default for New {
    fn default() -> Self {
        Self { size: [512, 512], regions: None, seamless: false, dpi: 300.0 }
    }
}

/// The answer to a question.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Answer {
    /// Yes; the first choice.
    Yes,
    /// No; the second choice.
    No,
    /// The third choice, where there is one.
    Third,
    /// Cancel.
    Cancel,
}

impl New {
    /// Whether all values are within their limits.
    #[must_use]
    pub fn is_allowed(&self) -> bool {
        self.size.iter().all(|side| SIDES.contains(side))
            && self.regions.iter().flatten().all(|regions| (1..=limits::MAX_REGIONS).contains(regions))
            && (limits::DPI.low..=limits::DPI.high).contains(&self.dpi)
    }

    /// The document.
    #[must_use]
    pub fn document(&self) -> Document {
        let edges = if self.seamless { Edges::Wrap } else { Edges::Closed };
        Document { size: self.size, regions: self.regions, edges, dpi: self.dpi, ..Document::default() }
    }

    /// The page.
    pub fn ui(&mut self, ui: &mut Ui, units: Units) -> Option<Answer> {
        fit_width(ui, 340.0);
        ui.heading("New document");
        ui.add_space(6.0);
        Grid::new("new").num_columns(2).spacing(vec2(16.0, 10.0)).show(ui, |ui| {
            ui.label("Size").on_hover_text("Width and height of the canvas");
            let ruler = Ruler { units, dpi: self.dpi };
            ui.horizontal(|ui| sides(ui, &mut self.size, ruler, SIDES, ["Width", "Height"]));
            ui.end_row();
            ui.label("Regions").on_hover_text(REGIONS);
            ui.horizontal(|ui| regions(ui, &mut self.regions, ["Regions", "Columns", "Rows"]));
            ui.end_row();
            ui.label("Seamless").on_hover_text(SEAMLESS);
            ui.add(Checkbox::new(&mut self.seamless, "tiles without a seam"));
            ui.end_row();
            ui.label("Resolution").on_hover_text(DPI);
            resolution(ui, &mut self.dpi, "Resolution");
            ui.end_row();
        });
        ui.horizontal(|ui| {
            ui.weak("Sizes");
            for (name, size) in [("512²", [512, 512]), ("1024²", [1024, 1024]), ("768 × 512", [768, 512])]
            {
                if ui.small_button(name).clicked() {
                    self.size = size;
                }
            }
        });
        ui.add_space(6.0);
        choice(ui, "Create", None)
    }
}

/// The buttons of a page, the first choice on the right.
pub fn choice(ui: &mut Ui, yes: &str, no: Option<&str>) -> Option<Answer> {
    choice_of(ui, yes, true, no)
}

/// The buttons of a page, the first choice on the right; it is disabled unless `can`.
pub fn choice_of(ui: &mut Ui, yes: &str, can: bool, no: Option<&str>) -> Option<Answer> {
    let others: Vec<(&str, Answer)> = no.into_iter().map(|no| (no, Answer::No)).collect();
    choice_among(ui, yes, can, &others)
}

/// The buttons of a page with any number of other choices; the first choice is disabled unless `can`.
fn choice_among(ui: &mut Ui, yes: &str, can: bool, others: &[(&str, Answer)]) -> Option<Answer> {
    let mut answer = None;
    let buttons = |ui: &mut Ui| {
        let fill = ui.visuals().selection.bg_fill;
        let text = RichText::new(yes).color(ui.visuals().selection.stroke.color);
        if ui.add_enabled(can, Button::new(text).fill(fill).min_size(vec2(96.0, 28.0))).clicked() {
            answer = Some(Answer::Yes);
        }
        for (other, meant) in others {
            if ui.add(Button::new(*other).min_size(vec2(96.0, 28.0))).clicked() {
                answer = Some(*meant);
            }
        }
        if ui.add(Button::new("Cancel").min_size(vec2(80.0, 28.0))).clicked() {
            answer = Some(Answer::Cancel);
        }
    };
    if is_small(ui.ctx()) && !others.is_empty() {
        // The buttons stand one below the other, because they would not fit side by side.
        ui.vertical_centered_justified(buttons);
    } else {
        // A fixed height: without it the layout would take all the space that is left.
        let size = vec2(ui.available_width(), 28.0);
        ui.allocate_ui_with_layout(size, egui::Layout::right_to_left(egui::Align::Center), buttons);
    }
    answer
}

/// Asks what to do with unsaved changes.
pub fn unsaved(ui: &mut Ui, title: &str) -> Option<Answer> {
    fit_width(ui, 400.0);
    ui.heading(format!("Save the changes to {title}?"));
    ui.label("Otherwise they will be lost.");
    ui.add_space(8.0);
    choice(ui, "Save", Some("Don't save"))
}

/// Explains why a document should not be sent as a link. `can`: whether a link can be made.
pub fn unlinked(ui: &mut Ui, why: &str, can: bool) -> Option<Answer> {
    fit_width(ui, 440.0);
    ui.heading("Send it as a file?");
    ui.label(why);
    ui.add_space(8.0);
    choice(ui, "Save a file…", can.then_some("Copy the link anyway"))
}

/// Asks what a dropped picture is for.
pub fn dropped_picture(ui: &mut Ui, name: &str) -> Option<Answer> {
    fit_width(ui, 440.0);
    ui.heading(format!("What is {name} for?"));
    ui.label(
        "A sketch: the spots or stripes in the photograph become marks of a new document. Tone: the lowest \
         layer follows the picture, with more ink where it is darker and stripes along its edges. A reference \
         picture: it is shown \
         under the canvas, to draw over.",
    );
    ui.add_space(8.0);
    let others = [("Reference picture", Answer::No), ("Tone", Answer::Third)];
    choice_among(ui, "Sketch from it", true, &others)
}

/// Asks what to do with a mark that does not belong on the active layer.
pub fn another_layer(ui: &mut Ui, mark: &Mark) -> Option<Answer> {
    fit_width(ui, 400.0);
    ui.heading("Draw it on another layer?");
    ui.label(match mark {
        Mark::Ellipse(_) => {
            "This layer grows rings or a net around the marks beneath. A line sets their width; ellipses need \
             another layer."
        }
        Mark::Line(_) | Mark::Path(_) => {
            "This layer grows a spot inside each mark beneath. An ellipse sets their size; lines need another layer."
        }
    });
    ui.add_space(8.0);
    choice(ui, "Other layer", None)
}

/// Version, papers, licence.
pub fn about(ui: &mut Ui) {
    fit_width(ui, 460.0);
    ui.heading("dapple");
    ui.label(format!("Version {}", env!("CARGO_PKG_VERSION")));
    ui.add_space(6.0);
    ui.label(
        "Draw a few spots or stripes; dapple grows a texture with their size, shape, spacing and direction. \
         The pattern is computed: two substances react and diffuse until they settle.",
    );
    ui.add_space(6.0);
    ui.label(RichText::new("The papers").strong());
    for paper in [
        "Phan & Grimm, Sketching Reaction-Diffusion Texture. Sketch-Based Interfaces and Modeling, 2006.",
        "Turk, Generating Textures on Arbitrary Surfaces Using Reaction-Diffusion. SIGGRAPH 1991.",
        "Witkin & Kass, Reaction-Diffusion Textures. SIGGRAPH 1991.",
        "Turing, The Chemical Basis of Morphogenesis. Phil. Trans. R. Soc. B 237, 1952.",
        "Meinhardt, Models of Biological Pattern Formation. Academic Press, 1982.",
    ] {
        ui.label(paper);
    }
    ui.add_space(6.0);
    ui.weak("Licensed under MIT or Apache-2.0, at your choice.");
}

/// First steps.
pub fn hint(ui: &mut Ui) -> Option<Action> {
    fit_width(ui, 400.0);
    let mut action = None;
    ui.heading("Your first texture");
    ui.add_space(4.0);
    for (number, text) in [
        "Draw a few round or oval spots on the canvas, each with one stroke.",
        "The texture grows beside it: spots of this size, shape and spacing on the whole canvas.",
        "Draw other spots elsewhere: the texture changes gradually from one to the other.",
    ]
    .iter()
    .enumerate()
    {
        ui.horizontal_top(|ui| {
            ui.label(RichText::new(format!("{}", number + 1)).strong());
            ui.label(*text);
        });
    }
    ui.add_space(2.0);
    ui.weak("Open strokes grow stripes. Everything can be undone.");
    ui.add_space(8.0);
    ui.horizontal(|ui| {
        if ui.add(Button::new("Start drawing").min_size(vec2(120.0, 30.0))).clicked() {
            action = Some(Action::Page(Page::Hint));
        }
        if ui.add(Button::new("Look at examples").min_size(vec2(130.0, 30.0))).clicked() {
            action = Some(Action::Page(Page::Examples));
        }
    });
    action
}
