//! How much of a drawn line lies in the stripes that grew.

use crate::attributes::regions::RegionGrid;
use crate::grid::resample::Spline;
use crate::marks::Path;
use crate::synth::pattern::EDGE;

/// The share of a drawn line that is to lie in a stripe.
pub(super) const COVERED: f64 = 0.9;

/// The share of a path (px) that lies in a stripe of the pattern `surface`, of what of it lies on the canvas and is not `hidden`
/// by marks of the layers beneath; `None` where nothing is left.
#[must_use]
pub fn covered(
    path: &Path,
    layout: &RegionGrid,
    surface: &Spline,
    hidden: impl Fn([f64; 2]) -> bool,
) -> Option<f64> {
    const POINTS: usize = 64;
    let points = path.samples(POINTS).into_iter().map(|sample| sample.point);
    let on = |point: &[f64; 2]| layout.bounds().contains(*point) && !hidden(*point);
    let points: Vec<[f64; 2]> = points.filter(on).collect();
    let covered = points.iter().filter(|point| surface.at(**point) >= EDGE).count();
    (!points.is_empty()).then(|| covered as f64 / points.len() as f64)
}
