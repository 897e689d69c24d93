//! Measures a picture, and decides whether it shows spots or stripes.

use super::raggedness::spot_raggedness;
use super::spots::{Census, Spot, census};
use super::stripes::{StripeStatistics, stripes};
use crate::attributes::moments::weighted_variation;
use crate::attributes::spacing::{mean_length, neighbours};
use crate::attributes::{Spots, Spread};
use crate::grid::{Edges, Field};
use crate::marks::Ellipse;

/// The marks of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Picture {
    /// Separate ellipses.
    Spots {
        /// Number of whole spots, over which the means are taken.
        marks: usize,
        /// Means over them.
        got: Spots,
        /// Spread of the spots.
        spread: Spread,
        /// Their mean raggedness: (contour ÷ contour of the ellipse with equal moments)², 1 for an ellipse; `None` if it was not
        /// measured.
        raggedness: Option<f64>,
    },
    /// Long or connected bands.
    Stripes {
        /// Number of connected bands, also those cut by the border.
        marks: usize,
        /// Their statistics.
        got: StripeStatistics,
    },
}

impl Picture {
    /// These measurements with the raggedness of the spots above `level`.
    #[must_use]
    pub fn with_raggedness(self, field: &Field, level: f32) -> Self {
        let Self::Spots { marks, got, spread, .. } = self else { return self };
        let ragged = spot_raggedness(field, level);
        let raggedness = (!ragged.is_empty()).then(|| ragged.iter().sum::<f64>() / ragged.len() as f64);
        Self::Spots { marks, got, spread, raggedness }
    }
}

/// Contour² ÷ (4π·area): 1 for a disc, 1.8 for an ellipse of aspect 0.25; a band of ten widths has 3.
const LONG: f64 = 2.5;

/// Least fill of the ellipse of a region's own moments: ellipses reach it; bands, even short ones, do not.
const ROUND: f64 = 0.97;

/// Measures the spots or stripes above `level`. `None` if there are neither: nothing is above it, or only noise.
///
/// They are stripes if more than half of the area is in bands: regions that are long (contour² ÷ (4π·area) above 2.5) or endless,
/// and no ellipses.
///
/// ```
/// use dapple_engine::grid::{Edges, Field};
/// use dapple_engine::measure::{Picture, picture};
///
/// let wave = |[x, _]: [f64; 2]| (x * std::f64::consts::TAU / 16.0).sin() as f32;
/// let stripes = Field::from_fn([64, 64], [1.0, 1.0], Edges::Wrap, wave);
/// let Some(Picture::Stripes { got, .. }) = picture(&stripes, 0.0) else { panic!("bands were drawn") };
/// assert!((got.wavelength - 16.0).abs() < 0.5 && (got.angle - 90.0).abs() < 1.0);
/// ```
#[must_use]
pub fn picture(field: &Field, level: f32) -> Option<Picture> {
    picture_of(field, level, &census(field, level))
}

/// Measures the spots or stripes of a [`census`] of the field at this level. `None` if there are neither.
#[must_use]
pub fn picture_of(field: &Field, level: f32, census: &Census) -> Option<Picture> {
    let total: f64 = census.spots.iter().map(|spot| spot.ellipse.area()).sum();
    let bands = census.spots.iter().filter(|spot| is_band(spot));
    let banded: f64 = bands.map(|spot| spot.ellipse.area()).sum();
    if banded > 0.5 * total {
        let got = stripes(field, level)?;
        // Thresholded noise consists of bands narrower than two px.
        let cell = field.cell[0].max(field.cell[1]);
        return (got.width >= 2.0 * cell).then_some(Picture::Stripes { marks: census.spots.len(), got });
    }
    // More specks than spots: thresholded noise, unless they are dust beside far larger spots.
    let is_noise = census.specks > 2 * census.spots.len() && census.speck_area > DUST * total;
    if is_noise { None } else { spotted(field, census) }
}

/// Specks that cover less than this share of the area of the spots are dust. Specks of thresholded noise, of single px or blurred
/// by up to 3 px, cover at least 0.06 if they are twice as many as its spots.
const DUST: f64 = 0.03;

/// Measures the regions above `level` as spots, however ragged or long they are: patches. `None` if no whole region is above it.
#[must_use]
pub fn patches(field: &Field, level: f32) -> Option<Picture> {
    Some(spotted(field, &census(field, level))?.with_raggedness(field, level))
}

fn is_band(spot: &Spot) -> bool {
    let long = spot.contour * spot.contour > LONG * 4.0 * std::f64::consts::PI * spot.ellipse.area();
    spot.endless || long && !(spot.whole && spot.fill > ROUND)
}

fn spotted(field: &Field, census: &Census) -> Option<Picture> {
    let whole: Vec<Ellipse> =
        census.spots.iter().filter(|spot| spot.whole).map(|spot| spot.ellipse).collect();
    let centers: Vec<[f64; 2]> = census.spots.iter().map(|spot| spot.ellipse.center).collect();
    // All spots are neighbours, also those that are cut.
    let edges = neighbours(&centers, (field.edges == Edges::Wrap).then(|| field.extent()));
    let weighted = edges.iter().map(|edge| (edge.length, edge.weight));
    Some(Picture::Spots {
        marks: whole.len(),
        raggedness: None,
        got: Spots { spacing: mean_length(&edges), ..Spots::measure(&whole)? },
        spread: Spread { spacing: weighted_variation(weighted), ..Spread::measure(&whole) },
    })
}
