//! Spots whose places are given: the others are laid around them.

use crate::grid::{Buckets, Domain};
use crate::rd::System;
use crate::rd::nuclei::PUSH;
use crate::rd::nuclei::cell_list::{CellList, distance2};
use crate::rd::nuclei::obstacles::is_clear;
use crate::rd::nucleus::Nucleus;
use crate::rd::parameter_field::Parameters;

/// A spot that is to stand at a given place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PinnedSpot<P = [f64; 2]> {
    /// Its place, cells.
    pub at: P,
    /// The parameters of the room that it takes, in the frame of its place.
    pub own: Parameters,
    /// Distance to another spot, pitches, below which both would merge.
    pub near: f64,
}

impl<P: Copy> PinnedSpot<P> {
    pub(in crate::rd) fn nucleus<D: Domain<Place = P>>(&self, system: System, domain: &D) -> Nucleus<P> {
        Nucleus::new(&self.own, domain, domain.cell_at(self.at), self.at, system.spacing(&self.own))
    }
}

/// The reason why a spot cannot be at its given place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hindrance {
    /// The mark of another layer covers the place, or is too near.
    Obstacle,
    /// Another spot that stays is too near.
    Neighbour,
}

/// Whether each of `spots` can be at its place, beside the obstacle cells (empty = none). Nearly as many as possible are chosen so
/// that no two hinder each other. A closed edge hinders none, but spots near it are moved onto it.
#[must_use]
pub fn placeable<D: Domain>(
    system: System,
    domain: &D,
    obstacles: &[bool],
    spots: &[PinnedSpot<D::Place>],
) -> Vec<Result<(), Hindrance>> {
    if spots.is_empty() {
        // There is no spot, and so no reach to sort by.
        return Vec::new();
    }
    let nuclei: Vec<Nucleus<D::Place>> = spots.iter().map(|spot| spot.nucleus(system, domain)).collect();
    let clear: Vec<bool> = nuclei.iter().map(|nucleus| is_clear(domain, obstacles, nucleus)).collect();
    let largest = nuclei.iter().map(|nucleus| nucleus.reach).fold(1.0, f64::max);
    let mut placed = CellList::new(domain.buckets(PUSH * largest));
    nuclei.iter().zip(&clear).filter(|(_, clear)| **clear).for_each(|(nucleus, _)| placed.insert(*nucleus));
    let near: Vec<f64> =
        spots.iter().zip(&clear).filter(|(_, clear)| **clear).map(|(spot, _)| spot.near).collect();
    let mut stays = independent(&crowded(&placed, &near)).into_iter();
    let stands = |clear: bool| match clear.then(|| stays.next()) {
        None => Err(Hindrance::Obstacle),
        Some(stays) => stays.unwrap_or(false).then_some(()).ok_or(Hindrance::Neighbour),
    };
    clear.into_iter().map(stands).collect()
}

/// For each placed spot, the spots that are closer to it than the mean of the two `near` distances.
fn crowded<B: Buckets>(placed: &CellList<B>, near: &[f64]) -> Vec<Vec<usize>> {
    let mut crowded = vec![Vec::new(); placed.all.len()];
    for (i, point) in placed.all.iter().enumerate() {
        placed.near_by_index(point, PUSH, |other, displacement| {
            let least = 0.5 * (near[i] + near[other]);
            let there = &placed.all[other];
            // Images beyond a closed edge do not count as neighbours.
            let image = placed.is_to_image(point, there, displacement);
            if other != i && !image && distance2(point, there, displacement) < least * least {
                crowded[i].push(other);
            }
        });
    }
    crowded
}

/// An independent set, by index: no two members are `near` each other, and it has nearly as many members as possible. The spots
/// with the fewest undecided neighbours are taken first; among equals, the earlier one.
fn independent(near: &[Vec<usize>]) -> Vec<bool> {
    // Most spots have no others near them; these stay.
    let mut stays: Vec<Option<bool>> = near.iter().map(|near| near.is_empty().then_some(true)).collect();
    let beside: Vec<usize> = (0..near.len()).filter(|i| stays[*i].is_none()).collect();
    loop {
        let open = |i: &usize| stays[*i].is_none();
        let degree = |i: &usize| near[*i].iter().filter(|other| open(other)).count();
        let Some(next) = beside.iter().copied().filter(open).min_by_key(degree) else { break };
        near[next].iter().for_each(|other| {
            stays[*other].get_or_insert(false);
        });
        stays[next] = Some(true);
    }
    stays.into_iter().map(|stays| stays == Some(true)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Edges, Grid};
    use crate::rd::ParameterField;
    use crate::rd::nuclei::cell_list::Displacement;
    use crate::rd::nuclei::{ROUNDS, lay};
    use rand::SeedableRng;
    use rand_pcg::Pcg64Mcg;

    const P: Parameters = Parameters { rate: 6.0, ratio: 20.0, stretch: 0.7, direction: 20.0, pitch: 1.0 };

    fn pinned(places: &[[f64; 2]]) -> Vec<PinnedSpot> {
        places.iter().map(|at| PinnedSpot { at: *at, own: P, near: 0.6 }).collect()
    }

    #[test]
    fn every_second_spot_of_a_row_that_is_too_dense_is_kept() {
        let maps = ParameterField::uniform([200, 60], Edges::Closed, P);
        let pitch = System::MEINHARDT_SPOTS.spacing(&P);
        let row: Vec<[f64; 2]> = (0..7).map(|k| [20.0 + 0.55 * pitch * f64::from(k), 30.0]).collect();
        let stays = placeable(System::MEINHARDT_SPOTS, &maps.domain, &[], &pinned(&row));
        let stays: Vec<bool> = stays.iter().map(Result::is_ok).collect();
        assert_eq!(stays, [true, false, true, false, true, false, true]);
    }

    #[test]
    fn a_spot_on_obstacle_cells_does_not_exclude_others() {
        let mut maps = ParameterField::uniform([80, 60], Edges::Closed, P);
        maps.obstacles = (0..80 * 60).map(|cell| cell % 80 < 20).collect();
        let spots = pinned(&[[10.0, 30.0], [21.0, 30.0], [50.0, 30.0]]);
        let found = placeable(System::MEINHARDT_SPOTS, &maps.domain, &maps.obstacles, &spots);
        assert_eq!(found, [Err(Hindrance::Obstacle), Err(Hindrance::Obstacle), Ok(())]);
    }

    #[test]
    fn neighbours_across_the_border_count_only_on_a_tile() {
        let spots = pinned(&[[2.0, 30.0], [78.0, 30.0]]);
        let grid = |edges| Grid { size: [80, 60], cell: [1.0, 1.0], edges };
        let stand = |edges| placeable(System::MEINHARDT_SPOTS, &grid(edges), &[], &spots);
        assert_eq!(stand(Edges::Closed), [Ok(()), Ok(())]);
        assert_eq!(stand(Edges::Wrap), [Ok(()), Err(Hindrance::Neighbour)]);
    }

    #[test]
    fn other_spots_are_placed_around_pinned_spots() {
        let maps = ParameterField::uniform([160, 130], Edges::Closed, P);
        let system = System::MEINHARDT_SPOTS;
        let spots = pinned(&[[1.0, 50.0], [60.3, 61.7], [73.1, 70.2], [100.0, 100.0]]);
        let nuclei: Vec<Nucleus> = spots.iter().map(|spot| spot.nucleus(system, &maps.domain)).collect();
        let pitch = |p: &Parameters| system.spacing(p);
        for edges in [Edges::Closed, Edges::Wrap] {
            let maps = ParameterField::uniform([160, 130], edges, P);
            let free = lay(&maps, &pitch, &[], |_| ROUNDS, &mut Pcg64Mcg::seed_from_u64(3)).inside.len();
            let laid = lay(&maps, &pitch, &nuclei, |_| ROUNDS, &mut Pcg64Mcg::seed_from_u64(3)).inside;
            assert!(laid.iter().zip(&spots).all(|(laid, spot)| laid.at == spot.at));
            assert!(laid.len().abs_diff(free) * 12 <= free, "{} with, {free} without", laid.len());
            let near = laid[4..].iter().flat_map(|other| {
                nuclei.iter().map(|own| {
                    let displacement = [other.at[0] - own.at[0], other.at[1] - own.at[1]];
                    distance2(own, other, Displacement { here: displacement, there: displacement }).sqrt()
                })
            });
            assert!(near.fold(f64::INFINITY, f64::min) > 0.75);
        }
    }
}
