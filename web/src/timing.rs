//! Measures how long the window's own code occupies the page's thread, without painting.

use std::cell::Cell;

use dapple::app::Window;
use dapple::machine::clock::Instant;
use eframe::glow;
use egui::{Ui, Visuals};
use wasm_bindgen::prelude::*;

thread_local! {
    static LONGEST: Cell<f64> = const { Cell::new(0.0) };
}

/// Does `work` and measures it; the longest duration is kept.
pub fn watched<T>(work: impl FnOnce() -> T) -> T {
    let began = Instant::now();
    let done = work();
    LONGEST.set(LONGEST.get().max(1e3 * began.elapsed().as_secs_f64()));
    done
}

/// The window, with each frame measured.
pub struct Timed(pub Window);

impl eframe::App for Timed {
    fn ui(&mut self, ui: &mut Ui, frame: &mut eframe::Frame) {
        watched(|| eframe::App::ui(&mut self.0, ui, frame));
    }

    fn clear_color(&self, visuals: &Visuals) -> [f32; 4] {
        eframe::App::clear_color(&self.0, visuals)
    }

    fn on_exit(&mut self, context: Option<&glow::Context>) {
        eframe::App::on_exit(&mut self.0, context);
    }
}

/// The longest duration of a frame, or of opening the window, since the last call, ms.
#[wasm_bindgen]
#[must_use]
pub fn longest_frame() -> f64 {
    LONGEST.replace(0.0)
}
