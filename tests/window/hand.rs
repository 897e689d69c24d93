//! A window and the hand that works in it.

use std::f64::consts::TAU;
use std::time::{Duration, Instant};

use dapple::app::{Phase, Settings, Start, Tool, Window};
use dapple::marks::{Ellipse, Line};
use dapple::synth::recipe::{Document, Stroke};
use eframe::egui::{Key, Modifiers, Pos2, Rect, Theme, Vec2, pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable, by};

/// A window on a desk of its own.
pub type Desk = Harness<'static, Window>;

/// A window of 1280 × 800 points, as after the first hint.
pub fn window() -> Desk {
    opened(Start::default(), vec2(1280.0, 800.0), Theme::Light)
}

/// A window that begins with something.
pub fn opened(mut start: Start, size: Vec2, theme: Theme) -> Desk {
    start.settings.hint_seen = true;
    begun(start, size, theme)
}

/// A window as it is; the hint may be there.
pub fn begun(mut start: Start, size: Vec2, theme: Theme) -> Desk {
    start.settings.theme = theme.into();
    let mut start = Some(start);
    let mut window: Option<Window> = None;
    let mut desk = Harness::builder().with_size(size).with_theme(theme).with_step_dt(1.0 / 60.0).build_ui_state(
        move |ui, window: &mut Option<Window>| {
            let window = window.get_or_insert_with(|| Window::new(ui.ctx(), start.take().unwrap_or_default()));
            window.ui(ui);
        },
        window.take(),
    );
    desk.run_steps(3);
    desk_of(desk)
}
