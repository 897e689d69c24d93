//! Depth-first clusters that keep going: chains of points along a direction, each a ragged stripe (after the paper's figure 23).
//!
//! [`clusters()`](super::clusters()) go back where they find no way on, and so make clumps. These do not go back.

use rand::Rng;

use super::clusters::shuffle;
use super::normal;
use crate::marks::turn;
use crate::points::delaunay::{Axis, Delaunay};

/// Standard deviation, degrees, of the turns by which neighbours are sorted: .15 rad, as for clusters.
const JITTER: f64 = 8.6;
/// A chain turns by no more than this from the direction, degrees: the next neighbours of a point are 60° apart.
const WIDEST: f64 = 50.0;
/// Edges of less clearance count as none, so that a chain is one in the interpolated field too.
const CLEARANCE: f64 = 0.2;

/// A chain of fewer points would be a dot: these stay light.
const LEAST: usize = 3;

/// The chain of each point, `None` for light ones: `size` points each, or as many as find a way on, from a start both ways along the
/// `direction` at each point, degrees; then all their free neighbours are light. Where `size` is 0 all are.
pub fn streaks(
    graph: &Delaunay,
    size: impl Fn([f64; 2]) -> usize,
    direction: impl Fn([f64; 2]) -> f64,
    rng: &mut impl Rng,
) -> Vec<Option<u32>> {
    let mut owner: Vec<Option<u32>> = vec![None; graph.points.len()];
    let sizes: Vec<usize> = graph.points.iter().map(|at| size(*at)).collect();
    let mut light: Vec<bool> = sizes.iter().map(|size| *size == 0).collect();
    let mut starts: Vec<usize> = (0..graph.points.len()).collect();
    shuffle(&mut starts, rng);
    let mut chain = 0;
    for start in starts {
        if light[start] || owner[start].is_some() {
            continue;
        }
        owner[start] = Some(chain);
        let mut taken = vec![start];
        for (sign, most) in [(1.0, sizes[start].div_ceil(2)), (-1.0, sizes[start])] {
            let mut at = start;
            while taken.len() < most {
                let is_free = |to: usize| owner[to].is_none() && !light[to];
                let Some(next) = ahead(graph, at, direction(graph.points[at]), sign, is_free, rng) else {
                    break;
                };
                owner[next] = Some(chain);
                taken.push(next);
                at = next;
            }
        }
        if taken.len() < LEAST.min(sizes[start]) {
            taken.into_iter().for_each(|point| owner[point] = None);
            light[start] = true;
            continue;
        }
        for point in taken {
            for other in graph.neighbours(point) {
                light[other] |= owner[other].is_none();
            }
        }
        chain += 1;
    }
    owner
}

/// The free neighbour of a point that turns least from the `direction`, degrees, or with `sign` −1 from its reverse.
fn ahead(
    graph: &Delaunay,
    point: usize,
    direction: f64,
    sign: f64,
    is_free: impl Fn(usize) -> bool,
    rng: &mut impl Rng,
) -> Option<usize> {
    let (s, c) = libm::sincos(direction.to_radians());
    let mut best: Option<(f64, usize)> = None;
    for Axis { displacement, to, clearance } in graph.axes(point) {
        let Some(to) = to.map(|to| to as usize).filter(|to| is_free(*to)) else { continue };
        let away = turn(libm::atan2(displacement[1], displacement[0]).to_degrees(), direction);
        let is_ahead = sign * (displacement[0] * c + displacement[1] * s) > 0.0 && away.abs() <= WIDEST;
        let key = (away + JITTER * normal(rng)).abs();
        if is_ahead && *clearance >= CLEARANCE && best.is_none_or(|(least, _)| key < least) {
            best = Some((key, to));
        }
    }
    best.map(|(_, to)| to)
}
