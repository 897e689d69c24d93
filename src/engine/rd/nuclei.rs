//! The starting places of spots: points at the natural spacing of the system.
//!
//! From noise, a system needs most of its time to find its own spacing. Points that already have this spacing, in the metric of the
//! local tensor, save that time and fix the number of spots. The system still moves and shapes spots, and removes those that have
//! no room.
//!
//! Dart throwing, then relaxation by mutual repulsion. Distances are measured by the local metric
//! ds² = (ρ·along² + across²/ρ)/pitch².

mod among;
mod boundary;
mod cell_list;
mod density;
mod geodesic;
mod obstacles;
mod pinned;
mod relaxation;
mod repulsion;

pub use among::{LaidAmong, LaidBefore, lay_among};
pub use density::density_of;
pub use pinned::{Hindrance, PinnedSpot, placeable};
pub use relaxation::{Places, adjust_to_walls, relax_places};

use rand::{Rng, RngExt};

use super::nucleus::{Metrics, Nucleus};
use super::parameter_field::{ParameterField, Parameters};
use crate::grid::{Buckets, Domain, Space};
use boundary::keep_off_walls;
use cell_list::{CellList, distance2};
use density::SpotDensity;
use geodesic::Christoffel;
use repulsion::relax;

/// Darts closer than this share of the pitch are refused. At 0.70 the wanted density is 81 % of the highest density of random
/// darts, so that few darts are wasted.
const DART: f64 = 0.70;
/// Neighbours closer than this share of the pitch push each other: the first ring of a hexagonal lattice.
const PUSH: f64 = 1.25;
/// Rounds of relaxation. Tuned by the spread of the spacing: 0.16 after darts, 0.085 after 30, 0.08 after 100.
pub const ROUNDS: usize = 30;

/// Width of the frame beyond closed edges in which spots are placed, in reaches of one pitch.
const FRAME: f64 = 1.5;

/// Points that were laid.
pub struct LaidSpots<P> {
    /// Nuclei on the domain, the pinned ones first.
    pub inside: Vec<Nucleus<P>>,
    /// Points beyond closed edges and on obstacle cells, which push the others back.
    pub beyond: Vec<Nucleus<P>>,
}

/// Points over the whole domain whose neighbours stand `pitch(parameters)` cells apart.
///
/// Closed edges are treated as if the pattern went on beyond them: points are laid over a margin too, which is cut off. The
/// `pinned` points stay where they are, on the domain; the others make room for them. Without obstacles the points are relaxed in
/// `rounds(n)` rounds, n being their number.
pub fn lay<D: Domain>(
    maps: &ParameterField<D>,
    pitch: &(dyn Fn(&Parameters) -> f64 + Sync),
    pinned: &[Nucleus<D::Place>],
    rounds: fn(usize) -> usize,
    rng: &mut impl Rng,
) -> LaidSpots<D::Place> {
    let density = SpotDensity::new(maps, pitch);
    let space = maps.domain.space((FRAME * density.largest).ceil());
    let nucleus = |at: D::Place| Nucleus { at, ..Nucleus::at(maps, space.to_domain(at), pitch) };
    let largest = pinned.iter().map(|pinned| pinned.reach).fold(density.largest, f64::max);
    let mut placed = CellList::new(space.buckets(PUSH * largest));
    let mut metrics = Metrics::new(maps, pitch);
    let mut dart = |at: D::Place| Nucleus { at, ..metrics.at(space.to_domain(at)) };
    let posts = obstacles::posts(maps, &mut placed, &mut |at| dart(space.to_space(at)));
    pinned.iter().for_each(|one| placed.insert(Nucleus { at: space.to_space(one.at), ..*one }));
    let fixed = placed.all.clone();
    let moving = fixed.len()..usize::MAX;
    let moved = |i: usize, before: &Nucleus<D::Place>, at: D::Place| {
        // The parameters, and so the metric, are constant within a cell.
        let stays = i < fixed.len() || maps.domain.cell_at(space.to_domain(at)) == before.cell;
        if stays { Nucleus { at, ..*before } } else { nucleus(at) }
    };
    let curvature = |point: &Nucleus<D::Place>| {
        maps.is_curved.then(|| Christoffel::at(maps, pitch, space.to_domain(point.at), point))
    };
    let clear = if posts.is_empty() { Vec::new() } else { obstacles::clear(maps, pitch) };
    let cell_at = |at: D::Place| maps.domain.cell_at(space.to_domain(at));
    let is_clear = |at: D::Place| clear.is_empty() || clear[cell_at(at)];
    if posts.is_empty() {
        let wanted = density.wanted(&space).saturating_sub(density.displaced_by(pinned, maps));
        let likely = |at: D::Place| density.densities[cell_at(at)] / density.densest;
        throw(&mut placed, wanted, &space, &likely, &mut dart, rng);
        let rounds = rounds(placed.all.len());
        relax(&space, &mut placed, rounds, PUSH, &moving, &curvature, &moved);
    } else {
        for closest in obstacles::FILLS {
            obstacles::fill(&mut placed, posts.len(), &space, closest, &is_clear, &mut dart, rng);
            for _ in 0..ROUNDS {
                obstacles::within(&mut placed, &is_clear, |placed| {
                    relax(&space, placed, 1, PUSH, &moving, &curvature, &moved);
                });
            }
        }
    }
    keep_off_walls(&space, &mut placed, fixed.len(), |placed| {
        obstacles::within(placed, &is_clear, |placed| {
            relax(&space, placed, 1, PUSH, &moving, &curvature, &moved);
        });
    });
    let mut all = placed.all.split_off(fixed.len());
    if !fixed.is_empty() {
        all.retain(|point| is_clear(point.at));
        // Where the points were laid: points beyond closed edges are no mirror images of points inside.
        all = obstacles::with_room(&fixed[posts.len()..], all, placed.emptied());
    }
    let on_domain = |point: Nucleus<D::Place>| Nucleus { at: space.to_domain(point.at), ..point };
    let inside = |point: &Nucleus<D::Place>| space.is_inside(point.at);
    let (mut inside, mut beyond): (Vec<_>, Vec<_>) = all.into_iter().map(on_domain).partition(inside);
    if inside.is_empty() && fixed.is_empty() {
        // A canvas smaller than the room of one spot still shows one spot.
        inside.push(Nucleus::at(maps, maps.domain.middle(), pitch));
    }
    beyond.extend(posts.into_iter().map(on_domain));
    LaidSpots { inside, beyond }
}

/// Dart throwing: places `wanted` more points over `space`, with the probability `likely`, 0..1, at a place.
fn throw<S: Space, B: Buckets<Place = S::Place>>(
    placed: &mut CellList<B>,
    wanted: usize,
    space: &S,
    likely: &dyn Fn(S::Place) -> f64,
    nucleus: &mut dyn FnMut(S::Place) -> Nucleus<S::Place>,
    rng: &mut impl Rng,
) {
    let wanted = placed.all.len() + wanted;
    let mut closest = DART;
    let mut refused = 0;
    while placed.all.len() < wanted {
        let at = space.random(rng);
        if rng.random::<f64>() > likely(at) {
            continue;
        }
        let dart = nucleus(at);
        if !placed.any_near(&dart, DART, |other, displacement| {
            distance2(&dart, other, displacement) < closest * closest
        }) {
            placed.insert(dart);
            refused = 0;
        } else {
            refused += 1;
            if refused > 1_000 {
                closest *= 0.95;
                refused = 0;
            }
        }
    }
}

/// The nuclei of `laid`, without those that have no room among the ones before them where they are `crowded`.
pub fn thinned<D: Domain>(
    laid: Vec<Nucleus<D::Place>>,
    maps: &ParameterField<D>,
    crowded: &dyn Fn(&Nucleus<D::Place>) -> bool,
) -> Vec<Nucleus<D::Place>> {
    let (rest, roomy): (Vec<_>, Vec<_>) = laid.into_iter().partition(crowded);
    if rest.is_empty() {
        return roomy;
    }
    let largest = roomy.iter().chain(&rest).map(|nucleus| nucleus.reach).fold(0.0, f64::max);
    let mut kept = CellList::new(maps.domain.buckets(PUSH * largest));
    roomy.into_iter().for_each(|nucleus| kept.insert(nucleus));
    for nucleus in rest {
        let mut free = true;
        kept.near(&nucleus, DART, |other, displacement| {
            free &= distance2(&nucleus, other, displacement) >= DART * DART;
        });
        if free {
            kept.insert(nucleus);
        }
    }
    kept.all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;
    use crate::rd::nuclei::boundary::HOLD;
    use rand::SeedableRng;
    use rand_pcg::Pcg64Mcg;

    fn placed(edges: Edges, stretch: f32) -> Vec<Nucleus> {
        let p = Parameters { rate: 1.0, ratio: 20.0, stretch, direction: 20.0, pitch: 1.0 };
        let maps = ParameterField::uniform([240, 200], edges, p);
        lay(&maps, &|_| 14.0, &[], |_| ROUNDS, &mut Pcg64Mcg::seed_from_u64(5)).inside
    }

    #[test]
    fn the_number_of_points_is_that_of_a_hexagonal_lattice_of_the_pitch() {
        for edges in [Edges::Closed, Edges::Wrap] {
            for stretch in [1.0, 0.4] {
                let wanted = (240.0 * 200.0 / (14.0 * 14.0 * 0.866_025_4)) as usize + 1;
                // Closed edges cut through spots: spots on an edge count as half.
                let (found, cut) = match edges {
                    Edges::Wrap => (placed(edges, stretch).len(), 0),
                    Edges::Closed => (placed(edges, stretch).len(), 24),
                };
                assert!(found.abs_diff(wanted) <= cut, "{found} of {wanted}");
            }
        }
    }

    #[test]
    fn the_smallest_canvas_has_a_spot() {
        let p = Parameters { rate: 1.0, ratio: 20.0, stretch: 0.5, direction: 90.0, pitch: 1.0 };
        for edges in [Edges::Closed, Edges::Wrap] {
            for seed in 0..20 {
                let maps = ParameterField::uniform([8, 8], edges, p);
                let laid = lay(&maps, &|_| 40.0, &[], |_| ROUNDS, &mut Pcg64Mcg::seed_from_u64(seed));
                let on = |at: f64| (0.0..8.0).contains(&at);
                assert!(!laid.inside.is_empty() && laid.inside.iter().all(|p| on(p.at[0]) && on(p.at[1])));
            }
        }
    }

    #[test]
    fn near_closed_edges_points_are_on_the_edge_or_far_enough_from_it() {
        let p = Parameters { rate: 1.0, ratio: 20.0, stretch: 0.5, direction: 90.0, pitch: 1.0 };
        let maps = ParameterField::uniform([240, 200], Edges::Closed, p);
        let all = lay(&maps, &|_| 14.0, &[], |_| ROUNDS, &mut Pcg64Mcg::seed_from_u64(5)).inside;
        // Upright marks, half as wide as long: the metric is (ρ·along² + across²/ρ)/pitch².
        let off = |at: f64, side: f64, pitch: f64| at.min(side - at) / pitch;
        let (mut on, mut inside) = (0, 0);
        for point in &all {
            for away in
                [off(point.at[0], 240.0, 14.0 * 0.5f64.sqrt()), off(point.at[1], 200.0, 14.0 / 0.5f64.sqrt())]
            {
                assert!(!(1e-9..=HOLD - 1e-9).contains(&away), "{away}");
                on += usize::from(away < 1e-9);
                inside += usize::from(away > 1.0);
            }
        }
        assert!(on > 10 && inside > 2 * on, "{on} {inside}");
    }

    #[test]
    fn distances_are_kept_in_the_local_metric() {
        for stretch in [1.0, 0.4] {
            let all = placed(Edges::Wrap, stretch);
            let closest = |a: &Nucleus| {
                let others = all.iter().filter(|b| b.at != a.at);
                let deltas = others.map(|b| {
                    [0, 1].map(|i| {
                        let n = [240.0, 200.0][i];
                        let d: f64 = b.at[i] - a.at[i];
                        d - n * (d / n).round()
                    })
                });
                deltas.map(|d| a.distance2(d).sqrt()).fold(f64::INFINITY, f64::min)
            };
            let distances: Vec<f64> = all.iter().map(closest).collect();
            let mean = distances.iter().sum::<f64>() / distances.len() as f64;
            let least = distances.iter().copied().fold(f64::INFINITY, f64::min);
            assert!(mean > 0.85 && least > 0.6, "stretch {stretch}: mean {mean}, least {least}");
        }
    }
}
