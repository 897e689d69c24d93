//! Aligning and distributing the selected marks.

use crate::editor::selection::Place;
use crate::editor::session::Session;
use crate::editor::shape;
use crate::marks::Mark;

impl Session {
    /// Puts the centres of the selected marks on one line: the same x (`axis` 0) or the same y (1), their mean.
    pub fn align(&mut self, axis: usize) {
        let marks: Vec<(Place, Mark)> = self.selected().collect();
        let mean = marks.iter().map(|(_, mark)| mark.center()[axis]).sum::<f64>() / marks.len().max(1) as f64;
        let to: Vec<f64> = vec![mean; marks.len()];
        self.put(&marks, axis, &to);
    }

    /// Makes the distances between the centres of the selected marks equal, along x (`axis` 0) or y (1); the outermost two
    /// stay.
    pub fn distribute(&mut self, axis: usize) {
        let mut marks: Vec<(Place, Mark)> = self.selected().collect();
        let at = |mark: &(Place, Mark)| mark.1.center()[axis];
        marks.sort_by(|a, b| at(a).total_cmp(&at(b)));
        let (Some(first), Some(last)) = (marks.first().map(at), marks.last().map(at)) else { return };
        let gaps = (marks.len() - 1).max(1) as f64;
        let to: Vec<f64> = (0..marks.len()).map(|k| first + (last - first) * k as f64 / gaps).collect();
        self.put(&marks, axis, &to);
    }

    fn put(&mut self, marks: &[(Place, Mark)], axis: usize, to: &[f64]) {
        let moved = marks.iter().zip(to).map(|((place, mark), to)| {
            let mut by = [0.0; 2];
            by[axis] = to - mark.center()[axis];
            (*place, shape::moved(mark, by))
        });
        let moved: Vec<_> = moved.collect();
        self.replace(&moved);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::marks::Ellipse;

    fn at(places: &[[f64; 2]]) -> Session {
        let mut session = Session::default();
        let spot =
            |center: &[f64; 2]| Mark::Ellipse(Ellipse { center: *center, radii: [9.0, 5.0], angle: 20.0 });
        session.add(&places.iter().map(spot).collect::<Vec<_>>());
        session
    }

    fn centers(session: &Session) -> Vec<[f64; 2]> {
        session.marks().map(|(_, mark)| mark.center()).collect()
    }

    #[test]
    fn marks_are_put_on_one_line_and_at_equal_distances() {
        let mut session = at(&[[100.0, 40.0], [20.0, 60.0], [30.0, 50.0]]);
        session.align(1);
        assert_eq!(centers(&session), [[100.0, 50.0], [20.0, 50.0], [30.0, 50.0]]);
        session.distribute(0);
        assert_eq!(centers(&session), [[100.0, 50.0], [20.0, 50.0], [60.0, 50.0]]);
        session.selection.clear();
        session.distribute(0);
        session.align(0);
        assert_eq!(centers(&session).len(), 3);
    }
}
