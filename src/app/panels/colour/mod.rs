//! The tab for colours: a bar with the stops of the active layer, the transitions between them, presets, palettes.

mod bar;
mod copies;
mod curve;
mod grip;
mod ground;
mod hex_field;
mod picker;
mod presets;
mod stop;
mod stop_menu;
mod swatches;

use egui::{Color32, Key, RichText, TextureHandle, Ui, ecolor::HsvaGamma};

use crate::app::action::Action;
use crate::app::panels::finish::finish;
use crate::app::panels::warp::warp;
use crate::colour::ColourModel;
use crate::document::Colours;
use crate::editor::edit::Edit;
use crate::editor::session::Session;

/// What is selected and dragged in the tab; nothing of it is saved.
#[derive(Default)]
pub struct ColourPanel {
    /// The selected stop.
    pub(super) stop: usize,
    /// The selected transition: from this stop to the next.
    pub(super) gap: usize,
    drag: Option<Drag>,
    /// A colour that is being typed.
    hex: Option<String>,
    /// The colour of the picker with its hue, saturation and value: from a gray alone the hue would be lost.
    hsv: Option<([u8; 3], HsvaGamma)>,
    /// The colour model of the picker's numbers, and the numbers that were typed: the resulting colour, its model, its
    /// coordinates.
    model: ColourModel,
    typed: Option<([u8; 3], ColourModel, [f64; 3])>,
    /// Whether the next click on a picture gives the selected stop its colour.
    pub picking: bool,
    /// Whether the plot of the transition is unfolded.
    unfolded: bool,
    /// Whether it has just been unfolded and is to be scrolled to.
    shows_plot: bool,
    /// Whether the picker opens in this frame.
    open_picker: bool,
    /// Pictures of the presets.
    samples: Vec<TextureHandle>,
}

/// A stop or a handle that is dragged.
struct Drag {
    /// The colours before the drag.
    before: Colours,
    /// The stop; `None` = a handle of the curve.
    stop: Option<usize>,
    /// The vector from the dragged stop or handle to the pointer, points.
    offset: [f32; 2],
    /// The range of y in the curve's plot; it does not change during the drag.
    range: [f64; 2],
}

impl ColourPanel {
    /// Ends a drag. Returns whether there was one.
    pub fn cancel(&mut self) -> bool {
        self.drag.take().is_some()
    }

    /// Whether a stop or a transition is being dragged.
    #[must_use]
    pub fn is_dragging(&self) -> bool {
        self.drag.is_some()
    }

    /// Limits the selection to existing stops and transitions.
    fn retain_existing(&mut self, colours: &Colours) {
        let last = colours.stops.len() - 1;
        self.stop = self.stop.min(last);
        self.gap = self.gap.min(last.saturating_sub(1));
    }

    /// Selects a stop, and the transition after it.
    fn choose(&mut self, stop: usize, colours: &Colours) {
        self.stop = stop;
        self.gap = stop.min(colours.stops.len().saturating_sub(2));
        self.hex = None;
    }
}

/// Shows the colours of the active layer. A drag returns an edit in every frame.
pub fn colour(ui: &mut Ui, session: &Session, panel: &mut ColourPanel) -> Vec<Action> {
    let layer = session.active_layer;
    let before = session.colours(layer);
    let mut colours = before.clone();
    panel.retain_existing(&colours);
    ui.label(RichText::new(format!("Colours of {}", session.layer_name(layer))).strong());
    if panel.drag.is_some() && ui.input(|input| input.key_pressed(Key::Escape)) {
        if let Some(drag) = panel.drag.take() {
            colours = drag.before;
        }
        ui.ctx().stop_dragging();
    }
    bar::bar(ui, panel, &mut colours);
    stop::stop(ui, panel, &mut colours);
    swatches::swatches(ui, session, panel, &mut colours);
    let preset = presets::presets(ui, panel, &colours);
    if colours.stops.len() > 1 {
        curve::curve(ui, panel, &mut colours);
    }
    ground::ground(ui, session, &mut colours);
    let mut actions = Vec::new();
    if colours != before {
        actions.push(paint(layer, colours.clone()));
    }
    actions.extend(copies::copies(ui, session, &colours));
    actions.extend(preset.map(|preset| paint(layer, preset)));
    actions.extend(warp(ui, session.document()));
    actions.extend(finish(ui, session.document()));
    actions
}

/// Gives the selected stop of the active layer the colour that was picked, and ends picking.
pub fn picked(session: &Session, panel: &mut ColourPanel, colour: [u8; 3]) -> Action {
    let layer = session.active_layer;
    let mut colours = session.colours(layer);
    panel.retain_existing(&colours);
    (panel.picking, panel.hex) = (false, None);
    colours.stops[panel.stop].colour = colour;
    paint(layer, colours)
}

/// Gives a layer these colours.
fn paint(layer: usize, colours: Colours) -> Action {
    Action::Edit(Edit::Colours(vec![layer], Some(colours)))
}

/// A colour for the screen, of red, green, blue, alpha.
fn shown([red, green, blue, alpha]: [u8; 4]) -> Color32 {
    Color32::from_rgba_unmultiplied(red, green, blue, alpha)
}
