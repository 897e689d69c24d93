//! A model with the pattern as a relief, for printers.

use std::io::Write;

use crate::document::BodySource;
use crate::export::Stopped;
use crate::export::body::{Coloured, Fine, normals, ply, stl};
use crate::export::maps::{Surface, shares};
use crate::surface::Mesh;
use crate::synth::body::coat::Coat;
use crate::synth::body::grown::GrownBody;
use crate::synth::body::output::BARE;
use crate::synth::body::texture::chosen;

/// Millimetres of an inch.
const INCH: f64 = 25.4;
/// Millimetres of the unit of glTF, the metre.
const METRE: f64 = 1_000.0;

/// Meshes with a relief, mm: what is grown on, then each of the other parts.
pub struct Displaced {
    parts: Vec<Mesh>,
    colours: Vec<Vec<[f32; 3]>>,
}

impl GrownBody {
    /// The model with the middles of marks `height` mm above the ground, along the normals; below it if `height` is negative. It is
    /// as closed as the model is: no vertex is split.
    #[must_use]
    pub fn displaced(&self, height: f64) -> Displaced {
        let Fine { mut mesh, normals, patterns } = self.fine();
        let relief = Surface { relief: vec![height], ..Surface::default() };
        let colours = Coat::new(&self.document).lights(&patterns);
        let mut shared = chosen(&patterns, &self.raised());
        shares(&mut shared);
        let mut heights = relief.height(&shared);
        heights.resize(mesh.positions.len(), 0.0);
        let (scale, unit) = (self.placed.scale, self.millimetres());
        for ((at, normal), height) in mesh.positions.iter_mut().zip(&normals).zip(heights) {
            let ground = scale.to_file(*at);
            *at = [0, 1, 2].map(|i| unit * ground[i] + f64::from(height) * normal[i]);
        }
        let bare = self.bare(&|at| at.map(|part| unit * part));
        let others: Vec<Mesh> = bare.into_iter().map(|bare| bare.mesh).collect();
        let bare = others.iter().map(|mesh| vec![BARE; mesh.positions.len()]);
        let colours = [colours].into_iter().chain(bare).collect();
        Displaced { parts: [mesh].into_iter().chain(others).collect(), colours }
    }

    /// Millimetres of a unit of the model's file: 1, but 1,000 of glTF, whose unit is the metre. A built-in body has no unit: it is as
    /// large as its px are at the document's dpi.
    fn millimetres(&self) -> f64 {
        let source = self.document.model.as_ref().map(|body| &body.source);
        match source {
            Some(BodySource::File { .. }) => {
                let name = self.placed.model.name.to_ascii_lowercase();
                if name.ends_with(".glb") || name.ends_with(".gltf") { METRE } else { 1.0 }
            }
            _ => self.placed.scale.px * INCH / self.document.dpi,
        }
    }
}

impl Displaced {
    /// Its sides, mm.
    #[must_use]
    pub fn size(&self) -> [f64; 3] {
        let bounds: Vec<_> = self.parts.iter().map(Mesh::bounds).collect();
        [0, 1, 2].map(|axis| {
            let low = bounds.iter().map(|[low, _]| low[axis]).fold(f64::INFINITY, f64::min);
            bounds.iter().map(|[_, high]| high[axis]).fold(f64::NEG_INFINITY, f64::max) - low
        })
    }

    /// The meshes, mm: what is grown on, then each of the other parts.
    #[must_use]
    pub fn parts(&self) -> &[Mesh] {
        &self.parts
    }

    /// Writes a binary `.stl`.
    ///
    /// # Errors
    /// The bytes cannot be written.
    pub fn write_stl(&self, out: impl Write) -> Result<(), Stopped> {
        stl(out, &self.parts.iter().collect::<Vec<_>>())
    }

    /// Writes a `.ply` with colours by vertex.
    ///
    /// # Errors
    /// The bytes cannot be written.
    pub fn write_ply(&self, out: impl Write) -> Result<(), Stopped> {
        let shown: Vec<_> = self.parts.iter().map(normals).collect();
        let part = |((mesh, normals), colours)| Coloured {
            name: "grown",
            material: "",
            mesh,
            normals,
            uvs: &[],
            tangents: &[],
            colours,
        };
        let all = self.parts.iter().zip(shown.iter().map(Vec::as_slice));
        let parts: Vec<Coloured> = all.zip(self.colours.iter().map(Vec::as_slice)).map(part).collect();
        ply(out, &parts)
    }
}
