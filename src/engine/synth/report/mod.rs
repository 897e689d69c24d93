//! The report of a growth: what was asked, what was looked up and what has grown. Each kind of layer fills in its own part.

pub mod covered;
pub mod drawn;
mod parts;
pub mod pinned;
pub mod region;
pub mod stripe_along;

pub use drawn::DrawnMark;
pub use parts::{
    GrowthReport, PointsReport, PointsShare, ShareReport, ThreadErrors, ThreadReport, ToneReport, WidthReport,
};
pub use region::{RaggednessReport, RegionReport};

use serde::Serialize;

/// Least relative difference of a width or a share from the expected value that is noted.
pub const NOTED: f64 = 0.06;

/// The report of a growth. Serialised, it is the JSON of `grow --report`.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// The name of the document's file.
    pub document: String,
    /// The canvas, px.
    pub size: [u32; 2],
    /// The document's seed.
    pub seed: u64,
    /// Wall time of the growth and of writing its pictures, s.
    pub seconds: f64,
    /// The reports of the layers, the lowest first.
    pub layers: Vec<LayerReport>,
}

/// The report of one layer.
#[derive(Clone, Debug, Serialize)]
pub struct LayerReport {
    /// The layer's name.
    pub name: String,
    /// The reaction-diffusion system.
    pub system: &'static str,
    /// Whether its stripes are the gaps between the lines that grow, because they cover more than half of their period.
    pub inverted: bool,
    /// px a cell.
    pub cell: f64,
    /// Cells along x and y.
    pub grid: [usize; 2],
    /// Steps taken.
    pub steps: u64,
    /// Whether the pattern settled within the step limit.
    pub settled: bool,
    /// The reports of the regions, row by row; empty for pairs.
    pub regions: Vec<RegionReport>,
    /// The lines between cells.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gap: Option<WidthReport>,
    /// The blotches of stucco.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub blotches: Option<WidthReport>,
    /// The share of the canvas that streaks or cracks cover.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub share: Option<ShareReport>,
    /// The reports of the directions of a weave.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub threads: Vec<ThreadReport>,
    /// Notes for the user on the layer; regions have notes of their own.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
    /// The note that names missing drawn marks.
    #[serde(skip)]
    pub note_on_drawn: Option<String>,
    /// The centres of whole spots that are two merged ones, px.
    #[serde(skip)]
    pub merged: Vec<[f64; 2]>,
    /// Places of half-grown marks, px.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub half_grown: Vec<[f64; 2]>,
    /// Its field of points.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub points: Option<PointsReport>,
    /// Agreement with the picture that drives the layer.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tone: Option<ToneReport>,
    /// The pattern of Turing's growth.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub growth: Option<GrowthReport>,
    /// The report on each drawn mark; empty if none was to be kept.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub drawn: Vec<DrawnMark>,
    /// `Some(false)` for a layer whose marks are replaced by those of the layer above; otherwise `None`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shown: Option<bool>,
}
