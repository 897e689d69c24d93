//! What is written of a model beside pictures: the maps of a material, models with textures, reliefs for printers.

use std::io::Write;
use std::path::{Path, PathBuf};

use super::Args;
use super::body_picture::{check_picture, prepare_picture};
use crate::cli::Error;
use crate::export::bake::Atlas;
use crate::export::body::{Skin, SkinPicture};
use crate::export::maps::Surface;
use crate::export::material::{Map, Set, name};
use crate::export::{Format, Stopped, has_ending};
use crate::files::{self, Prepared, prepare_maps};
use crate::machine::free_memory;
use crate::synth::body::{GrownBody, MATERIAL, Texture};
use crate::synth::{Watch, memory};

/// Width and height of a texture, texels.
const SIZE: [u32; 2] = [2_048, 2_048];
/// The pictures of a skin, in its order.
const SKIN: [Map; 3] = [Map::BaseColour, Map::NormalGl, Map::Orm];
/// The pictures beside an `.obj`.
const OF_OBJ: [Map; 3] = [Map::BaseColour, Map::NormalGl, Map::Roughness];

/// Files under temporary names, and what is to be said of them.
#[derive(Default)]
pub struct Written {
    pub files: Vec<Prepared>,
    pub notes: Vec<String>,
}

/// Refuses a relief that no file takes, and a file that needs one.
///
/// # Errors
/// [`Error::Usage`] with what is allowed.
pub fn check(args: &Args) -> Result<(), Error> {
    let output = args.output.as_deref();
    let ends = |ending| output.is_some_and(|path| has_ending(path, ending));
    let shown = output.unwrap_or(Path::new("no --output")).display();
    if args.body.displace.is_some() && !ends("stl") && !ends("ply") {
        return Err(Error::Usage(format!(
            "--displace: found {shown}, which holds no relief; allowed: with -o OUT.stl or OUT.ply"
        )));
    }
    if ends("stl") && args.body.displace.is_none() {
        return Err(Error::Usage(format!(
            "--output: found {shown}, which holds no colours; allowed: with --displace MM, the height of the marks"
        )));
    }
    if args.material.material.is_some() || ends("glb") || ends("obj") {
        let size = size(args).map(|side| side as usize);
        args.material.check(size)?;
        memory::check_export(
            "the texture",
            Texture::held(size),
            "choose a smaller --size",
            Some(free_memory()),
        )
        .map_err(Error::step)?;
    }
    if output.is_some_and(|path| Format::from_path(path).is_some()) {
        check_picture(args)?;
    }
    Ok(())
}

/// Width and height of a texture, texels.
fn size(args: &Args) -> [u32; 2] {
    args.size.unwrap_or(SIZE).map(|side| side.saturating_mul(args.scale.unwrap_or(1)))
}

/// Writes all files of a model but its report.
///
/// # Errors
/// A file cannot be written; or it was cancelled.
pub fn prepare(args: &Args, grown: &GrownBody, watch: &Watch) -> Result<Written, Error> {
    let mut written = Written::default();
    let textured = Textured::new(args, grown, &mut written)?;
    if let Some(path) = args.output.as_deref() {
        let file = if has_ending(path, "glb") {
            match &textured {
                Some(textured) => textured.glb(path, watch)?,
                None => files::prepare(path, |out| grown.write_glb(out)).map_err(Error::exported)?,
            }
        } else if let (true, Some(textured)) = (has_ending(path, "obj"), &textured) {
            textured.obj(path, watch, &mut written.files)?
        } else if let Some(height) = args.body.displace {
            relief(path, grown, height, &mut written)?
        } else if has_ending(path, "ply") {
            files::prepare(path, |out| grown.write_ply(out)).map_err(Error::exported)?
        } else {
            prepare_picture(path, args, grown)?
        };
        written.files.push(file);
    }
    if let (Some(folder), Some(textured)) = (&args.material.material, &textured) {
        textured.material(folder, args, watch, &mut written.files)?;
    }
    Ok(written)
}

/// Writes a model whose marks are raised by `height` mm.
fn relief(path: &Path, grown: &GrownBody, height: f64, written: &mut Written) -> Result<Prepared, Error> {
    let displaced = grown.displaced(height);
    let [x, y, z] = displaced.size();
    written.notes.push(format!("{}: {x:.1} × {y:.1} × {z:.1} mm", path.display()));
    let is_stl = has_ending(path, "stl");
    files::prepare(path, |out| if is_stl { displaced.write_stl(out) } else { displaced.write_ply(out) })
        .map_err(Error::exported)
}

/// A model with its texture.
struct Textured<'a> {
    grown: &'a GrownBody,
    atlas: Atlas,
    surface: Surface,
    size: [usize; 2],
    deep: bool,
}

impl<'a> Textured<'a> {
    /// `None` where no file has a texture: a `.glb` of a model without texture coordinates has colours by vertex.
    fn new(args: &Args, grown: &'a GrownBody, written: &mut Written) -> Result<Option<Self>, Error> {
        let ends = |ending| args.output.as_deref().is_some_and(|path| has_ending(path, ending));
        let needed = args.material.material.is_some() || ends("obj");
        let atlas = if needed {
            let laid = grown.lay_out().map_err(Error::step)?;
            written.notes.extend(laid.note(&grown.placed.model.name));
            Some(laid.atlas)
        } else if ends("glb") {
            grown.own_atlas().ok()
        } else {
            None
        };
        let surface = args.material.surface(&grown.document);
        let (size, deep) = (size(args).map(|side| side as usize), args.look.depth == 16);
        Ok(atlas.map(|atlas| Self { grown, atlas, surface, size, deep }))
    }

    fn texture(&self) -> Texture<'_> {
        self.grown.texture(&self.atlas, self.size, &self.surface)
    }

    fn set<'b>(&self, name: &'b str) -> Set<'b> {
        Set { name, size: self.size, deep: self.deep, transparent: false, dpi: None }
    }

    /// Writes a `.glb` with its pictures.
    fn glb(&self, path: &Path, watch: &Watch) -> Result<Prepared, Error> {
        let mut pictures: [Vec<u8>; 3] = Default::default();
        let set = Set { deep: false, ..self.set("") };
        let failed = self.texture().write(&mut pictures, &set, &SKIN, watch);
        files::prepare(path, |out| {
            failed.map_err(|failed| failed.why)?;
            let [base_colour, normal, orm] = [0, 1, 2].map(|at| SkinPicture::Inside(&pictures[at]));
            let skin = self.skin([base_colour, normal, orm]);
            self.grown.write_textured_glb(out, &self.atlas, &skin)
        })
        .map_err(Error::exported)
    }

    fn skin<'b>(&self, [base_colour, normal, orm]: [SkinPicture<'b>; 3]) -> Skin<'b> {
        Skin { material: MATERIAL, base_colour, normal, orm, transparent: false }
    }

    /// Writes an `.obj`; its materials and their pictures lie beside it.
    fn obj(&self, path: &Path, watch: &Watch, files: &mut Vec<Prepared>) -> Result<Prepared, Error> {
        let named = name(&path.file_stem().unwrap_or_default().to_string_lossy());
        let folder = path.parent().unwrap_or(Path::new(""));
        let set = self.set(&named);
        files.extend(prepare_maps(&self.texture(), folder, &set, &OF_OBJ, watch).map_err(Error::exported)?);
        let [base_colour, normal, roughness] = OF_OBJ.map(|map| map.file(&named));
        let skin = self.skin([&base_colour, &normal, &normal].map(|file| SkinPicture::Beside(file)));
        let library = format!("{named}.mtl");
        let of_library = files::prepare(&folder.join(&library), |out| {
            self.grown.write_mtl(out, &self.atlas, &skin, &roughness)
        });
        files.push(of_library.map_err(Error::exported)?);
        files::prepare(path, |out| self.grown.write_obj(out, &self.atlas, &library)).map_err(Error::exported)
    }

    /// Writes all maps into a folder, and the model with them.
    fn material(
        &self,
        folder: &Path,
        args: &Args,
        watch: &Watch,
        files: &mut Vec<Prepared>,
    ) -> Result<(), Error> {
        if !folder.is_dir() {
            files::make_folder(folder).map_err(Error::step)?;
        }
        let named = super::material::set_name(&args.file);
        let set = self.set(&named);
        let maps = prepare_maps(&self.texture(), folder, &set, &set.maps(), watch);
        files.extend(maps.map_err(Error::exported)?);
        let pictures = SKIN.map(|map| map.file(&named));
        let skin = self.skin([0, 1, 2].map(|at| SkinPicture::Beside(&pictures[at])));
        let buffer = format!("{named}.bin");
        let [text, bytes] = self.grown.textured_gltf(&self.atlas, &skin, &buffer);
        for (file, bytes) in [(format!("{named}.gltf"), text), (buffer, bytes)] {
            let path: PathBuf = folder.join(file);
            let prepared = files::prepare(&path, |out| Ok::<(), Stopped>(out.write_all(&bytes)?));
            files.push(prepared.map_err(Error::exported)?);
        }
        Ok(())
    }
}
