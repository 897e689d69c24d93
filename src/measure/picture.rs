//! A picture of spots or stripes, measured without knowing which.

use super::spots::{Census, Spot, census};
use super::stripes::{StripeStatistics, stripes};
use crate::attributes::spacing::{edges, mean_spacing, trimmed_mean};
use crate::attributes::{Spots, axial_mean};
use crate::field::{Edges, Field};

/// What a picture shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Picture {
    /// Separate ellipses.
    Spots {
        /// Whole ones, which the means are over.
        marks: usize,
        /// Means over them.
        got: Spots,
        /// How much they vary.
        spread: Spread,
    },
    /// Long or connected bands.
    Stripes {
        /// Connected bands, cut ones too.
        marks: usize,
        /// Their statistics.
        got: StripeStatistics,
    },
}

/// Coefficients of variation (standard deviation ÷ mean).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// Of the areas.
    pub area: f64,
    /// Of the aspects.
    pub aspect: f64,
    /// Of the distances between neighbours, where there are any.
    pub spacing: Option<f64>,
}

/// Contour² ÷ (4π·area): 1 for a disc, 1.8 for an ellipse of aspect 0.25; a band of ten widths has 3.
const LONG: f64 = 2.5;

/// Ellipses fill their own moments' ellipse; bands, even short ones, do not.
const ROUND: f64 = 0.97;

/// Spots or stripes above `level`? `None` where it is neither: nothing there, or only noise.
///
/// Stripes, where more than half of the area is in bands: regions that are long (contour² ÷ (4π·area) above
/// 2.5) or endless, and no ellipses.
#[must_use]
pub fn picture(field: &Field, level: f32) -> Option<Picture> {
    let census = census(field, level);
    let total: f64 = census.spots.iter().map(|spot| spot.ellipse.area()).sum();
    let bands = census.spots.iter().filter(|spot| is_band(spot));
    let banded: f64 = bands.map(|spot| spot.ellipse.area()).sum();
    if banded > 0.5 * total {
        let got = stripes(field, level)?;
        // Bands under two pixels are what thresholded noise is made of.
        let cell = field.cell[0].max(field.cell[1]);
        return (got.width >= 2.0 * cell).then_some(Picture::Stripes { marks: census.spots.len(), got });
    }
    // More specks than spots: thresholded noise.
    if census.specks > 2 * census.spots.len() { None } else { spotted(field, &census) }
}

fn is_band(spot: &Spot) -> bool {
    let long = spot.contour * spot.contour > LONG * 4.0 * std::f64::consts::PI * spot.ellipse.area();
    spot.endless || long && !(spot.whole && spot.fill > ROUND)
}

fn spotted(field: &Field, census: &Census) -> Option<Picture> {
    let whole: Vec<&Spot> = census.spots.iter().filter(|spot| spot.whole).collect();
    let areas: Vec<f64> = whole.iter().map(|spot| spot.ellipse.area()).collect();
    let aspects: Vec<f64> = whole.iter().map(|spot| spot.ellipse.aspect()).collect();
    let (area, area_spread) = mean_and_variation(&areas)?;
    let (aspect, aspect_spread) = mean_and_variation(&aspects)?;
    let angles = whole.iter().map(|spot| (spot.ellipse.major_angle(), 1.0 - spot.ellipse.aspect()));
    let centers: Vec<[f64; 2]> = census.spots.iter().map(|spot| spot.ellipse.center).collect();
    let lengths: Vec<f64> = match field.edges {
        Edges::Closed => {
            edges(&centers, None).iter().filter(|edge| !edge.hull).map(|edge| edge.length).collect()
        }
        Edges::Wrap => edges(&centers, Some(field.extent())).iter().map(|edge| edge.length).collect(),
    };
    let spacing = match field.edges {
        Edges::Closed => mean_spacing(&centers),
        Edges::Wrap => trimmed_mean(lengths.clone()),
    };
    let near: Vec<f64> =
        lengths.into_iter().filter(|length| spacing.is_some_and(|mean| *length <= 2.0 * mean)).collect();
    Some(Picture::Spots {
        marks: whole.len(),
        got: Spots { area, aspect, angle: axial_mean(angles).map_or(0.0, |(angle, _)| angle), spacing },
        spread: Spread {
            area: area_spread,
            aspect: aspect_spread,
            spacing: mean_and_variation(&near).map(|(_, spread)| spread),
        },
    })
}

fn mean_and_variation(values: &[f64]) -> Option<(f64, f64)> {
    if values.is_empty() {
        return None;
    }
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    let variance = values.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / n;
    Some((mean, variance.sqrt() / mean))
}
