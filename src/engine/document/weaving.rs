//! Lines that cross → a weave, where the system is chosen automatically.

use crate::attributes::direction_groups::{CROSSING, direction_groups};
use crate::document::layer_rules::{Beneath, Combination};
use crate::document::{Document, Kind, Layer, Stroke, SystemChoice};
use crate::grid::Bounds;
use crate::marks::{Line, Mark, Path, turn};
use crate::rd::pairs::{MOST_PAIRS, PairKind};

/// Two lines cross where each extends beyond the other, on both sides, by this multiple of the other's width and by this share of its own
/// length. A line that extends less was meant to end there (chevrons, T-joints, rays), and was drawn a little too far. Of 100
/// T-joints drawn by hand without sight of the other line, 5 count as crossing; 14 did with 1.5 widths and 0.08.
const BEYOND: (f64, f64) = (2.0, 0.1);
/// Length over which the [`direction`] of a line is measured to both sides of a crossing, in widths of the line. Three widths in
/// all are longer than the unsteadiness of the hand, and shorter than the bends of drawn lines.
const ABOUT: f64 = 1.5;

impl Document {
    /// The system of pairs that grows layer `index`: the one that is asked for, or a weave where the system is chosen automatically
    /// and drawn lines cross; `None` for all other layers.
    ///
    /// Lines cross where both go on, at 30° or more, in two to five directions. A layer is not a weave if it has an `after` or an
    /// option that [`layer_rules`](super::layer_rules) refuses for a weave, or if it states whether its marks are kept.
    #[must_use]
    pub fn pairs(&self, index: usize) -> Option<PairKind> {
        let layer = self.layers.get(index)?;
        // Fitting strokes takes long; only layers that may weave need it.
        let fits = layer.system == SystemChoice::Auto && may_weave(layer);
        let marks: Vec<Option<Mark>> = layer.strokes.iter().filter(|_| fits).map(Stroke::mark).collect();
        self.pairs_of(layer, &marks)
    }

    /// The system of pairs that grows `layer`, see [`Self::pairs`]. `marks` are the fitted marks of its strokes, `None` for a
    /// stroke that is no mark.
    #[must_use]
    pub fn pairs_of(&self, layer: &Layer, marks: &[Option<Mark>]) -> Option<PairKind> {
        match layer.system {
            SystemChoice::Auto => weaves(self, layer, marks).then_some(PairKind::Weave),
            SystemChoice::Stripes | SystemChoice::Of(_) => layer.system.pairs(),
        }
    }
}

/// Whether the layer breaks no rule if it grows a weave.
fn may_weave(layer: &Layer) -> bool {
    let weave = SystemChoice::Of(PairKind::Weave.description());
    let combination = Combination::new(layer, Some(Kind::Line), Beneath::Unknown);
    // Threads always run through the drawn lines. Documents of version 1, which knew no weaves, say whether theirs are kept.
    layer.options.keep.is_none() && Combination { system: weave, ..combination }.broken_rule().is_none()
}

/// Whether the lines among these marks cross, and can be a weave.
fn weaves(document: &Document, layer: &Layer, marks: &[Option<Mark>]) -> bool {
    let lines: Vec<Path> = marks.iter().flatten().filter_map(Mark::path).collect();
    let crosses = |index: usize| lines[..index].iter().any(|other| cross(&lines[index], other));
    may_weave(layer) && (0..lines.len()).any(crosses) && can_weave(document, &lines)
}

/// Whether these lines have the largest number of directions in one place that a weave can have.
#[must_use]
pub(super) fn can_weave(document: &Document, lines: &[Path]) -> bool {
    let bounds = Bounds { size: document.size.map(f64::from), edges: document.edges };
    (2..=MOST_PAIRS).contains(&direction_groups(lines, &bounds).len())
}

/// Whether two lines cross at an angle of [`CROSSING`] or more where both go on.
fn cross(a: &Path, b: &Path) -> bool {
    if !a.may_touch(b) {
        return false;
    }
    let goes_on = |path: &Path, along: f64, other: &Path| {
        let length = path.length();
        along.min(length - along) >= (BEYOND.0 * other.width).max(BEYOND.1 * length)
    };
    let is_weave = |[on_a, on_b]: &[f64; 2]| {
        let turned = turn(direction(a, *on_a), direction(b, *on_b)).abs();
        turned >= CROSSING && goes_on(a, *on_a, b) && goes_on(b, *on_b, a)
    };
    a.crossings_along(b).iter().any(is_weave)
}

/// The direction of a path near a place `along` it (px), degrees: that of the piece that extends [`ABOUT`] widths to both sides.
/// The length averages out the unsteadiness of the hand.
fn direction(path: &Path, along: f64) -> f64 {
    let (length, half) = (path.length(), ABOUT * path.width);
    let [from, to] = [along - half, along + half].map(|at| path.at(at / length).point);
    Line { from, to, width: path.width }.angle()
}
