//! New marks: to which layer they go, and which part of a freehand stroke is kept.

use super::Session;
use crate::document::{Document, Kind, Layer, Stroke, limits};
use crate::editor::freehand;
use crate::editor::selection::{Place, Selection};
use crate::editor::shape;
use crate::marks::Mark;
use crate::sketch::closed_outline;

impl Session {
    /// Adds marks and selects them. They go to the active layer if it accepts their kind, else to the highest layer
    /// that does, else to a new one.
    pub fn add(&mut self, marks: &[Mark]) {
        let drawn: Vec<(Mark, Stroke)> =
            marks.iter().map(|mark| (mark.clone(), Stroke::from(mark.clone()))).collect();
        self.add_drawn(&drawn);
    }

    /// Adds the mark that was recognised in a freehand stroke with these `points`, with its outline if it is closed,
    /// and selects it.
    pub fn add_freehand(&mut self, mark: Mark, points: &[[f64; 2]]) {
        let outline = closed_outline(points, limits::MAX_CORNERS).and_then(freehand::outline);
        let stroke = match (&mark, outline) {
            (Mark::Ellipse(ellipse), Some(outline)) => Stroke::Fitted { ellipse: *ellipse, outline },
            _ => Stroke::from(mark.clone()),
        };
        self.add_drawn(&[(mark, stroke)]);
    }

    /// Adds a closed freehand stroke with its own outline, and selects it, where the active layer grows areas whose
    /// outlines have any shape. Returns whether it did. Open strokes, and outlines that a document cannot hold, are
    /// left to [`Self::add_freehand`].
    pub fn add_outline(&mut self, points: &[[f64; 2]]) -> bool {
        let grows_areas = |layer: &Layer| layer.areas().is_some();
        if !self.document.layers.get(self.active_layer).is_some_and(grows_areas)
            || !self.accepts(self.active_layer, Kind::Ellipse)
        {
            return false;
        }
        let Some(corners) = closed_outline(points, limits::MAX_CORNERS) else { return false };
        let stroke =
            freehand::outline(corners.clone()).map_or_else(|| Stroke::outline(corners), Stroke::Outline);
        let stroke = shape::within_limits(stroke, self.document.size);
        let alone = Document::new(self.document.size).with_layer(Layer::new([stroke.clone()]));
        match stroke.mark().filter(|_| alone.check("the stroke").is_ok()) {
            Some(mark) => {
                self.add_drawn(&[(mark, stroke)]);
                true
            }
            None => false,
        }
    }

    /// Adds strokes, each together with the mark that it represents, to the layers that take such marks, and selects
    /// them.
    pub(in crate::editor) fn add_drawn(&mut self, drawn: &[(Mark, Stroke)]) {
        let size = self.document.size;
        let mut added = Vec::with_capacity(drawn.len());
        for (mark, drawn) in drawn {
            let layer = self.layer_for(Kind::from(mark));
            let stroke = self.document.layers.get(layer).map_or(0, |layer| layer.strokes.len());
            let stroke_of_it = shape::within_limits(drawn.changed(shape::bounded(mark, size)), size);
            self.edit(|document| {
                if layer == document.layers.len() {
                    document.layers.push(Layer::default());
                }
                document.layers[layer].strokes.push(stroke_of_it);
            });
            self.active_layer = layer;
            added.push(Place { layer, stroke });
        }
        self.selection = Selection::new(added);
    }

    /// The layer to which a mark of `kind` goes. The number of layers stands for a new layer.
    fn layer_for(&self, kind: Kind) -> usize {
        let accepts = |layer: usize| self.accepts(layer, kind);
        if accepts(self.active_layer) {
            return self.active_layer;
        }
        let layers = self.document.layers.len();
        (0..layers).rev().find(|layer| accepts(*layer) && self.kind(*layer) == Some(kind)).unwrap_or(layers)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{AreaKind, SystemChoice};
    use crate::sketch::recognise;
    use crate::synth::areas::plan::AreaPlan;

    /// The path of the pen through these corners, with one point every 4 px.
    fn drawn(corners: &[[f64; 2]]) -> Vec<[f64; 2]> {
        let mut points = vec![corners[0]];
        for pair in corners.windows(2) {
            let [x, y] = [0, 1].map(|axis| pair[1][axis] - pair[0][axis]);
            let steps = (x.hypot(y) / 4.0).ceil() as usize;
            let at = |k: usize| k as f64 / steps as f64;
            points.extend((1..=steps).map(|k| [pair[0][0] + at(k) * x, pair[0][1] + at(k) * y]));
        }
        points
    }

    fn add(session: &mut Session, points: &[[f64; 2]]) -> Mark {
        let mark = recognise(points, 6.0).expect("a mark");
        session.add_freehand(mark.clone(), points);
        mark
    }

    /// A square that goes over the right border of the canvas of 512 px.
    const SQUARE: [[f64; 2]; 5] =
        [[480.0, 360.0], [560.0, 360.0], [560.0, 440.0], [480.0, 440.0], [480.0, 360.0]];

    #[test]
    fn strokes_over_the_border_stay_where_they_were_drawn() {
        let straight = drawn(&[[450.0, 100.0], [642.0, 100.0]]);
        let hook = drawn(&[[420.0, 200.0], [520.0, 200.0], [520.0, 392.0]]);
        let round: Vec<[f64; 2]> = (0..=60)
            .map(|k| (std::f64::consts::TAU * f64::from(k) / 60.0).sin_cos())
            .map(|(s, c)| [520.0 + 30.0 * c, 400.0 + 20.0 * s])
            .collect();
        for points in [straight, hook, round, drawn(&SQUARE)] {
            let mut session = Session::default();
            let mark = add(&mut session, &points);
            assert_eq!(session.marks_of(0), [mark]);
            session.finished().check("the document").expect("it can be saved");
        }
    }

    #[test]
    fn a_closed_stroke_keeps_its_outline_while_it_is_moved_turned_and_scaled() {
        let mut session = Session::default();
        let mark = add(
            &mut session,
            &drawn(&SQUARE).iter().map(|[x, y]| [x - 300.0, y - 200.0]).collect::<Vec<_>>(),
        );
        let corners = |session: &Session| match &session.document().layers[0].strokes[0] {
            Stroke::Fitted { outline, .. } => outline.points.clone(),
            other => panic!("{other:?}"),
        };
        let before = corners(&session);
        assert!(before.iter().all(|[x, y]| (x - 220.0).abs().max((y - 200.0).abs()) < 43.0), "{before:?}");
        assert_eq!(session.document().layers[0].areas(), None, "it grows as the ellipse that it is read as");

        let pivot = mark.center();
        let turned = shape::turned(&mark, 30.0, pivot);
        let changed = shape::moved(&shape::scaled(&turned, 0.5, pivot), [30.0, -20.0]);
        session.replace(&[(Place { layer: 0, stroke: 0 }, changed.clone())]);
        assert_eq!(session.marks_of(0), [changed], "the ellipse is what was asked for, with all its digits");
        for (corner, [u, v]) in before.iter().zip(corners(&session)) {
            let [x, y] =
                shape::out_of_frame([0, 1].map(|axis| 0.5 * (corner[axis] - pivot[axis])), pivot, 30.0);
            assert!((u - x - 30.0).hypot(v - y + 20.0) < 1e-3, "{corner:?} {u} {v}");
            assert!([u, v].iter().all(|x| (1e3 * x - (1e3 * x).round()).abs() < 1e-6), "{u} {v}");
        }
        session.commit();
        session.undo();
        assert!(session.marks_of(0).is_empty());
    }

    #[test]
    fn a_freehand_stroke_of_a_file_keeps_its_outline_when_it_is_moved() {
        let points = drawn(&SQUARE).iter().map(|[x, y]| [x - 300.0, *y]).collect();
        let layer = Layer::new([Stroke::Freehand { points, width: 6.0 }]);
        let mut session = Session::open(Document::default().with_layer(layer), None);
        session.selection = Selection::new([Place { layer: 0, stroke: 0 }]);
        session.nudge([-10.0, 0.0]);
        let Stroke::Fitted { outline, .. } = &session.document().layers[0].strokes[0] else { panic!() };
        let left = outline.points.iter().map(|point| point[0]).fold(f64::INFINITY, f64::min);
        assert!((left - 170.0).abs() < 2.0, "{left}");
    }

    #[test]
    fn outlines_are_kept_where_patches_are_chosen_after_drawing() {
        let mut session = Session::default();
        let points: Vec<[f64; 2]> = drawn(&SQUARE).iter().map(|[x, y]| [x - 300.0, *y]).collect();
        add(&mut session, &points);
        let patches = SystemChoice::Of(AreaKind::Patches.description());
        session.edit(|document| document.layers[0].system = patches);
        let document = session.finished();
        let plan = AreaPlan::read(&document, 0, "a test", [512.0; 2], None).expect("a plan");
        let [(0, kept)] = &plan.kept[..] else { panic!("one is kept") };
        // The ellipse that was fitted to the square reaches beyond its sides, and does not reach into its corners.
        assert!((kept.area() / 6400.0 - 1.0).abs() < 0.02, "{}", kept.area());
        let [low, high] = kept.corners();
        assert!((low[0] - 180.0).abs() < 2.0 && (high[1] - 440.0).abs() < 2.0, "{low:?} {high:?}");
    }

    #[test]
    fn an_outline_has_no_more_corners_than_a_document_can_hold() {
        let many: Vec<[f64; 2]> = (0..40_000)
            .map(|k| (std::f64::consts::TAU * f64::from(k) / 39_999.0).sin_cos())
            .map(|(s, c)| [200.0 + 90.0 * c, 200.0 + 60.0 * s])
            .collect();
        let mut session = Session::default();
        add(&mut session, &many);
        assert!(matches!(&session.document().layers[0].strokes[0], Stroke::Fitted { .. }));
        session.finished().check("the document").expect("it can be saved");
        // A scribble that goes around several times does not enclose a single area.
        let scribble: Vec<[f64; 2]> = (0..400)
            .map(|k| (std::f64::consts::TAU * f64::from(k) / 90.0).sin_cos())
            .enumerate()
            .map(|(k, (s, c))| [300.0 + (40.0 + (k % 7) as f64) * c, 300.0 + 40.0 * s])
            .collect();
        add(&mut session, &scribble);
        session.finished().check("the document").expect("it can be saved");
    }
}
