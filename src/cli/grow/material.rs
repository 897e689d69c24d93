//! `--material`: maps for rendering engines.

use crate::cli::{Error, values};
use crate::document::{Document, Extent};
use crate::export::material::{Map, Set, name};
use crate::export::{ExportError, Format, maps::Surface};
use crate::files::{self, Prepared, SavePicture};
use crate::grid::Edges;
use crate::machine::free_memory;
use crate::synth::render::painting::{Making, Painting, Style, usual_relief};
use crate::synth::{Watch, memory};
use std::path::{Path, PathBuf};

/// Options for a material.
#[derive(clap::Args, Clone, Debug)]
pub struct Material {
    /// Also write a material into this folder: base colour, height, normals, roughness, occlusion, a plane (docs/materials.md)
    #[arg(long, value_name = "DIR")]
    pub material: Option<PathBuf>,
    /// Height of the marks above the ground, px; negative for hollows. One number for each layer; the last one is for
    /// all further layers. Without it 6, with a finish that of the finish: 6 of leather, 1 of skin, else 0
    #[arg(
        long, value_name = "PX,…", requires = "material", value_delimiter = ',',
        value_parser = values::relief
    )]
    pub relief: Option<Vec<f64>>,
    /// Roughness of the ground and of the marks, 0 to 1. One number for each layer; the last one is for all further
    /// layers
    #[arg(
        long, value_name = "GROUND,MARKS,…", requires = "material", value_delimiter = ',',
        default_value = "0.8,0.5", value_parser = roughness
    )]
    pub roughness: Vec<f64>,
}

fn roughness(text: &str) -> Result<f64, String> {
    let number = text.trim().parse::<f64>().ok().filter(|number| (0.0..=1.0).contains(number));
    number.ok_or_else(|| "allowed: numbers from 0 (mirror) to 1 (chalk), such as 0.8,0.5".to_owned())
}

impl Material {
    /// Checks whether the maps can be written, before the growth starts.
    pub fn check(&self, size: [usize; 2]) -> Result<(), Error> {
        let Some(folder) = &self.material else { return Ok(()) };
        if folder.exists() && !folder.is_dir() {
            let folder = folder.display();
            return Err(Error::Usage(format!("--material: found a file {folder}; allowed: a folder")));
        }
        let above = folder.parent().filter(|above| *above != Path::new(""));
        if above.is_some_and(|above| !above.is_dir()) && !folder.is_dir() {
            return Err(Error::step(ExportError::NoFolder {
                path: folder.clone(),
                folder: above.unwrap_or(folder).to_owned(),
            }));
        }
        if size.iter().any(|side| *side > Format::Png.max_side()) {
            let path = folder.clone();
            return Err(Error::step(ExportError::TooWide { path, size, format: Format::Png }));
        }
        Ok(())
    }

    /// Checks whether the data of all layers of `document` fits into memory while the maps are written.
    pub fn check_memory(&self, document: &Document, width: usize, extent: Extent) -> Result<(), Error> {
        if self.material.is_none() {
            return Ok(());
        }
        let wrapped = Making { edges: Edges::Wrap, ..self.making(document, extent, false) };
        let held = wrapped.held(width, document.layers.len());
        memory::check_export("--material", held, "write a smaller one", Some(free_memory()))
            .map_err(Error::step)
    }

    /// Heights and roughness of the marks of `document`.
    pub fn surface(&self, document: &Document) -> Surface {
        let relief = self.relief.clone().unwrap_or_else(|| usual_relief(document));
        Surface { relief, roughness: self.roughness.clone() }
    }

    fn making(&self, document: &Document, extent: Extent, transparent_ground: bool) -> Making {
        Making {
            surface: self.surface(document),
            scale: extent.scale as usize,
            edges: document.edges,
            transparent_ground,
        }
    }

    /// The files of the material of the document `file`.
    pub fn files(&self, file: &Path) -> Vec<PathBuf> {
        let Some(folder) = &self.material else { return Vec::new() };
        let named = set_name(file);
        let maps = Map::ALL.iter().map(|map| map.file(&named));
        let plane = ["bin", "gltf"].map(|ending| format!("{named}.{ending}"));
        maps.chain(plane).map(|file| folder.join(file)).collect()
    }

    /// Writes the maps under temporary names; their final names begin with the name of the document's file.
    pub fn prepare(
        &self,
        painting: &Painting,
        document: &Document,
        file: &Path,
        extent: Extent,
        style: &Style,
        watch: &Watch,
    ) -> Result<Vec<Prepared>, Error> {
        let Some(folder) = &self.material else { return Ok(Vec::new()) };
        if !folder.is_dir() {
            files::make_folder(folder).map_err(Error::step)?;
        }
        let named = set_name(file);
        let set = Set {
            name: &named,
            size: painting.size,
            deep: style.deep,
            transparent: style.transparent || !painting.is_opaque(),
            anisotropic: painting.is_anisotropic(),
            dpi: Some(style.dpi),
        };
        let making = self.making(document, extent, style.transparent);
        painting.prepare_material(folder, &set, &making, watch).map_err(Error::exported)
    }
}

/// The name of a document's material.
pub fn set_name(file: &Path) -> String {
    name(&file.file_stem().unwrap_or_default().to_string_lossy())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn invalid_reliefs_and_roughnesses_are_refused() {
        assert_eq!((values::relief("-2.5"), roughness("0")), (Ok(-2.5), Ok(0.0)));
        for wrong in ["", "nan", "inf", "1e9", "x"] {
            assert!(values::relief(wrong).is_err() && roughness(wrong).is_err(), "{wrong}");
        }
        assert!(roughness("1.1").is_err() && roughness("-0.1").is_err());
    }
}
