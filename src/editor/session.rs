//! The open document: its marks, selection, undo history and whether it is saved.

use std::path::{Path, PathBuf};

mod combing;
mod drawing;
mod far_spacing;
mod layers;
mod moving;
mod split;
mod starting;

use crate::document::layer_rules::tidy;
use crate::document::{After, AreaKind, Document, Kind, Layer, Stroke};
use crate::editor::backdrop::Backdrop;
use crate::editor::freehand;
use crate::editor::history::{History, Snapshot};
use crate::editor::selection::{Place, Selection};
use crate::editor::shape;
use crate::grid::Bounds;
use crate::marks::Mark;

/// The open document while it is edited.
#[derive(Clone, Debug)]
pub struct Session {
    document: Document,
    /// The selected marks.
    pub selection: Selection,
    /// The layer that new marks go to, if it accepts their kind.
    pub active_layer: usize,
    /// How many of the lowest layers are frozen.
    frozen: usize,
    /// The file it was read from or saved to.
    pub path: Option<PathBuf>,
    history: History,
    /// The state after the last undo step.
    committed: Snapshot,
    /// The picture under the canvas, to draw over; it is not saved.
    backdrop: Option<Backdrop>,
    /// The document in the state in which the file holds it.
    saved: Document,
    /// The spacing that applies far from the ellipses of each layer, after the last undo step; `None` = not computed
    /// yet.
    far_spacing: Option<Vec<Option<f64>>>,
    /// The mark of each stroke, by layer and stroke; freehand strokes are fitted, `None` where that failed.
    marks: Vec<Vec<Option<Mark>>>,
    /// The kind of area that each layer grows, if it grows areas.
    areas: Vec<Option<AreaKind>>,
    /// Number of changes so far.
    revision: u64,
}

impl Default for Session {
    fn default() -> Self {
        Self::open(Document::default(), None)
    }
}

impl Session {
    /// Opens a document without unsaved changes; `path` is its file, `None` for a new document.
    #[must_use]
    pub fn open(document: Document, path: Option<PathBuf>) -> Self {
        let active_layer = document.layers.len().saturating_sub(1);
        let selection = Selection::default();
        let committed =
            Snapshot { document: document.clone(), selection, active_layer, frozen: 0, backdrop: None };
        let marks = fitted(&document, &Document::default(), &[]);
        let areas = areas(&document, &marks);
        Self {
            saved: document.clone(),
            document,
            selection: Selection::default(),
            active_layer,
            frozen: 0,
            path,
            history: History::default(),
            committed,
            backdrop: None,
            far_spacing: None,
            areas,
            marks,
            revision: 0,
        }
    }

    /// Whether nothing would grow: no marks, no picture that drives a layer, no field of points.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.document.layers.iter().all(Layer::is_blank)
    }

    /// Opens a document that differs from its file; `saved` is the document in the file.
    #[must_use]
    pub fn open_unsaved(document: Document, saved: Document, path: Option<PathBuf>) -> Self {
        Self { saved, ..Self::open(document, path) }
    }

    /// The document as it is edited; it may have empty layers.
    #[must_use]
    pub fn document(&self) -> &Document {
        &self.document
    }

    /// The document as it is saved and grown: empty layers are removed, unnamed layers get a name, and the lowest
    /// layer has no relation to a layer beneath.
    #[must_use]
    pub fn finished(&self) -> Document {
        let mut document = self.document.clone();
        for (index, layer) in document.layers.iter_mut().enumerate() {
            tidy(layer, self.kind(index));
        }
        let mut layers = document.layers.iter_mut().enumerate();
        if let Some((index, lowest)) = layers.find(|(_, layer)| !layer.is_blank()) {
            lowest.after = After::Between;
            tidy(lowest, self.kind(index));
        }
        document.layers.retain(|layer| !layer.is_blank());
        for (index, layer) in document.layers.iter_mut().enumerate() {
            if layer.name.is_empty() {
                layer.name = format!("layer {}", index + 1);
            }
        }
        document
    }

    /// A number that changes with every edit.
    #[must_use]
    pub fn revision(&self) -> u64 {
        self.revision
    }

    /// Changes the document. The next [`Self::commit`] makes the change an undo step. The spacing that applies far from
    /// all marks is stored with it, so that it need not change.
    pub fn edit(&mut self, change: impl FnOnce(&mut Document)) {
        let before = self.document.clone();
        change(&mut self.document);
        self.keep_far_spacing(&before);
        self.changed_from(&before);
    }

    /// Updates what depends on the document, after a change of the document `before`.
    fn changed_from(&mut self, before: &Document) {
        if self.document == *before {
            return;
        }
        self.revision += 1;
        self.marks = fitted(&self.document, before, &self.marks);
        self.areas = areas(&self.document, &self.marks);
        self.selection.retain_existing(&self.document);
    }

    /// Makes the changes since the last commit one undo step; returns whether there were any.
    pub fn commit(&mut self) -> bool {
        if !self.is_uncommitted() {
            self.committed.selection.clone_from(&self.selection);
            (self.committed.active_layer, self.committed.frozen) = (self.active_layer, self.frozen);
            return false;
        }
        self.far_spacing = None;
        let now = self.snapshot();
        self.history.push(std::mem::replace(&mut self.committed, now));
        true
    }

    /// Discards the changes since the last commit.
    pub fn revert(&mut self) {
        self.restore(self.committed.clone());
    }

    /// Undoes the last step.
    pub fn undo(&mut self) {
        self.commit();
        let snapshot = self.history.undo(self.committed.clone());
        self.restore(snapshot);
    }

    /// Redoes the step that was undone last.
    pub fn redo(&mut self) {
        if !self.commit() {
            let snapshot = self.history.redo(self.committed.clone());
            self.restore(snapshot);
        }
    }

    /// Whether there is something to undo, and something to redo.
    #[must_use]
    pub fn can_undo_redo(&self) -> [bool; 2] {
        let [undo, redo] = self.history.can_undo_redo();
        [undo || self.is_uncommitted(), redo]
    }

    /// Whether something has changed since the last undo step.
    fn is_uncommitted(&self) -> bool {
        self.document != self.committed.document || self.backdrop != self.committed.backdrop
    }

    /// The picture under the canvas.
    #[must_use]
    pub fn backdrop(&self) -> Option<&Backdrop> {
        self.backdrop.as_ref()
    }

    /// Changes the picture under the canvas. The next [`Self::commit`] makes the change an undo step.
    pub fn set_backdrop(&mut self, backdrop: Option<Backdrop>) {
        self.backdrop = backdrop;
    }

    /// Sets the picture with which the document was opened; that cannot be undone.
    pub fn open_backdrop(&mut self, backdrop: Option<Backdrop>) {
        self.committed.backdrop.clone_from(&backdrop);
        self.backdrop = backdrop;
    }

    fn snapshot(&self) -> Snapshot {
        Snapshot {
            document: self.document.clone(),
            selection: self.selection.clone(),
            active_layer: self.active_layer,
            frozen: self.frozen,
            backdrop: self.backdrop.clone(),
        }
    }

    fn restore(&mut self, snapshot: Snapshot) {
        let before = std::mem::replace(&mut self.document, snapshot.document.clone());
        self.changed_from(&before);
        self.far_spacing = None;
        self.selection.clone_from(&snapshot.selection);
        (self.active_layer, self.frozen) = (snapshot.active_layer, snapshot.frozen);
        self.backdrop.clone_from(&snapshot.backdrop);
        self.committed = snapshot;
    }

    /// Whether the document differs from its file.
    #[must_use]
    pub fn is_changed(&self) -> bool {
        self.document != self.saved
    }

    /// Records that `document`, an earlier state or the current one, was saved to `path`.
    pub fn mark_saved(&mut self, document: Document, path: &Path) {
        self.saved = document;
        self.path = Some(path.to_owned());
    }

    /// The name shown to the user: the file's name, else the document's, else `untitled`.
    #[must_use]
    pub fn title(&self) -> String {
        let file =
            self.path.as_deref().and_then(Path::file_name).map(|name| name.to_string_lossy().into_owned());
        file.unwrap_or_else(|| {
            if self.document.name.is_empty() { "untitled".to_owned() } else { self.document.name.clone() }
        })
    }

    /// The mark at a place.
    #[must_use]
    pub fn mark(&self, place: Place) -> Option<Mark> {
        self.marks.get(place.layer)?.get(place.stroke)?.clone()
    }

    /// All marks, those of the lowest layer first.
    pub fn marks(&self) -> impl DoubleEndedIterator<Item = (Place, Mark)> + '_ {
        self.marks.iter().enumerate().flat_map(|(layer, marks)| {
            marks
                .iter()
                .enumerate()
                .filter_map(move |(stroke, mark)| Some((Place { layer, stroke }, mark.clone()?)))
        })
    }

    /// The kind of area that a layer grows, if it does: because it says so, or because its marks are too dense for
    /// spots.
    #[must_use]
    pub fn areas(&self, layer: usize) -> Option<AreaKind> {
        self.areas.get(layer).copied().flatten()
    }

    /// What a closed stroke on a layer becomes: one of it, with its article, and several of it.
    #[must_use]
    pub fn closed_strokes(&self, layer: usize) -> [&'static str; 2] {
        match self.areas(layer) {
            Some(AreaKind::Polygons) => ["a cell", "cells"],
            Some(AreaKind::Patches) => ["a patch", "patches"],
            None => ["an ellipse", "ellipses"],
        }
    }

    /// The mark of each stroke, by layer and stroke; `None` for a stroke that is not a mark.
    #[must_use]
    pub fn fitted_marks(&self) -> &[Vec<Option<Mark>>] {
        &self.marks
    }

    /// The marks of one layer.
    #[must_use]
    pub fn marks_of(&self, layer: usize) -> Vec<Mark> {
        self.marks.get(layer).into_iter().flatten().flatten().cloned().collect()
    }

    /// The marks of one layer in the way in which they are read for growing: on a seamless canvas, marks whose centre
    /// is outside appear at the other side.
    #[must_use]
    pub fn marks_on_tile(&self, layer: usize) -> Vec<Mark> {
        let canvas = Bounds { size: self.document.size.map(f64::from), edges: self.document.edges };
        self.marks_of(layer).into_iter().map(|mark| mark.on_tile(&canvas)).collect()
    }

    /// The selected marks.
    pub fn selected(&self) -> impl Iterator<Item = (Place, Mark)> + '_ {
        self.selection.places().filter_map(|place| Some((place, self.mark(place)?)))
    }

    /// The kind of marks in a layer ([`Kind::of_layer`]); `None` where it is empty.
    #[must_use]
    pub fn kind(&self, layer: usize) -> Option<Kind> {
        Kind::of_layer(self.marks.get(layer)?.iter().flatten().map(Kind::from))
    }

    /// Replaces marks.
    pub fn replace(&mut self, marks: &[(Place, Mark)]) {
        let size = self.document.size;
        self.edit(|document| {
            for (place, mark) in marks {
                let stroke = document
                    .layers
                    .get_mut(place.layer)
                    .and_then(|layer| layer.strokes.get_mut(place.stroke));
                if let Some(stroke) = stroke {
                    let changed = stroke.changed(shape::bounded(mark, size));
                    if changed != *stroke {
                        *stroke = shape::within_limits(freehand::rounded(changed), size);
                    }
                }
            }
        });
    }

    /// Removes marks.
    pub fn remove(&mut self, places: &[Place]) {
        let mut places = places.to_vec();
        places.sort_unstable();
        self.edit(|document| {
            for place in places.iter().rev() {
                if let Some(layer) = document.layers.get_mut(place.layer)
                    && place.stroke < layer.strokes.len()
                {
                    layer.strokes.remove(place.stroke);
                }
            }
        });
        self.selection.clear();
    }

    /// The editable mark nearest to a point, at most `reach` px away. Of equally near marks, those of the active layer
    /// come first, then the topmost one.
    #[must_use]
    pub fn hit(&self, point: [f64; 2], reach: f64) -> Option<Place> {
        let near = self.editable_marks().rev().map(|(place, mark)| (place, shape::distance(&mark, point)));
        let near = near.filter(|(_, distance)| *distance <= reach);
        let order = |(place, distance): &(Place, f64)| (*distance, place.layer != self.active_layer);
        near.min_by(|a, b| {
            let (a, b) = (order(a), order(b));
            a.0.total_cmp(&b.0).then(a.1.cmp(&b.1))
        })
        .map(|(place, _)| place)
    }
}

/// The kind of area that each layer of `document` grows, if it does. The strokes have been fitted.
fn areas(document: &Document, marks: &[Vec<Option<Mark>>]) -> Vec<Option<AreaKind>> {
    marks.iter().enumerate().map(|(layer, marks)| document.areas_of(layer, marks)).collect()
}

/// The marks of `document`. Freehand strokes that did not change since `before` keep their fitted mark.
fn fitted(document: &Document, before: &Document, marks: &[Vec<Option<Mark>>]) -> Vec<Vec<Option<Mark>>> {
    let fit = |layer: usize, index: usize, stroke: &Stroke| {
        let is_same = || before.layers.get(layer).and_then(|layer| layer.strokes.get(index)) == Some(stroke);
        match marks.get(layer).and_then(|marks| marks.get(index)) {
            Some(known) if stroke.kind().is_none() && is_same() => known.clone(),
            _ => stroke.mark(),
        }
    };
    let layers = document.layers.iter().enumerate();
    layers
        .map(|(layer, drawn)| {
            drawn.strokes.iter().enumerate().map(|(i, stroke)| fit(layer, i, stroke)).collect()
        })
        .collect()
}
