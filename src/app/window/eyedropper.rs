//! Taking a colour from the reference picture or the texture.

use egui::{Align2, Color32, CursorIcon, FontId, Id, LayerId, Order, Pos2, Sense, Stroke, Ui, vec2};

use super::Window;
use super::places::Places;
use crate::app::action::{Action, Tab};
use crate::app::panels;
use crate::app::theme::Palette;

/// The vector from the pointer to the sample of the colour under it, points.
const OFFSET: egui::Vec2 = vec2(22.0, 22.0);

impl Window {
    /// While the user picks a colour: shows the colour under the pointer, and takes it on a click.
    pub(super) fn eyedropper(&mut self, ui: &mut Ui, places: &Places) -> Option<Action> {
        self.colour.picking &= self.tab == Tab::Colour && self.shows_column(ui.ctx());
        if !self.colour.picking {
            return None;
        }
        let [sketch, texture] = places.rooms;
        let response = ui.interact(sketch.union(texture), Id::unique("eyedropper"), Sense::click());
        let at = response.hover_pos()?;
        ui.ctx().set_cursor_icon(CursorIcon::Crosshair);
        let colour = self.colour_at(places, at);
        let palette = Palette::current(ui.visuals());
        let painter = ui.ctx().layer_painter(LayerId::new(Order::Tooltip, Id::unique("picked colour")));
        let center = at + OFFSET;
        match colour {
            Some([red, green, blue]) => {
                let fill = Color32::from_rgb(red, green, blue);
                painter.circle(center, 13.0, fill, Stroke::new(2.0, palette.paper));
                painter.circle_stroke(center, 14.5, Stroke::new(1.0, palette.border));
            }
            None => {
                let text = "No colour here";
                let font = FontId::proportional(12.0);
                painter.text(center, Align2::LEFT_CENTER, text, font, ui.visuals().text_color());
            }
        }
        let colour = colour.filter(|_| response.clicked())?;
        Some(panels::picked(&self.session, &mut self.colour, colour))
    }

    /// The colour at a position on the screen, of the reference picture or of the texture.
    fn colour_at(&self, places: &Places, at: Pos2) -> Option<[u8; 3]> {
        let size = self.session.document().size;
        let [left, right] = places.rooms;
        let on_texture = if self.over {
            (at.x > right.left() + self.curtain * right.width()).then_some(right)
        } else {
            right.contains(at).then_some(right)
        };
        match on_texture {
            Some(room) => self.texture_colour(self.texture.view.to_canvas(room, at)),
            None => self.canvas.reference.colour_at(self.canvas.view.to_canvas(left, at), size),
        }
    }

    /// The colour of the texture at a point of the canvas, px; outside the canvas, the colour of the tile that is shown
    /// there. `None` where the texture is transparent.
    fn texture_colour(&self, at: [f64; 2]) -> Option<[u8; 3]> {
        let picture = self.growth.picture.as_ref()?;
        let canvas = picture.canvas.map(f64::from);
        let share = [0, 1].map(|axis| at[axis] / canvas[axis]);
        let last = if self.texture.tiled { 2.0 } else { 1.0 };
        if share.iter().any(|share| !(0.0..last).contains(share)) {
            return None;
        }
        let [x, y] = [0, 1].map(|axis| {
            let side = picture.image.size[axis];
            ((share[axis].fract() * side as f64) as usize).min(side.saturating_sub(1))
        });
        let px = picture.image.pixels.get(y * picture.image.size[0] + x)?;
        let [red, green, blue, alpha] = px.to_srgba_unmultiplied();
        (alpha > 0).then_some([red, green, blue])
    }
}
