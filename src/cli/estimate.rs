//! How long it will take, told before it begins.

use crate::synth::drawn::region_map;
use crate::synth::plan::Plan;
use crate::synth::recipe::Document;
use crate::synth::{Engine, Training, memory, planned};
use std::io::Write;
use std::time::Instant;

/// What takes longer than this is told, seconds.
const LONG: f64 = 5.0;
/// Cell updates of the stint that tells this machine's speed now: 5 to 50 ms.
const STINT: u64 = 4_000_000;
/// A whole growth takes so many times the simulation of its layers: planning and probes before, measuring and painting
/// after. On the examples 1.1 to 1.6.
const BESIDE: f64 = 1.3;
/// px of all canvases below which a growth is over before its time is worked out.
const SMALL: f64 = 700.0 * 700.0;

/// Tells how long work will take.
pub struct Estimate<'a> {
    /// What parameters are looked up in.
    pub training: &'a Training,
    /// Nobody wants to know.
    pub quiet: bool,
}

impl Estimate<'_> {
    /// Tells on stderr how long these documents will take, each grown `times`, where that is long.
    pub fn tell(&self, documents: &[(&Document, &str)], times: f64) {
        let area = |size: [u32; 2]| f64::from(size[0]) * f64::from(size[1]);
        let px: f64 = documents.iter().map(|(document, _)| area(document.size)).sum();
        if self.quiet || times * px < SMALL {
            return;
        }
        let Some(first) = documents.first().and_then(|(document, source)| self.seconds(document, source))
        else {
            return;
        };
        // The first stands for the others, by its px.
        let seconds = times * first * px / area(documents[0].0.size);
        self.tell_seconds(seconds);
    }

    /// Tells on stderr that it will take so many seconds, where these are many.
    pub fn tell_seconds(&self, seconds: f64) {
        if !self.quiet && seconds > LONG {
            // Nobody left to tell is no reason to fail.
            let _ = writeln!(std::io::stderr(), "note: this will take {}", told(seconds));
        }
    }

    /// Seconds of one growth: cell updates to be expected, at the speed of a short stint of the engine. `None` where it
    /// cannot be planned: the growth itself says why.
    fn seconds(&self, document: &Document, source: &str) -> Option<f64> {
        let mut beneath: Option<Plan> = None;
        let (mut updates, mut speed) = (0.0, None);
        for index in 0..document.layers.len() {
            let map = region_map(document, index, source).ok()?;
            let plan = planned(document, index, source, self.training, &map, beneath.as_ref()).ok()?;
            memory::check(plan.system, document.size.map(f64::from), plan.grid).ok()?;
            let mut engine = Engine::new(&plan, document.layer_seed(index));
            updates += engine.updates_left();
            if speed.is_none() {
                let started = Instant::now();
                let before = engine.updates_left();
                engine.advance(STINT);
                let done = before - engine.updates_left();
                speed = Some(done.max(1.0) / started.elapsed().as_secs_f64().max(1e-6));
            }
            beneath = Some(plan);
        }
        Some(BESIDE * updates / speed?)
    }
}

/// Such as `about 40 s`: two digits at most.
fn told(seconds: f64) -> String {
    let coarse = |value: f64| if value < 10.0 { value.round() } else { (value / 5.0).round() * 5.0 };
    match seconds {
        s if s < 90.0 => format!("about {:.0} s", coarse(s)),
        s if s < 5400.0 => format!("about {:.0} min", coarse(s / 60.0)),
        s => format!("about {:.1} h", s / 3600.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_is_told_in_round_numbers() {
        let times = [6.4, 41.0, 119.0, 1000.0, 7200.0].map(told);
        assert_eq!(times, ["about 6 s", "about 40 s", "about 2 min", "about 15 min", "about 2.0 h"]);
    }
}
