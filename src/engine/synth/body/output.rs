//! Pictures and files of what has grown on a model.

use std::io::Write;

use crate::document::{Axis, MapKey};
use crate::export::Stopped;
use crate::export::body::{Coloured, Fine, glb, normals, ply};
use crate::surface::Mesh;
use crate::synth::body::beneath::carried;
use crate::synth::body::coat::Coat;
use crate::synth::body::grown::GrownBody;
use crate::synth::body::layer::BodyLayer;
use crate::synth::body::maps::colours;

/// The light of parts that nothing grows on.
pub const BARE: [f32; 3] = [0.55; 3];
/// Most triangles of a file: a finer mesh than about a million would be slow to load.
const MOST: usize = 250_000;

/// Coordinates in which an axis points up as +y does.
#[must_use]
pub fn upright(up: Axis, [x, y, z]: [f64; 3]) -> [f64; 3] {
    match up {
        Axis::Y => [x, y, z],
        Axis::Z => [x, z, -y],
        Axis::X => [-y, x, z],
        Axis::MinusX => [y, -x, z],
        Axis::MinusY => [x, -y, -z],
        Axis::MinusZ => [x, -z, y],
    }
}

/// A part that nothing grows on.
pub struct Bare {
    /// Its name.
    pub name: String,
    /// The name of its material.
    pub material: String,
    /// Its triangles.
    pub mesh: Mesh,
    /// Normals by vertex.
    pub normals: Vec<[f64; 3]>,
    /// Texture coordinates by vertex; empty if it has none.
    pub uvs: Vec<[f64; 2]>,
}

impl GrownBody {
    /// Writes a `.glb`, y up, in the units of the model's file.
    ///
    /// # Errors
    /// The bytes cannot be written.
    pub fn write_glb(&self, out: impl Write) -> Result<(), Stopped> {
        let up = self.up();
        self.write(&|at| upright(up, at), |parts| glb(out, parts))
    }

    /// Writes a `.ply` in the coordinates of the model's file.
    ///
    /// # Errors
    /// The bytes cannot be written.
    pub fn write_ply(&self, out: impl Write) -> Result<(), Stopped> {
        self.write(&|at| at, |parts| ply(out, parts))
    }

    fn write(
        &self,
        turned: &dyn Fn([f64; 3]) -> [f64; 3],
        write: impl FnOnce(&[Coloured]) -> Result<(), Stopped>,
    ) -> Result<(), Stopped> {
        let scale = &self.placed.scale;
        let Fine { mut mesh, patterns, .. } = self.fine();
        mesh.positions.iter_mut().for_each(|at| *at = turned(scale.to_file(*at)));
        let shown = normals(&mesh);
        let colours = Coat::new(&self.document).lights(&patterns);
        let bare = self.bare(turned);
        let grown = Coloured {
            name: "grown",
            material: "grown",
            mesh: &mesh,
            normals: &shown,
            uvs: &[],
            tangents: &[],
            colours: &colours,
        };
        let plain: Vec<Vec<[f32; 3]>> =
            bare.iter().map(|bare| vec![BARE; bare.mesh.positions.len()]).collect();
        let others = bare.iter().zip(&plain).map(|(bare, colours)| Coloured {
            name: &bare.name,
            material: &bare.material,
            mesh: &bare.mesh,
            normals: &bare.normals,
            uvs: &bare.uvs,
            tangents: &[],
            colours,
        });
        let parts: Vec<Coloured> = [grown].into_iter().chain(others).collect();
        write(&parts)
    }

    /// The patterns of all layers on the mesh of the finest, by vertex.
    #[must_use]
    pub fn patterns(&self) -> Vec<Vec<f32>> {
        let finest = self.finest();
        let of_layer = |layer: &BodyLayer| {
            let is_own = layer.plan.layer == finest.plan.layer;
            if is_own { layer.levelled.pattern.clone() } else { carried(layer, finest.plan.surface()) }
        };
        self.layers.iter().map(of_layer).collect()
    }

    /// The patterns of all layers on the mesh of the finest, and then the numbers of each map that changes colours only, by vertex: what colours need.
    #[must_use]
    pub fn painted(&self) -> Vec<Vec<f32>> {
        let surface = self.finest().plan.surface();
        let coordinates = self.placed.coordinates.as_ref();
        let layers = 0..self.document.layers.len();
        let keys = layers.flat_map(|layer| [MapKey::Colour, MapKey::Ground].map(|key| (layer, key)));
        let maps = keys.filter_map(|of| colours(&self.document, of, surface, coordinates));
        self.patterns().into_iter().chain(maps).collect()
    }

    /// What colours need, on a mesh so fine that edges of spots between its vertices look smooth.
    #[must_use]
    pub fn fine(&self) -> Fine {
        let mesh = self.finest().plan.surface().mesh.clone();
        let fine = Fine { normals: normals(&mesh), patterns: self.painted(), mesh };
        if fine.mesh.faces.len() > MOST { fine } else { fine.split() }
    }

    /// The parts of the model that nothing grows on, in coordinates that `turned` makes of those of the file.
    pub(super) fn bare(&self, turned: &dyn Fn([f64; 3]) -> [f64; 3]) -> Vec<Bare> {
        let only = self.document.model.as_ref().map_or(&[][..], |body| &body.only);
        let part = |index: usize| {
            let split = self.placed.model.split(index);
            let positions = split.mesh.positions.iter().map(|at| turned(*at)).collect();
            let mesh = Mesh { positions, faces: split.mesh.faces };
            let part = &self.placed.model.parts[index];
            let name = part.names().next().unwrap_or("part").to_owned();
            let material = part.material.clone().unwrap_or_else(|| name.clone());
            Bare { name, material, normals: normals(&mesh), mesh, uvs: split.uvs }
        };
        self.placed.model.others(only).into_iter().map(part).collect()
    }

    /// The axis of the file that points upwards.
    pub(super) fn up(&self) -> Axis {
        self.document.model.as_ref().map_or(Axis::Y, |body| body.up)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_axis_is_turned_up_without_a_mirror() {
        for (_, up) in Axis::NAMES {
            assert_eq!(upright(up, up.vector()), [0.0, 1.0, 0.0], "{up:?}");
            let [a, b, c] = [Axis::X, Axis::Y, Axis::Z].map(|axis| upright(up, axis.vector()));
            let cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
            assert_eq!(cross, c, "{up:?}");
        }
    }
}
