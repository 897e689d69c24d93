//! Copy, paste and duplicate; selecting and changing several marks. The clipboard holds a document as text.

use crate::document::{Document, DocumentError, Layer, LayerMaps, Stroke};
use crate::editor::selection::{Place, Selection};
use crate::editor::session::Session;
use crate::editor::shape;
use crate::marks::{Line, Mark, Path};

impl Session {
    /// The selected marks as a separate document; `None` where nothing is selected.
    #[must_use]
    pub fn copy(&self) -> Option<String> {
        let source = self.document();
        let selected = |layer: usize| {
            let strokes = source.layers[layer].strokes.iter().enumerate();
            strokes.filter(move |(stroke, _)| self.selection.contains(Place { layer, stroke: *stroke }))
        };
        let layers = (0..source.layers.len()).map(|layer| {
            let strokes = selected(layer).map(|(_, stroke)| stroke.clone()).collect();
            // Only the marks are copied, not the pictures that drive their layer.
            Layer { strokes, tone: None, maps: LayerMaps::default(), ..source.layers[layer].clone() }
        });
        let layers: Vec<Layer> = layers.filter(|layer| !layer.strokes.is_empty()).collect();
        (!layers.is_empty()).then(|| Document { layers, ..source.clone() }.to_json())
    }

    /// Adds the marks of a document in `text` and selects them. Their common midpoint is put at `at` (px) if that is
    /// given; otherwise they are moved by `step` px. Where they would lie exactly on identical marks, they are moved by
    /// further steps.
    ///
    /// # Errors
    /// Where the text is not a document.
    pub fn paste(&mut self, text: &str, at: Option<[f64; 2]>, step: [f64; 2]) -> Result<(), DocumentError> {
        self.paste_document(Document::parse(text, "the clipboard")?, at, step);
        Ok(())
    }

    /// Adds the marks of `document` and selects them, placed as [`Self::paste`] places them. Returns how many there are.
    pub fn paste_document(&mut self, document: Document, at: Option<[f64; 2]>, step: [f64; 2]) -> usize {
        let pasted = Self::open(document, None);
        let marks: Vec<(Place, Mark)> = pasted.marks().collect();
        let by = match (at, shape::extent(marks.iter().map(|(_, mark)| mark))) {
            (Some(at), Some([low, high])) => [0, 1].map(|axis| at[axis] - 0.5 * (low[axis] + high[axis])),
            _ => step,
        };
        let strokes = strokes_of(pasted.document(), &marks);
        self.add_copies(&marks, &strokes, by, step);
        marks.len()
    }

    /// Adds `marks`, drawn as `strokes`, and selects them. They are moved by `by` px as far as all of them stay on the
    /// canvas, and by further `step`s until none lies exactly on an identical mark.
    fn add_copies(&mut self, marks: &[(Place, Mark)], strokes: &[Stroke], by: [f64; 2], step: [f64; 2]) {
        /// Attempts in each direction; more would leave most canvases.
        const ATTEMPTS: i32 = 40;
        let own: Vec<Mark> = self.marks().map(|(_, mark)| mark).collect();
        let there: Vec<[f64; 2]> = own.iter().map(shape::center).collect();
        let at = |times: i32| {
            let by = [0, 1].map(|axis| by[axis] + f64::from(times) * step[axis]);
            let by = self.limit_copies(marks, by);
            marks.iter().map(|(_, mark)| shape::moved(mark, by)).collect::<Vec<_>>()
        };
        let near = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]) < 0.01;
        let is_double = |copy: &Mark| there.iter().any(|center| near(*center, shape::center(copy)));
        let times = (0..ATTEMPTS).flat_map(|times| [times, -times]);
        let free = times.map(at).find(|copies| !copies.iter().any(is_double));
        let copies = free.unwrap_or_else(|| at(0));
        if !copies.is_empty() {
            self.add_drawn(&copies.into_iter().zip(strokes.iter().cloned()).collect::<Vec<_>>());
        }
    }

    /// The part of the move `by` (px) that takes no centre of the `marks` over the border, so that copies can be seen.
    fn limit_copies(&self, marks: &[(Place, Mark)], mut by: [f64; 2]) -> [f64; 2] {
        for (_, mark) in marks {
            let center = shape::center(mark);
            for axis in 0..2 {
                let side = f64::from(self.document().size[axis]);
                by[axis] = by[axis].clamp(-center[axis].max(0.0), (side - center[axis]).max(0.0));
            }
        }
        by
    }

    /// Adds a copy of each selected mark, moved by `by` px as far as all copies stay on the canvas, and selects the
    /// copies.
    pub fn duplicate(&mut self, by: [f64; 2]) {
        let marks: Vec<(Place, Mark)> = self.selected().collect();
        let strokes = strokes_of(self.document(), &marks);
        self.add_copies(&marks, &strokes, by, by);
    }

    /// Adds a copy of each selected mark where it is, and selects the copies.
    pub fn add_copies_in_place(&mut self) {
        let marks: Vec<(Place, Mark)> = self.selected().collect();
        let strokes = strokes_of(self.document(), &marks);
        self.add_drawn(&marks.into_iter().map(|(_, mark)| mark).zip(strokes).collect::<Vec<_>>());
    }

    /// Removes the selected marks.
    pub fn delete_selected(&mut self) {
        let places: Vec<Place> = self.selection.places().collect();
        self.remove(&places);
    }

    /// Selects all editable marks.
    pub fn select_all(&mut self) {
        self.selection = Selection::new(self.editable_marks().map(|(place, _)| place));
    }

    /// Selects the editable mark that comes `step` places after the first selected one; after the last mark comes the
    /// first. Returns whether there is any.
    pub fn select_next(&mut self, step: isize) -> bool {
        let places: Vec<Place> = self.editable_marks().map(|(place, _)| place).collect();
        if places.is_empty() {
            return false;
        }
        let current = self.selection.places().next();
        let index = current.and_then(|current| places.iter().position(|place| *place == current));
        let n = places.len() as isize;
        let next =
            index.map_or(if step > 0 { 0 } else { n - 1 }, |index| (index as isize + step).rem_euclid(n));
        let place = places[next as usize];
        self.selection = Selection::new([place]);
        self.active_layer = place.layer;
        true
    }

    /// Changes the width of each selected line, and the size of each selected ellipse, by a factor.
    pub fn widen(&mut self, factor: f64) {
        self.change_each(|mark, center| match mark {
            Mark::Ellipse(_) => shape::scaled(mark, factor, center),
            Mark::Line(line) => Mark::Line(Line { width: factor * line.width, ..*line }),
            Mark::Path(path) => Mark::Path(Path { width: factor * path.width, ..path.clone() }),
        });
    }

    /// Changes each selected mark; `change` gets the mark and its centre.
    pub fn change_each(&mut self, change: impl Fn(&Mark, [f64; 2]) -> Mark) {
        let marks: Vec<(Place, Mark)> = self.selected().collect();
        let changed: Vec<_> =
            marks.iter().map(|(place, mark)| (*place, change(mark, shape::center(mark)))).collect();
        self.replace(&changed);
    }
}

/// What was drawn at the places of these marks.
fn strokes_of(document: &Document, marks: &[(Place, Mark)]) -> Vec<Stroke> {
    marks.iter().map(|(place, _)| document.layers[place.layer].strokes[place.stroke].clone()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::marks::Ellipse;

    fn spot(x: f64) -> Mark {
        Mark::Ellipse(Ellipse { center: [x, 50.0], radii: [12.0, 8.0], angle: 0.0 })
    }

    /// The x coordinates of the selected marks, px.
    fn selected(session: &Session) -> Vec<f64> {
        session.selected().map(|(_, mark)| mark.center()[0]).collect()
    }

    fn three() -> Session {
        let mut session = Session::default();
        session.add(&[spot(20.0), spot(60.0), spot(100.0)]);
        session
    }

    #[test]
    fn copied_marks_are_pasted_into_another_document() {
        let mut session = three();
        session.selection = Selection::new([0, 2].map(|stroke| Place { layer: 0, stroke }));
        let text = session.copy().unwrap();
        let mut other = Session::default();
        other.paste(&text, None, [5.0, 0.0]).unwrap();
        assert_eq!(selected(&other), [25.0, 105.0]);
        other.paste(&text, Some([200.0, 50.0]), [5.0, 0.0]).unwrap();
        assert_eq!(selected(&other), [160.0, 240.0]);
        // Pasted at the same place again, the marks are put beside those that are there.
        other.paste(&text, Some([200.0, 50.0]), [5.0, 0.0]).unwrap();
        assert_eq!(selected(&other), [165.0, 245.0]);
        assert!(other.paste("a shopping list", None, [0.0; 2]).is_err());
        other.selection.clear();
        assert_eq!(other.copy(), None);
    }

    #[test]
    fn copies_stay_on_the_canvas_and_are_selected() {
        let mut session = Session::default();
        session.add(&[spot(500.0)]);
        session.duplicate([30.0, 0.0]);
        assert_eq!((selected(&session), session.marks().count()), (vec![512.0], 2));
        // There is no more room to the right.
        session.duplicate([30.0, 0.0]);
        assert_eq!(selected(&session), [482.0]);
        session.delete_selected();
        assert_eq!((session.marks().count(), session.selection.len()), (2, 0));
    }

    #[test]
    fn after_the_last_mark_the_first_one_is_selected() {
        let mut session = three();
        session.select_all();
        assert_eq!(session.selection.len(), 3);
        session.selection.clear();
        assert!(session.select_next(-1));
        assert_eq!(selected(&session), [100.0]);
        assert!(session.select_next(1));
        assert_eq!(selected(&session), [20.0]);
        assert!(!Session::default().select_next(1));
    }
}
