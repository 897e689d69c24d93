//! The colours of the layer at hand: a bar with stops, the ways between them, presets, palettes.

mod bar;
mod between;
mod curve;
mod grip;
mod picker;
mod presets;
mod stop;

use egui::{Color32, Key, RichText, TextureHandle, Ui, ecolor::HsvaGamma};

use crate::app::Window;
use crate::app::action::Action;
use crate::document::{Colours, Layer};
use crate::editor::session::Session;

/// What is chosen and held in the panel; nothing of it is saved.
#[derive(Default)]
pub struct ColourPanel {
    /// The chosen stop.
    pub(super) stop: usize,
    /// The chosen way, from this stop to the next.
    pub(super) gap: usize,
    held: Option<Held>,
    /// A colour that is being typed.
    hex: Option<String>,
    /// The colour in the picker, and what it stands for: gray has no hue of its own.
    hsv: Option<([u8; 3], HsvaGamma)>,
    /// Shall the picker open?
    open_picker: bool,
    /// Small pictures of the presets.
    samples: Vec<TextureHandle>,
}

/// A stop or a handle under the pointer.
struct Held {
    /// The colours before.
    before: Colours,
    /// Which stop; a handle knows itself.
    stop: usize,
    /// From the pointer to what it holds, points.
    grip: [f32; 2],
    /// Smallest and largest y of the curve's picture: it stands still meanwhile.
    rise: [f64; 2],
}

impl ColourPanel {
    /// Lets go of what is held: everything is as before. Gives whether something was.
    pub fn cancel(&mut self, session: &mut Session) -> bool {
        let held = self.held.take().is_some();
        if held {
            session.revert();
        }
        held
    }

    /// What is chosen is there.
    fn retain_existing(&mut self, colours: &Colours) {
        let last = colours.stops.len() - 1;
        self.stop = self.stop.min(last);
        self.gap = self.gap.min(last.saturating_sub(1));
    }

    /// Chooses a stop, and the way from it.
    fn choose(&mut self, stop: usize, colours: &Colours) {
        self.stop = stop;
        self.gap = stop.min(colours.stops.len().saturating_sub(2));
        self.hex = None;
    }
}

/// The colours of a layer as they are seen: its own, or those it has by itself.
#[must_use]
pub fn of(session: &Session, layer: usize) -> Colours {
    let layers = &session.document().layers;
    let own = layers.get(layer).and_then(|layer| layer.colours.clone());
    // Layers without marks are not grown, and the next one stands in their place.
    let grown = layers.iter().take(layer).filter(|layer| !layer.strokes.is_empty()).count();
    own.filter(|colours| !colours.stops.is_empty()).unwrap_or_else(|| Colours::default_for_layer(grown))
}

/// Gives layers these colours; `None` = those they have by themselves.
pub fn give(session: &mut Session, layers: &[usize], colours: Option<&Colours>) {
    session.edit(|document| {
        for &layer in layers {
            // Colours may be chosen before anything is drawn.
            if layer == 0 && document.layers.is_empty() && colours.is_some() {
                document.layers.push(Layer::default());
            }
            if let Some(layer) = document.layers.get_mut(layer) {
                layer.colours = colours.cloned();
            }
        }
    });
}

/// What people call a layer.
#[must_use]
pub fn name_of(session: &Session, layer: usize) -> String {
    let name = session.document().layers.get(layer).map_or("", |layer| layer.name.as_str());
    if name.is_empty() { format!("layer {}", layer + 1) } else { name.to_owned() }
}

/// Shows them.
pub fn colour(ui: &mut Ui, window: &mut Window, actions: &mut Vec<Action>) {
    let layer = window.session.active_layer;
    let before = of(&window.session, layer);
    let mut colours = before.clone();
    let panel = &mut window.colour;
    panel.retain_existing(&colours);
    ui.label(RichText::new(format!("Colours of {}", name_of(&window.session, layer))).strong());
    if panel.held.is_some() && ui.input(|input| input.key_pressed(Key::Escape)) {
        if let Some(held) = panel.held.take() {
            colours = held.before;
        }
        ui.ctx().stop_dragging();
    }
    bar::bar(ui, panel, &mut colours);
    stop::stop(ui, panel, &mut colours);
    if colours.stops.len() > 1 {
        curve::curve(ui, panel, &mut colours);
    }
    if colours != before {
        give(&mut window.session, &[layer], Some(&colours));
    }
    between::between(ui, &mut window.session, actions);
    let before = of(&window.session, layer);
    let mut colours = before.clone();
    presets::presets(ui, &mut window.colour, &mut colours);
    if colours != before {
        give(&mut window.session, &[layer], Some(&colours));
    }
}

/// A colour as the screen takes it.
fn shown([red, green, blue]: [u8; 3]) -> Color32 {
    Color32::from_rgb(red, green, blue)
}

/// A colour as people write it.
fn hex([red, green, blue]: [u8; 3]) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}
