//! Means of a field over the cells of a coarser grid.

use rayon::prelude::*;

/// The mean of `values`, on `from` cells, over each of `to` cells of the same canvas, row by row: cells that two of these share count in
/// both by their parts. On as many cells they are the values.
#[must_use]
pub fn averages(values: &[f32], from: [usize; 2], to: [usize; 2]) -> Vec<f32> {
    if from == to {
        return values.to_vec();
    }
    let (columns, rows) = (parts(from[0], to[0]), parts(from[1], to[1]));
    let mut means = vec![0.0; to[0] * to[1]];
    means.par_chunks_mut(to[0]).zip(&rows).for_each_init(
        || vec![0.0; from[0]],
        |sums, (means, row)| {
            sums.fill(0.0);
            for &(y, share) in row {
                let of_row = &values[y * from[0]..(y + 1) * from[0]];
                sums.iter_mut().zip(of_row).for_each(|(sum, value)| *sum += share * value);
            }
            for (mean, column) in means.iter_mut().zip(&columns) {
                *mean = column.iter().map(|(x, share)| share * sums[*x]).sum();
            }
        },
    );
    means
}

/// Of each of `to` parts of a line, which of its `from` cells lie in it, and the share of each in its length.
fn parts(from: usize, to: usize) -> Vec<Vec<(usize, f32)>> {
    // In units of 1 ÷ (from · to) of the line, so that nothing is rounded.
    let part = |k: usize| {
        let [low, high] = [k * from, (k + 1) * from];
        let cells = low / to..high.div_ceil(to);
        let share = |cell: usize| {
            let shared = high.min((cell + 1) * to) - low.max(cell * to);
            (cell, shared as f32 / from as f32)
        };
        cells.map(share).collect()
    };
    (0..to).map(part).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn means_count_shared_cells_by_their_parts() {
        let thirds = averages(&[3.0, 6.0, 12.0], [3, 1], [2, 1]);
        assert!((thirds[0] - 4.0).abs() < 1e-5 && (thirds[1] - 10.0).abs() < 1e-5, "{thirds:?}");
        assert_eq!(averages(&[1.0, 2.0, 3.0, 6.0], [2, 2], [1, 1]), [3.0]);
        assert_eq!(averages(&[1.0, 2.0, 3.0, 6.0], [2, 2], [2, 2]), [1.0, 2.0, 3.0, 6.0]);
    }

    #[test]
    fn the_mean_of_all_stays() {
        let values: Vec<f32> = (0..31 * 17).map(|k| (k * 37 % 101) as f32).collect();
        let mean = |values: &[f32]| values.iter().sum::<f32>() / values.len() as f32;
        let means = averages(&values, [31, 17], [12, 5]);
        assert_eq!(means.len(), 60);
        assert!((mean(&means) - mean(&values)).abs() < 1e-3);
    }
}
