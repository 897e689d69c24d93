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
        let set = Set { deep: false, ..self.set("") };
        let texture = self.texture(watch);
        let maps = self.maps(&texture);
        let mut pictures = vec![Vec::new(); maps.len()];
        let failed = texture.write(&mut pictures, &set, &maps, watch);
        prepare(path, |out| {
            failed.map_err(|failed| failed.why)?;
            let pictures: Vec<_> = pictures.iter().map(|bytes| SkinPicture::Inside(bytes)).collect();
            let skin = skin(&pictures);
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
        let mut files = prepare_maps(&self.texture(watch), folder, &set, &OF_OBJ, watch)?;
        let [base_colour, normal, roughness] = OF_OBJ.map(|map| map.file(&named));
        let skin = skin(&[&base_colour, &normal, &normal].map(|file| SkinPicture::Beside(file)));
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
        let texture = self.texture(watch);
        let set = Set { anisotropic: texture.is_anisotropic(), ..self.set(named) };
        let mut files = prepare_maps(&texture, folder, &set, &set.maps(), watch)?;
        let pictures: Vec<String> = self.maps(&texture).iter().map(|map| map.file(named)).collect();
        let pictures: Vec<_> = pictures.iter().map(|file| SkinPicture::Beside(file)).collect();
        let skin = skin(&pictures);
        let buffer = format!("{named}.bin");
        let [text, bytes] = self.grown.textured_gltf(&self.atlas, &skin, &buffer);
        for (file, bytes) in [(format!("{named}.gltf"), text), (buffer, bytes)] {
            let path: PathBuf = folder.join(file);
            files.push(prepare(&path, |out| Ok::<(), Stopped>(out.write_all(&bytes)?))?);
        }
        Ok(files)
    }

    fn texture(&self, watch: &Watch) -> Texture<'_> {
        self.grown.texture(&self.atlas, self.size, &self.surface, watch)
    }

    /// The pictures of its skin.
    fn maps(&self, texture: &Texture) -> Vec<Map> {
        SKIN.into_iter().chain(texture.is_anisotropic().then_some(Map::Anisotropy)).collect()
    }

    fn set<'b>(&self, name: &'b str) -> Set<'b> {
        Set { name, size: self.size, deep: self.deep, transparent: false, anisotropic: false, dpi: None }
    }
}

/// A skin of these pictures: of [`SKIN`], and if there is one the direction of reflections.
fn skin<'a>(pictures: &[SkinPicture<'a>]) -> Skin<'a> {
    Skin {
        material: MATERIAL,
        base_colour: pictures[0],
        normal: pictures[1],
        orm: pictures[2],
        anisotropy: pictures.get(3).copied(),
        transparent: false,
    }
}
