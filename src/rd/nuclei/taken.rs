//! Marks of other layers: posts among them keep new spots away.

use super::Nucleus;
use super::near::{Buckets, distance2};
use crate::rd::maps::Maps;

/// Posts stand this share of a pitch apart: so near that no spot slips in between.
const APART: f64 = 0.45;
/// Nearer to a post than this no spot is laid.
const CLEAR: f64 = 0.6;

/// Puts posts on the taken cells, as many as keep others off, and gives them.
pub fn posts(maps: &Maps, placed: &mut Buckets, nucleus: &dyn Fn([f64; 2]) -> Nucleus) -> Vec<Nucleus> {
    for cell in (0..maps.taken.len()).filter(|cell| maps.taken[*cell]) {
        let post = nucleus(maps.middle(cell));
        if !near(placed, &post, APART) {
            placed.insert(post);
        }
    }
    placed.all.clone()
}

/// Is a place too near to a post for a spot?
pub fn is_near(placed: &Buckets, place: &Nucleus) -> bool {
    near(placed, place, CLEAR)
}

fn near(placed: &Buckets, place: &Nucleus, pitches: f64) -> bool {
    let mut near = false;
    placed.near(place, pitches, |other, delta| near |= distance2(place, other, delta) < pitches * pitches);
    near
}
