//! The panels around sketch and texture. Each takes what it shows and returns the actions that the user asks for.

mod alternatives;
mod canvas;
mod colour;
mod column;
mod context_menu;
mod draw;
mod entries;
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
mod starters;
mod status;
mod tools;
mod wanted;

pub use alternatives::{HEIGHT, alternatives};
pub use canvas::{CanvasState, canvas};
pub use colour::{ColourPanel, colour};
pub use column::column;
pub use context_menu::context_menu;
pub use draw::{DrawState, draw};
pub use growth_bar::growth_bar;
pub use layers::{LayersPanel, layers};
pub use menu::{MenuKeys, MenuState, menu};
pub use result::{ResultPanel, ResultState, paint_signs, result};
pub use sketch_bar::sketch_bar;
pub use starters::starters;
pub use status::status;
pub use tools::tools;
