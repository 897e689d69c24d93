//! The panels around sketch and texture. Each takes what it shows and returns the actions that the user asks for.

mod alternatives;
mod colour;
mod column;
mod draw;
mod form;
mod growth_bar;
mod layer_details;
mod layers;
mod meets;
mod menu;
mod notes;
mod result;
mod selected;
mod sketch_bar;
mod status;
mod tools;
mod wanted;

pub use alternatives::{HEIGHT, alternatives};
pub use colour::{ColourPanel, colour};
pub use column::column;
pub use draw::{DrawState, draw};
pub use growth_bar::growth_bar;
pub use layers::{LayersPanel, layers};
pub use menu::{MenuState, menu};
pub use result::{ResultPanel, ResultState, paint_signs, result};
pub use sketch_bar::sketch_bar;
pub use status::status;
pub use tools::tools;
