//! The supersampled grid on which a level line is followed: `factor` × `factor` nodes a cell, and a border of nodes.
//!
//! Nodes stand at the centres of the parts of a cell. Squares between neighbouring nodes must cover the canvas
//! exactly, so the grid is completed up to the border of the canvas: on a closed field by repeating the outermost nodes
//! on the border itself (values are mirrored there, so nothing changes across it); on a wrapped one by repeating the
//! first node after the last.

use rayon::prelude::*;

use crate::grid::resample::Spline;
use crate::grid::{Edges, Field};

/// The most nodes of a supersampled grid; a 4096² field gets at most 4 × 4 per cell.
const MOST_NODES: f64 = 3e8;

/// Nodes of a band.
const BAND: usize = 1 << 17;

/// A field read at `factor` × `factor` nodes a cell.
pub(super) struct SupersampledGrid<'a> {
    field: &'a Field,
    factor: usize,
    /// Positions of a row's nodes, px.
    pub(super) xs: Vec<f64>,
}

impl<'a> SupersampledGrid<'a> {
    /// The grid with `factor` nodes per cell along each side, or as many as fit.
    pub(super) fn new(field: &'a Field, factor: usize) -> Self {
        let cells = (field.width * field.height).max(1) as f64;
        let factor = factor.min((MOST_NODES / cells).sqrt() as usize).max(1);
        let xs = places(field.width * factor, field.cell[0] / factor as f64, field.edges);
        Self { field, factor, xs }
    }

    /// Does `work` on bands of rows, on all threads, and returns the results in the order of the bands.
    ///
    /// `work` takes the rows' ys (px), their values and whether the band is the topmost. The last row of a band is also the first
    /// of the next. Bands do not depend on the number of threads.
    pub(super) fn bands<T: Send>(&self, work: impl Fn(&[f64], &[f32], bool) -> T + Sync) -> Vec<T> {
        let field = self.field;
        let (width, height) = (field.width * self.factor, field.height * self.factor);
        if width == 0 || height == 0 {
            return Vec::new();
        }
        let ys = places(height, field.cell[1] / self.factor as f64, field.edges);
        let spline = (self.factor > 1).then(|| {
            let spline = Spline::new(field);
            let columns = spline.columns(width);
            (spline, columns)
        });
        // The row of nodes that row `i` of the completed grid repeats.
        let row = |i: usize| match field.edges {
            Edges::Closed => i.saturating_sub(1).min(height - 1),
            Edges::Wrap => i % height,
        };
        let rows = (BAND / self.xs.len()).max(16);
        let firsts: Vec<usize> = (0..ys.len() - 1).step_by(rows).collect();
        let band = |(completed, line, values): &mut (Vec<f32>, Vec<f32>, Vec<f32>), first: usize| {
            let last = (first + rows).min(ys.len() - 1);
            completed.resize((last + 1 - first) * self.xs.len(), 0.0);
            values.resize(width, 0.0);
            for (i, completed) in (first..=last).zip(completed.chunks_exact_mut(self.xs.len())) {
                let y = row(i);
                match &spline {
                    Some((spline, columns)) => {
                        spline.row(y, height, columns, line, values);
                        self.complete(values, completed);
                    }
                    None => self.complete(&field.values[y * width..(y + 1) * width], completed),
                }
            }
            work(&ys[first..=last], completed, first == 0)
        };
        firsts.into_par_iter().map_init(Default::default, band).collect()
    }

    /// A row of nodes with those on the border.
    fn complete(&self, values: &[f32], completed: &mut [f32]) {
        let n = values.len();
        match self.field.edges {
            Edges::Closed => {
                completed[1..=n].copy_from_slice(values);
                completed[0] = values[0];
                completed[n + 1] = values[n - 1];
            }
            Edges::Wrap => {
                completed[..n].copy_from_slice(values);
                completed[n] = values[0];
            }
        }
    }
}

/// Positions of `n` nodes `step` px apart, and of those on the border.
fn places(n: usize, step: f64, edges: Edges) -> Vec<f64> {
    let centre = |i: usize| (i as f64 + 0.5) * step;
    match edges {
        Edges::Wrap => (0..=n).map(centre).collect(),
        Edges::Closed => {
            let ends = [n as f64 * step];
            std::iter::once(0.0).chain((0..n).map(centre)).chain(ends).collect()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(field: &Field, factor: usize) -> (Vec<f64>, Vec<f64>, Vec<Vec<f32>>) {
        let nodes = SupersampledGrid::new(field, factor);
        let (mut ys, mut all) = (Vec::new(), Vec::new());
        let bands = nodes.bands(|ys, values, top| (ys.to_vec(), values.to_vec(), top));
        for (some, values, top) in bands {
            let again = usize::from(!top);
            ys.extend_from_slice(&some[again..]);
            all.extend(values.chunks(nodes.xs.len()).skip(again).map(<[f32]>::to_vec));
        }
        (nodes.xs.clone(), ys, all)
    }

    #[test]
    fn the_squares_cover_the_canvas_up_to_its_border() {
        let mut field = Field::flat(2, 1, Edges::Closed, 0.0);
        field.values = vec![1.0, 2.0];
        let (xs, ys, all) = rows(&field, 1);
        assert_eq!(xs, [0.0, 0.5, 1.5, 2.0]);
        assert_eq!(ys, [0.0, 0.5, 1.0]);
        assert_eq!(all, vec![vec![1.0, 1.0, 2.0, 2.0]; 3]);
        let field = Field { edges: Edges::Wrap, ..field };
        let (xs, ys, all) = rows(&field, 1);
        assert_eq!((xs, ys), (vec![0.5, 1.5, 2.5], vec![0.5, 1.5]));
        assert_eq!(all, vec![vec![1.0, 2.0, 1.0]; 2]);
    }

    #[test]
    fn bands_do_not_change_the_result() {
        let field = Field::from_fn([700, 900], [1.0, 1.0], Edges::Wrap, |[x, y]| (x + 1000.0 * y) as f32);
        let (_, ys, all) = rows(&field, 2);
        assert_eq!((ys.len(), all.len()), (1801, 1801));
        let whole = crate::grid::resample::resample(&field, 1400, 1800);
        for (y, row) in all.iter().enumerate().take(1800) {
            assert_eq!(row[..1400], whole.values[1400 * y..1400 * (y + 1)]);
        }
        assert_eq!(all[1800], all[0]);
    }
}
