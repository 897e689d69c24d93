//! The direction of the hair and the scales of a document.

use crate::attributes::free::FreeMap;
use crate::document::{Document, FlowChoice, Kind, Stroke};
use crate::finish::Flow;
use crate::grid::Edges;
use crate::marks::{Mark, Path};

/// Distance between two nodes at which directions are computed, px.
const APART: f32 = 12.0;

/// The direction of the hair and the scales of a document; `None` if it has none.
#[must_use]
pub fn flow_of(document: &Document) -> Option<Flow> {
    let finishing = document.finish.as_ref().filter(|finishing| finishing.finish.kind.has_flow())?;
    Some(of(document, &finishing.flow, document.size.map(f64::from)))
}

/// The directions on a canvas of `canvas` px.
pub(super) fn of(document: &Document, choice: &FlowChoice, canvas: [f64; 2]) -> Flow {
    let along = |strokes: &[Stroke]| {
        let marks: Vec<Mark> = strokes.iter().filter_map(Stroke::mark).collect();
        Directions::new(&marks, document)
    };
    let head_to_tail = || Flow::uniform(FlowChoice::HEAD_TO_TAIL);
    match choice {
        FlowChoice::Angle(angle) => Flow::uniform(*angle),
        FlowChoice::Strokes(strokes) => {
            along(strokes).map_or_else(head_to_tail, |strokes| strokes.flow(canvas, false))
        }
        FlowChoice::Usual => {
            let lowest = document.layers.iter().find(|layer| layer.visible);
            let stripes = lowest.filter(|layer| {
                Kind::of_layer(layer.strokes.iter().filter_map(Stroke::kind)) == Some(Kind::Line)
            });
            let stripes = stripes.and_then(|layer| along(&layer.strokes));
            stripes.map_or_else(head_to_tail, |stripes| stripes.flow(canvas, true))
        }
    }
}

/// Drawn lines as directions: between them as stripes turn between drawn lines.
struct Directions {
    /// Axial directions.
    map: FreeMap,
    /// Pieces of the lines, from → to, px of the document.
    pieces: Vec<[[f64; 2]; 2]>,
    size: [f64; 2],
    edges: Edges,
}

impl Directions {
    fn new(marks: &[Mark], document: &Document) -> Option<Self> {
        let size = document.size.map(f64::from);
        let paths: Vec<Path> = marks.iter().filter_map(Mark::path).collect();
        let pieces = paths.iter().flat_map(|path| path.points.windows(2).map(|ends| [ends[0], ends[1]]));
        let pieces: Vec<_> = pieces.collect();
        let map = FreeMap::from_marks(marks, size, document.edges).ok()?;
        Some(Self { map, pieces, size, edges: document.edges })
    }

    /// Directions along the lines, or across them, where that is nearer to the direction from head to tail.
    fn flow(&self, canvas: [f64; 2], across: bool) -> Flow {
        let stretch = [0, 1].map(|axis| self.size[axis] / canvas[axis]);
        Flow::nodes(canvas.map(|side| side as f32), self.edges, APART, |point| {
            let point = [point[0] * stretch[0], point[1] * stretch[1]];
            let [cos, sin] = self.map.double_angle_at(point);
            // Half the angle, of the two solutions that with x ≥ 0.
            let x = (0.5 * (1.0 + cos)).max(0.0).sqrt();
            let y = (0.5 * (1.0 - cos)).max(0.0).sqrt().copysign(sin);
            let axis = if across { [-y, x] } else { [x, y] };
            let [to_x, to_y] = if across { head_to_tail() } else { self.side(point) };
            if axis[0] * to_x + axis[1] * to_y < 0.0 { axis.map(|part| -part) } else { axis }
        })
    }

    /// The side to which the lines near a point lead: the sum of their pieces by the inverse of the squared distance.
    fn side(&self, point: [f64; 2]) -> [f64; 2] {
        let bounds = crate::grid::Bounds { size: self.size, edges: self.edges };
        let mut sum = [0.0; 2];
        for [from, to] in &self.pieces {
            let middle = [0, 1].map(|axis| 0.5 * (from[axis] + to[axis]) - point[axis]);
            let [x, y] = bounds.shortest(middle);
            let weight = 1.0 / (x * x + y * y + 1.0);
            sum = [0, 1].map(|axis| sum[axis] + weight * (to[axis] - from[axis]));
        }
        sum
    }
}

/// The direction from head to tail.
fn head_to_tail() -> [f64; 2] {
    let (sin, cos) = crate::grid::sin_cos_degrees(FlowChoice::HEAD_TO_TAIL);
    [cos, sin]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Finishing, Layer};
    use crate::finish::{Finish, Kind as Material};

    fn document(flow: FlowChoice, strokes: Vec<Stroke>) -> Document {
        let finish = Finishing { flow, ..Finish::new(Material::Fur).into() };
        Document { finish: Some(finish), ..Document::new([128, 128]).with_layer(Layer::new(strokes)) }
    }

    fn at(document: &Document, point: [f32; 2]) -> [f32; 2] {
        of(document, &document.finish.as_ref().unwrap().flow, [128.0; 2]).at(point)
    }

    #[test]
    fn hair_lies_along_the_strokes_and_in_their_direction() {
        let strokes = vec![
            Stroke::line([10.0, 60.0], [10.0, 20.0], 6.0),
            Stroke::line([118.0, 20.0], [118.0, 60.0], 6.0),
        ];
        let spot = vec![Stroke::ellipse([60.0, 60.0], [9.0, 9.0], 0.0)];
        let document = document(FlowChoice::Strokes(strokes), spot);
        let (left, right) = (at(&document, [12.0, 40.0]), at(&document, [116.0, 40.0]));
        assert!(left[1] < -0.99 && right[1] > 0.99, "{left:?} {right:?}");
    }

    #[test]
    fn hair_lies_across_drawn_stripes_and_otherwise_from_head_to_tail() {
        let stripe = |x| Stroke::line([x, 20.0], [x + 30.0, 100.0], 8.0);
        let striped = document(FlowChoice::Usual, vec![stripe(30.0), stripe(60.0)]);
        let [x, y] = at(&striped, [60.0, 60.0]);
        assert!((x * 30.0 + y * 80.0).abs() < 2.0 && x < 0.0, "{x} {y}");
        let spotted = document(FlowChoice::Usual, vec![Stroke::ellipse([60.0, 60.0], [9.0, 9.0], 0.0)]);
        let [x, y] = at(&spotted, [60.0, 60.0]);
        assert!((x + 0.985).abs() < 0.01 && (y + 0.174).abs() < 0.01, "{x} {y}");
    }
}
