//! Keeps the spacing far from all marks constant while marks are changed.
//!
//! Without this, the spacing that follows from the marks, which is rounded to steps, would sometimes change by a step,
//! and all spots far away would get new places.

use super::Session;
use crate::attributes::free::far_spacing;
use crate::document::{Document, Layer, limits, tile};
use crate::machine::threads;
use crate::marks::Mark;

/// With more marks than this, the spacing hardly changes when some of them change, and computing it takes longer than a
/// frame.
const MOST: usize = 100;

impl Session {
    /// Sets, on each layer whose strokes differ from the document `before`, the spacing far from the marks to the one
    /// after the last undo step. Intermediate states during a drag do not count.
    pub(super) fn keep_far_spacing(&mut self, before: &Document) {
        let layers = self.document.layers.len();
        if layers != before.layers.len() || self.document.regions.is_some() {
            return;
        }
        for index in 0..layers {
            let (now, was) = (&self.document.layers[index], &before.layers[index]);
            if now.strokes == was.strokes || now.far_spacing != was.far_spacing {
                continue;
            }
            // In a thread of its own: the window must not wait for others in the pool that the whole program shares.
            let compute = || threads::with(Some(1), || all_far_spacings(before, &self.marks));
            let known = self.far_spacing.get_or_insert_with(compute);
            let known = known.get(index).copied().flatten();
            let spacing = match self.committed.document.layers.get(index) {
                // Nothing has changed, so there is nothing to undo.
                Some(committed) if committed.strokes == now.strokes => committed.far_spacing,
                _ => known.filter(|_| now.strokes.len() > 1),
            };
            self.document.layers[index].far_spacing = spacing;
        }
    }
}

/// The spacing far from the ellipses of each layer of `document`, whose strokes represent `marks`.
fn all_far_spacings(document: &Document, marks: &[Vec<Option<Mark>>]) -> Vec<Option<f64>> {
    let size = document.size.map(f64::from);
    if tile::is_too_narrow(size, document.edges) {
        return vec![None; document.layers.len()];
    }
    let layers = document.layers.iter().zip(marks);
    let of_layer = |(layer, marks): (&Layer, &Vec<Option<Mark>>)| {
        let ellipses = marks.iter().flatten().filter_map(Mark::ellipse);
        let centers: Vec<[f64; 2]> = ellipses.map(|ellipse| ellipse.center).collect();
        if centers.len() > MOST {
            return None;
        }
        let spacing = far_spacing(&centers, size, document.edges, layer.far_spacing);
        spacing.filter(|spacing| limits::FAR_SPACING.holds(*spacing))
    };
    layers.map(of_layer).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Stroke;
    use crate::editor::selection::{Place, Selection};

    /// Five spots drawn as by hand, about 40 px apart.
    fn session() -> Session {
        let centers = [[60.0, 62.0], [103.0, 57.0], [139.0, 64.0], [82.0, 97.0], [118.0, 93.0]];
        let strokes = centers.map(|center| Stroke::ellipse(center, [9.0, 7.0], 20.0));
        let document = Document::new([512, 512]).with_layer(Layer::new(strokes));
        Session::open(document, None)
    }

    fn move_mark(session: &mut Session, stroke: usize, by: [f64; 2]) {
        session.selection = Selection::new(vec![Place { layer: 0, stroke }]);
        session.nudge(by);
    }

    fn kept(session: &Session) -> Option<f64> {
        session.document().layers[0].far_spacing
    }

    #[test]
    fn the_spacing_far_from_all_marks_stays_while_marks_are_moved() {
        let mut session = session();
        assert_eq!(kept(&session), None);
        move_mark(&mut session, 1, [3.0, 2.0]);
        session.commit();
        let first = kept(&session);
        assert!(first.is_some_and(|spacing| (36.0..45.0).contains(&spacing)), "{first:?}");
        for (stroke, by) in [(0, [-4.0, 3.0]), (3, [2.0, 4.0]), (4, [3.0, -2.0]), (0, [5.0, -3.0])] {
            move_mark(&mut session, stroke, by);
            session.commit();
            assert_eq!(kept(&session), first);
        }
    }

    #[test]
    fn the_spacing_changes_once_the_marks_differ_much_from_it() {
        let mut session = session();
        move_mark(&mut session, 1, [1.0, 0.0]);
        session.commit();
        let first = kept(&session).expect("five marks");
        // Farther apart by a half: the next change finds that the kept spacing no longer fits.
        let farther: Vec<_> = session
            .marks()
            .map(|(place, mark)| {
                let [x, y] = mark.center();
                (place, mark.shifted([0.5 * x, 0.5 * y]))
            })
            .collect();
        session.replace(&farther);
        session.commit();
        move_mark(&mut session, 1, [1.0, 0.0]);
        let now = kept(&session).expect("five marks");
        assert!(now > 1.3 * first, "{now} after {first}");
    }

    #[test]
    fn intermediate_places_of_a_dragged_mark_do_not_count() {
        let (mut there, mut back) = (session(), session());
        move_mark(&mut there, 0, [-2.0, 3.0]);
        for by in [[-40.0, -40.0], [200.0, 100.0], [-162.0, -57.0]] {
            move_mark(&mut back, 0, by);
        }
        assert_eq!(kept(&there), kept(&back));
    }

    #[test]
    fn a_mark_that_returns_to_its_place_is_no_change() {
        let mut session = session();
        move_mark(&mut session, 0, [5.0, 0.0]);
        assert!(session.is_changed());
        move_mark(&mut session, 0, [-5.0, 0.0]);
        assert!(!session.is_changed() && !session.commit());
    }

    #[test]
    fn undo_brings_back_the_document_as_it_was() {
        let mut session = session();
        let before = session.document().clone();
        move_mark(&mut session, 2, [4.0, 4.0]);
        session.commit();
        let after = session.document().clone();
        session.undo();
        assert_eq!(*session.document(), before);
        session.redo();
        assert_eq!(*session.document(), after);
    }

    #[test]
    fn a_single_mark_sets_no_spacing() {
        let mut session = session();
        let places: Vec<Place> = (1..5).map(|stroke| Place { layer: 0, stroke }).collect();
        session.remove(&places);
        assert_eq!(kept(&session), None);
    }
}
