//! The data that define a reaction-diffusion system: each file of [`super::systems`] fills in one [`Definition`].

use std::fmt;
use std::hash::{Hash, Hasher};

use super::chemicals::Chemicals;
use super::kinetics::{MOBILITIES, Spreading};
use super::oriented_waves::WaveStart;
use super::parameter_field::{ParameterField, Parameters};
use super::plane::{Plane, RowLayout};
use super::selling::PrincipalAxes;
use super::sparse::ReactingByRows;
use super::start::Start;
use crate::attributes::system::Description;
use crate::attributes::{Attribute, Spread};

/// Combines planes on a grid with a reaction.
pub type Reacting = fn(&ParameterField, RowLayout, Vec<Plane>) -> Option<Box<dyn Chemicals>>;

/// Writes the concentration at the centre of a mark for each of these ratios.
pub type Peaks = fn(&[f32], &mut [f32]);

/// All properties of one system.
pub struct Definition {
    /// The description for the rest of the program.
    pub description: Description,
    /// The names of its chemicals, in the order of [`super::Growth::concentrations`].
    pub chemicals: &'static [&'static str],
    /// For each chemical, the kind of its diffusion.
    pub spread: &'static [Spreading],
    /// The diffusion tensors of a place with these parameters, on square cells.
    pub tensors: &'static [fn(&Parameters) -> PrincipalAxes],
    /// The mobility numbers of a place with these parameters.
    pub mobilities: fn(&Parameters) -> [f32; MOBILITIES],
    /// Concentrations, one plane a chemical, with their reaction; `None` for another number of planes.
    pub reacting: Reacting,
    /// Concentrations by vertex of a surface, with their reaction; `None` for systems that do not grow there.
    pub by_rows: Option<ReactingByRows>,
    /// Compiled rows for [`fineness`](super::fineness()); `None` where they are not measured.
    pub fineness: Option<&'static [u8]>,
    /// Its initial concentrations.
    pub begin: Begin,
    /// Dependence of the concentration at the centre of a mark on the ratio; `None` = it is equal everywhere.
    pub peaks: Option<Peaks>,
    /// Writes how much of a mark each cell of a row shows, given the row of each chemical and the peaks there: 0 on the ground,
    /// 1 at the centre of a mark with the parameters there.
    pub show: fn(&[&[f32]], &[f32], &mut [f32]),
    /// The way in which spots are made irregular; `None` if they cannot be.
    pub decay_noise: Option<DecayNoise>,
    /// Concentrations of obstacle cells, one a chemical: they keep marks away.
    pub obstacle: &'static [f32],
    /// Distance to obstacle cells ÷ spacing within which the shown concentration is that of the obstacle.
    pub obstacle_rim: f64,
    /// The usual parameter G; `None` for systems without a parameter G that varies over the canvas.
    pub g: Option<f32>,
    /// The decay constant that scales normalised time (`facts.md` 0): T = decay · rate · time.
    pub decay: f32,
    /// The largest dt·s at which the reactions alone stay stable.
    pub reaction_limit: f32,
    /// The largest dt·s of a super step (`facts.md` S).
    pub super_step_limit: f32,
    /// Its laws of scale.
    pub laws: Laws,
    /// κ² of [`System::compensated`]: the strength of the correction for a coarse grid.
    pub compensation: f64,
    /// Cells that a mark needs.
    pub resolution: Resolution,
    /// Criterion for a settled pattern.
    pub convergence: Convergence,
    /// Scatter of patches of 80 spots (or 10 wavelengths) with the same parameters, from seed to seed: of 40 patches each
    /// at stretches of 0.35, 0.6 and 0.9 and three sizes or five ratios and levels (of lines 14 each of three ratios), the
    /// median.
    pub scatter: Scatter,
    /// Scatter that needs no correction by probes, since sizes and spacings are corrected on the canvas by thresholds and pitches.
    /// The value for directions is half of the scatter over a canvas of stripes, or an amount that cannot be seen.
    pub tolerated: Scatter,
    /// d ln size ÷ d ln level, about level ½.
    pub level_slope: f64,
    /// Its laws of lines along curves; `None` where marks do not stay on the curves that they begin along.
    pub along_curves: Option<LinesAlongCurves>,
    /// Limits of its spots; `None` for stripes.
    pub spots: Option<SpotLimits>,
    /// The cost of a growth.
    pub cost: Cost,
    /// The quantities that a sweep may vary.
    pub sweep: &'static [SweepQuantity],
    /// A rate at which its marks have a usual number of cells: for benchmarks and tests.
    pub usual_rate: f32,
    /// Largest errors of lookups, checked by `dapple learn`.
    pub error_bounds: ErrorBounds,
}

/// The kind of initial concentrations of a system.
#[derive(Clone, Copy)]
pub enum Begin {
    /// For spots: from bells on their nuclei, on any domain.
    Bells {
        /// Radius of a bell in a place with these parameters, pitches.
        radius: fn(&Parameters) -> f64,
        /// Writes the concentrations of some cells, one slice a chemical, from the heights of their bells, 0..1, and their
        /// parameters.
        fill: fn(&mut [&mut [f32]], &[f32], &[Parameters]),
    },
    /// Of stripes and lines: from waves.
    Waves {
        /// On a grid. One vector a chemical.
        on_grid: fn(&Start, &ParameterField) -> Vec<Vec<f32>>,
        /// On any domain; `None` of systems that grow on grids alone.
        on_any: Option<WaveStart>,
    },
}

/// Laws of scale, good to some per cent.
pub struct Laws {
    /// Size at a ratio: area of a spot at half its peak, cells, × rate, or the squared width of a stripe × rate.
    pub size: fn(f32) -> f64,
    /// Distance of the places of spots (that of a hexagonal lattice with as many) or wavelength of stripes × √rate, at a
    /// ratio.
    pub spacing: fn(f32) -> f64,
    /// Rate for marks of a size (area of a spot, width of a stripe, cells) at a ratio and a threshold. Less accurate than the other
    /// laws; used to choose what to sweep.
    pub rate: fn(f64, f64, f64) -> f64,
}

/// Laws of lines that begin along curves around other marks, or between them.
#[derive(Clone, Copy, Debug)]
pub struct LinesAlongCurves {
    /// R = D_b/Dₐ.
    pub ratio: f64,
    /// R where three lines meet.
    pub ratio_at_junctions: f64,
    /// The law for a ring around each mark.
    pub rings: CurveLaw,
    /// The law for one web between all marks.
    pub web: CurveLaw,
}

/// Rate and tensor of lines along one kind of curve.
#[derive(Clone, Copy, Debug)]
pub struct CurveLaw {
    /// √rate of a line one cell wide, its width measured at half of the local peak.
    pub root_rate: f64,
    /// Minor ÷ major axis of the activator's tensor along a line, √(slow ÷ fast).
    pub stretch: f64,
}

/// The way in which a system makes its spots irregular.
#[derive(Clone, Copy, Debug)]
pub struct DecayNoise {
    /// Standard deviation of the decay for the most irregular spots.
    pub deviation: f64,
    /// Relative increase of the rate for the most irregular spots.
    pub rate: f64,
}

/// Cells that a mark needs.
#[derive(Clone, Copy, Debug)]
pub struct Resolution {
    /// Marks of fewer cells than this do not form on a coarse grid.
    pub least: f64,
    /// From this number of cells on, the pattern of a coarse grid is used unchanged.
    pub enough: f64,
    /// Whether only the thin side of long spots counts, since their hard edges stick to the grid.
    pub thin_side: bool,
    /// Cells of the smallest mark on the planned grid.
    pub planned: MarkCells,
    /// From this number of cells on, parameters scale exactly.
    pub exact: MarkCells,
}

/// Cells of a mark: the area of a spot, the width of a stripe.
#[derive(Clone, Copy, Debug)]
pub struct MarkCells {
    /// Where the system sets the distance of marks.
    pub own_distance: f64,
    /// Where a distance of marks is asked for.
    pub asked_distance: f64,
}

impl MarkCells {
    /// An equal number of cells in both cases.
    #[must_use]
    pub const fn always(cells: f64) -> Self {
        Self { own_distance: cells, asked_distance: cells }
    }
}

/// Criterion for a settled pattern: normalised times (`facts.md` 0) where the reactions are slowest.
#[derive(Clone, Copy, Debug)]
pub struct Convergence {
    /// Earliest time of a check.
    pub earliest: f64,
    /// Time limit.
    pub latest: f64,
    /// Relative change per unit of time that counts as steady drift.
    pub drift: f64,
    /// Earliest time of a check where only the errors of a coarser grid are corrected.
    pub corrected: f64,
    /// Relative change per unit of time that counts as settled at such a check.
    pub still: f64,
}

/// Scatter of measurements, from seed to seed; 0 for quantities that the system does not allow to be corrected.
#[derive(Clone, Copy, Debug)]
pub struct Scatter {
    /// Scatter of ln area or ln width.
    pub size: f64,
    /// Scatter of ln spacing or ln wavelength.
    pub spacing: f64,
    /// Scatter of ln aspect.
    pub elongation: f64,
    /// Scatter of the direction, degrees.
    pub direction: f64,
}

/// Limits of the spots of a system.
#[derive(Clone, Copy, Debug)]
pub struct SpotLimits {
    /// The distance at which they merge.
    pub merging: MergingDistance,
    /// Variation of spots with equal parameters.
    pub own_variation: OwnVariation,
    /// Largest possible variation of spots.
    pub variation: Variation,
}

/// The distance below which spots merge, in spacings: `least` + `by_root_density` · √(area ÷ spacing²).
#[derive(Clone, Copy, Debug, Default)]
pub struct MergingDistance {
    /// The distance for the sparsest rows.
    pub least: f64,
    /// Its increase with the density.
    pub by_root_density: f64,
}

/// Variation of spots with equal parameters.
#[derive(Clone, Copy, Debug, Default)]
pub struct OwnVariation {
    /// Coefficient of variation of the area.
    pub area: f64,
    /// Standard deviation of −ln aspect · (cos 2θ, sin 2θ).
    pub shape: f64,
}

/// Largest possible variation of spots without merging or losing their shape.
#[derive(Clone, Copy, Debug)]
pub enum Variation {
    /// This spread at any density; its aspect is not used.
    Fixed(Spread),
    /// Less at higher densities.
    ByDensity {
        /// area ÷ spacing² up to which the area may vary without limit.
        free_density: f64,
        /// Decrease of the allowed variation of the area for each unit of area ÷ spacing² above that.
        area_by_density: f64,
        /// Largest spread of the directions of spots.
        turn: TurnLimit,
        /// Coefficient of variation of the spacing.
        spacing: f64,
    },
}

/// The largest spread of the directions of spots: `degrees` · (`length` ÷ their length)^`power`.
#[derive(Clone, Copy, Debug)]
pub struct TurnLimit {
    /// The spread at that length, degrees.
    pub degrees: f64,
    /// The length, in spacings.
    pub length: f64,
    /// The power.
    pub power: f64,
}

/// The cost of a growth.
#[derive(Clone, Copy, Debug)]
pub struct Cost {
    /// Seconds per cell that a growth takes on one core, where all marks have about one size. In examples of 100,000 to 500,000
    /// cells, spots took 3.9e-6 to 8.2e-6 and stripes 1.4e-6 to 2.6e-6; on millions of cells both take less.
    pub seconds_a_cell: f64,
    /// Bytes of memory per cell where parameters differ everywhere. Spots need two chemicals twice (16), weights, mobilities and
    /// rate (27), parameters (20), convergence and prolongation (25); measured 85–90 at 2,570²–2,979² cells. Stripes with five
    /// chemicals: 123–130 at 1,748²–8,192² cells.
    pub bytes_a_cell: f64,
    /// Cell updates needed ÷ cell updates expected: the median of the golden textures and seven examples. A finer grid
    /// mostly needs fewer steps than expected, and stripes settle on it at once.
    pub updates: f64,
    /// Cell updates needed ÷ cell updates expected where the whole growth is on one grid, as for lines along curves.
    pub updates_on_one_grid: f64,
}

/// A quantity that a sweep may vary.
#[derive(Clone, Copy, Debug)]
pub struct SweepQuantity {
    /// Its name.
    pub name: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// Lowest and highest value.
    pub allowed: [f64; 2],
}

/// Largest median and 95th percentile of the error, by attribute: % of area, spacing, width and wavelength, degrees of angle.
pub type Bounds = &'static [(Attribute, [f64; 2])];

/// Largest errors of lookups.
#[derive(Clone, Copy, Debug)]
pub struct ErrorBounds {
    /// For marks that grow with parameters that were looked up.
    pub looked_up: Bounds,
    /// For marks that grow with parameters after probes and refinement.
    pub refined: Bounds,
}

/// A reaction-diffusion system. Two are equal if their names are.
#[derive(Clone, Copy)]
pub struct System(&'static Definition);

impl System {
    /// The system that `definition` describes.
    #[doc(hidden)]
    #[must_use]
    pub const fn new(definition: &'static Definition) -> Self {
        Self(definition)
    }

    /// All its properties.
    #[doc(hidden)]
    #[must_use]
    pub const fn definition(self) -> &'static Definition {
        self.0
    }

    /// The description for the rest of the program.
    #[must_use]
    pub const fn description(self) -> &'static Description {
        &self.0.description
    }

    /// Its name in documents and of its training set.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.0.description.name
    }

    /// The names of its chemicals, in the order of [`super::Growth::concentrations`].
    #[must_use]
    pub fn chemicals(self) -> &'static [&'static str] {
        self.0.chemicals
    }

    /// Whether it grows stripes, not spots.
    #[must_use]
    pub const fn is_striped(self) -> bool {
        self.0.description.is_striped()
    }

    /// The usual parameter G; `None` for systems whose G does not vary over the canvas.
    #[must_use]
    pub const fn usual_g(self) -> Option<f32> {
        self.0.g
    }

    /// Cells that a spot covers at half its peak, or the squared width of a stripe: how finely the grid shows it.
    #[must_use]
    pub fn cells(self, p: &Parameters) -> f64 {
        (self.0.laws.size)(p.ratio) / f64::from(p.rate)
    }

    /// Distance at which spots begin, or the wavelength of stripes, cells.
    ///
    /// ```
    /// use dapple_engine::rd::{Parameters, System};
    ///
    /// let slow = Parameters { rate: 0.02, ratio: 30.0, stretch: 1.0, direction: 0.0, pitch: 1.0 };
    /// let fast = Parameters { rate: 0.08, ..slow };
    /// let [far, near] = [slow, fast].map(|p| System::MEINHARDT_SPOTS.spacing(&p));
    /// assert!((far / near - 2.0).abs() < 1e-6);
    /// ```
    #[must_use]
    pub fn spacing(self, p: &Parameters) -> f64 {
        f64::from(p.pitch) * (self.0.laws.spacing)(p.ratio) / f64::from(p.rate).sqrt()
    }
}

impl PartialEq for System {
    fn eq(&self, other: &Self) -> bool {
        self.name() == other.name()
    }
}

impl Eq for System {}

impl Hash for System {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.name().hash(state);
    }
}

impl fmt::Debug for System {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
