//! Rows of a pattern → its level lines: marching squares with linear interpolation, row by row.
//!
//! The values belong to the cells' centres. Around them, on the border of the canvas, a frame of nodes is added: mirrored
//! values on a closed border, the mean with the opposite side on a wrapped one. A second frame in the same place is outside
//! of any level. So every line is closed (along the border where a mark reaches it), and on a wrapped canvas a line that ends
//! at one side starts at the same place of the opposite side.

use kurbo::Point;

use crate::export::Stopped;
use crate::grid::marching_squares::lines;
use crate::grid::{Edges, UnionFind};
use std::ops::Range;

/// Index that means "no crossing".
const NONE: u32 = u32::MAX;
/// Number of values that are requested at a time.
const BAND: usize = 1 << 20;

/// The level lines of a pattern, all closed.
#[derive(Debug, Default)]
pub struct Traced {
    /// The lines.
    pub rings: Vec<Ring>,
    /// Labels of parts of the canvas that touch across its wrapped border.
    pub seams: Vec<[u32; 2]>,
    /// The label of the outside of the canvas.
    pub outside: u32,
}

/// A closed level line. Where y runs down, the inside is on its right: around a mark it has a positive area, around a hole a
/// negative one.
#[derive(Debug)]
pub struct Ring {
    /// Its points, px; the first is not repeated.
    pub points: Vec<Point>,
    /// The labels of the parts inside and outside.
    pub sides: [u32; 2],
}

impl Ring {
    /// Whether it runs around a mark, not around a hole.
    pub fn is_around_mark(&self) -> bool {
        let next = self.points.iter().cycle().skip(1);
        let twice: f64 = self.points.iter().zip(next).map(|(a, b)| a.to_vec2().cross(b.to_vec2())).sum();
        twice > 0.0
    }
}

/// Traces where a field of `size` values over a canvas of `extent` px reaches `level`; `rows` returns its values.
///
/// # Errors
/// The error of `rows`.
pub fn trace(
    size: [usize; 2],
    extent: [f64; 2],
    edges: Edges,
    level: f64,
    rows: &mut dyn FnMut(Range<usize>) -> Result<Vec<f32>, Stopped>,
) -> Result<Traced, Stopped> {
    let [width, height] = size;
    if width == 0 || height == 0 || level.is_nan() {
        return Ok(Traced::default());
    }
    // Outside is below any level.
    let mut tracer = Tracer::new(size, extent, edges, level.max(f64::MIN));
    let outside = vec![f32::NEG_INFINITY; width];
    tracer.push(&outside, 0.0, false);
    let (first, last) = (rows(0..1)?, rows(height - 1..height)?);
    let across: Vec<f32> = match edges {
        Edges::Closed => first,
        Edges::Wrap => first.iter().zip(&last).map(|(a, b)| 0.5 * (a + b)).collect(),
    };
    tracer.push(&across, 0.0, true);
    let band = (BAND / width).max(1);
    for start in (0..height).step_by(band) {
        let range = start..(start + band).min(height);
        for (row, y) in rows(range.clone())?.chunks(width).zip(range) {
            tracer.push(row, (y as f64 + 0.5) * extent[1] / height as f64, true);
        }
    }
    let below = if edges == Edges::Wrap { &across } else { &last };
    tracer.push(below, extent[1], true);
    tracer.join_top_and_bottom();
    tracer.push(&outside, extent[1], false);
    Ok(tracer.finish())
}

/// A row of nodes.
#[derive(Default)]
struct Row {
    y: f64,
    values: Vec<f64>,
    inside: Vec<bool>,
    labels: Vec<u32>,
}

struct Tracer {
    edges: Edges,
    level: f64,
    /// x of the columns of nodes, px.
    xs: Vec<f64>,
    above: Option<Row>,
    /// The labels along the upper border.
    top: Row,
    /// The points on the horizontal edges of the row above.
    upper: Vec<u32>,
    points: Vec<Crossing>,
    labels: UnionFind,
    seams: Vec<[u32; 2]>,
}

/// A crossing of the level, and the next one on its line.
struct Crossing {
    at: Point,
    next: u32,
    sides: [u32; 2],
}

impl Tracer {
    fn new([width, _]: [usize; 2], extent: [f64; 2], edges: Edges, level: f64) -> Self {
        let mut xs = vec![0.0, 0.0];
        xs.extend((0..width).map(|x| (x as f64 + 0.5) * extent[0] / width as f64));
        xs.extend([extent[0]; 2]);
        let upper = vec![NONE; xs.len() - 1];
        Self {
            edges,
            level,
            xs,
            above: None,
            top: Row::default(),
            upper,
            points: Vec::new(),
            labels: UnionFind::default(),
            seams: Vec::new(),
        }
    }

    /// Adds the next row of values; `framed`: with border nodes on both sides.
    fn push(&mut self, values: &[f32], y: f64, framed: bool) {
        let row = self.row(values, y, framed);
        if let Some(above) = self.above.take() {
            self.march(&above, &row);
        }
        if self.edges == Edges::Wrap && framed {
            let last = row.labels.len() - 2;
            if row.inside[1] && row.inside[last] {
                self.seams.push([row.labels[1], row.labels[last]]);
            }
            if self.top.labels.is_empty() {
                self.top = Row { labels: row.labels.clone(), inside: row.inside.clone(), ..Row::default() };
            }
        }
        self.above = Some(row);
    }

    fn row(&mut self, values: &[f32], y: f64, framed: bool) -> Row {
        let (first, last) = (f64::from(values[0]), f64::from(values[values.len() - 1]));
        let border = match self.edges {
            _ if !framed => [f64::NEG_INFINITY; 2],
            Edges::Closed => [first, last],
            Edges::Wrap => [0.5 * (first + last); 2],
        };
        let mut nodes = vec![f64::NEG_INFINITY, border[0]];
        nodes.extend(values.iter().map(|value| f64::from(*value)));
        nodes.extend([border[1], f64::NEG_INFINITY]);
        // NaN is outside.
        let inside: Vec<bool> = nodes.iter().map(|value| *value >= self.level).collect();
        let mut labels = Vec::with_capacity(nodes.len());
        for x in 0..nodes.len() {
            let mut label = (x > 0 && inside[x - 1] == inside[x]).then(|| labels[x - 1]);
            if let Some(above) = self.above.as_ref().filter(|above| above.inside[x] == inside[x]) {
                label = Some(match label {
                    Some(left) => self.labels.join(left, above.labels[x], [0, 0]),
                    None => above.labels[x],
                });
            }
            labels.push(label.unwrap_or_else(|| self.labels.add()));
        }
        Row { y, values: nodes, inside, labels }
    }

    /// Adds the lines between two rows of nodes.
    fn march(&mut self, above: &Row, below: &Row) {
        let mut left = NONE;
        for x in 0..self.xs.len() - 1 {
            let corners = [above.inside[x], above.inside[x + 1], below.inside[x + 1], below.inside[x]];
            let top = self.upper[x];
            if corners == [corners[0]; 4] {
                (self.upper[x], left) = (NONE, NONE);
                continue;
            }
            let right = self.crossing([above, below], [x + 1, x + 1]);
            let bottom = self.crossing([below, below], [x, x + 1]);
            self.link(corners, [top, right, bottom, left], [above, below], x);
            (self.upper[x], left) = (bottom, right);
        }
    }

    /// The point between two nodes where the level is crossed.
    fn crossing(&mut self, rows: [&Row; 2], x: [usize; 2]) -> u32 {
        let inside = [0, 1].map(|end| rows[end].inside[x[end]]);
        if inside[0] == inside[1] {
            return NONE;
        }
        let [a, b] = [0, 1].map(|end| rows[end].values[x[end]]);
        let t = (self.level - a) / (b - a);
        let t = if t.is_finite() { t.clamp(0.0, 1.0) } else { 0.5 };
        let between = |a: f64, b: f64| a + t * (b - a);
        let at = Point::new(between(self.xs[x[0]], self.xs[x[1]]), between(rows[0].y, rows[1].y));
        let labels = [0, 1].map(|end| rows[end].labels[x[end]]);
        let sides = if inside[0] { labels } else { [labels[1], labels[0]] };
        self.points.push(Crossing { at, next: NONE, sides });
        (self.points.len() - 1) as u32
    }

    /// Connects the crossings on the edges of one cell; `corners` and `edges` are listed clockwise from the upper left corner
    /// and the top edge.
    ///
    /// In a saddle cell, the mean of the corners decides which two corners are connected.
    fn link(&mut self, corners: [bool; 4], edges: [u32; 4], rows: [&Row; 2], x: usize) {
        let saddle = corners[0] == corners[2] && corners[1] == corners[3];
        let [above, below] = rows;
        let mean = || 0.25 * (above.values[x] + above.values[x + 1] + below.values[x + 1] + below.values[x]);
        let joined = saddle && mean() >= self.level;
        if saddle {
            let falling = corners[0] == joined;
            let ends = if falling {
                [above.labels[x], below.labels[x + 1]]
            } else {
                [above.labels[x + 1], below.labels[x]]
            };
            self.labels.join(ends[0], ends[1], [0, 0]);
        }
        for [enter, leave] in lines(corners, || joined) {
            self.points[edges[enter] as usize].next = edges[leave];
        }
    }

    /// On a wrapped canvas, joins the parts at the lower border with the parts at the upper one.
    fn join_top_and_bottom(&mut self) {
        let Some(row) = self.above.as_ref().filter(|_| self.edges == Edges::Wrap) else { return };
        for x in 1..row.labels.len() - 1 {
            if row.inside[x] && self.top.inside[x] {
                self.seams.push([row.labels[x], self.top.labels[x]]);
            }
        }
        self.seams.dedup();
    }

    fn finish(mut self) -> Traced {
        let mut rings = Vec::new();
        for first in 0..self.points.len() {
            let mut points: Vec<Point> = Vec::new();
            let mut at = first as u32;
            while at != NONE {
                let point = &mut self.points[at as usize];
                if points.last() != Some(&point.at) {
                    points.push(point.at);
                }
                // Each crossing is used once.
                at = std::mem::replace(&mut point.next, NONE);
            }
            while points.len() > 1 && points.last() == points.first() {
                points.pop();
            }
            if points.len() > 2 {
                let sides = self.points[first].sides.map(|label| self.labels.find(label).0);
                rings.push(Ring { points, sides });
            }
        }
        let seams = self.seams.iter().map(|pair| pair.map(|label| self.labels.find(label).0)).collect();
        Traced { rings, seams, outside: self.labels.find(0).0 }
    }
}

#[cfg(test)]
mod tests;
