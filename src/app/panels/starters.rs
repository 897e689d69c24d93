//! What a new sketch can begin with: small pictures in the row below sketch and texture, below an empty canvas, or at its lower edge,
//! as many as have room.

use egui::{
    Align2, Color32, FontId, Id, Rect, Role, Sense, Shape, Stroke, StrokeKind, Ui, Vec2, WidgetInfo,
    epaint::EllipseShape, pos2, vec2,
};

use crate::app::action::{Action, Beginning};
use crate::app::assets;
use crate::app::examples;
use crate::app::panels::layer_details::small_picture;
use crate::app::theme::Palette;

/// The example of an animal.
const ANIMAL: &str = "turk-2-lower-right-leopard";
/// The largest and the smallest side of a picture, points.
const SIDES: [f32; 2] = [76.0, 48.0];
/// Space between two pictures, points.
const GAP: f32 = 14.0;
/// Height of the texts above and below the pictures, points.
const TEXT: f32 = 20.0;

/// A starter.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Starter {
    Spots,
    Stripes,
    Animal,
    Cow,
    /// The coat with this name, which has a finish.
    Coat(&'static str),
}

impl Starter {
    const ALL: [(Self, &'static str); 7] = [
        (Self::Spots, "Spots"),
        (Self::Stripes, "Stripes"),
        (Self::Animal, "A leopard"),
        (Self::Cow, "A cow"),
        (Self::Coat("tiger-coat"), "Tiger fur"),
        (Self::Coat("jaguar-coat"), "Jaguar fur"),
        (Self::Coat("ball-python-coat"), "Snake skin"),
    ];

    fn action(self) -> Action {
        match self {
            Self::Spots => Action::Begin(Beginning::Spots),
            Self::Stripes => Action::Begin(Beginning::Stripes),
            Self::Animal => Action::Begin(Beginning::Example(ANIMAL)),
            Self::Cow => Action::Begin(Beginning::Cow),
            Self::Coat(name) => Action::Begin(Beginning::Coat(name)),
        }
    }
}

/// Shows them below `paper`, the canvas in `room`; where there is no space, at its lower edge.
pub fn starters(ui: &mut Ui, room: Rect, paper: Rect) -> Option<Action> {
    let wide = room.width().min(paper.width().max(220.0)) - 2.0 * GAP;
    // As many as have room side by side.
    let shown = (((wide + GAP) / (SIDES[1] + GAP)) as usize).clamp(1, Starter::ALL.len());
    let gaps = (shown - 1) as f32 * GAP;
    let side = ((wide - gaps) / shown as f32).clamp(SIDES[1], SIDES[0]);
    let height = side + 2.0 * TEXT;
    let below = paper.bottom().max(room.top()) + 8.0;
    let top = if below + height <= room.bottom() - 4.0 { below } else { room.bottom() - height - 6.0 };
    let weak = ui.visuals().weak_text_color();
    let font = FontId::proportional(13.0);
    let text = pos2(room.center().x, top + 0.5 * TEXT);
    ui.painter().text(text, Align2::CENTER_CENTER, "Or begin with", font, weak);
    let all = shown as f32 * side + gaps;
    let mut action = None;
    for (index, (starter, name)) in Starter::ALL.into_iter().take(shown).enumerate() {
        let left = room.center().x - 0.5 * all + index as f32 * (side + GAP);
        let place = Rect::from_min_size(pos2(left, top + TEXT), Vec2::splat(side));
        if card(ui, place, starter, name) {
            action = Some(starter.action());
        }
    }
    action
}

/// One picture with its name. Gives whether it was clicked.
fn card(ui: &Ui, rect: Rect, starter: Starter, name: &str) -> bool {
    let colours = Palette::current(ui.visuals());
    let response = ui.interact(rect, Id::unique(("starter", name)), Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, name));
    let painter = ui.painter();
    painter.rect_filled(rect, 6.0, colours.paper);
    picture(ui, rect.shrink(3.0), starter, colours);
    let is_marked = response.hovered() || response.has_focus();
    let border = if is_marked { Stroke::new(2.0, colours.accent) } else { Stroke::new(1.0, colours.border) };
    painter.rect_stroke(rect, 6.0, border, StrokeKind::Outside);
    let at = pos2(rect.center().x, rect.bottom() + 0.5 * TEXT + 1.0);
    let text = ui.visuals().text_color();
    painter.text(at, Align2::CENTER_CENTER, name, FontId::proportional(12.5), text);
    let help = match starter {
        Starter::Spots => "Draws six spots; their texture grows at once",
        Starter::Stripes => "Draws four lines; their texture grows at once",
        Starter::Animal => "Draws spots and rings on two layers; their texture grows at once",
        Starter::Cow => "Fills the canvas with blotches; nothing has to be drawn",
        Starter::Coat(_) => "A seamless tile of 640 × 640 px with a finish, on which a few marks are drawn",
    };
    response.on_hover_text(help).clicked()
}

fn picture(ui: &Ui, rect: Rect, starter: Starter, colours: &Palette) {
    let painter = ui.painter_at(rect);
    let at = |[x, y]: [f32; 2]| rect.min + vec2(x, y) * rect.size();
    let ink = colours.ink(0).gamma_multiply(0.85);
    match starter {
        Starter::Spots => {
            for center in [
                [0.2, 0.22],
                [0.55, 0.18],
                [0.86, 0.34],
                [0.34, 0.54],
                [0.68, 0.62],
                [0.22, 0.84],
                [0.52, 0.92],
            ] {
                painter.add(Shape::Ellipse(EllipseShape {
                    center: at(center),
                    radius: vec2(0.11, 0.08) * rect.width(),
                    angle: 25_f32.to_radians(),
                    fill: ink,
                    stroke: Stroke::NONE,
                }));
            }
        }
        Starter::Stripes => {
            for y in [0.12, 0.36, 0.6, 0.84, 1.08] {
                painter.line_segment(
                    [at([-0.1, y]), at([1.1, y - 0.22])],
                    Stroke::new(0.09 * rect.width(), ink),
                );
            }
        }
        Starter::Animal => example(ui, rect, ANIMAL),
        Starter::Coat(name) => example(ui, rect, name),
        Starter::Cow => {
            let picture = small_picture::of_labels("random");
            if let Some(texture) = picture.and_then(|asset| assets::texture(ui.ctx(), asset)) {
                // Its middle square.
                let middle = Rect::from_min_max(pos2(1.0 / 6.0, 0.0), pos2(5.0 / 6.0, 1.0));
                painter.image(texture.id(), rect, middle, Color32::WHITE);
            }
        }
    }
}

/// The picture of an example.
fn example(ui: &Ui, rect: Rect, name: &str) {
    if let Some(texture) = examples::thumbnail(ui.ctx(), name) {
        let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
        ui.painter_at(rect).image(texture.id(), rect, whole, Color32::WHITE);
    }
}
