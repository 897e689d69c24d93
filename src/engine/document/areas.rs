//! Which layers scattered points make.

use crate::attributes::system::Family;
use crate::document::{After, AreaKind, Document, Layer, LineKind, Points, Stroke, SystemChoice};

impl Document {
    /// Whether scattered points make layer `index`: patches, cells, streaks, cracks or a field of points.
    #[must_use]
    pub fn is_of_points(&self, index: usize) -> bool {
        self.areas(index).is_some() || self.layers.get(index).is_some_and(Layer::is_of_points)
    }
}

impl Layer {
    /// Whether scattered points make it whatever its marks are; see [`Document::is_of_points`].
    #[must_use]
    pub fn is_of_points(&self) -> bool {
        self.areas().is_some() || self.system.kind().is_some_and(Family::is_scattered)
    }

    /// The areas that grow on it whatever its marks are, if any: its system says so, or it is `"auto"` and outlines are drawn, which are
    /// patches then. Irregular spots are Turing's, and spots inside others Meinhardt's, whatever they are drawn as. See
    /// [`Document::areas`].
    #[must_use]
    pub fn areas(&self) -> Option<AreaKind> {
        let has_outlines = || self.strokes.iter().any(|stroke| matches!(stroke, Stroke::Outline(_)));
        let can_be = self.after == After::Between && self.options.irregular == 0.0;
        match self.system {
            SystemChoice::Auto => (can_be && has_outlines()).then_some(AreaKind::Patches),
            SystemChoice::Stripes | SystemChoice::Of(_) => self.system.areas(),
        }
    }

    /// The lines of points that grow on it, if any: its system says so.
    #[must_use]
    pub fn point_lines(&self) -> Option<LineKind> {
        self.system.lines()
    }

    /// The field of points that grows on it, if any: its system says so. Defaults where the layer does not say more.
    #[must_use]
    pub fn point_field(&self) -> Option<Points> {
        (self.system.kind() == Some(Family::Points)).then(|| self.points.clone().unwrap_or_default())
    }
}
