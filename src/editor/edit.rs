//! Changes of the document that panels ask for.

use crate::document::systems::POINTS;
use crate::document::{
    After, Colours, Document, Finishing, Layer, LayerMaps, LayerOptions, Points, SystemChoice, Tone,
    ToneImage, Warp,
};
use crate::editor::goal::Goal;
use crate::editor::selection::Place;
use crate::editor::session::Session;
use crate::grid::Edges;
use crate::marks::Mark;
use crate::synth::import::tone;

/// A change of the open document. Layers are given by index, 0 = the lowest.
#[derive(Clone, Debug, PartialEq)]
pub enum Edit {
    /// Set width and height of the canvas, px. Marks whose centre is outside are removed.
    Size([u32; 2]),
    /// Set the number of columns and rows of regions; `None` = free marks.
    Regions(Option<[u32; 2]>),
    /// Set how the canvas ends.
    Edges(Edges),
    /// Set the resolution, dots per inch.
    Dpi(f64),
    /// Set the seed.
    Seed(u64),
    /// Set or remove the warp.
    Warp(Option<Warp>),
    /// Set or remove the finish.
    Finish(Option<Finishing>),
    /// Replace marks.
    Marks(Vec<(Place, Mark)>),
    /// Name a layer.
    LayerName(usize, String),
    /// Set where the marks of a layer grow relative to those beneath.
    LayerAfter(usize, After),
    /// Set the system of a layer.
    LayerSystem(usize, SystemChoice),
    /// Let a layer become this.
    LayerGoal(usize, Goal),
    /// Set the options of a layer.
    LayerOptions(usize, LayerOptions),
    /// Make a layer a field of these points.
    LayerPoints(usize, Points),
    /// Let a picture drive the layer that has a tone. If no layer has one, the lowest layer gets it, and is created
    /// where there is none.
    Drive(ToneImage),
    /// Set or remove the tone of a layer.
    LayerTone(usize, Option<Tone>),
    /// Set the maps of a layer.
    LayerMaps(usize, Box<LayerMaps>),
    /// Set the colours of layers; `None` = the default colours of each.
    Colours(Vec<usize>, Option<Colours>),
}

impl Session {
    /// Carries out a change. The next [`Session::commit`] makes it a step that can be undone.
    pub fn change(&mut self, edit: Edit) {
        match edit {
            Edit::Size(size) => self.resize(size),
            Edit::Regions(regions) => self.edit(|document| document.regions = regions),
            Edit::Edges(edges) => self.edit(|document| document.edges = edges),
            Edit::Dpi(dpi) => self.edit(|document| document.dpi = dpi),
            Edit::Seed(seed) => self.edit(|document| document.seed = seed),
            Edit::Warp(warp) => self.edit(|document| document.warp = warp),
            Edit::Finish(finish) => self.edit(|document| document.finish = finish),
            Edit::Marks(marks) => self.replace(&marks),
            Edit::LayerName(layer, name) => self.change_layer(layer, |layer| layer.name = name),
            Edit::LayerAfter(layer, after) => self.change_layer(layer, |layer| layer.after = after),
            Edit::LayerSystem(layer, system) => self.change_layer(layer, |layer| layer.system = system),
            Edit::LayerGoal(layer, goal) => self.become_goal(layer, goal),
            Edit::LayerOptions(layer, options) => self.change_layer(layer, |layer| layer.options = options),
            Edit::LayerPoints(layer, points) => self.edit(|document| scatter(document, layer, points)),
            Edit::Drive(image) => self.drive(image),
            Edit::LayerTone(layer, tone) => self.change_layer(layer, |layer| layer.tone = tone),
            Edit::LayerMaps(layer, maps) => self.change_layer(layer, |layer| layer.maps = *maps),
            Edit::Colours(layers, colours) => self.edit(|document| colour(document, &layers, &colours)),
        }
    }

    fn drive(&mut self, image: ToneImage) {
        if self.document().layers.is_empty() {
            self.edit(|document| document.layers.push(Layer::default()));
        }
        self.edit(|document| tone::drive(document, image));
        let driven = self.document().layers.iter().position(|layer| layer.tone.is_some()).unwrap_or(0);
        // Settings that are not allowed beside a tone get their defaults.
        self.change_layer(driven, |_| ());
        self.active_layer = driven;
    }

    fn become_goal(&mut self, layer: usize, goal: Goal) {
        let marks = self.marks_of(layer);
        let mut active = layer;
        self.edit(|document| active = goal.apply(document, layer, &marks));
        self.active_layer = active;
    }

    fn resize(&mut self, size: [u32; 2]) {
        let outside = self.marks().filter(|(_, mark)| !mark.is_on(size.map(f64::from)));
        let removed: Vec<Place> = outside.map(|(place, _)| place).collect();
        self.remove(&removed);
        self.edit(|document| document.size = size);
        // A smaller canvas has narrower limits.
        let kept: Vec<_> = self.marks().collect();
        self.replace(&kept);
    }

    /// The colours with which a layer is painted: its own, or its default.
    #[must_use]
    pub fn colours(&self, layer: usize) -> Colours {
        let layers = &self.document().layers;
        let own = layers.get(layer).and_then(|layer| layer.colours.clone());
        // Layers without marks are left out when the document is finished, and the next one takes their index.
        let index = layers.iter().take(layer).filter(|layer| !layer.is_blank()).count();
        own.filter(|colours| !colours.stops.is_empty()).unwrap_or_else(|| Colours::default_for_layer(index))
    }
}

fn scatter(document: &mut Document, layer: usize, points: Points) {
    if let Some(layer) = document.layers.get_mut(layer) {
        layer.system = SystemChoice::Of(&POINTS);
        layer.points = Some(points);
    }
}

fn colour(document: &mut Document, layers: &[usize], colours: &Option<Colours>) {
    for &layer in layers {
        // Colours may be chosen before anything is drawn.
        if layer == 0 && document.layers.is_empty() && colours.is_some() {
            document.layers.push(Layer::default());
        }
        if let Some(layer) = document.layers.get_mut(layer) {
            layer.colours.clone_from(colours);
        }
    }
}
