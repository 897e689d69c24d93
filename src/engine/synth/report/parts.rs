//! Parts of the report of a layer besides its regions, each for some systems only.

use serde::Serialize;

use crate::attributes::Stripes;

/// A width alone: of the lines between cells, or of blotches.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct WidthReport {
    /// The mean width that was asked for, px.
    pub asked: f64,
    /// The grown width, px; for lines between cells the area outside all cells ÷ the length of the lines. `None` if it cannot be
    /// measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub got: Option<f64>,
}

/// The share of the canvas that lines cover.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ShareReport {
    /// The share that was asked for, of the area that the layers beneath left free, 0..1.
    pub asked: f64,
    /// The share that grew.
    pub got: f64,
}

/// The threads of one direction.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ThreadReport {
    /// The lines that were drawn in this direction.
    pub lines: usize,
    /// The width, distance (px) and direction that were asked for, as means.
    pub asked: Stripes,
    /// The grown threads; `None` if none grew.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub got: Option<Stripes>,
    /// The errors: relative for width and wavelength, degrees for the angle.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error: Option<ThreadErrors>,
}

/// Differences between grown threads and those asked for at their places.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ThreadErrors {
    /// Relative error of the width.
    pub width: f64,
    /// Relative error of the distance from one thread to the next.
    pub wavelength: f64,
    /// Mean error of the angle, degrees.
    pub angle: f64,
    /// Root mean square error of the angle, degrees.
    pub angle_rms: f64,
}

/// A grown field of points.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PointsReport {
    /// The kind of labels of the points.
    pub labels: &'static str,
    /// Number of points, of all octaves.
    pub count: usize,
    /// The smallest and the largest distance that was asked for, px.
    pub distance: [f64; 2],
    /// The share of the canvas above the edge.
    pub share: PointsShare,
}

/// The share above the edge, of the area that the layers beneath left free, 0..1.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct PointsShare {
    /// The share that was asked for, if any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub asked: Option<f64>,
    /// The share that grew.
    pub got: f64,
}

/// Agreement of a layer with the picture that drives it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ToneReport {
    /// Width and height of the picture, px.
    pub image: [usize; 2],
    /// The properties that follow it.
    pub drives: Vec<&'static str>,
    /// The usual distance from one mark to the next, px.
    pub wavelength: f64,
    /// The correlation of ink and tone, both blurred by half a wavelength and by one; `None` for an even tone.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub correlation: Option<[f64; 2]>,
    /// Mean absolute difference of ink and tone, as a share of ink.
    pub difference: [f64; 2],
    /// The median angle between the lines and the wanted directions, where these are clear, degrees.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub direction: Option<f64>,
}

/// The pattern of Turing's growth.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct GrowthReport {
    /// The lowest and the highest G.
    pub range: [f32; 2],
    /// The usual distance from one mark to the next, px.
    pub wavelength: f64,
    /// The share of the canvas that is ink, 0..1.
    pub ink: f64,
}
