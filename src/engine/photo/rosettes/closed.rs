//! A group of cells, closed by a disc without joining it to others.

use crate::grid::distance::{length, nearest};
use crate::grid::{Edges, Grid};

/// Closes each group by a disc of `radius` cells, on a picture of `size` cells. Cells of others, and those beside them, are not added.
pub fn close(groups: &mut [&mut Vec<usize>], radius: f32, size: [usize; 2]) {
    let mut owners = vec![0_u32; size[0] * size[1]];
    for (number, cells) in groups.iter().enumerate() {
        cells.iter().for_each(|cell| owners[*cell] = number as u32 + 1);
    }
    for (number, cells) in groups.iter_mut().enumerate() {
        let own = number as u32 + 1;
        let added = added(cells, radius, size);
        let is_free = |cell: &usize| {
            let (x, y) = ((cell % size[0]) as isize, (cell / size[0]) as isize);
            (0..9).all(|k| {
                let [x, y] = [(x + k % 3 - 1, size[0]), (y + k / 3 - 1, size[1])]
                    .map(|(at, count)| Edges::Closed.index(at, count));
                [0, own].contains(&owners[y * size[0] + x])
            })
        };
        let added: Vec<usize> = added.into_iter().filter(is_free).collect();
        added.iter().for_each(|cell| owners[*cell] = own);
        cells.extend(added);
    }
}

/// The cells that a disc of `radius` cells adds to some cells when it closes them.
fn added(cells: &[usize], radius: f32, [width, height]: [usize; 2]) -> Vec<usize> {
    let margin = radius.ceil() as usize + 2;
    let places = || cells.iter().map(|cell| [cell % width, cell / width]);
    let range = |axis: usize, side: usize| {
        let low = places().map(|place| place[axis]).min().unwrap_or(0);
        let high = places().map(|place| place[axis]).max().unwrap_or(0);
        low.saturating_sub(margin)..(high + margin + 1).min(side)
    };
    let (columns, rows) = (range(0, width), range(1, height));
    let grid = Grid { size: [columns.len(), rows.len()], cell: [1.0; 2], edges: Edges::Closed };
    let mut inside = vec![false; grid.size[0] * grid.size[1]];
    places().for_each(|[x, y]| inside[(y - rows.start) * grid.size[0] + x - columns.start] = true);
    let beyond = |of: &[bool]| -> Option<Vec<bool>> {
        let far = |offset: [i32; 2]| length(offset, &grid) as f32 > radius;
        Some(nearest(of, &grid)?.into_iter().map(far).collect())
    };
    let Some(closed) = beyond(&inside).and_then(|open| beyond(&open)) else { return Vec::new() };
    let place =
        |cell: usize| (rows.start + cell / grid.size[0]) * width + columns.start + cell % grid.size[0];
    (0..closed.len()).filter(|cell| closed[*cell] && !inside[*cell]).map(place).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: [usize; 2] = [60, 40];

    /// The cells of a disc of radius 10 with a notch 4 cells wide, and those of a square 3 cells right of the disc.
    fn groups() -> [Vec<usize>; 2] {
        let at = |inside: &dyn Fn(f64, f64) -> bool| {
            let is_inside = |cell: &usize| inside((cell % 60) as f64, (cell / 60) as f64);
            (0..60 * 40).filter(is_inside).collect()
        };
        let disc =
            |x: f64, y: f64| (x - 20.0).hypot(y - 20.0) <= 10.0 && !((18.0..22.0).contains(&x) && y < 16.0);
        [at(&disc), at(&|x, y| (33.0..45.0).contains(&x) && (14.0..26.0).contains(&y))]
    }

    #[test]
    fn notches_are_filled_and_groups_side_by_side_stay_apart() {
        let [mut disc, mut square] = groups();
        let before = [disc.len(), square.len()];
        close(&mut [&mut disc, &mut square], 4.0, SIZE);
        let whole = std::f64::consts::PI * 100.0;
        assert!((disc.len() as f64 / whole - 1.0).abs() < 0.05, "{} {before:?}", disc.len());
        assert!(square.len() <= before[1] + 4);
        let touches = |cell: &usize| disc.contains(&(cell - 1)) || disc.contains(&(cell - 2));
        assert!(!square.iter().any(touches));
    }
}
