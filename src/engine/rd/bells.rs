//! Initial spots: bells on their nuclei.

use rayon::prelude::*;

use super::nucleus::Nucleus;
use super::parameter_field::{ParameterField, Parameters};
use crate::grid::{Domain, exp};

/// Distance from a nucleus, cells, beyond which a bell is less than 2·10⁻⁷ of its peak; `radius` in pitches.
#[must_use]
pub fn bell_reach<P>(nucleus: &Nucleus<P>, radius: f64) -> f64 {
    3.5 * radius * nucleus.reach
}

/// For each cell 1 at the centre of an initial spot, falling to 0 away from it as a Gaussian in its metric.
#[must_use]
pub fn bells<D: Domain>(
    maps: &ParameterField<D>,
    nuclei: &[Nucleus<D::Place>],
    radius: &(dyn Fn(&Parameters) -> f64 + Sync),
) -> Vec<f32> {
    let radii: Vec<f64> = nuclei.iter().map(|nucleus| radius(&maps.at(nucleus.at))).collect();
    let mut bell = vec![0.0f32; maps.domain.cells()];
    let part = maps.domain.part();
    bell.par_chunks_mut(part).enumerate().for_each(|(index, bell)| {
        let first = index * part;
        for (nucleus, radius) in nuclei.iter().zip(&radii) {
            let (far, cells) = (bell_reach(nucleus, *radius), first..first + bell.len());
            if !maps.domain.may_reach(nucleus.at, far, &cells) {
                continue;
            }
            maps.domain.near(nucleus.at, far, cells).for_each(|(cell, delta)| {
                let exponent = -0.5 * nucleus.distance2(delta) / (radius * radius);
                // Farther out the bell is less than 2·10⁻⁷ of its peak: a ten-thousandth of the ground.
                if exponent > -16.0 {
                    let cell = &mut bell[cell - first];
                    *cell = cell.max(exp(exponent) as f32);
                }
            });
        }
    });
    bell
}
