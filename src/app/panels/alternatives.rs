//! The alternatives, as a row of small pictures below sketch and texture.

use egui::{Align, Layout, Rect, RichText, Role, ScrollArea, Sense, Stroke, Ui, Vec2, WidgetInfo, pos2};

use super::card::{self, Card};
use crate::app::action::Action;
use crate::app::alternatives::Alternatives;
use crate::app::growth::Growth;
use crate::app::icons::Icon;
use crate::app::theme::Palette;

/// Side of a picture, points.
const SIDE: f32 = 92.0;
/// Height of the panel, points.
pub const HEIGHT: f32 = 160.0;
/// Side of the star, points.
const STAR: f32 = 22.0;

/// Shows them; pictures are loaded to the graphics card when they are first shown.
pub fn alternatives(ui: &mut Ui, alternatives: &mut Alternatives, growth: &Growth) -> Vec<Action> {
    let mut actions = Vec::new();
    head(ui, alternatives, growth, &mut actions);
    ui.add_space(2.0);
    ScrollArea::horizontal().id_salt("alternatives").auto_shrink([false, true]).show(ui, |ui| {
        ui.horizontal_top(|ui| {
            ui.spacing_mut().item_spacing.x = 8.0;
            for index in 0..alternatives.all.len() {
                card(ui, alternatives, index, &mut actions);
            }
        });
    });
    actions
}

fn head(ui: &mut Ui, alternatives: &Alternatives, growth: &Growth, actions: &mut Vec<Action>) {
    ui.horizontal(|ui| {
        ui.strong("Alternatives").on_hover_text("Other textures that fit the same sketch");
        let done = alternatives.all.iter().filter(|one| one.picture.is_some()).count();
        let text = match alternatives.all.len() {
            _ if growth.texture.is_none() && growth.is_empty() => "draw something first".to_owned(),
            _ if growth.texture.is_none() => "they grow when the texture is finished".to_owned(),
            all if done < all && alternatives.is_growing() => format!("growing, {done} of {all}"),
            all if done < all => format!("{done} of {all}"),
            _ => "click one to use it, star it to keep it".to_owned(),
        };
        ui.weak(text);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            if ui.small_button("Hide").on_hover_text("Hide the alternatives (A)").clicked() {
                actions.push(Action::Alternatives(false));
            }
            if !alternatives.is_complete() {
                let growing = alternatives.is_growing();
                let (name, help) = match growing {
                    true => ("Stop the alternatives", "Stop growing the alternatives"),
                    false => ("Continue the alternatives", "Grow the alternatives that are still missing"),
                };
                if ui.small_button(name).on_hover_text(help).clicked() {
                    actions.push(Action::StopAlternatives(growing));
                }
            }
        });
    });
}

/// One alternative: its picture, its star and its name.
fn card(ui: &mut Ui, alternatives: &mut Alternatives, index: usize, actions: &mut Vec<Action>) {
    let one = &alternatives.all[index];
    let (id, kept, is_done) = (one.id, one.kept, one.picture.is_some());
    let (is_open, progress) = (alternatives.is_taken(id), alternatives.progress(id));
    ui.vertical(|ui| {
        ui.spacing_mut().item_spacing.y = 3.0;
        ui.set_width(SIDE);
        let one = &mut alternatives.all[index];
        let help = one.failed.clone().unwrap_or_else(|| one.help.clone());
        let name = one.name.clone();
        // Space for the picture is reserved first, so that the star over it gets clicks before the picture does.
        let (rect, _) = ui.allocate_exact_size(Vec2::splat(SIDE), Sense::hover());
        let response = ui.interact(rect, ui.scope_id().with(("alternative", id)), Sense::click());
        response.widget_info(|| {
            let mut label = format!("Use {name}");
            if is_open {
                label.push_str(", open now");
            }
            WidgetInfo::selected(Role::Button, is_done, is_open, &label)
        });
        let words = if one.failed.is_some() { "cannot grow" } else { "…" };
        let texture = one.texture(ui.ctx()).cloned();
        card::paint(ui, rect, &Card { texture: texture.as_ref(), words, is_open, is_there: true, progress });
        card::mark(ui, rect, &response);
        if response.on_hover_text(help).clicked() && is_done {
            actions.push(Action::TakeAlternative(id));
        }
        let corner =
            Rect::from_min_size(pos2(rect.right() - STAR - 3.0, rect.top() + 3.0), Vec2::splat(STAR));
        star(ui, corner, &name, kept, id, actions);
        let font = RichText::new(&name).small();
        let font = if is_open { font.strong() } else { font };
        ui.add(egui::Label::new(font).truncate().selectable(false));
    });
}

fn star(ui: &mut Ui, rect: Rect, name: &str, kept: bool, id: u64, actions: &mut Vec<Action>) {
    let palette = Palette::current(ui.visuals());
    let button = ui.interact(rect, ui.scope_id().with(("star", id)), Sense::click());
    let back = palette.paper.gamma_multiply(0.85);
    ui.painter().circle_filled(rect.center(), 0.5 * STAR, back);
    let icon = if kept { Icon::Starred } else { Icon::Star };
    let colour = if kept { palette.axis } else { ui.style().interact(&button).text_color() };
    icon.paint(ui.painter(), rect.shrink(3.0), colour);
    if button.has_focus() {
        let stroke = Stroke::new(1.5, palette.accent);
        ui.painter().circle_stroke(rect.center(), 0.5 * STAR, stroke);
    }
    let (label, help) = match kept {
        true => (
            format!("Remove star from {name}"),
            "Kept with the document, also when the sketch changes; click to remove the star",
        ),
        false => (format!("Star {name}"), "Keep it with the document, also when the sketch changes"),
    };
    button.widget_info(|| WidgetInfo::selected(Role::Button, true, kept, &label));
    if button.on_hover_text(help).clicked() {
        actions.push(Action::KeepAlternative(id, !kept));
    }
}
