//! Painting marks and strokes on the canvas.

use std::f64::consts::TAU;

use egui::epaint::{EllipseShape, PathShape};
use egui::{Color32, Mesh, Painter, Pos2, Rect, Shape, Stroke, pos2, vec2};

use super::view::View;
use crate::editor::shape;
use crate::marks::{Ellipse, Line, Mark, Path};

/// Paints on a canvas, in px of the canvas.
#[derive(Clone, Copy)]
pub struct Ink<'a> {
    /// Where shapes are added.
    pub painter: &'a Painter,
    /// The visible part of the canvas.
    pub view: &'a View,
    /// The part of the screen that shows it.
    pub room: Rect,
}

impl Ink<'_> {
    /// A point of the canvas on the screen.
    #[must_use]
    pub fn at(&self, point: [f64; 2]) -> Pos2 {
        self.view.to_screen(self.room, point)
    }

    /// A mark, filled and outlined.
    pub fn mark(&self, mark: &Mark, fill: Color32, outline: Stroke) {
        match mark {
            Mark::Ellipse(ellipse) => {
                let radius = vec2(ellipse.radii[0] as f32, ellipse.radii[1] as f32) * self.view.zoom;
                let shape = EllipseShape {
                    center: self.at(ellipse.center),
                    radius,
                    fill,
                    stroke: outline,
                    angle: 0.0,
                };
                self.painter.add(shape.with_angle(ellipse.angle.to_radians() as f32));
            }
            Mark::Line(line) => {
                let outline = PathShape {
                    closed: true,
                    ..PathShape::convex_polygon(self.rounded(line), fill, outline)
                };
                self.painter.add(outline);
            }
            Mark::Path(path) => self.wide_path(path, fill, outline),
        }
    }

    /// A closed polygon, filled and outlined; it need not be convex.
    pub fn polygon(&self, corners: &[[f64; 2]], fill: Color32, outline: Stroke) {
        let points: Vec<Pos2> = corners.iter().map(|corner| self.at(*corner)).collect();
        let mut inside = Mesh::default();
        let bounds = Rect::from_points(&points).intersect(self.room);
        // Fills row by row of screen points: each section from an odd crossing with the outline to the next crossing.
        for row in bounds.top().floor() as i64..bounds.bottom().ceil() as i64 {
            let y = row as f32 + 0.5;
            let sides = points.iter().zip(points.iter().cycle().skip(1));
            let crossed = sides.filter(|(a, b)| (a.y > y) != (b.y > y));
            let mut crossings: Vec<f32> =
                crossed.map(|(a, b)| a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x)).collect();
            crossings.sort_by(f32::total_cmp);
            for pair in crossings.chunks_exact(2) {
                let corners = [pos2(pair[0], row as f32), pos2(pair[1], row as f32 + 1.0)];
                inside.add_colored_rect(Rect::from_two_pos(corners[0], corners[1]), fill);
            }
        }
        self.painter.add(inside);
        self.painter.add(Shape::closed_line(points, outline));
    }

    /// The outline of a mark, dashed.
    pub fn dashed_outline(&self, mark: &Mark, stroke: Stroke) {
        let mut points = match mark {
            Mark::Ellipse(ellipse) => self.around(ellipse),
            Mark::Line(line) => self.rounded(line),
            Mark::Path(path) => self.sides(path, 0.5 * (path.width as f32 * self.view.zoom).max(1.5)),
        };
        points.extend(points.first().copied());
        self.painter.extend(Shape::dashed_line(&points, stroke, 5.0, 3.5));
    }

    /// The outline of an ellipse.
    fn around(&self, ellipse: &Ellipse) -> Vec<Pos2> {
        const STEPS: usize = 48;
        let point = |step: usize| {
            let (s, c) = (TAU * step as f64 / STEPS as f64).sin_cos();
            shape::out_of_frame([ellipse.radii[0] * c, ellipse.radii[1] * s], ellipse.center, ellipse.angle)
        };
        (0..STEPS).map(|step| self.at(point(step))).collect()
    }

    /// A path, drawn as wide as it is, with an outline.
    fn wide_path(&self, path: &Path, fill: Color32, outline: Stroke) {
        let width = (path.width as f32 * self.view.zoom).max(1.5);
        self.path(&path.points, Stroke::new(width, fill));
        self.painter.add(PathShape {
            points: self.sides(path, 0.5 * width),
            closed: true,
            fill: Color32::TRANSPARENT,
            stroke: outline.into(),
        });
    }

    /// The two sides of a path at the distance `half`, points of the screen, as one line: forth along one side, back
    /// along the other.
    fn sides(&self, path: &Path, half: f32) -> Vec<Pos2> {
        let points: Vec<Pos2> = path.points.iter().map(|point| self.at(*point)).collect();
        let normal = |index: usize| {
            let [before, after] = [index.saturating_sub(1), (index + 1).min(points.len() - 1)];
            (points[after] - points[before]).normalized().rot90() * half
        };
        let side = |index: usize, side: f32| points[index] + side * normal(index);
        let there = (0..points.len()).map(|index| side(index, 1.0));
        there.chain((0..points.len()).rev().map(|index| side(index, -1.0))).collect()
    }

    /// The outline of a line with round ends.
    fn rounded(&self, line: &Line) -> Vec<Pos2> {
        /// Steps of the half circle at each end.
        const STEPS: usize = 8;
        let [from, to] = [line.from, line.to].map(|end| self.at(end));
        let half = (0.5 * line.width as f32 * self.view.zoom).max(0.75);
        let start = (to - from).angle() - std::f32::consts::FRAC_PI_2;
        let mut outline = Vec::with_capacity(2 * STEPS + 2);
        for (end, turn) in [(to, 0.0), (from, std::f32::consts::PI)] {
            for step in 0..=STEPS {
                let angle = start + turn + std::f32::consts::PI * step as f32 / STEPS as f32;
                outline.push(end + half * vec2(angle.cos(), angle.sin()));
            }
        }
        outline
    }

    /// A freehand stroke.
    pub fn path(&self, points: &[[f64; 2]], stroke: Stroke) {
        let points: Vec<Pos2> = points.iter().map(|point| self.at(*point)).collect();
        match &points[..] {
            [] => {}
            [dot] => drop(self.painter.circle_filled(*dot, 0.5 * stroke.width, stroke.color)),
            _ => drop(self.painter.add(Shape::line(points, stroke))),
        }
    }

    /// A straight line.
    pub fn segment(&self, [from, to]: [[f64; 2]; 2], stroke: Stroke) {
        self.painter.line_segment([self.at(from), self.at(to)], stroke);
    }

    /// A box with a dashed border.
    pub fn dashed(&self, corners: [Pos2; 2], stroke: Stroke) {
        let rect = Rect::from_two_pos(corners[0], corners[1]);
        let [a, b, c, d] = [rect.left_top(), rect.right_top(), rect.right_bottom(), rect.left_bottom()];
        self.painter.extend(Shape::dashed_line(&[a, b, c, d, a], stroke, 4.0, 3.0));
    }
}
