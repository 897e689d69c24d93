//! The growth of a system of pairs.

use super::own_grids::OwnGrids;
use super::shared_grid::SharedGrid;
use super::start::PairStart;
use super::{MOST_PAIRS, PairField, PairModel, PairParameterField};
use crate::grid::{Domain, Field};
use crate::rd::wavefront::{Instructions, Tiling};

/// A pattern of pairs being grown.
#[derive(Clone, Debug)]
pub struct PairGrowth {
    grids: Grids,
}

/// The grids of the pairs.
#[derive(Clone, Debug)]
enum Grids {
    Shared(SharedGrid),
    Own(OwnGrids),
}

impl PairGrowth {
    /// Computes the coefficients and the initial concentrations. Pairs whose sizes differ much get grids of their own. `None`
    /// without pairs, with more than [`MOST_PAIRS`], or if the length of a vector is not the number of cells.
    #[must_use]
    pub fn new(maps: &PairParameterField, model: &PairModel, start: &PairStart) -> Option<Self> {
        check(maps)?;
        if OwnGrids::suit(maps) {
            return Some(Self { grids: Grids::Own(OwnGrids::new(maps, model, start)?) });
        }
        Self::on_one_grid(maps, model, start)
    }

    /// Computes the coefficients and the initial concentrations, with all pairs on one grid. `None` in the cases of
    /// [`Self::new`].
    #[must_use]
    pub fn on_one_grid(maps: &PairParameterField, model: &PairModel, start: &PairStart) -> Option<Self> {
        check(maps)?;
        Some(Self { grids: Grids::Shared(SharedGrid::new(maps, model, start)?) })
    }

    /// This growth, before its first step, set to take super steps of `stages`; 1 = Euler steps. Pairs on grids of their own keep
    /// their number of stages.
    #[must_use]
    pub fn with_stages(self, stages: usize) -> Self {
        match self.grids {
            Grids::Shared(grid) => Self { grids: Grids::Shared(grid.with_stages(stages)) },
            Grids::Own(_) => self,
        }
    }

    /// Takes `steps` explicit steps, rounded up to whole super steps.
    pub fn advance(&mut self, steps: u64) {
        match &mut self.grids {
            Grids::Shared(grid) => grid.advance(steps),
            Grids::Own(grids) => grids.advance(steps),
        }
    }

    /// Takes `steps` explicit steps with this tiling and these instructions. The bits do not depend on the two.
    pub fn advance_as(&mut self, steps: u64, tiling: Tiling, instructions: Instructions) {
        match &mut self.grids {
            Grids::Shared(grid) => grid.advance_as(steps, tiling, instructions),
            Grids::Own(grids) => grids.advance_as(steps, tiling, instructions),
        }
    }

    /// Takes `steps` explicit steps with the plain solver, which gives the bits of the fast solver, but more slowly. The fast
    /// solver is tested and measured against it.
    pub fn advance_plain(&mut self, steps: u64) {
        match &mut self.grids {
            Grids::Shared(grid) => grid.advance_plain(steps),
            Grids::Own(grids) => grids.advance_plain(steps),
        }
    }

    /// Takes one super step in which the reaction is held at the shares of the cells above the threshold, so that edges leave the
    /// borders of cells. Only steps of this kind can follow. Pairs on grids of their own take a usual step: their reaction is a
    /// mean over cells in any case. `None` if `raised` is for another number of cells.
    pub fn advance_by_shares(&mut self, model: &PairModel, raised: &[f32]) -> Option<()> {
        match &mut self.grids {
            Grids::Shared(grid) => grid.advance_by_shares(model, raised),
            Grids::Own(grids) => {
                grids.advance(1);
                Some(())
            }
        }
    }

    /// Cells along x and y of the finest grid.
    #[must_use]
    pub fn grid(&self) -> [usize; 2] {
        match &self.grids {
            Grids::Shared(grid) => grid.size(),
            Grids::Own(grids) => grids.size(),
        }
    }

    /// Steps taken. On one grid the stages of super steps are counted one by one, as each is as much work as an Euler step; on
    /// grids of their own whole super steps are counted.
    #[must_use]
    pub fn steps(&self) -> u64 {
        match &self.grids {
            Grids::Shared(grid) => grid.steps(),
            Grids::Own(grids) => grids.steps(),
        }
    }

    /// Steps that make up `time`, in 1/b.
    #[must_use]
    pub fn steps_in(&self, time: f64) -> u64 {
        (time / self.time_a_step()).ceil().max(1.0) as u64
    }

    /// Time of the growth so far, in 1/b.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.steps() as f64 * self.time_a_step()
    }

    fn time_a_step(&self) -> f64 {
        match &self.grids {
            Grids::Shared(grid) => grid.time_a_step(),
            Grids::Own(_) => OwnGrids::STEP,
        }
    }

    /// The difference C₊ − C₋ of each pair.
    #[must_use]
    pub fn differences(&self) -> Vec<Field> {
        match &self.grids {
            Grids::Shared(grid) => grid.differences(),
            Grids::Own(grids) => grids.differences(),
        }
    }

    /// The concentrations of each morphogen, row by row: C₊ and C₋ of the first pair, then of the second, and so on.
    #[must_use]
    pub fn concentrations(&self) -> Vec<Vec<f32>> {
        match &self.grids {
            Grids::Shared(grid) => grid.concentrations(),
            Grids::Own(grids) => grids.concentrations(),
        }
    }
}

/// `None` without pairs, with too many, or if the length of a vector is not the number of cells.
fn check(maps: &PairParameterField) -> Option<()> {
    let cells = maps.grid.cells();
    let fits = |pair: &PairField| pair.direction.len() == cells && pair.size.len() == cells;
    let is_known = (1..=MOST_PAIRS).contains(&maps.pairs.len()) && maps.pairs.iter().all(fits);
    let covers = |values: usize| values == 0 || values == cells;
    (is_known && covers(maps.obstacles.len()) && covers(maps.raised.len())).then_some(())
}
