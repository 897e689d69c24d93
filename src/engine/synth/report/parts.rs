//! What the report of a layer says beside its regions, each of some systems alone.

use serde::Serialize;

use crate::attributes::Stripes;

/// A width alone: of the lines between cells, or of blotches.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct WidthReport {
    /// The mean width that was asked for, px.
    pub asked: f64,
    /// The width of what grew, px: of lines all that no cell covers, by their length. `None` where it cannot be measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub got: Option<f64>,
}

/// The share of the canvas that lines cover.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ShareReport {
    /// What was asked for, of what the layers beneath left free, 0..1.
    pub asked: f64,
    /// What grew.
    pub got: f64,
}

/// The threads of one direction.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ThreadReport {
    /// The lines that were drawn in this direction.
    pub lines: usize,
    /// Width, distance (px) and direction that were asked for, their means.
    pub asked: Stripes,
    /// What grew; `None` where none did.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub got: Option<Stripes>,
    /// By how much it differs: shares of width and wavelength, degrees.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error: Option<ThreadErrors>,
}

/// By how much grown threads differ from what was asked for at their places.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ThreadErrors {
    /// Share of the width.
    pub width: f64,
    /// Share of the distance from one to the next.
    pub wavelength: f64,
    /// The mean, degrees.
    pub angle: f64,
    /// The root mean square, degrees.
    pub angle_rms: f64,
}

/// A grown field of points.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PointsReport {
    /// What gave the points their values.
    pub labels: &'static str,
    /// How many points there are, of all octaves.
    pub count: usize,
    /// The smallest and the largest distance that was asked for, px.
    pub distance: [f64; 2],
    /// The share of the canvas above the edge.
    pub share: PointsShare,
}

/// The share of the canvas above the edge, of what the layers beneath left free, 0..1.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct PointsShare {
    /// What was asked for, if anything was.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub asked: Option<f64>,
    /// What grew.
    pub got: f64,
}

/// How near a layer is to the picture that drives it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ToneReport {
    /// Width and height of the picture, px.
    pub image: [usize; 2],
    /// What follows it.
    pub drives: Vec<&'static str>,
    /// The usual distance from one mark to the next, px.
    pub wavelength: f64,
    /// The correlation of ink and tone, both blurred by half a wavelength and by one; `None` of an even tone.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub correlation: Option<[f64; 2]>,
    /// Their mean absolute difference, as a share of ink.
    pub difference: [f64; 2],
    /// The median turn of the lines from the directions wanted where these are clear, degrees.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub direction: Option<f64>,
}

/// What Turing's growth has made.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct GrowthReport {
    /// The lowest and the highest growth.
    pub range: [f32; 2],
    /// The usual distance from one mark to the next, px.
    pub wavelength: f64,
    /// The share of the canvas that is ink, 0..1.
    pub ink: f64,
}
