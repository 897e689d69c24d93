//! Parametric surfaces over the canvas (`"model": {"height": …}`, `{"surface": …}`), by whose metric the flat texture is corrected.

use std::sync::Arc;

use crate::document::Problem;
use crate::document::limits;
use crate::document::node::Node;
use crate::document::shape::{Key, Object, Shape};
use crate::surface::HeightField;

/// A surface x(u) over the points u of the canvas. The attributes of the sketch hold on the surface; the canvas is its flat map.
#[derive(Clone, Debug, PartialEq)]
pub enum ParametricSurface {
    /// Heights over the canvas.
    Heights(Relief),
    /// A torus: the canvas goes once round its ring along x and once round its tube along y. The middle of the tube is as long as the
    /// canvas is wide, and the tube is as long around as the canvas is high. The canvas is wider than high, and its edges wrap.
    Torus,
}

/// A picture of heights that is stretched over the canvas.
#[derive(Clone, Debug, PartialEq)]
pub struct Relief {
    /// The path of the picture, relative to the folder of the document.
    pub path: String,
    /// Height of white above black, px.
    pub scale: f64,
    /// The heights in the picture, or the reason why they are not known.
    pub heights: Result<Arc<HeightField>, String>,
}

impl ParametricSurface {
    /// The name of a torus in documents.
    const TORUS: &'static str = "torus";

    /// Its name in messages.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Heights(_) => "heights",
            Self::Torus => Self::TORUS,
        }
    }

    /// The heights.
    #[must_use]
    pub fn relief(&self) -> Option<&Relief> {
        if let Self::Heights(relief) = self { Some(relief) } else { None }
    }
}

impl Relief {
    /// Heights in a picture that has not been read yet.
    #[must_use]
    pub fn new(path: String, scale: f64) -> Self {
        let heights = Err(format!("{path}, which was not looked for"));
        Self { path, scale, heights }
    }

    /// The heights.
    ///
    /// # Errors
    /// They are not known: the path, why, and what to do.
    pub fn heights(&self) -> Result<&HeightField, Problem> {
        let allowed = "a picture of heights (.png, .tif and others) beside the document";
        let heights = self.heights.as_deref();
        heights.map_err(|found| Problem::new("model.height", found.clone(), allowed))
    }
}

pub(super) static HEIGHTS: Object = Object {
    name: "Height field",
    keys: &[
        Key::new(
            "height",
            Shape::Text([1, limits::MAX_NAME]),
            Key::REQUIRED,
            "a picture of heights, relative to the folder of the document; stretched over the canvas",
        ),
        Key::new(
            "scale",
            Shape::Number(limits::RELIEF),
            Key::REQUIRED,
            "by how many px white is higher than black",
        ),
    ],
};

pub(super) static SURFACE: Object = Object {
    name: "Surface",
    keys: &[Key::new(
        "surface",
        Shape::Choice(|| vec![ParametricSurface::TORUS]),
        Key::REQUIRED,
        "the surface of which the canvas is the flat map",
    )],
};

/// The parametric surface of a model; `None` for other models.
pub(super) fn read(node: &Node) -> Result<Option<ParametricSurface>, Problem> {
    if let Some(surface) = node.get("surface") {
        node.is(&SURFACE)?;
        return surface.choice(&[(ParametricSurface::TORUS, ())]).map(|()| Some(ParametricSurface::Torus));
    }
    if node.get("height").is_none() && node.get("scale").is_none() {
        return Ok(None);
    }
    node.is(&HEIGHTS)?;
    let allowed =
        format!("the path of a picture beside the document, of 1 to {} characters", limits::MAX_NAME);
    let height = node.need("height", &allowed)?;
    let path = height.text(&allowed)?;
    if !(1..=limits::MAX_NAME).contains(&path.chars().count()) {
        return Err(height.wrong(allowed));
    }
    let scale = node.need("scale", "px by which white is higher than black")?.number(&limits::RELIEF)?;
    Ok(Some(ParametricSurface::Heights(Relief::new(path.to_owned(), scale))))
}
