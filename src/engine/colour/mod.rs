//! Field → picture: pattern values to colours.
//!
//! A [`Gradient`] computes the exact colour of a pattern value; its [`Table`] is a lookup table with an entry for each of the 65536
//! values of a 16-bit picture of the pattern. [`paint()`] colours every px of every layer; [`FineTable`] has more than 8 bits and
//! opacity, [`Ground`] a second colour of the ground. [`Gradient::pattern_of`] converts colours back to pattern values. [`ColourModel`] gives the coordinates in which people
//! pick colours. [`Set`] holds the default colours of documents, [`PRESETS`] colours to choose from; [`gpl`] reads and writes
//! palettes of other programs.

mod bezier;
pub mod gpl;
mod gradient;
mod ground;
mod inverse;
mod models;
mod oklab;
mod opacity;
mod paint;
mod presets;
mod sets;
mod table;

pub use bezier::Bend;
pub use gradient::{Gradient, Stop};
pub use ground::Ground;
pub use models::{ColourModel, Coordinate};
pub use oklab::{linear_light, oklab_of_light, srgb_of_oklab};
pub use opacity::FineTable;
pub use paint::{Painted, over, paint, paint_rows, painter};
pub use presets::{Group, Marking, PRESETS, Preset};
pub use sets::{BY_LAYER, COATS, Set};
pub use table::Table;
