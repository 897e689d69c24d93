//! Small pictures on buttons, drawn as lines so that they are sharp at any size.

use eframe::egui::epaint::EllipseShape;
use eframe::egui::{
    Button, Color32, Painter, Pos2, Rect, Response, Sense, Shape, Stroke, Ui, Vec2, pos2, vec2,
};

/// A picture on a button.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Icon {
    /// Select.
    Arrow,
    /// Freehand.
    Pen,
    /// Ellipse.
    Ellipse,
    /// Line.
    Line,
    /// Eraser.
    Eraser,
    /// Pan.
    Hand,
    /// Undo.
    Undo,
    /// Redo.
    Redo,
    /// Pause.
    Pause,
    /// Go on.
    Play,
    /// Stop.
    Stop,
    /// Another seed.
    Dice,
    /// Fit the canvas.
    Fit,
    /// Side by side.
    Beside,
    /// One over the other.
    Over,
    /// Two by two tiles.
    Tiles,
    /// Views move together.
    Link,
}

impl Icon {
    /// Paints it into a square.
    pub fn paint(self, painter: &Painter, rect: Rect, colour: Color32) {
        let unit = rect.width() / 20.0;
        let at = |[x, y]: [f32; 2]| rect.min + vec2(x, y) * unit;
        let stroke = Stroke::new(1.4 * unit.max(0.8), colour);
        let path = |points: &[[f32; 2]]| {
            let points: Vec<Pos2> = points.iter().map(|point| at(*point)).collect();
            painter.add(Shape::line(points, stroke));
        };
        let closed = |points: &[[f32; 2]]| {
            painter.add(Shape::closed_line(points.iter().map(|point| at(*point)).collect(), stroke));
        };
        let filled = |points: &[[f32; 2]]| {
            let points: Vec<Pos2> = points.iter().map(|point| at(*point)).collect();
            painter.add(Shape::convex_polygon(points, colour, Stroke::NONE));
        };
        let dot = |x: f32, y: f32, r: f32| {
            painter.circle_filled(at([x, y]), r * unit, colour);
        };
        match self {
            Self::Arrow => closed(&[
                [5.0, 3.0],
                [5.0, 15.5],
                [8.3, 12.4],
                [10.6, 17.2],
                [12.6, 16.2],
                [10.4, 11.5],
                [14.8, 11.2],
            ]),
            Self::Pen => {
                closed(&[[4.0, 16.0], [5.0, 12.2], [13.4, 3.8], [16.2, 6.6], [7.8, 15.0]]);
                path(&[[11.4, 5.8], [14.2, 8.6]]);
            }
            Self::Ellipse => {
                let ellipse = EllipseShape::stroke(at([10.0, 10.0]), vec2(7.0, 4.6) * unit, stroke);
                painter.add(ellipse.with_angle(-0.45));
            }
            Self::Line => {
                path(&[[4.5, 15.5], [15.5, 4.5]]);
                dot(4.5, 15.5, 1.9);
                dot(15.5, 4.5, 1.9);
            }
            Self::Eraser => {
                closed(&[[3.5, 12.5], [11.5, 4.5], [16.0, 9.0], [9.5, 15.5], [6.5, 15.5]]);
                path(&[[7.5, 8.5], [12.0, 13.0]]);
                path(&[[11.0, 15.5], [16.5, 15.5]]);
            }
            Self::Hand => {
                path(&[[10.0, 3.0], [10.0, 17.0]]);
                path(&[[3.0, 10.0], [17.0, 10.0]]);
                for [a, b, c] in [
                    [[8.0, 5.0], [10.0, 3.0], [12.0, 5.0]],
                    [[8.0, 15.0], [10.0, 17.0], [12.0, 15.0]],
                    [[5.0, 8.0], [3.0, 10.0], [5.0, 12.0]],
                    [[15.0, 8.0], [17.0, 10.0], [15.0, 12.0]],
                ] {
                    path(&[a, b, c]);
                }
            }
            Self::Undo | Self::Redo => {
                let flip = |x: f32| if self == Self::Undo { x } else { 20.0 - x };
                let arc: Vec<[f32; 2]> = (0..=14)
                    .map(|i| {
                        let angle = -std::f32::consts::FRAC_PI_2 + std::f32::consts::PI * i as f32 / 14.0;
                        [flip(11.0 + 4.5 * angle.cos()), 11.5 + 4.5 * angle.sin()]
                    })
                    .collect();
                path(&arc);
                path(&[[flip(11.0), 7.0], [flip(4.5), 7.0]]);
                path(&[[flip(7.5), 4.0], [flip(4.5), 7.0], [flip(7.5), 10.0]]);
                path(&[[flip(11.0), 16.0], [flip(7.0), 16.0]]);
            }
            Self::Pause => {
                filled(&[[6.0, 4.5], [8.6, 4.5], [8.6, 15.5], [6.0, 15.5]]);
                filled(&[[11.4, 4.5], [14.0, 4.5], [14.0, 15.5], [11.4, 15.5]]);
            }
            Self::Play => filled(&[[6.5, 4.0], [15.5, 10.0], [6.5, 16.0]]),
            Self::Stop => filled(&[[5.5, 5.5], [14.5, 5.5], [14.5, 14.5], [5.5, 14.5]]),
            Self::Dice => {
                let square = Rect::from_min_max(at([3.5, 3.5]), at([16.5, 16.5]));
                painter.rect_stroke(square, 3.0 * unit, stroke, eframe::egui::StrokeKind::Middle);
                for [x, y] in [[7.0, 7.0], [13.0, 7.0], [10.0, 10.0], [7.0, 13.0], [13.0, 13.0]] {
                    dot(x, y, 1.2);
                }
            }
            Self::Fit => {
                for [x, y, dx, dy] in [
                    [4.0, 4.0, 1.0, 1.0],
                    [16.0, 4.0, -1.0, 1.0],
                    [16.0, 16.0, -1.0, -1.0],
                    [4.0, 16.0, 1.0, -1.0],
                ] {
                    path(&[[x + 4.0 * dx, y], [x, y], [x, y + 4.0 * dy]]);
                }
            }
            Self::Beside => {
                closed(&[[3.0, 5.0], [9.0, 5.0], [9.0, 15.0], [3.0, 15.0]]);
                closed(&[[11.0, 5.0], [17.0, 5.0], [17.0, 15.0], [11.0, 15.0]]);
            }
            Self::Over => {
                closed(&[[3.5, 5.0], [16.5, 5.0], [16.5, 15.0], [3.5, 15.0]]);
                path(&[[10.0, 3.0], [10.0, 17.0]]);
                filled(&[[10.0, 5.0], [16.5, 5.0], [16.5, 15.0], [10.0, 15.0]]);
            }
            Self::Tiles => {
                for [x, y] in [[3.5, 3.5], [10.8, 3.5], [3.5, 10.8], [10.8, 10.8]] {
                    closed(&[[x, y], [x + 5.7, y], [x + 5.7, y + 5.7], [x, y + 5.7]]);
                }
            }
            Self::Link => {
                for x in [7.0, 13.0] {
                    let ring = EllipseShape::stroke(at([x, 10.0]), vec2(4.0, 3.0) * unit, stroke);
                    painter.add(ring);
                }
            }
        }
    }

    /// A button with the picture, and with a name for those who do not see it.
    pub fn button(self, ui: &mut Ui, name: &str, selected: bool) -> Response {
        self.button_of(ui, name, selected, vec2(30.0, 28.0))
    }

    /// The same at a size.
    pub fn button_of(self, ui: &mut Ui, name: &str, selected: bool, size: Vec2) -> Response {
        let button = Button::new("").min_size(size).selected(selected).frame_when_inactive(selected);
        let response = ui.add_sized(size, button.sense(Sense::click()));
        let colour = if selected {
            ui.visuals().selection.stroke.color
        } else if ui.is_enabled() {
            ui.style().interact(&response).text_color()
        } else {
            ui.visuals().widgets.noninteractive.fg_stroke.color.gamma_multiply(0.4)
        };
        let side = (size.y - 8.0).min(20.0);
        let center = response.rect.center();
        let square = Rect::from_center_size(pos2(center.x.round(), center.y.round()), Vec2::splat(side));
        self.paint(ui.painter(), square, colour);
        response.accessible_name(name)
    }
}
