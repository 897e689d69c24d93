//! Small pictures of what each system grows, and each kind of labels of a field of points, beside their names.
//!
//! Each was grown by dapple, and holds its document: `docs/window.md` says how they are renewed.

use egui::{Color32, ColorImage, Context, Id, TextureHandle, TextureOptions, Vec2, vec2};

/// Size of a picture, points: half of its px, so that it is sharp on fine screens.
pub const SIZE: Vec2 = vec2(48.0, 32.0);

macro_rules! pictures {
    ($folder:literal: $($name:literal),* $(,)?) => {
        &[$(($name, include_bytes!(concat!("../../../../assets/", $folder, "/", $name, ".png")).as_slice())),*]
    };
}

/// By name of the kind of labels.
const LABELS: &[(&str, &[u8])] = pictures!["labels":
    "values",
    "random",
    "image",
    "space-giraffe",
    "breadth-first",
    "depth-first",
    "round-robin",
    "connected",
];

/// The picture of a kind of labels, as a PNG; empty where there is none.
pub fn of_labels(name: &str) -> &'static [u8] {
    LABELS.iter().find(|(of, _)| *of == name).map_or(&[], |(_, png)| png)
}

/// A `png`, which is kept under this name; `None` where it is empty.
pub fn texture(ctx: &Context, name: &str, png: &[u8]) -> Option<TextureHandle> {
    if png.is_empty() {
        return None;
    }
    let id = Id::unique(("small picture", name));
    if let Some(known) = ctx.data(|data| data.get_temp(id)) {
        return Some(known);
    }
    let texture = ctx.load_texture(name, decoded(png), TextureOptions::LINEAR);
    ctx.data_mut(|data| data.insert_temp(id, texture.clone()));
    Some(texture)
}

fn decoded(bytes: &[u8]) -> ColorImage {
    match image::load_from_memory(bytes) {
        Ok(image) => {
            let image = image.into_rgba8();
            let size = [image.width() as usize, image.height() as usize];
            ColorImage::from_rgba_unmultiplied(size, image.as_raw())
        }
        // The pictures are inside the program; a test decodes them all.
        Err(_) => ColorImage::filled([1, 1], Color32::TRANSPARENT),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Labels, Layer, SystemChoice};

    /// The layer that is in the small picture `name` of a folder, after it was seen that this can be shown.
    fn layer_in(folder: &str, name: &str, bytes: &[u8]) -> Layer {
        assert!(bytes.len() < 16_000, "{name}: {} bytes", bytes.len());
        let image = decoded(bytes);
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
            let points = layer_in("labels", name, of_labels(name)).point_field().expect("a field of points");
            assert_eq!(points.labels.name(), name);
        }
    }
}
