//! Checks whether a grown field is a texture that is suitable as training data, and if not, why.

use super::spots::{Census, Spot};
use super::stripes::StripeStatistics;
use crate::grid::Field;

/// The reason why a grown field is not a texture.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum Reason {
    /// A value is NaN or infinite.
    #[error("the field holds values that are not finite: the step was too large")]
    NotFinite,
    /// The range of values is too small: no pattern formed, or it vanished.
    #[error("no pattern: values span {range}, at least {least} is needed")]
    NoPattern {
        /// Highest − lowest value.
        range: f32,
        /// The least range of a pattern.
        least: f32,
    },
    /// A value is far beyond the range of the system: the growth diverged.
    #[error("a value is {value}, far outside the usual {} to {}", usual[0], usual[1])]
    LeftRange {
        /// The value that is farthest out.
        value: f32,
        /// Usual values of the ground and of the centre of a mark.
        usual: [f32; 2],
    },
    /// The picture still changed at the end of its time.
    #[error("did not settle: still forming when its time was over")]
    Unsettled,
    /// Too few whole spots to take means over.
    #[error("too few spots: {marks} whole ones, at least {least} are needed")]
    TooFew {
        /// Whole spots.
        marks: usize,
        /// The least number.
        least: usize,
    },
    /// Too few stripes side by side to take means over.
    #[error("too few stripes: {wavelengths:.1} wavelengths across, at least {least} are needed")]
    TooFewStripes {
        /// Wavelengths along a side.
        wavelengths: f64,
        /// The least number.
        least: f64,
    },
    /// The spots are smaller than the grid resolves.
    #[error("spots of {cells:.1} cells are too small for the grid, at least {CELLS} are needed")]
    TooSmall {
        /// Mean area, cells.
        cells: f64,
    },
    /// Spots have merged into bars, webs or a labyrinth.
    #[error("merged: {bent:.0} % of the area belongs to marks that are no ellipses, mean fill {fill:.3}")]
    Merged {
        /// Share of the area in marks that fill less than 0.93 of their ellipse or are endless, per cent.
        bent: f64,
        /// Mean fill of the whole marks.
        fill: f64,
    },
    /// The spots differ too much in size for one mean to represent them.
    #[error("spots differ in area by {spread:.2} of the mean, at most {SPREAD} is allowed")]
    TooIrregular {
        /// Coefficient of variation of the area.
        spread: f64,
    },
    /// Stripes without a direction of their own.
    #[error("stripes have no direction: coherence {coherence:.2}, at least {COHERENCE} is needed")]
    NoDirection {
        /// Mean coherence.
        coherence: f64,
    },
    /// Nearly all or nearly none of the canvas is above the level.
    #[error("{:.0} % of the canvas is inside the stripes, between 15 and 85 % is needed", 100.0 * share)]
    OneSided {
        /// Share of the canvas above the level.
        share: f64,
    },
}

impl Reason {
    /// All values of [`Self::kind`].
    pub const KINDS: [&'static str; 7] =
        ["unsettled", "no-pattern", "touching", "too-few", "too-small", "irregular", "left-range"];

    /// The reason in one word, for counting.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        let [unsettled, no_pattern, touching, too_few, too_small, irregular, left_range] = Self::KINDS;
        match self {
            Self::NotFinite | Self::LeftRange { .. } => left_range,
            Self::Unsettled => unsettled,
            Self::NoPattern { .. } => no_pattern,
            Self::TooFew { .. } | Self::TooFewStripes { .. } => too_few,
            Self::TooSmall { .. } => too_small,
            // Stripes in all directions are a labyrinth; regions that fill nearly everything have merged.
            Self::Merged { .. } | Self::NoDirection { .. } => touching,
            Self::OneSided { share } => {
                if *share > 0.5 {
                    touching
                } else {
                    no_pattern
                }
            }
            Self::TooIrregular { .. } => irregular,
        }
    }
}

/// Values that span less than this share of the usual range are no pattern: dead or fading ones were measured below it (`facts.md` 1,
/// rule 10).
const LEAST_RANGE: f32 = 0.1;
/// Values farther out than this multiple of the usual span have diverged. Settled marks were measured within a tenth of it;
/// Turing's spots of 2 cells, next to a dead cell, were at 2.2 times beyond it.
const BEYOND: f32 = 1.0;
/// Fewer whole spots give no useful mean.
const MARKS: usize = 6;
/// Below this size, soft spots are still measured to 2 %, but grown ones are affected by the grid (areas −20 % at 11 cells).
const CELLS: f64 = 7.0;
/// An ellipse fills 1, a rectangle 0.955, two merged spots less; mixed bars were measured at 0.93–0.98.
pub const MERGED_FILL: f64 = 0.93;
/// Largest share of the area in marks that fill less: one pair among 80 spots that touch exceeds it, and changes their mean area by
/// more than the difference between seeds.
const BENT: f64 = 0.02;
/// Mean fill: good textures were measured above 0.985, bars below 0.98, labyrinths below 0.85.
const MEAN_FILL: f64 = 0.98;
/// Coefficient of variation of the area, if all spots have equal parameters: 0.02–0.04 was measured for Meinhardt's, 0.03–0.08 for
/// Turing's; two doubled ones among 80 give 0.16.
const SPREAD: f64 = 0.15;
/// Least coherence: random waves of one length reach 0.48 in all directions (a labyrinth), 0.71 within ±45°, 0.94 within ±15°.
const COHERENCE: f64 = 0.7;

/// Checks that a pattern has formed, within the range of the system. `usual` are the values of the ground and of the
/// centre of a mark.
///
/// # Errors
/// The first [`Reason`] that applies.
pub fn check_formed(field: &Field, usual: [f32; 2]) -> Result<(), Reason> {
    if !field.values.iter().all(|value| value.is_finite()) {
        return Err(Reason::NotFinite);
    }
    let low = field.values.iter().copied().fold(f32::INFINITY, f32::min);
    let high = field.values.iter().copied().fold(f32::NEG_INFINITY, f32::max);
    let span = usual[1] - usual[0];
    let (under, over) = (usual[0] - low, high - usual[1]);
    if under.max(over) > BEYOND * span {
        return Err(Reason::LeftRange { value: if under > over { low } else { high }, usual });
    }
    let (range, least) = (high - low, LEAST_RANGE * span);
    if range >= least { Ok(()) } else { Err(Reason::NoPattern { range, least }) }
}

/// Checks that a field whose spots all have equal parameters is a texture of spots. `usual` as for [`check_formed`].
///
/// # Errors
/// The first [`Reason`] that applies.
pub fn check_spot_texture(field: &Field, census: &Census, usual: [f32; 2]) -> Result<(), Reason> {
    check_formed(field, usual)?;
    let whole: Vec<&Spot> = census.spots.iter().filter(|spot| spot.whole).collect();
    let sum = |chosen: &dyn Fn(&&Spot) -> bool| -> f64 {
        census.spots.iter().filter(chosen).map(|spot| spot.ellipse.area()).sum()
    };
    let area = sum(&|_| true).max(f64::MIN_POSITIVE);
    let bent = sum(&|spot| spot.endless || spot.whole && spot.fill < MERGED_FILL) / area;
    let mean =
        |value: &dyn Fn(&Spot) -> f64| whole.iter().map(|spot| value(spot)).sum::<f64>() / whole.len() as f64;
    let fill = if whole.is_empty() { 0.0 } else { mean(&|spot| spot.fill) };
    if bent > BENT || !whole.is_empty() && fill < MEAN_FILL {
        return Err(Reason::Merged { bent: 100.0 * bent, fill });
    }
    if whole.len() < MARKS {
        return Err(Reason::TooFew { marks: whole.len(), least: MARKS });
    }
    let usual = mean(&|spot| spot.ellipse.area());
    let cells = usual / (field.cell[0] * field.cell[1]);
    if cells < CELLS {
        return Err(Reason::TooSmall { cells });
    }
    let variance = mean(&|spot| (spot.ellipse.area() - usual) * (spot.ellipse.area() - usual));
    let spread = variance.sqrt() / usual;
    if spread > SPREAD { Err(Reason::TooIrregular { spread }) } else { Ok(()) }
}

/// Checks that a field is a texture of stripes. `usual` as for [`check_formed`].
///
/// # Errors
/// The first [`Reason`] that applies.
pub fn check_stripe_texture(
    field: &Field,
    found: Option<&StripeStatistics>,
    usual: [f32; 2],
) -> Result<(), Reason> {
    check_formed(field, usual)?;
    let Some(found) = found else { return Err(Reason::OneSided { share: all_or_nothing(field) }) };
    if !(0.15..=0.85).contains(&found.share) {
        return Err(Reason::OneSided { share: found.share });
    }
    if found.coherence < COHERENCE {
        return Err(Reason::NoDirection { coherence: found.coherence });
    }
    Ok(())
}

/// Share above the mid-range for a field in which no stripe has an edge.
fn all_or_nothing(field: &Field) -> f64 {
    f64::from(u8::from(field.values.first().is_some_and(|value| *value > 0.5)))
}
