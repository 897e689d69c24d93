//! Models → pictures and files: [`draw()`] shows them lit from above; [`glb()`] and [`ply()`] write them with colours by vertex,
//! [`textured_glb()`], [`gltf()`] and [`obj()`] with the pictures of a [`Skin`], [`stl()`] without colours.
//!
//! Colours are linear light, red, green and blue, from 0 to 1. y is up unless a [`View`] says otherwise.

mod blurred;
mod camera;
pub(super) mod curved;
mod draw;
mod fine;
mod floor;
mod glb;
mod light;
mod mips;
mod normals;
mod obj;
mod paint;
mod ply;
pub(super) mod raster;
mod scene;
mod shadow;
mod skin;
mod smooth;
mod stl;
pub(super) mod vector;

pub use blurred::{Blurred, is_far};
pub use camera::{View, length_of_px};
pub use draw::{Picture, draw};
pub use fine::Fine;
pub use glb::{glb, gltf, textured_glb};
pub use mips::Mips;
pub use normals::normals;
pub use obj::{mtl, obj};
pub use paint::{Coloured, Look, Paint, Painted};
pub use ply::ply;
pub use skin::{Skin, SkinPicture};
pub use smooth::Smooth;
pub use stl::stl;
