//! The loop that runs the passes.

use super::correctable::{Correctable, Grown};
use super::found::MergedSpots;
use super::own_thresholds::OwnLevelling;
use super::pass::{Pass, PassSet};
use super::restarts::Restart;
use super::room::Room;
use super::rounds::Rounds;
use super::thresholds::{Levelling, Moved};
use super::trace::Trace;
use crate::synth::error::LayerError;
use crate::synth::profile;
use crate::synth::watch::Stage;

/// The result of a call of [`Passes::advance`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Step {
    /// The work, in cell updates; px that are measured count as much.
    pub updates: u64,
    /// Whether the picture has changed.
    pub seen: bool,
    /// Whether no pass is left.
    pub done: bool,
}

/// The passes over one layer, and which of them is next.
pub struct Passes {
    next: usize,
    corrects: bool,
    without: PassSet,
    rounds: Rounds,
    levelling: Option<Levelling>,
    own: Option<OwnLevelling>,
    parts: bool,
    unbiased: bool,
    trace: Trace,
}

/// The result of a pass.
enum Change {
    /// There was nothing to do.
    Nothing,
    /// Part of the work, with its amount; the pass continues.
    Part(u64),
    /// The rest of the work, with its amount.
    All(u64),
    /// Spots have been restarted.
    GrowsOn,
}

/// The order in which passes run.
const LIST: [Pass; 12] = [
    Pass::Growth,
    Pass::Thresholds,
    Pass::OwnThresholds,
    Pass::Parts,
    Pass::Keep,
    Pass::Separation,
    Pass::Room,
    Pass::Corrections,
    Pass::LeavingOut,
    Pass::Mending,
    Pass::Bias,
    Pass::Raggedness,
];

impl Passes {
    /// All passes except those in `without`; if not `corrects`, only growth and raggedness.
    #[must_use]
    pub fn new(corrects: bool, without: PassSet) -> Self {
        let mut trace = Trace::default();
        trace.begin(Pass::Growth, 0.0, 1);
        Self {
            next: 0,
            corrects,
            without,
            rounds: Rounds::default(),
            levelling: None,
            own: None,
            parts: false,
            unbiased: false,
            trace,
        }
    }

    /// The log of what the passes have seen, changed and cost so far.
    #[must_use]
    pub fn trace(&self) -> &Trace {
        &self.trace
    }

    /// Whether the layer grows now.
    #[must_use]
    pub fn grows(&self) -> bool {
        self.next == 0
    }

    /// The current stage of the work, and the share of it that is done; `growth` is the share of the growth.
    #[must_use]
    pub fn progress(&self, growth: f64) -> (Stage, f64) {
        match (LIST.get(self.next), &self.levelling) {
            (Some(Pass::Growth), _) => (Stage::Grow, growth),
            (Some(Pass::Parts), _) if self.parts => (Stage::Grow, growth),
            (Some(Pass::Thresholds), Some(levelling)) => (Stage::Refine, levelling.progress()),
            (Some(Pass::Thresholds), None) => (Stage::Refine, 0.0),
            _ => (Stage::Refine, 1.0),
        }
    }

    /// Runs the next pass on `layer`, or a part of it.
    ///
    /// # Errors
    /// Why the layer does not grow.
    pub fn advance(&mut self, layer: &mut impl Correctable, budget: u64) -> Result<Step, LayerError> {
        let before = profile::time();
        while let Some(pass) = LIST.get(self.next) {
            let change = if self.runs(*pass) { self.run(*pass, layer, budget)? } else { Change::Nothing };
            let (updates, next) = match change {
                Change::Nothing => (None, self.next + 1),
                Change::Part(updates) => (Some(updates), self.next),
                Change::All(updates) => (Some(updates), self.next + 1),
                Change::GrowsOn => (Some(layer.measured()), 0),
            };
            let seen = *pass == Pass::Growth && next == 0;
            self.next = next;
            if let Some(updates) = updates {
                self.trace.add(updates, profile::time() - before);
                // A growth ends the use of the budget, so that a following growth has a whole one: films then show equal moments.
                let has_settled = *pass == Pass::Growth && next > 0;
                let updates = if has_settled { updates.max(budget) } else { updates };
                return Ok(Step { updates, seen, done: false });
            }
        }
        layer.check()?;
        Ok(Step { updates: 0, seen: false, done: true })
    }

    fn runs(&self, pass: Pass) -> bool {
        let always = matches!(pass, Pass::Growth | Pass::Keep | Pass::Raggedness);
        (self.corrects || always) && !self.without.has(pass)
    }

    fn run(&mut self, pass: Pass, layer: &mut impl Correctable, budget: u64) -> Result<Change, LayerError> {
        if matches!(pass, Pass::Bias | Pass::Raggedness) {
            layer.check()?;
        }
        Ok(match pass {
            Pass::Growth => {
                let Grown { updates, settled } = layer.grow(budget)?;
                if settled { Change::All(updates + layer.measured()) } else { Change::Part(updates) }
            }
            Pass::Thresholds => self.level(layer),
            Pass::OwnThresholds => self.level_own(layer),
            Pass::Parts => self.separate_parts(layer),
            Pass::Keep => {
                if !self.runs(Pass::Parts) {
                    layer.compare();
                }
                layer.keep();
                Change::All(layer.measured())
            }
            Pass::Bias => {
                if self.unbiased || !layer.begin_unbiased()? {
                    return Ok(Change::Nothing);
                }
                self.unbiased = true;
                self.rounds = Rounds::default();
                self.grows_on(pass, 1.0, 1)
            }
            Pass::Raggedness => match layer.roughen() {
                None => Change::Nothing,
                Some(cells) => {
                    self.goes_on(pass, 0.0, 1);
                    Change::Part(cells)
                }
            },
            _ => self.begin_again(pass, layer),
        })
    }

    /// Restarts spots if that is worth its time.
    fn begin_again(&mut self, pass: Pass, layer: &mut impl Correctable) -> Change {
        match pass {
            Pass::Separation if self.rounds.separate(layer.merged()) => {
                let restart = Restart::separation(layer.merged());
                let surplus = restart.away.len();
                self.restart(pass, layer, &restart, surplus as f64)
            }
            Pass::Room => {
                let room = Room::beside(layer, &layer.drawn().crowded);
                if room.is_none() || !self.rounds.make_room(layer.drawn()) {
                    return Change::Nothing;
                }
                let restart = room.made(layer.drawn());
                let crowded = layer.drawn().crowded.len();
                self.restart(pass, layer, &restart, crowded as f64)
            }
            Pass::Corrections if self.rounds.is_worth(layer.drawn()) => {
                let restart = Restart::correction(layer.drawn());
                let error = layer.drawn().error;
                self.restart(pass, layer, &restart, error)
            }
            Pass::LeavingOut if self.rounds.leave_out(layer.merged()) => {
                let restart = Restart::leaving_out(layer.drawn().count, layer.merged());
                let crowded = restart.away.len();
                self.restart(pass, layer, &restart, crowded as f64)
            }
            Pass::Mending if self.rounds.mend(layer.half_grown()) => {
                let half = layer.half_grown();
                match layer.restart_half_grown() {
                    0 => Change::Nothing,
                    again => self.grows_on(pass, half as f64, again),
                }
            }
            _ => Change::Nothing,
        }
    }

    /// Moves the thresholds of the regions.
    fn level(&mut self, layer: &mut impl Correctable) -> Change {
        let levelling = self.levelling.get_or_insert_with(|| Levelling::new(layer));
        if let Some(Moved { largest, count }) = levelling.advance(layer) {
            self.goes_on(Pass::Thresholds, largest, count);
            return Change::Part(layer.measured());
        }
        self.levelling = None;
        Change::All(layer.measured())
    }

    /// Moves the thresholds of the drawn spots.
    fn level_own(&mut self, layer: &mut impl Correctable) -> Change {
        let (regions, range) = (layer.thresholds().len(), layer.range());
        let own = self.own.get_or_insert_with(|| OwnLevelling::new(layer, regions, range));
        if let Some(Moved { largest, count }) = own.advance(layer) {
            self.goes_on(Pass::OwnThresholds, largest, count);
            return Change::Part(layer.measured());
        }
        self.own = None;
        Change::All(layer.measured())
    }

    /// Separates merged spots if they are few.
    fn separate_parts(&mut self, layer: &mut impl Correctable) -> Change {
        if self.parts {
            return match layer.grow_parts() {
                Some(updates) => Change::Part(updates),
                None => {
                    self.parts = false;
                    Change::Part(layer.measured())
                }
            };
        }
        layer.compare();
        if !layer.has_parts() || !self.rounds.separate(layer.merged()) {
            return Change::Nothing;
        }
        let MergedSpots { surplus, kept, .. } = layer.merged();
        let (surplus, changed) = (surplus.len(), surplus.len() + kept.len());
        self.goes_on(Pass::Parts, surplus as f64, changed);
        layer.begin_parts();
        self.parts = true;
        Change::Part(layer.measured())
    }

    /// Restarts spots for `pass`, with the value that it `saw`.
    fn restart(&mut self, pass: Pass, layer: &mut impl Correctable, restart: &Restart, saw: f64) -> Change {
        layer.restart(restart);
        self.grows_on(pass, saw, restart.count())
    }

    /// Logs that `pass` has changed the layer, whose growth continues.
    fn grows_on(&mut self, pass: Pass, saw: f64, changed: usize) -> Change {
        self.trace.begin(pass, saw, changed);
        self.trace.add_round();
        Change::GrowsOn
    }

    /// Logs another round of `pass`.
    fn goes_on(&mut self, pass: Pass, saw: f64, changed: usize) {
        if self.trace.entries().last().is_none_or(|entry| entry.pass != pass) {
            self.trace.begin(pass, saw, changed);
        }
        self.trace.add_round();
    }
}

#[cfg(test)]
#[path = "run_tests.rs"]
mod tests;
