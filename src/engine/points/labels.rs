//! Labels at points: dark or light, at random, by a picture, or by growing over the graph.

mod clusters;
mod connected;
mod groups;
mod round_robin;
mod space_giraffe;
mod streaks;

use rand::{Rng, RngExt};

use crate::grid::Field;

pub(crate) use clusters::shuffle;
pub use clusters::{Order, clusters};
pub use connected::{connected, net, net_along, ringed, sparse};
pub use groups::groups;
pub use round_robin::{Claim, bordered, round_robin};
pub use space_giraffe::{ray_points, space_giraffe};
pub use streaks::streaks;

/// Each of `points` is dark with the probability `dark` at its place: the cow of figure 11, the progressions of figure 17.
pub fn random(points: &[[f64; 2]], dark: impl Fn([f64; 2]) -> f64, rng: &mut impl Rng) -> Vec<bool> {
    points.iter().map(|at| rng.random::<f64>() < dark(*at)).collect()
}

/// Each of `points`, px of the canvas that `reference` covers, is dark with the value there as the probability: figures 13 and 14.
/// Beyond the border a point takes the value of the nearest place, or of its image.
pub fn by_reference(points: &[[f64; 2]], reference: &Field, rng: &mut impl Rng) -> Vec<bool> {
    let bounds = reference.grid().bounds_px();
    let cell = |at: [f64; 2], axis: usize| (at[axis] / reference.cell[axis]) as isize;
    let value = |at: [f64; 2]| {
        let at = bounds.inside(at);
        reference.get(
            cell(at, 0).min(reference.width as isize - 1),
            cell(at, 1).min(reference.height as isize - 1),
        )
    };
    random(points, |at| f64::from(value(at)), rng)
}

/// A standard normal number, by Box and Muller.
pub(crate) fn normal(rng: &mut impl Rng) -> f64 {
    // 1 − u is never 0.
    let radius = (-2.0 * libm::log(1.0 - rng.random::<f64>())).sqrt();
    radius * libm::cos(std::f64::consts::TAU * rng.random::<f64>())
}

#[cfg(test)]
mod tests;
