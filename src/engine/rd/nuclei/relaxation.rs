//! Relaxation of unequal spots: each needs the room that its own parameters give.

use crate::grid::{Domain, Space};
use crate::rd::System;
use crate::rd::nuclei::boundary::keep_off_walls;
use crate::rd::nuclei::cell_list::CellList;
use crate::rd::nuclei::repulsion::{relax, straight};
use crate::rd::nuclei::{FRAME, PUSH};
use crate::rd::nucleus::Nucleus;
use crate::rd::parameter_field::{ParameterField, Parameters};

/// The places of the points `laid` after `rounds` rounds of mutual repulsion. Each point has the pitch and the metric of its `own`
/// parameters, whose direction is given in the frame of its place. Points farther apart than `reach` pitches do not push each
/// other. Pinned points and points beyond the edges stay.
#[must_use]
pub fn relax_places<D: Domain>(
    system: System,
    maps: &ParameterField<D>,
    laid: &Places<D::Place>,
    own: &[Parameters],
    reach: f64,
    rounds: usize,
) -> Vec<D::Place> {
    let (at, domain) = (&laid.inside, &maps.domain);
    if at.is_empty() {
        // There is no spot to move, and no reach by which to sort the points beyond the edges.
        return Vec::new();
    }
    let laid_in: Vec<usize> = at.iter().map(|at| domain.cell_at(*at)).collect();
    let reaches =
        own.iter().map(|own| Nucleus::new(own, domain, laid_in[0], at[0], system.spacing(own)).reach);
    let largest = reaches.fold(0.0, f64::max);
    let space = domain.space((FRAME * largest).ceil());
    let nucleus = |i: usize, to: D::Place| {
        let cell = domain.cell_at(space.to_domain(to));
        let own = own[i].turned(domain.transport_angle(laid_in[i], cell));
        Nucleus::new(&own, domain, cell, to, system.spacing(&own))
    };
    let framed = |at: D::Place| space.moved(space.to_space(at), [0.0; 2]);
    let pitch = |p: &Parameters| system.spacing(p);
    let beyond = laid.beyond.iter().filter(|at| space.covers(**at));
    let beyond: Vec<Nucleus<D::Place>> =
        beyond.map(|at| Nucleus { at: framed(*at), ..Nucleus::at(maps, *at, &pitch) }).collect();
    let moving = laid.pinned..own.len();
    let moved = |i: usize, before: &Nucleus<D::Place>, to: D::Place| {
        if i < laid.pinned || i >= own.len() {
            return *before;
        }
        let cell = domain.cell_at(space.to_domain(to));
        // In a frame that is not rotated the metric has equal numbers.
        let is_turned = domain.transport_angle(before.cell, cell) != 0.0;
        if is_turned { nucleus(i, to) } else { Nucleus { at: to, cell, ..*before } }
    };
    let mut placed = CellList::new(space.buckets(PUSH.max(reach) * largest));
    at.iter().enumerate().for_each(|(i, at)| placed.insert(nucleus(i, framed(*at))));
    beyond.iter().for_each(|point| placed.insert(*point));
    relax(&space, &mut placed, rounds, reach, &moving, &straight, &moved);
    keep_off_walls(&space, &mut placed, laid.pinned, |placed| {
        relax(&space, placed, 1, reach, &moving, &straight, &moved);
    });
    let stands = |point: &Nucleus<D::Place>| domain.inside(space.to_domain(point.at));
    placed.all[..own.len()].iter().map(stands).collect()
}

/// Returns the `places`, of which those too close to a closed edge for a whole spot are moved onto the edge or away from it.
#[must_use]
pub fn adjust_to_walls<D: Domain>(
    system: System,
    maps: &ParameterField<D>,
    places: Vec<D::Place>,
) -> Vec<D::Place> {
    let space = maps.domain.space(0.0);
    if space.walls().is_empty() || places.is_empty() {
        return places;
    }
    let nucleus = |at: D::Place| Nucleus::at(maps, at, &|p| system.spacing(p));
    let all: Vec<Nucleus<D::Place>> = places.into_iter().map(nucleus).collect();
    let largest = all.iter().map(|point| point.reach).fold(0.0, f64::max);
    let mut placed = CellList::new(space.buckets(largest));
    placed.replace(all);
    keep_off_walls(&space, &mut placed, 0, |_| ());
    placed.all.iter().map(|point| point.at).collect()
}

/// Places of points, cells: points on the domain, and points that prevent these from spreading beyond the edges.
#[derive(Clone, Debug)]
pub struct Places<P = [f64; 2]> {
    /// On the domain.
    pub inside: Vec<P>,
    /// Beyond closed edges, and on obstacle cells.
    pub beyond: Vec<P>,
    /// Number of points on the domain, counted from the first, that stay where they are.
    pub pinned: usize,
}

impl<P> Default for Places<P> {
    fn default() -> Self {
        Self { inside: Vec::new(), beyond: Vec::new(), pinned: 0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;

    #[test]
    fn relaxation_without_points_gives_no_points() {
        let p = Parameters { rate: 1.0, ratio: 20.0, stretch: 1.0, direction: 0.0, pitch: 1.0 };
        let maps = ParameterField::uniform([40, 40], Edges::Closed, p);
        let laid = Places { beyond: vec![[20.0, 20.0]], ..Places::default() };
        assert!(relax_places(System::MEINHARDT_SPOTS, &maps, &laid, &[], 1.0, 2).is_empty());
    }
}
