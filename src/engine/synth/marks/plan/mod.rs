//! Plans of a layer, in stages. Each stage is made from the one before:
//!
//! ```text
//!  document ─▶ Targets ──look_up──▶ Lookup ──corrected──▶ Corrected ──lay_out──▶ Plan ──begin──▶ Begun
//!              what is asked,       system, cells,        questions corrected   among the       nuclei: places,
//!              may it be            parameters            by probes             layers beneath  spread and distances
//! ```
//!
//! The engine takes a [`Begun`], painting takes a [`Plan`]. Neither changes while the layer grows: corrections of a growth are
//! stored beside them.

mod answers;
pub mod around;
mod arrange;
pub mod asked;
mod auto;
pub mod begun;
mod beyond;
mod cell_corners;
mod cell_parameters;
pub mod cell_size;
pub mod corrected;
mod drawn_marks;
mod drawn_spots;
pub mod free_spacing;
pub mod inside;
pub mod laid_out;
pub mod lattice;
mod layer_grid;
pub mod layer_lookup;
pub mod looked_up;
pub mod mark_cells;
pub mod obstacle_mask;
pub mod offset;
pub mod offset_curves;
pub mod one_spot;
pub mod pinned_marks;
pub mod raggedness;
pub mod setting;
pub mod spacing_correction;
pub mod spread;
pub mod spread_limits;
mod targets;
pub mod visible_part;

pub use answers::Answers;
pub use arrange::Surroundings;
pub use asked::Asked;
pub use begun::{Begun, Nuclei};
pub use cell_size::{cell_for, exact_cell};
pub use corrected::Corrected;
pub use free_spacing::free_spacing;
pub use laid_out::{Arrangement, Plan};
pub use layer_grid::finest_cell;
pub use layer_lookup::{Lookup, Start, look_up, look_up_on};
pub use setting::Setting;
pub use targets::Targets;
