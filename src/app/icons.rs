//! Icons, drawn as lines so that they are sharp at any size.

use egui::epaint::EllipseShape;
use egui::{Button, Color32, Painter, Pos2, Rect, Response, Sense, Shape, Stroke, Ui, Vec2, pos2, vec2};

/// An icon.
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
    /// Comb.
    Comb,
    /// Pan.
    Hand,
    /// Undo.
    Undo,
    /// Redo.
    Redo,
    /// Pause.
    Pause,
    /// Resume.
    Play,
    /// Stop.
    Stop,
    /// Another seed.
    Dice,
    /// Fit the canvas.
    Fit,
    /// Side by side.
    Beside,
    /// Texture over the sketch.
    Over,
    /// Two by two tiles.
    Tiles,
    /// Add.
    Add,
    /// Duplicate.
    Copies,
    /// Delete.
    Bin,
    /// Raise.
    Up,
    /// Lower.
    Down,
    /// Shown.
    Eye,
    /// Hidden.
    Shut,
    /// Frozen.
    Frozen,
    /// Folded up.
    Folded,
    /// Unfolded.
    Unfolded,
    /// Alternatives.
    Strip,
    /// Pick a colour from a picture.
    Dropper,
    /// Keep.
    Star,
    /// Kept.
    Starred,
}

/// A part of an icon, in a square of 20 × 20.
enum Part {
    /// A line.
    Path(&'static [[f32; 2]]),
    /// A closed line.
    Closed(&'static [[f32; 2]]),
    /// A filled convex outline.
    Filled(&'static [[f32; 2]]),
    /// A dot: its centre and radius.
    Dot([f32; 3]),
    /// An ellipse: its centre, radii and angle.
    Oval([f32; 5]),
    /// Half a circle, its centre and radius; on the left (−1) or right (1) of its centre.
    Half([f32; 3], f32),
}

use Part::{Closed, Dot, Filled, Half, Oval, Path};

impl Icon {
    fn parts(self) -> &'static [Part] {
        match self {
            Self::Arrow => ARROW,
            Self::Pen => PEN,
            Self::Ellipse => &[Oval([10.0, 10.0, 7.0, 4.6, -0.45])],
            Self::Line => &[Path(&[[4.5, 15.5], [15.5, 4.5]]), Dot([4.5, 15.5, 1.9]), Dot([15.5, 4.5, 1.9])],
            Self::Eraser => ERASER,
            Self::Comb => COMB,
            Self::Hand => HAND,
            Self::Undo => UNDO,
            Self::Redo => REDO,
            Self::Pause => PAUSE,
            Self::Play => &[Filled(&[[6.5, 4.0], [15.5, 10.0], [6.5, 16.0]])],
            Self::Stop => &[Filled(&[[5.5, 5.5], [14.5, 5.5], [14.5, 14.5], [5.5, 14.5]])],
            Self::Dice => DICE,
            Self::Fit => FIT,
            Self::Beside => BESIDE,
            Self::Over => OVER,
            Self::Tiles => TILES,
            Self::Add => &[Path(&[[10.0, 4.0], [10.0, 16.0]]), Path(&[[4.0, 10.0], [16.0, 10.0]])],
            Self::Copies => COPIES,
            Self::Bin => BIN,
            Self::Up => &[Path(&[[10.0, 16.5], [10.0, 3.5]]), Path(&[[5.0, 8.5], [10.0, 3.5], [15.0, 8.5]])],
            Self::Down => {
                &[Path(&[[10.0, 3.5], [10.0, 16.5]]), Path(&[[5.0, 11.5], [10.0, 16.5], [15.0, 11.5]])]
            }
            Self::Eye => EYE,
            Self::Shut => SHUT,
            Self::Frozen => FROZEN,
            Self::Folded => &[Path(&[[8.0, 5.5], [12.5, 10.0], [8.0, 14.5]])],
            Self::Unfolded => &[Path(&[[5.5, 8.0], [10.0, 12.5], [14.5, 8.0]])],
            Self::Strip => STRIP,
            Self::Dropper => DROPPER,
            Self::Star => STAR,
            Self::Starred => STARRED,
        }
    }

    /// Paints it into a square.
    pub fn paint(self, painter: &Painter, rect: Rect, colour: Color32) {
        let unit = rect.width() / 20.0;
        let at = |[x, y]: [f32; 2]| rect.min + vec2(x, y) * unit;
        let all = |points: &[[f32; 2]]| points.iter().map(|point| at(*point)).collect::<Vec<Pos2>>();
        let stroke = Stroke::new(1.4 * unit.max(0.8), colour);
        for part in self.parts() {
            painter.add(match part {
                Path(points) => Shape::line(all(points), stroke),
                Closed(points) => Shape::closed_line(all(points), stroke),
                Filled(points) => Shape::convex_polygon(all(points), colour, Stroke::NONE),
                Dot([x, y, radius]) => Shape::circle_filled(at([*x, *y]), radius * unit, colour),
                Oval([x, y, a, b, angle]) => {
                    EllipseShape::stroke(at([*x, *y]), vec2(*a, *b) * unit, stroke).with_angle(*angle).into()
                }
                Half([x, y, radius], side) => {
                    let point = |i: i32| {
                        let (sin, cos) = (std::f32::consts::PI * (i as f32 / 14.0 - 0.5)).sin_cos();
                        at([x + side * radius * cos, y + radius * sin])
                    };
                    Shape::line((0..=14).map(point).collect(), stroke)
                }
            });
        }
    }

    /// A button with the icon, and with an accessible name.
    pub fn button(self, ui: &mut Ui, name: &str, selected: bool) -> Response {
        self.sized_button(ui, name, selected, vec2(30.0, 28.0))
    }

    /// A button of `size` points with the icon, and with an accessible name.
    pub fn sized_button(self, ui: &mut Ui, name: &str, selected: bool, size: Vec2) -> Response {
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

const ARROW: &[Part] = &[Closed(&[
    [5.0, 3.0],
    [5.0, 15.5],
    [8.3, 12.4],
    [10.6, 17.2],
    [12.6, 16.2],
    [10.4, 11.5],
    [14.8, 11.2],
])];
const PEN: &[Part] = &[
    Closed(&[[4.0, 16.0], [5.0, 12.2], [13.4, 3.8], [16.2, 6.6], [7.8, 15.0]]),
    Path(&[[11.4, 5.8], [14.2, 8.6]]),
];
const ERASER: &[Part] = &[
    Closed(&[[3.5, 12.5], [11.5, 4.5], [16.0, 9.0], [9.5, 15.5], [6.5, 15.5]]),
    Path(&[[7.5, 8.5], [12.0, 13.0]]),
    Path(&[[11.0, 15.5], [16.5, 15.5]]),
];
const COMB: &[Part] = &[
    Path(&[[3.5, 6.0], [16.5, 6.0]]),
    Path(&[[4.5, 6.0], [4.5, 15.0]]),
    Path(&[[8.2, 6.0], [8.2, 15.0]]),
    Path(&[[11.8, 6.0], [11.8, 15.0]]),
    Path(&[[15.5, 6.0], [15.5, 15.0]]),
];
const HAND: &[Part] = &[
    Path(&[[10.0, 3.0], [10.0, 17.0]]),
    Path(&[[3.0, 10.0], [17.0, 10.0]]),
    Path(&[[8.0, 5.0], [10.0, 3.0], [12.0, 5.0]]),
    Path(&[[8.0, 15.0], [10.0, 17.0], [12.0, 15.0]]),
    Path(&[[5.0, 8.0], [3.0, 10.0], [5.0, 12.0]]),
    Path(&[[15.0, 8.0], [17.0, 10.0], [15.0, 12.0]]),
];
const UNDO: &[Part] = &[
    Half([11.0, 11.5, 4.5], 1.0),
    Path(&[[11.0, 7.0], [4.5, 7.0]]),
    Path(&[[7.5, 4.0], [4.5, 7.0], [7.5, 10.0]]),
    Path(&[[11.0, 16.0], [7.0, 16.0]]),
];
const REDO: &[Part] = &[
    Half([9.0, 11.5, 4.5], -1.0),
    Path(&[[9.0, 7.0], [15.5, 7.0]]),
    Path(&[[12.5, 4.0], [15.5, 7.0], [12.5, 10.0]]),
    Path(&[[9.0, 16.0], [13.0, 16.0]]),
];
const PAUSE: &[Part] = &[
    Filled(&[[6.0, 4.5], [8.6, 4.5], [8.6, 15.5], [6.0, 15.5]]),
    Filled(&[[11.4, 4.5], [14.0, 4.5], [14.0, 15.5], [11.4, 15.5]]),
];
const DICE: &[Part] = &[
    Closed(&[
        [4.5, 3.5],
        [15.5, 3.5],
        [16.5, 4.5],
        [16.5, 15.5],
        [15.5, 16.5],
        [4.5, 16.5],
        [3.5, 15.5],
        [3.5, 4.5],
    ]),
    Dot([7.0, 7.0, 1.2]),
    Dot([13.0, 7.0, 1.2]),
    Dot([10.0, 10.0, 1.2]),
    Dot([7.0, 13.0, 1.2]),
    Dot([13.0, 13.0, 1.2]),
];
const FIT: &[Part] = &[
    Path(&[[8.0, 4.0], [4.0, 4.0], [4.0, 8.0]]),
    Path(&[[12.0, 4.0], [16.0, 4.0], [16.0, 8.0]]),
    Path(&[[12.0, 16.0], [16.0, 16.0], [16.0, 12.0]]),
    Path(&[[8.0, 16.0], [4.0, 16.0], [4.0, 12.0]]),
];
const BESIDE: &[Part] = &[
    Closed(&[[3.0, 5.0], [9.0, 5.0], [9.0, 15.0], [3.0, 15.0]]),
    Closed(&[[11.0, 5.0], [17.0, 5.0], [17.0, 15.0], [11.0, 15.0]]),
];
const OVER: &[Part] = &[
    Closed(&[[3.5, 5.0], [16.5, 5.0], [16.5, 15.0], [3.5, 15.0]]),
    Path(&[[10.0, 3.0], [10.0, 17.0]]),
    Filled(&[[10.0, 5.0], [16.5, 5.0], [16.5, 15.0], [10.0, 15.0]]),
];
const STRIP: &[Part] = &[
    Closed(&[[3.0, 3.5], [17.0, 3.5], [17.0, 11.0], [3.0, 11.0]]),
    Closed(&[[3.0, 13.0], [6.8, 13.0], [6.8, 16.8], [3.0, 16.8]]),
    Closed(&[[8.1, 13.0], [11.9, 13.0], [11.9, 16.8], [8.1, 16.8]]),
    Closed(&[[13.2, 13.0], [17.0, 13.0], [17.0, 16.8], [13.2, 16.8]]),
];
const DROPPER: &[Part] = &[
    Closed(&[[3.5, 16.5], [4.2, 13.4], [10.4, 7.2], [12.8, 9.6], [6.6, 15.8]]),
    Path(&[[9.0, 5.8], [14.2, 11.0]]),
    Filled(&[[10.9, 7.0], [14.4, 3.5], [16.5, 5.6], [13.0, 9.1]]),
];
const STAR: &[Part] = &[Closed(&[
    [10.0, 2.6],
    [12.2, 7.6],
    [17.6, 8.1],
    [13.5, 11.7],
    [14.7, 17.0],
    [10.0, 14.2],
    [5.3, 17.0],
    [6.5, 11.7],
    [2.4, 8.1],
    [7.8, 7.6],
])];
// Convex pieces: five tips and the pentagon between them.
const STARRED: &[Part] = &[
    Filled(&[[10.0, 2.2], [12.3, 7.7], [7.7, 7.7]]),
    Filled(&[[17.9, 8.0], [13.5, 11.9], [12.0, 7.4]]),
    Filled(&[[14.9, 17.4], [9.8, 14.4], [13.6, 11.5]]),
    Filled(&[[5.1, 17.4], [6.4, 11.5], [10.2, 14.4]]),
    Filled(&[[2.1, 8.0], [8.0, 7.4], [6.5, 11.9]]),
    Filled(&[[7.6, 7.4], [12.4, 7.4], [13.7, 11.8], [10.0, 14.4], [6.3, 11.8]]),
];
const TILES: &[Part] = &[
    Closed(&[[3.5, 3.5], [9.2, 3.5], [9.2, 9.2], [3.5, 9.2]]),
    Closed(&[[10.8, 3.5], [16.5, 3.5], [16.5, 9.2], [10.8, 9.2]]),
    Closed(&[[3.5, 10.8], [9.2, 10.8], [9.2, 16.5], [3.5, 16.5]]),
    Closed(&[[10.8, 10.8], [16.5, 10.8], [16.5, 16.5], [10.8, 16.5]]),
];
const COPIES: &[Part] = &[
    Closed(&[[3.5, 3.5], [12.5, 3.5], [12.5, 12.5], [3.5, 12.5]]),
    Path(&[[15.0, 7.5], [16.5, 7.5], [16.5, 16.5], [7.5, 16.5], [7.5, 15.0]]),
];
const BIN: &[Part] = &[
    Path(&[[3.5, 5.5], [16.5, 5.5]]),
    Path(&[[7.5, 5.5], [7.5, 3.5], [12.5, 3.5], [12.5, 5.5]]),
    Path(&[[5.0, 5.5], [5.8, 16.5], [14.2, 16.5], [15.0, 5.5]]),
    Path(&[[8.5, 8.5], [8.5, 13.5]]),
    Path(&[[11.5, 8.5], [11.5, 13.5]]),
];
const EYE: &[Part] = &[
    Path(&[[2.5, 10.0], [5.0, 7.2], [7.5, 5.8], [10.0, 5.4], [12.5, 5.8], [15.0, 7.2], [17.5, 10.0]]),
    Path(&[[2.5, 10.0], [5.0, 12.8], [7.5, 14.2], [10.0, 14.6], [12.5, 14.2], [15.0, 12.8], [17.5, 10.0]]),
    Dot([10.0, 10.0, 2.4]),
];
const SHUT: &[Part] = &[
    Path(&[[2.5, 9.0], [5.0, 11.8], [7.5, 13.2], [10.0, 13.6], [12.5, 13.2], [15.0, 11.8], [17.5, 9.0]]),
    Path(&[[4.6, 11.4], [3.2, 13.4]]),
    Path(&[[10.0, 13.6], [10.0, 16.2]]),
    Path(&[[15.4, 11.4], [16.8, 13.4]]),
];
const FROZEN: &[Part] = &[
    Path(&[[10.0, 3.0], [10.0, 17.0]]),
    Path(&[[3.9, 6.5], [16.1, 13.5]]),
    Path(&[[3.9, 13.5], [16.1, 6.5]]),
    Path(&[[8.0, 4.2], [10.0, 6.2], [12.0, 4.2]]),
    Path(&[[8.0, 15.8], [10.0, 13.8], [12.0, 15.8]]),
];
