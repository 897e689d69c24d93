//! Stripes on a triangle surface: width and wavelength from areas and contour lengths, directions from the structure tensor, as
//! [`crate::measure::stripes()`] has them on a canvas.

use rayon::prelude::*;

use crate::grid::{Domain, atan2};
use crate::measure::surface_spots::level_set::LevelSet;
use crate::surface::Surface;

/// What is measured of stripes about some places of a surface.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SurfaceStripes {
    /// Area of the surface, in squared lengths of the surface.
    pub surface: f64,
    /// Area above the threshold.
    pub area: f64,
    /// Length of the contour.
    pub contour: f64,
}

impl SurfaceStripes {
    /// Mean width: 2 × area ÷ contour length; `None` without a contour.
    #[must_use]
    pub fn width(&self) -> Option<f64> {
        (self.contour > 0.0).then(|| 2.0 * self.area / self.contour)
    }

    /// Mean wavelength: 2 × surface area ÷ contour length; `None` without a contour.
    #[must_use]
    pub fn wavelength(&self) -> Option<f64> {
        (self.contour > 0.0).then(|| 2.0 * self.surface / self.contour)
    }
}

/// Areas and contour lengths of what lies above `threshold` in `values`, both by vertex, in each of `groups` groups of vertices. A face
/// belongs to the group of its first corner; one of group [`usize::MAX`] counts nowhere.
#[must_use]
pub fn surface_stripes(
    surface: &Surface,
    values: &[f32],
    threshold: f32,
    groups: usize,
    group_of: &(dyn Fn(usize) -> usize + Sync),
) -> Vec<SurfaceStripes> {
    let above: Vec<f64> = values.iter().map(|value| f64::from(*value) - f64::from(threshold)).collect();
    let level_set = LevelSet::new(surface, &above);
    let of_face = |face: usize| {
        let [x, y, z] = surface.mesh.area_vector(face);
        let whole = 0.5 * (x * x + y * y + z * z).sqrt();
        let corners = surface.mesh.faces[face].map(|vertex| above[vertex as usize] > 0.0);
        let mut found = SurfaceStripes { surface: whole, ..SurfaceStripes::default() };
        if corners == [true; 3] {
            found.area = whole;
        } else if corners != [false; 3] {
            let (pieces, contour) = level_set.pieces_and_contour(surface, face);
            found.area = pieces.iter().map(|piece| piece.area).sum();
            found.contour = contour;
        }
        found
    };
    let faces: Vec<SurfaceStripes> = (0..surface.mesh.faces.len()).into_par_iter().map(of_face).collect();
    let mut sums = vec![SurfaceStripes::default(); groups];
    for (face, found) in surface.mesh.faces.iter().zip(faces) {
        if let Some(sum) = sums.get_mut(group_of(face[0] as usize)) {
            sum.surface += found.surface;
            sum.area += found.area;
            sum.contour += found.contour;
        }
    }
    sums
}

/// How the stripes run at a vertex.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SurfaceDirection {
    /// Along the stripes, degrees in the frame of the vertex, 0..180.
    pub degrees: f64,
    /// Whether the place has one clear direction, 0..1.
    pub coherence: f64,
    /// Its weight in means: coherence times the squared slope.
    pub weight: f64,
}

/// Rounds of averaging at most, which reach 15 edges far. Not tuned: it limits the time for wide stripes on fine meshes.
const MOST: usize = 400;

/// Directions of the stripes of `values` at each vertex, averaged over about `radius`, in lengths of the surface.
#[must_use]
pub fn surface_directions(surface: &Surface, values: &[f32], radius: f64) -> Vec<SurfaceDirection> {
    // The structure tensor as its trace and its part of double angle.
    let mut tensors: Vec<[f64; 3]> =
        (0..values.len()).into_par_iter().map(|vertex| tensor(surface, values, vertex)).collect();
    let turns: Vec<Vec<(u32, [f64; 2])>> = (0..values.len())
        .into_par_iter()
        .map(|vertex| {
            let turned = |other: usize| {
                let (sin, cos) = libm::sincos(2.0 * surface.transport_angle(other, vertex).to_radians());
                (other as u32, [cos, sin])
            };
            surface.ring(vertex).map(turned).collect()
        })
        .collect();
    // A round moves a value by a variance of about half a squared edge; an edge is about 1.07 units long.
    let rounds = (2.0 * (radius / surface.unit()) * (radius / surface.unit()) / 1.15).ceil() as usize;
    for _ in 0..rounds.clamp(1, MOST) {
        let mean = |vertex: usize| {
            let [mut all, mut x, mut y] = tensors[vertex];
            let ring = &turns[vertex];
            let share = 1.0 / ring.len().max(1) as f64;
            for (other, [cos, sin]) in ring {
                let [trace, c, s] = tensors[*other as usize];
                all += share * trace;
                x += share * (cos * c - sin * s);
                y += share * (sin * c + cos * s);
            }
            [0.5 * all, 0.5 * x, 0.5 * y]
        };
        tensors = (0..tensors.len()).into_par_iter().map(mean).collect();
    }
    let direction = |[trace, x, y]: &[f64; 3]| {
        let size = (x * x + y * y).sqrt();
        let coherence = if *trace > 0.0 { (size / trace).min(1.0) } else { 0.0 };
        let across = 0.5 * atan2(*y, *x).to_degrees();
        SurfaceDirection { degrees: (across + 90.0).rem_euclid(180.0), coherence, weight: coherence * trace }
    };
    tensors.iter().map(direction).collect()
}

/// |∇v|² and (v_x² − v_y², 2·v_x·v_y) at a vertex, times the area of its cell.
fn tensor(surface: &Surface, values: &[f32], vertex: usize) -> [f64; 3] {
    let (mut products, mut right) = ([0.0; 3], [0.0; 2]);
    for (other, [x, y]) in surface.tangent_ring(vertex) {
        let rise = f64::from(values[other]) - f64::from(values[vertex]);
        products = [products[0] + x * x, products[1] + x * y, products[2] + y * y];
        right = [right[0] + x * rise, right[1] + y * rise];
    }
    let [xx, xy, yy] = products;
    let size = xx * yy - xy * xy;
    let [x, y] = [yy * right[0] - xy * right[1], xx * right[1] - xy * right[0]].map(|part| part / size);
    let area = surface.cell_area(vertex);
    if x.is_finite() && y.is_finite() {
        [area * (x * x + y * y), area * (x * x - y * y), area * 2.0 * x * y]
    } else {
        [0.0; 3]
    }
}
