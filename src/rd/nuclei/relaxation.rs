//! Spots that differ from each other: each takes the room that its own parameters need.

use crate::grid::{Bounds, Edges};
use crate::rd::System;
use crate::rd::maps::{Maps, Parameters};
use crate::rd::nuclei::boundary::Walls;
use crate::rd::nuclei::cell_list::{CellList, relax};
use crate::rd::nuclei::{FRAME, PUSH};
use crate::rd::nucleus::Nucleus;

/// Where the points `laid` come to stand in `rounds` rounds of mutual repulsion, each with the pitch and the metric of
/// its `own` parameters; those farther than `reach` pitches do not push each other. Those beyond the edges stay, and those
/// that are pinned.
#[must_use]
pub fn relax_places(
    system: System,
    maps: &Maps,
    laid: &Places,
    own: &[Parameters],
    reach: f64,
    rounds: usize,
) -> Vec<[f64; 2]> {
    let at = &laid.inside;
    if at.is_empty() {
        // There is no spot to move, and no reach to sort those beyond by.
        return Vec::new();
    }
    let nucleus = |i: usize, at: [f64; 2]| Nucleus::new(&own[i], maps.grid.cell, at, system.spacing(&own[i]));
    let largest = (0..at.len()).map(|i| nucleus(i, at[i]).reach).fold(0.0, f64::max);
    let Bounds { size, edges } = maps.grid.bounds();
    let frame = if edges == Edges::Closed { (FRAME * largest).ceil() } else { 0.0 };
    let space = Bounds { size: size.map(|side| side + 2.0 * frame), edges: Edges::Wrap };
    let framed = |at: [f64; 2]| space.folded(at.map(|v| v + frame));
    let pitch = |p: &Parameters| system.spacing(p);
    let beyond = laid.beyond.iter().filter(|at| (0..2).all(|i| (-frame..size[i] + frame).contains(&at[i])));
    let beyond: Vec<Nucleus> =
        beyond.map(|at| Nucleus { at: framed(*at), ..Nucleus::at(maps, *at, &pitch) }).collect();
    let moved = |i: usize, to: [f64; 2]| match i {
        i if i < laid.pinned => nucleus(i, framed(at[i])),
        i if i < own.len() => nucleus(i, to),
        i => beyond[i - own.len()],
    };
    let mut placed = CellList::new(space, PUSH.max(reach) * largest);
    at.iter().enumerate().for_each(|(i, at)| placed.insert(nucleus(i, framed(*at))));
    beyond.iter().for_each(|point| placed.insert(*point));
    for _ in 0..rounds {
        relax(&mut placed, reach, &moved);
    }
    if edges == Edges::Closed {
        Walls { frame, size }.keep_off_walls(&mut placed, laid.pinned, |placed| relax(placed, reach, &moved));
    }
    let stands = |point: &Nucleus| [0, 1].map(|i| (point.at[i] - frame).clamp(0.0, size[i] * (1.0 - 1e-12)));
    placed.all[..own.len()].iter().map(stands).collect()
}

/// Where points at `places`, cells, come to stand when those are moved that are too near a closed edge for a spot: on it,
/// or well off.
#[must_use]
pub fn adjust_to_walls(system: System, maps: &Maps, places: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    if maps.grid.edges == Edges::Wrap || places.is_empty() {
        return places;
    }
    let bounds = maps.grid.bounds();
    let nucleus = |at: [f64; 2]| Nucleus::at(maps, at, &|p| system.spacing(p));
    let all: Vec<Nucleus> = places.into_iter().map(nucleus).collect();
    let largest = all.iter().map(|point| point.reach).fold(0.0, f64::max);
    let mut placed = CellList::new(bounds, largest);
    placed.replace(all);
    Walls { frame: 0.0, size: bounds.size }.keep_off_walls(&mut placed, 0, |_| ());
    placed.all.iter().map(|point| point.at).collect()
}

/// Places of points, cells: those on the grid, and those that keep these from spreading over the edges.
#[derive(Clone, Debug, Default)]
pub struct Places {
    /// On the grid.
    pub inside: Vec<[f64; 2]>,
    /// Beyond closed edges, and on obstacle cells.
    pub beyond: Vec<[f64; 2]>,
    /// How many of those on the grid, the first, stay where they are.
    pub pinned: usize,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn relaxation_without_points_gives_no_points() {
        let p = Parameters { rate: 1.0, ratio: 20.0, stretch: 1.0, direction: 0.0, pitch: 1.0 };
        let maps = Maps::uniform([40, 40], Edges::Closed, p);
        let laid = Places { beyond: vec![[20.0, 20.0]], ..Places::default() };
        assert!(relax_places(System::MEINHARDT_SPOTS, &maps, &laid, &[], 1.0, 2).is_empty());
    }
}
