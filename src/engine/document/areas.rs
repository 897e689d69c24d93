//! Test for layers that are made from scattered points.

use crate::attributes::system::Family;
use crate::document::{AreaKind, Document, Layer, LineKind, Points, Stroke, SystemChoice};

impl Document {
    /// Whether layer `index` is made from scattered points: patches, cells, streaks, cracks or a field of points.
    #[must_use]
    pub fn is_of_points(&self, index: usize) -> bool {
        self.areas(index).is_some() || self.layers.get(index).is_some_and(Layer::is_of_points)
    }
}

impl Layer {
    /// Whether the layer is made from scattered points whatever its marks are; see [`Document::is_of_points`].
    #[must_use]
    pub fn is_of_points(&self) -> bool {
        self.areas().is_some() || self.system.kind().is_some_and(Family::is_scattered)
    }

    /// The kind of areas that the layer grows whatever its marks are: that of its system, or patches if the system is `"auto"` and
    /// outlines are drawn. `None` for a system of other marks. With `"auto"`, irregular spots always grow by Turing's system, and
    /// spots inside others by Meinhardt's, even if outlines are drawn. See [`Document::areas`].
    #[must_use]
    pub fn areas(&self) -> Option<AreaKind> {
        let has_outlines = || self.strokes.iter().any(|stroke| matches!(stroke, Stroke::Outline(_)));
        let can_be = self.after.keeps_away() && self.options.irregular == 0.0;
        match self.system {
            SystemChoice::Auto => (can_be && has_outlines()).then_some(AreaKind::Patches),
            SystemChoice::Stripes | SystemChoice::Of(_) => self.system.areas(),
        }
    }

    /// The kind of lines that the layer grows from points; `None` if its system is not one of these.
    #[must_use]
    pub fn point_lines(&self) -> Option<LineKind> {
        self.system.lines()
    }

    /// The field of points that the layer grows, with defaults where the layer has no `points`; `None` if its system is not a field
    /// of points.
    #[must_use]
    pub fn point_field(&self) -> Option<Points> {
        (self.system.kind() == Some(Family::Points)).then(|| self.points.clone().unwrap_or_default())
    }
}
