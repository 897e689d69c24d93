//! Spots at closed edges: on them or well off.

use crate::rd::nuclei::cell_list::CellList;
use crate::rd::nucleus::Nucleus;

/// Spots nearer to a closed edge than this share of the pitch are put on it. Seen: farther off they grow a tail to it.
const SNAP: f64 = 0.22;
/// Others are held this far from it; nearer they grow a tail too.
pub const HOLD: f64 = 0.42;

/// Rounds of relaxation around them.
const WALLED: usize = 10;

/// Closed edges of a grid that has a frame around it, over which points are laid too.
pub struct Walls {
    /// Width of the frame, cells.
    pub frame: f64,
    /// Sides of the grid, cells.
    pub size: [f64; 2],
}

impl Walls {
    /// Near a wall a spot cannot keep its shape. One on the wall is half a spot, cut by the edge; nearer than [`HOLD`] it
    /// would be drawn out to the wall. So those that are near are moved, once and for all, and the others `relax` around
    /// them. The first `fixed` stay.
    pub fn keep_off_walls(&self, placed: &mut CellList, fixed: usize, mut relax: impl FnMut(&mut CellList)) {
        let on_walls: Vec<[Option<f64>; 2]> =
            placed.all.iter().map(|point| [0, 1].map(|axis| self.wall_under(point, axis))).collect();
        for _ in 0..WALLED {
            relax(placed);
            placed.moved(|index, point| {
                if index < fixed {
                    return point.at;
                }
                [0, 1].map(|axis| on_walls[index][axis].unwrap_or_else(|| self.held(point, axis)))
            });
        }
    }

    /// The walls along one axis with the way inward.
    fn walls(&self, axis: usize) -> [(f64, f64); 2] {
        [(self.frame, 1.0), (self.frame + self.size[axis] * (1.0 - 1e-12), -1.0)]
    }

    /// The wall that a point is so near to that it is put on it.
    fn wall_under(&self, point: &Nucleus, axis: usize) -> Option<f64> {
        let near =
            |(wall, _): &(f64, f64)| (point.at[axis] - wall).abs() * point.pitches_to_wall(axis) < SNAP;
        self.walls(axis).into_iter().find(near).map(|(wall, _)| wall)
    }

    /// The coordinate of a point that is on no wall, moved away from walls that are too near.
    fn held(&self, point: &Nucleus, axis: usize) -> f64 {
        let far = HOLD / point.pitches_to_wall(axis);
        let hold = |at: f64, (wall, inward): (f64, f64)| match (at - wall) * inward {
            away if away <= 0.0 => at,
            away => wall + inward * away.max(far),
        };
        self.walls(axis).into_iter().fold(point.at[axis], hold)
    }
}
