//! The growth of a layer of pairs.
//!
//! ```text
//!  pieces of a maze ─▶ lines that threads begin from, direction by direction ─▶ grow ─▶ measure ─▶ corrected: grow again
//! ```

use crate::document::Document;
use crate::grid::{Domain, Field};
use crate::rd::pairs::{PairGrowth, PairKind, PairStart};
use crate::synth::error::LayerError;
use crate::synth::kind::{Advanced, Beneath, Kind, Request, Seen, Setting};
use crate::synth::marks::Marks;
use crate::synth::marks::grow::MarksGrowth;
use crate::synth::marks::grow::obstacles::obstacles;
use crate::synth::memory;
use crate::synth::pairs::grow::maze_pieces::maze_pieces;
use crate::synth::pairs::grow::noise::noise_around_lines;
use crate::synth::pairs::grow::seed_lines::{SeedLines, from_middles, from_phase};
use crate::synth::pairs::grow::{begin, correct, level_of_width, measure, most_corrections, times};
use crate::synth::pairs::grown::{GrownPairs, OverUnder, PairPattern};
use crate::synth::pairs::plan::{MazeForm, PairForm, PairPlan};
use crate::synth::pairs::stripes_of_threads::stripes_of;
use crate::synth::profile::{Section, during};
use crate::synth::watch::Stage;

/// A layer of pairs that grows.
pub struct PairsGrowth<'a> {
    setting: Setting<'a>,
    plan: PairPlan,
    /// The documents of stripes along which the threads of a direction without a phase begin, by direction.
    stripes: Vec<Document>,
    /// Factors of the sizes after the corrections so far.
    factors: Vec<f64>,
    /// Number of corrections so far.
    corrected: usize,
    /// Steps before this round, and the time of the rounds before, in 1/b.
    before: (u64, f64),
    state: State<'a>,
}

/// The current part of the work.
enum State<'a> {
    /// The pieces of a maze are laid.
    Pieces,
    /// Lines are laid from which the threads of this direction begin.
    Lines(usize, SeedLines),
    /// Stripes grow, along which the threads of this direction begin.
    Stripes(usize, SeedLines, Box<MarksGrowth<'a>>),
    /// Pairs grow, in this round until the step that it holds.
    Grow(Box<Round>),
    /// The pairs are grown.
    Grown(Box<GrownPairs>),
    /// A step of the work has failed.
    Failed,
}

/// A round of a growth.
struct Round {
    growth: PairGrowth,
    drawn: PairStart,
    /// The step at which it ends.
    last: u64,
}

impl<'a> PairsGrowth<'a> {
    /// Begins to grow `plan` above the layers `beneath`.
    pub fn begin(mut plan: PairPlan, index: usize, beneath: &Beneath, setting: Setting<'a>) -> Self {
        let obstacles = during(Section::LayOut, || obstacles(beneath, plan.grid.size, &|_| false));
        plan.obstacles = obstacles;
        let document = beneath.document;
        let threads = plan.threads.iter().filter(|_| plan.crosses());
        let stripes = threads.map(|threads| stripes_of(document, threads, setting.seed, index)).collect();
        let factors = vec![1.0; plan.threads.len()];
        Self { setting, plan, stripes, factors, corrected: 0, before: (0, 0.0), state: State::Pieces }
    }

    /// Does a part of the work.
    ///
    /// # Errors
    /// Why the layer does not grow.
    pub fn advance(&mut self, budget: u64) -> Result<Advanced, LayerError> {
        let cells = self.plan.grid.cells();
        match std::mem::replace(&mut self.state, State::Failed) {
            State::Pieces => {
                self.lay_pieces();
                Ok(Advanced::by(cells))
            }
            State::Lines(direction, lines) => {
                self.lay_lines(direction, lines)?;
                Ok(Advanced::by(cells))
            }
            State::Stripes(direction, mut lines, mut stripes) => {
                let advanced = stripes.advance(budget)?;
                if !advanced.done {
                    self.state = State::Stripes(direction, lines, stripes);
                    return Ok(Advanced { seen: false, ..advanced });
                }
                let [nx, ny] = self.plan.grid.size;
                let grown = stripes.complete().ok_or(LayerError::NoPattern)?;
                let pattern = grown.pattern().field(nx, ny);
                let from_middle = from_middles(&pattern, &self.plan.threads[direction], &self.plan);
                lines.add(&self.plan, direction, &from_middle);
                self.state = State::Lines(direction + 1, lines);
                Ok(Advanced::by(cells))
            }
            State::Grow(mut round) => {
                let Round { growth, last, .. } = &mut *round;
                let left = last.saturating_sub(growth.steps());
                if left == 0 {
                    return self.measure(*round);
                }
                let before = growth.steps();
                let steps = (budget / cells as u64).clamp(1, left);
                during(Section::Steps, || growth.advance(steps));
                let updates = (growth.steps() - before) * cells as u64;
                self.state = State::Grow(round);
                Ok(Advanced::seen(updates))
            }
            State::Grown(grown) => {
                self.state = State::Grown(grown);
                Ok(Advanced::done(0))
            }
            State::Failed => Err(LayerError::NoPattern),
        }
    }

    /// Lays the pieces of a maze; systems that begin from noise begin to grow.
    fn lay_pieces(&mut self) {
        match self.plan.kind() {
            PairKind::Weave => self.state = State::Lines(0, SeedLines::none(&self.plan)),
            PairKind::Maze => {
                let laid = during(Section::Start, || maze_pieces(&self.plan, self.setting.seed));
                self.plan.form = PairForm::Maze(MazeForm { pieces: laid });
                self.state = State::Lines(0, SeedLines::none(&self.plan));
            }
            PairKind::Stripes | PairKind::Stucco => {
                let seed = self.setting.seed;
                let reaction = during(Section::Start, || noise_around_lines(&self.plan, seed));
                self.start(PairStart::Drawn(reaction));
            }
        }
    }

    /// Lays the lines of one direction, or begins to grow stripes for them; after the last direction the pairs begin.
    fn lay_lines(&mut self, direction: usize, mut lines: SeedLines) -> Result<(), LayerError> {
        let Some(threads) = self.plan.threads.get(direction) else {
            lines.beside_obstacles(&self.plan);
            self.plan.raised = lines.raised;
            self.start(PairStart::Drawn(lines.reaction));
            return Ok(());
        };
        match during(Section::Start, || from_phase(threads, &self.plan)) {
            Some(from_middle) => {
                lines.add(&self.plan, direction, &from_middle);
                self.state = State::Lines(direction + 1, lines);
            }
            None => {
                let stripes = self.stripes(direction)?;
                self.state = State::Stripes(direction, lines, Box::new(stripes));
            }
        }
        Ok(())
    }

    /// The growth of the stripes that the threads of one direction begin along.
    fn stripes(&self, direction: usize) -> Result<MarksGrowth<'a>, LayerError> {
        let Setting { source, training, memory, .. } = self.setting;
        let document = &self.stripes[direction];
        let size = self.plan.canvas().size;
        let request = Request { document, index: 0, source, size, training, memory, beneath: None };
        let plan = Marks::read(&request)?;
        let needed = Marks::bytes(&plan, size, Marks::planned(&plan).grid.size);
        memory::fits(needed, size, Marks::planned(&plan).grid.size, memory)?;
        let seed = document.layer_seed(0);
        let setting = Setting { seed, corrects: true, concentrations: false, ..self.setting };
        Marks::begin(plan, &Beneath { document, layers: Vec::new() }, setting)
    }

    /// Begins the first round.
    fn start(&mut self, drawn: PairStart) {
        let growth = begin(&self.plan, &self.factors, &drawn);
        self.grow(growth, drawn);
    }

    /// Begins a round.
    fn grow(&mut self, growth: PairGrowth, drawn: PairStart) {
        let time = times(self.plan.kind())[self.corrected.min(1)];
        let last = growth.steps_in(time);
        self.state = State::Grow(Box::new(Round { growth, drawn, last }));
    }

    /// Largest number of corrections.
    fn most_corrections(&self) -> usize {
        if self.setting.corrects { most_corrections(self.plan.kind()) } else { 0 }
    }

    /// Measures the grown pairs; begins another round if a correction is useful.
    fn measure(&mut self, round: Round) -> Result<Advanced, LayerError> {
        let Round { growth, drawn, .. } = round;
        let plan = &self.plan;
        let work = plan.grid.cells() * plan.threads.len();
        let steps = self.before.0 + growth.steps();
        let differences = plan.shown(growth.differences());
        if differences.iter().any(|field| field.values.iter().any(|value| !value.is_finite())) {
            return Err(LayerError::NoPattern);
        }
        let levels = if self.setting.corrects && plan.kind() != PairKind::Weave {
            during(Section::Measure, || vec![level_of_width(plan, &differences[0])])
        } else {
            plan.levels()
        };
        let measured = during(Section::Measure, || measure(plan, &differences, &levels));
        if measured.iter().all(|threads| threads.got.is_none()) {
            return Err(LayerError::Blank { what: "no threads", advice: LayerError::MARKS });
        }
        let again = self.corrected < self.most_corrections()
            && correct(plan, &measured, &mut self.factors, self.corrected);
        if !again {
            let concentrations =
                if self.setting.concentrations { growth.concentrations() } else { Vec::new() };
            let over = OverUnder::new(plan.over, self.setting.seed, &plan.threads, &plan.canvas());
            let plan = plan.clone();
            let grown = GrownPairs { plan, steps, differences, levels, measured, concentrations, over };
            self.state = State::Grown(Box::new(grown));
            return Ok(Advanced::done(work));
        }
        let time = times(plan.kind())[self.corrected.min(1)];
        self.before = (steps, self.before.1 + time);
        self.corrected += 1;
        // Lines from noise keep their distances.
        let from_noise = plan.kind() == PairKind::Stripes;
        let grown = (!from_noise).then(|| PairStart::Grown(growth.concentrations()));
        let growth = begin(plan, &self.factors, grown.as_ref().unwrap_or(&drawn));
        self.grow(growth, drawn);
        Ok(Advanced::by(work))
    }

    /// The current stage of the work, and the share of it that is done.
    #[must_use]
    pub fn progress(&self) -> (Stage, f64) {
        match &self.state {
            State::Grow(round) => {
                let [first, second] = times(self.plan.kind());
                // A second correction is rare.
                let whole = first + if self.most_corrections() > 0 { second } else { 0.0 };
                (Stage::Grow, ((self.before.1 + round.growth.time()) / whole).min(1.0))
            }
            State::Pieces | State::Lines(..) | State::Stripes(..) => (Stage::Plan, 0.5),
            State::Grown(_) | State::Failed => (Stage::Refine, 1.0),
        }
    }

    /// Cell updates of `time`, in 1/b; the smallest part of the work while the layer is not growing.
    #[must_use]
    pub fn updates_in(&self, time: f64) -> u64 {
        match &self.state {
            State::Grow(round) if round.growth.steps() < round.last => {
                round.growth.steps_in(time) * self.plan.grid.cells() as u64
            }
            _ => 1,
        }
    }

    /// The current state of the layer; `None` while it does not grow.
    #[must_use]
    pub fn seen(&self) -> Option<Seen<'_>> {
        let State::Grow(round) = &self.state else { return None };
        let (plan, growth) = (&self.plan, &round.growth);
        if growth.steps() == 0 {
            return None;
        }
        Some(seen(plan, growth, self.before.0))
    }

    /// The grown pairs; `None` before the end.
    #[must_use]
    pub fn complete(self) -> Option<GrownPairs> {
        if let State::Grown(grown) = self.state { Some(*grown) } else { None }
    }
}

/// The growing pairs, after `before` steps of earlier rounds.
pub(in crate::synth::pairs) fn seen<'s>(plan: &'s PairPlan, growth: &'s PairGrowth, before: u64) -> Seen<'s> {
    let shown = || -> Vec<Field> { plan.shown(growth.differences()) };
    Seen {
        steps: before + growth.steps(),
        grid: plan.grid.size,
        canvas: plan.canvas().size,
        pattern: Box::new(move || Box::new(PairPattern::new(&shown(), &plan.levels()))),
    }
}
