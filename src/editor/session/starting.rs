//! Beginning a sketch with the layers of another document.

use super::Session;
use crate::document::{Document, Layer, Stroke};
use crate::editor::{freehand, shape};
use crate::marks::Mark;

impl Session {
    /// Replaces the layers by those of `other`, enlarged or reduced to this canvas, around its centre. Size, edges, regions
    /// and resolution of the canvas stay. The next [`Self::commit`] makes this a step that can be undone.
    pub fn begin_with(&mut self, other: Document) {
        let size = self.document().size;
        let shorter = |size: [u32; 2]| f64::from(size[0].min(size[1]));
        let factor = shorter(size) / shorter(other.size);
        let [from, to] = [other.size, size].map(|size| size.map(|side| 0.5 * f64::from(side)));
        let by = [0, 1].map(|axis| to[axis] - from[axis]);
        let fitted = |stroke: Stroke, mark: &Option<Mark>| match mark {
            Some(mark) => {
                let mark = shape::moved(&shape::scaled(mark, factor, from), by);
                let changed = stroke.changed(shape::bounded(&mark, size));
                shape::within_limits(freehand::rounded(changed), size)
            }
            None => stroke,
        };
        let marks = Self::open(other.clone(), None).marks;
        let layers: Vec<Layer> = other
            .layers
            .into_iter()
            .zip(marks)
            .map(|(layer, marks)| {
                let strokes = layer.strokes.into_iter().zip(&marks);
                Layer { strokes: strokes.map(|(stroke, mark)| fitted(stroke, mark)).collect(), ..layer }
            })
            .collect();
        self.edit(|document| document.layers = layers);
        self.active_layer = self.document().layers.len().saturating_sub(1);
    }

    /// Takes size, edges, seed, layers and finish of `other`, whose maps and materials have sizes in px of its own canvas. Name and
    /// resolution stay. The next [`Self::commit`] makes this a step that can be undone.
    pub fn begin_as(&mut self, other: Document) {
        self.edit(|document| {
            let (name, dpi) = (std::mem::take(&mut document.name), document.dpi);
            *document = Document { name, dpi, ..other };
        });
        self.active_layer = self.document().layers.len().saturating_sub(1);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;
    use crate::marks::Ellipse;

    #[test]
    fn a_tile_replaces_the_canvas_with_its_finish_and_one_undo_brings_it_back() {
        let finish = Some(crate::document::Finish::new(crate::document::FinishKind::Fur).into());
        let ellipse = Ellipse { center: [100.0, 50.0], radii: [10.0, 5.0], angle: 30.0 };
        let layer = Layer { strokes: vec![Stroke::Ellipse(ellipse)], ..Layer::default() };
        let size = [200, 100];
        let tile = Document {
            size,
            edges: Edges::Wrap,
            finish,
            seed: 9,
            layers: vec![layer],
            ..Document::default()
        };
        let canvas =
            Document { size: [400, 300], dpi: 150.0, name: "mine".to_owned(), ..Document::default() };
        let mut session = Session::open(canvas.clone(), None);
        session.begin_as(tile.clone());
        session.commit();
        assert_eq!(*session.document(), Document { dpi: 150.0, name: "mine".to_owned(), ..tile });
        session.undo();
        assert_eq!(*session.document(), canvas);
    }

    #[test]
    fn the_layers_are_fitted_to_a_canvas_that_stays_and_one_undo_removes_them() {
        let ellipse = Ellipse { center: [100.0, 50.0], radii: [10.0, 5.0], angle: 30.0 };
        let layer = Layer { strokes: vec![Stroke::Ellipse(ellipse)], ..Layer::default() };
        let other = Document { size: [200, 100], layers: vec![layer], ..Document::default() };
        let canvas = Document { size: [400, 300], edges: Edges::Wrap, dpi: 150.0, ..Document::default() };
        let mut session = Session::open(canvas.clone(), None);
        session.begin_with(other);
        session.commit();
        let [Some(Mark::Ellipse(found))] = session.fitted_marks()[0][..] else { panic!("one ellipse") };
        assert_eq!((found.center, found.radii, found.angle), ([200.0, 150.0], [30.0, 15.0], 30.0));
        let document = session.document();
        assert_eq!((document.size, document.edges, document.dpi), (canvas.size, canvas.edges, canvas.dpi));
        session.undo();
        assert_eq!(*session.document(), canvas);
    }
}
