//! What the active layer can become, as a row of small pictures below sketch and texture.

use egui::{Align, Label, Layout, RichText, Role, ScrollArea, Sense, Ui, Vec2, WidgetInfo};

use super::card::{self, Card};
use crate::app::action::Action;
use crate::app::goals::{Goals, ShownGoal};
use crate::app::growth::Growth;
use crate::editor::edit::Edit;
use crate::editor::goal::Goal;
use crate::editor::picture_use::PictureUse;
use crate::editor::session::Session;

/// Side of a picture, points.
const SIDE: f32 = 72.0;
/// Height of the panel, points.
pub const HEIGHT: f32 = 130.0;

/// Shows them; pictures are loaded to the graphics card when they are first shown.
pub fn goals(ui: &mut Ui, goals: &mut Goals, session: &Session, growth: &Growth) -> Vec<Action> {
    let mut actions = Vec::new();
    actions.extend(head(ui, goals, session, growth));
    ui.add_space(2.0);
    ScrollArea::horizontal().id_salt("goals").auto_shrink([false, true]).show(ui, |ui| {
        ui.horizontal_top(|ui| {
            ui.spacing_mut().item_spacing.x = 8.0;
            let can = !session.is_active_frozen();
            for one in goals.all.iter_mut().filter(|one| one.is_now || one.failed.is_none()) {
                if card(ui, one, can) {
                    actions.push(taken(one.offer.goal, session.active_layer));
                }
            }
        });
    });
    actions
}

/// The action that takes a goal: for a tone, the user's own picture is asked for.
fn taken(goal: Goal, layer: usize) -> Action {
    if goal == Goal::Tone {
        Action::ChoosePicture(PictureUse::Tone)
    } else {
        Action::Edit(Edit::LayerGoal(layer, goal))
    }
}

fn head(ui: &mut Ui, goals: &Goals, session: &Session, growth: &Growth) -> Option<Action> {
    let mut action = None;
    ui.horizontal(|ui| {
        let title = match session.document().layers.len() {
            0 | 1 => "What it can become".to_owned(),
            _ => format!("What {} can become", session.layer_name(session.active_layer)),
        };
        ui.strong(title)
            .on_hover_text("Small pictures, grown from your sketch, of what else your marks can stand for");
        let text = match goals.all.len() {
            _ if session.is_active_frozen() => "frozen: click the snowflake to change it",
            0 if growth.is_empty() => "draw a spot or a stripe first",
            0 if session.kind(session.active_layer).is_none() => "draw something on this layer first",
            _ if growth.texture.is_none() || !goals.is_complete() => "growing",
            _ => "click one to take it",
        };
        ui.weak(text);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let help = "Hide these pictures (they are in the menu View)";
            let button = ui.small_button("Hide").on_hover_text(help);
            action = button.clicked().then_some(Action::Goals(false));
        });
    });
    action
}

/// One goal. Gives whether it was clicked.
fn card(ui: &mut Ui, one: &mut ShownGoal, can: bool) -> bool {
    let (goal, is_now) = (one.offer.goal, one.is_now);
    let can = can && one.can_be_taken();
    let is_new = can && !is_now;
    ui.vertical(|ui| {
        ui.spacing_mut().item_spacing.y = 3.0;
        ui.set_width(SIDE);
        let (rect, _) = ui.allocate_exact_size(Vec2::splat(SIDE), Sense::hover());
        let response = ui.interact(rect, ui.scope_id().with(("goal", goal.name())), Sense::click());
        response.widget_info(|| {
            let label = match (&one.offer.outcome, is_now) {
                (_, true) => format!("Become {}, as it is now", goal.name()),
                (Err([words, _]), _) => format!("Become {}: {words}", goal.name()),
                (Ok(_), _) => format!("Become {}", goal.name()),
            };
            WidgetInfo::selected(Role::Button, can, is_now, label)
        });
        let words = one.offer.outcome.as_ref().err().map_or("…", |[words, _]| *words);
        let texture = one.texture(ui.ctx()).cloned();
        let is_there = can || is_now;
        let shown = Card { texture: texture.as_ref(), words, is_open: is_now, is_there, progress: None };
        card::paint(ui, rect, &shown);
        if is_new {
            card::mark(ui, rect, &response);
        }
        let name = RichText::new(goal.name()).small();
        let name = if is_now { name.strong() } else { name };
        ui.add(Label::new(name).truncate().selectable(false));
        let is_clicked = response.clicked() && is_new;
        response.on_hover_ui(|ui| tooltip(ui, one));
        is_clicked
    })
    .inner
}

fn tooltip(ui: &mut Ui, one: &ShownGoal) {
    let goal = one.offer.goal;
    ui.strong(goal.name());
    ui.label(format!("{}.", goal.help()));
    if let Err([words, why]) = &one.offer.outcome {
        ui.label(format!("It {words}. {}", ended(why)));
    }
    ui.weak(format!("In How it grows: {}", goal.system()));
}

/// A sentence with its full stop.
fn ended(sentence: &str) -> String {
    if sentence.ends_with('.') { sentence.to_owned() } else { format!("{sentence}.") }
}
