//! Marks of other layers: new spots begin at a distance from them, and fixed points ("posts") on the marks push spots away.

use crate::grid::{Buckets, Domain, Space};
use crate::rd::nuclei::cell_list::{CellList, Displacement, distance2};
use crate::rd::nucleus::{Metrics, Nucleus};
use crate::rd::parameter_field::{ParameterField, Parameters};
use rand::seq::SliceRandom;
use rand::{Rng, RngExt};
use rayon::prelude::*;

/// Distance of posts, pitches: small enough that no spot fits between two.
const APART: f64 = 0.9;
/// No spot begins closer to an obstacle cell than this, in pitches: half of its own length, and a gap. At 0.36 about one spot in a
/// hundred touched.
const CLEAR: f64 = 0.45;

/// Puts posts on the obstacle cells, enough of them to keep spots off, and returns them. Posts push no farther than a spot's own
/// room, however far apart the spots are.
pub fn posts<D: Domain, B: Buckets<Place = D::Place>>(
    maps: &ParameterField<D>,
    placed: &mut CellList<B>,
    nucleus: &mut dyn FnMut(D::Place) -> Nucleus<D::Place>,
) -> Vec<Nucleus<D::Place>> {
    for cell in (0..maps.obstacles.len()).filter(|cell| maps.obstacles[*cell]) {
        let post = nucleus(maps.domain.center(cell)).alone();
        if !placed.any_near(&post, APART, |other, displacement| {
            distance2(&post, other, displacement) < APART * APART
        }) {
            placed.insert(post);
        }
    }
    placed.all.clone()
}

/// Distances of spots, pitches, in successive rounds of filling the clear cells; each round places spots until no cell has room.
/// Darts that leave no hole of 0.777 pitches are as many as the points of a hexagonal lattice of pitch 1 (they cover 0.547, the
/// lattice 0.907). The second round fills the holes that open when the first spots have spread.
pub const FILLS: [f64; 2] = [0.777, 0.85];

/// For each cell, whether it is far enough from the obstacles, measured by the system's natural spacing and not by the wanted one.
pub fn clear<D: Domain>(maps: &ParameterField<D>, pitch: &(dyn Fn(&Parameters) -> f64 + Sync)) -> Vec<bool> {
    let own = |p: &Parameters| pitch(p) / f64::from(p.pitch);
    let away = maps.domain.distances(&maps.obstacles);
    let known = |cell: usize, nucleus: &Nucleus<D::Place>| {
        let away = away.as_ref()?[cell];
        let [nearest, farthest] = nucleus.bounds(away);
        // A margin for the rounding of the distances.
        if nearest > CLEAR * (1.0 + 1e-9) {
            return Some(true);
        }
        (farthest < CLEAR * (1.0 - 1e-9)).then_some(false)
    };
    let cells = (0..maps.obstacles.len()).into_par_iter();
    let metrics = || Metrics::new(maps, &own);
    cells
        .with_min_len(maps.domain.part())
        .map_init(metrics, |metrics, cell| {
            if maps.obstacles[cell] {
                return false;
            }
            let nucleus = metrics.at(maps.domain.center(cell));
            known(cell, &nucleus).unwrap_or_else(|| is_clear(&maps.domain, &maps.obstacles, &nucleus))
        })
        .collect()
}

/// Cells that are tested together. Not tuned.
const BATCH: usize = 256;

/// Places spots after the `posts` of `placed` wherever one is `clear` and `closest` pitches or more from all others,
/// until no cell of `space` has room for another.
pub fn fill<S: Space, B: Buckets<Place = S::Place>>(
    placed: &mut CellList<B>,
    posts: usize,
    space: &S,
    closest: f64,
    clear: &dyn Fn(S::Place) -> bool,
    nucleus: &mut dyn FnMut(S::Place) -> Nucleus<S::Place>,
    rng: &mut impl Rng,
) {
    let mut cells: Vec<u32> = (0..space.cells() as u32).collect();
    cells.shuffle(rng);
    let mut spots = placed.emptied();
    placed.all[posts..].iter().for_each(|spot| spots.insert(*spot));
    // Cells come in random order. Their data are read for many cells at once, so that the reads do not wait for each other.
    let mut darts = Vec::with_capacity(BATCH);
    for batch in cells.chunks(BATCH) {
        let places = batch.iter().map(|cell| space.place_in(*cell as usize, [rng.random(), rng.random()]));
        darts.extend(places.filter(|at| clear(*at)).map(&mut *nucleus));
        for dart in darts.drain(..) {
            let hinders = |other: &Nucleus<S::Place>, displacement: Displacement| {
                distance2(&dart, other, displacement) < closest * closest
            };
            if !spots.any_near(&dart, closest, hinders) {
                spots.insert(dart);
                placed.insert(dart);
            }
        }
    }
}

/// Moves points by `move_on`, except points that would then be too close to an obstacle.
pub fn within<B: Buckets>(
    placed: &mut CellList<B>,
    clear: &dyn Fn(B::Place) -> bool,
    move_on: impl FnOnce(&mut CellList<B>),
) {
    let before: Vec<B::Place> = placed.all.iter().map(|point| point.at).collect();
    move_on(placed);
    placed.moved(|index, point| if clear(point.at) { point.at } else { before[index] });
}

/// Spots that are squeezed between marks merge if they are closer than this share of a pitch: without the limit five of 450 merged,
/// with it none.
const SQUEEZED: f64 = 0.76;

/// Least distance of another spot by the metric of one spot alone, pitches: a narrow spot needs the room in its long direction,
/// even next to a spot that lies across it.
const POINTED: f64 = 0.4;

/// All `pinned` points, and the `others` that have room among the points before them. `placed` must be empty.
pub fn with_room<B: Buckets>(
    pinned: &[Nucleus<B::Place>],
    others: Vec<Nucleus<B::Place>>,
    mut placed: CellList<B>,
) -> Vec<Nucleus<B::Place>> {
    pinned.iter().for_each(|point| placed.insert(*point));
    for point in others {
        let hinders = |other: &Nucleus<B::Place>, displacement: Displacement| {
            let nearer = point.distance2(displacement.here).min(other.distance2(displacement.there));
            distance2(&point, other, displacement) < SQUEEZED * SQUEEZED || nearer < POINTED * POINTED
        };
        if !placed.any_near(&point, SQUEEZED, hinders) {
            placed.insert(point);
        }
    }
    placed.all
}

/// Whether a place of the `domain` is far enough from the obstacle cells; true if `obstacles` is empty.
pub fn is_clear<D: Domain>(domain: &D, obstacles: &[bool], place: &Nucleus<D::Place>) -> bool {
    if obstacles.is_empty() {
        return true;
    }
    let mut near = domain.near(place.at, CLEAR * place.reach, 0..domain.cells());
    !near.any(|(cell, delta)| obstacles[cell] && place.distance2(delta) < CLEAR * CLEAR)
}
