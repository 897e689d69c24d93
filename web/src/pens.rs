//! The pressure of pens. The page reports it, because browsers do not include it in the events that the window gets.
//! The pressure of fingers has no meaning and is ignored.

use std::cell::RefCell;

use egui::{Context, Event, Plugin, RawInput, TouchDeviceId, TouchId, TouchPhase, pos2};
use wasm_bindgen::prelude::*;

#[derive(Default)]
struct Pen {
    /// The events of the pen since the last frame: phase, place, pressure.
    moves: Vec<(TouchPhase, [f32; 2], f32)>,
    /// The pressure of the pen while it touches.
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
        // Some browsers treat a pen as a mouse, so that no touch was reported.
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

/// Passes the events of pens to the window.
pub fn listen(context: &Context) {
    context.add_plugin(Pens);
}

/// An event of a pen: `down`, `move` or `up`, the place (points), and the pressure, 0..1.
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
