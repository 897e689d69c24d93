//! Planar Voronoi cells of points on a surface, and Turk's Laplacian from them.

use rayon::prelude::*;

use super::near::Near;
use super::relaxed::RelaxedPoints;
use crate::surface::{Laplacian, Surface};

/// Distance beyond which points have no effect on a cell, in radii of repulsion.
const REACH: f64 = 2.0;
/// The sum of the coefficients of each point, equal to that of the four neighbours on a square grid.
const SUM: f64 = 4.0;

/// A corner of a cell, and the neighbour across the edge that begins there.
type Corner = ([f64; 2], Option<u32>);

/// Turk's Laplacian: the coefficient of two neighbours is the length of the edge between their planar Voronoi cells; the
/// coefficients of a point are normalised to the sum 1 and multiplied by four. Its lengths are in units of √(mean cell area),
/// whatever the sizes of the cells: therefore patterns follow the density of the points.
#[must_use]
pub fn voronoi_laplacian(surface: &Surface, points: &RelaxedPoints) -> Laplacian {
    let near = Near::new(surface, &points.places);
    let row = |index: usize| {
        let around = near.around(index, REACH * points.radius);
        let mut edges = voronoi_edges(&around, REACH * points.radius);
        edges.sort_by_key(|(neighbour, _)| *neighbour);
        let sum: f64 = edges.iter().map(|(_, length)| length).sum();
        edges.iter_mut().for_each(|(_, length)| *length *= SUM / sum);
        edges
    };
    let rows: Vec<Vec<(u32, f64)>> = (0..points.places.len()).into_par_iter().map(row).collect();
    let mut starts = vec![0];
    for row in &rows {
        starts.push(starts.last().copied().unwrap_or_default() + row.len() as u32);
    }
    let columns = rows.iter().flatten().map(|(column, _)| *column).collect();
    let weights = rows.iter().flatten().map(|(_, weight)| *weight).collect();
    Laplacian { starts, columns, weights, mass: vec![1.0; rows.len()] }
}

/// The neighbours of a point at the origin with the lengths of the edges that its Voronoi cell shares with theirs; the cell is cut
/// off at `reach` along each axis.
fn voronoi_edges(around: &[(usize, [f64; 2])], reach: f64) -> Vec<(u32, f64)> {
    let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let mut cell: Vec<Corner> = square.map(|corner| (corner.map(|part| reach * part), None)).to_vec();
    for (neighbour, way) in around {
        cell = clipped(&cell, *way, *neighbour as u32);
    }
    let ends = cell.iter().zip(cell.iter().cycle().skip(1));
    let edge = |(from, to): (&Corner, &Corner)| {
        let (x, y) = (to.0[0] - from.0[0], to.0[1] - from.0[1]);
        let length = (x * x + y * y).sqrt();
        from.1.filter(|_| length > 0.0).map(|neighbour| (neighbour, length))
    };
    ends.filter_map(edge).collect()
}

/// The part of a convex polygon that is nearer to the origin than to a point.
fn clipped(polygon: &[Corner], point: [f64; 2], neighbour: u32) -> Vec<Corner> {
    let middle = 0.5 * (point[0] * point[0] + point[1] * point[1]);
    let beyond = |at: [f64; 2]| at[0] * point[0] + at[1] * point[1] - middle;
    let mut kept = Vec::with_capacity(polygon.len() + 1);
    for (index, (corner, edge)) in polygon.iter().enumerate() {
        let (end, _) = polygon[(index + 1) % polygon.len()];
        let [here, there] = [beyond(*corner), beyond(end)];
        let crossing = || {
            let share = here / (here - there);
            [0, 1].map(|axis| corner[axis] + share * (end[axis] - corner[axis]))
        };
        match (here <= 0.0, there <= 0.0) {
            (true, true) => kept.push((*corner, *edge)),
            // The new edge begins where this one ends.
            (true, false) => kept.extend([(*corner, *edge), (crossing(), Some(neighbour))]),
            (false, true) => kept.push((crossing(), *edge)),
            (false, false) => {}
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cell_of_a_square_lattice_is_a_square_and_farther_points_add_nothing() {
        let lattice = (-2..=2).flat_map(|x| (-2..=2).map(move |y| [f64::from(x), f64::from(y)]));
        let around: Vec<(usize, [f64; 2])> = lattice.filter(|way| *way != [0.0; 2]).enumerate().collect();
        let edges = voronoi_edges(&around, 4.0);
        let beside: Vec<[f64; 2]> = edges.iter().map(|(index, _)| around[*index as usize].1).collect();
        assert_eq!(edges.len(), 4, "{beside:?}");
        assert!(beside.iter().all(|[x, y]| x.abs() + y.abs() == 1.0));
        assert!(edges.iter().all(|(_, length)| (length - 1.0).abs() < 1e-12), "{edges:?}");
    }

    #[test]
    fn the_cell_of_a_hexagonal_lattice_is_a_hexagon_and_one_without_neighbours_has_no_edges() {
        let at = |turn: i32| {
            let (sin, cos) = libm::sincos(f64::from(turn) * std::f64::consts::FRAC_PI_3);
            [cos, sin]
        };
        let around: Vec<(usize, [f64; 2])> = (0..6).map(at).enumerate().collect();
        let edges = voronoi_edges(&around, 4.0);
        assert_eq!(edges.len(), 6);
        assert!(edges.iter().all(|(_, length)| (length - 1.0 / 3.0_f64.sqrt()).abs() < 1e-12), "{edges:?}");
        assert!(voronoi_edges(&[], 4.0).is_empty());
    }
}
