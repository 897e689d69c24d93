//! Marks of other layers: new spots begin clear of them, and posts among them push these away.

use crate::grid::Domain;
use crate::rd::maps::{Maps, Parameters};
use crate::rd::nuclei::cell_list::{CellList, distance2};
use crate::rd::nucleus::Nucleus;
use rand::seq::SliceRandom;
use rand::{Rng, RngExt};
use rayon::prelude::*;

/// Distance of posts, pitches: so near that no spot fits in between.
const APART: f64 = 0.9;
/// Nearer to an obstacle cell than this share of a pitch no spot begins: half of its own length, and a gap. At 0.36 one in
/// some hundred touched.
const CLEAR: f64 = 0.45;

/// Puts posts on the obstacle cells, as many as keep other spots off, and returns them. However far spots stand apart from each
/// other, posts push no farther than a spot's own room.
pub fn posts(maps: &Maps, placed: &mut CellList, nucleus: &dyn Fn([f64; 2]) -> Nucleus) -> Vec<Nucleus> {
    for cell in (0..maps.obstacles.len()).filter(|cell| maps.obstacles[*cell]) {
        let post = nucleus(maps.grid.center(cell)).alone();
        let mut near = false;
        placed.near(&post, APART, |other, delta| near |= distance2(&post, other, delta) < APART * APART);
        if !near {
            placed.insert(post);
        }
    }
    placed.all.clone()
}

/// The clear cells are filled so often, each time with all the spots that find room so many pitches from all others.
/// Darts that leave no hole of 0.777 pitches are as many as a hexagonal lattice of 1 pitch has points (they cover 0.547,
/// it 0.907); those that follow fill what opens when the first have spread.
pub const FILLS: [f64; 2] = [0.777, 0.85];

/// Which cells stand clear of the obstacles: by the system's own distances, however far spots are to stand apart.
pub fn clear(maps: &Maps, pitch: &(dyn Fn(&Parameters) -> f64 + Sync)) -> Vec<bool> {
    let own = |p: &Parameters| pitch(p) / f64::from(p.pitch);
    let cells = (0..maps.obstacles.len()).into_par_iter();
    cells.map(|cell| is_clear(maps, &Nucleus::at(maps, maps.grid.center(cell), &own))).collect()
}

/// Places spots after the `posts` of `placed` wherever one is `clear` and `closest` pitches or more from all others,
/// until no cell of the space of this `size` has room for another.
pub fn fill(
    placed: &mut CellList,
    posts: usize,
    size: [f64; 2],
    closest: f64,
    clear: &dyn Fn([f64; 2]) -> bool,
    nucleus: &dyn Fn([f64; 2]) -> Nucleus,
    rng: &mut impl Rng,
) {
    let [nx, ny] = size.map(|side| side as usize);
    let mut cells: Vec<usize> = (0..nx * ny).collect();
    cells.shuffle(rng);
    let mut spots = placed.emptied();
    placed.all[posts..].iter().for_each(|spot| spots.insert(*spot));
    for cell in cells {
        let at = [(cell % nx) as f64 + rng.random::<f64>(), (cell / nx) as f64 + rng.random::<f64>()];
        if !clear(at) {
            continue;
        }
        let dart = nucleus(at);
        let mut free = true;
        spots
            .near(&dart, closest, |other, delta| free &= distance2(&dart, other, delta) >= closest * closest);
        if free {
            spots.insert(dart);
            placed.insert(dart);
        }
    }
}

/// Lets points `move_on`, but for those that would then no longer stand `clear`.
pub fn within(placed: &mut CellList, clear: &dyn Fn([f64; 2]) -> bool, move_on: impl FnOnce(&mut CellList)) {
    let before: Vec<[f64; 2]> = placed.all.iter().map(|point| point.at).collect();
    move_on(placed);
    placed.moved(|index, point| if clear(point.at) { point.at } else { before[index] });
}

/// Squeezed between marks, spots nearer to each other than this share of a pitch merge: of 450 five did at none, none did
/// at this.
const SQUEEZED: f64 = 0.76;

/// All of `pinned`, and those of `others` that have room among those before them. `placed` holds none yet.
pub fn with_room(pinned: &[Nucleus], others: Vec<Nucleus>, mut placed: CellList) -> Vec<Nucleus> {
    pinned.iter().for_each(|point| placed.insert(*point));
    for point in others {
        let mut free = true;
        placed.near(&point, SQUEEZED, |other, delta| {
            free &= distance2(&point, other, delta) >= SQUEEZED * SQUEEZED;
        });
        if free {
            placed.insert(point);
        }
    }
    placed.all
}

/// Is `place` (cells of `maps`) clear of the obstacle cells?
pub fn is_clear(maps: &Maps, place: &Nucleus) -> bool {
    if maps.obstacles.is_empty() {
        return true;
    }
    let mut near = maps.grid.near(place.at, CLEAR * place.reach, 0..maps.grid.cells());
    !near.any(|(cell, delta)| maps.is_obstacle(cell) && place.distance2(delta) < CLEAR * CLEAR)
}
