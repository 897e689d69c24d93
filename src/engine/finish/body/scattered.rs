//! Places scattered over a surface: even in the mean, or not nearer to each other than a distance.

use std::collections::HashMap;

use crate::finish::noise::{Random, mixed};
use crate::surface::vector::{Vector, dot, length};
use crate::surface::{Surface, SurfacePoint};

/// Candidates for each place that is taken.
const CANDIDATES: f64 = 14.0;

/// Random places, one for each `area` px² in the mean. One lies in each piece of this area in the order of the triangles, which are
/// near each other in space where they are so in this order: places are more even than independent ones.
pub(super) fn scattered(surface: &Surface, area: f64, seed: u32) -> Vec<SurfacePoint> {
    let of_face = |face: usize| 0.5 * length(surface.mesh.area_vector(face));
    let whole: f64 = (0..surface.mesh.faces.len()).map(of_face).sum();
    let count = (whole / area).round().max(1.0) as u32;
    let (mut face, mut passed) = (0, 0.0);
    let mut places = Vec::with_capacity(count as usize);
    for index in 0..count {
        let mut random = Random::of(seed, [index, 0]);
        let wanted = (f64::from(index) + f64::from(random.number())) * whole / f64::from(count);
        while passed + of_face(face) < wanted && face + 1 < surface.mesh.faces.len() {
            passed += of_face(face);
            face += 1;
        }
        let root = f64::from(random.number()).sqrt();
        let second = root * f64::from(random.number());
        places.push(SurfacePoint { face: face as u32, weights: [1.0 - root, root - second] });
    }
    places
}

/// Random places of a surface that are not nearer to each other than `least`, as `far` measures the way between two places; one for
/// each `area` px², or fewer if there is no room.
///
/// Darts (R. L. Cook, "Stochastic sampling in computer graphics", ACM Trans. Graphics 5, 1986): without an `area` they cover about
/// .55 of a plane by discs of half this distance, one for each 1.44·least².
pub(super) fn apart(
    surface: &Surface,
    area: f64,
    least: f64,
    seed: u32,
    far: impl Fn(SurfacePoint, Vector) -> f64,
) -> Vec<SurfacePoint> {
    let mut candidates: Vec<(u32, SurfacePoint)> = scattered(surface, area / CANDIDATES, seed)
        .into_iter()
        .enumerate()
        .map(|(index, place)| (mixed(seed ^ mixed(index as u32)), place))
        .collect();
    let most = (candidates.len() as f64 / CANDIDATES).ceil() as usize;
    // Equal hashes keep their order.
    candidates.sort_by_key(|(hash, _)| *hash);
    let mut taken: Vec<SurfacePoint> = Vec::new();
    let mut cells: HashMap<[i64; 3], Vec<(Vector, Vector)>> = HashMap::new();
    for (_, place) in candidates {
        if taken.len() >= most {
            break;
        }
        let (at, normal) = (surface.position(place), surface.mesh.area_vector(place.face as usize));
        let cell = at.map(|part| (part / least).floor() as i64);
        let is_near = |(other, outwards): &(Vector, Vector)| {
            let way = [0, 1, 2].map(|axis| other[axis] - at[axis]);
            dot(*outwards, normal) > 0.0 && far(place, way) < least
        };
        let around = (0..27)
            .filter_map(|k| cells.get(&[cell[0] + k % 3 - 1, cell[1] + k / 3 % 3 - 1, cell[2] + k / 9 - 1]));
        if around.flatten().any(is_near) {
            continue;
        }
        cells.entry(cell).or_default().push((at, normal));
        taken.push(place);
    }
    taken
}
