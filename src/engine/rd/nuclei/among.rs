//! Spots around pinned ones, among others that have been laid before.

use rand::Rng;

use super::boundary::keep_off_walls;
use super::cell_list::{CellList, distance2};
use super::density::SpotDensity;
use super::repulsion::{relax, straight};
use super::{FRAME, PUSH, throw};
use crate::grid::{Buckets, Domain, Space};
use crate::rd::nucleus::{Metrics, Nucleus};
use crate::rd::parameter_field::{ParameterField, Parameters};

/// Rounds of relaxation: most of the points have been relaxed before. Not tuned.
const ROUNDS: usize = 20;
/// Points closer than this to a pinned one, in pitches, are displaced by it: on average 0.9 points of a hexagonal lattice. Within
/// 0.7 it would be 1.8.
const GIVES_WAY: f64 = 0.5;
/// Points that are still closer than this to a pinned one after relaxation, in pitches, are removed: they lie between several
/// pinned points. In 40 sketches like hand drawings 14 spots would otherwise lie within half a spacing of a drawn one, instead of
/// 5.
const NO_ROOM: f64 = 0.7;

/// Points that have been laid without pinned ones.
pub struct LaidBefore<'a, P> {
    /// Points that stay where they are: on the domain, and beyond its closed edges.
    pub kept: [Vec<Nucleus<P>>; 2],
    /// Points that move, or give way to others. All lie on open cells.
    pub near: Vec<Nucleus<P>>,
    /// Density at which all were laid, points per cell.
    pub density: f64,
    /// By cell, whether other points may lie there.
    pub open: &'a [bool],
}

/// A point among others that have been laid before.
pub struct LaidAmong<P> {
    /// Index of the point among the `near` points before; `None` = the point is new.
    pub was: Option<usize>,
    /// Its place and metric.
    pub point: Nucleus<P>,
}

/// Points on the open cells, with neighbours `pitch(parameters)` cells apart: points laid `before` for which the `pinned` ones
/// leave room, and new points where some are missing. There must be no obstacles.
pub fn lay_among<D: Domain>(
    maps: &ParameterField<D>,
    pitch: &(dyn Fn(&Parameters) -> f64 + Sync),
    pinned: &[Nucleus<D::Place>],
    before: &LaidBefore<D::Place>,
    rng: &mut impl Rng,
) -> Vec<LaidAmong<D::Place>> {
    let density = SpotDensity::new(maps, pitch);
    // About the margin over which the points `before` were laid.
    let margin = before.kept.iter().flatten().map(|nucleus| nucleus.reach).fold(0.0, f64::max);
    let space = maps.domain.space((FRAME * margin).ceil());
    let largest = pinned.iter().map(|pinned| pinned.reach).fold(density.largest.max(margin), f64::max);
    let mut placed = CellList::new(space.buckets(PUSH * largest));
    let framed =
        |one: &Nucleus<D::Place>| Nucleus { at: space.moved(space.to_space(one.at), [0.0; 2]), ..*one };
    pinned.iter().for_each(|one| placed.insert(framed(one)));
    let near: Vec<Nucleus<D::Place>> = before.near.iter().map(framed).collect();
    // The points that lay there, plus the increase of their density.
    let denser = |cell: usize| if before.open[cell] { density.densities[cell] - before.density } else { 0.0 };
    let wanted = near.len() as f64 + space.integral(denser) - density.displaced_by(pinned, maps) as f64;
    let wanted = if before.open.contains(&true) { wanted.max(0.0).round() as usize } else { 0 };
    let stayed = with_room(&placed, &near, wanted);
    before.kept.iter().flatten().for_each(|one| placed.insert(framed(one)));
    let fixed = placed.all.len();
    stayed.iter().for_each(|index| placed.insert(near[*index]));
    let cell_at = |at: D::Place| maps.domain.cell_at(space.to_domain(at));
    let mut metrics = Metrics::new(maps, pitch);
    let mut dart = |at: D::Place| Nucleus { at, ..metrics.at(space.to_domain(at)) };
    let likely = |at: D::Place| {
        let cell = cell_at(at);
        if before.open[cell] { density.densities[cell] / density.densest } else { 0.0 }
    };
    throw(&mut placed, wanted - stayed.len(), &space, &likely, &mut dart, rng);
    let moving = fixed..usize::MAX;
    let moved = |_: usize, before: &Nucleus<D::Place>, at: D::Place| {
        let stays = cell_at(at) == before.cell;
        if stays {
            Nucleus { at, ..*before }
        } else {
            Nucleus { at, ..Nucleus::at(maps, space.to_domain(at), pitch) }
        }
    };
    relax(&space, &mut placed, ROUNDS, PUSH, &moving, &straight, &moved);
    keep_off_walls(&space, &mut placed, fixed, |placed| {
        relax(&space, placed, 1, PUSH, &moving, &straight, &moved);
    });
    let on_domain = |point: Nucleus<D::Place>| Nucleus { at: space.to_domain(point.at), ..point };
    let laid = placed.all.split_off(fixed);
    placed.replace(pinned.iter().map(framed).collect());
    let has_room = |(_, point): &(usize, Nucleus<D::Place>)| to_nearest(&placed, point) >= NO_ROOM;
    let all = laid.into_iter().enumerate().filter(has_room);
    all.map(|(k, point)| LaidAmong { was: stayed.get(k).copied(), point: on_domain(point) }).collect()
}

/// The distance of a point to the nearest `pinned` one, pitches; infinite where none is near.
fn to_nearest<B: Buckets>(pinned: &CellList<B>, point: &Nucleus<B::Place>) -> f64 {
    let mut nearest = f64::INFINITY;
    pinned.near(point, 2.0 * PUSH, |other, displacement| {
        nearest = nearest.min(distance2(point, other, displacement));
    });
    nearest.sqrt()
}

/// The indices of the `near` points for which the `pinned` ones leave room, at most `most`; the points nearest to a pinned one are
/// removed first.
fn with_room<B: Buckets>(pinned: &CellList<B>, near: &[Nucleus<B::Place>], most: usize) -> Vec<usize> {
    let distances: Vec<f64> = near.iter().map(|point| to_nearest(pinned, point)).collect();
    let mut order: Vec<usize> = (0..near.len()).collect();
    order.sort_by(|a, b| distances[*a].total_cmp(&distances[*b]));
    let crowded = order.iter().filter(|index| distances[**index] < GIVES_WAY).count();
    let mut stayed = order.split_off(crowded.max(near.len().saturating_sub(most)));
    stayed.sort_unstable();
    stayed
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;
    use crate::rd::nuclei::{ROUNDS, density_of, lay};
    use rand::SeedableRng;
    use rand_pcg::Pcg64Mcg;

    const PITCH: f64 = 14.0;

    fn maps(edges: Edges) -> ParameterField {
        let p = Parameters { rate: 1.0, ratio: 20.0, stretch: 0.8, direction: 20.0, pitch: 1.0 };
        ParameterField::uniform([260, 240], edges, p)
    }

    struct Laid {
        pinned: Vec<Nucleus>,
        kept: Vec<Nucleus>,
        before: Vec<Nucleus>,
        among: Vec<LaidAmong<[f64; 2]>>,
    }

    /// Points laid by themselves. Those within 50 cells of [120, 110] are displaced by the `pinned` ones.
    fn laid(edges: Edges, pinned: &[[f64; 2]]) -> Laid {
        let maps = maps(edges);
        let alone = lay(&maps, &|_| PITCH, &[], |_| ROUNDS, &mut Pcg64Mcg::seed_from_u64(7));
        let is_near = |at: [f64; 2]| (at[0] - 120.0).powi(2) + (at[1] - 110.0).powi(2) < 2500.0;
        let at = |cell: usize| [(cell % 260) as f64, (cell / 260) as f64];
        let open: Vec<bool> = (0..260 * 240).map(|cell| is_near(at(cell))).collect();
        let (near, kept): (Vec<_>, Vec<_>) = alone.inside.into_iter().partition(|one| is_near(one.at));
        let pinned: Vec<Nucleus> = pinned.iter().map(|at| Nucleus::at(&maps, *at, &|_| PITCH)).collect();
        let before = LaidBefore { kept: [kept, alone.beyond], near, density: density_of(PITCH), open: &open };
        let among = lay_among(&maps, &|_| PITCH, &pinned, &before, &mut Pcg64Mcg::seed_from_u64(8));
        Laid { pinned, kept: before.kept.concat(), before: before.near, among }
    }

    #[test]
    fn each_pinned_point_displaces_one_and_all_have_room() {
        for edges in [Edges::Closed, Edges::Wrap] {
            let places = [[100.3, 104.0], [115.0, 108.8], [123.0, 121.0], [138.0, 96.0]];
            let Laid { pinned, kept, before, among } = laid(edges, &places);
            assert_eq!(among.len() + pinned.len(), before.len(), "{edges:?}");
            let grid = maps(edges).domain;
            let mut all = CellList::new(grid.buckets(2.0 * PITCH));
            pinned
                .iter()
                .chain(&kept)
                .chain(among.iter().map(|one| &one.point))
                .for_each(|one| all.insert(*one));
            for LaidAmong { point, .. } in &among {
                let mut nearest = f64::INFINITY;
                all.near(point, 1.0, |other, displacement| {
                    if other.at != point.at {
                        nearest = nearest.min(distance2(point, other, displacement).sqrt());
                    }
                });
                assert!(nearest > 0.7, "{edges:?}: {:?} {nearest}", point.at);
            }
        }
    }

    #[test]
    fn points_a_few_pitches_from_the_pinned_ones_hardly_move() {
        let Laid { before, among, .. } = laid(Edges::Wrap, &[[100.3, 104.0]]);
        let moved = |LaidAmong { was, point: now }: &LaidAmong<[f64; 2]>| {
            let at = before[was.expect("none is new")].at;
            let displacement = (at[0] - 100.3).hypot(at[1] - 104.0);
            (displacement, (now.at[0] - at[0]).hypot(now.at[1] - at[1]))
        };
        let all: Vec<(f64, f64)> = among.iter().map(moved).collect();
        assert!(
            all.iter()
                .filter(|(displacement, _)| *displacement > 3.0 * PITCH)
                .all(|(_, moved)| *moved < 0.1 * PITCH)
        );
        assert!(all.iter().any(|(displacement, moved)| *displacement < 1.5 * PITCH && *moved > 0.1 * PITCH));
    }
}
