//! Moves marks so that some part of each stays on the canvas.

use super::Session;
use crate::editor::selection::Place;
use crate::editor::shape;
use crate::marks::Mark;

impl Session {
    /// Moves the selected marks by `by` px, or less, so that none of them leaves the canvas.
    pub fn nudge(&mut self, by: [f64; 2]) {
        let before: Vec<_> = self.selected().collect();
        let by = self.limit_move(&before, by);
        let moved: Vec<_> = before.iter().map(|(place, mark)| (*place, shape::moved(mark, by))).collect();
        self.replace(&moved);
    }

    /// The part of the move `by` (px) that keeps some part of each of the `marks` on the canvas.
    #[must_use]
    pub fn limit_move(&self, marks: &[(Place, Mark)], mut by: [f64; 2]) -> [f64; 2] {
        let size = self.document.size.map(f64::from);
        for (_, mark) in marks {
            let ([low, high], reach) = (shape::extent_of(mark), shape::reach(mark));
            for axis in 0..2 {
                let side = size[axis];
                // The bounding box of the mark stays on the canvas, and the ends of the mark stay where a document can
                // hold them.
                let back = (high[axis] - shape::SEEN).min(reach[0][axis] + side).max(0.0);
                let on = (side - shape::SEEN - low[axis]).min(2.0 * side - reach[1][axis]).max(0.0);
                by[axis] = by[axis].clamp(-back, on);
            }
        }
        let leaves = |share: f64| {
            let there = |mark: &Mark| shape::moved(mark, by.map(|by| share * by));
            marks.iter().any(|(_, mark)| mark.is_on(size) && !there(mark).is_on(size))
        };
        // At a corner, the bounding box is still on the canvas when the mark is not.
        if leaves(1.0) {
            let last = 1.0 - shape::least_share(|back| !leaves(1.0 - back));
            by = by.map(|by| last * by);
        }
        by
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::marks::{Ellipse, Line};

    fn spot(center: [f64; 2]) -> Mark {
        Mark::Ellipse(Ellipse { center, radii: [20.0, 20.0], angle: 0.0 })
    }

    fn center(session: &Session, mark: usize) -> [f64; 2] {
        session.marks_of(0)[mark].center()
    }

    #[test]
    fn a_mark_is_moved_over_the_border_until_little_of_it_is_on_the_canvas() {
        let mut session = Session::default();
        session.add(&[spot([30.0, 200.0])]);
        session.nudge([-40.0, 0.0]);
        assert_eq!(center(&session, 0), [-10.0, 200.0]);
        session.nudge([-400.0, 15.0]);
        assert_eq!(center(&session, 0), [-19.0, 215.0]);
        // At a corner, the bounding box is still on the canvas when the mark is not.
        session.nudge([0.0, -900.0]);
        let [x, y] = center(&session, 0);
        assert!((x.hypot(y) - 20.0).abs() < 1.5 && x < 0.0, "{x} {y}");
        assert!(session.marks_of(0)[0].is_on([512.0; 2]));
        session.finished().check("the document").expect("it can be saved");
        session.nudge([100.0, 300.0]);
        assert_eq!(center(&session, 0), [x + 100.0, y + 300.0]);
    }

    #[test]
    fn marks_that_are_moved_together_stop_together() {
        let mut session = Session::default();
        let line = Mark::Line(Line { from: [100.0, 50.0], to: [300.0, 50.0], width: 8.0 });
        session.add(&[line, Mark::Line(Line { from: [100.0, 90.0], to: [300.0, 250.0], width: 8.0 })]);
        session.nudge([0.0, -500.0]);
        assert_eq!([center(&session, 0)[1], center(&session, 1)[1]], [-3.0, 117.0]);
    }
}
