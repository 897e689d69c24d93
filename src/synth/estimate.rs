//! How long a growth will take and what it needs, told before it begins.

use super::drawn::region_map;
use super::plan::Plan;
use super::recipe::Document;
use super::{Engine, Training, memory, planned};
use std::time::Instant;

/// Cell updates of the stint that tells this machine's speed now: 5 to 50 ms.
const STINT: u64 = 4_000_000;
/// A whole growth takes so many times the simulation of its layers: planning and probes before, measuring and painting
/// after. On the examples 1.1 to 1.6.
const BESIDE: f64 = 1.3;

/// What a growth takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Needs {
    /// Time on this machine, as busy as it is now.
    pub seconds: f64,
    /// Bytes of memory.
    pub bytes: f64,
}

impl Needs {
    /// Of one growth: cell updates to be expected, at the speed of a short stint of the engine. `None` where it cannot be
    /// planned: the growth itself says why.
    #[must_use]
    pub fn of(document: &Document, source: &str, training: &Training) -> Option<Self> {
        let mut beneath: Option<Plan> = None;
        let (mut updates, mut speed, mut bytes) = (0.0, None, 0.0_f64);
        for index in 0..document.layers.len() {
            let map = region_map(document, index, source).ok()?;
            let plan = planned(document, index, source, training, &map, beneath.as_ref()).ok()?;
            bytes = bytes.max(memory::needed(plan.system, document.size.map(f64::from), plan.grid));
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
        Some(Self { seconds: BESIDE * updates / speed?, bytes })
    }
}

/// Such as `about 40 s`: two digits at most.
#[must_use]
pub fn told(seconds: f64) -> String {
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
