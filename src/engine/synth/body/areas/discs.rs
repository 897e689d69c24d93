//! Poisson discs on a surface: vertices in random order, none in the disc of another, until no vertex is left outside of all.

use rand_pcg::Pcg64Mcg;

use crate::grid::Domain;
use crate::points::labels::shuffle;
use crate::surface::{Surface, SurfacePoint};

/// The places of discs with the radius `radius`, px, of each vertex. The `first` places are kept, whatever their distances.
#[must_use]
pub fn poisson_discs(
    surface: &Surface,
    radius: &dyn Fn(usize) -> f64,
    first: &[SurfacePoint],
    rng: &mut Pcg64Mcg,
) -> Vec<SurfacePoint> {
    let vertices = surface.cells();
    let mut is_covered = vec![false; vertices];
    let cover = |place: SurfacePoint, is_covered: &mut [bool]| {
        let reach = radius(surface.vertex_of(place)) / surface.unit();
        surface.near(place, reach, 0..vertices).for_each(|(vertex, _)| is_covered[vertex] = true);
    };
    let mut places = first.to_vec();
    first.iter().for_each(|place| cover(*place, &mut is_covered));
    let mut order: Vec<usize> = (0..vertices).collect();
    shuffle(&mut order, rng);
    for vertex in order {
        if !is_covered[vertex] {
            let place = surface.place_of(vertex);
            cover(place, &mut is_covered);
            places.push(place);
        }
    }
    places
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::points::discs::POINTS_A_SQUARE;
    use crate::surface::test_meshes::sphere;
    use rand::SeedableRng;

    #[test]
    fn no_disc_holds_the_centre_of_another_and_no_room_is_left() {
        let surface = Surface::new(sphere(36, 30.0), [1.0, 0.0, 0.0]);
        let first = [surface.closest([0.0, 30.0, 0.0])];
        let radius = |_| 5.0;
        let places = poisson_discs(&surface, &radius, &first, &mut Pcg64Mcg::seed_from_u64(2));
        assert_eq!(places[0], first[0]);
        let at: Vec<[f64; 3]> = places.iter().map(|place| surface.position(*place)).collect();
        let apart =
            |a: &[f64; 3], b: &[f64; 3]| (0..3).map(|i| (a[i] - b[i]) * (a[i] - b[i])).sum::<f64>().sqrt();
        let nearest = |i: usize| {
            let others = at.iter().enumerate().filter(|(j, _)| *j != i);
            others.map(|(_, other)| apart(&at[i], other)).fold(f64::INFINITY, f64::min)
        };
        let least = (0..at.len()).map(nearest).fold(f64::INFINITY, f64::min);
        let wanted = POINTS_A_SQUARE * surface.mesh.area() / 25.0;
        assert!(least > 4.7, "{least}");
        assert!((at.len() as f64 / wanted - 1.0).abs() < 0.12, "{} of {wanted}", at.len());
    }
}
