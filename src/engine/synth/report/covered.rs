//! The share of a drawn line that lies in grown stripes.

use crate::attributes::regions::RegionGrid;
use crate::grid::resample::Spline;
use crate::marks::Path;
use crate::synth::pattern::EDGE;

/// The least share of a drawn line in a stripe for the line to count as kept.
pub(super) const COVERED: f64 = 0.9;

/// The share of a path (px) that lies in a stripe of the pattern `surface`. Parts outside the canvas, or `hidden` by marks of the
/// layers beneath, are ignored; `None` if nothing else is left.
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
