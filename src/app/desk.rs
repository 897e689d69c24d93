//! The open document: what is on it, what is selected, what was done, whether it is saved.

use std::path::{Path, PathBuf};

mod layers;

use super::shape;
use crate::document::layer_rules::tidy;
use crate::document::{After, Document, Kind, Layer, Stroke};
use crate::editor::history::{History, Moment};
use crate::editor::selection::{Place, Selection};
use crate::marks::Mark;
use crate::sketch::recognise;

/// The open document.
#[derive(Clone, Debug)]
pub struct Desk {
    document: Document,
    /// What is selected.
    pub selection: Selection,
    /// The layer that new marks go to, if they are of its kind.
    pub layer: usize,
    /// How many of the lowest layers are frozen.
    frozen: usize,
    /// Where it is saved.
    pub path: Option<PathBuf>,
    history: History,
    /// As after the last step that can be undone.
    committed: Moment,
    /// As on the disk.
    saved: Document,
    /// By layer and stroke: what stands there, freehand strokes fitted.
    marks: Vec<Vec<Option<Mark>>>,
    /// Counts changes.
    revision: u64,
}

impl Default for Desk {
    fn default() -> Self {
        Self::open(Document::default(), None)
    }
}

impl Desk {
    /// A document, from a file or new.
    #[must_use]
    pub fn open(document: Document, path: Option<PathBuf>) -> Self {
        let layer = document.layers.len().saturating_sub(1);
        let committed =
            Moment { document: document.clone(), selection: Selection::default(), layer, frozen: 0 };
        let marks = fitted(&document, &Document::default(), &[]);
        Self {
            saved: document.clone(),
            document,
            selection: Selection::default(),
            layer,
            frozen: 0,
            path,
            history: History::default(),
            committed,
            marks,
            revision: 0,
        }
    }

    /// A document that was not saved, and what its file holds.
    #[must_use]
    pub fn recovered(document: Document, saved: Document, path: Option<PathBuf>) -> Self {
        Self { saved, ..Self::open(document, path) }
    }

    /// The document as it is drawn; it may have empty layers.
    #[must_use]
    pub fn document(&self) -> &Document {
        &self.document
    }

    /// The document as it is saved and grown: without empty layers, those without a name named as a file's are, and
    /// the lowest, which has nothing beneath it, meets nothing.
    #[must_use]
    pub fn finished(&self) -> Document {
        let mut document = self.document.clone();
        for (index, layer) in document.layers.iter_mut().enumerate() {
            tidy(layer, self.kind(index));
        }
        document.layers.retain(|layer| !layer.strokes.is_empty());
        if let Some(lowest) = document.layers.first_mut() {
            lowest.after = After::Between;
            lowest.options.broken = 0.0;
        }
        for (index, layer) in document.layers.iter_mut().enumerate() {
            if layer.name.is_empty() {
                layer.name = format!("layer {}", index + 1);
            }
        }
        document
    }

    /// Changes with every edit.
    #[must_use]
    pub fn revision(&self) -> u64 {
        self.revision
    }

    /// Changes the document. Becomes a step that can be undone with the next [`Self::commit`].
    pub fn edit(&mut self, change: impl FnOnce(&mut Document)) {
        let before = self.document.clone();
        change(&mut self.document);
        if self.document == before {
            return;
        }
        self.revision += 1;
        self.marks = fitted(&self.document, &before, &self.marks);
        self.selection.keep_within(&self.document);
    }

    /// Makes what was changed since the last commit one step that can be undone; gives whether there was any.
    pub fn commit(&mut self) -> bool {
        if self.document == self.committed.document {
            self.committed.selection.clone_from(&self.selection);
            (self.committed.layer, self.committed.frozen) = (self.layer, self.frozen);
            return false;
        }
        let now = self.moment();
        self.history.remember(std::mem::replace(&mut self.committed, now));
        true
    }

    /// Takes back what was changed since the last commit.
    pub fn revert(&mut self) {
        self.restore(self.committed.clone());
    }

    /// Undoes the last step.
    pub fn undo(&mut self) {
        self.commit();
        let moment = self.history.undo(self.committed.clone());
        self.restore(moment);
    }

    /// Does again what was undone.
    pub fn redo(&mut self) {
        if !self.commit() {
            let moment = self.history.redo(self.committed.clone());
            self.restore(moment);
        }
    }

    /// Is there something to undo, and to redo?
    #[must_use]
    pub fn can_undo_redo(&self) -> [bool; 2] {
        let [undo, redo] = self.history.can();
        [undo || self.document != self.committed.document, redo]
    }

    fn moment(&self) -> Moment {
        Moment {
            document: self.document.clone(),
            selection: self.selection.clone(),
            layer: self.layer,
            frozen: self.frozen,
        }
    }

    fn restore(&mut self, moment: Moment) {
        self.edit(|document| document.clone_from(&moment.document));
        self.selection.clone_from(&moment.selection);
        (self.layer, self.frozen) = (moment.layer, moment.frozen);
        self.committed = moment;
    }

    /// Is there something that the file does not have?
    #[must_use]
    pub fn is_changed(&self) -> bool {
        self.document != self.saved
    }

    /// It was saved to `path`.
    pub fn mark_saved(&mut self, path: &Path) {
        self.saved = self.document.clone();
        self.path = Some(path.to_owned());
    }

    /// What people call it: its file, or what it is named, or `untitled`.
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
        *self.marks.get(place.layer)?.get(place.stroke)?
    }

    /// All marks, those of the lowest layer first.
    pub fn marks(&self) -> impl DoubleEndedIterator<Item = (Place, Mark)> + '_ {
        self.marks.iter().enumerate().flat_map(|(layer, marks)| {
            marks
                .iter()
                .enumerate()
                .filter_map(move |(stroke, mark)| Some((Place { layer, stroke }, (*mark)?)))
        })
    }

    /// The marks of one layer.
    #[must_use]
    pub fn marks_of(&self, layer: usize) -> Vec<Mark> {
        self.marks.get(layer).into_iter().flatten().flatten().copied().collect()
    }

    /// The selected marks.
    pub fn selected(&self) -> impl Iterator<Item = (Place, Mark)> + '_ {
        self.selection.places().filter_map(|place| Some((place, self.mark(place)?)))
    }

    /// What a layer holds; `None` where it is empty.
    #[must_use]
    pub fn kind(&self, layer: usize) -> Option<Kind> {
        self.marks.get(layer)?.iter().flatten().next().map(kind_of)
    }

    /// Puts marks down and selects them: in the layer at hand if it holds such marks, else in the highest that does,
    /// else in a new one.
    pub fn add(&mut self, marks: &[Mark]) {
        let size = self.document.size;
        let mut added = Vec::with_capacity(marks.len());
        for mark in marks {
            let layer = self.layer_for(kind_of(mark));
            let stroke = self.document.layers.get(layer).map_or(0, |layer| layer.strokes.len());
            let mark = shape::bounded(mark, size);
            self.edit(|document| {
                if layer == document.layers.len() {
                    document.layers.push(Layer::default());
                }
                document.layers[layer].strokes.push(stroke_of(&mark));
            });
            self.layer = layer;
            added.push(Place { layer, stroke });
        }
        self.selection = Selection::of(added);
    }

    /// The layer that a mark of `kind` goes to; one more than there are = a new one.
    fn layer_for(&self, kind: Kind) -> usize {
        let takes = |layer: usize| self.takes(layer, kind);
        if takes(self.layer) {
            return self.layer;
        }
        let layers = self.document.layers.len();
        (0..layers).rev().find(|layer| takes(*layer) && self.kind(*layer).is_some()).unwrap_or(layers)
    }

    /// Puts other marks in the place of these.
    pub fn replace(&mut self, marks: &[(Place, Mark)]) {
        let size = self.document.size;
        self.edit(|document| {
            for (place, mark) in marks {
                let stroke = document
                    .layers
                    .get_mut(place.layer)
                    .and_then(|layer| layer.strokes.get_mut(place.stroke));
                if let Some(stroke) = stroke {
                    *stroke = stroke_of(&shape::bounded(mark, size));
                }
            }
        });
    }

    /// Takes marks away.
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

    /// Moves what is selected by `by` px, as far as all of it stays on the canvas.
    pub fn nudge(&mut self, by: [f64; 2]) {
        let before: Vec<_> = self.selected().collect();
        let by = self.within(&before, by);
        let moved: Vec<_> = before.iter().map(|(place, mark)| (*place, shape::moved(mark, by))).collect();
        self.replace(&moved);
    }

    /// `by`, or as much of it as keeps the middles of all marks on the canvas.
    #[must_use]
    pub fn within(&self, marks: &[(Place, Mark)], mut by: [f64; 2]) -> [f64; 2] {
        for (_, mark) in marks {
            let middle = shape::middle(mark);
            for axis in 0..2 {
                let side = f64::from(self.document.size[axis]);
                by[axis] = by[axis].clamp(-middle[axis].max(0.0), (side - middle[axis]).max(0.0));
            }
        }
        by
    }

    /// The nearest mark within `reach` px of a point that the hand can work on; of several there, one of the layer at
    /// hand, then the topmost.
    #[must_use]
    pub fn hit(&self, point: [f64; 2], reach: f64) -> Option<Place> {
        let near = self.reachable().rev().map(|(place, mark)| (place, shape::distance(&mark, point)));
        let near = near.filter(|(_, distance)| *distance <= reach);
        let order = |(place, distance): &(Place, f64)| (*distance, place.layer != self.layer);
        near.min_by(|a, b| {
            let (a, b) = (order(a), order(b));
            a.0.total_cmp(&b.0).then(a.1.cmp(&b.1))
        })
        .map(|(place, _)| place)
    }
}

/// What a mark is.
#[must_use]
pub fn kind_of(mark: &Mark) -> Kind {
    match mark {
        Mark::Ellipse(_) => Kind::Ellipse,
        Mark::Line(_) => Kind::Line,
    }
}

/// The stroke that stands for a mark.
#[must_use]
pub fn stroke_of(mark: &Mark) -> Stroke {
    match *mark {
        Mark::Ellipse(ellipse) => Stroke::Ellipse(ellipse),
        Mark::Line(line) => Stroke::Line(line),
    }
}

/// The marks of `document`; freehand strokes that stood in the same place `before` keep what they were fitted with.
fn fitted(document: &Document, before: &Document, marks: &[Vec<Option<Mark>>]) -> Vec<Vec<Option<Mark>>> {
    let fit = |layer: usize, index: usize, stroke: &Stroke| match stroke {
        Stroke::Ellipse(ellipse) => Some(Mark::Ellipse(*ellipse)),
        Stroke::Line(line) => Some(Mark::Line(*line)),
        Stroke::Freehand { points, width } => {
            let same = before.layers.get(layer).and_then(|layer| layer.strokes.get(index)) == Some(stroke);
            match marks.get(layer).and_then(|marks| marks.get(index)) {
                Some(known) if same => *known,
                _ => recognise(points, *width),
            }
        }
    };
    let layers = document.layers.iter().enumerate();
    layers
        .map(|(layer, of)| of.strokes.iter().enumerate().map(|(i, stroke)| fit(layer, i, stroke)).collect())
        .collect()
}
