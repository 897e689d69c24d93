//! Shapes → what a pen draws, in which order.

use rayon::prelude::*;

use super::path::{Path, distance};
use super::route::{Route, route, travel};
use super::svg::Unit;
use super::{Hatch, Shape, hatch};

/// What happens to marks at the border of the canvas.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Ends {
    /// Their outlines are closed along it.
    #[default]
    Closed,
    /// Their outlines end at it.
    Cut,
}

/// How shapes are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// Filled areas.
    pub fill: bool,
    /// Strokes along the outlines.
    pub stroke: bool,
    /// Parallel strokes in the areas.
    pub hatch: Option<Hatch>,
    /// What happens to strokes at the border.
    pub ends: Ends,
    /// Whether to look for a short way.
    pub ordered: bool,
}

impl Default for Style {
    fn default() -> Self {
        Self { fill: true, stroke: false, hatch: None, ends: Ends::Closed, ordered: true }
    }
}

/// What is drawn of a layer.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// The layer's name.
    pub name: String,
    /// Red, green, blue.
    pub colour: [u8; 3],
    /// Areas to fill, drawn first.
    pub areas: Vec<Shape>,
    /// Strokes, in order.
    pub strokes: Vec<Path>,
}

/// What a pen does, px. It begins at the canvas' upper left corner; areas count as their outlines.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Travel {
    /// Paths.
    pub paths: usize,
    /// On the paper.
    pub down: f64,
    /// In the air.
    pub up: f64,
    /// In the air if the paths were drawn as they were found.
    pub up_unordered: f64,
}

/// Draws the shapes of layers (name, colour, shapes) on a canvas of `size` px.
#[must_use]
pub fn draw(
    layers: Vec<(String, [u8; 3], Vec<Shape>)>,
    size: [f64; 2],
    style: &Style,
) -> (Vec<Group>, Travel) {
    let mut done = Travel::default();
    let mut pens = [[0.0, 0.0]; 2];
    let mut groups = Vec::with_capacity(layers.len());
    for (name, colour, shapes) in layers {
        let mut group = Group { name, colour, areas: Vec::new(), strokes: Vec::new() };
        let strokes = strokes(&shapes, size, style);
        if style.fill {
            let found = shapes.clone();
            group.areas = if style.ordered { ordered(shapes, pens[0]) } else { shapes };
            done.add(&rings(&group.areas), &rings(&found), &mut pens);
        }
        if style.ordered {
            let (found, from) = (strokes.clone(), pens[0]);
            group.strokes = route(strokes, from).paths;
            done.add(&group.strokes, &found, &mut pens);
        } else {
            done.add(&strokes, &strokes, &mut pens);
            group.strokes = strokes;
        }
        groups.push(group);
    }
    (groups, done)
}

impl Travel {
    /// Such as `412 paths; the pen draws 3.10 m and travels 0.42 m in the air (2.90 m in the order found)`.
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

    /// Adds what was drawn, and what it would be as found; `pens` is where both stand.
    fn add(&mut self, drawn: &[Path], found: &[Path], pens: &mut [[f64; 2]; 2]) {
        self.paths += drawn.len();
        self.down += drawn.par_iter().map(Path::length).collect::<Vec<_>>().iter().sum::<f64>();
        self.up += travel(pens[0], drawn);
        self.up_unordered += travel(pens[1], found);
        for (pen, paths) in pens.iter_mut().zip([drawn, found]) {
            *pen = paths.last().map_or(*pen, Path::end);
        }
    }
}

fn rings(shapes: &[Shape]) -> Vec<Path> {
    shapes.iter().flat_map(Shape::paths).cloned().collect()
}

fn strokes(shapes: &[Shape], size: [f64; 2], style: &Style) -> Vec<Path> {
    let each = |shape: &Shape| {
        let mut strokes = Vec::new();
        if style.stroke {
            match style.ends {
                Ends::Closed => strokes.extend(shape.paths().cloned()),
                Ends::Cut => strokes.extend(shape.paths().flat_map(|path| path.cut(size))),
            }
        }
        strokes.extend(style.hatch.map(|lines| hatch(shape, lines)).unwrap_or_default());
        strokes
    };
    shapes.par_iter().flat_map_iter(each).collect()
}

/// Shapes in the order of their outer boundaries; the holes of each follow it.
fn ordered(shapes: Vec<Shape>, from: [f64; 2]) -> Vec<Shape> {
    let (outers, holes): (Vec<Path>, Vec<Vec<Path>>) =
        shapes.into_iter().map(|shape| (shape.outer, shape.holes)).unzip();
    let mut holes: Vec<Option<Vec<Path>>> = holes.into_iter().map(Some).collect();
    let Route { order, paths } = route(outers, from);
    let with_holes = |(index, outer): (usize, Path)| {
        let pen = outer.end();
        let mut holes = holes[index].take().unwrap_or_default();
        if holes.len() > 1 {
            holes = route(holes, pen).paths;
        } else if let Some(hole) = holes.pop() {
            let near = |i: &usize| distance(pen, hole.pieces[*i].end());
            let first = (0..hole.pieces.len()).min_by(|a, b| near(a).total_cmp(&near(b)));
            holes.push(hole.begun_after(first.map_or(0, |i| i + 1)));
        }
        Shape { outer, holes }
    };
    order.into_iter().zip(paths).map(with_holes).collect()
}
