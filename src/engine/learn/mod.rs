//! Training rows → answers: which parameters give the wanted attributes.
//!
//! `data-gen` grows a texture for each of many parameters, measures it and writes a row. A
//! [`TrainingSet`] holds the rows of one system and answers with locally weighted regression
//! (Atkeson, Moore & Schaal, "Locally weighted learning", Artificial Intelligence Review 11, 1997;
//! the use for reaction-diffusion textures: Phan & Grimm, "Sketching reaction-diffusion texture"
//! (2006)), in coordinates in which the map is almost linear:
//!
//! ```text
//! spots    asked: ln A, ln(A/L²), v                    answered: ln(rate·A), ln ratio, level, w
//! stripes  asked: ln W, (cos 4θ, sin 4θ)               answered: ln(rate·W²), −ln stretch, (cos 2Δ, sin 2Δ)
//! lines    asked: ln W, ln(W/λ), (cos 4θ, sin 4θ)      answered: ln(rate·W²), −ln stretch, ln ratio, (cos 2Δ, sin 2Δ)
//!
//!          v = −ln(aspect)·(cos 2θ, sin 2θ)   w = −ln(stretch)·(cos 2φ, sin 2φ)   Δ = φ − θ
//!          A area, L spacing, W width, λ wavelength, θ angle; φ direction
//! ```
//!
//! All lengths here are cells of the simulation grid, because the discretisation error at small spots is part of what is
//! learnt. A question beyond the rows is never extrapolated: it is moved into their range, and the answer says so
//! ([`Coverage`]).

mod answer;
mod ask;
mod bandwidth;
mod brought_rows;
mod compiled_rows;
mod coordinates;
mod coverage;
mod csv_rows;
mod error;
mod errors;
mod folder;
mod folder_rows;
mod found;
mod gaps;
mod hold_out;
mod in_cells;
mod isolated_spots;
#[cfg(test)]
mod laws;
mod local;
mod manifest;
mod method;
mod neighbours;
mod note;
mod pairs;
mod row;
mod scale_law;
mod small_vector;
mod spot_ranges;
mod spot_regression;
mod stripe_regression;
#[cfg(test)]
mod tests;
mod training_set;
mod tree;
mod weighted_line;

pub use answer::{Answer, AskError, Prediction};
pub use brought_rows::bring_rows;
pub use coverage::Coverage;
pub use csv_rows::{line_of, shown, six_digits, write_rows};
pub use error::TrainingError;
pub use errors::{Error, Errors, summaries};
pub use folder::Folder;
pub use found::Found;
pub use gaps::of_gaps;
pub use hold_out::{Fold, evenly, folds};
pub use in_cells::{InCells, Lengths};
pub use method::Method;
pub use neighbours::Neighbour;
pub use note::{Note, Quantity};
pub use pairs::{HeldOut, PairAnswer, PairRow, PairSet, held_out, write_pair_row};
pub use row::{Parameters, Row};
pub use spot_regression::NARROWEST;
pub use training_set::TrainingSet;
