//! Growing on a model: a document with a `model` → spots on its surface.
//!
//! ```text
//!  bytes ─▶ placed ─▶ anchors ─▶ plan ─▶ growth ─▶ threshold ─▶ grown ─▶ report, picture, .glb, .ply
//!           px, prepared   what is wanted where   remeshed, parameters by vertex   the level of each anchor
//! ```
//!
//! A spot on a surface is the flat spot, corrected for how fine the mesh is: training sets and lookup are those of the flat canvas.

mod anchors;
mod answer_table;
mod area_form;
mod areas;
mod asked;
mod begin;
mod beneath;
mod choice;
mod clearance;
mod coat;
mod curves;
mod describe;
mod direction_report;
mod displaced;
mod drawn_spacing;
mod finished;
mod flow;
mod given_directions;
mod got;
mod grown;
mod growth;
mod laid;
mod layer;
mod maps;
mod models;
mod needs;
mod output;
mod pair_form;
mod pair_stripes;
mod placed;
mod plan;
mod point_form;
mod ragged;
mod refusals;
mod remeshed;
mod report;
mod shown;
mod texture;
mod texture_coordinates;
mod threshold;
mod varied;
mod wanted;

pub use describe::{DescribedBody, describe};
pub use direction_report::DirectionReport;
pub use displaced::Displaced;
pub use grown::GrownBody;
pub use growth::{BodyGrowth, BodyProgress};
pub use layer::BodyLayer;
pub use models::MATERIAL;
pub use placed::Placed;
pub use plan::BodyPlan;
pub use report::{AnchorReport, BodyLayerReport, BodyReport, ModelReport};
pub use shown::Shown;
pub use texture::{LaidOut, NoTexture, Texture};

#[cfg(test)]
mod bad_models;
#[cfg(test)]
mod kinds_tests;
#[cfg(test)]
mod maps_tests;
#[cfg(test)]
mod tests;
