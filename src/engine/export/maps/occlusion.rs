//! Height → ambient occlusion: the share of the sky that is visible from each px.
//!
//! ```text
//! A = 1 − 1/N Σ_θ Σ_d W(d)·(sin h(d) − sin h(d′)),  W(d) = 1 − (d/R)²
//! ```
//!
//! summed over N directions θ and the distances d at which the horizon h rises above its value at the nearer distance d′. The
//! horizon starts at the tangent of the surface, so a slope does not occlude itself. tan h = (height at d − height here)/d.
//!
//! L. Bavoil, M. Sainz, R. Dimitrov, "Image-Space Horizon-Based Ambient Occlusion", SIGGRAPH Talks 2008.

use rayon::prelude::*;

use super::Height;

/// Number of directions. Doubling it changes no 8-bit value of the examples by more than 2.
const DIRECTIONS: usize = 16;
/// Ratio of successive distances, from 1 px on.
const DISTANCE_RATIO: f64 = 1.35;

/// A sample of a ray: its offset in values, its direction and its distance, px. It is the centre of a px, so its direction is only
/// approximately the direction of the ray.
struct Sample {
    offset: isize,
    direction: [f32; 2],
    distance: f32,
    weight: f32,
}

/// The share of the sky that is visible from each px, 0..1: 1 = the whole sky. The margin must be at least `radius` px, and
/// `radius` at least 1. Rows that are not computed because of a cancellation are 0.
#[must_use]
pub fn openness(height: &Height, radius: usize, cancelled: &(dyn Fn() -> bool + Sync)) -> Vec<f32> {
    let rays = rays(radius.max(1), height.stride() as isize);
    let mut open = vec![0.0; height.width * height.rows];
    open.par_chunks_mut(height.width.max(1)).enumerate().for_each(|(y, row)| {
        // A band with a large radius takes seconds.
        if cancelled() {
            return;
        }
        let start = height.start(y);
        for (x, open) in row.iter_mut().enumerate() {
            *open = at(&height.values, start + x, &rays, height.stride());
        }
    });
    open
}

fn at(h: &[f32], here: usize, rays: &[Vec<Sample>], stride: usize) -> f32 {
    let slope = [(h[here + 1] - h[here - 1]) / 2.0, (h[here + stride] - h[here - stride]) / 2.0];
    let mut covered = 0.0;
    for samples in rays {
        // Above the tangent.
        let mut horizon = 0.0;
        for Sample { offset, direction, distance, weight } in samples {
            let tangent = sine(direction[0] * slope[0] + direction[1] * slope[1]);
            let above = sine((h[here.wrapping_add_signed(*offset)] - h[here]) / distance) - tangent;
            if above > horizon {
                covered += weight * (above - horizon);
                horizon = above;
            }
        }
    }
    (1.0 - covered / rays.len() as f32).clamp(0.0, 1.0)
}

/// sin(arctan t).
fn sine(tangent: f32) -> f32 {
    tangent / (1.0 + tangent * tangent).sqrt()
}

/// The samples of each direction.
fn rays(radius: usize, stride: isize) -> Vec<Vec<Sample>> {
    let direction = |k: usize| {
        let angle = std::f64::consts::TAU * (k as f64 + 0.5) / DIRECTIONS as f64;
        let ray = [libm::cos(angle), libm::sin(angle)];
        let mut samples: Vec<Sample> = Vec::new();
        let mut far = 1.0;
        while far <= radius as f64 {
            let [dx, dy] = ray.map(|part| (far * part).round());
            let distance = (dx * dx + dy * dy).sqrt();
            let offset = dy as isize * stride + dx as isize;
            let nearer = samples.last().map_or(0.0, |sample| f64::from(sample.distance));
            if distance > nearer && distance <= radius as f64 {
                let share = distance / (radius + 1) as f64;
                let (direction, distance) =
                    ([dx / distance, dy / distance].map(|part| part as f32), distance as f32);
                samples.push(Sample { offset, direction, distance, weight: (1.0 - share * share) as f32 });
            }
            far = (far * DISTANCE_RATIO).max(far + 1.0);
        }
        samples
    };
    (0..DIRECTIONS).map(direction).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Edges, Field};
    use std::sync::atomic::{AtomicUsize, Ordering};

    fn open(f: impl Fn(f64, f64) -> f64, edges: Edges, radius: usize) -> Vec<f32> {
        let field = Field::from_fn([48, 40], [1.0; 2], edges, |[x, y]| f(x, y) as f32);
        openness(&Height::from_field(&field, radius), radius, &|| false)
    }

    #[test]
    fn no_row_begins_after_it_is_cancelled() {
        let rows = AtomicUsize::new(0);
        let field = Field::from_fn([48, 40], [1.0; 2], Edges::Wrap, |_| 0.0);
        let cancelled = || rows.fetch_add(1, Ordering::Relaxed) >= 5;
        let open = openness(&Height::from_field(&field, 3), 3, &cancelled);
        assert_eq!(open.iter().filter(|open| **open > 0.0).count(), 5 * 48);
    }

    #[test]
    fn flat_ground_and_an_even_slope_are_not_occluded() {
        assert!(open(|_, _| 7.0, Edges::Wrap, 12).iter().all(|open| *open == 1.0));
        let slope = open(|x, y| 0.6 * x - 1.3 * y, Edges::Closed, 6);
        assert!((slope[20 * 48 + 24] - 1.0).abs() < 1e-5);
    }

    #[test]
    fn the_occlusion_of_a_tile_does_not_depend_on_where_it_is_cut() {
        use std::f64::consts::TAU;
        let wave =
            |x: f64, y: f64| 3.0 * (TAU * x / 16.0).sin() * (TAU * y / 20.0).cos() + (TAU * x / 48.0).cos();
        let moved = |x: f64, y: f64| wave(x + 5.0, y + 7.0);
        let (one, moved) = (open(wave, Edges::Wrap, 12), open(moved, Edges::Wrap, 12));
        for (i, open) in moved.iter().enumerate() {
            let there = one[(i / 48 + 7) % 40 * 48 + (i % 48 + 5) % 48];
            assert!((open - there).abs() < 1e-4, "{open} {there}");
        }
    }

    #[test]
    fn the_foot_of_a_wall_has_the_exact_occlusion() {
        // A wall of height 8 begins at x = 30; 4 px before it, radius 20.
        let open = open(|x, _| if x > 30.0 { 8.0 } else { 0.0 }, Edges::Closed, 20);
        let found = open[20 * 48 + 25];
        // The same with steps of 1/100 px and 1/1000 of a full circle.
        let mut covered = 0.0;
        for k in 0..1000 {
            let toward = (std::f64::consts::TAU * (f64::from(k) + 0.5) / 1000.0).cos();
            let distance = 5.0 / toward;
            if toward > 0.0 && distance <= 20.0 {
                covered += (1.0 - (distance / 21.0).powi(2)) * (8.0 / distance).atan().sin() / 1000.0;
            }
        }
        assert!((f64::from(found) - (1.0 - covered)).abs() < 0.03, "{found} {}", 1.0 - covered);
        assert_eq!(open[20 * 48 + 5], 1.0);
    }

    #[test]
    fn a_pit_is_darker_than_its_rim_and_a_dome_no_darker_than_its_foot() {
        let bump = |x: f64, y: f64| (-((x - 24.0).powi(2) + (y - 20.0).powi(2)) / 30.0).exp();
        let [pit, dome] = [-9.0, 9.0].map(|high| open(|x, y| high * bump(x, y), Edges::Wrap, 16));
        let [center, foot] = [20 * 48 + 24, 20 * 48 + 33];
        assert!(pit[center] < 0.6 && pit[center] < pit[foot] - 0.2, "{} {}", pit[center], pit[foot]);
        assert!(dome[center] > 0.99 && dome[foot] < 0.95, "{} {}", dome[center], dome[foot]);
    }
}
