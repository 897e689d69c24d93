//! Runs of groups in a row that are stepped in one way.

use super::coefficients::Coefficients;
use super::diffusion::Diffusion;
use super::kinetics::MOBILITIES;
use super::plane::{LANES, MARGIN, RowLayout};
use super::selling::OFFSETS;
use crate::grid::Edges;

/// Consecutive groups of one row that are stepped in one way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Run {
    /// The first group after it.
    pub end: u32,
    /// The offsets that the first tensor uses, as bits.
    pub used: u32,
    /// Whether all its weights are 1: isotropic diffusion on square cells.
    pub unit: bool,
    /// Whether all groups have the coefficients of the first.
    pub same: bool,
    /// Whether the stencil reaches beyond a closed edge.
    pub edge: bool,
}

/// The runs of every row, stored once for equal rows.
#[derive(Clone, Debug)]
pub struct Runs {
    /// Start of the runs of each row.
    rows: Vec<u32>,
    runs: Vec<Run>,
}

impl Runs {
    /// Finds the runs for these coefficients (one tensor or more).
    #[must_use]
    pub fn new(
        grid: RowLayout,
        tensors: &[Diffusion],
        mobility: &Coefficients<MOBILITIES>,
        rate: &Coefficients<1>,
    ) -> Self {
        let reach = tensors.iter().map(|tensor| tensor.reach).fold(1, usize::max);
        let (mut rows, mut runs) = (vec![], vec![]);
        for y in 0..grid.ny {
            let same_tensors =
                |a: usize, b: usize| tensors.iter().all(|t| t.weights.place(a, y) == t.weights.place(b, y));
            let like = |group: usize| (mobility.place(group, y), rate.place(group, y));
            let mut row: Vec<Run> = Vec::new();
            for group in 0..grid.groups() {
                let run = Run { end: group as u32 + 1, ..alone(grid, reach, group, y, &tensors[0].weights) };
                match row.last_mut() {
                    Some(last) if (last.used, last.unit, last.edge) == (run.used, run.unit, run.edge) => {
                        last.same &= like(group) == like(group - 1) && same_tensors(group, group - 1);
                        last.end = run.end;
                    }
                    _ => row.push(run),
                }
            }
            let above = rows.last().map_or(0, |first| *first as usize);
            if runs[above..] == row {
                rows.push(above as u32);
            } else {
                rows.push(runs.len() as u32);
                runs.extend_from_slice(&row);
            }
        }
        Self { rows, runs }
    }

    /// The runs of row `y`, from the first group on, followed by those of later rows; the last run of a row ends with its last
    /// group.
    #[must_use]
    pub fn in_row(&self, y: usize) -> &[Run] {
        &self.runs[self.rows[y] as usize..]
    }
}

/// A run of one group, with stencils that reach `reach` cells; its end is set later.
fn alone(
    grid: RowLayout,
    reach: usize,
    group: usize,
    y: usize,
    weights: &Coefficients<{ OFFSETS.len() }>,
) -> Run {
    let (used, packs) = weights.in_group(group, y);
    let unit = used == 0b11 && packs[..2].iter().all(|pack| pack.0 == [1.0; LANES]);
    let left = group * LANES < MARGIN + reach;
    let right = (group + 1) * LANES + reach > MARGIN + grid.nx;
    let near = left || right || y < reach || y + reach >= grid.ny;
    Run { end: 0, used, unit, same: true, edge: near && grid.edges == Edges::Closed }
}
