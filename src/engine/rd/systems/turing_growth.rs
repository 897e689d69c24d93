//! Turing's system with a parameter G that varies over the canvas.
//!
//! ∂a/∂t = kₐ(G − ab) + ∇·(Dₐ∇a), a ≥ 0
//! ∂b/∂t = kₐ(ab − b − β) + ∇·(D_b∇b), b ≥ 0, β = 20
//!
//! Lawlor, "Reaction-diffusion textures with multigrid" (2003), after Turk, "Generating textures on arbitrary surfaces using
//! reaction-diffusion" (1991). At β = 20 dots of b grow up to G = 20, worms from 21 to 26, holes in b from 27 on. The share of the
//! cells with b > 3 rises from 0.48 at G = 18 to 0.87 at 27; below 17.5 b dies out, above 27.5 nothing is left of the holes. The
//! distance of marks hardly depends on G. `data-gen growth-map` draws what grows at each G and β.

use crate::attributes::system::{Description, Family, Keys, MarkKind, picture};
use crate::rd::chemicals::{Chemicals, reacting};
use crate::rd::definition::{
    Begin, Convergence, Cost, Definition, ErrorBounds, Laws, MarkCells, Resolution, Scatter, System,
};
use crate::rd::gabor::{self, Kernels};
use crate::rd::kinetics::{Kinetics, Spreading};
use crate::rd::parameter_field::{ParameterField, Parameters};
use crate::rd::plane::{Plane, RowLayout};
use crate::rd::selling::PrincipalAxes;
use crate::rd::start::Start;
use crate::rd::vector::Number;
use rand::RngExt;

impl System {
    /// Two chemicals; dots, worms or holes, depending on [`ParameterField::g`]. Its parameters follow from laws and not from
    /// training rows, so that it is not in [`Self::ALL`].
    #[must_use]
    pub const fn with_growth() -> Self {
        Self::new(&DEFINITION)
    }
}

/// The usual G: worms.
const USUAL: f32 = 22.0;

static DEFINITION: Definition = Definition {
    description: Description {
        name: "turing-growth",
        title: "Turing's growth",
        noun: "Turing's growth",
        help: "Dots, worms and holes, whose kind a picture or noise determines",
        picture: picture!("turing-growth"),
        kind: Family::Growth,
        marks: MarkKind::Stripes,
        either_marks: true,
        grows_blank: true,
        lowest_alone: Some("Turing's growth needs the whole canvas, which only the lowest layer has"),
        tone: true,
        own_keys: &[Keys {
            keys: &["maps.growth"],
            reason: "Only Turing's growth uses this map: set \"system\" to \"turing-growth\"",
        }],
        refused_keys: &[Keys {
            keys: &["maps.area", "maps.spacing", "maps.direction", "maps.aspect", "maps.duty"],
            reason: "With Turing's growth only the growth and the colour can have maps",
        }],
        ..Description::PLAIN
    },
    chemicals: &["a", "b"],
    spread: &TuringGrowth::SPREAD,
    tensors: &[PrincipalAxes::of_unit_determinant],
    mobilities: |_| [RATIO.sqrt(), 1.0 / RATIO.sqrt()],
    reacting: with_growth,
    by_rows: None,
    fineness: None,
    begin: Begin::Waves { on_grid: begin, on_any: None },
    peaks: None,
    show: |chemicals, _, marks| {
        for (mark, b) in marks.iter_mut().zip(chemicals[1]) {
            *mark = b / (b + EDGE);
        }
    },
    decay_noise: None,
    along_curves: None,
    obstacle: &OBSTACLE,
    obstacle_rim: 0.25,
    g: Some(USUAL),
    decay: 1.0,
    // Lawlor's step is 0.5 at kₐ = 0.0125; this is twice as long. From white noise b explodes where it reaches a region with much a
    // late. From waves it does not: a stays below 30.
    reaction_limit: 0.0125,
    // Steps of Euler alone: super steps were not tried here.
    super_step_limit: 0.0,
    laws: Laws {
        size: |_| 0.25 * WAVELENGTH * WAVELENGTH,
        spacing: |_| WAVELENGTH,
        rate: |width, _, _| {
            let root = 0.5 * WAVELENGTH / width;
            root * root
        },
    },
    compensation: 0.0,
    // A pattern is formed within T = 3; a coarser grid would save little.
    resolution: Resolution {
        least: 0.0,
        enough: f64::INFINITY,
        thin_side: false,
        planned: MarkCells::always(6.0),
        exact: MarkCells::always(6.0),
    },
    // The share of ink is within 0.01 of its limit from T = 6 on for G = 20 and more, from T = 11 on for G = 18.
    convergence: Convergence { earliest: 8.0, latest: 40.0, drift: 0.025, corrected: 6.0, still: 0.02 },
    scatter: NONE,
    tolerated: NONE,
    level_slope: 0.0,
    spots: None,
    cost: Cost { seconds_a_cell: 5e-6, bytes_a_cell: 200.0, updates: 1.0, updates_on_one_grid: 1.0 },
    sweep: &[],
    usual_rate: 0.11,
    error_bounds: ErrorBounds { looked_up: &[], refined: &[] },
};

/// Nothing is corrected by probes.
const NONE: Scatter = Scatter { size: 0.0, spacing: 0.0, elongation: 0.0, direction: 0.0 };

/// The usual β.
const BETA: f32 = 20.0;
/// Dₐ/D_b: 0.25 ÷ 0.03125.
const RATIO: f32 = 8.0;
/// b at the edges of marks.
const EDGE: f32 = 3.0;
/// Distance of marks × √(kₐ/√(DₐD_b)): 9.0 cells at Lawlor's parameters (`facts.md` V).
const WAVELENGTH: f64 = 3.38;
/// The initial noise: waves of all directions, as far apart as marks. White noise takes five times as long, and the pattern
/// vanishes where G is low: b uses up a everywhere at once.
const NOISE: Kernels = Kernels { reach: [1.0; 2], density: 3.0 };
/// Initial a and b: mean, and change for one standard deviation of the noise.
const START: [[f32; 2]; 2] = [[6.0, -2.0], [6.0, 6.0]];
/// Concentrations that keep marks away: much b and little a.
const OBSTACLE: [f32; 2] = [2.0, 12.0];

/// a, b and G, which varies in space and is constant in time.
#[derive(Clone, Copy, Debug)]
pub struct TuringGrowth {
    /// β: decay of b.
    decay: f32,
}

impl Kinetics<3> for TuringGrowth {
    const SPREAD: [Spreading; 3] = [
        Spreading::Tensor { tensor: 0, mobility: 0 },
        Spreading::Tensor { tensor: 0, mobility: 1 },
        Spreading::Still,
    ];

    #[inline(always)]
    fn react<V: Number>(&self, [a, b, growth]: [V; 3]) -> [V; 3] {
        let ab = a * b;
        [growth - ab, ab - b - V::splat(self.decay), V::splat(0.0)]
    }

    #[inline(always)]
    fn bounded<V: Number>([a, b, growth]: [V; 3]) -> [V; 3] {
        [a.at_least(0.0), b.at_least(0.0), growth]
    }
}

/// a and b with the parameter G of each cell.
fn with_growth(maps: &ParameterField, grid: RowLayout, mut planes: Vec<Plane>) -> Option<Box<dyn Chemicals>> {
    let growth = if maps.g.is_empty() {
        Plane::from_cells(grid, &vec![USUAL; maps.parameters.len()])
    } else {
        Plane::from_cells(grid, &maps.g)
    };
    planes.push(growth?);
    reacting(TuringGrowth { decay: maps.decay.unwrap_or(BETA) }, planes)
}

/// Noise of waves in all directions.
fn begin(start: &Start, maps: &ParameterField) -> Vec<Vec<f32>> {
    let mut random = start.random();
    // A wave has the direction of the cell at which it begins.
    let turned = |p: &Parameters| Parameters { direction: 180.0 * random.random::<f32>(), ..*p };
    let turned = ParameterField::new(maps.domain, maps.parameters.iter().map(turned).collect());
    let wavelength = |p: &Parameters| System::with_growth().spacing(p);
    let noise = gabor::noise(&turned, &wavelength, NOISE, &mut random);
    START.map(|[mean, change]| noise.iter().map(|n| (mean + change * n).max(0.0)).collect()).into()
}

#[cfg(test)]
mod tests {
    use crate::grid::Edges;
    use crate::rd::{Growth, ParameterField, Parameters, System};

    /// Cells along a side.
    const SIDE: usize = 96;

    /// The growth from Lawlor's parameters with this G at each cell, after `steps` steps.
    fn grown(growth: Vec<f32>, steps: u64) -> Growth {
        let rate = 0.0125 / (0.25_f32 * 0.03125).sqrt();
        let parameters = Parameters { rate, ratio: 1.0, stretch: 1.0, direction: 0.0, pitch: 1.0 };
        let maps =
            ParameterField { g: growth, ..ParameterField::uniform([SIDE; 2], Edges::Wrap, parameters) };
        let mut growth = Growth::new(System::with_growth(), &maps, 3);
        growth.advance(steps);
        growth
    }

    /// The share of ink.
    fn ink(marks: &[f32]) -> f64 {
        marks.iter().filter(|mark| **mark > 0.5).count() as f64 / marks.len() as f64
    }

    #[test]
    fn the_share_of_ink_follows_the_law_for_g() {
        for (growth, wanted) in [(18.5, 0.48), (20.0, 0.53), (22.0, 0.61), (25.0, 0.74), (27.0, 0.87)] {
            let found = ink(&grown(vec![growth; SIDE * SIDE], 2_500).marks().values);
            assert!((found - wanted).abs() < 0.03, "{growth}: {found} of {wanted}");
        }
    }

    #[test]
    fn marks_are_as_far_apart_as_the_law_says() {
        let marks = grown(vec![22.0; SIDE * SIDE], 2_500).marks().values;
        // The autocorrelation of worms in all directions has its first minimum at 0.61 of their distance (zero of J₁).
        let mean = marks.iter().sum::<f32>() / marks.len() as f32;
        let alike = |lag: usize| -> f32 {
            (0..SIDE * SIDE)
                .map(|cell| {
                    let [x, y] = [cell % SIDE, cell / SIDE];
                    (marks[cell] - mean) * (marks[y * SIDE + (x + lag) % SIDE] - mean)
                })
                .sum()
        };
        let lowest = (2..12).min_by(|a, b| alike(*a).total_cmp(&alike(*b))).unwrap();
        // The vertex of the parabola through it and its neighbours.
        let [before, at, after] = [lowest - 1, lowest, lowest + 1].map(alike);
        let vertex = lowest as f32 + 0.5 * (before - after) / (before - 2.0 * at + after);
        assert!((vertex / 0.61 - 9.0).abs() < 0.45, "{} cells", vertex / 0.61);
    }

    #[test]
    fn the_fast_and_the_plain_solver_grow_the_same_bits() {
        let ramp = (0..SIDE * SIDE).map(|cell| 18.0 + 9.0 * (cell % SIDE) as f32 / SIDE as f32).collect();
        let fast = grown(ramp, 0);
        let mut plain = fast.clone();
        let mut fast = fast;
        fast.advance(150);
        plain.advance_plain(150);
        assert!(fast.concentrations() == plain.concentrations());
    }
}
