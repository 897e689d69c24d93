//! Pictures that belong to the program. A desktop has them in the program; a browser loads them when they are needed.

use std::io;

use egui::{ColorImage, Context, Id, TextureHandle, TextureOptions};

use super::asset::decoded;
use super::platform;

pub use super::asset::Asset;

/// The picture of this name in a folder of the folder `assets`.
macro_rules! asset {
    ($folder:literal, $name:literal) => {
        $crate::app::asset::Asset {
            folder: $folder,
            name: $name,
            ending: "png",
            bytes: $crate::app::platform::asset_bytes!("assets/", $folder, "/", $name, ".png"),
        }
    };
}
pub(crate) use asset;

/// The document of this name in a folder of examples.
macro_rules! document {
    ($folder:literal, $name:literal) => {
        $crate::app::asset::Asset {
            folder: $folder,
            name: $name,
            ending: "dapple",
            bytes: $crate::app::platform::asset_bytes!($folder, "/", $name, ".dapple"),
        }
    };
}
pub(crate) use document;

/// The texture of a picture; `None` while it is being loaded.
pub fn texture(ctx: &Context, asset: Asset) -> Option<TextureHandle> {
    let id = Id::unique(("asset", asset.folder, asset.name));
    if let Some(known) = ctx.data(|data| data.get_temp(id)) {
        return Some(known);
    }
    let image = platform::asset_image(asset)?;
    let texture = ctx.load_texture(asset.name, image, TextureOptions::LINEAR);
    ctx.data_mut(|data| data.insert_temp(id, texture.clone()));
    Some(texture)
}

/// Reads and decodes a picture. In a browser this must not run on the page's thread, which must not block.
///
/// # Errors
///
/// Where the picture cannot be loaded.
pub fn image(asset: Asset) -> io::Result<ColorImage> {
    decoded(&platform::asset_read(asset)?)
}
