//! Depth-first clusters that keep their direction: chains of points, each a ragged stripe (after the paper's figure 23).
//!
//! [`clusters()`](super::clusters()) backtrack where they find no free point, and so form clumps. Streaks do not backtrack.

use rand::Rng;

use super::clusters::shuffle;
use super::normal;
use crate::marks::turn;
use crate::points::delaunay::{Axis, Delaunay};

/// Standard deviation, degrees, of the noise added to the angles by which neighbours are sorted: .15 rad, the same as for clusters.
const JITTER: f64 = 8.6;
/// Largest angle, degrees, between a step of a chain and the direction: the neighbours of a point are 60° apart.
const WIDEST: f64 = 50.0;
/// Edges of less clearance are ignored, so that a chain is connected in the interpolated field too.
const CLEARANCE: f64 = 0.2;

/// Least number of points in a chain: shorter chains would be dots and stay light.
const LEAST: usize = 3;

/// The chain of each point, `None` for light points. Each chain has `size` points, or fewer if it finds no further one, and grows
/// from its start both ways along the `direction`, degrees, at each point. Then all its free neighbours are light. Where `size` is
/// 0 all points are light.
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

/// The free neighbour of a point with the least angle to the `direction`, degrees, or for `sign` −1 to its reverse.
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
