//! The strip of alternatives at the bottom of the middle.

use egui::{
    Align, Color32, FontId, Layout, Rect, RichText, Role, ScrollArea, Sense, Shape, Stroke, StrokeKind, Ui,
    Vec2, WidgetInfo, epaint::Mesh, pos2, vec2,
};

use crate::app::Window;
use crate::app::action::Action;
use crate::app::alternatives::Alternative;
use crate::app::icons::Icon;
use crate::app::theme::Palette;

/// Points: the side of a picture, the height of the strip, the side of a star.
const SIDE: f32 = 92.0;
/// The height of the strip, points.
pub const HEIGHT: f32 = 160.0;
const STAR: f32 = 22.0;

/// The strip. Gives what is chosen.
pub fn alternatives(ui: &mut Ui, window: &mut Window) -> Vec<Action> {
    let mut actions = Vec::new();
    head(ui, window, &mut actions);
    ui.add_space(2.0);
    ScrollArea::horizontal().id_salt("alternatives").auto_shrink([false, true]).show(ui, |ui| {
        ui.horizontal_top(|ui| {
            ui.spacing_mut().item_spacing.x = 8.0;
            for index in 0..window.alternatives.all.len() {
                card(ui, window, index, &mut actions);
            }
        });
    });
    actions
}

fn head(ui: &mut Ui, window: &Window, actions: &mut Vec<Action>) {
    let alternatives = &window.alternatives;
    ui.horizontal(|ui| {
        ui.strong("Alternatives").on_hover_text("Other textures that fit the same sketch");
        let there = alternatives.all.iter().filter(|one| one.picture.is_some()).count();
        let text = match alternatives.all.len() {
            _ if window.growth.texture.is_none() && window.growth.is_empty() => {
                "draw something first".to_owned()
            }
            _ if window.growth.texture.is_none() => "they grow once the texture has settled".to_owned(),
            all if there < all && alternatives.is_growing() => format!("growing, {there} of {all}"),
            all if there < all => format!("{there} of {all}"),
            _ => "click one to take it, star it to keep it".to_owned(),
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
                    true => ("Stop these", "Give up growing the alternatives"),
                    false => ("Grow these", "Grow the alternatives that are not there yet"),
                };
                if ui.small_button(name).on_hover_text(help).clicked() {
                    actions.push(Action::StopAlternatives(growing));
                }
            }
        });
    });
}

fn card(ui: &mut Ui, window: &mut Window, index: usize, actions: &mut Vec<Action>) {
    let one = &window.alternatives.all[index];
    let (id, kept, there) = (one.id, one.kept, one.grown.is_some() && one.picture.is_some());
    let (taken, progress) = (window.alternatives.is_taken(id), window.alternatives.progress(id));
    ui.vertical(|ui| {
        ui.spacing_mut().item_spacing.y = 3.0;
        ui.set_width(SIDE);
        let one = &mut window.alternatives.all[index];
        let help = one.failed.clone().unwrap_or_else(|| one.help.clone());
        let name = one.name.clone();
        // The star lies on the picture: it must be asked first.
        let (rect, _) = ui.allocate_exact_size(Vec2::splat(SIDE), Sense::hover());
        let response = ui.interact(rect, ui.scope_id().with(("alternative", id)), Sense::click());
        response.widget_info(|| {
            let mut said = format!("Take {name}");
            if taken {
                said.push_str(", open now");
            }
            WidgetInfo::selected(Role::Button, there, taken, &said)
        });
        picture(ui, one, rect, taken, progress);
        if response.has_focus() || response.hovered() {
            let stroke = Stroke::new(1.5, Palette::of(ui.visuals()).accent);
            ui.painter().rect_stroke(rect.expand(1.0), 4.0, stroke, StrokeKind::Outside);
        }
        if response.has_focus() {
            response.scroll_to_me(None);
        }
        if response.on_hover_text(help).clicked() && there {
            actions.push(Action::TakeAlternative(id));
        }
        let corner =
            Rect::from_min_size(pos2(rect.right() - STAR - 3.0, rect.top() + 3.0), Vec2::splat(STAR));
        star(ui, corner, &name, kept, id, actions);
        let font = RichText::new(&name).small();
        let font = if taken { font.strong() } else { font };
        ui.add(egui::Label::new(font).truncate().selectable(false));
    });
}

/// The small picture, or what is there in its place.
fn picture(ui: &Ui, one: &mut Alternative, rect: Rect, taken: bool, progress: Option<f32>) {
    let palette = Palette::of(ui.visuals());
    let painter = ui.painter();
    painter.rect_filled(rect, 4.0, palette.desk);
    let failed = one.failed.is_some();
    if let Some(texture) = one.texture(ui.ctx()) {
        let size = texture.size_vec2();
        let shown = Rect::from_center_size(rect.center(), size * (SIDE / size.max_elem()));
        let mut mesh = Mesh::with_texture(texture.id());
        mesh.add_rect_with_uv(shown, Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0)), Color32::WHITE);
        painter.add(Shape::mesh(mesh));
    } else {
        let text = if failed { "cannot grow" } else { "…" };
        let weak = ui.visuals().weak_text_color();
        let center = egui::Align2::CENTER_CENTER;
        painter.text(rect.center(), center, text, FontId::proportional(11.5), weak);
    }
    if let Some(share) = progress {
        let bar = Rect::from_min_size(rect.left_bottom() - vec2(0.0, 4.0), vec2(rect.width() * share, 4.0));
        painter.rect_filled(bar, 2.0, palette.accent);
    }
    let border = if taken { Stroke::new(2.5, palette.accent) } else { Stroke::new(1.0, palette.border) };
    painter.rect_stroke(rect, 4.0, border, StrokeKind::Inside);
}

fn star(ui: &mut Ui, rect: Rect, name: &str, kept: bool, id: u64, actions: &mut Vec<Action>) {
    let palette = Palette::of(ui.visuals());
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
    let (said, help) = match kept {
        true => (format!("Let {name} go"), "Kept; click to let it go with the others of its sketch"),
        false => (
            format!("Keep {name}"),
            "Keep it in the strip, with all of its document, when the sketch changes",
        ),
    };
    button.widget_info(|| WidgetInfo::selected(Role::Button, true, kept, &said));
    if button.on_hover_text(help).clicked() {
        actions.push(Action::KeepAlternative(id, !kept));
    }
}
