//! The marks of a finished picture: where its colours come from marks, without crumbs, and with the share of ink of the pattern.
//!
//! A mark of the pattern keeps its largest piece. Every other piece is removed from the picture too: it gets the colours around it.

use std::collections::HashMap;

use super::noise::mixed;
use super::surfel::{Source, Surfel};
use crate::grid::Edges;

/// Steps of the level at which a px counts as ink.
const STEPS: usize = 256;

/// Removes crumbs from `picture`, and returns for each px the layer whose mark covers it after the finish; 0 = none.
pub fn settled(picture: &mut [Surfel], source: &Source) -> Vec<u8> {
    let before: Vec<bool> = source.labels.iter().map(|label| *label > 0).collect();
    let level = level(picture, &before);
    let mut ink: Vec<bool> = picture.iter().map(|surfel| surfel.ink >= level).collect();
    remove_crumbs(picture, source, &before, &mut ink);
    balance(picture, source, &before, &mut ink);
    remove_crumbs(picture, source, &before, &mut ink);
    let (width, scale) = (source.size[0], source.scale());
    let label = |px: usize| {
        if !ink[px] {
            return 0;
        }
        let point = [((px % width) as f32 + 0.5) / scale[0], ((px / width) as f32 + 0.5) / scale[1]];
        if source.labels[px] > 0 { source.labels[px] } else { source.reach.label_beside(point).max(1) }
    };
    (0..picture.len()).map(label).collect()
}

/// Gives a px its own colour, as if nothing had moved there.
fn revert(picture: &mut [Surfel], source: &Source, px: usize) {
    let [red, green, blue, ink] = source.px(px);
    picture[px].colour = [red, green, blue];
    picture[px].ink = ink;
}

/// Makes pieces of ink and ground that are not kept a part of what surrounds them, and brings back marks of which nothing is left.
fn remove_crumbs(picture: &mut [Surfel], source: &Source, before: &[bool], ink: &mut [bool]) {
    let (was, is) = (Pieces::of(before, source), Pieces::of(ink, source));
    let kept = kept(&was, &is, before, ink);
    let piece: Vec<bool> = is.root.iter().map(|root| ink[*root as usize]).collect();
    let width = source.size[0];
    for y in 0..source.size[1] {
        // Twice, so that what the first px of a row gets may come from the last ones.
        for x in (0..width).chain(0..width) {
            let px = y * width + x;
            let lost = !kept.was[was.root[px] as usize];
            if kept.is[is.root[px] as usize] && !lost {
                continue;
            }
            ink[px] = if lost { before[px] } else { !piece[px] };
            if ink[px] == before[px] {
                revert(picture, source, px);
                continue;
            }
            let left = source.edges.index(x as isize - 1, width);
            let beside = if left == x { 1.min(width - 1) } else { left };
            picture[px].colour = picture[y * width + beside].colour;
            picture[px].ink = f32::from(u8::from(ink[px]));
        }
    }
}

/// Gives px at the edges of marks back their own colour until there is as much ink as `before`.
fn balance(picture: &mut [Surfel], source: &Source, before: &[bool], ink: &mut [bool]) {
    let count = |ink: &[bool]| ink.iter().filter(|ink| **ink).count();
    let (found, wanted) = (count(ink), count(before));
    let surplus = found > wanted;
    let [width, height] = source.size;
    let at_edge = |px: usize| {
        let (x, y) = ((px % width) as isize, (px / width) as isize);
        [(-1, 0), (1, 0), (0, -1), (0, 1)].into_iter().any(|(dx, dy)| {
            let near = source.edges.index(y + dy, height) * width + source.edges.index(x + dx, width);
            ink[near] != surplus
        })
    };
    let candidates =
        (0..ink.len()).filter(|px| ink[*px] == surplus && before[*px] != surplus && at_edge(*px));
    let mut candidates: Vec<usize> = candidates.collect();
    // In a random order: along all edges alike.
    candidates.sort_by_key(|px| (mixed(*px as u32), *px));
    for px in candidates.into_iter().take(found.abs_diff(wanted)) {
        ink[px] = !surplus;
        revert(picture, source, px);
    }
}

/// The share of ink from which on a px counts as ink, so that as many px do as `before`; of equally good ones the nearest to ½.
fn level(picture: &[Surfel], before: &[bool]) -> f32 {
    let mut counts = [0_usize; STEPS + 1];
    for surfel in picture {
        counts[(surfel.ink.clamp(0.0, 1.0) * STEPS as f32) as usize] += 1;
    }
    let wanted = before.iter().filter(|ink| **ink).count();
    let mut above = 0;
    let mut best = (usize::MAX, STEPS, STEPS / 2);
    for step in (1..=STEPS).rev() {
        above += counts[step];
        let found = (above.abs_diff(wanted), step.abs_diff(STEPS / 2), step);
        best = best.min(found);
    }
    best.2 as f32 / STEPS as f32
}

/// Connected pieces of ink and of ground.
struct Pieces {
    /// For each px the first px of its piece.
    root: Vec<u32>,
}

impl Pieces {
    fn of(ink: &[bool], source: &Source) -> Self {
        let [width, height] = source.size;
        let mut root: Vec<u32> = (0..ink.len() as u32).collect();
        let wraps = source.edges == Edges::Wrap;
        for y in 0..height {
            for x in 0..width {
                let px = y * width + x;
                let right = if x + 1 < width { Some(px + 1) } else { wraps.then_some(y * width) };
                let below = if y + 1 < height { Some(px + width) } else { wraps.then_some(x) };
                for other in [right, below].into_iter().flatten().filter(|other| ink[*other] == ink[px]) {
                    join(&mut root, px as u32, other as u32);
                }
            }
        }
        // Roots come before their px.
        for px in 0..root.len() {
            root[px] = root[root[px] as usize];
        }
        Self { root }
    }
}

/// The first px of the piece of `px`; the path to it gets shorter.
fn find(root: &mut [u32], mut px: u32) -> u32 {
    while root[px as usize] != px {
        let next = root[px as usize];
        root[px as usize] = root[next as usize];
        px = next;
    }
    px
}

fn join(root: &mut [u32], a: u32, b: u32) {
    let (a, b) = (find(root, a), find(root, b));
    root[a.max(b) as usize] = a.min(b);
}

/// By the first px of each piece: whether a piece of the pattern is still there, and whether one of the picture stays.
struct Kept {
    was: Vec<bool>,
    is: Vec<bool>,
}

/// Of each piece of the pattern the largest piece in the picture stays.
fn kept(was: &Pieces, is: &Pieces, before: &[bool], ink: &[bool]) -> Kept {
    let mut shared: HashMap<(u32, u32), usize> = HashMap::new();
    for px in (0..ink.len()).filter(|px| before[*px] == ink[*px]) {
        *shared.entry((was.root[px], is.root[px])).or_default() += 1;
    }
    let mut largest: HashMap<u32, (usize, u32)> = HashMap::new();
    for ((was, is), count) in shared {
        let found = (count, u32::MAX - is);
        largest.entry(was).and_modify(|best| *best = found.max(*best)).or_insert(found);
    }
    let mut kept = Kept { was: vec![false; ink.len()], is: vec![false; ink.len()] };
    for (was, (_, is)) in largest {
        kept.was[was as usize] = true;
        kept.is[(u32::MAX - is) as usize] = true;
    }
    kept
}
