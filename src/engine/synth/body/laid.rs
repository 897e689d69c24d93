//! Where spots begin on a surface: laid by repulsion on the coarse mesh that the fine one was made from. It has a quarter of the vertices, six a
//! spacing; all spots laid so have lived (the animal in four triangulations with five seeds each, 3,000 spots on a sphere).

use rayon::prelude::*;

use crate::rd::{ParameterField, Parameters, nuclei};
use crate::surface::{Surface, SurfacePoint};
use crate::synth::body::plan::degrees;
use crate::synth::body::refusals::system;

/// Places of spots on the surface of `maps`, laid on a `coarse` mesh of the same model.
#[must_use]
pub fn lay(maps: &ParameterField<Surface>, coarse: Surface, seed: u64) -> Vec<SurfacePoint> {
    let fine = &maps.domain;
    let longer = coarse.unit() / fine.unit();
    let at = |vertex: usize| {
        let (place, normal) = (coarse.place_of(vertex), coarse.normal(vertex));
        let own = fine.vertex_of(fine.closest_facing(coarse.position(place), normal));
        let p = maps.parameters[own];
        let [x, y] = fine.frame(own);
        let (sin, cos) = libm::sincos(f64::from(p.direction).to_radians());
        let long_axis = std::array::from_fn(|i| cos * x[i] + sin * y[i]);
        let direction = degrees(&coarse, place, long_axis).unwrap_or_default() as f32;
        // The same lengths are fewer of the longer cells.
        Parameters { rate: p.rate * (longer * longer) as f32, direction, ..p }
    };
    let parameters = (0..coarse.mesh.positions.len()).into_par_iter().map(at).collect();
    let maps = ParameterField::new(coarse, parameters);
    let places = nuclei(system(), &maps, seed, &[]).inside;
    let coarse = &maps.domain;
    let carried = |place: &SurfacePoint| {
        fine.closest_facing(coarse.position(*place), coarse.normal(coarse.vertex_of(*place)))
    };
    places.iter().map(carried).collect()
}
