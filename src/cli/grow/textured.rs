//! What is written of a model beside pictures: the maps of a material, models with textures, reliefs for printers.

use std::path::Path;

use super::Args;
use super::body_picture::{check_picture, prepare_picture};
use crate::cli::Error;
use crate::export::{ExportError, Format, has_ending};
use crate::files::{self, Prepared, TexturedBody};
use crate::machine::free_memory;
use crate::synth::body::{GrownBody, Texture};
use crate::synth::{Watch, memory};

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
    args.size.unwrap_or(TexturedBody::SIZE).map(|side| side.saturating_mul(args.scale.unwrap_or(1)))
}

/// Writes all files of a model but its report.
///
/// # Errors
/// A file cannot be written; or it was cancelled.
pub fn prepare(args: &Args, grown: &GrownBody, watch: &Watch) -> Result<Written, Error> {
    let mut written = Written::default();
    let textured = textured(args, grown, &mut written)?;
    if let Some(path) = args.output.as_deref() {
        let one = |file: Result<Prepared, ExportError>| Ok(vec![file.map_err(Error::exported)?]);
        let made = if has_ending(path, "glb") {
            one(match &textured {
                Some(textured) => textured.prepare_glb(path, watch),
                None => files::prepare(path, |out| grown.write_glb(out)),
            })
        } else if let (true, Some(textured)) = (has_ending(path, "obj"), &textured) {
            textured.prepare_obj(path, watch).map_err(Error::exported)
        } else if let Some(height) = args.body.displace {
            Ok(vec![relief(path, grown, height, &mut written)?])
        } else if has_ending(path, "ply") {
            written.notes.extend(unfinished(path, grown));
            one(files::prepare(path, |out| grown.write_ply(out)))
        } else {
            Ok(vec![prepare_picture(path, args, grown, watch)?])
        };
        written.files.extend(made?);
    }
    if let (Some(folder), Some(textured)) = (&args.material.material, &textured) {
        let named = super::material::set_name(&args.file);
        written.files.extend(textured.prepare_material(folder, &named, watch).map_err(Error::exported)?);
    }
    Ok(written)
}

/// Writes a model whose marks are raised by `height` mm.
fn relief(path: &Path, grown: &GrownBody, height: f64, written: &mut Written) -> Result<Prepared, Error> {
    written.notes.extend(unfinished(path, grown));
    let displaced = grown.displaced(height);
    let [x, y, z] = displaced.size();
    written.notes.push(format!("{}: {x:.1} × {y:.1} × {z:.1} mm", path.display()));
    let is_stl = has_ending(path, "stl");
    files::prepare(path, |out| if is_stl { displaced.write_stl(out) } else { displaced.write_ply(out) })
        .map_err(Error::exported)
}

/// What is to be said of a file that has colours and heights by vertex; nothing if the document has no finish.
fn unfinished(path: &Path, grown: &GrownBody) -> Option<String> {
    let kind = grown.document.finish.as_ref()?.finish.kind.name();
    let path = path.display();
    Some(format!("{path}: without the finish {kind}, which is finer than its triangles; -o OUT.glb has it"))
}

/// The model with its texture; `None` where no file has one: a `.glb` of a model without texture coordinates has colours by
/// vertex, unless the document has a finish.
fn textured<'a>(
    args: &Args,
    grown: &'a GrownBody,
    written: &mut Written,
) -> Result<Option<TexturedBody<'a>>, Error> {
    let ends = |ending| args.output.as_deref().is_some_and(|path| has_ending(path, ending));
    // A finish is finer than colours by vertex.
    let is_finished = grown.document.finish.is_some() && ends("glb");
    let needed = args.material.material.is_some() || ends("obj") || is_finished;
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
    Ok(atlas.map(|atlas| TexturedBody { grown, atlas, surface, size, deep }))
}
