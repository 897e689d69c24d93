//! Where spots begin on a surface: laid by repulsion on the coarse mesh that the fine one was made from. It has a quarter of the vertices, six a
//! spacing; all spots laid so have lived (the animal in four triangulations with five seeds each, 3,000 spots on a sphere).

use rayon::prelude::*;

use crate::grid::Domain;
use crate::rd::{ParameterField, Parameters, PinnedSpot, Places, System, nuclei};
use crate::surface::{Surface, SurfacePoint};
use crate::synth::body::given_directions::degrees;

/// What is nearer than this to an obstacle, in pitches, counts as one: the cells of the coarse mesh are large. Without this one of 159
/// spots beside large ones did not live.
const BESIDE: f64 = 0.1;

/// Places of spots on the surface of `maps`, laid on a `coarse` mesh of the same model: the `pinned` ones first, then others around
/// them and beside obstacles.
#[must_use]
pub fn lay(
    maps: &ParameterField<Surface>,
    system: System,
    coarse: &Surface,
    seed: u64,
    pinned: &[PinnedSpot<SurfacePoint>],
) -> Places<SurfacePoint> {
    let fine = &maps.domain;
    let longer = coarse.unit() / fine.unit();
    let on_coarse =
        |at: SurfacePoint| coarse.closest_facing(fine.position(at), fine.normal(fine.vertex_of(at)));
    // The same lengths are fewer of the longer cells, and the same direction has another angle in another frame.
    let carried = |own: usize, place: SurfacePoint, p: Parameters| {
        let [x, y] = fine.frame(own);
        let (sin, cos) = libm::sincos(f64::from(p.direction).to_radians());
        let long_axis = std::array::from_fn(|i| cos * x[i] + sin * y[i]);
        let direction = degrees(coarse, place, long_axis).unwrap_or_default() as f32;
        Parameters { rate: p.rate * (longer * longer) as f32, direction, ..p }
    };
    let nearest = |vertex: usize| {
        let (place, normal) = (coarse.place_of(vertex), coarse.normal(vertex));
        fine.vertex_of(fine.closest_facing(coarse.position(place), normal))
    };
    let own: Vec<usize> = (0..coarse.mesh.positions.len()).into_par_iter().map(nearest).collect();
    let at = |(vertex, own): (usize, &usize)| carried(*own, coarse.place_of(vertex), maps.parameters[*own]);
    let parameters = own.par_iter().enumerate().map(at).collect();
    let away = if maps.obstacles.is_empty() { None } else { fine.distances(&maps.obstacles) };
    let is_taken = |away: &[f64]| {
        let is_near = |own: &usize| away[*own] <= BESIDE * system.spacing(&maps.parameters[*own]);
        own.iter().map(is_near).collect()
    };
    let obstacles: Vec<bool> = away.as_deref().map_or_else(Vec::new, is_taken);
    let pinned: Vec<PinnedSpot<SurfacePoint>> = pinned
        .iter()
        .map(|spot| {
            let at = on_coarse(spot.at);
            PinnedSpot { at, own: carried(fine.vertex_of(spot.at), at, spot.own), near: spot.near }
        })
        .collect();
    let laid_on = ParameterField { obstacles, ..ParameterField::new(coarse.clone(), parameters) };
    let places = nuclei(system, &laid_on, seed, &pinned);
    let on_fine = |place: &SurfacePoint| {
        fine.closest_facing(coarse.position(*place), coarse.normal(coarse.vertex_of(*place)))
    };
    Places {
        inside: places.inside.iter().map(on_fine).collect(),
        beyond: places.beyond.iter().map(on_fine).collect(),
        pinned: places.pinned,
    }
}
