//! A button with a picture for each place where the marks of a layer can grow, relative to the marks beneath.

use egui::{Button, Color32, Painter, Pos2, Rect, Response, Shape, Stroke, Ui, Vec2, pos2, vec2};

use crate::app::theme::Palette;
use crate::document::After;

/// Size of a button, points.
pub const SIZE: Vec2 = vec2(43.0, 38.0);

/// The centres of the marks beneath in a picture of 40 × 28.
const BENEATH: [[f32; 2]; 3] = [[9.5, 8.5], [30.0, 8.0], [19.5, 20.5]];

/// Its label.
#[must_use]
pub fn name(after: After) -> &'static str {
    match after {
        After::Between => "Between",
        After::Near => "Near",
        After::Around => "Around",
        After::Net => "Net",
        After::Inside => "Inside",
    }
}

/// Its tooltip.
#[must_use]
pub fn help(after: After) -> &'static str {
    match after {
        After::Between => {
            "Marks grow between the marks of the layers beneath and keep away from them, like the small spots \
             of a cheetah"
        }
        After::Near => {
            "Marks grow between the marks beneath, and are the rarer the farther away from them they are, like the \
             specks at the edges of the patches of a cow"
        }
        After::Around => {
            "Rings grow around the marks beneath, like the rosettes of a leopard; the drawn lines set their width"
        }
        After::Net => {
            "A connected net grows in the space between the marks beneath, as on a giraffe; the drawn lines \
             set its width"
        }
        After::Inside => {
            "A smaller mark grows inside each mark of the layer beneath, which itself is not shown"
        }
    }
}

/// The button; disabled where the choice is refused. Its tooltip then shows the reason.
pub fn button(ui: &mut Ui, after: After, chosen: bool, refused: Option<&str>) -> Response {
    ui.add_enabled_ui(refused.is_none(), |ui| {
        let button = Button::new("").selected(chosen).min_size(SIZE);
        let response = ui.add_sized(SIZE, button).accessible_name(format!("Grows: {}", name(after)));
        let own = if chosen {
            ui.visuals().selection.stroke.color
        } else {
            ui.style().interact(&response).text_color()
        };
        let own = if refused.is_some() { own.gamma_multiply(0.35) } else { own };
        let beneath = if chosen {
            own.gamma_multiply(0.45)
        } else if refused.is_some() {
            own.gamma_multiply(0.5)
        } else {
            Palette::current(ui.visuals()).accent.gamma_multiply(0.55)
        };
        let picture = Rect::from_center_size(response.rect.center(), vec2(40.0, 28.0));
        paint(ui.painter(), picture.min, after, own, beneath);
        let response = response.on_hover_ui(|ui| {
            ui.strong(name(after));
            ui.label(help(after));
        });
        response.on_disabled_hover_ui(|ui| {
            ui.strong(name(after));
            ui.label(help(after));
            ui.weak(refused.unwrap_or_default());
        })
    })
    .inner
}

fn paint(painter: &Painter, corner: Pos2, after: After, own: Color32, beneath: Color32) {
    let at = |[x, y]: [f32; 2]| corner + vec2(x, y);
    match after {
        After::Between => {
            dots(painter, corner, 4.6, beneath);
            for place in [[20.0, 6.0], [3.0, 20.0], [9.0, 24.0], [31.0, 22.5], [37.0, 17.0], [27.0, 15.2]] {
                painter.circle_filled(at(place), 1.9, own);
            }
        }
        After::Near => {
            dots(painter, corner, 4.6, beneath);
            for place in [[16.4, 8.0], [3.0, 13.2], [10.4, 15.6], [26.8, 19.4], [36.6, 9.6], [30.4, 14.8]] {
                painter.circle_filled(at(place), 1.5, own);
            }
        }
        After::Around => {
            dots(painter, corner, 3.4, beneath);
            for place in BENEATH {
                painter.circle_stroke(at(place), 6.6, Stroke::new(2.2, own));
            }
        }
        After::Net => {
            dots(painter, corner, 4.6, beneath);
            let web: [&[[f32; 2]]; 3] = [
                &[[20.0, -0.5], [20.2, 11.0], [9.0, 17.5], [-0.5, 16.5]],
                &[[20.2, 11.0], [30.5, 17.0], [40.5, 15.5]],
                &[[9.0, 17.5], [8.0, 28.5]],
            ];
            for line in web.into_iter().chain([&[[30.5, 17.0], [32.0, 28.5]][..]]) {
                let points = line.iter().map(|point| at(*point)).collect();
                painter.add(Shape::line(points, Stroke::new(2.2, own)));
            }
        }
        After::Inside => {
            for place in BENEATH {
                let ring: Vec<Pos2> = (0..=24).map(|i| on_circle(at(place), 6.4, i)).collect();
                painter.extend(Shape::dashed_line(&ring, Stroke::new(1.2, beneath), 2.0, 2.0));
                painter.circle_filled(at(place), 3.0, own);
            }
        }
    }
}

fn on_circle(center: Pos2, radius: f32, step: u8) -> Pos2 {
    let (sin, cos) = (std::f32::consts::TAU * f32::from(step) / 24.0).sin_cos();
    pos2(center.x + radius * cos, center.y + radius * sin)
}

fn dots(painter: &Painter, corner: Pos2, radius: f32, colour: Color32) {
    for [x, y] in BENEATH {
        painter.circle_filled(corner + vec2(x, y), radius, colour);
    }
}
