//! Field → picture: pattern values to colours.
//!
//! A [`Gradient`] says which colour a pattern value has, exactly; its [`Table`] says the same fast, one
//! entry for each of the 65536 steps that a 16-bit picture of the pattern knows. [`paint()`] looks every px
//! of every layer up; [`Fine`] does so with more than 8 bit, and with opacity. [`Set`] holds the colours that a document
//! gets when it names none, [`PRESETS`] those to choose from; [`gpl`] is how other programs keep colours.

mod bezier;
pub mod gpl;
mod gradient;
mod opacity;
mod paint;
mod presets;
mod sets;
mod table;

pub use bezier::Bend;
pub use gradient::{Gradient, GradientError, Stop};
pub use opacity::Fine;
pub use paint::{Painted, paint, paint_rows, painter};
pub use presets::{Group, Marking, PRESETS, Preset};
pub use sets::{BY_LAYER, COATS, Set};
pub use table::Table;
