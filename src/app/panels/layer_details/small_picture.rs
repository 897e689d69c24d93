//! Small pictures that stand beside the names of systems and of kinds of labels, and show what these grow.
//!
//! Each was grown by dapple, and holds its document: `docs/window.md` says how they are renewed.

use egui::{Vec2, vec2};

use crate::app::assets::{Asset, asset};

/// Size of a picture, points: half of its px, so that it is sharp on fine screens.
pub const SIZE: Vec2 = vec2(48.0, 32.0);

/// The pictures of the kinds of labels, in the order of their names.
const LABELS: [Asset; 8] = [
    asset!("labels", "values"),
    asset!("labels", "random"),
    asset!("labels", "image"),
    asset!("labels", "space-giraffe"),
    asset!("labels", "breadth-first"),
    asset!("labels", "depth-first"),
    asset!("labels", "round-robin"),
    asset!("labels", "connected"),
];

/// The picture of a kind of labels, where there is one.
pub fn of_labels(name: &str) -> Option<Asset> {
    LABELS.into_iter().find(|asset| asset.name == name)
}

/// The picture of what the system of this name in documents grows, which the engine has as a PNG unless it is loaded.
pub fn of_system(name: &'static str, bytes: &'static [u8]) -> Asset {
    Asset { folder: "systems", name, ending: "png", bytes }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::assets;
    use crate::document::{Labels, Layer, SystemChoice};

    /// The layer that is in a small picture, after it was seen that this can be shown.
    fn layer_in(asset: Asset) -> Layer {
        let Asset { folder, name, bytes, .. } = asset;
        assert!(bytes.len() < 16_000, "{name}: {} bytes", bytes.len());
        let image = assets::image(asset).unwrap();
        assert_eq!(image.size, [96, 64], "{name}");
        assert!(image.pixels.iter().any(|pixel| *pixel != image.pixels[0]), "{name} is empty");
        let assets = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("assets");
        let path = assets.join(folder).join(format!("{name}.png"));
        let (document, _) = crate::files::in_picture(path).unwrap().expect("it holds its document");
        document.layers[0].clone()
    }

    #[test]
    fn every_system_has_a_small_picture_that_it_has_grown_itself() {
        for (name, system) in SystemChoice::names().into_iter().filter(|(name, _)| *name != "auto") {
            assert_eq!(layer_in(of_system(name, system.picture())).system, system, "{name}");
        }
    }

    #[test]
    fn every_kind_of_labels_has_a_small_picture_that_was_grown_with_it() {
        assert_eq!(LABELS.len(), Labels::NAMES.len());
        for name in Labels::NAMES {
            let points = layer_in(of_labels(name).unwrap()).point_field().expect("a field of points");
            assert_eq!(points.labels.name(), name);
        }
    }
}
