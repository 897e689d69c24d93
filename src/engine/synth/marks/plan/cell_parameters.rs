//! Parameters of the cells between the nodes of a lattice: row by row, many cells side by side.

use multiversion::multiversion;

use crate::grid::{Grid, atan2, exp};
use crate::rd::Parameters;
use crate::synth::marks::plan::cell_corners::{CellCorners, CellValues};
use crate::synth::marks::plan::lattice::{Lattice, Node};

/// Cells that are computed side by side. Not tuned.
const TOGETHER: usize = 64;

/// Number of values that are interpolated between nodes.
const FIELDS: usize = 5;

/// The cells of a grid between the nodes of a lattice over the same canvas.
pub struct CellParameters<'a> {
    lattice: &'a Lattice,
    corners: CellCorners,
}

impl<'a> CellParameters<'a> {
    /// The cells of `grid`.
    pub fn new(lattice: &'a Lattice, grid: &Grid) -> Self {
        Self { lattice, corners: CellCorners::new(&lattice.layout, grid) }
    }

    /// Writes the parameters of the cells from `first` on: those of [`Lattice::between`] at the centre of each cell, changed by
    /// `vary`, which is given the number of the cell, and then of [`Node::parameters`] with the `pitch` of the cell; up to rounding.
    pub fn write(
        &self,
        first: usize,
        pitch: &CellValues,
        vary: impl Fn(usize, Node) -> Node,
        mut parameters: &mut [Parameters],
    ) {
        let columns = self.corners.across().len();
        let mut cell = first;
        while !parameters.is_empty() {
            let (row, column) = (cell / columns, cell % columns);
            let (nodes, pitch) = (between_rows(self.lattice, &self.corners, row), pitch.row(row));
            let (of_row, rest) = parameters.split_at_mut(parameters.len().min(columns - column));
            let across = &self.corners.across()[column..column + of_row.len()];
            let mut x = column;
            for (some, across) in of_row.chunks_mut(TOGETHER).zip(across.chunks(TOGETHER)) {
                let mut values = [[0.0; TOGETHER]; FIELDS];
                let mut pitches = [0.0; TOGETHER];
                for (k, (left, right, share)) in across.iter().enumerate() {
                    let between =
                        nodes.each_ref().map(|nodes| (1.0 - share) * nodes[*left] + share * nodes[*right]);
                    let varied = fields(&vary(cell + k, node(between)));
                    values.iter_mut().zip(varied).for_each(|(values, varied)| values[k] = varied);
                    pitches[k] = pitch(x + k);
                }
                side_by_side(&values, &pitches, some);
                (cell, x) = (cell + some.len(), x + some.len());
            }
            parameters = rest;
        }
    }
}

/// The node with these values; its threshold is not used here.
fn node([ln_rate, ln_ratio, c, s, ln_pitch]: [f64; FIELDS]) -> Node {
    Node { ln_rate, ln_ratio, shape: [c, s], ln_pitch, level: 0.0 }
}

/// The inverse of [`node`].
fn fields(node: &Node) -> [f64; FIELDS] {
    [node.ln_rate, node.ln_ratio, node.shape[0], node.shape[1], node.ln_pitch]
}

/// The values of [`fields`] along row `y` of the grid, at the columns of nodes.
fn between_rows(lattice: &Lattice, corners: &CellCorners, y: usize) -> [Vec<f64>; FIELDS] {
    let (upper, lower, share) = corners.rows(y);
    let [upper, lower] = [upper, lower].map(|first| &lattice.nodes[first..first + corners.columns()]);
    let nodes: Vec<[f64; FIELDS]> = upper
        .iter()
        .zip(lower)
        .map(|(upper, lower)| {
            let (upper, lower) = (fields(upper), fields(lower));
            std::array::from_fn(|k| (1.0 - share) * upper[k] + share * lower[k])
        })
        .collect();
    std::array::from_fn(|k| nodes.iter().map(|node| node[k]).collect())
}

/// The parameters of each cell, see [`Node::parameters`].
#[multiversion(targets("x86_64+avx2"))]
fn side_by_side(
    [ln_rate, ln_ratio, c, s, ln_pitch]: &[[f64; TOGETHER]; FIELDS],
    pitches: &[f64; TOGETHER],
    parameters: &mut [Parameters],
) {
    let mut found = [[0.0f32; TOGETHER]; FIELDS];
    let [rate, ratio, stretch, direction, pitch] = &mut found;
    for k in 0..TOGETHER {
        rate[k] = exp(ln_rate[k]) as f32;
    }
    for k in 0..TOGETHER {
        ratio[k] = exp(ln_ratio[k]) as f32;
    }
    for k in 0..TOGETHER {
        stretch[k] = exp(-(c[k] * c[k] + s[k] * s[k]).sqrt()) as f32;
    }
    for k in 0..TOGETHER {
        direction[k] = (0.5 * atan2(s[k], c[k])).to_degrees() as f32;
    }
    for k in 0..TOGETHER {
        pitch[k] = (pitches[k] * exp(ln_pitch[k])) as f32;
    }
    for (k, p) in parameters.iter_mut().enumerate() {
        *p = Parameters {
            rate: rate[k],
            ratio: ratio[k],
            stretch: stretch[k],
            direction: direction[k],
            pitch: pitch[k],
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::attributes::regions::RegionGrid;
    use crate::grid::Edges;

    #[test]
    fn cells_have_the_parameters_that_they_have_one_by_one() {
        for edges in [Edges::Closed, Edges::Wrap] {
            let layout = RegionGrid { size: [200.0, 30.0], grid: [4, 3], edges };
            let node = |k: usize| {
                let k = k as f64;
                let shape = [0.9 - 0.17 * k, 0.13 * k - 0.5];
                Node {
                    ln_rate: 3.0 - 0.2 * k,
                    ln_ratio: 2.0 + 0.1 * k,
                    shape,
                    ln_pitch: 0.05 * k,
                    level: 0.5,
                }
            };
            let lattice = Lattice { layout, nodes: (0..12).map(node).collect() };
            let grid = Grid { size: [150, 17], cell: [200.0 / 150.0, 30.0 / 17.0], edges };
            let pitches: Vec<f64> = (0..12).map(|k| 1.0 + 0.01 * f64::from(k)).collect();
            let pitches = CellValues::new(&lattice.layout, &grid, &pitches);
            let pitch = |cell: usize| pitches.row(cell / 150)(cell % 150);
            let vary = |cell: usize, node: Node| Node { ln_rate: node.ln_rate + 0.001 * cell as f64, ..node };
            // Some of the first and of the last row are left out.
            let (first, end) = (37, 150 * 17 - 20);
            let mut found = Parameters::unwritten(end - first);
            CellParameters::new(&lattice, &grid).write(first, &pitches, vary, &mut found);
            for (cell, found) in (first..).zip(&found) {
                let single = vary(cell, lattice.at(grid.center_px(cell))).parameters(pitch(cell));
                let pairs = [
                    (found.rate, single.rate),
                    (found.ratio, single.ratio),
                    (found.stretch, single.stretch),
                    (found.direction, single.direction),
                    (found.pitch, single.pitch),
                ];
                let equal = |(a, b): &(f32, f32)| (a - b).abs() <= 2.0 * f32::EPSILON * b.abs();
                assert!(pairs.iter().all(equal), "{edges:?} {cell}: {found:?} {single:?}");
            }
        }
    }
}
