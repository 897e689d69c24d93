//! The pieces of a maze: the direction that each place is to have.
//!
//! A region whose lines have one direction is one piece, so that a checkerboard of such regions is a basket weave. Elsewhere pieces
//! are the Voronoi cells of Poisson discs, as large as the drawn lines are long. A piece with drawn lines has their direction, and
//! other pieces take the directions that are rarest so far. The direction around a drawn line is always that of the line.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use crate::grid::Domain;
use crate::points::discs::poisson_discs;
use crate::points::extent::Extent;
use crate::points::metric::Metric;
use crate::points::voronoi::owners;
use crate::synth::pairs::grow::nearest_line::nearest_lines;
use crate::synth::pairs::plan::PairPlan;
use crate::synth::pairs::plan::thread_map::ThreadMap;

/// Radius of the discs ÷ the size of the pieces: Voronoi cells of discs of radius 1 have an area of 1.43.
const RADIUS: f64 = 0.83;
/// Places along a drawn line at which it is tested.
const SAMPLES: usize = 32;
/// Distance from a drawn line up to which its direction is kept, in distances of lines.
const BESIDE: f64 = 0.75;

/// The direction of each cell of the grid, as the index of a thread of `plan`.
pub(super) fn maze_pieces(plan: &PairPlan, seed: u64) -> Vec<u8> {
    let canvas = plan.canvas();
    let extent = Extent::from(canvas);
    let size = plan.length_of_pieces();
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    let points = poisson_discs(&extent, size, &|_| Metric::circle(RADIUS * size), &[], &mut rng);
    let pieces = owners(&points, &|_| Metric::circle(size), &extent, &plan.grid);
    let allowed = |at: [f64; 2]| -> Vec<usize> {
        let drawn_here = |threads: &ThreadMap| {
            let map = threads.map();
            map.is_free() || map.region(map.layout().region_of(at)).marks > 0
        };
        let here: Vec<usize> = (0..plan.threads.len()).filter(|of| drawn_here(&plan.threads[*of])).collect();
        if here.is_empty() { (0..plan.threads.len()).collect() } else { here }
    };
    let mut drawn = vec![vec![0usize; plan.threads.len()]; points.len()];
    for (direction, threads) in plan.threads.iter().enumerate() {
        for point in
            threads.lines.iter().flat_map(|(_, line)| line.samples(SAMPLES)).map(|sample| sample.point)
        {
            if extent.contains(point) {
                let cell = plan.grid.cell_at(plan.grid.to_cells(extent.folded(point)));
                drawn[pieces[cell] as usize][direction] += 1;
            }
        }
    }
    let mut used = vec![0usize; plan.threads.len()];
    let mut of_piece = vec![0usize; points.len()];
    let most_drawn = |votes: &[usize]| {
        let most = votes.iter().copied().max().filter(|most| *most > 0)?;
        votes.iter().position(|votes| *votes == most)
    };
    // Pieces with drawn lines first, so that the others balance them.
    for (piece, votes) in drawn.iter().enumerate() {
        if let Some(direction) = most_drawn(votes) {
            (of_piece[piece], used[direction]) = (direction, used[direction] + 1);
        }
    }
    for piece in (0..points.len()).filter(|piece| most_drawn(&drawn[*piece]).is_none()) {
        let choices = allowed(canvas.inside(points[piece]));
        let ranked = choices.into_iter().map(|direction| (used[direction], rng.random::<u32>(), direction));
        let direction = ranked.min().map_or(0, |(_, _, direction)| direction);
        (of_piece[piece], used[direction]) = (direction, used[direction] + 1);
    }
    let mut found: Vec<u8> = pieces
        .iter()
        .enumerate()
        .map(|(cell, piece)| {
            let (own, here) = (of_piece[*piece as usize], allowed(plan.grid.center_px(cell)));
            (if here.contains(&own) { own } else { here[0] }) as u8
        })
        .collect();
    for (found, line) in found.iter_mut().zip(nearest_lines(plan, BESIDE)) {
        if let Some(line) = line {
            *found = line.direction as u8;
        }
    }
    found
}
