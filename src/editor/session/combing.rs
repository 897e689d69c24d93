//! The strokes that comb hair and scales: the flow of the finish.

use super::Session;
use crate::document::limits::Range;
use crate::document::{Finishing, FlowChoice, Stroke};
use crate::marks::{Path, distance_to_segment};

/// Width of a stroke of hair, px: only its direction counts.
const WIDTH: f64 = 6.0;
/// Points within this distance of a line between others are left out, px.
const FINE: f64 = 0.3;

impl Session {
    /// Whether the finish of the document has a direction that strokes on the canvas can give: not on a model.
    #[must_use]
    pub fn can_comb(&self) -> bool {
        let has_flow = |finishing: &Finishing| finishing.finish.kind.has_flow();
        self.document.model.is_none() && self.document.finish.as_ref().is_some_and(has_flow)
    }

    /// The strokes of hair, each with its points, px.
    pub fn hair(&self) -> impl Iterator<Item = Path> {
        let flow = self.document.finish.as_ref().map(|finishing| &finishing.flow);
        let strokes = match flow {
            Some(FlowChoice::Strokes(strokes)) => &strokes[..],
            _ => &[],
        };
        strokes.iter().filter_map(|stroke| stroke.mark()?.path())
    }

    /// Adds a stroke of hair from the first of these points to the last one, in place of an angle. Returns whether it did: the finish
    /// must have a direction, and the stroke a length.
    pub fn comb(&mut self, points: &[[f64; 2]]) -> bool {
        let [low, high] = Range::around_canvas(self.document.size);
        let rounded = |point: [f64; 2]| {
            [0, 1].map(|axis| (10.0 * point[axis].clamp(low[axis], high[axis])).round() / 10.0)
        };
        let path = Path { points: points.to_vec(), width: WIDTH };
        let mut points: Vec<[f64; 2]> = match points.len() {
            0..2 => return false,
            _ => path.simplified(FINE).points.into_iter().map(rounded).collect(),
        };
        points.dedup();
        if points.len() < 2 || !self.can_comb() {
            return false;
        }
        self.edit(|document| {
            let Some(finishing) = &mut document.finish else { return };
            let stroke = Stroke::path(points, WIDTH);
            match &mut finishing.flow {
                FlowChoice::Strokes(strokes) => strokes.push(stroke),
                flow => *flow = FlowChoice::Strokes(vec![stroke]),
            }
        });
        true
    }

    /// Removes the strokes of hair that come within `reach` px of the way between two points. Without any left the direction is the
    /// usual one.
    pub fn uncomb(&mut self, [from, to]: [[f64; 2]; 2], reach: f64) {
        let steps = ((to[0] - from[0]).hypot(to[1] - from[1]) / reach).ceil().max(1.0) as usize;
        let places: Vec<[f64; 2]> = (0..=steps)
            .map(|step| [0, 1].map(|axis| from[axis] + step as f64 / steps as f64 * (to[axis] - from[axis])))
            .collect();
        let is_near = |path: &Path| {
            let mut sides = path.points.windows(2).map(|ends| [ends[0], ends[1]]);
            sides.any(|side| places.iter().any(|place| distance_to_segment(*place, side) <= reach))
        };
        self.edit(|document| {
            let Some(finishing) = &mut document.finish else { return };
            if let FlowChoice::Strokes(strokes) = &mut finishing.flow {
                strokes.retain(|stroke| {
                    !stroke.mark().and_then(|mark| mark.path()).is_some_and(|path| is_near(&path))
                });
                if strokes.is_empty() {
                    finishing.flow = FlowChoice::Usual;
                }
            }
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Body, BodySource, Document, Finish, FinishKind, Layer};

    fn session(kind: FinishKind) -> Session {
        let finish = Some(Finishing { flow: FlowChoice::Angle(30.0), ..Finish::new(kind).into() });
        let spot = Stroke::ellipse([60.0, 60.0], [14.0, 10.0], 20.0);
        let document = Document { finish, ..Document::new([200, 100]).with_layer(Layer::new([spot])) };
        Session::open(document, None)
    }

    #[test]
    fn strokes_of_hair_are_drawn_erased_and_undone_one_by_one() {
        let mut session = session(FinishKind::Fur);
        let before = session.document().clone();
        for y in [20.0, 60.0] {
            assert!(session.comb(&[[180.0, y], [100.0, y + 0.01], [20.0, y + 10.0]]));
            session.commit();
        }
        let found: Vec<Path> = session.hair().collect();
        assert_eq!((found.len(), found[0].points[0]), (2, [180.0, 20.0]));
        assert_eq!(Document::parse(&session.document().to_json(), "a").unwrap(), *session.document());
        session.uncomb([[100.0, 0.0], [100.0, 30.0]], 4.0);
        session.commit();
        assert_eq!(session.hair().map(|path| path.points[0]).collect::<Vec<_>>(), [[180.0, 60.0]]);
        session.uncomb([[100.0, 50.0], [100.0, 80.0]], 4.0);
        assert_eq!(session.document().finish.as_ref().unwrap().flow, FlowChoice::Usual);
        session.commit();
        for _ in 0..4 {
            session.undo();
        }
        assert_eq!(*session.document(), before);
    }

    #[test]
    fn only_finishes_with_a_direction_are_combed_and_a_click_combs_nothing() {
        let points = [[10.0, 10.0], [90.0, 10.0]];
        assert!(!session(FinishKind::Cloth).comb(&points));
        let mut fur = session(FinishKind::Fur);
        assert!(!fur.comb(&[[10.0, 10.0]]) && !fur.comb(&[[10.0, 10.0], [10.01, 10.0]]));
        assert!(fur.comb(&points));
        let body = Body::new(BodySource::BuiltIn("sphere"));
        let on_model = Document { model: Some(body), ..session(FinishKind::Fur).document().clone() };
        assert!(!Session::open(on_model, None).comb(&points));
    }
}
