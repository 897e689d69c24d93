//! The part of a sketch that a small picture of its texture shows: marks are as large there as they need to be to be seen.

use crate::document::{Document, Labels, Layer, MapKey, MapSource, Progression, Stroke};
use crate::editor::{freehand, shape};
use crate::marks::Mark;

/// Side of the part ÷ the size of a mark: the diameter of an ellipse, the period of lines as wide as their gaps.
const ACROSS: f64 = 16.0;
/// The largest such side: where marks are farther apart, fewer of them are shown.
const WIDEST: f64 = 40.0;
/// The fewest marks of the layer that the part holds, or two thirds of them, where they are not too far apart.
const FEWEST: usize = 6;
/// The smallest side, px.
const LEAST: f64 = 160.0;
/// Growth of the side until the part holds enough marks.
const STEP: f64 = 1.4;
/// A part that is larger than this share of the canvas along both sides is the whole canvas.
const NEARLY_ALL: f64 = 0.8;
/// The most places of the part that are compared.
const PLACES: usize = 64;

/// A rectangle of the canvas: its left upper corner and its size, px, and the number of its regions.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Part {
    corner: [f64; 2],
    size: [f64; 2],
    regions: Option<[u32; 2]>,
}

/// The part of `document` in which most marks of layer `index` are, as a document; all of it where it is small, or where a picture
/// or a surface covers the whole canvas. It has no starred textures and no material.
#[must_use]
pub fn part(document: &Document, index: usize) -> Document {
    let whole = Document { starred: Vec::new(), finish: None, ..document.clone() };
    let marks: Vec<Vec<Option<Mark>>> =
        document.layers.iter().map(|layer| layer.strokes.iter().map(Stroke::mark).collect()).collect();
    let Some(part) =
        marks.get(index).filter(|_| !is_one_piece(document)).and_then(|marks| best(document, marks))
    else {
        return whole;
    };
    let size = part.size.map(|side| side.round().max(1.0) as u32);
    let by = part.corner.map(|at| -at);
    let layers = whole.layers.iter().zip(&marks).map(|(layer, marks)| cut(layer, marks, by, size)).collect();
    Document { size, regions: part.regions, edges: crate::grid::Edges::Closed, layers, ..whole }
}

/// Whether something belongs to the canvas as a whole.
fn is_one_piece(document: &Document) -> bool {
    let is_drawn_over = |layer: &Layer| {
        let of_map = |key: MapKey| {
            layer.maps.get(key).is_some_and(|map| matches!(map.source, MapSource::Image { .. }))
        };
        let of_points = layer.points.as_ref().is_some_and(|points| {
            matches!(points.labels, Labels::Image { .. })
                || matches!(points.progression, Progression::Image(_))
        });
        layer.tone.is_some() || of_points || MapKey::ALL.into_iter().any(of_map)
    };
    document.model.is_some() || document.parametric.is_some() || document.layers.iter().any(is_drawn_over)
}

/// The part that holds most of these marks; `None` for the whole canvas.
fn best(document: &Document, marks: &[Option<Mark>]) -> Option<Part> {
    let marks: Vec<&Mark> = marks.iter().flatten().collect();
    let mut sizes: Vec<f64> = marks.iter().map(|mark| size_of(mark)).collect();
    sizes.sort_by(f64::total_cmp);
    let usual = *sizes.get(sizes.len() / 2)?;
    let (mut side, widest) = ((ACROSS * usual).max(LEAST), (WIDEST * usual).max(LEAST));
    loop {
        let canvas = document.size.map(f64::from);
        let places = places(document, side, &marks);
        let count = |part: &Part| marks.iter().filter(|mark| part.holds(mark.center())).count();
        let found =
            places.into_iter().map(|part| (count(&part), part)).reduce(|a, b| if b.0 > a.0 { b } else { a });
        let (count, part) = found?;
        if (0..2).all(|axis| part.size[axis] >= NEARLY_ALL * canvas[axis]) {
            return None;
        }
        if count >= FEWEST.min((2 * marks.len()).div_ceil(3)) || side >= widest {
            return Some(part);
        }
        side = (STEP * side).min(widest);
    }
}

fn size_of(mark: &Mark) -> f64 {
    match mark {
        Mark::Ellipse(ellipse) => 2.0 * (ellipse.radii[0] * ellipse.radii[1]).sqrt(),
        Mark::Line(line) => 2.0 * line.width,
        Mark::Path(path) => 2.0 * path.width,
    }
}

/// Parts of about this `side`: around marks, or of whole regions.
fn places(document: &Document, side: f64, marks: &[&Mark]) -> Vec<Part> {
    let canvas = document.size.map(f64::from);
    let Some(regions) = document.regions else {
        let size = canvas.map(|whole| side.min(whole));
        let step = marks.len().div_ceil(PLACES).max(1);
        let around = |mark: &&Mark| {
            let center = mark.center();
            let corner =
                [0, 1].map(|axis| (center[axis] - 0.5 * size[axis]).clamp(0.0, canvas[axis] - size[axis]));
            Part { corner: corner.map(f64::round), size, regions: None }
        };
        return marks.iter().step_by(step).map(around).collect();
    };
    let one = [0, 1].map(|axis| canvas[axis] / f64::from(regions[axis]));
    let count = [0, 1].map(|axis| ((side / one[axis]).ceil() as u32).clamp(1, regions[axis]));
    let size = [0, 1].map(|axis| one[axis] * f64::from(count[axis]));
    let at = |column: u32, row: u32| {
        let corner = [one[0] * f64::from(column), one[1] * f64::from(row)];
        Part { corner, size, regions: Some(count) }
    };
    let rows = 0..=regions[1] - count[1];
    rows.flat_map(|row| (0..=regions[0] - count[0]).map(move |column| at(column, row))).collect()
}

impl Part {
    fn holds(&self, point: [f64; 2]) -> bool {
        (0..2).all(|axis| (self.corner[axis]..=self.corner[axis] + self.size[axis]).contains(&point[axis]))
    }
}

/// The layer with the marks that lie on the part, moved `by`; where none does, with the nearest one at its border.
fn cut(layer: &Layer, marks: &[Option<Mark>], by: [f64; 2], size: [u32; 2]) -> Layer {
    let canvas = size.map(f64::from);
    let both = layer.strokes.iter().zip(marks);
    let all: Vec<(&Stroke, Mark)> =
        both.filter_map(|(stroke, mark)| Some((stroke, mark.as_ref()?.shifted(by)))).collect();
    let far = |(_, mark): &&(&Stroke, Mark)| {
        let center = mark.center();
        (center[0] - 0.5 * canvas[0]).hypot(center[1] - 0.5 * canvas[1])
    };
    let on: Vec<&(&Stroke, Mark)> = all.iter().filter(|(_, mark)| mark.is_on(canvas)).collect();
    let kept = match on.is_empty() {
        true => all.iter().min_by(|a, b| far(a).total_cmp(&far(b))).into_iter().collect(),
        false => on,
    };
    let strokes = kept.into_iter().map(|(stroke, mark)| {
        let changed = stroke.changed(shape::bounded(mark, size));
        shape::within_limits(freehand::rounded(changed), size)
    });
    Layer { strokes: strokes.collect(), ..layer.clone() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::marks::{Ellipse, Line};

    fn spot(center: [f64; 2]) -> Stroke {
        Stroke::Ellipse(Ellipse { center, radii: [6.0, 6.0], angle: 0.0 })
    }

    fn document(size: [u32; 2], layers: Vec<Vec<Stroke>>) -> Document {
        let layers = layers.into_iter().map(|strokes| Layer { strokes, ..Layer::default() }).collect();
        Document { size, layers, ..Document::default() }
    }

    /// Seven spots near each other, and one far away.
    fn cluster() -> Vec<Stroke> {
        let near = (0..7).map(|k| spot([600.0 + 20.0 * f64::from(k), 700.0]));
        std::iter::once(spot([50.0, 50.0])).chain(near).collect()
    }

    #[test]
    fn the_part_lies_where_most_marks_are_and_they_keep_their_size() {
        let part = part(&document([1000, 1000], vec![cluster()]), 0);
        assert_eq!(part.size, [192, 192]);
        let marks: Vec<Mark> = part.layers[0].strokes.iter().filter_map(Stroke::mark).collect();
        assert_eq!(marks.len(), 7);
        assert!(marks.iter().all(|mark| mark.ellipse().is_some_and(|of| of.radii == [6.0, 6.0])));
        part.check("the part").unwrap();
    }

    #[test]
    fn a_small_canvas_is_shown_whole() {
        let all = document([200, 200], vec![cluster().into_iter().take(1).collect()]);
        assert_eq!(part(&all, 0), all);
    }

    #[test]
    fn a_layer_without_marks_on_the_part_keeps_its_nearest_mark() {
        let line = Stroke::Line(Line { from: [20.0, 20.0], to: [60.0, 20.0], width: 4.0 });
        let part = part(&document([1000, 1000], vec![cluster(), vec![line]]), 0);
        assert_eq!(part.layers[1].strokes.len(), 1);
        part.check("the part").unwrap();
    }

    #[test]
    fn regions_are_shown_whole() {
        let all = Document { regions: Some([5, 4]), ..document([1000, 1000], vec![cluster()]) };
        let part = part(&all, 0);
        assert_eq!((part.size, part.regions), ([200, 250], Some([1, 1])));
        assert_eq!(part.layers[0].strokes.len(), 7);
        part.check("the part").unwrap();
    }
}
