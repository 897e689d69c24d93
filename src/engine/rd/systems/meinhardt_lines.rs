//! Meinhardt lines: thin stripes on wide ground.
//!
//! ∂a/∂t = s(0.01 a²/b − p₁a) + ∇·(Dₐ∇a)
//! ∂b/∂t = s(0.01 a² − p₂b) + D_b∇²b
//!
//! The kinetics of [`crate::rd::systems::meinhardt_spots`], but only the activator diffuses by the tensor. Where it diffuses
//! farther along than across, spots merge to lines along its long axis (`facts.md` D, "oriented thin stripes"). Between the
//! lines a is almost 0 and no line appears by itself: lines stay where the initial conditions put them. R = D_b/Dₐ sets
//! the ratio of width to spacing.

use std::f64::consts::{PI, TAU};

use multiversion::multiversion;

use crate::attributes::Attribute;
use crate::attributes::Polarity;
use crate::attributes::columns;
use crate::attributes::system::{Description, LookupBy, MarkKind, Scaling, picture};
use crate::grid::{exp, ln};
use crate::rd::chemicals::reacting;
use crate::rd::definition::{
    Begin, Convergence, Cost, CurveLaw, Definition, ErrorBounds, Laws, LinesAlongCurves, MarkCells,
    Resolution, Scatter, System,
};
use crate::rd::gabor::{self, Kernels};
use crate::rd::kinetics::{Kinetics, Spreading};
use crate::rd::line_noise::Reach;
use crate::rd::oriented_waves::{WaveStart, WaveValue};
use crate::rd::parameter_field::{ParameterField, Parameters};
use crate::rd::selling::PrincipalAxes;
use crate::rd::sparse::reacting_by_rows;
use crate::rd::start::{Start, by_cell};
use crate::rd::sweep;
use crate::rd::systems::meinhardt_spots::{MeinhardtSpots, show_peaks};
use crate::rd::systems::{embedded, meinhardt_spots};
use crate::rd::vector::Number;

impl System {
    /// Two chemicals; thin stripes on wide ground.
    pub const MEINHARDT_LINES: Self = Self::new(&DEFINITION);
}

static DEFINITION: Definition = Definition {
    description: Description {
        name: "meinhardt-lines",
        title: "Meinhardt's lines",
        noun: "Meinhardt's lines",
        help: "Thin stripes on wide ground",
        picture: picture!("meinhardt-lines"),
        marks: MarkKind::Stripes,
        free_spacing: true,
        along_curves: true,
        option_keys: &["keep", "duty", "vary", "double", "ragged"],
        lookup: LookupBy::Rows,
        columns: &columns::LINES,
        training: embedded!("meinhardt-lines"),
        neighbours: &[56, 100],
        // The width of lines is proportional to R^−0.37.
        scaling: Scaling { ratio: 0.74, level: 0.0 },
        ..Description::PLAIN
    },
    chemicals: &["a", "b"],
    spread: &MeinhardtLines::SPREAD,
    tensors: &[PrincipalAxes::of_unit_width],
    mobilities: meinhardt_spots::mobilities,
    reacting: |_, _, planes| reacting(MeinhardtLines, planes),
    by_rows: Some(|rows, _| reacting_by_rows(MeinhardtLines, rows)),
    fineness: None,
    begin: Begin::Waves {
        on_grid: begin,
        on_any: Some(WaveStart {
            kernels: NOISE_ON_SURFACES,
            lead: LEAD,
            value: WaveValue::Phase,
            fill: write_lines,
        }),
    },
    peaks: Some(peaks),
    show: |chemicals, peaks, marks| show_peaks(chemicals[0], peaks, marks),
    decay_noise: None,
    along_curves: Some(ALONG_CURVES),
    obstacle: &OBSTACLE,
    obstacle_rim: 0.0,
    g: None,
    decay: meinhardt_spots::P2,
    reaction_limit: 1.0,
    super_step_limit: 4.0,
    laws: Laws {
        size: |ratio| {
            let width = width(ratio);
            width * width
        },
        spacing: wavelength,
        // The inverse of `width`.
        rate: |width, ratio, _| {
            let root = 14.8 * libm::pow(ratio / 10.0, -0.37) / width;
            root * root
        },
    },
    compensation: 0.0,
    // The error of the grid narrows a line of 5 cells by 1.5 %, one of 4 by 3 %. The training set reaches to widths of 9.
    resolution: Resolution {
        least: 9.0,
        enough: 11.0,
        thin_side: false,
        planned: MarkCells { own_distance: 8.0, asked_distance: 5.0 },
        exact: MarkCells { own_distance: 14.0, asked_distance: 8.0 },
    },
    // Formed at T = 15. Bent lines drift for ever, at 0.02 per unit of time, and where lines meet one of them ends: from T = 15 to
    // 60 their distance grew by 4 %, to 300 by 10 %.
    convergence: Convergence { earliest: 15.0, latest: 120.0, drift: 0.04, corrected: 4.0, still: 0.04 },
    scatter: Scatter { size: 0.01, spacing: 0.016, elongation: 0.0, direction: 0.42 },
    tolerated: Scatter { size: 0.03, spacing: 0.03, elongation: 0.0, direction: 1.0 },
    // The profile across is a Gaussian: ln width = ½ ln ln(1/l) + c.
    level_slope: -0.72,
    spots: None,
    cost: Cost { seconds_a_cell: 4e-6, bytes_a_cell: 150.0, updates: 0.53, updates_on_one_grid: 1.15 },
    sweep: &[sweep::WIDTH, sweep::RATIO, sweep::STRETCH, sweep::DIRECTION],
    usual_rate: 6.0,
    error_bounds: ErrorBounds {
        looked_up: &[
            (Attribute::Width, [2.0, 6.0]),
            (Attribute::Wavelength, [2.5, 7.0]),
            (Attribute::Angle, [1.5, 4.0]),
        ],
        refined: &[(Attribute::Width, [1.0, 3.0]), (Attribute::Wavelength, [2.5, 7.0])],
    },
};

/// a and b.
#[derive(Clone, Copy, Debug)]
pub struct MeinhardtLines;

impl Kinetics<2> for MeinhardtLines {
    const SPREAD: [Spreading; 2] =
        [Spreading::Tensor { tensor: 0, mobility: 0 }, Spreading::Isotropic { mobility: 1 }];

    #[inline(always)]
    fn react<V: Number>(&self, u: [V; 2]) -> [V; 2] {
        MeinhardtSpots.react(u)
    }

    #[inline(always)]
    fn bounded<V: Number>(u: [V; 2]) -> [V; 2] {
        MeinhardtSpots::bounded(u)
    }
}

/// a on the centre line of a line. Fitted to straight lines at their natural distance, R 10–36, within 2 %; at the end of a
/// line a is up to a tenth higher.
#[inline]
fn peak(ratio: f32) -> f32 {
    (2.23 * exp(0.458 * ln(f64::from(ratio) / 10.0))) as f32
}

/// [`peak`] at each ratio.
#[multiversion(targets("x86_64+avx2"))]
fn peaks(ratios: &[f32], peaks: &mut [f32]) {
    peaks.iter_mut().zip(ratios).for_each(|(value, ratio)| *value = peak(*ratio));
}

/// Distance from line to line × √rate, the rate being s/√(DₐD_b) with Dₐ that across the lines.
///
/// Lines stay where they begin, so that the system has no distance of its own. At this distance the fewest lines end. Of lines at a
/// distance of 31, some vanish at all ratios. Lines of higher ratios, which are thinner at equal distances, break into pieces: 21
/// lines at R = 60 and distance 38, 3 at R = 30 and 53.
fn wavelength(ratio: f32) -> f64 {
    32.0 * exp(0.55 * ln(f64::from(ratio) / 12.0))
}

/// Width of a line at half its peak × √rate. Fitted to the lines of [`peak`].
fn width(ratio: f32) -> f64 {
    14.8 * exp(-0.37 * ln(f64::from(ratio) / 10.0))
}

/// Measured on rings and webs around grown spots (`facts.md` N).
const ALONG_CURVES: LinesAlongCurves = LinesAlongCurves {
    // From a ratio of 20 on lines move towards the marks beneath and break where three meet; at 12 they split in wide gaps, and at
    // 10 they fill the gaps.
    ratio: 15.0,
    // The inhibitor of all three lines adds up: at a ratio of 15 they separate after T = 60.
    ratio_at_junctions: 8.0,
    // Webs far from marks break into spots at 1 : 1.5, and widen at bends at 1 : 10. The stronger the anisotropy, the more a bent
    // line moves to the inner side of its bend: rings, which cannot leave the gap around their mark, move against their marks at 1
    // : 2.
    rings: CurveLaw { root_rate: 12.5, stretch: 0.82 },
    web: CurveLaw { root_rate: 15.8, stretch: 0.5 },
};
/// Noise whose crests have the distance and the direction of the lines. Lines repair fewer defects than stripes: with these kernels
/// only half as many lines end as with the kernels of stripes, and no more where directions change.
const NOISE: Kernels = Kernels { reach: [8.0, 4.0], density: 0.6 };
/// On surfaces directions turn and surfaces bend within long kernels: shorter ones follow both.
const NOISE_ON_SURFACES: Kernels = Kernels { reach: [5.0, 2.5], density: 0.8 };
/// The noise follows guide lines over a long distance.
const LEAD: Reach = Reach { beyond: [0.0, 4.0], across: [0.4, 3.0] };
/// Standard deviation of the initial profile, a Gaussian, ÷ the width of the line it becomes: its width at
/// half height is then that of the line.
const PROFILE: f64 = 0.42;

/// Initial lines along curves, or along the crests of oriented waves.
fn begin(start: &Start, maps: &ParameterField) -> Vec<Vec<f32>> {
    if let Some(curves) = start.curves {
        return profiles(maps, &curves.distance, |distance, _| distance);
    }
    let spacing = |p: &Parameters| System::MEINHARDT_LINES.spacing(p);
    let led = (start.lines, LEAD);
    let phases = gabor::phases(maps, &spacing, NOISE, led, &mut start.random());
    // Stripes along the given lines have phase 0; lines in the gaps between these stripes have phase π.
    let from_line = |phase: f64| match start.polarity {
        Polarity::Positive => phase,
        Polarity::Negative => PI - phase.abs(),
    };
    profiles(maps, &phases, |phase, p| from_line(phase) / TAU * spacing(p))
}

/// A Gaussian profile across each line. `distance` converts the value of a cell in `known` to its distance from the centre line,
/// cells.
fn profiles(
    maps: &ParameterField,
    known: &[f32],
    distance: impl Fn(f64, &Parameters) -> f64 + Sync,
) -> Vec<Vec<f32>> {
    by_cell(maps, 2, known, |chemicals, known, parameters| {
        write_profiles(chemicals, known, parameters, &distance);
    })
}

/// Writes the concentrations of lines with a centre line where the phase is 0.
fn write_lines(chemicals: &mut [&mut [f32]], phases: &[f32], parameters: &[Parameters]) {
    write_profiles(chemicals, phases, parameters, |phase, p| {
        phase / TAU * System::MEINHARDT_LINES.spacing(p)
    });
}

fn write_profiles(
    chemicals: &mut [&mut [f32]],
    known: &[f32],
    parameters: &[Parameters],
    distance: impl Fn(f64, &Parameters) -> f64,
) {
    for (i, (known, p)) in known.iter().zip(parameters).enumerate() {
        let deviation = PROFILE * width(p.ratio) / f64::from(p.rate).sqrt();
        let off = distance(f64::from(*known), p) / deviation;
        let profile = exp(-0.5 * off * off) as f32;
        (chemicals[0][i], chemicals[1][i]) = (0.02 + peak(p.ratio) * profile, 0.3);
    }
}

/// No activator, and the inhibitor concentration between lines.
const OBSTACLE: [f32; 2] = [0.0, 0.4];
