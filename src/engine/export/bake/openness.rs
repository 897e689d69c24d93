//! Ambient occlusion of a surface with a relief: how much of the sky each vertex sees.
//!
//! ```text
//! A = 1 − 1/N Σ_θ Σ_d W(d)·(sin h(d) − sin h(d′)),  W(d) = 1 − (d/R)²
//! ```
//!
//! over N sectors θ around a vertex and the vertices at distances d in them, at which the horizon h rises above its value at the
//! nearer d′; h is counted from the plane of the relief at the vertex, so that a slope does not occlude itself. On the plane this is
//! what [`crate::export::maps::openness`] computes for pictures.

use std::f64::consts::TAU;

use rayon::prelude::*;

use crate::export::body::curved::slopes;
use crate::export::body::vector::{Vector, cross, dot, minus, plus, unit};
use crate::surface::Surface;

/// Sectors around a vertex.
const SECTORS: usize = 12;

/// How much of the sky each vertex of a surface with these heights sees, 0..1: 1 = the whole sky. Vertices farther than `radius`, in
/// units of the surface, hide nothing.
#[must_use]
pub fn openness(surface: &Surface, heights: &[f32], radius: f64) -> Vec<f32> {
    let steepness = slopes(&surface.mesh, heights);
    let raised: Vec<Vector> = surface
        .mesh
        .positions
        .iter()
        .zip(heights)
        .enumerate()
        .map(|(vertex, (at, height))| plus(*at, f64::from(*height), surface.normal(vertex)))
        .collect();
    let count = raised.len();
    let of_vertex = |(stamps, around): &mut (Vec<u32>, Vec<(f64, u32)>), vertex: usize| {
        near(surface, vertex, radius, stamps, around);
        let normal = unit(minus(surface.normal(vertex), steepness[vertex]));
        let right = unit(cross(normal, crate::surface::vector::axis_beside(normal)));
        let up = cross(normal, right);
        let mut horizon = [0.0_f64; SECTORS];
        let mut covered = 0.0;
        for (square, other) in around.iter() {
            let to = minus(raised[*other as usize], raised[vertex]);
            let length = dot(to, to).sqrt();
            let sine = dot(to, normal) / length.max(f64::MIN_POSITIVE);
            let turn = libm::atan2(dot(to, up), dot(to, right)) / TAU + 0.5;
            let highest = &mut horizon[((turn * SECTORS as f64) as usize).min(SECTORS - 1)];
            if sine > *highest {
                covered += (1.0 - square / (radius * radius)) * (sine - *highest);
                *highest = sine;
            }
        }
        (1.0 - covered / SECTORS as f64).clamp(0.0, 1.0) as f32
    };
    (0..count).into_par_iter().map_init(|| (vec![u32::MAX; count], Vec::new()), of_vertex).collect()
}

/// The vertices that are joined to a vertex by others not farther than `radius`, with their squared distances; the nearest first.
fn near(surface: &Surface, vertex: usize, radius: f64, stamps: &mut [u32], around: &mut Vec<(f64, u32)>) {
    around.clear();
    around.push((0.0, vertex as u32));
    stamps[vertex] = vertex as u32;
    let mut next = 0;
    while let Some((_, at)) = around.get(next).copied() {
        next += 1;
        for other in surface.ring(at as usize) {
            if stamps[other] == vertex as u32 {
                continue;
            }
            stamps[other] = vertex as u32;
            let off = minus(surface.mesh.positions[other], surface.mesh.positions[vertex]);
            if dot(off, off) <= radius * radius {
                around.push((dot(off, off), other as u32));
            }
        }
    }
    around.swap_remove(0);
    around.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export::maps::{Height, openness as flat_openness};
    use crate::grid::{Edges, Field};
    use crate::surface::test_meshes::{even_plate, sphere};

    fn hill([x, y]: [f64; 2]) -> f32 {
        (6.0 * libm::exp(-((x - 50.0) * (x - 50.0) + (y - 50.0) * (y - 50.0)) / 60.0)) as f32
    }

    #[test]
    fn a_hill_on_a_plate_shades_its_foot_as_in_a_flat_picture() {
        let surface = Surface::new(even_plate([100.0; 2], 2.0), [1.0, 0.0, 0.0]);
        let heights: Vec<f32> = surface.mesh.positions.iter().map(|[x, y, _]| hill([*x, *y])).collect();
        let found = openness(&surface, &heights, 24.0);
        let field = Field::from_fn([100, 100], [1.0; 2], Edges::Closed, hill);
        let flat = flat_openness(&Height::from_field(&field, 24), 24, &|| false);
        let mut darkest = 1.0_f32;
        for (open, [x, y, _]) in found.iter().zip(&surface.mesh.positions) {
            if [x, y].iter().all(|at| (30.0..70.0).contains(*at)) {
                let there = flat[*y as usize * 100 + *x as usize];
                assert!((open - there).abs() < 0.06, "{x} {y}: {open} {there}");
                darkest = darkest.min(*open);
            }
        }
        assert!(darkest < 0.9, "{darkest}");
    }

    #[test]
    fn a_smooth_ball_is_open_everywhere() {
        let surface = Surface::new(sphere(8, 50.0), [1.0, 0.0, 0.0]);
        let open = openness(&surface, &vec![0.0; surface.mesh.positions.len()], 20.0);
        assert!(open.iter().all(|open| *open == 1.0));
    }
}
