//! The column on the right: what is drawn, its colours, what came of it; below, the layers.

use egui::{Button, CentralPanel, Frame, Grid, Margin, Panel, Rect, RichText, ScrollArea, Slider, Ui, vec2};

use super::{colour, layers, result, selected};
use crate::app::Window;
use crate::app::action::Action;
use crate::app::canvas::tool::Tool;
use crate::app::pages::{DPI, REGIONS, SEAMLESS, SIDES, pair, sides};
use crate::app::preferences::resolution;
use crate::app::units::Ruler;
use crate::attributes::Attributes;
use crate::document::limits;
use crate::editor::session::Session;
use crate::editor::shape;
use crate::grid::Edges;

/// Widths of lines to choose from, px: evenly over those that grow in moments.
const WIDTHS: [f64; 4] = [4.0, 8.0, 12.0, 16.0];

/// What the column shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tab {
    /// The tool, what is selected, the canvas.
    #[default]
    Draw,
    /// The colours of the layer at hand.
    Colour,
    /// What was asked and what has grown.
    Result,
}

impl Tab {
    /// All, as they stand.
    pub const ALL: [Self; 3] = [Self::Draw, Self::Colour, Self::Result];

    /// What people read.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Draw => "Draw",
            Self::Colour => "Colour",
            Self::Result => "Result",
        }
    }
}

/// The column. Gives what is chosen.
pub fn inspector(ui: &mut Ui, window: &mut Window) -> Vec<Action> {
    let mut actions = Vec::new();
    let frame = Frame::NONE.inner_margin(Margin { top: 8, ..Margin::ZERO });
    let below = Panel::bottom("layers").frame(frame).resizable(false);
    below.show(ui, |ui| layers::layers(ui, window, &mut actions));
    CentralPanel::no_frame().show(ui, |ui| {
        ui.horizontal(|ui| {
            for tab in Tab::ALL {
                let button = Button::new(tab.name()).selected(window.tab == tab);
                if ui.add_sized(vec2(64.0, 26.0), button).clicked() {
                    actions.push(Action::Tab(tab));
                }
            }
        });
        ui.add_space(6.0);
        let area = ScrollArea::vertical().id_salt(window.tab.name()).auto_shrink([false; 2]);
        area.show(ui, |ui| match window.tab {
            Tab::Draw => draw(ui, window, &mut actions),
            Tab::Colour => colour::colour(ui, window, &mut actions),
            Tab::Result => result::result(ui, window, &mut actions),
        });
    });
    actions
}

fn draw(ui: &mut Ui, window: &mut Window, actions: &mut Vec<Action>) {
    if window.session.selection.is_empty() {
        tool(ui, window);
    } else {
        selected::selected(ui, window, actions);
    }
    canvas(ui, window);
    region(ui, window);
    shown(ui, window, actions);
}

/// A heading over a part of the column.
pub fn heading(ui: &mut Ui, text: &str) {
    ui.add_space(8.0);
    ui.label(RichText::new(text).strong());
}

/// Rows of a name and a value.
pub fn rows(ui: &mut Ui, id: &str, add: impl FnOnce(&mut Ui)) {
    Grid::new(id).num_columns(2).min_col_width(72.0).spacing(vec2(10.0, 7.0)).show(ui, add);
}

fn tool(ui: &mut Ui, window: &mut Window) {
    let tool = window.canvas.tool;
    let ruler = window.ruler();
    ui.label(RichText::new(tool.name()).strong());
    if matches!(tool, Tool::Pen | Tool::Line) {
        rows(ui, "nib", |ui| {
            ui.label("Line width").on_hover_text("Width of the stripe that a line stands for");
            let field = ruler.field(&mut window.canvas.nib.width).suffix(ruler.unit());
            ui.add(field).accessible_name("Line width");
            ui.end_row();
        });
        let width = &mut window.canvas.nib.width;
        *width = width.clamp(0.5, 400.0);
        presets(ui, width, ruler);
    } else if tool == Tool::Ellipse {
        rows(ui, "stamp", |ui| {
            ui.label("A click makes").on_hover_text("The size of the ellipse that a click puts down");
            ui.horizontal(|ui| {
                for (radius, name) in
                    window.canvas.nib.radii.iter_mut().zip(["Radius along", "Radius across"])
                {
                    ui.add(ruler.field(radius)).accessible_name(name);
                    *radius = radius.clamp(0.5, 2000.0);
                }
                ui.weak(ruler.unit().trim_start());
            });
            ui.end_row();
        });
    } else {
        ui.weak("Nothing is selected.");
    }
}

/// The widths to choose from, each drawn as it is.
pub fn presets(ui: &mut Ui, width: &mut f64, ruler: Ruler) -> bool {
    let mut changed = false;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        for preset in WIDTHS {
            let chosen = (*width - preset).abs() < 0.05;
            let size = vec2(46.0, 26.0);
            let button = ui.add_sized(size, Button::new("").selected(chosen));
            let colour = if chosen {
                ui.visuals().selection.stroke.color
            } else {
                ui.style().interact(&button).text_color()
            };
            let bar = Rect::from_center_size(button.rect.center(), vec2(26.0, preset as f32));
            ui.painter().rect_filled(bar, 2.0, colour);
            let name = format!("{} wide", ruler.rough(preset));
            let button = button.accessible_name(&name);
            if button.on_hover_text(&name).clicked() {
                *width = preset;
                changed = true;
            }
        }
    });
    changed
}

fn canvas(ui: &mut Ui, window: &mut Window) {
    heading(ui, "Canvas");
    let ruler = window.ruler();
    let session = &mut window.session;
    let document = session.document();
    let (mut size, mut regions) = (document.size, document.regions);
    let (mut seamless, mut dpi) = (document.edges == Edges::Wrap, document.dpi);
    rows(ui, "canvas", |ui| {
        ui.label("Size").on_hover_text("Width and height of the canvas");
        ui.horizontal(|ui| {
            if sides(ui, &mut size, ruler, SIDES, ["Canvas width", "Canvas height"]) {
                resize(session, size);
                window.canvas.view.fitted = true;
                window.texture.view.fitted = true;
            }
        });
        ui.end_row();
        ui.label("Regions").on_hover_text(REGIONS);
        ui.horizontal(|ui| {
            if pair(ui, &mut regions, 1..=limits::MAX_REGIONS, ["Region columns", "Region rows"], "") {
                session.edit(|document| document.regions = regions);
            }
        });
        ui.end_row();
        ui.label("Seamless").on_hover_text(SEAMLESS);
        if ui.checkbox(&mut seamless, "tiles").accessible_name("Seamless").on_hover_text(SEAMLESS).changed() {
            session.edit(|document| document.edges = if seamless { Edges::Wrap } else { Edges::Closed });
            window.texture.tiled &= seamless;
        }
        ui.end_row();
        ui.label("Resolution").on_hover_text(DPI);
        if resolution(ui, &mut dpi, "Resolution") {
            session.edit(|document| document.dpi = dpi);
        }
        ui.end_row();
    });
}

/// Another canvas; marks that are not on it any more go.
fn resize(session: &mut Session, size: [u32; 2]) {
    let outside = |point: [f64; 2]| (0..2).any(|axis| point[axis] > f64::from(size[axis]));
    let gone: Vec<_> =
        session.marks().filter(|(_, mark)| outside(shape::center(mark))).map(|(place, _)| place).collect();
    session.remove(&gone);
    session.edit(|document| document.size = size);
}

fn region(ui: &mut Ui, window: &Window) {
    let middle = window.session.document().size.map(|side| 0.5 * f64::from(side));
    let at = window.canvas.pointer.unwrap_or(middle);
    let Some((place, region)) = window.canvas.analysis.region(window.session.active_layer, at) else {
        return;
    };
    let Some(map) = window.canvas.analysis.map(window.session.active_layer) else { return };
    heading(ui, &format!("Region {}, {}", place[0] + 1, place[1] + 1));
    let own = region.own.is_some();
    let ruler = window.ruler();
    rows(ui, "region", |ui| {
        let mut row = |name: &str, value: String, help: &str| {
            ui.label(name).on_hover_text(help);
            ui.label(RichText::new(value).weak());
            ui.end_row();
        };
        let marks = if own { region.marks.to_string() } else { "none; as nearby".to_owned() };
        row("Marks", marks, "Marks whose middle lies in this region");
        match map.at(map.layout().center(place)) {
            Attributes::Spots(spots) => {
                row("Area", ruler.area(spots.area), "Mean area of the ellipses");
                row("Aspect", format!("{:.2}", spots.aspect), "Minor ÷ major radius; 1 is round");
                row("Direction", format!("{:.0}°", spots.angle), "Mean direction of the major axes");
                let spacing = spots.spacing.map_or("free".to_owned(), |spacing| ruler.rough(spacing));
                row("Spacing", spacing, "Mean distance between neighbours; free = what grows by itself");
            }
            Attributes::Stripes(stripes) => {
                row("Width", ruler.length(stripes.width), "Mean width of the lines");
                row("Direction", format!("{:.0}°", stripes.angle), "Mean direction of the lines");
            }
        }
    });
}

fn shown(ui: &mut Ui, window: &mut Window, actions: &mut Vec<Action>) {
    heading(ui, "Shown");
    ui.checkbox(&mut window.canvas.overlays.regions, "Region grid").on_hover_text(REGIONS);
    ui.checkbox(&mut window.canvas.overlays.analysis, "What dapple sees").on_hover_text(
        "Fitted marks with their axes, the edges between neighbours whose mean is the spacing, and each \
         region's mean mark",
    );
    if window.session.document().edges == Edges::Wrap {
        ui.checkbox(&mut window.texture.tiled, "Tiles, two by two")
            .on_hover_text("So that a seam would be seen");
    }
    ui.checkbox(&mut window.linked, "Views move together")
        .on_hover_text("Zooming and panning the sketch does the same to the texture");
    let reference = &mut window.canvas.reference;
    if reference.is_there() {
        ui.horizontal(|ui| {
            ui.checkbox(&mut reference.shown, "Picture").on_hover_text(&reference.name);
            let slider = Slider::new(&mut reference.opacity, 0.0..=1.0).show_value(false);
            ui.spacing_mut().slider_width = 80.0;
            ui.add(slider).accessible_name("Opacity of the reference picture");
            if ui.small_button("Remove").clicked() {
                reference.clear();
            }
        });
    } else if ui
        .button("Reference picture…")
        .on_hover_text("A photo under the canvas, to draw over")
        .clicked()
    {
        actions.push(Action::Reference);
    }
}
