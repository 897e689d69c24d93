//! Beginning single spots again in a pattern that has grown.
//!
//! c′(x) = c(x) + w(x) (c₀(x) − c(x)), c₀ the initial conditions; w = 1 about the spots that begin again, 0 about the others

use crate::grid::{Domain, exp};
use crate::rd::System;
use crate::rd::local_warp::fading;
use crate::rd::maps::Maps;
use crate::rd::nucleus::Nucleus;
use crate::rd::shepard::TAU;

/// Up to this distance from a spot, pitches of the room that it needs itself, all is as it began.
const INNER: f64 = 0.35;
/// From here on all stays as it has grown.
const OUTER: f64 = 0.6;

/// Puts the initial conditions `afresh` back into the `chemicals` about the places `again`, cells. About the places `stay`
/// nothing changes.
pub fn restart(
    system: System,
    maps: &Maps,
    chemicals: &mut [Vec<f32>],
    afresh: &[Vec<f32>],
    [again, stay]: [&[[f64; 2]]; 2],
) {
    let mut sums = vec![[0.0f64; 2]; maps.domain.cells()];
    let mut add = |at: [f64; 2], begins: bool| {
        let p = maps.at(at);
        let spot = Nucleus::new(&p, &maps.domain, maps.domain.cell_at(at), at, system.spacing(&p)).alone();
        for (cell, delta) in maps.domain.near(at, OUTER * spot.reach, 0..maps.domain.cells()) {
            let distance2 = spot.distance2(delta);
            let share = exp(-0.5 * distance2 / (TAU * TAU));
            if begins {
                sums[cell][0] += share * fading(distance2.sqrt(), [INNER, OUTER]);
            }
            sums[cell][1] += share;
        }
    };
    again.iter().for_each(|at| add(*at, true));
    stay.iter().for_each(|at| add(*at, false));
    for (chemical, afresh) in chemicals.iter_mut().zip(afresh) {
        for ((value, afresh), [begins, total]) in chemical.iter_mut().zip(afresh).zip(&sums) {
            if *begins > 0.0 {
                *value += (begins / total) as f32 * (afresh - *value);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;
    use crate::rd::Parameters;

    #[test]
    fn one_spot_begins_again_and_its_neighbour_stays_as_it_has_grown() {
        let p = Parameters { rate: 3.0, ratio: 20.0, stretch: 1.0, direction: 0.0, pitch: 1.0 };
        let maps = Maps::uniform([90, 40], Edges::Closed, p);
        let mut grown = vec![vec![1.0f32; 90 * 40]];
        let afresh = vec![vec![5.0f32; 90 * 40]];
        restart(System::MEINHARDT_SPOTS, &maps, &mut grown, &afresh, [&[[20.0, 20.0]], &[[40.0, 20.0]]]);
        let at = |x: usize| grown[0][20 * 90 + x];
        assert!((at(20) - 5.0).abs() < 0.05 && (at(40) - 1.0).abs() < 0.05, "{} {}", at(20), at(40));
        assert!((20..40).all(|x| at(x) >= at(x + 1)) && at(80) == 1.0);
    }
}
