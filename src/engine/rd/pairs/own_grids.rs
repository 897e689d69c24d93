//! Pairs of different sizes, each on a grid as fine as its own size needs.
//!
//! The blurred values of a pair are smooth over its size s: a pair of wide threads needs neither the cells of thin threads nor
//! their short steps. In turn, the reaction R is computed on the finest grid from the differences of all pairs, which are
//! interpolated there by splines. Its mean over each cell of a pair's own grid is held while this pair takes one super step.
//! Patterns at rest are those of one grid: at rest, R does not change from step to step.

use super::kinetics::{held_pairs, reaction};
use super::shared_grid::{STEP_LIMIT, SUPER_STEP_LIMIT, tensors};
use super::start::{HELD, PairStart, noise};
use super::{PairField, PairModel, PairParameterField};
use crate::grid::averages::averages;
use crate::grid::resample::resample;
use crate::grid::{Domain, Field, Grid};
use crate::rd::chemicals::{Chemicals, Clock};
use crate::rd::coefficients::Coefficients;
use crate::rd::kinetics::MOBILITIES;
use crate::rd::plane::{Plane, RowLayout};
use crate::rd::problem::Problem;
use crate::rd::solver::Solver;
use crate::rd::super_step::euler_steps;
use crate::rd::wavefront::{Instructions, Scratch, Tiling};

/// Smallest size of a pair on a grid of its own, cells.
const CELLS: f64 = 1.75;
/// Least ratio of a size to the smallest one for pairs to get grids of their own.
const DIFFERENT: f64 = 1.4;
/// Planes of a pair: C₊, C₋ and the reaction that is held.
const PLANES: usize = 3;

/// Pairs being grown on grids of their own.
#[derive(Clone, Debug)]
pub(super) struct OwnGrids {
    model: PairModel,
    /// The finest grid.
    grid: Grid,
    pairs: Vec<OwnGrid>,
    /// The increase of the threshold at each cell of the finest grid; empty = 0 everywhere.
    raised: Vec<f32>,
    steps: u64,
}

/// A pair on its grid.
#[derive(Clone, Debug)]
struct OwnGrid {
    grid: Grid,
    problem: Problem,
    /// C₊, C₋, and the reaction that is held.
    chemicals: Box<dyn Chemicals>,
    scratch: Scratch,
}

/// The method of stepping a pair.
#[derive(Clone, Copy)]
enum Stepping {
    Plain,
    Fast(Option<Tiling>, Instructions),
}

impl OwnGrids {
    /// Time of a step, in 1/b.
    pub const STEP: f64 = SUPER_STEP_LIMIT as f64;

    /// Whether grids of their own save time where the smallest sizes of pairs range from `finest` to `coarsest`.
    pub fn are_worth(finest: f64, coarsest: f64) -> bool {
        coarsest >= DIFFERENT * finest
    }

    /// Cell size of the grid of a pair of this smallest size, relative to the finest grid.
    pub fn coarser(size: f64) -> f64 {
        let larger = size / CELLS;
        if larger < DIFFERENT { 1.0 } else { larger }
    }

    /// Whether the sizes differ so much that grids of their own save time. False with obstacle cells, which are known on one grid
    /// only.
    pub fn suit(maps: &PairParameterField) -> bool {
        let sizes = maps.pairs.iter().map(least_size);
        let largest = sizes.fold(0.0, f64::max);
        maps.obstacles.is_empty() && Self::are_worth(f64::from(maps.least_size()), largest)
    }

    /// Computes the coefficients and the initial concentrations; `None` if the length of a vector is not the number of cells.
    pub fn new(maps: &PairParameterField, model: &PairModel, start: &PairStart) -> Option<Self> {
        let pairs = maps.pairs.iter().map(|pair| OwnGrid::new(&maps.grid, pair, model));
        let mut pairs = pairs.collect::<Option<Vec<OwnGrid>>>()?;
        let cells = maps.grid.cells();
        match start {
            PairStart::Noise(seed) => {
                for (index, pair) in pairs.iter_mut().enumerate() {
                    let own = pair.grid.cells();
                    pair.set(&[0, 1].map(|plane| noise(own, 2 * index + plane, *seed)));
                }
            }
            PairStart::Drawn(drawn) if drawn.len() == cells => {
                let stepping = Stepping::chosen();
                for pair in &mut pairs {
                    pair.hold(drawn, maps.grid.size);
                    (0..(HELD / Self::STEP).ceil() as u64).for_each(|step| pair.step(step, stepping));
                }
            }
            PairStart::Grown(planes) if planes.len() == 2 * pairs.len() => {
                if planes.iter().any(|plane| plane.len() != cells) {
                    return None;
                }
                for (pair, planes) in pairs.iter_mut().zip(planes.chunks_exact(2)) {
                    let own = |plane: &Vec<f32>| averages(plane, maps.grid.size, pair.grid.size);
                    let planes = [own(&planes[0]), own(&planes[1])];
                    pair.set(&planes);
                }
            }
            PairStart::Drawn(_) | PairStart::Grown(_) => return None,
        }
        let unit = model.peak_gain() * model.gain.at(0.0);
        let raised = maps.raised.iter().map(|raised| unit * raised).collect();
        Some(Self { model: *model, grid: maps.grid, pairs, raised, steps: 0 })
    }

    pub fn advance(&mut self, steps: u64) {
        self.take(steps, Stepping::chosen());
    }

    pub fn advance_as(&mut self, steps: u64, tiling: Tiling, instructions: Instructions) {
        self.take(steps, Stepping::Fast(Some(tiling), instructions));
    }

    pub fn advance_plain(&mut self, steps: u64) {
        self.take(steps, Stepping::Plain);
    }

    fn take(&mut self, steps: u64, stepping: Stepping) {
        for _ in 0..steps {
            let differences: Vec<Vec<f32>> =
                self.differences().into_iter().map(|difference| difference.values).collect();
            let time = self.steps as f64 * Self::STEP;
            let reaction = reaction(&self.model, &differences, &self.raised, time);
            for pair in &mut self.pairs {
                pair.hold(&reaction, self.grid.size);
                pair.step(self.steps, stepping);
            }
            self.steps += 1;
        }
    }

    /// Cells along x and y of the finest grid.
    pub fn size(&self) -> [usize; 2] {
        self.grid.size
    }

    /// Super steps taken.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// The difference C₊ − C₋ of each pair on the finest grid.
    pub fn differences(&self) -> Vec<Field> {
        let difference = |pair: &OwnGrid| {
            let [plus, minus] = [0, 1].map(|plane| pair.chemicals.planes()[plane].cells());
            let own = plus.iter().zip(&minus).map(|(plus, minus)| plus - minus).collect();
            self.on_finest(&pair.grid, own)
        };
        self.pairs.iter().map(difference).collect()
    }

    /// The concentrations of each morphogen on the finest grid.
    pub fn concentrations(&self) -> Vec<Vec<f32>> {
        let planes = self.pairs.iter().flat_map(|pair| [(pair, 0), (pair, 1)]);
        planes
            .map(|(pair, plane)| self.on_finest(&pair.grid, pair.chemicals.planes()[plane].cells()).values)
            .collect()
    }

    fn on_finest(&self, grid: &Grid, values: Vec<f32>) -> Field {
        let [width, height] = self.grid.size;
        Field { cell: self.grid.cell, ..resample(&Field::new(grid, values), width, height) }
    }
}

impl OwnGrid {
    /// A grid for a pair, whose concentrations are still 0.
    fn new(finest: &Grid, pair: &PairField, model: &PairModel) -> Option<Self> {
        let grid = own_grid(finest, least_size(pair));
        let layout = RowLayout::new(&grid);
        let cells_a_cell = (finest.cell[0] * finest.cell[1] / (grid.cell[0] * grid.cell[1])).sqrt() as f32;
        let there = |cell: usize| finest.cell_at(finest.to_cells(grid.center_px(cell)));
        let own = PairField {
            direction: (0..grid.cells()).map(|cell| pair.direction[there(cell)]).collect(),
            size: (0..grid.cells()).map(|cell| pair.size[there(cell)] * cells_a_cell).collect(),
            blurs: pair.blurs,
        };
        let tensors = tensors(&own, model, layout, grid.cell);
        let largest = tensors.iter().map(|tensor| tensor.largest).fold(0.0, f32::max);
        let most = STEP_LIMIT / (4.0 * largest + 1.0);
        let stages = (1..).find(|stages| euler_steps(*stages) as f32 * most >= SUPER_STEP_LIMIT)?;
        let step = SUPER_STEP_LIMIT / euler_steps(stages) as f32;
        let mobility = Coefficients::new(layout, |_| (), |()| [step; MOBILITIES]);
        let rate = Coefficients::new(layout, |_| (), |()| [step]);
        let problem = Problem::new(layout, tensors.into(), [1.0, 1.0], mobility, rate, step);
        let chemicals = held_pairs(vec![Plane::flat(layout, 0.0); PLANES])?;
        Some(Self { grid, problem: Problem { stages, ..problem }, chemicals, scratch: Scratch::default() })
    }

    fn set(&mut self, planes: &[Vec<f32>; 2]) {
        for (plane, cells) in self.chemicals.planes_mut().iter_mut().zip(planes) {
            set_cells(plane, cells, self.grid.size[0]);
        }
    }

    /// Stores the mean over each cell of a reaction on a grid of `size` cells.
    fn hold(&mut self, reaction: &[f32], size: [usize; 2]) {
        let own = averages(reaction, size, self.grid.size);
        set_cells(&mut self.chemicals.planes_mut()[PLANES - 1], &own, self.grid.size[0]);
    }

    /// Takes a super step, after `taken` others.
    fn step(&mut self, taken: u64, stepping: Stepping) {
        let stages = self.problem.stages;
        let clock = Clock { steps: taken * stages as u64, step: OwnGrids::STEP / stages as f64 };
        match stepping {
            Stepping::Plain => {
                for stage in 0..stages as u64 {
                    self.chemicals.step(&self.problem, Clock { steps: clock.steps + stage, ..clock });
                }
            }
            Stepping::Fast(tiling, instructions) => {
                let suited = || Tiling::suited(&self.problem, PLANES, rayon::current_num_threads());
                let tiling = Tiling { time_steps: stages, ..tiling.unwrap_or_else(suited) };
                self.chemicals.sweep(&self.problem, clock, tiling, instructions, &mut self.scratch);
            }
        }
    }
}

impl Stepping {
    fn chosen() -> Self {
        match Solver::chosen() {
            Solver::Plain => Self::Plain,
            Solver::Fast(instructions) => Self::Fast(None, instructions),
        }
    }
}

/// The smallest size of a pair, cells.
fn least_size(pair: &PairField) -> f64 {
    f64::from(pair.size.iter().copied().fold(f32::INFINITY, f32::min))
}

/// The grid over the canvas on which `size` cells of the finest grid are [`CELLS`] cells; the finest grid itself if the difference
/// is small.
fn own_grid(finest: &Grid, size: f64) -> Grid {
    let larger = OwnGrids::coarser(size);
    if larger == 1.0 {
        return *finest;
    }
    finest.resized(finest.size.map(|side| (side as f64 / larger).ceil() as usize))
}

fn set_cells(plane: &mut Plane, cells: &[f32], width: usize) {
    cells.chunks_exact(width).enumerate().for_each(|(y, row)| plane.set_row(y, row));
}
