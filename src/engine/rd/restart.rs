//! Restarting single spots in a pattern that has grown.
//!
//! c′(x) = c(x) + w(x) (c₀(x) − c(x)), c₀ the initial conditions; w = 1 about the spots that begin again, 0 about the others

use crate::grid::{Domain, exp};
use crate::rd::System;
use crate::rd::local_warp::fading;
use crate::rd::nucleus::Nucleus;
use crate::rd::parameter_field::ParameterField;
use crate::rd::shepard::TAU;

/// Up to this distance from a spot, in pitches of the room that the spot needs, the concentrations are reset.
const INNER: f64 = 0.35;
/// From this distance on, in pitches, the concentrations do not change.
const OUTER: f64 = 0.6;

/// Puts the initial conditions back into the `chemicals` about the places `again`, cells. About the places `stay` nothing changes.
///
/// `afresh` gives the initial concentrations in some cells, one vector a chemical. It is given these cells, and a function that tells
/// whether any of them may be within a distance, cells, of a place.
pub fn restart(
    system: System,
    maps: &ParameterField,
    chemicals: &mut [Vec<f32>],
    [again, stay]: [&[[f64; 2]]; 2],
    afresh: impl FnOnce(&[usize], &dyn Fn([f64; 2], f64) -> bool) -> Vec<Vec<f32>>,
) {
    let domain = &maps.domain;
    let spot = |at: &[f64; 2]| {
        let p = maps.at(*at);
        Nucleus::new(&p, domain, domain.cell_at(*at), *at, system.spacing(&p)).alone()
    };
    let again: Vec<Nucleus> = again.iter().map(spot).collect();
    // Spots far from all restarted ones have no effect.
    let beside = |stays: &Nucleus| {
        again.iter().any(|begins| {
            let reach = OUTER * (begins.reach + stays.reach) + 1.0;
            domain.displacement(begins.at, stays.at).iter().all(|along| along.abs() <= reach)
        })
    };
    let stay: Vec<Nucleus> = stay.iter().map(spot).filter(beside).collect();
    let mut sums = vec![[0.0f64; 2]; domain.cells()];
    let mut begun = Vec::new();
    for (k, spot) in again.iter().chain(&stay).enumerate() {
        for (cell, delta) in domain.near(spot.at, OUTER * spot.reach, 0..domain.cells()) {
            let distance2 = spot.distance2(delta);
            let share = exp(-0.5 * distance2 / (TAU * TAU));
            let [begins, total] = &mut sums[cell];
            if k < again.len() {
                if *total == 0.0 {
                    begun.push(cell);
                }
                *begins += share * fading(distance2.sqrt(), [INNER, OUTER]);
            }
            *total += share;
        }
    }
    begun.retain(|cell| sums[*cell][0] > 0.0 && !maps.is_obstacle(*cell));
    let near = |at: [f64; 2], distance: f64| {
        again.iter().any(|begins| {
            let reach = OUTER * begins.reach + distance;
            domain.displacement(begins.at, at).iter().all(|along| along.abs() <= reach)
        })
    };
    for (chemical, afresh) in chemicals.iter_mut().zip(afresh(&begun, &near)) {
        for (cell, afresh) in begun.iter().zip(afresh) {
            let [begins, total] = sums[*cell];
            chemical[*cell] += (begins / total) as f32 * (afresh - chemical[*cell]);
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
        let maps = ParameterField::uniform([90, 40], Edges::Closed, p);
        let mut grown = vec![vec![1.0f32; 90 * 40]];
        let afresh = |cells: &[usize], near: &dyn Fn([f64; 2], f64) -> bool| {
            assert!(near([20.0, 20.0], 0.0) && !near([80.0, 20.0], 5.0));
            vec![vec![5.0; cells.len()]]
        };
        restart(System::MEINHARDT_SPOTS, &maps, &mut grown, [&[[20.0, 20.0]], &[[40.0, 20.0]]], afresh);
        let at = |x: usize| grown[0][20 * 90 + x];
        assert!((at(20) - 5.0).abs() < 0.05 && (at(40) - 1.0).abs() < 0.05, "{} {}", at(20), at(40));
        assert!((20..40).all(|x| at(x) >= at(x + 1)) && at(80) == 1.0);
    }
}
