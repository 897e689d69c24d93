//! What stands around the canvas and the texture.

mod alternatives;
pub mod colour;
mod growth_bar;
mod inspector;
mod layer_details;
mod layers;
mod meets;
mod menu;
mod result;
mod selected;
mod sketch_bar;
mod status;
mod strip;

pub use alternatives::{HEIGHT, alternatives};
pub use colour::ColourPanel;
pub use growth_bar::growth_bar;
pub use inspector::{Tab, inspector};
pub use menu::menu;
pub use result::digits;
pub use sketch_bar::sketch_bar;
pub use status::status;
pub use strip::strip;
