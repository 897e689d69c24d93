//! Models → pictures and files: [`draw()`] shows them lit from above, [`glb()`] and [`ply()`] write them with colours by vertex.
//!
//! Colours are linear light, red, green and blue, from 0 to 1. y is up unless a [`View`] says otherwise.

mod camera;
mod curved;
mod draw;
mod fine;
mod floor;
mod glb;
mod light;
mod normals;
mod paint;
mod ply;
mod raster;
mod scene;
mod shadow;
mod smooth;
mod vector;

pub use camera::View;
pub use draw::{Picture, draw};
pub use fine::Fine;
pub use glb::glb;
pub use normals::normals;
pub use paint::{Coloured, Paint, Painted};
pub use ply::ply;
pub use smooth::Smooth;
