//! Small pictures of what each system grows, beside their names.
//!
//! Each was grown by dapple, and holds its document: `docs/window.md` says how they are renewed.

use egui::{Color32, ColorImage, Context, Id, TextureHandle, TextureOptions, Vec2, vec2};

/// Size of a picture, points: half of its px, so that it is sharp on fine screens.
pub const SIZE: Vec2 = vec2(48.0, 32.0);

macro_rules! pictures {
    ($($name:literal),* $(,)?) => {
        &[$(($name, include_bytes!(concat!("../../../../assets/systems/", $name, ".png")).as_slice())),*]
    };
}

/// By name of the system; automatic has none, as it may grow any of them.
const PICTURES: &[(&str, &[u8])] = pictures![
    "stripes",
    "turing-spots",
    "meinhardt-spots",
    "meinhardt-stripes",
    "meinhardt-lines",
    "weave",
    "maze",
    "pair-stripes",
    "stucco",
    "patches",
    "cells",
    "streaks",
    "cracks",
    "points",
];

/// The picture of the system of this name; `None` of a system without one.
pub fn picture(ctx: &Context, name: &str) -> Option<TextureHandle> {
    let id = Id::unique(("system picture", name));
    if let Some(known) = ctx.data(|data| data.get_temp(id)) {
        return Some(known);
    }
    let (_, bytes) = PICTURES.iter().find(|(of, _)| *of == name)?;
    let texture = ctx.load_texture(name, decoded(bytes), TextureOptions::LINEAR);
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
    use crate::document::{SystemChoice, embedded};

    #[test]
    fn every_system_has_a_small_picture_that_it_has_grown_itself() {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/systems");
        for (name, system) in SystemChoice::NAMES.into_iter().filter(|(name, _)| *name != "auto") {
            let found = PICTURES.iter().find(|(of, _)| *of == name);
            let (_, bytes) = found.unwrap_or_else(|| panic!("no picture of {name}"));
            assert!(bytes.len() < 16_000, "{name}: {} bytes", bytes.len());
            let image = decoded(bytes);
            assert_eq!(image.size, [96, 64], "{name}");
            assert!(image.pixels.iter().any(|pixel| *pixel != image.pixels[0]), "{name} is empty");
            let path = folder.join(format!("{name}.png"));
            let (document, _) = embedded::in_picture(path).unwrap().expect("it holds its document");
            assert_eq!(document.layers[0].system, system, "{name}");
        }
    }
}
