//! The selected stop: its colour, its position, its neighbours.

use egui::{
    Button, DragValue, Popup, PopupCloseBehavior, RichText, Role, Sense, StrokeKind, Ui, WidgetInfo, vec2,
};

use super::grip::rounded;
use super::hex_field::hex_field;
use super::{ColourPanel, picker, shown};
use crate::app::checkerboard;
use crate::app::icons::Icon;
use crate::app::theme::Palette;
use crate::app::units::number_field;
use crate::document::{Colours, Stop};

/// Shows it.
pub fn stop(ui: &mut Ui, panel: &mut ColourPanel, colours: &mut Colours) {
    panel.retain_existing(colours);
    let index = panel.stop;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 6.0;
        swatch(ui, panel, &mut colours.stops[index]);
        hex_field(ui, panel, &mut colours.stops[index], "Colour in hexadecimal digits");
        let help = "Take the colour from the reference picture or the texture: click there. Escape cancels";
        let dropper =
            Icon::Dropper.sized_button(ui, "Take a colour from a picture", panel.picking, vec2(26.0, 24.0));
        if dropper.on_hover_text(help).clicked() {
            panel.picking = !panel.picking;
        }
        let before = colours.stops[index].at;
        let mut at = before;
        let field = DragValue::new(&mut at).range(0.0..=1.0).speed(0.002).max_decimals(3);
        let field = ui.add(number_field(field, "")).accessible_name("Position of the stop");
        field.on_hover_text(
            "The place from ground to mark that has this colour: 0 = the ground, 0.5 = the edge of a mark, 1 \
             = its centre",
        );
        if at != before {
            let moved = colours.shift(index, rounded(at));
            panel.choose(moved, colours);
        }
    });
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 3.0;
        ui.spacing_mut().button_padding.x = 5.0;
        let (index, count) = (panel.stop, colours.stops.len());
        let swaps = [
            ("Swap with previous", index.checked_sub(1)),
            ("Swap with next", Some(index + 1).filter(|next| *next < count)),
        ];
        for (text, other) in swaps {
            let button = ui.add_enabled(other.is_some(), small(text));
            let button = button.on_hover_text("Swap the colours of the two stops");
            if let (true, Some(other)) = (button.clicked(), other) {
                colours.swap(index, other);
                panel.choose(other, colours);
            }
        }
    });
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 3.0;
        ui.spacing_mut().button_padding.x = 5.0;
        let (index, count) = (panel.stop, colours.stops.len());
        let reverse = ui.add(small("Reverse"));
        if reverse.on_hover_text("Reverse all colours and transitions").clicked() {
            colours.reverse();
            panel.choose(count - 1 - index, colours);
        }
        let remove = ui.add_enabled(count > 1, small("Remove"));
        if remove.on_hover_text("Remove this stop (one must remain)").clicked() && colours.remove(index) {
            panel.choose(index.min(count - 2), colours);
        }
    });
}

fn small(text: &str) -> Button<'_> {
    Button::new(RichText::new(text).small()).min_size(vec2(0.0, 22.0))
}

/// A button in the stop's colour that opens the picker.
fn swatch(ui: &mut Ui, panel: &mut ColourPanel, stop: &mut Stop) {
    let (rect, response) = ui.allocate_exact_size(vec2(40.0, 24.0), Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, "Pick a colour"));
    let palette = Palette::current(ui.visuals());
    if stop.alpha < u8::MAX {
        checkerboard::paint(ui.painter(), rect);
    }
    ui.painter().rect_filled(rect, 4.0, shown(stop.rgba()));
    let border = if response.has_focus() { palette.accent } else { palette.border };
    ui.painter().rect_stroke(
        rect,
        4.0,
        (if response.has_focus() { 2.0 } else { 1.0 }, border),
        StrokeKind::Inside,
    );
    let id = Popup::default_response_id(&response);
    let by_key = std::mem::take(&mut panel.open_picker);
    if by_key {
        Popup::open_id(ui.ctx(), id);
    }
    let popup = Popup::from_toggle_button_response(&response);
    let popup = popup.close_behavior(PopupCloseBehavior::CloseOnClickOutside);
    popup.show(|ui| picker::picker(ui, panel, stop, by_key));
    response.on_hover_text("The colour of the selected stop; click to pick another");
}
