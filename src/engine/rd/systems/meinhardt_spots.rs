//! Meinhardt spots.
//!
//! ∂a/∂t = s(0.01 a²β/b − p₁a + p₃) + ∇·(Dₐ∇a)
//! ∂b/∂t = s(0.01 a²β − p₂b + p₃) + ∇·(D_b∇b)
//!
//! Meinhardt, "Models of biological pattern formation" (1982); in this form Turk (1991) and Phan & Grimm
//! (2006), appendix B. A spot is a peak of a. R = D_b/Dₐ sets the spacing of spots of one size.

use multiversion::multiversion;

use crate::attributes::Attribute;
use crate::attributes::columns;
use crate::attributes::system::{
    Crowding, Description, Intervals, IsolatedSpots, LookupBy, Scaling, picture,
};
use crate::grid::{exp, ln};
use crate::rd::by_ratio::ByRatio;
use crate::rd::chemicals::reacting;
use crate::rd::definition::{
    Begin, Convergence, Cost, Definition, ErrorBounds, Laws, MarkCells, MergingDistance, OwnVariation,
    Resolution, Scatter, SpotLimits, System, TurnLimit, Variation,
};
use crate::rd::kinetics::{Kinetics, Spreading};
use crate::rd::parameter_field::Parameters;
use crate::rd::selling::PrincipalAxes;
use crate::rd::sparse::reacting_by_rows;
use crate::rd::sweep;
use crate::rd::systems::embedded;
use crate::rd::vector::Number;

impl System {
    /// Two chemicals; spots of any size and any spacing.
    pub const MEINHARDT_SPOTS: Self = Self::new(&DEFINITION);
}

static DEFINITION: Definition = Definition {
    description: Description {
        name: "meinhardt-spots",
        title: "Meinhardt's spots",
        noun: "Meinhardt's spots",
        help: "Spots with the drawn spacing, all of them ellipses",
        picture: picture!("meinhardt-spots"),
        alternative: Some("Meinhardt's system: rounder spots, as far apart as they are drawn"),
        free_spacing: true,
        fixed_places: true,
        tone: true,
        option_keys: &["spread", "keep", "irregular", "ragged"],
        lookup: LookupBy::Rows,
        columns: &columns::SPOTS,
        training: embedded!("meinhardt-spots-narrow", "meinhardt-spots-orientation", "meinhardt-spots-size"),
        neighbours: &[32, 40, 225, 32, 40, 40],
        // Areas are proportional to 1/R within 7 % from 12 to 60, and to e^(2.85 (½ − l)) from threshold ½ to 0.2 (`facts.md` B).
        scaling: Scaling { ratio: 1.0, level: 2.85 },
        isolated: Some(ISOLATED),
        ..Description::PLAIN
    },
    chemicals: &["a", "b"],
    spread: &MeinhardtSpots::SPREAD,
    tensors: &[PrincipalAxes::of_unit_determinant],
    mobilities,
    reacting: |_, _, planes| reacting(MeinhardtSpots, planes),
    by_rows: Some(|rows, _| reacting_by_rows(MeinhardtSpots, rows)),
    fineness: Some(include_bytes!(concat!(env!("OUT_DIR"), "/fineness.rows"))),
    begin: Begin::Bells { radius: |p| radius(p.ratio) / p.apart(), fill },
    peaks: Some(peaks),
    show: |chemicals, peaks, marks| show_peaks(chemicals[0], peaks, marks),
    decay_noise: None,
    along_curves: None,
    obstacle: &OBSTACLE,
    obstacle_rim: 0.0,
    g: None,
    decay: P2,
    // `facts.md` B.
    reaction_limit: 1.0,
    super_step_limit: 4.0,
    laws: Laws {
        size: area,
        spacing,
        // Fitted to spots of 40–60 cells at ratios 12–120 and levels 0.2–0.5.
        rate: |area, ratio, level| {
            163.0 * libm::pow(12.0 / ratio, 0.89) * libm::exp(2.85 * (0.5 - level)) / area
        },
    },
    // This reduces errors of 3 % in area, 3 % in aspect and 1° to 0.9 %, 0.5 % and 0.4°.
    compensation: 10.0,
    resolution: Resolution {
        least: 9.0,
        enough: 11.0,
        thin_side: false,
        planned: MarkCells::always(48.0),
        exact: MarkCells::always(120.0),
    },
    convergence: Convergence { earliest: 15.0, latest: 120.0, drift: 0.004, corrected: 4.0, still: 0.01 },
    scatter: Scatter { size: 0.0008, spacing: 0.005, elongation: 0.001, direction: 0.05 },
    tolerated: Scatter { size: 0.01, spacing: 0.02, elongation: 0.01, direction: 0.5 },
    level_slope: -1.44,
    spots: Some(SpotLimits {
        // Of nine pairs among other spots, round and long, along and across, none merged at distances of 0.41, 0.52, 0.60, 0.66
        // and 0.70 spacings where area ÷ spacing² was 0.032, 0.085, 0.13, 0.17 and 0.21; closer by 0.02 some merged, by 0.06
        // nearly all.
        merging: MergingDistance { least: 0.24, by_root_density: 1.02 },
        own_variation: OwnVariation { area: 0.03, shape: 0.005 },
        variation: Variation::ByDensity {
            // Of 280 spots at 0.21 one merged at 0.5, none at 0.35; of 900 at 0.165 one at 0.5.
            free_density: 0.124,
            area_by_density: 3.4,
            // Of 600 spots one merged at 10° (length 0.85) and at 20° (0.67), none at 30° (0.59); a per cent did at
            // twice that.
            turn: TurnLimit { degrees: 8.5, length: 0.85, power: 3.0 },
            // Neighbours push spots back from more uneven places.
            spacing: 0.16,
        },
    }),
    cost: Cost { seconds_a_cell: 4e-6, bytes_a_cell: 140.0, updates: 0.8, updates_on_one_grid: 0.8 },
    sweep: &[sweep::AREA, sweep::RATIO, sweep::LEVEL, sweep::STRETCH, sweep::DIRECTION],
    usual_rate: 2.0,
    error_bounds: ErrorBounds {
        looked_up: &[
            (Attribute::Area, [3.0, 8.0]),
            (Attribute::Spacing, [2.5, 7.0]),
            (Attribute::Aspect, [0.008, 0.03]),
            (Attribute::Angle, [0.5, 1.5]),
        ],
        refined: &[
            (Attribute::Area, [0.5, 1.5]),
            (Attribute::Spacing, [1.5, 5.0]),
            (Attribute::Aspect, [0.006, 0.02]),
            (Attribute::Angle, [0.4, 1.2]),
        ],
    },
};

/// Spots without neighbours. The ground between them is inert: no spot appears by itself.
const ISOLATED: IsolatedSpots = IsolatedSpots {
    // Spots of ratio 12 split in two without end; those of 13, 14, 15, 20, 30 do not, and settle after 510, 600, 740,
    // 1,450 and 2,450 steps.
    ratio: 15.0,
    // The highest threshold is used if spots have room, down to the lowest otherwise. At a low threshold a spot of one size is the
    // foot of a smaller peak.
    highest_level: 0.5,
    lowest_level: 0.25,
    // Measured 205–209 at 27–136 cells, stretch 0.3–1.
    area: 208.4,
    // At thresholds ½, 0.35, ¼ area · rate was 208.4, 320.5, 425.
    foot: 1.03,
    // Patches of pitch 1, 1.5, 2.5, 4 had 127.4, 179.4, 208.0, 208.9.
    crowding: Crowding { c: 0.389, a: 1.33, b: 1.45 },
    spacing: 36.0,
    // Patches of 160 spots at ratios 12–85: 1.006 (stretch 0.7–1), 1.003 (0.6), 0.998 (0.5), 1.000 (0.4), 0.968 (0.3).
    round: 1.007,
    by_stretch: -0.02,
    // At this pitch a neighbour may be a third closer than the mean.
    alone: 1.6,
    merging: 1.0,
    // Grids of 27–136 cells a spot, stretch 0.3–1, five directions.
    intervals: Intervals { area: 0.012, aspect: 0.012, angle: 0.8, spacing: 0.03 },
};

/// a and b.
#[derive(Clone, Copy, Debug)]
pub struct MeinhardtSpots;

/// Decay of a.
const P1: f32 = 0.03;
/// Decay of b.
pub const P2: f32 = 0.04;
/// Lower bounds of a and b. Far from any spot both decay for ever; without bounds a² and b would underflow in 32 bits, and a²/b
/// would be NaN. The bounds are too low to be visible, and the bound of b is so far above that of a that a²/b stays negligible.
const LEAST: [f32; 2] = [1e-17, 1e-12];
// β = 1 and p₃ = 0: noise in β makes spots uneven, p₃ > 0 makes them sparser (`facts.md` B).

impl Kinetics<2> for MeinhardtSpots {
    const SPREAD: [Spreading; 2] =
        [Spreading::Tensor { tensor: 0, mobility: 0 }, Spreading::Tensor { tensor: 0, mobility: 1 }];

    #[inline(always)]
    fn react<V: Number>(&self, [a, b]: [V; 2]) -> [V; 2] {
        let source = V::splat(0.01) * a * a;
        [source / b - V::splat(P1) * a, source - V::splat(P2) * b]
    }

    #[inline(always)]
    fn bounded<V: Number>([a, b]: [V; 2]) -> [V; 2] {
        [a.at_least(LEAST[0]), b.at_least(LEAST[1])]
    }
}

/// a at the centre of a spot. Fitted to `facts.md` B, within 4 % for R 10–200.
#[inline]
fn peak(ratio: f32) -> f32 {
    (3.3 * exp(0.765 * ln(f64::from(ratio) / 10.0))) as f32
}

/// [`peak`] at each ratio.
#[multiversion(targets("x86_64+avx2"))]
fn peaks(ratios: &[f32], peaks: &mut [f32]) {
    peaks.iter_mut().zip(ratios).for_each(|(value, ratio)| *value = peak(*ratio));
}

/// Distance of spots × √rate. Fitted to `facts.md` B.
fn spacing(ratio: f32) -> f64 {
    let r = f64::from(ratio);
    36.0 + 0.045 * (r - 15.0)
}

/// Area of a spot at half its peak × rate. `facts.md` B: area · R is constant within 5 % for R 12–30, and 13 % larger at 50.
fn area(ratio: f32) -> f64 {
    1960.0 / f64::from(ratio)
}

/// Radius of an initial bell ÷ spacing: about that of the spot that grows from it.
fn radius(ratio: f32) -> f64 {
    0.6 * libm::pow(f64::from(ratio), -0.45)
}

/// Dₐ and D_b of mean 1.
pub fn mobilities(p: &Parameters) -> [f32; 2] {
    [1.0 / p.ratio.sqrt(), p.ratio.sqrt()]
}

/// a ÷ its value at the centre of a mark.
pub fn show_peaks(a: &[f32], peaks: &[f32], marks: &mut [f32]) {
    for ((mark, a), peak) in marks.iter_mut().zip(a).zip(peaks) {
        *mark = a / peak;
    }
}

/// Bells on the nuclei (`facts.md` G).
///
/// Where spots are far apart, the ground has no a: away from spots a decays as exp(−p₁/p₂·T), more slowly than b, and the
/// ground would form a pattern once a/b = 3, at T = 15.
fn fill(chemicals: &mut [&mut [f32]], bells: &[f32], parameters: &[Parameters]) {
    let mut peak = ByRatio::new(peak);
    for (i, (bell, p)) in bells.iter().zip(parameters).enumerate() {
        let ground = if p.apart() > 1.0 { 0.0 } else { 0.02 };
        (chemicals[0][i], chemicals[1][i]) = (ground + peak.at(p.ratio) * bell, 0.3);
    }
}

/// No activator, and the inhibitor concentration between spots.
const OBSTACLE: [f32; 2] = [0.0, 0.4];
