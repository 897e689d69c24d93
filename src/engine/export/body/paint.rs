//! The input of drawing and writing: triangles with colours.

use super::blurred::Blurred;
use super::mips::Mips;
use super::vector::Vector;
use crate::surface::Mesh;

/// Triangles to draw.
#[derive(Clone, Copy, Debug)]
pub struct Painted<'a> {
    /// The triangles; all their indices must be of vertices.
    pub mesh: &'a Mesh,
    /// Normals by vertex, of length 1; `normals` computes them.
    pub normals: &'a [Vector],
    /// Their colours.
    pub paint: Paint<'a>,
}

/// Colours of a surface: linear light, 0..1.
#[derive(Clone, Copy)]
pub enum Paint<'a> {
    /// One colour.
    Plain([f32; 3]),
    /// Colours by vertex, interpolated: edges between colours are as wide as a triangle.
    Colours(&'a [[f32; 3]]),
    /// Values by vertex, interpolated by cubics, and a colour for each sample of the picture: edges where the colour changes with
    /// the value are sharp and smooth, for triangles of any size.
    Pattern {
        /// Up to eight fields of values by vertex.
        fields: &'a [&'a [f32]],
        /// The colour for one value of each field.
        colour: &'a (dyn Fn(&[f32]) -> [f32; 3] + Sync),
    },
    /// Colours by vertex, blurred as much as a px needs: of a model that is far away.
    Blurred(&'a Blurred),
    /// A look that is computed for single places.
    Look(&'a dyn Look),
    /// A picture on texture coordinates.
    Texture {
        /// By vertex, from the lower left corner.
        uvs: &'a [[f64; 2]],
        /// The picture at all sizes.
        mips: &'a Mips,
    },
}

/// What a surface looks like, place by place.
pub trait Look: Sync {
    /// Colour, linear light, and slope of a relief at a place, which the shares of the corners of a triangle give: a tangent vector along
    /// which it rises, px a px. What is seen as one is `px` long.
    fn at(&self, triangle: usize, shares: [f64; 3], px: f64) -> ([f32; 3], Vector);
}

impl std::fmt::Debug for Paint<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Plain(colour) => f.debug_tuple("Plain").field(colour).finish(),
            Self::Colours(colours) => f.debug_tuple("Colours").field(&colours.len()).finish(),
            Self::Blurred(_) => f.debug_tuple("Blurred").finish_non_exhaustive(),
            Self::Look(_) => f.debug_tuple("Look").finish_non_exhaustive(),
            Self::Texture { mips, .. } => f.debug_struct("Texture").field("size", &mips.size()).finish(),
            Self::Pattern { fields, .. } => {
                f.debug_struct("Pattern").field("fields", &fields.len()).finish_non_exhaustive()
            }
        }
    }
}

/// Triangles to write in a file.
#[derive(Clone, Copy, Debug)]
pub struct Coloured<'a> {
    /// The name of the part.
    pub name: &'a str,
    /// The name of its material; it has none if empty.
    pub material: &'a str,
    /// The triangles; all their indices must be of vertices.
    pub mesh: &'a Mesh,
    /// Normals by vertex; none are written if empty.
    pub normals: &'a [Vector],
    /// Texture coordinates by vertex, from the lower left corner; none are written if empty.
    pub uvs: &'a [[f64; 2]],
    /// Tangents by vertex, along u of the texture coordinates, with the sign of the bitangent; none are written if empty.
    pub tangents: &'a [[f32; 4]],
    /// Colours by vertex, linear light, 0..1; none are written if empty.
    pub colours: &'a [[f32; 3]],
}
