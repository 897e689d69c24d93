//! Small pictures of what each system grows, and each kind of labels of a field of points, beside their names.
//!
//! Each was grown by dapple, and holds its document: `docs/window.md` says how they are renewed.

use egui::{Context, Id, TextureHandle, TextureOptions, Vec2, vec2};

use crate::app::assets::{Asset, asset, decoded};

/// Size of a picture, points: half of its px, so that it is sharp on fine screens.
pub const SIZE: Vec2 = vec2(48.0, 32.0);

/// By name of the kind of labels.
const LABELS: [(&str, Asset); 8] = [
    ("values", asset!("labels/values.png")),
    ("random", asset!("labels/random.png")),
    ("image", asset!("labels/image.png")),
    ("space-giraffe", asset!("labels/space-giraffe.png")),
    ("breadth-first", asset!("labels/breadth-first.png")),
    ("depth-first", asset!("labels/depth-first.png")),
    ("round-robin", asset!("labels/round-robin.png")),
    ("connected", asset!("labels/connected.png")),
];

/// The picture of a kind of labels, where there is one.
pub fn of_labels(name: &str) -> Option<Asset> {
    LABELS.iter().find(|(of, _)| *of == name).map(|(_, asset)| *asset)
}

/// The picture of what the system of this name in documents grows; `None` where there is none.
pub fn of_system(ctx: &Context, name: &str, png: &[u8]) -> Option<TextureHandle> {
    if png.is_empty() {
        return None;
    }
    let id = Id::unique(("small picture", name));
    if let Some(known) = ctx.data(|data| data.get_temp(id)) {
        return Some(known);
    }
    // The pictures are inside the engine; a test decodes them all.
    let texture = ctx.load_texture(name, decoded(png).ok()?, TextureOptions::LINEAR);
    ctx.data_mut(|data| data.insert_temp(id, texture.clone()));
    Some(texture)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Labels, Layer, SystemChoice};

    /// The layer that is in the small picture `name` of a folder, after it was seen that this can be shown.
    fn layer_in(folder: &str, name: &str, bytes: &[u8]) -> Layer {
        assert!(bytes.len() < 16_000, "{name}: {} bytes", bytes.len());
        let image = decoded(bytes).unwrap();
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
            assert_eq!(layer_in("systems", name, system.picture()).system, system, "{name}");
        }
    }

    #[test]
    fn every_kind_of_labels_has_a_small_picture_that_was_grown_with_it() {
        assert_eq!(LABELS.len(), Labels::NAMES.len());
        for name in Labels::NAMES {
            let points = layer_in("labels", name, of_labels(name).unwrap().bytes)
                .point_field()
                .expect("a field of points");
            assert_eq!(points.labels.name(), name);
        }
    }
}
