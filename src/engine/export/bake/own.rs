//! The texture coordinates that a model has, if a texture can be baked on them.

use std::collections::BTreeSet;

use super::atlas::Atlas;
use super::corners::Corners;
use crate::export::body::raster::Plane;
use crate::surface::Model;

/// The side of the picture in which overlaps are looked for, texels.
const SIDE: usize = 1_024;
/// The share of the covered texels that may be covered twice: such small overlaps are hardly seen.
const OVERLAP: f64 = 0.001;
/// The share of the surface that may have no area in the texture.
const FLAT: f64 = 0.01;
/// How far coordinates may lie beyond the picture: rounding.
const BEYOND: f64 = 1e-4;
/// The share of a corner from which on a texel lies within a triangle, not on its side.
const WITHIN: f64 = 1e-6;

/// Why a texture cannot be baked on the coordinates of a model.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum Unfit {
    /// It has none, or not everywhere.
    #[error("it has no texture coordinates")]
    Missing,
    /// They go beyond the picture, which is repeated there.
    #[error(
        "its texture coordinates go from {low:.2} to {high:.2}, beyond the picture, which goes from 0 to 1"
    )]
    Beyond {
        /// The least coordinate.
        low: f64,
        /// The greatest one.
        high: f64,
    },
    /// Two triangles have the same place, as on models whose sides are mirrored.
    #[error("{:.1} % of its texture coordinates overlap", 100.0 * share)]
    Overlap {
        /// The share of the covered texture that is covered twice.
        share: f64,
    },
    /// Triangles have no area in the texture.
    #[error("{:.1} % of its surface have no area in the texture", 100.0 * share)]
    Flat {
        /// The share of the surface.
        share: f64,
    },
}

/// The atlas of the parts of a model for which `is_grown` holds, with the coordinates of its file.
///
/// # Errors
/// Why it cannot be baked on them.
pub fn own(model: &Model, is_grown: &dyn Fn(usize) -> bool) -> Result<Atlas, Unfit> {
    let corners = Corners::new(model, is_grown);
    if corners.uvs.is_empty() {
        return Err(Unfit::Missing);
    }
    let all = || corners.uvs.iter().flatten().flatten().copied();
    let (low, high) = (all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max));
    if !all().all(|part| (-BEYOND..=1.0 + BEYOND).contains(&part)) {
        return Err(Unfit::Beyond { low, high });
    }
    let share = flat_share(&corners);
    if share > FLAT {
        return Err(Unfit::Flat { share });
    }
    let share = overlap_of(&corners);
    if share > OVERLAP {
        return Err(Unfit::Overlap { share });
    }
    Ok(Atlas::new(&corners, &corners.uvs))
}

/// Twice the area of a triangle in the picture.
fn area([a, b, c]: &[[f64; 2]; 3]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// The share of the surface that has no area in the texture.
fn flat_share(corners: &Corners) -> f64 {
    let (mut flat, mut whole) = (0.0, 0.0);
    for (face, uvs) in corners.uvs.iter().enumerate() {
        let size = corners.mesh.area_vector(face).iter().map(|part| part * part).sum::<f64>().sqrt();
        if size.is_finite() {
            whole += size;
            flat += if area(uvs).abs() < 1e-12 { size } else { 0.0 };
        }
    }
    if whole > 0.0 { flat / whole } else { 1.0 }
}

/// The share of the covered texels that two triangles cover. Triangles that are there twice count once.
pub fn overlap_of(corners: &Corners) -> f64 {
    let mut known = BTreeSet::new();
    let mut covered = vec![0_u8; SIDE * SIDE];
    for (face, uvs) in corners.mesh.faces.iter().zip(&corners.uvs) {
        let mut positions = face.map(|vertex| corners.mesh.positions[vertex as usize].map(f64::to_bits));
        positions.sort_unstable();
        if known.insert(positions) {
            each_within(uvs, |texel| covered[texel] = covered[texel].saturating_add(1));
        }
    }
    let count = |least: u8| covered.iter().filter(|count| **count >= least).count() as f64;
    count(2) / count(1).max(1.0)
}

/// Names all texels whose middles lie within a triangle.
fn each_within(uvs: &[[f64; 2]; 3], mut name: impl FnMut(usize)) {
    let corners = uvs.map(|[u, v]| [u * SIDE as f64, v * SIDE as f64, 0.0]);
    let Some(plane) = Plane::new(&corners) else { return };
    let range = |axis: usize| {
        let [a, b, c] = corners.map(|corner| corner[axis]);
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        (low - 0.5).ceil().max(0.0) as usize..((high - 0.5).floor() + 1.0).clamp(0.0, SIDE as f64) as usize
    };
    for row in range(1) {
        for column in range(0) {
            let weights = plane.weights([column as f64 + 0.5, row as f64 + 0.5]);
            if weights.iter().all(|weight| *weight > WITHIN) {
                name(row * SIDE + column);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::{built_in, read_model};

    /// Why the coordinates of a square of two triangles are unfit, and those of a copy of it above.
    fn of(first: [[f64; 2]; 4], second: [[f64; 2]; 4]) -> Option<Unfit> {
        let mut text =
            String::from("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 2\nv 1 0 2\nv 1 1 2\nv 0 1 2\n");
        first.iter().chain(&second).for_each(|[u, v]| text += &format!("vt {u} {v}\n"));
        text += "f 1/1 2/2 3/3 4/4\nf 5/5 6/6 7/7 8/8\n";
        own(&read_model(text.as_bytes(), "a.obj").expect("a model"), &|_| true).err()
    }

    #[test]
    fn coordinates_that_are_missing_overlap_are_flat_or_beyond_the_picture_are_unfit() {
        let square = |x: f64, y: f64| [[x, y], [x + 0.4, y], [x + 0.4, y + 0.4], [x, y + 0.4]];
        assert_eq!(of(square(0.0, 0.0), square(0.4, 0.0)), None, "side by side");
        assert_eq!(of(square(0.0, 0.0), square(0.0, 0.4)), None);
        let Some(Unfit::Overlap { share }) = of(square(0.0, 0.0), square(0.2, 0.0)) else { panic!() };
        assert!((share - 1.0 / 3.0).abs() < 0.01, "{share}");
        // A mirrored half.
        let mirrored = [[0.4, 0.0], [0.0, 0.0], [0.0, 0.4], [0.4, 0.4]];
        let Some(Unfit::Overlap { share }) = of(square(0.0, 0.0), mirrored) else { panic!() };
        assert!(share > 0.99, "{share}");
        assert_eq!(of(square(0.0, 0.0), [[0.7; 2]; 4]), Some(Unfit::Flat { share: 0.5 }));
        assert_eq!(
            of(square(0.0, 0.0), square(0.8, 0.0)),
            Some(Unfit::Beyond { low: 0.0, high: 1.2000000000000002 })
        );
        assert_eq!(own(&built_in("animal").expect("a body"), &|_| true).err(), Some(Unfit::Missing));
        for name in ["cube", "sphere", "torus", "cylinder", "capsule", "spindle", "vase", "snake", "egg"] {
            assert!(own(&built_in(name).expect("a body"), &|_| true).is_ok(), "{name}");
        }
    }

    #[test]
    fn a_triangle_that_is_there_twice_does_not_overlap_itself() {
        let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\nf 1/1 2/2 3/3\n";
        assert!(own(&read_model(text.as_bytes(), "a.obj").expect("a model"), &|_| true).is_ok());
    }
}
