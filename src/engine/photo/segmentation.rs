//! Segments a photograph into its marks as a field: 0 = ground, 1 = marks, and the threshold of their edges.

use std::sync::Arc;

use super::ink_shares::{InkShares, ink_shares};
use super::lab::Lab;
use super::mark_colours::MarkColours;
use super::{Raster, channel, edge, scale};
use crate::grid::blur::gaussian;
use crate::grid::{Edges, Field};
use crate::measure::{self, Picture};

/// A segmentation of marks and ground.
#[derive(Clone, Debug)]
pub struct Segmentation {
    /// 0 = ground, 1 = marks, not clipped; on cells of whole px of the photograph.
    pub field: Field,
    /// The threshold of the marks' edges in it.
    pub level: f32,
    /// Distance from one mark to the next, px.
    pub wavelength: f64,
    /// The usual difference of marks and ground, OKLab.
    pub contrast: f64,
    /// Deviations within marks and within ground, as a share of the contrast: root mean square.
    pub uneven: f64,
    /// The working copy; `None` for a pattern, which has no colours.
    pub lab: Option<Arc<Lab>>,
    /// Whether the picture is a pattern whose threshold is known: its marks need not be found.
    pub is_pattern: bool,
}

/// Most cells of the copy in which the wavelength is sought: in a photograph of 24 Mpx waves of 16 px are still visible.
const SEEN: usize = 4 << 20;
/// Number of cells to which a photograph is reduced if its marks allow it.
const ENOUGH: usize = 1 << 20;
/// Most cells, for any marks: larger copies take more than 5 s and 1 GB.
const MOST: usize = 8 << 20;
/// Cells per wavelength that the working copy keeps if the photograph has them: areas of round spots are then accurate to 1 %.
const FINE: f64 = 16.0;
/// Cells per wavelength in the copy from which only kind and spacing are found.
const COARSE: f64 = 8.0;
/// Standard deviation of the first high pass, as a share of the shorter side: light varies more slowly.
const LIGHT: f64 = 1.0 / 12.0;
/// Standard deviation of the widest blur before the segmentation ÷ wavelength: it reduces round spots by 3 %.
const WIDEST: f64 = 0.06;
/// Noise is blurred until only this share of the contrast is left.
const NOISE: f64 = 0.04;
/// Largest factor between the measured spacing and the first wavelength; with a larger one it is not a spacing of marks.
const TURN: f64 = 3.0;
/// Several colours of marks are used if they leave less than this share of the deviations in the single channel: for two kinds of
/// dots of different colours about half is left, for shaded marks and a shaded ground all of it.
const EVENER: f64 = 0.7;
/// If the shares of marks and ground differ by less than this from ½, the marks are the separate regions, or else the darker ones.
const EVEN: f64 = 0.05;

/// The kind of the marks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum MarkKind {
    /// Spots, which may be shaded.
    Spots,
    /// Stripes, or not yet known.
    Bands,
}

impl MarkKind {
    /// Standard deviation of the least blur ÷ wavelength. For spots any blur reduces the area, 0.03 by up to 8 % for narrow ones.
    /// Straight edges stay where they are, and noise along them lengthens their contour, which 0.04 halves.
    const fn least_blur(self) -> f64 {
        match self {
            Self::Spots => 0.0,
            Self::Bands => 0.04,
        }
    }

    /// Position of the edge from ½ towards the steepest value, 0..1, for marks that repeat after `wavelength` cells. Measured on
    /// grown textures. The error of the area of spots is then 1.8 % (median) in clean pictures and 7.8 % in degraded ones; with 1
    /// it is 3.7 and 8.9 %, with 0 it is 10–22 % for shaded ones. For stripes of a few cells the steepest value is meaningless:
    /// wood grain 4 px wide has an error of 13 % with 0.7 and of 8 % with 0.
    fn trust(self, wavelength: f64) -> f64 {
        if self == Self::Bands && wavelength < THIN { 0.0 } else { 0.7 }
    }
}

/// Cells per wavelength below which stripes are thin.
const THIN: f64 = 12.0;

/// Segments a photograph. The marks cover less than the ground, or more if `invert`. If both cover nearly the same, the marks are
/// the one that consists of spots, or else the darker one.
///
/// Between its steps it calls `goes_on` with the share that is done; the result is `None` if that returns false.
#[must_use]
pub fn segment(
    raster: &Raster,
    invert: bool,
    goes_on: &(dyn Fn(f64) -> bool + Sync),
) -> Option<Segmentation> {
    let lab = Lab::of(raster, reduced_to(raster, SEEN));
    let rough = rough_wavelength(&lab) * lab.factor as f64;
    drop(lab);
    if !goes_on(0.35) {
        return None;
    }
    // As few cells as are enough, if that leaves enough of them per wavelength.
    let [least, most] = [reduced_to(raster, MOST), reduced_to(raster, ENOUGH)];
    let factor = |fine: f64| ((rough / fine) as usize).clamp(least, most);
    let (wavelength, kind) = first_look(&Lab::of(raster, factor(COARSE)), rough, invert);
    if !goes_on(0.6) {
        return None;
    }
    let lab = Lab::of(raster, factor(FINE));
    let found = segmented(&lab, wavelength / lab.factor as f64, kind, invert);
    Some(Segmentation { lab: Some(Arc::new(lab)), ..found })
}

/// The segmentation of a pattern whose threshold is known, such as one that dapple wrote; `raster` has its colours. Its wavelength
/// is found with its marks.
#[must_use]
pub fn known(field: Field, level: f32, raster: Option<&Raster>) -> Segmentation {
    let lab = raster.map(|raster| Arc::new(Lab::of(raster, 1)));
    Segmentation { field, level, wavelength: 0.0, contrast: 1.0, uneven: 0.0, lab, is_pattern: true }
}

/// The factor that leaves at most this number of cells.
fn reduced_to(raster: &Raster, cells: usize) -> usize {
    let px = raster.size[0] * raster.size[1];
    (1..).find(|factor| px / (factor * factor) <= cells).unwrap_or(1)
}

/// The distance of the marks, px, and their kind, as found with the `rough` wavelength, px.
fn first_look(lab: &Lab, rough: f64, invert: bool) -> (f64, MarkKind) {
    let once = segmented(lab, rough / lab.factor as f64, MarkKind::Bands, invert);
    let (spacing, kind) = match measure::picture(&once.field, once.level) {
        Some(Picture::Spots { got, .. }) => (got.spacing, MarkKind::Spots),
        Some(Picture::Stripes { got, .. }) => (Some(got.wavelength), MarkKind::Bands),
        None => (None, MarkKind::Bands),
    };
    (spacing.unwrap_or(rough).clamp(rough / TURN, rough * TURN), kind)
}

/// The wavelength of the strongest variation, cells.
fn rough_wavelength(lab: &Lab) -> f64 {
    let axis = channel::axis(lab, LIGHT * lab.size[0].min(lab.size[1]) as f64);
    scale::wavelength(&channel::channel(lab, axis), lab.size)
}

/// Segments a working copy whose marks repeat after about `wavelength` cells.
fn segmented(lab: &Lab, wavelength: f64, kind: MarkKind, invert: bool) -> Segmentation {
    let axis = channel::axis(lab, wavelength);
    let mut channel = channel::channel(lab, axis);
    let apart = deviation(&channel, &super::coarse::wide(&channel, lab.size, wavelength));
    let noise = noise(&channel, lab.size, wavelength);
    // A Gaussian of σ cells leaves 1 ÷ (2√π·σ) of the noise of single cells.
    let enough = noise / (2.0 * std::f64::consts::PI.sqrt() * NOISE * 2.0 * apart.max(f64::MIN_POSITIVE));
    let sigma = enough.clamp(kind.least_blur() * wavelength, WIDEST * wavelength);
    channel = gaussian(&channel, lab.size, sigma, Edges::Closed);
    let InkShares { mut share, mut contrast } = ink_shares(&channel, lab.size, wavelength);
    if let Some(colours) = MarkColours::of(lab, &share) {
        let shares = colours.shares(lab);
        if unevenness(&shares) < EVENER * unevenness(&share) {
            (share, contrast) = (gaussian(&shares, lab.size, sigma, Edges::Closed), colours.contrast());
        }
    }
    let ink = share.iter().filter(|share| **share > 0.5).count() as f64 / share.len() as f64;
    // The channel rises with the lightness: ink is the lighter part.
    let marks_are_ink = ink < 0.5 - EVEN;
    if marks_are_ink == invert {
        share.iter_mut().for_each(|share| *share = 1.0 - *share);
    }
    let [width, height] = lab.size;
    let field = Field { width, height, cell: [lab.factor as f64; 2], edges: Edges::Closed, values: share };
    let level = edge::level(&field.values, lab.size, kind.trust(wavelength));
    let is_even = (0.5 - EVEN..0.5 + EVEN).contains(&ink);
    let (field, level) = if is_even { spots_of_either(field, level, invert) } else { (field, level) };
    let uneven = unevenness(&field.values);
    Segmentation {
        field,
        level,
        wavelength: wavelength * lab.factor as f64,
        contrast: f64::from(contrast),
        uneven,
        lab: None,
        is_pattern: false,
    }
}

/// If marks and ground cover nearly equal areas, the one of them that consists of spots becomes the marks, or the others if
/// `invert`; unchanged if both are spots, or neither.
fn spots_of_either(field: Field, level: f32, invert: bool) -> (Field, f32) {
    let is_spotted =
        |field: &Field, level: f32| matches!(measure::picture(field, level), Some(Picture::Spots { .. }));
    let other = Field { values: field.values.iter().map(|share| 1.0 - share).collect(), ..field.clone() };
    if is_spotted(&field, level) == invert && is_spotted(&other, 1.0 - level) != invert {
        (other, 1.0 - level)
    } else {
        (field, level)
    }
}

/// Root mean square of a difference.
fn deviation(values: &[f32], slow: &[f32]) -> f64 {
    let square = |(value, slow): (&f32, &f32)| f64::from(value - slow) * f64::from(value - slow);
    (values.iter().zip(slow).map(square).sum::<f64>() / values.len().max(1) as f64).sqrt()
}

/// Standard deviation of the noise of single cells of a picture whose marks repeat after `wavelength` cells.
///
/// A compressed picture has lost the noise of single px, but not that of squares of them: the larger of both is used if marks are
/// much larger than these squares.
fn noise(values: &[f32], size: [usize; 2], wavelength: f64) -> f64 {
    let single = roughness(values, size);
    if wavelength < COARSE_ENOUGH || size.iter().any(|side| *side < 8) {
        return single;
    }
    let [width, height] = size.map(|side| side / 2);
    let square = |k: usize| {
        let at = 2 * (k / width) * size[0] + 2 * (k % width);
        0.25 * (values[at] + values[at + 1] + values[at + size[0]] + values[at + size[0] + 1])
    };
    let squares: Vec<f32> = (0..width * height).map(square).collect();
    single.max(2.0 * roughness(&squares, [width, height]))
}

/// Cells per wavelength from which on second differences of squares of 2 × 2 cells are only noise.
const COARSE_ENOUGH: f64 = 24.0;

/// Standard deviation of the noise of single cells, from the median size of a second difference, on which edges have no effect.
///
/// J. Immerkær, "Fast noise variance estimation", CVIU 64 (1996), with the median in place of the mean.
fn roughness(values: &[f32], [width, height]: [usize; 2]) -> f64 {
    /// Distance between the rows and columns that are sampled: enough for any picture.
    const STEP: usize = 3;
    /// Median of |x| of the normal distribution, and the norm of the weights.
    const SCALE: f64 = 0.674_49 * 6.0;
    let mut sizes = Vec::new();
    for y in (1..height.saturating_sub(1)).step_by(STEP) {
        for x in (1..width.saturating_sub(1)).step_by(STEP) {
            let line = |y: usize| {
                values[y * width + x - 1] - 2.0 * values[y * width + x] + values[y * width + x + 1]
            };
            sizes.push((line(y - 1) - 2.0 * line(y) + line(y + 1)).abs());
        }
    }
    if sizes.is_empty() {
        return 0.0;
    }
    let middle = sizes.len() / 2;
    let (_, median, _) = sizes.select_nth_unstable_by(middle, f32::total_cmp);
    f64::from(*median) / SCALE
}

/// Deviations within marks and ground: root mean square of the shares' distance from 0 and 1.
fn unevenness(share: &[f32]) -> f64 {
    let off = |share: &f32| f64::from(if *share > 0.5 { share - 1.0 } else { *share });
    (share.iter().map(|share| off(share) * off(share)).sum::<f64>() / share.len().max(1) as f64).sqrt()
}
