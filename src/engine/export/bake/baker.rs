//! Values, normals and light of texels, row by row.

use std::ops::Range;

use rayon::prelude::*;

use super::atlas::Atlas;
use super::fields::Fields;
use super::texels::{Flat, Texels};
use crate::export::body::vector::{Vector, cross, dot, minus, plus, unit};
use crate::surface::{Mesh, Surface, SurfacePoint};

/// How far a texel of the gutter may lie from its triangle in space, in lengths that this distance has on the surface on average: a
/// sliver's plane is not followed far.
const FARTHEST: f64 = 3.0;

/// A texture on a surface on which something has grown.
pub struct Baker<'a> {
    atlas: &'a Atlas,
    texels: Texels,
    surface: &'a Surface,
    /// The triangles of the atlas in the coordinates of the surface.
    mesh: Mesh,
    layers: Fields<'a>,
    open: Vec<f32>,
    /// The mean side of a texel on the surface.
    side: f64,
}

/// Some rows of a texture. Texels that are far from all triangles have the values 0, no slope and an open sky.
#[derive(Clone, Debug, Default)]
pub struct Baked {
    /// By layer, the values of the texels.
    pub values: Vec<Vec<f32>>,
    /// The share of the sky that is seen.
    pub open: Vec<f32>,
    /// The place on the surface that each texel shows.
    pub places: Vec<Option<SurfacePoint>>,
    /// By layer, how steep the values are, a unit of length of the surface.
    slopes: Vec<Vec<Vector>>,
    frames: Vec<Option<Frame>>,
}

impl Baked {
    /// The normals of a relief in tangent space: x along u, y along v, upwards in the picture, z out of the surface. `rises`, by
    /// layer: how much higher the relief is for a value that is greater by 1, in units of length of the surface. `more` is how much
    /// steeper it is besides, by texel; nowhere if it is empty.
    #[must_use]
    pub fn normals(&self, rises: &[Vec<f32>], more: &[[f64; 3]]) -> Vec<[f32; 3]> {
        let of_texel = |(texel, frame): (usize, &Option<Frame>)| {
            let Some(frame) = frame else { return [0.0, 0.0, 1.0] };
            let slope = self
                .slopes
                .iter()
                .zip(rises)
                .fold(more.get(texel).copied().unwrap_or_default(), |sum, (slopes, rises)| {
                    plus(sum, f64::from(rises[texel]), slopes[texel])
                });
            frame.normal(slope)
        };
        self.frames.par_iter().enumerate().map(of_texel).collect()
    }

    /// A direction along the surface in tangent space: x along u, y along v; of length 1, or 0 where there is none.
    #[must_use]
    pub fn in_tangent_space(&self, texel: usize, direction: [f64; 3]) -> [f32; 2] {
        self.frames[texel].map_or([0.0; 2], |frame| frame.direction(direction))
    }
}

/// A texel.
struct Texel {
    values: Vec<f32>,
    slopes: Vec<Vector>,
    open: f32,
    place: Option<SurfacePoint>,
    frame: Option<Frame>,
}

impl<'a> Baker<'a> {
    /// A texture of the `texels` of an atlas. `to_surface` maps the coordinates of the atlas to those of the surface; `layers` are
    /// fields of values by vertex of the surface, and `open` is the share of the sky that its vertices see.
    #[must_use]
    pub fn new(
        atlas: &'a Atlas,
        texels: Texels,
        surface: &'a Surface,
        to_surface: &dyn Fn([f64; 3]) -> [f64; 3],
        layers: &[&[f32]],
        open: Vec<f32>,
    ) -> Self {
        let positions = atlas.mesh.positions.iter().map(|at| to_surface(*at)).collect();
        let mesh = Mesh { positions, faces: atlas.mesh.faces.clone() };
        let in_picture: f64 = (0..mesh.faces.len())
            .map(|face| {
                let [a, b, c] = atlas.in_picture(face, texels.size);
                0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).abs()
            })
            .sum();
        let side = (mesh.area() / in_picture.max(f64::MIN_POSITIVE)).sqrt();
        Self { atlas, texels, surface, mesh, layers: Fields::new(surface, layers), open, side }
    }

    /// Width and height, texels.
    #[must_use]
    pub fn size(&self) -> [usize; 2] {
        self.texels.size
    }

    /// Texels along each unit of length of the surface, in the mean.
    #[must_use]
    pub fn scale(&self) -> f64 {
        1.0 / self.side
    }

    /// The texels of some rows.
    #[must_use]
    pub fn rows(&self, rows: Range<usize>) -> Baked {
        let width = self.texels.size[0];
        let texels: Vec<Texel> =
            (rows.start * width..rows.end * width).into_par_iter().map(|texel| self.texel(texel)).collect();
        Baked {
            values: (0..self.layers.count())
                .map(|layer| texels.iter().map(|texel| texel.values[layer]).collect())
                .collect(),
            slopes: (0..self.layers.count())
                .map(|layer| texels.iter().map(|texel| texel.slopes[layer]).collect())
                .collect(),
            open: texels.iter().map(|texel| texel.open).collect(),
            places: texels.iter().map(|texel| texel.place).collect(),
            frames: texels.iter().map(|texel| texel.frame).collect(),
        }
    }

    fn texel(&self, texel: usize) -> Texel {
        let Some((face, shares, place)) = self.place(texel) else {
            let count = self.layers.count();
            let (values, slopes) = (vec![0.0; count], vec![[0.0; 3]; count]);
            return Texel { values, slopes, open: 1.0, place: None, frame: None };
        };
        let normal = self.mesh.area_vector(face);
        let found = self.surface.closest_facing(place, normal);
        let vertices = self.surface.mesh.faces[found.face as usize].map(|vertex| vertex as usize);
        let within = found.shares();
        Texel {
            values: self.layers.values(found),
            slopes: self.layers.slopes(found),
            open: (0..3).map(|at| within[at] as f32 * self.open[vertices[at]]).sum(),
            place: Some(found),
            frame: Some(self.frame(face, shares)),
        }
    }

    /// The triangle of a texel, the shares of its corners in its nearest place, and where the texel is: on the plane of the triangle.
    fn place(&self, texel: usize) -> Option<(usize, [f64; 3], Vector)> {
        let face = self.texels.face(texel)?;
        let (flat, middle) = (Flat(self.atlas.in_picture(face, self.texels.size)), self.texels.middle(texel));
        let (shares, square) = flat.nearest(middle);
        let corners = self.mesh.corners(face);
        let at = |shares: [f64; 3]| (0..3).fold([0.0; 3], |sum, at| plus(sum, shares[at], corners[at]));
        let nearest = at(shares);
        if square == 0.0 {
            return Some((face, shares, nearest));
        }
        let off = minus(at(flat.weights(middle)?), nearest);
        let most = FARTHEST * self.side * square.sqrt();
        let length = dot(off, off).sqrt();
        let share = if length > most { most / length } else { 1.0 };
        Some((face, shares, plus(nearest, share, off)))
    }

    fn frame(&self, face: usize, shares: [f64; 3]) -> Frame {
        let vertices = self.mesh.faces[face].map(|vertex| vertex as usize);
        let mean = |of: &dyn Fn(usize) -> Vector| {
            (0..3).fold([0.0; 3], |sum, at| plus(sum, shares[at], of(vertices[at])))
        };
        let normal = mean(&|vertex| self.atlas.normals[vertex]);
        let tangent = mean(&|vertex| {
            let [x, y, z, _] = self.atlas.tangents[vertex].map(f64::from);
            [x, y, z]
        });
        Frame { normal, tangent, sign: f64::from(self.atlas.tangents[vertices[0]][3]) }
    }
}

/// The frame that shaders use at a texel: normal and tangent are interpolated between the corners, and not normalised.
#[derive(Clone, Copy, Debug)]
struct Frame {
    normal: Vector,
    tangent: Vector,
    sign: f64,
}

impl Frame {
    /// A direction of the surface along tangent and bitangent, of length 1.
    fn direction(&self, along: Vector) -> [f32; 2] {
        let bitangent = cross(self.normal, self.tangent).map(|part| self.sign * part);
        let [x, y] = [self.tangent, bitangent].map(|axis| dot(along, unit(axis)));
        let length = (x * x + y * y).sqrt();
        if length > 0.0 { [x, y].map(|part| (part / length) as f32) } else { [0.0; 2] }
    }

    /// The normal in tangent space that becomes, in a shader, the normal of the surface minus this slope of a relief: the inverse of
    /// what it computes (Mikkelsen 2008).
    fn normal(&self, slope: Vector) -> [f32; 3] {
        let bitangent = cross(self.normal, self.tangent).map(|part| self.sign * part);
        let up = unit(self.normal);
        let wanted = minus(up, plus(slope, -dot(slope, up), up));
        let rows =
            [cross(bitangent, self.normal), cross(self.normal, self.tangent), cross(self.tangent, bitangent)];
        let volume = dot(self.tangent, rows[0]);
        let [x, y, z] = rows.map(|row| dot(wanted, row) * volume.signum());
        let length = (x * x + y * y + z * z).sqrt();
        if z > 0.0 && length > 0.0 { [x, y, z].map(|part| (part / length) as f32) } else { [0.0, 0.0, 1.0] }
    }
}
