//! The numbers that a document may hold: every bound in one place.
//!
//! These are the bounds of a *file*. Whether the machine has enough memory, and whether a system can grow it, is checked
//! when the document is grown.

use std::fmt;

use crate::attributes::periods::PeriodRules;
use crate::points::patches::Patches;
use crate::points::stripe_variation::StripeVariation;
use crate::rd::pairs::Stucco;

/// The longest side of a canvas, px; two of them make 2³² px, where a 32-bit count of px ends.
pub const MAX_SIDE: u32 = 65_536;
/// Longer ÷ shorter side of a seamless canvas. Marks that are far larger than the shorter side have copies of themselves as neighbours;
/// on 20000 × 1 px there are hundreds of thousands, and to find the nearest takes minutes. At 256 it took 2 s.
pub const MAX_TILE_RATIO: f64 = 256.0;
/// Most columns and most rows of regions.
pub const MAX_REGIONS: u32 = 64;
/// Most layers: a label is one byte of which 0 means none.
pub const MAX_LAYERS: usize = 255;
/// Most textures that a document keeps beside its own.
pub const MAX_STARRED: usize = 64;
/// Longest name of a document or a layer, characters.
pub const MAX_NAME: usize = 1_000;
/// Largest file that is read, bytes: a million freehand points take about 40 MB.
pub const MAX_FILE: u64 = 256 << 20;
/// Characters that a link may have. Browsers open longer ones, but few programs pass them on.
pub const MAX_LINK: usize = 64 << 10;
/// Bytes of text that a link may hold: far more than documents of [`MAX_LINK`] characters have, while deflate can write a thousand
/// times what it reads.
pub const MAX_LINK_TEXT: usize = 1 << 20;
/// Shortest length, width or radius, px: well below what a px can show, well above where squares underflow.
pub const MIN_LENGTH: f64 = 0.01;
/// The spacing that is asked for far from all ellipses, px. The upper limit exceeds the distance of any two marks on a canvas.
pub const FAR_SPACING: Range = Range { low: MIN_LENGTH, high: 2.0 * MAX_SIDE as f64, unit: "px" };
/// The longest side of a model.
pub const BODY_SIDE: Range = Range { low: 1.0, high: MAX_SIDE as f64, unit: "px" };
/// A coordinate of a model.
pub const MODEL: Range = Range { low: -1e12, high: 1e12, unit: "" };
/// Least length of a vector that is accepted as a direction.
pub const SHORTEST: f64 = 1e-30;
/// Most pins of a model, most strokes on it, and most names of its groups.
pub const MAX_PINS: usize = 1_000;
/// Dots an inch.
pub const DPI: Range = Range { low: 1.0, high: 100_000.0, unit: "dots an inch" };
/// Stripe width ÷ period. Below this range thin stripes break into pieces, above it the gaps between wide stripes do.
pub const DUTY: Range =
    Range { low: PeriodRules::STRIPES.duties[0], high: PeriodRules::STRIPES.duties[1], unit: "" };
/// Irregularity of spots.
pub const IRREGULAR: Range = Range { low: 0.0, high: 1.0, unit: "" };
/// Place of a colour stop: a pattern value.
pub const STOP: Range = Range { low: 0.0, high: 1.0, unit: "" };
/// The distance from the marks beneath at which marks near them become rare.
pub const NEAR: Range = Range { low: 2.0, high: 1_000.0, unit: "px" };
/// A share that a map gives; below 0 it counts as 0, above 1 as 1, so that a slow map can have steep borders.
pub const MAP_SHARE: Range = Range { low: -5.0, high: 5.0, unit: "" };
/// How far the colours of the ground reach from the edge of a mark. At the least it is a px or two of most patterns.
pub const HALO: Range = Range { low: 0.05, high: 1.0, unit: "" };
/// x of a Bezier handle: inside the gap, or the curve would turn back (as in CSS).
pub const BEND_X: Range = Range { low: 0.0, high: 1.0, unit: "" };
/// y of a Bezier handle: it may overshoot the two colours, by no more than twice their distance.
pub const BEND_Y: Range = Range { low: -2.0, high: 3.0, unit: "" };

/// Coefficient of variation of the areas of a layer's spots.
pub const SPREAD_AREA: Range = Range { low: 0.0, high: 0.6, unit: "" };
/// Root mean square deviation of their directions; 52° means that all directions are equally frequent.
pub const SPREAD_ANGLE: Range = Range { low: 0.0, high: 45.0, unit: "degrees" };
/// Standard deviation of their aspects.
pub const SPREAD_ASPECT: Range = Range { low: 0.0, high: 0.2, unit: "" };
/// Coefficient of variation of their distances.
pub const SPREAD_SPACING: Range = Range { low: 0.0, high: 0.2, unit: "" };

/// σ of the edges of patches. Above this range dense patches have no room for longer fringes, and others fall to pieces.
pub const RAGGED: Range = Range { low: 0.0, high: 0.5, unit: "" };
/// Standard deviation ÷ mean of the width along stripes.
pub const VARY: Range = Range { low: 0.0, high: StripeVariation::MOST_VARY, unit: "" };
/// The share of stripes that open into two.
pub const DOUBLE: Range = Range { low: 0.0, high: 1.0, unit: "" };
/// Points a patch.
pub const DETAIL: Range = Range { low: Patches::LEAST_DETAIL, high: Patches::MOST_DETAIL, unit: "points" };
/// Width of the lines between cells: below 1 px they cannot be seen, and the finest grid is that fine.
pub const GAP: Range = Range { low: 1.0, high: 1_000.0, unit: "px" };
/// Blotches around a rosette: one is a ring with a gap, more than twelve cannot be told apart.
pub const ROSETTE_PARTS: [u64; 2] = [1, 12];
/// The share of patches that stay solid.
pub const ROSETTE_SOLID: Range = Range { low: 0.0, high: 1.0, unit: "" };
/// How deep the blotches of a rosette are.
pub const ROSETTE_WIDTH: Range = Range { low: 2.0, high: 1_000.0, unit: "px" };
/// Dots inside a rosette: more find no room.
pub const ROSETTE_DOTS: [u64; 2] = [0, 6];
/// The pattern inside a rosette: at ½ it would be a mark.
pub const ROSETTE_TINT: Range = Range { low: 0.0, high: 0.45, unit: "" };
/// Decrease of the gain of stucco. Above this range blotches vanish.
pub const DECAY: Range = Range { low: 0.0, high: Stucco::MOST_DECAY, unit: "" };
/// Most corners of an outline: with a corner every 4 px a patch may be 1,200 px wide. The test for crossings tries all pairs of
/// sides that lie one above the other, so its time limits the number.
pub const MAX_CORNERS: usize = 1_000;
/// Largest share of the area of an outline in the smaller loop, if the outline crosses itself. Such a loop comes from a small error in
/// closing the outline by hand.
pub const LOOP: f64 = 0.05;

/// Longest side of the picture in a tone, px: 18 px for each of 56 stripes, and about 600 kB in the document.
pub const TONE_SIDE: u32 = 1_024;
/// Share of ink that a tone asks for.
pub const INK: Range = Range { low: 0.0, high: 1.0, unit: "" };
/// Weight of the drawn direction against the edges of a picture. From 10 on, edges do not change the direction.
pub const SKETCH: Range = Range { low: 0.0, high: 10.0, unit: "" };

/// Area of spots that a map asks for.
pub const MAP_AREA: Range = Range { low: 1.0, high: 1e8, unit: "px²" };
/// Parameter G of Turing's growth that a map asks for. Below this range b dies out, above it no ground is left.
pub const MAP_GROWTH: Range = Range { low: 17.5, high: 27.5, unit: "" };
/// Distance of marks that a map asks for.
pub const MAP_SPACING: Range = Range { low: 1.0, high: 1e4, unit: "px" };
/// Direction that a map asks for, or angle by which it rotates directions. Two full turns allow a spiral to be painted as one ramp.
pub const MAP_DIRECTION: Range = Range { low: -720.0, high: 720.0, unit: "degrees" };
/// Minor ÷ major radius that a map asks for, from the narrowest spots that grow to round ones.
pub const MAP_ASPECT: Range = Range { low: 0.2, high: 1.0, unit: "" };
/// Factor of a map that multiplies.
pub const MAP_FACTOR: Range = Range { low: 0.1, high: 10.0, unit: "" };
/// Shift of colours by a map, as a share of the gradient; ground and edge are half a gradient apart.
pub const MAP_SHIFT: Range = Range { low: -0.5, high: 0.5, unit: "" };
/// Size of the noise of a map: distance from a light place to the next dark one.
pub const MAP_SIZE: Range = Range { low: 2.0, high: 1e5, unit: "px" };
/// Octaves of the noise of a map, at most: an eighth has 1/128 of the weight of the first.
pub const MAP_OCTAVES: u32 = 8;

/// Distance of the points of a field: closer points cannot be seen.
pub const POINT_DISTANCE: Range = Range { low: 2.0, high: 1e5, unit: "px" };
/// Octaves of a field of points, at most: an eighth has 1/128 of the weight of the first.
pub const POINT_OCTAVES: u32 = 8;
/// Length of the axes of points, in edges. Below 1 some places are hardly within the reach of any point; the time grows with the
/// square.
pub const AXIS: Range = Range { low: 1.0, high: 2.0, unit: "" };
/// ε, how strongly the weights of points are shifted.
pub const SHIFT: Range = Range { low: 0.0, high: 1.0, unit: "" };
/// Share of the canvas on which a field of points is above its threshold. Outside this range a small change of the threshold
/// changes the share much.
pub const POINT_SHARE: Range = Range { low: 0.02, high: 0.98, unit: "" };
/// Points of a group with one value.
pub const GROUP: [u32; 2] = [1, 100];
/// Points of a cluster.
pub const CLUSTER: [u32; 2] = [1, 10_000];
/// Most rings of points by which borders and nets are thickened.
pub const RINGS: u32 = 8;
/// Passes by a picture, at most: the eighth has points 1/11 as far apart as the first.
pub const PASSES: u32 = 8;
/// Rays of the cells of a space giraffe: fewer than 3 enclose nothing.
pub const RAYS: [u32; 2] = [3, 60];
/// The probability that a point is an end of a net.
pub const START: Range = Range { low: 0.001, high: 1.0, unit: "" };

/// Height of white above black in a picture of heights, px.
pub const RELIEF: Range = Range { low: 0.0, high: MAX_SIDE as f64, unit: "px" };

/// Share of a ring that is open.
pub const BROKEN: Range = Range { low: 0.0, high: 0.6, unit: "" };

/// A number's bounds, both included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Smallest number allowed.
    pub low: f64,
    /// Largest number allowed.
    pub high: f64,
    /// Its unit; empty if it has none.
    pub unit: &'static str,
}

impl Range {
    /// Any finite number of degrees: angles are axial and read mod 180.
    pub const ANGLE: Self = Self { low: f64::MIN, high: f64::MAX, unit: "degrees" };
    /// A radius or width on the largest canvas.
    pub const THICKNESS: Self = Self { low: MIN_LENGTH, high: MAX_SIDE as f64, unit: "px" };
    /// A coordinate on the largest canvas and around it.
    pub const AROUND: Self = Self { low: -(MAX_SIDE as f64), high: 2.0 * MAX_SIDE as f64, unit: "px" };

    /// A radius or width on a canvas of `size` px: no thicker than the canvas' longer side.
    #[must_use]
    pub fn thickness(size: [u32; 2]) -> Self {
        Self { high: f64::from(size[0].max(size[1])), ..Self::THICKNESS }
    }

    /// A coordinate of a centre, an end or a point, which may be outside the canvas by as much as the length of its side.
    #[must_use]
    pub fn around(side: u32) -> Self {
        Self { low: -f64::from(side), high: 2.0 * f64::from(side), ..Self::AROUND }
    }

    /// The corners of the rectangle around a canvas of `size` px in which [`Self::around`] keeps points.
    #[must_use]
    pub fn around_canvas(size: [u32; 2]) -> [[f64; 2]; 2] {
        let sides = size.map(Self::around);
        [sides.map(|side| side.low), sides.map(|side| side.high)]
    }

    /// Whether `number` lies in it; NaN does not.
    #[must_use]
    pub fn holds(&self, number: f64) -> bool {
        self.low <= number && number <= self.high
    }
}

impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        if *self == Self::ANGLE {
            return write!(f, "any finite number of degrees");
        }
        write!(f, "a number from {} to {}", self.low, self.high)?;
        if self.unit.is_empty() { Ok(()) } else { write!(f, " {}", self.unit) }
    }
}
