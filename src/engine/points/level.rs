//! The level above which a field has a given area, and the field rescaled to a pattern with its edges at ½.

use rayon::prelude::*;

use crate::grid::Field;

/// The share of the canvas above `level`, 0..1. The level divides a cell by the field's slope in it, so that the share is a
/// continuous function of the level.
#[must_use]
pub fn share_above(field: &Field, level: f32) -> f64 {
    share_above_beside(field, level, &[])
}

/// The share, 0..1, of the cells that are not `taken` which lies above `level`. If `taken` is empty, all cells count. 0 if no cell
/// is left.
#[must_use]
pub fn share_above_beside(field: &Field, level: f32, taken: &[bool]) -> f64 {
    share(field, &slopes(field), level, taken)
}

/// Difference between the value at the centre and at the corners of each cell: half of the steps to its neighbours, summed.
fn slopes(field: &Field) -> Vec<f32> {
    let mut slopes = vec![0.0; field.values.len()];
    slopes.par_chunks_mut(field.width.max(1)).enumerate().for_each(|(y, slopes)| {
        let row = |y: isize| {
            let start = field.edges.index(y, field.height) * field.width;
            &field.values[start..start + field.width]
        };
        let (above, here, below) = (row(y as isize - 1), row(y as isize), row(y as isize + 1));
        for (x, slope) in slopes.iter_mut().enumerate() {
            let beside = |x: isize| here[field.edges.index(x, field.width)];
            let across = if x > 0 && x + 1 < here.len() {
                here[x + 1] - here[x - 1]
            } else {
                beside(x as isize + 1) - beside(x as isize - 1)
            };
            *slope = 0.5 * (across.abs() + (below[x] - above[x]).abs());
        }
    });
    slopes
}

fn share(field: &Field, slopes: &[f32], level: f32, taken: &[bool]) -> f64 {
    let inside = |(value, slope): (&f32, &f32)| {
        let above = value - level;
        f64::from(if *slope > 0.0 { (above / slope + 0.5).clamp(0.0, 1.0) } else { f32::from(above > 0.0) })
    };
    let width = field.width.max(1);
    let rows = field.values.par_chunks(width).zip(slopes.par_chunks(width)).enumerate();
    let of_row = |(y, (row, slopes)): (usize, (&[f32], &[f32]))| {
        let free = |x: usize| !taken.get(y * width + x).is_some_and(|taken| *taken);
        let cells = row.iter().zip(slopes).enumerate().filter(|(x, _)| free(*x));
        cells.map(|(_, cell)| inside(cell)).sum::<f64>()
    };
    // Summed row by row, so that the sums do not depend on the number of threads.
    let rows: Vec<f64> = rows.map(of_row).collect();
    let free = field.values.len() - taken.iter().filter(|taken| **taken).count();
    rows.iter().sum::<f64>() / free.max(1) as f64
}

/// Bisections of the range 0..1: an error of 2⁻¹⁶ in the level moves no edge by a hundredth of a px.
const HALVINGS: usize = 16;

/// The level between 0 and 1 above which the share `wanted` of the canvas lies, 0..1.
///
/// ```
/// use dapple_engine::grid::{Edges, Field};
/// use dapple_engine::points::level::{level_of_share, share_above};
///
/// let ramp = Field::from_fn([64, 8], [1.0, 1.0], Edges::Closed, |[x, _]| x as f32 / 64.0);
/// let level = level_of_share(&ramp, 0.25);
/// assert!((share_above(&ramp, level) - 0.25).abs() < 0.01);
/// ```
#[must_use]
pub fn level_of_share(field: &Field, wanted: f64) -> f32 {
    level_of_share_beside(field, wanted, &[])
}

/// The level between 0 and 1 above which the share `wanted`, 0..1, of the cells that are not `taken` lies. If `taken` is empty, all
/// cells count.
#[must_use]
pub fn level_of_share_beside(field: &Field, wanted: f64, taken: &[bool]) -> f32 {
    let slopes = slopes(field);
    let [mut low, mut high] = [0.0f32, 1.0];
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if share(field, &slopes, middle, taken) > wanted { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// Rescales a field of 0..1 so that its level for this `share` of the canvas becomes ½, linearly below and above it. Returns the
/// previous level.
pub fn relevel(field: &mut Field, share: f64) -> f32 {
    let level = level_of_share(field, share).clamp(LEAST, 1.0 - LEAST);
    relevel_at(field, level);
    level
}

/// Rescales a field of 0..1 so that this `level` becomes ½, linearly below and above it.
pub fn relevel_at(field: &mut Field, level: f32) {
    let level = level.clamp(LEAST, 1.0 - LEAST);
    for value in &mut field.values {
        *value =
            if *value < level { 0.5 * *value / level } else { 0.5 + 0.5 * (*value - level) / (1.0 - level) };
    }
}

/// Rescales a field of 0..1 so that this `level` becomes ½: v·(1 − l) ÷ (l + v·(1 − 2l)). Unlike [`relevel`], it has no kink at the
/// edge. A spline through the cells would shift the edge at such a kink if the level is far from ½.
pub fn relevel_smoothly(field: &mut Field, level: f32) {
    let level = level.clamp(LEAST, 1.0 - LEAST);
    for value in &mut field.values {
        *value = smoothly(*value, level);
    }
}

/// A value, 0..1, rescaled as [`relevel_smoothly`] does.
#[must_use]
pub fn smoothly(value: f32, level: f32) -> f32 {
    let level = level.clamp(LEAST, 1.0 - LEAST);
    value * (1.0 - level) / (level + value * (1.0 - 2.0 * level))
}

/// Least distance of the level from 0 and 1: nearer levels would make the slope too steep.
const LEAST: f32 = 0.02;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;

    #[test]
    fn the_share_above_a_level_is_the_share_of_the_disc() {
        let cone = Field::from_fn([90, 70], [1.0, 1.0], Edges::Closed, |[x, y]| {
            (1.0 - libm::hypot(x - 44.3, y - 35.8) / 40.0) as f32
        });
        for radius in [9.0, 18.5, 27.3f64] {
            let share = std::f64::consts::PI * radius * radius / (90.0 * 70.0);
            let level = (1.0 - radius / 40.0) as f32;
            assert!((share_above(&cone, level) / share - 1.0).abs() < 2e-3, "{radius}");
            assert!((level_of_share(&cone, share) - level).abs() < 1e-3, "{radius}");
        }
    }

    #[test]
    fn smooth_rescaling_keeps_the_ends_and_the_order() {
        for level in [0.1, 0.5, 0.8f32] {
            let values = vec![0.0, 0.05, 0.1, 0.3, 0.5, 0.8, 0.9, 1.0];
            let mut field = Field { values, ..Field::flat(8, 1, Edges::Closed, 0.0) };
            relevel_smoothly(&mut field, level);
            assert!(
                field.values.is_sorted() && field.values[0] == 0.0 && (field.values[7] - 1.0).abs() < 1e-6
            );
            let mut edge = Field::flat(1, 1, Edges::Closed, level);
            relevel_smoothly(&mut edge, level);
            assert!((edge.values[0] - 0.5).abs() < 1e-6);
        }
    }

    #[test]
    fn the_levelled_field_has_its_edges_at_one_half() {
        let mut ramp = Field::from_fn([100, 4], [1.0, 1.0], Edges::Closed, |[x, _]| (x / 100.0) as f32);
        let level = relevel(&mut ramp, 0.3);
        assert!((level - 0.7).abs() < 1e-3);
        // The slope changes in the cell with the edge.
        assert!((share_above(&ramp, 0.5) - 0.3).abs() < 3e-3);
        assert!(ramp.values.iter().all(|value| (0.0..=1.0).contains(value)));
    }
}
