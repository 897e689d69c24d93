//! Marks of other layers: new spots begin clear of them, and posts among them push these away.

use super::Nucleus;
use super::near::{Buckets, distance2};
use crate::field::Edges;
use crate::rd::maps::Maps;

/// Posts stand this share of a pitch apart: so near that no spot slips in between.
const APART: f64 = 0.45;
/// Nearer to a taken cell than this share of a pitch no spot begins: half of its own length, and a gap. At 0.36 one in
/// some hundred touched.
const CLEAR: f64 = 0.42;

/// Puts posts on the taken cells, as many as keep others off, and gives them.
pub fn posts(maps: &Maps, placed: &mut Buckets, nucleus: &dyn Fn([f64; 2]) -> Nucleus) -> Vec<Nucleus> {
    for cell in (0..maps.taken.len()).filter(|cell| maps.taken[*cell]) {
        let post = nucleus(maps.middle(cell));
        let mut near = false;
        placed.near(&post, APART, |other, delta| near |= distance2(&post, other, delta) < APART * APART);
        if !near {
            placed.insert(post);
        }
    }
    placed.all.clone()
}

/// Squeezed between marks, spots nearer to each other than this share of a pitch merge: of 450 five did at none, none did
/// at this.
const SQUEEZED: f64 = 0.76;

/// All of `kept`, and those of `others` that stand clear of the taken cells and of those before them. `placed` holds none
/// yet.
pub fn with_room(
    maps: &Maps,
    edges: Edges,
    kept: &[Nucleus],
    others: Vec<Nucleus>,
    mut placed: Buckets,
) -> Vec<Nucleus> {
    kept.iter().for_each(|point| placed.insert(*point));
    for point in others {
        let mut free = is_clear(maps, edges, &point);
        placed.near(&point, SQUEEZED, |other, delta| {
            free &= distance2(&point, other, delta) >= SQUEEZED * SQUEEZED;
        });
        if free {
            placed.insert(point);
        }
    }
    placed.all
}

/// Is `place` (cells of `maps`) clear of the taken cells?
pub fn is_clear(maps: &Maps, edges: Edges, place: &Nucleus) -> bool {
    if maps.taken.is_empty() {
        return true;
    }
    let reach = CLEAR * place.reach;
    let range = |v: f64| (v - 0.5 - reach).ceil() as isize..=(v - 0.5 + reach).floor() as isize;
    let within = |v: isize, n: usize| edges == Edges::Wrap || (0..n as isize).contains(&v);
    !range(place.at[1]).filter(|y| within(*y, maps.ny)).any(|y| {
        let row = edges.index(y, maps.ny) * maps.nx;
        range(place.at[0]).filter(|x| within(*x, maps.nx)).any(|x| {
            let delta = [x as f64 + 0.5 - place.at[0], y as f64 + 0.5 - place.at[1]];
            maps.is_taken(row + edges.index(x, maps.nx)) && place.distance2(delta) < CLEAR * CLEAR
        })
    })
}
