//! What is not seen of an SVG: shapes that are clipped away or fully transparent.

use std::rc::Rc;

use usvg::tiny_skia_path::Transform;
use usvg::{ClipPath, FillRule, Group, Node};

use super::strokes::strokes;

/// Points of an outline that are tested.
const POINTS: usize = 48;

/// What the groups around a shape leave visible of it.
#[derive(Clone)]
pub(super) struct Visibility {
    clips: Vec<Rc<Clip>>,
    /// Opacity of the groups, 0 to 1.
    opacity: f32,
}

impl Default for Visibility {
    fn default() -> Self {
        Self { clips: Vec::new(), opacity: 1.0 }
    }
}

/// The part of the canvas that a clip path leaves: that inside any of its shapes.
struct Clip {
    shapes: Vec<(FillRule, Vec<Vec<[f64; 2]>>)>,
}

impl Visibility {
    /// What remains inside `group`.
    pub(super) fn inside(&self, group: &Group, scale: f64) -> Self {
        let mut inside = self.clone();
        // A mask without content hides everything, as an empty clip path does.
        if group.mask().is_some_and(|mask| mask.root().children().is_empty()) {
            inside.clips.push(Rc::new(Clip { shapes: Vec::new() }));
        }
        let mut clip = group.clip_path();
        while let Some(path) = clip {
            inside.clips.push(Rc::new(Clip::new(path, group.abs_transform(), scale)));
            clip = path.clip_path();
        }
        inside.opacity *= group.opacity().get();
        inside
    }

    /// The opacity of the groups around a shape, 0 to 1.
    pub(super) fn opacity(&self) -> f32 {
        self.opacity
    }

    /// Whether a place is left by all clip paths.
    pub(super) fn shows(&self, place: [f64; 2]) -> bool {
        self.clips.iter().all(|clip| clip.contains(place))
    }

    /// Whether less than half of a shape with these `points` is left.
    pub(super) fn is_clipped(&self, points: &[[f64; 2]]) -> bool {
        if self.clips.is_empty() {
            return false;
        }
        let seen: Vec<bool> = tested(points).map(|point| self.shows(point)).collect();
        2 * seen.iter().filter(|seen| **seen).count() < seen.len()
    }
}

impl Clip {
    /// Of a group with this absolute transform.
    fn new(path: &ClipPath, group: Transform, scale: f64) -> Self {
        let mut clip = Self { shapes: Vec::new() };
        clip.add(path.root(), group.pre_concat(path.transform()), scale);
        clip
    }

    fn add(&mut self, group: &Group, around: Transform, scale: f64) {
        for node in group.children() {
            match node {
                Node::Group(group) => self.add(group, around, scale),
                Node::Path(path) => {
                    let transform = around.pre_concat(path.abs_transform());
                    let outlines = strokes(path.data(), transform, scale).into_iter();
                    let rule = path.fill().map_or(FillRule::NonZero, usvg::Fill::rule);
                    self.shapes.push((rule, outlines.map(|outline| outline.points).collect()));
                }
                Node::Image(_) | Node::Text(_) => {}
            }
        }
    }

    fn contains(&self, point: [f64; 2]) -> bool {
        self.shapes.iter().any(|(rule, outlines)| {
            inside(&outlines.iter().map(|outline| &outline[..]).collect::<Vec<_>>(), *rule, point)
        })
    }
}

/// Points of an outline, and of the same half as large.
pub(super) fn tested(points: &[[f64; 2]]) -> impl Iterator<Item = [f64; 2]> {
    let n = points.len() as f64;
    let center = [0, 1].map(|axis| points.iter().map(|point| point[axis]).sum::<f64>() / n);
    let some = points.iter().step_by(points.len().div_ceil(POINTS).max(1));
    some.flat_map(move |point| [*point, [0, 1].map(|axis| 0.5 * (point[axis] + center[axis]))])
}

/// Whether a point lies in the area of some outlines.
pub(super) fn inside(outlines: &[&[[f64; 2]]], rule: FillRule, point: [f64; 2]) -> bool {
    let winding: i32 = outlines.iter().map(|outline| winding(outline, point)).sum();
    match rule {
        FillRule::NonZero => winding != 0,
        FillRule::EvenOdd => winding % 2 != 0,
    }
}

/// How often an outline winds around a point; an open one is closed.
fn winding(outline: &[[f64; 2]], [x, y]: [f64; 2]) -> i32 {
    let next = outline.iter().cycle().skip(1);
    let sides = outline.iter().zip(next);
    let crossing = |(a, b): (&[f64; 2], &[f64; 2])| {
        let is_crossed = (a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
        if is_crossed { if a[1] > y { 1 } else { -1 } } else { 0 }
    };
    sides.map(crossing).sum()
}
