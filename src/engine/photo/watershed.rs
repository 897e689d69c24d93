//! Separates spots that touch at their necks.
//!
//! The distance to the ground has a peak in the middle of each spot and a saddle at the neck between two. The region is flooded
//! from the peaks downwards; basins that meet at a saddle stay separate if the lower peak is clearly above it (watershed by
//! persistence: F. Meyer, "Topographic distance and watershed lines", Signal Processing 38 (1994)).

use crate::grid::Field;
use crate::grid::distance::{length, nearest};
use crate::marks::Moments;

/// A region that fills less of the ellipse of its second moments may consist of several spots: two that touch fill 0.75–0.9.
const FILL: f64 = 0.93;
/// The parts must fill their own ellipses better by this much, or the region stays whole: a bent spot is a single spot.
const GAIN: f64 = 0.04;
/// A neck is at most this share of the narrower part's width.
const NECK: f32 = 0.75;
/// A neck is narrower than the narrower part by at least this number of cells: px make steps of this size in any outline.
const STEP: f32 = 0.75;
/// Difference between the level and the value of cells of a neck: the interpolated surface may not rise above the level between
/// them.
const BELOW: f32 = 0.2;

/// Lowers the necks between spots that touch below `level`; returns the number of regions that were cut.
pub fn cut_apart(field: &mut Field, level: f32) -> usize {
    let ground: Vec<bool> = field.values.iter().map(|value| *value <= level).collect();
    let mut grid = field.grid();
    // Cells are square here: distances are counted in cells.
    grid.cell = [1.0; 2];
    let Some(offsets) = nearest(&ground, &grid) else { return 0 };
    let far = |at: usize| length(offsets[at], &grid) as f32;
    let size = [field.width, field.height];
    let mut seen = ground.clone();
    // The part that each cell belongs to; 0 = not processed yet.
    let mut parts = vec![0_u32; seen.len()];
    let mut cut = 0;
    for start in 0..seen.len() {
        if seen[start] {
            continue;
        }
        let cells = component(start, &mut seen, size);
        let fill = fill(cells.iter().copied(), size[0]);
        if fill >= FILL || cells.len() < 4 {
            continue;
        }
        let count = flood(&cells, far, size, &mut parts);
        if count > 1 && parts_fill(&cells, &parts, count, size[0]) > fill + GAIN {
            cut += 1;
            for at in &cells {
                let lower = around(*at, size).any(|near| parts[near] != 0 && parts[near] < parts[*at]);
                if lower {
                    field.values[*at] = field.values[*at].min(level - BELOW);
                }
            }
        }
        cells.iter().for_each(|at| parts[*at] = 0);
    }
    cut
}

/// The area of the mark that each cell above `level` belongs to, px²; 0 on the ground.
pub fn areas(field: &Field, level: f32) -> Vec<f64> {
    let mut seen: Vec<bool> = field.values.iter().map(|value| *value <= level).collect();
    let mut areas = vec![0.0; seen.len()];
    for start in 0..seen.len() {
        if !seen[start] {
            let cells = component(start, &mut seen, [field.width, field.height]);
            let area = cells.len() as f64 * field.cell[0] * field.cell[1];
            cells.iter().for_each(|cell| areas[*cell] = area);
        }
    }
    areas
}

/// The cells that are connected with `start`; they are marked as seen.
pub(super) fn component(start: usize, seen: &mut [bool], [width, height]: [usize; 2]) -> Vec<usize> {
    let mut cells = vec![start];
    seen[start] = true;
    let mut next = 0;
    while next < cells.len() {
        let at = cells[next];
        let (x, y) = (at % width, at / width);
        let sides = [
            (x > 0, at.wrapping_sub(1)),
            (x + 1 < width, at + 1),
            (y > 0, at.wrapping_sub(width)),
            (y + 1 < height, at + width),
        ];
        for (_, near) in sides.into_iter().filter(|(inside, _)| *inside) {
            if !std::mem::replace(&mut seen[near], true) {
                cells.push(near);
            }
        }
        next += 1;
    }
    cells
}

/// The up to eight cells around one.
fn around(at: usize, [width, height]: [usize; 2]) -> impl Iterator<Item = usize> {
    let (x, y) = ((at % width) as isize, (at / width) as isize);
    (0..9).filter(|k| *k != 4).filter_map(move |k| {
        let (x, y) = (x + k % 3 - 1, y + k / 3 - 1);
        let inside = x >= 0 && y >= 0 && x < width as isize && y < height as isize;
        inside.then(|| y as usize * width + x as usize)
    })
}

/// Numbers the parts of a region from 1 in `parts`; returns their number.
fn flood(cells: &[usize], far: impl Fn(usize) -> f32, size: [usize; 2], parts: &mut [u32]) -> usize {
    let mut order: Vec<(f32, usize)> = cells.iter().map(|at| (far(*at), *at)).collect();
    // From the highest down; equal ones in reading order.
    order.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    // For each basin: its peak, and the basin that it was joined to.
    let mut basins: Vec<(f32, usize)> = Vec::new();
    let root = |basins: &[(f32, usize)], mut basin: usize| {
        while basins[basin].1 != basin {
            basin = basins[basin].1;
        }
        basin
    };
    for (height, at) in order {
        // The way upwards leads to the highest of the neighbours that are flooded.
        let mut up: Option<(f32, usize)> = None;
        for near in around(at, size).filter(|near| parts[*near] > 0) {
            let other = root(&basins, parts[near] as usize - 1);
            let Some((highest, own)) = up else {
                up = Some((far(near), other));
                continue;
            };
            let own = root(&basins, own);
            if own != other {
                let (low, high) = if basins[own].0 < basins[other].0 { (own, other) } else { (other, own) };
                let peak = basins[low].0;
                if height >= NECK * peak || height >= peak - STEP {
                    basins[low].1 = high;
                }
            }
            if far(near) > highest {
                up = Some((far(near), other));
            }
        }
        let own = up.map_or(basins.len(), |(_, own)| root(&basins, own));
        if up.is_none() {
            basins.push((height, own));
        }
        parts[at] = own as u32 + 1;
    }
    // Renumbered without those that were joined.
    let mut numbers = vec![0_u32; basins.len()];
    let mut count = 0;
    for at in cells {
        let basin = root(&basins, parts[*at] as usize - 1);
        if numbers[basin] == 0 {
            count += 1;
            numbers[basin] = count;
        }
        parts[*at] = numbers[basin];
    }
    count as usize
}

/// Area ÷ area of the ellipse with equal second moments: 1 for an ellipse.
pub(super) fn fill(cells: impl Iterator<Item = usize>, width: usize) -> f64 {
    let mut moments = Moments::default();
    for at in cells {
        let (x, y) = ((at % width) as f64, (at / width) as f64);
        moments.add(&Moments::rectangle([x, x + 1.0], [y, y + 1.0]));
    }
    if moments.area <= 0.0 {
        return 1.0;
    }
    let (_, [xx, xy, yy]) = moments.central();
    let product = (xx * yy - xy * xy).max(f64::MIN_POSITIVE).sqrt();
    moments.area / (4.0 * std::f64::consts::PI * product)
}

/// The mean fill of the parts, by their areas.
fn parts_fill(cells: &[usize], parts: &[u32], count: usize, width: usize) -> f64 {
    let mut by_part = vec![Vec::new(); count];
    cells.iter().for_each(|at| by_part[parts[*at] as usize - 1].push(*at));
    let sum: f64 = by_part.iter().map(|cells| cells.len() as f64 * fill(cells.iter().copied(), width)).sum();
    sum / cells.len() as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;
    use crate::measure::spots;

    /// Soft discs (centre, radius) on 120 × 80 cells.
    fn discs(discs: &[([f64; 2], f64)]) -> Field {
        Field::from_fn([120, 80], [1.0; 2], Edges::Closed, |[x, y]| {
            let inside = |([cx, cy], r): &([f64; 2], f64)| 0.5 + 0.5 * (r - (x - cx).hypot(y - cy));
            discs.iter().map(inside).fold(0.0, f64::max).min(1.0) as f32
        })
    }

    #[test]
    fn two_discs_that_touch_become_two_of_their_areas() {
        let mut field = discs(&[([40.0, 40.0], 14.0), ([65.0, 44.0], 12.5), ([100.0, 20.0], 9.0)]);
        assert_eq!(spots(&field, 0.5).len(), 2);
        assert_eq!(cut_apart(&mut field, 0.5), 1);
        let mut areas: Vec<f64> = spots(&field, 0.5).iter().map(|spot| spot.ellipse.area()).collect();
        areas.sort_by(f64::total_cmp);
        let wanted = [9.0_f64, 12.5, 14.0].map(|r| std::f64::consts::PI * r * r);
        assert_eq!(areas.len(), 3);
        assert!(
            areas.iter().zip(wanted).all(|(area, wanted)| (area / wanted - 1.0).abs() < 0.06),
            "{areas:?}"
        );
    }

    #[test]
    fn an_ellipse_and_a_bent_spot_stay_whole() {
        let bent: Vec<([f64; 2], f64)> = (0..30)
            .map(|k| ([30.0 + 1.5 * f64::from(k), 40.0 - 0.06 * f64::from(k * (29 - k))], 7.0))
            .collect();
        let mut field = discs(&bent);
        assert_eq!(cut_apart(&mut field, 0.5), 0);
        assert_eq!(spots(&field, 0.5).len(), 1);
    }
}
