//! Spots at closed edges: they lie on an edge, or well away from it.

use crate::grid::{Buckets, Space, Wall};
use crate::rd::nuclei::cell_list::CellList;
use crate::rd::nucleus::Nucleus;

/// Spots closer to a closed edge than this share of the pitch are put on it. Spots that began slightly farther away were seen to
/// grow a tail towards the edge.
const SNAP: f64 = 0.22;
/// Other spots are kept at least this far from an edge, in pitches; closer ones grow a tail, too.
pub const HOLD: f64 = 0.42;

/// Rounds of relaxation around the spots that have been moved.
const WALLED: usize = 10;

/// Near a wall a spot cannot keep its shape. A spot on the wall is half a spot, cut by the edge; closer than [`HOLD`] it would be
/// stretched towards the wall. So spots near a wall are moved once, and the others `relax` around them. The first `fixed` stay.
pub fn keep_off_walls<S: Space, B: Buckets<Place = S::Place>>(
    space: &S,
    placed: &mut CellList<B>,
    fixed: usize,
    mut relax: impl FnMut(&mut CellList<B>),
) {
    let walls = space.walls();
    if walls.is_empty() {
        return;
    }
    let on_walls: Vec<Vec<bool>> = placed.all.iter().map(|point| walls_under(&walls, point)).collect();
    for _ in 0..WALLED {
        relax(placed);
        placed.moved(
            |index, point| {
                if index < fixed { point.at } else { held(&walls, &on_walls[index], point) }
            },
        );
    }
}

/// For each wall, whether a point is so close that it is put on the wall; of two walls that face each other, only one.
fn walls_under<P: Copy, W: Wall<P>>(walls: &[W], point: &Nucleus<P>) -> Vec<bool> {
    let mut on: Vec<bool> = Vec::with_capacity(walls.len());
    for wall in walls {
        let near = wall.depth(point.at).abs() * point.pitches_to_wall(wall.inward(point.at)) < SNAP;
        let taken = walls.iter().zip(&on).any(|(other, on)| *on && wall.faces(other));
        on.push(near && !taken);
    }
    on
}

/// The place of a point after it is put on the walls that it is `on`, and moved away from other walls that are too near.
fn held<P: Copy, W: Wall<P>>(walls: &[W], on: &[bool], point: &Nucleus<P>) -> P {
    let mut at = point.at;
    for (index, wall) in walls.iter().enumerate() {
        let between = walls.iter().zip(on).any(|(other, on)| *on && wall.faces(other));
        let depth = wall.depth(at);
        if on[index] {
            at = wall.at_depth(at, 0.0);
        } else if !between && depth > 0.0 {
            let far = HOLD / point.pitches_to_wall(wall.inward(at));
            at = wall.at_depth(at, depth.max(far));
        }
    }
    at
}
