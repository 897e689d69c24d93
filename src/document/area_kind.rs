//! What grows as areas: marks with outlines of their own, each with its place.

use crate::attributes::system::Description;
use crate::document::{After, Layer, Stroke, SystemChoice};
use crate::points::patches::PATCHES;
use crate::rd::pairs::cells::CELLS;

/// What a layer of areas grows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AreaKind {
    /// Patches of scattered points.
    Patches,
    /// Cells side by side, parted by lines.
    Cells,
}

impl AreaKind {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Patches, Self::Cells];

    /// What the rest of the program has to know of it.
    #[must_use]
    pub const fn description(self) -> &'static Description {
        match self {
            Self::Patches => &PATCHES,
            Self::Cells => &CELLS,
        }
    }
}

impl Layer {
    /// The areas that grow on it, if any: its system says so, or it is `"auto"` and outlines are drawn, which are patches then. Irregular
    /// spots are Turing's, and spots inside others Meinhardt's, whatever they are drawn as.
    #[must_use]
    pub fn areas(&self) -> Option<AreaKind> {
        let has_outlines = || self.strokes.iter().any(|stroke| matches!(stroke, Stroke::Outline(_)));
        let can_be = self.after == After::Between && self.options.irregular == 0.0;
        match self.system {
            SystemChoice::Areas(kind) => Some(kind),
            SystemChoice::Auto => (can_be && has_outlines()).then_some(AreaKind::Patches),
            SystemChoice::Stripes | SystemChoice::Of(_) | SystemChoice::Pairs(_) => None,
        }
    }
}
