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

/// A width or a share that differs by more than this share from what was expected is noted.
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
    /// Wall time of the growth and of writing its pictures.
    pub seconds: f64,
    /// One a layer, the lowest first.
    pub layers: Vec<LayerReport>,
}

/// What has grown on one layer.
#[derive(Clone, Debug, Serialize)]
pub struct LayerReport {
    /// The layer's name.
    pub name: String,
    /// The reaction-diffusion system.
    pub system: &'static str,
    /// Whether its stripes are the gaps between the lines that grow, because they cover more than half.
    pub inverted: bool,
    /// px a cell.
    pub cell: f64,
    /// Cells along x and y.
    pub grid: [usize; 2],
    /// Steps taken.
    pub steps: u64,
    /// Whether the pattern settled within the step limit.
    pub settled: bool,
    /// One a region, row by row; empty of pairs.
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
    /// One a direction of a weave.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub threads: Vec<ThreadReport>,
    /// What the user should know of a weave; regions have notes of their own.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
    /// The note which names drawn marks that are not there.
    #[serde(skip)]
    pub note_on_drawn: Option<String>,
    /// The centres of whole spots that are two grown together, px.
    #[serde(skip)]
    pub merged: Vec<[f64; 2]>,
    /// Places of marks that have grown by half, px.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub half_grown: Vec<[f64; 2]>,
    /// Its field of points.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub points: Option<PointsReport>,
    /// How near it is to the picture that drives it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tone: Option<ToneReport>,
    /// What Turing's growth has made.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub growth: Option<GrowthReport>,
    /// What became of each drawn mark; empty where none was to be among those that grow.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub drawn: Vec<DrawnMark>,
    /// `Some(false)` for a layer whose marks are replaced by those of the layer above; otherwise `None`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shown: Option<bool>,
}
