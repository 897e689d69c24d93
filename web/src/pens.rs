//! Pens: the page tells their pressure, which browsers do not give with the events that the window gets. The pressure of fingers says
//! nothing, and is left out.

use std::cell::RefCell;

use egui::{Context, Event, Plugin, RawInput, TouchDeviceId, TouchId, TouchPhase, pos2};
use wasm_bindgen::prelude::*;

#[derive(Default)]
struct Pen {
    /// What it did since the last frame: phase, place, pressure.
    moves: Vec<(TouchPhase, [f32; 2], f32)>,
    /// Its pressure while it is down.
    pressure: Option<f32>,
}

thread_local! {
    static PEN: RefCell<Pen> = RefCell::default();
}

struct Pens;

impl Plugin for Pens {
    fn debug_name(&self) -> &'static str {
        "pens"
    }

    fn input_hook(&mut self, _: &Context, input: &mut RawInput) {
        PEN.with_borrow_mut(|pen| pen.tell(&mut input.events));
    }
}

impl Pen {
    fn tell(&mut self, events: &mut Vec<Event>) {
        let moves = std::mem::take(&mut self.moves);
        let mut touched = false;
        for event in events.iter_mut() {
            if let Event::Touch { force, .. } = event {
                *force = self.pressure;
                touched = true;
            }
        }
        // Some browsers treat a pen as a mouse: then nothing has touched.
        if !touched {
            let touch = |(phase, at, pressure): (TouchPhase, [f32; 2], f32)| Event::Touch {
                device_id: TouchDeviceId(u64::MAX),
                id: TouchId(0),
                phase,
                pos: pos2(at[0], at[1]),
                force: Some(pressure),
            };
            events.splice(..0, moves.into_iter().map(touch));
        }
    }
}

/// Lets the window hear of pens.
pub fn listen(context: &Context) {
    context.add_plugin(Pens);
}

/// What a pen does: `down`, `move` or `up`, where (points), with which pressure, 0..1.
#[wasm_bindgen]
pub fn pen(what: &str, x: f32, y: f32, pressure: f32) {
    let phase = match what {
        "down" => TouchPhase::Start,
        "move" => TouchPhase::Move,
        _ => TouchPhase::End,
    };
    PEN.with_borrow_mut(|pen| {
        pen.pressure = (phase != TouchPhase::End).then_some(pressure);
        pen.moves.push((phase, [x, y], pressure));
    });
}
