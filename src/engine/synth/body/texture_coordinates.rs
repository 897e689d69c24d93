//! The texture coordinates that a model's file gives its surface.

use crate::document::{Document, DocumentError, LayerMap, MapKey, MapSource, Problem};
use crate::surface::{BoundingTree, Face, Model, area_vector};

/// The triangles of a model with the texture coordinates of their corners.
pub struct TextureCoordinates {
    tree: BoundingTree,
    /// Normals of the triangles, of any length.
    normals: Vec<[f64; 3]>,
    /// Coordinates of the corners of each triangle.
    uvs: Vec<[[f64; 2]; 3]>,
}

impl TextureCoordinates {
    /// The coordinates that the maps of a document on a model need; `None` where none is by a picture. `to_px` turns coordinates of the
    /// file into px.
    ///
    /// # Errors
    /// One is, and a triangle of the model has no coordinates: the place, and what is allowed.
    pub fn needed(
        document: &Document,
        model: &Model,
        to_px: &dyn Fn([f64; 3]) -> [f64; 3],
        source: &str,
    ) -> Result<Option<Self>, DocumentError> {
        let Some((layer, key)) = by_picture(document) else { return Ok(None) };
        let found = Self::of(document, model, to_px);
        let missing = || {
            let place = format!("layers[{layer}].maps.{}.image", key.name());
            let found = format!("a picture, and {} has no texture coordinates", model.name);
            let allowed = "noise, or a model with texture coordinates, on which the picture lies";
            Problem::new(place, found, allowed).in_file(source)
        };
        found.map(Some).ok_or_else(missing)
    }

    fn of(document: &Document, model: &Model, to_px: &dyn Fn([f64; 3]) -> [f64; 3]) -> Option<Self> {
        let only = document.model.as_ref().map_or(&[][..], |body| &body.only);
        let others = model.others(only);
        let faces = || model.faces.iter().filter(|face| !others.contains(&(face.part as usize)));
        let corners =
            |face: &Face| face.corners.map(|corner| to_px(model.positions[corner.position as usize]));
        let of_face = |face: &Face| -> Option<[[f64; 2]; 3]> {
            let [a, b, c] = face.corners.map(|corner| corner.uv.map(|uv| model.uvs[uv as usize]));
            Some([a?, b?, c?])
        };
        let uvs: Vec<[[f64; 2]; 3]> = faces().map(of_face).collect::<Option<_>>()?;
        let triangles: Vec<[[f64; 3]; 3]> = faces().map(corners).collect();
        let normals = triangles.iter().map(|corners| area_vector(*corners)).collect();
        (!uvs.is_empty()).then(|| Self { tree: BoundingTree::new(triangles), normals, uvs })
    }

    /// The coordinates at a place of the surface, px, with this normal.
    #[must_use]
    pub fn at(&self, place: [f64; 3], normal: [f64; 3]) -> [f64; 2] {
        let faces = |triangle: u32| {
            let own = self.normals[triangle as usize];
            (0..3).map(|i| own[i] * normal[i]).sum::<f64>() > 0.0
        };
        let found = self.tree.nearest(place, faces).or_else(|| self.tree.nearest(place, |_| true));
        let Some(found) = found else { return [0.0; 2] };
        let corners = self.uvs[found.triangle as usize];
        [0, 1].map(|axis| (0..3).map(|corner| found.weights[corner] * corners[corner][axis]).sum())
    }
}

/// Whether a layer of a document has a map by a picture: its index and the key.
#[must_use]
pub fn by_picture(document: &Document) -> Option<(usize, MapKey)> {
    let layers = document.layers.iter().enumerate();
    let mut all =
        layers.flat_map(|(index, layer)| layer.maps.iter().map(move |(key, map)| (index, key, map)));
    let is_picture = |map: &LayerMap| matches!(map.source, MapSource::Image { .. });
    all.find(|(.., map)| is_picture(map)).map(|(index, key, _)| (index, key))
}
