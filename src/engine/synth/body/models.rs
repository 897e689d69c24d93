//! Files of the model with its texture: glTF, GLB, OBJ.

use std::io::Write;

use crate::export::Stopped;
use crate::export::bake::Atlas;
use crate::export::body::{Coloured, Skin, gltf, mtl, obj, textured_glb};
use crate::surface::Mesh;
use crate::synth::body::grown::GrownBody;
use crate::synth::body::output::upright;

/// The name of the material that has the texture.
pub const MATERIAL: &str = "grown";

impl GrownBody {
    /// Writes a `.glb`, y up, in the units of the model's file, with the pictures of a `skin` on the coordinates of an atlas.
    ///
    /// # Errors
    /// The bytes cannot be written.
    pub fn write_textured_glb(&self, out: impl Write, atlas: &Atlas, skin: &Skin) -> Result<(), Stopped> {
        let up = self.up();
        self.with_parts(atlas, &|at| upright(up, at), |parts| textured_glb(out, parts, skin))
    }

    /// The text of a `.gltf`, y up, in the units of the model's file, and the bytes of the file `buffer` beside it.
    #[must_use]
    pub fn textured_gltf(&self, atlas: &Atlas, skin: &Skin, buffer: &str) -> [Vec<u8>; 2] {
        let up = self.up();
        self.with_parts(atlas, &|at| upright(up, at), |parts| gltf(parts, skin, buffer))
    }

    /// Writes an `.obj` in the coordinates of the model's file; its materials are in the file `library`.
    ///
    /// # Errors
    /// The bytes cannot be written.
    pub fn write_obj(&self, out: impl Write, atlas: &Atlas, library: &str) -> Result<(), Stopped> {
        self.with_parts(atlas, &|at| at, |parts| obj(out, parts, library))
    }

    /// Writes the `.mtl` of [`Self::write_obj`]; `roughness` is the name of the picture of its roughness.
    ///
    /// # Errors
    /// The bytes cannot be written.
    pub fn write_mtl(
        &self,
        out: impl Write,
        atlas: &Atlas,
        skin: &Skin,
        roughness: &str,
    ) -> Result<(), Stopped> {
        self.with_parts(atlas, &|at| at, |parts| mtl(out, parts, skin, roughness))
    }

    /// The parts of the model in coordinates that `turned` makes of those of the file: what is grown on first.
    fn with_parts<R>(
        &self,
        atlas: &Atlas,
        turned: &dyn Fn([f64; 3]) -> [f64; 3],
        write: impl FnOnce(&[Coloured]) -> R,
    ) -> R {
        let positions = atlas.mesh.positions.iter().map(|at| turned(*at)).collect();
        let mesh = Mesh { positions, faces: atlas.mesh.faces.clone() };
        let normals: Vec<_> = atlas.normals.iter().map(|normal| turned(*normal)).collect();
        let tangent = |[x, y, z, sign]: &[f32; 4]| {
            let [x, y, z] = turned([*x, *y, *z].map(f64::from)).map(|part| part as f32);
            [x, y, z, *sign]
        };
        let tangents: Vec<[f32; 4]> = atlas.tangents.iter().map(tangent).collect();
        let bare = self.bare(turned);
        let grown = Coloured {
            name: "grown",
            material: MATERIAL,
            mesh: &mesh,
            normals: &normals,
            uvs: &atlas.uvs,
            tangents: &tangents,
            colours: &[],
        };
        let others = bare.iter().map(|bare| Coloured {
            name: &bare.name,
            // Only one material has the texture.
            material: if bare.material == MATERIAL { "other" } else { &bare.material },
            mesh: &bare.mesh,
            normals: &bare.normals,
            uvs: &bare.uvs,
            tangents: &[],
            colours: &[],
        });
        write(&[grown].into_iter().chain(others).collect::<Vec<_>>())
    }
}
