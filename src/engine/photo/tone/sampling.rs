//! Samples a picture on the cells of a grid over the canvas.

use rayon::prelude::*;

/// The position of the canvas on a picture, in px of the picture: the largest central part with its proportions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// The upper left corner.
    pub from: [f64; 2],
    /// Width and height.
    pub size: [f64; 2],
}

impl Frame {
    /// The part of a picture of `picture` px that a canvas of `canvas` px shows.
    #[must_use]
    pub fn covering(picture: [usize; 2], canvas: [f64; 2]) -> Self {
        let picture = picture.map(|side| side as f64);
        let scale = (picture[0] / canvas[0]).min(picture[1] / canvas[1]);
        let size = canvas.map(|side| side * scale);
        Self { from: [0, 1].map(|axis| 0.5 * (picture[axis] - size[axis])), size }
    }
}

/// `values` of a picture of `picture` px on `size` cells that cover `frame`: weighted means over triangles as wide as two cells or
/// two px, whichever is larger.
#[must_use]
pub fn sampled(
    values: &(impl Fn(usize) -> f32 + Sync),
    picture: [usize; 2],
    frame: &Frame,
    size: [usize; 2],
) -> Vec<f32> {
    let [across, down] =
        [0, 1].map(|axis| taps(picture[axis], frame.from[axis], frame.size[axis], size[axis]));
    let mut narrowed = vec![0.0; size[0] * picture[1]];
    narrowed.par_chunks_mut(size[0].max(1)).enumerate().for_each(|(y, row)| {
        for (cell, taps) in row.iter_mut().zip(&across) {
            *cell = taps.iter().map(|(x, weight)| weight * values(y * picture[0] + x)).sum();
        }
    });
    let mut out = vec![0.0_f32; size[0] * size[1]];
    out.par_chunks_mut(size[0].max(1)).zip(&down).for_each(|(row, taps)| {
        for (y, weight) in taps {
            let from = &narrowed[y * size[0]..(y + 1) * size[0]];
            row.iter_mut().zip(from).for_each(|(cell, value)| *cell += weight * value);
        }
    });
    out
}

/// The px of one axis that each cell reads, with their weights.
fn taps(px: usize, from: f64, length: f64, cells: usize) -> Vec<Vec<(usize, f32)>> {
    let step = length / cells as f64;
    let reach = step.max(1.0);
    let last = px.saturating_sub(1);
    let of_cell = |cell: usize| {
        let middle = from + (cell as f64 + 0.5) * step - 0.5;
        let [low, high] = [(middle - reach).ceil(), (middle + reach).floor()];
        let all: Vec<(usize, f64)> = (low as isize..=high as isize)
            .map(|at| {
                let weight = 1.0 - (at as f64 - middle).abs() / reach;
                (at.clamp(0, last as isize) as usize, weight.max(0.0))
            })
            .collect();
        let sum: f64 = all.iter().map(|(_, weight)| weight).sum();
        all.into_iter().map(|(at, weight)| (at, (weight / sum) as f32)).collect()
    };
    (0..cells).map(of_cell).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_canvas_shows_the_middle_of_a_wider_picture() {
        let frame = Frame::covering([300, 100], [50.0, 50.0]);
        assert_eq!(frame, Frame { from: [100.0, 0.0], size: [100.0, 100.0] });
    }

    #[test]
    fn a_ramp_stays_a_ramp_at_any_size() {
        let picture = [64, 8];
        let ramp = |px: usize| (px % 64) as f32;
        for cells in [16, 64, 200] {
            let frame = Frame::covering(picture, [64.0, 8.0]);
            let row = sampled(&ramp, picture, &frame, [cells, 4]);
            let wanted = |cell: usize| (cell as f32 + 0.5) * 64.0 / cells as f32 - 0.5;
            // At the border the mean lacks values from beyond.
            for (cell, found) in row[..cells].iter().enumerate().skip(cells / 8).take(cells - cells / 4) {
                assert!((found - wanted(cell)).abs() < 1e-3, "{cells} {cell}: {found}");
            }
        }
    }
}
