//! Shapes → the strokes and areas that a pen draws, in their order.

use kurbo::{BezPath, Point, Shape as _};
use rayon::prelude::*;

use super::path::{cut, end, pieces, started_after};
use super::route::{self, Route, route};
use super::svg::Unit;
use super::{Hatch, Shape, hatch};

/// Accuracy of lengths, px.
const ACCURACY: f64 = 0.01;

/// Treatment of outlines at the border of the canvas.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Ends {
    /// Outlines are closed along the border.
    #[default]
    Closed,
    /// Outlines end at the border.
    Cut,
}

/// The way of drawing shapes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// Filled areas.
    pub fill: bool,
    /// Strokes along the outlines.
    pub stroke: bool,
    /// Parallel strokes in the areas.
    pub hatch: Option<Hatch>,
    /// Width of the pen, px: hatch lines end so far inside the outlines that the drawn area is the area of the shape.
    pub pen: f64,
    /// Treatment of strokes at the border.
    pub ends: Ends,
    /// Whether to search a short route.
    pub ordered: bool,
}

impl Default for Style {
    fn default() -> Self {
        Self { fill: true, stroke: false, hatch: None, pen: 0.0, ends: Ends::Closed, ordered: true }
    }
}

/// The drawing of one layer.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// The layer's name.
    pub name: String,
    /// Red, green, blue.
    pub colour: [u8; 3],
    /// Areas to fill, drawn first.
    pub areas: Vec<Shape>,
    /// Strokes, in order.
    pub strokes: Vec<BezPath>,
}

/// Distances that a pen moves, px. It starts at the canvas' upper left corner; areas count as their outlines.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Travel {
    /// Number of paths.
    pub paths: usize,
    /// Distance with the pen on the paper.
    pub down: f64,
    /// Distance with the pen lifted.
    pub up: f64,
    /// Distance with the pen lifted if the paths were drawn in the order found.
    pub up_unordered: f64,
}

/// Draws the shapes of layers (name, colour, shapes) on a canvas of `size` px.
#[must_use]
pub fn draw(
    layers: Vec<(String, [u8; 3], Vec<Shape>)>,
    size: [f64; 2],
    style: &Style,
) -> (Vec<Group>, Travel) {
    let mut travel = Travel::default();
    let mut pens = [Point::ORIGIN; 2];
    let mut groups = Vec::with_capacity(layers.len());
    for (name, colour, shapes) in layers {
        let mut group = Group { name, colour, areas: Vec::new(), strokes: Vec::new() };
        let strokes = strokes(&shapes, size, style);
        if style.fill {
            let found = shapes.clone();
            group.areas = if style.ordered { ordered(shapes, pens[0]) } else { shapes };
            travel.add(&rings(&group.areas), &rings(&found), &mut pens);
        }
        if style.ordered {
            let (found, from) = (strokes.clone(), pens[0]);
            group.strokes = route(strokes, from).paths;
            travel.add(&group.strokes, &found, &mut pens);
        } else {
            travel.add(&strokes, &strokes, &mut pens);
            group.strokes = strokes;
        }
        groups.push(group);
    }
    (groups, travel)
}

impl Travel {
    /// A summary such as `412 paths; the pen draws 3.10 m and travels 0.42 m in the air (2.90 m in the order found)`.
    #[must_use]
    pub fn text(&self, unit: Unit) -> String {
        let length = |px: f64| match unit {
            Unit::Px => format!("{px:.0} px"),
            Unit::Mm { .. } => format!("{:.2} m", px * unit.per_px() / 1000.0),
        };
        let Self { paths, down, up, up_unordered } = *self;
        format!(
            "{paths} paths; the pen draws {} and travels {} in the air ({} in the order found)",
            length(down),
            length(up),
            length(up_unordered)
        )
    }

    /// Adds the paths as `drawn` and, for comparison, as `found`; `pens` are the positions of both pens.
    fn add(&mut self, drawn: &[BezPath], found: &[BezPath], pens: &mut [Point; 2]) {
        self.paths += drawn.len();
        let lengths: Vec<f64> = drawn.par_iter().map(|path| path.perimeter(ACCURACY)).collect();
        self.down += lengths.iter().sum::<f64>();
        self.up += route::travel(pens[0], drawn);
        self.up_unordered += route::travel(pens[1], found);
        for (pen, paths) in pens.iter_mut().zip([drawn, found]) {
            *pen = paths.last().map_or(*pen, end);
        }
    }
}

fn rings(shapes: &[Shape]) -> Vec<BezPath> {
    shapes.iter().flat_map(Shape::paths).cloned().collect()
}

fn strokes(shapes: &[Shape], size: [f64; 2], style: &Style) -> Vec<BezPath> {
    let each = |shape: &Shape| {
        let mut strokes = Vec::new();
        if style.stroke {
            match style.ends {
                Ends::Closed => strokes.extend(shape.paths().cloned()),
                Ends::Cut => strokes.extend(shape.paths().flat_map(|path| cut(path, size))),
            }
        }
        strokes.extend(style.hatch.map(|lines| hatch(shape, lines, style.pen)).unwrap_or_default());
        strokes
    };
    shapes.par_iter().flat_map_iter(each).collect()
}

/// Shapes in an order with a short route between their outer boundaries; the holes of each follow its boundary.
fn ordered(shapes: Vec<Shape>, from: Point) -> Vec<Shape> {
    let (outers, holes): (Vec<BezPath>, Vec<Vec<BezPath>>) =
        shapes.into_iter().map(|shape| (shape.outer, shape.holes)).unzip();
    let mut holes: Vec<Option<Vec<BezPath>>> = holes.into_iter().map(Some).collect();
    let Route { order, paths } = route(outers, from);
    let with_holes = |(index, outer): (usize, BezPath)| {
        let pen = end(&outer);
        let mut holes = holes[index].take().unwrap_or_default();
        if holes.len() > 1 {
            holes = route(holes, pen).paths;
        } else if let Some(hole) = holes.pop() {
            let knots = pieces(&hole).iter().map(|piece| piece.end_point().unwrap_or_default());
            let nearest = knots.map(|knot| pen.distance(knot)).enumerate().min_by(|a, b| a.1.total_cmp(&b.1));
            holes.push(started_after(hole, nearest.map_or(0, |(i, _)| i + 1)));
        }
        Shape { outer, holes }
    };
    order.into_iter().zip(paths).map(with_holes).collect()
}
