//! Turing spots.
//!
//! ∂a/∂t = kₐ(16 − ab) + ∇·(Dₐ∇a)
//! ∂b/∂t = kₐ(ab − b − β) + ∇·(D_b∇b), b ≥ 0
//!
//! Turing, "The chemical basis of morphogenesis" (1952); in this form Turk, "Generating textures on arbitrary surfaces using
//! reaction-diffusion" (1991), and Phan & Grimm, "Sketching reaction-diffusion texture" (2006), appendix A. A spot is where b is
//! used up. Its size determines the spacing: area ≈ 0.21 spacing². In patterns a stays above 2. It is bounded by 0 as well: at
//! rates of 0.38 and more the first spots on a canvas with room for one or two can contain so much b that a step of a overshoots.

use crate::attributes::Attribute;
use crate::attributes::columns;
use crate::attributes::system::{Description, LookupBy, Scaling, picture};
use crate::rd::chemicals::{Chemicals, reacting};
use crate::rd::definition::{
    Begin, Convergence, Cost, DecayNoise, Definition, ErrorBounds, Laws, MarkCells, MergingDistance,
    OwnVariation, Resolution, Scatter, SpotLimits, SweepQuantity, System, Variation,
};
use crate::rd::kinetics::{Kinetics, Spreading};
use crate::rd::parameter_field::Parameters;
use crate::rd::plane::{Plane, RowLayout};
use crate::rd::selling::PrincipalAxes;
use crate::rd::sparse::{SparseChemicals, reacting_by_rows};
use crate::rd::sweep;
use crate::rd::systems::embedded;
use crate::rd::vector::Number;

impl System {
    /// Two chemicals; packed spots of any size.
    pub const TURING_SPOTS: Self = Self::new(&DEFINITION);
}

static DEFINITION: Definition = Definition {
    description: Description {
        name: "turing-spots",
        title: "Turing's spots",
        noun: "Turing's spots",
        help: "Spots that fill the plane evenly; their spacing follows from their size. They can be irregular",
        picture: picture!("turing-spots"),
        alternative: Some("Turing's system: livelier spots that keep their own distance"),
        irregular: true,
        option_keys: &["spread", "keep", "irregular", "ragged"],
        lookup: LookupBy::Rows,
        columns: &columns::SPOTS,
        training: embedded!("turing-spots-narrow", "turing-spots-orientation", "turing-spots-size"),
        neighbours: &[75, 24, 24, 24, 24, 42],
        scaling: Scaling { ratio: 1.0, level: 2.85 },
        ..Description::PLAIN
    },
    chemicals: &["a", "b"],
    spread: &TuringSpots::SPREAD,
    tensors: &[PrincipalAxes::of_unit_determinant],
    mobilities: |_| [RATIO.sqrt(), 1.0 / RATIO.sqrt()],
    reacting: |maps, grid, planes| match maps.decay_noise.as_slice() {
        [] => reacting(TuringSpots, planes),
        noise => with_decay_noise(noise, grid, planes),
    },
    by_rows: Some(|rows, noise| match noise {
        [] => reacting_by_rows(TuringSpots, rows),
        noise => rows_with_decay_noise(noise, rows),
    }),
    fineness: None,
    begin: Begin::Bells { radius: |_| RADIUS, fill },
    peaks: None,
    show: |chemicals, _, marks| {
        for (mark, a) in marks.iter_mut().zip(chemicals[0]) {
            *mark = share(*a);
        }
    },
    // Spots of 27 cells under β ± 3, with independent values in all cells, vary by 0.44 in area and have an aspect of 0.60
    // (`facts.md` G). Spots of 48 cells under this noise vary by 0.40, with an aspect of 0.70; at a strength of 0.3 by 0.19, with
    // 0.82; at 1 a tenth of them is bent. One in nine spots merges with a neighbour. Without a higher rate the mean area would rise
    // by 21 % and the distance by 6 %; at half the deviation by 3 % and 1 %.
    decay_noise: Some(DecayNoise { deviation: 0.6, rate: 0.13 }),
    along_curves: None,
    obstacle: &OBSTACLE,
    // Half of the distance at which the edges of spots lie from an obstacle.
    obstacle_rim: 0.25,
    g: None,
    decay: 1.0,
    // `facts.md` A.
    reaction_limit: 0.045,
    // `facts.md` S.
    super_step_limit: 0.12,
    laws: Laws { size: |_| AREA, spacing: |_| SPACING, rate: |area, _, _| 5.2 / area },
    // Spots have a hard edge: this removes two thirds of an error of 6 % in area, and none of the error in aspect.
    compensation: 20.0,
    // Round spots of 48 cells lost 1.1 % of aspect from a grid of 21 cells per spot, and still as much from one of 25.
    resolution: Resolution {
        least: 22.0,
        enough: 27.0,
        thin_side: true,
        planned: MarkCells::always(48.0),
        exact: MarkCells::always(120.0),
    },
    convergence: Convergence { earliest: 20.0, latest: 150.0, drift: 0.008, corrected: 6.0, still: 0.02 },
    // The scatter for the largest elongation.
    scatter: Scatter { size: 0.004, spacing: 0.0, elongation: 0.018, direction: 1.0 },
    tolerated: Scatter { size: 0.01, spacing: 0.02, elongation: 0.01, direction: 0.5 },
    level_slope: -1.44,
    spots: Some(SpotLimits {
        // Of 36 pairs 20 lost a spot at a distance of 0.72 spacings, three at 0.82.
        merging: MergingDistance { least: 0.87, by_root_density: 0.0 },
        own_variation: OwnVariation { area: 0.045, shape: 0.055 },
        // With a larger spread, spots lose their shape (angle) or repel each other back (spacing).
        variation: Variation::Fixed(crate::attributes::Spread {
            area: 0.6,
            angle: 25.0,
            aspect: 0.2,
            spacing: 0.12,
        }),
    }),
    cost: Cost { seconds_a_cell: 6e-6, bytes_a_cell: 185.0, updates: 0.62, updates_on_one_grid: 0.62 },
    sweep: &[
        sweep::AREA,
        // The only ratio at which it is grown.
        SweepQuantity { name: "ratio", unit: "Da/Db", allowed: [3.8, 3.8] },
        sweep::LEVEL,
        sweep::STRETCH,
        sweep::DIRECTION,
    ],
    usual_rate: 0.15,
    error_bounds: ErrorBounds {
        looked_up: &[(Attribute::Area, [1.5, 5.0]), (Attribute::Angle, [1.0, 3.0])],
        refined: &[
            (Attribute::Area, [0.5, 1.5]),
            (Attribute::Spacing, [1.5, 5.0]),
            (Attribute::Aspect, [0.006, 0.02]),
            (Attribute::Angle, [0.8, 2.5]),
        ],
    },
};

/// a and b.
#[derive(Clone, Copy, Debug)]
pub struct TuringSpots;

/// Growth of a: 16, as published.
const GROWTH: f32 = 16.0;
/// Decay of b, equal over the grid except for irregular spots: [`TuringSpotsWithDecayNoise`].
const BETA: f32 = 12.0;

/// Dₐ/D_b. `facts.md` A: well-formed spots at 3.6–4.0, roundest below 3.8.
const RATIO: f32 = 3.8;
/// Distance of spots × √(kₐ/√(DₐD_b)). Measured: see `facts.md` A (2.10 √5.7).
const SPACING: f64 = 5.0;

impl Kinetics<2> for TuringSpots {
    const SPREAD: [Spreading; 2] =
        [Spreading::Tensor { tensor: 0, mobility: 0 }, Spreading::Tensor { tensor: 0, mobility: 1 }];

    #[inline(always)]
    fn react<V: Number>(&self, [a, b]: [V; 2]) -> [V; 2] {
        let ab = a * b;
        [V::splat(GROWTH) - ab, ab - b - V::splat(BETA)]
    }

    #[inline(always)]
    fn bounded<V: Number>([a, b]: [V; 2]) -> [V; 2] {
        [a.at_least(0.0), b.at_least(0.0)]
    }
}

/// a, b and β, which varies in space and is constant in time.
#[derive(Clone, Copy, Debug)]
pub struct TuringSpotsWithDecayNoise;

impl Kinetics<3> for TuringSpotsWithDecayNoise {
    const SPREAD: [Spreading; 3] = [TuringSpots::SPREAD[0], TuringSpots::SPREAD[1], Spreading::Still];

    #[inline(always)]
    fn react<V: Number>(&self, [a, b, beta]: [V; 3]) -> [V; 3] {
        let ab = a * b;
        [V::splat(GROWTH) - ab, ab - b - beta, V::splat(0.0)]
    }

    #[inline(always)]
    fn bounded<V: Number>([a, b, beta]: [V; 3]) -> [V; 3] {
        [a.at_least(0.0), b.at_least(0.0), beta]
    }
}

/// a and b with a β that differs by `noise` from cell to cell.
fn with_decay_noise(noise: &[f32], grid: RowLayout, mut planes: Vec<Plane>) -> Option<Box<dyn Chemicals>> {
    let beta: Vec<f32> = noise.iter().map(|off| BETA + off).collect();
    planes.push(Plane::from_cells(grid, &beta)?);
    reacting(TuringSpotsWithDecayNoise, planes)
}

/// a and b by row of a surface, with a β that differs by `noise` from row to row.
fn rows_with_decay_noise(noise: &[f32], rows: &[Vec<f32>]) -> Option<Box<dyn SparseChemicals>> {
    let mut rows = rows.to_vec();
    rows.push(noise.iter().map(|off| BETA + off).collect());
    reacting_by_rows(TuringSpotsWithDecayNoise, &rows)
}

/// Bells on the nuclei (`facts.md` G).
fn fill(chemicals: &mut [&mut [f32]], bells: &[f32], _: &[Parameters]) {
    for (i, bell) in bells.iter().enumerate() {
        (chemicals[0][i], chemicals[1][i]) = (3.3 + 4.0 * bell, (5.6 * (1.0 - 1.3 * bell)).max(0.0));
    }
}

/// Radius of an initial bell ÷ spacing: about that of the spot that grows from it.
const RADIUS: f64 = 0.26;

/// The concentration `a` scaled from the ground (0) to the centre of a spot (1): a runs from 3.0 to
/// 7.5 in settled patterns of 20 to 300 cells a spot.
fn share(a: f32) -> f32 {
    (a - 3.0) / 4.5
}

/// Area of a spot × rate (`facts.md` A).
const AREA: f64 = 5.7;

/// The state at the centre of a spot, which repels others (`facts.md` G, cheetah).
const OBSTACLE: [f32; 2] = [7.3, 0.0];
