//! What is near a place of a surface: lists by cubes of space.

use std::collections::{HashMap, HashSet};
use std::ops::Range;

use rayon::prelude::*;

use crate::surface::Surface;
use crate::surface::vector::{Vector, dot, minus};

/// Half the diagonal of a cube ÷ its side.
const HALF_DIAGONAL: f64 = 0.866_03;

/// A box in space that something may reach: its middle, its axes of length 1, and half its sides along them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reached {
    pub middle: Vector,
    pub axes: [Vector; 3],
    pub halves: [f64; 3],
}

impl Reached {
    /// A ball.
    pub fn ball(middle: Vector, radius: f64) -> Self {
        Self { middle, axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], halves: [radius; 3] }
    }

    /// Half the side of the box around it along an axis of space.
    fn half(&self, axis: usize) -> f64 {
        (0..3).map(|own| self.axes[own][axis].abs() * self.halves[own]).sum()
    }

    /// Whether it may reach into a ball.
    fn meets(&self, middle: Vector, radius: f64) -> bool {
        let off = minus(middle, self.middle);
        (0..3).all(|own| dot(off, self.axes[own]).abs() <= self.halves[own] + radius)
    }
}

/// Lists of things by the cubes of space that hold a part of the surface.
#[derive(Clone, Debug)]
pub(super) struct Buckets {
    side: f64,
    cubes: HashMap<[i32; 3], Range<u32>>,
    /// The things of each cube, in their order.
    things: Vec<u32>,
}

type Cube = [i32; 3];

impl Buckets {
    /// Cubes of this side over a surface, and the things that reach into each.
    pub fn new(
        surface: &Surface,
        side: f64,
        reached: &(impl Fn(usize) -> Reached + Sync),
        count: usize,
    ) -> Self {
        let cubes = occupied(surface, side);
        let of_thing = |thing: usize| {
            let reached = reached(thing);
            let [low, high] = [-1.0, 1.0].map(|sign| {
                [0, 1, 2].map(|axis| cube_of(reached.middle[axis] + sign * reached.half(axis), side))
            });
            let all = each_cube(low, high).filter(|cube| cubes.contains(cube));
            let near: Vec<(Cube, u32)> = all
                .filter(|cube| {
                    let middle = cube.map(|at| (f64::from(at) + 0.5) * side);
                    reached.meets(middle, HALF_DIAGONAL * side)
                })
                .map(|cube| (cube, thing as u32))
                .collect();
            near
        };
        let mut entries: Vec<(Cube, u32)> = (0..count).into_par_iter().flat_map_iter(of_thing).collect();
        entries.par_sort_unstable();
        let mut ranges = HashMap::with_capacity(cubes.len());
        let mut first = 0;
        for run in entries.chunk_by(|a, b| a.0 == b.0) {
            let end = first + run.len() as u32;
            ranges.insert(run[0].0, first..end);
            first = end;
        }
        Self { side, cubes: ranges, things: entries.into_iter().map(|(_, thing)| thing).collect() }
    }

    /// The things that may reach a place of the surface.
    pub fn at(&self, place: Vector) -> &[u32] {
        let cube = place.map(|part| cube_of(part, self.side));
        self.cubes.get(&cube).map_or(&[], |range| &self.things[range.start as usize..range.end as usize])
    }
}

fn cube_of(part: f64, side: f64) -> i32 {
    (part / side).floor() as i32
}

fn each_cube(low: Cube, high: Cube) -> impl Iterator<Item = Cube> {
    (low[0]..=high[0])
        .flat_map(move |x| (low[1]..=high[1]).flat_map(move |y| (low[2]..=high[2]).map(move |z| [x, y, z])))
}

/// The cubes that hold a part of the surface.
fn occupied(surface: &Surface, side: f64) -> HashSet<Cube> {
    let mut cubes = HashSet::new();
    for face in 0..surface.mesh.faces.len() {
        let corners = surface.mesh.corners(face);
        let bound = |pick: fn(f64, f64) -> f64, off: f64| {
            [0, 1, 2].map(|axis| {
                let [a, b, c] = corners.map(|corner| corner[axis]);
                // A place is rounded.
                cube_of(pick(pick(a, b), c) + off, side)
            })
        };
        cubes.extend(each_cube(bound(f64::min, -1e-6), bound(f64::max, 1e-6)));
    }
    cubes
}
