//! Which triangle each texel belongs to.

use rayon::prelude::*;

use super::atlas::Atlas;
use crate::export::body::raster::Plane;

/// No triangle.
const NONE: u32 = u32::MAX;
/// Rows of texels that are sorted together.
const BAND: usize = 16;
/// How far a triangle reaches beyond a side that another one joins, texels: rounding leaves no gap there.
const JOINED: f64 = 0.01;

/// The triangles of a picture's texels.
#[derive(Clone, Debug)]
pub struct Texels {
    /// Width and height, texels.
    pub size: [usize; 2],
    faces: Vec<u32>,
}

impl Texels {
    /// The texels of a picture of this size. Those outside of all triangles belong to the nearest one that ends there, as far as
    /// `gutter` texels away.
    #[must_use]
    pub fn new(atlas: &Atlas, size: [usize; 2], gutter: usize) -> Self {
        let reach = |face: usize| {
            if atlas.is_rim[face] == [false; 3] { JOINED } else { JOINED.max(gutter as f64) }
        };
        let mut bins = vec![Vec::new(); size[1].div_ceil(BAND)];
        for face in 0..atlas.mesh.faces.len() {
            let [a, b, c] = atlas.in_picture(face, size).map(|corner| corner[1]);
            let low = (a.min(b).min(c) - reach(face)).max(0.0) as usize / BAND;
            let high = (a.max(b).max(c) + reach(face)).max(0.0) as usize / BAND;
            for bin in bins.iter_mut().take(high.saturating_add(1)).skip(low) {
                bin.push(face as u32);
            }
        }
        let mut faces = vec![NONE; size[0] * size[1]];
        let bands = faces.par_chunks_mut(BAND * size[0].max(1));
        bands.zip(&bins).enumerate().for_each(|(band, (faces, bin))| {
            let mut squares = vec![f64::INFINITY; faces.len()];
            for &face in bin {
                let triangle = Flat(atlas.in_picture(face as usize, size));
                let rows = [band * BAND, band * BAND + faces.len() / size[0]];
                triangle.each_near(size[0], rows, reach(face as usize), |texel, square| {
                    // Triangles come in their order: of several the first one stays.
                    if square < squares[texel] {
                        (squares[texel], faces[texel]) = (square, face);
                    }
                });
            }
        });
        Self { size, faces }
    }

    /// The triangle of a texel; `None` if it is far from all.
    #[must_use]
    pub fn face(&self, texel: usize) -> Option<usize> {
        let face = self.faces[texel];
        (face != NONE).then_some(face as usize)
    }

    /// The middle of a texel, from the upper left corner.
    pub(super) fn middle(&self, texel: usize) -> [f64; 2] {
        [(texel % self.size[0]) as f64 + 0.5, (texel / self.size[0]) as f64 + 0.5]
    }
}

/// A triangle in the picture.
pub struct Flat(pub [[f64; 2]; 3]);

impl Flat {
    /// How much of each corner is in a place, also beyond the sides; `None` without area.
    pub fn weights(&self, place: [f64; 2]) -> Option<[f64; 3]> {
        let plane = Plane::new(&self.0.map(|[x, y]| [x, y, 0.0]))?;
        Some(plane.weights(place))
    }

    /// The shares of the corners in the nearest place of the triangle, and its squared distance.
    pub fn nearest(&self, place: [f64; 2]) -> ([f64; 3], f64) {
        match self.weights(place) {
            Some(weights) if weights.iter().all(|weight| *weight >= 0.0) => (weights, 0.0),
            _ => self.nearest_on_sides(place),
        }
    }

    fn nearest_on_sides(&self, [x, y]: [f64; 2]) -> ([f64; 3], f64) {
        let on_side = |side: usize| {
            let (a, b) = (self.0[side], self.0[(side + 1) % 3]);
            let (along, off) = ([b[0] - a[0], b[1] - a[1]], [x - a[0], y - a[1]]);
            let square = along[0] * along[0] + along[1] * along[1];
            let share = (along[0] * off[0] + along[1] * off[1]) / square;
            let share = if square > 0.0 { share.clamp(0.0, 1.0) } else { 0.0 };
            let off = [off[0] - share * along[0], off[1] - share * along[1]];
            let mut weights = [0.0; 3];
            weights[side] = 1.0 - share;
            weights[(side + 1) % 3] = share;
            (weights, off[0] * off[0] + off[1] * off[1])
        };
        let nearer = |a: ([f64; 3], f64), b: ([f64; 3], f64)| if b.1 < a.1 { b } else { a };
        nearer(nearer(on_side(0), on_side(1)), on_side(2))
    }

    /// Names the texels of the rows from `rows[0]` to before `rows[1]` that are not farther than `reach`, counted from the first of
    /// these rows, with their squared distances.
    fn each_near(&self, width: usize, rows: [usize; 2], reach: f64, mut name: impl FnMut(usize, f64)) {
        let Some(plane) = Plane::new(&self.0.map(|[x, y]| [x, y, 0.0])) else { return };
        let range = |axis: usize, [least, most]: [usize; 2]| {
            let [a, b, c] = self.0.map(|corner| corner[axis]);
            let (low, high) = (a.min(b).min(c) - reach, a.max(b).max(c) + reach);
            let first = (low - 0.5).ceil().max(least as f64) as usize;
            first..((high - 0.5).floor() + 1.0).clamp(0.0, most as f64) as usize
        };
        for row in range(1, rows) {
            for column in range(0, [0, width]) {
                let place = [column as f64 + 0.5, row as f64 + 0.5];
                let is_within = plane.weights(place).iter().all(|weight| *weight >= 0.0);
                let square = if is_within { 0.0 } else { self.nearest_on_sides(place).1 };
                if square <= reach * reach {
                    name((row - rows[0]) * width + column, square);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::export::bake::{Texels, own};
    use crate::surface::{built_in, read_model};

    #[test]
    fn each_side_of_a_cube_covers_its_part_of_the_picture() {
        let atlas = own(&built_in("cube").expect("a body"), &|_| true).expect("coordinates");
        let texels = Texels::new(&atlas, [96, 64], 4);
        for texel in 0..96 * 64 {
            let face = texels.face(texel).expect("the picture is full");
            let [column, row] = [texel % 96 / 32, texel / 96 / 32];
            // Sides 0, 1, 2 are below, and each has 24² squares.
            assert_eq!(face / (2 * 24 * 24), if row == 1 { column } else { 3 + column }, "{texel}");
        }
    }

    #[test]
    fn the_gutter_is_as_wide_as_asked_for_and_belongs_to_the_nearest_triangle() {
        let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.25 0.25\nvt 0.75 0.25\nvt 0.25 0.75\nf 1/1 2/2 3/3\n";
        let atlas = own(&read_model(text.as_bytes(), "a.obj").expect("a model"), &|_| true).expect("atlas");
        let texels = Texels::new(&atlas, [80, 80], 8);
        // The row through the middle of the left side: it begins at x = 20.
        let row = |x: usize| texels.face(40 * 80 + x).is_some();
        assert_eq!((0..80).filter(|x| row(*x)).min(), Some(12));
        // Beyond the slanting side the gutter is measured across it: at y = 40.5 the side is at x = 39.5.
        let last = (0..80).filter(|x| row(*x)).max().expect("some");
        assert!((last as f64 + 0.5 - 39.5 - 8.0 * 2f64.sqrt()).abs() < 1.0, "{last}");
    }
}
