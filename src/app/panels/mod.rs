//! What stands around the canvas and the texture.

pub mod colour;
mod growth_bar;
mod inspector;
mod layers;
mod menu;
mod result;
mod selected;
mod sketch_bar;
mod status;
mod strip;

pub use colour::ColourPanel;
pub use growth_bar::growth_bar;
pub use inspector::{Tab, inspector};
pub use menu::menu;
pub use sketch_bar::sketch_bar;
pub use status::status;
pub use strip::strip;
