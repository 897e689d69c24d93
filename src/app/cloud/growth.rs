//! The map of what Turing's system grows at each growth and decay, with the growth of a layer marked.

use egui::{Color32, Id, Ui, vec2};
use egui_plot::{Plot, PlotImage, PlotPoint, PlotPoints, Polygon};

use crate::app::assets::{self, Asset, asset};
use crate::app::theme::Palette;
use crate::rd::GrowthMap;

/// The map, made by `data-gen growth-map`.
const PICTURE: Asset = asset!(".", "growth-map");
/// The decay of layers.
const DECAY: f64 = 20.0;
/// Half the width of the frame that marks the growth of a layer, where this growth is the same everywhere.
const LEAST: f64 = 0.15;

/// The map and the growth of a layer.
pub struct GrowthView {
    /// The lowest and the highest growth of the layer.
    pub range: [f32; 2],
}

impl GrowthView {
    /// The map for a layer with this growth.
    pub fn new(range: [f32; 2]) -> Self {
        Self { range }
    }

    /// Shows it; each new `question` resets the visible range.
    pub fn ui(&self, ui: &mut Ui, question: u64) {
        let [low, high] = self.range;
        let own =
            if high - low < 0.05 { format!("G = {low:.1}") } else { format!("G = {low:.1} to {high:.1}") };
        ui.weak(format!(
            "What grows at each growth and decay. The frame is this layer: {own}, decay {DECAY}. From left to right: nothing, dots, \
             worms, holes, all ink."
        ));
        let map = GrowthMap::SHOWN;
        let [across, up] = map.bounds().map(|ends| ends.map(f64::from));
        let Some(texture) = assets::texture(ui.ctx(), PICTURE) else {
            ui.spinner();
            return;
        };
        let middle = |[from, to]: [f64; 2]| 0.5 * (from + to);
        let size = vec2((across[1] - across[0]) as f32, (up[1] - up[0]) as f32);
        let image = PlotImage::new("", texture.id(), PlotPoint::new(middle(across), middle(up)), size);
        let [low, high] = [f64::from(low) - LEAST, f64::from(high) + LEAST];
        let half = 0.5 * f64::from(map.decay_step);
        let corners = [[low, DECAY - half], [high, DECAY - half], [high, DECAY + half], [low, DECAY + half]];
        let colour = Palette::current(ui.visuals()).wrong;
        let frame = Polygon::new("This layer", PlotPoints::from(corners.to_vec()))
            .fill_color(Color32::TRANSPARENT)
            .stroke((2.5, colour));
        Plot::new(("growth map", question))
            .id(Id::unique("growth map's plot").with(question))
            .min_size(vec2(260.0, 200.0))
            .x_axis_label("Growth")
            .y_axis_label("Decay")
            .show(ui, |plot| {
                plot.image(image);
                plot.polygon(frame);
            });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_map_has_as_many_whole_patches_as_the_table_says() {
        let [width, height] = assets::image(PICTURE).unwrap().size;
        let [columns, rows] = GrowthMap::SHOWN.patches;
        assert!(
            width % columns == 0 && height % rows == 0 && width / columns == height / rows,
            "{width} {height}"
        );
    }
}
