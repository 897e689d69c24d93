//! A grown model with its texture in files, under temporary names until they are complete.

use std::io::Write;
use std::path::{Path, PathBuf};

use super::maps::prepare_maps;
use super::save::{Prepared, make_folder, prepare};
use crate::export::bake::Atlas;
use crate::export::body::{Skin, SkinPicture};
use crate::export::maps::Surface;
use crate::export::material::{Map, Set, name};
use crate::export::{ExportError, Stopped};
use crate::synth::Watch;
use crate::synth::body::{GrownBody, MATERIAL, Texture};

/// The pictures of a skin, in its order.
const SKIN: [Map; 3] = [Map::BaseColour, Map::NormalGl, Map::Orm];
/// The pictures beside an `.obj`.
const OF_OBJ: [Map; 3] = [Map::BaseColour, Map::NormalGl, Map::Roughness];

/// A grown model with its texture.
pub struct TexturedBody<'a> {
    /// What has grown.
    pub grown: &'a GrownBody,
    /// Its triangles with texture coordinates.
    pub atlas: Atlas,
    /// Heights and roughness of its marks.
    pub surface: Surface,
    /// Width and height of the texture, texels.
    pub size: [usize; 2],
    /// Whether the maps of a material have 16 bits.
    pub deep: bool,
}

impl TexturedBody<'_> {
    /// Width and height of the texture where none are asked for, texels.
    pub const SIZE: [u32; 2] = [2_048, 2_048];

    /// Writes a `.glb` with its pictures in it.
    ///
    /// # Errors
    /// The file cannot be written; or it was cancelled.
    pub fn prepare_glb(&self, path: &Path, watch: &Watch) -> Result<Prepared, ExportError> {
        let mut pictures: [Vec<u8>; 3] = Default::default();
        let set = Set { deep: false, ..self.set("") };
        let failed = self.texture().write(&mut pictures, &set, &SKIN, watch);
        prepare(path, |out| {
            failed.map_err(|failed| failed.why)?;
            let [base_colour, normal, orm] = [0, 1, 2].map(|at| SkinPicture::Inside(&pictures[at]));
            let skin = self.skin([base_colour, normal, orm]);
            self.grown.write_textured_glb(out, &self.atlas, &skin)
        })
    }

    /// Writes an `.obj`; its materials and their pictures lie beside it.
    ///
    /// # Errors
    /// A file cannot be written; or it was cancelled.
    pub fn prepare_obj(&self, path: &Path, watch: &Watch) -> Result<Vec<Prepared>, ExportError> {
        let named = name(&path.file_stem().unwrap_or_default().to_string_lossy());
        let folder = path.parent().unwrap_or(Path::new(""));
        let set = self.set(&named);
        let mut files = prepare_maps(&self.texture(), folder, &set, &OF_OBJ, watch)?;
        let [base_colour, normal, roughness] = OF_OBJ.map(|map| map.file(&named));
        let skin = self.skin([&base_colour, &normal, &normal].map(|file| SkinPicture::Beside(file)));
        let library = format!("{named}.mtl");
        files.push(prepare(&folder.join(&library), |out| {
            self.grown.write_mtl(out, &self.atlas, &skin, &roughness)
        })?);
        files.push(prepare(path, |out| self.grown.write_obj(out, &self.atlas, &library))?);
        Ok(files)
    }

    /// Writes all maps of the material `named` into a folder, and the model as `.gltf` with them.
    ///
    /// # Errors
    /// The folder cannot be made, a file cannot be written; or it was cancelled.
    pub fn prepare_material(
        &self,
        folder: &Path,
        named: &str,
        watch: &Watch,
    ) -> Result<Vec<Prepared>, ExportError> {
        make_folder(folder)?;
        let set = self.set(named);
        let mut files = prepare_maps(&self.texture(), folder, &set, &set.maps(), watch)?;
        let pictures = SKIN.map(|map| map.file(named));
        let skin = self.skin([0, 1, 2].map(|at| SkinPicture::Beside(&pictures[at])));
        let buffer = format!("{named}.bin");
        let [text, bytes] = self.grown.textured_gltf(&self.atlas, &skin, &buffer);
        for (file, bytes) in [(format!("{named}.gltf"), text), (buffer, bytes)] {
            let path: PathBuf = folder.join(file);
            files.push(prepare(&path, |out| Ok::<(), Stopped>(out.write_all(&bytes)?))?);
        }
        Ok(files)
    }

    fn texture(&self) -> Texture<'_> {
        self.grown.texture(&self.atlas, self.size, &self.surface)
    }

    fn set<'b>(&self, name: &'b str) -> Set<'b> {
        Set { name, size: self.size, deep: self.deep, transparent: false, anisotropic: false, dpi: None }
    }

    fn skin<'b>(&self, [base_colour, normal, orm]: [SkinPicture<'b>; 3]) -> Skin<'b> {
        Skin { material: MATERIAL, base_colour, normal, orm, transparent: false }
    }
}
