//! The growth of a layer of spots or stripes, from what was looked up to what has grown.
//!
//! ```text
//!  probe ─▶ lay out ─▶ grow and correct ─▶ once more, less what the layers beneath do ─▶ roughen the edges
//! ```

use std::sync::Arc;

use crate::document::LayerOptions;
use crate::grid::{Domain, Field};
use crate::measure::Spot;
use crate::rd::Seeding;
use crate::synth::error::LayerError;
use crate::synth::kind::{Advanced, Beneath, Seen, Setting};
use crate::synth::marks::GrownMarks;
use crate::synth::marks::grow::corrected_growth::CorrectedGrowth;
use crate::synth::marks::grow::obstacles::{bias, obstacles};
use crate::synth::marks::grow::passing::{crossed_marks, crosses};
use crate::synth::marks::grow::pattern::Pattern;
use crate::synth::marks::grow::probe::{Probes, When};
use crate::synth::marks::grow::ragged::RaggedSearch;
use crate::synth::marks::plan::offset::Offset;
use crate::synth::marks::plan::raggedness::asked_raggedness;
use crate::synth::marks::plan::{Corrected, Lookup, Plan, Start, Surroundings};
use crate::synth::phases::{Phase, during};
use crate::synth::watch::Stage;

/// A layer of spots or stripes that grows.
pub struct MarksGrowth<'a> {
    setting: Setting<'a>,
    options: LayerOptions,
    /// The pattern of the stripes beneath that its own pass under, if they cross any.
    crossed: Option<Arc<Field>>,
    /// Cells that marks beneath have taken; empty = none.
    obstacles: Vec<bool>,
    /// The spots of the next layer beneath.
    spots: Vec<Spot>,
    state: State,
}

/// What is being done.
enum State {
    /// Patches grow, to correct what was looked up.
    Probe(Box<Lookup>, Probes),
    /// Places of marks are found.
    LayOut(Box<Corrected>),
    /// It grows; whether for the second time.
    Grow(Box<CorrectedGrowth>, bool),
    /// Its edges are made ragged.
    Roughen(Box<RaggedSearch>),
    /// It has grown.
    Grown(Box<GrownMarks>),
    /// A step of the work has failed.
    Failed,
}

impl<'a> MarksGrowth<'a> {
    /// Begins to grow what was looked up, above the layers `beneath`.
    ///
    /// # Errors
    /// A training set cannot be read.
    pub fn begin(
        lookup: Lookup,
        options: LayerOptions,
        beneath: &Beneath,
        setting: Setting<'a>,
    ) -> Result<Self, LayerError> {
        let below = beneath.layers.last().and_then(|layer| layer.grown().downcast_ref::<GrownMarks>());
        let (obstacles, crossed) = during(Phase::LayOut, || {
            let obstacles = obstacles(beneath, lookup.grid.size, &|layer| crosses(&lookup, layer));
            (obstacles, crossed_marks(beneath, &lookup).map(Arc::new))
        });
        let spots = below.map_or(Vec::new(), |layer| layer.measured.spots().to_vec());
        let state = first_state(lookup, &setting)?;
        Ok(Self { setting, options, crossed, obstacles, spots, state })
    }

    /// Does a part of the work.
    ///
    /// # Errors
    /// Why the layer does not grow.
    pub fn advance(&mut self, budget: u64) -> Result<Advanced, LayerError> {
        match std::mem::replace(&mut self.state, State::Failed) {
            State::Probe(lookup, mut probes) => {
                let training = self.setting.training;
                if let Some(updates) = during(Phase::Probe, || probes.advance(training, budget))? {
                    self.state = State::Probe(lookup, probes);
                    return Ok(Advanced::by(updates as usize));
                }
                let corrected = during(Phase::Probe, || lookup.corrected(training, probes.found()))?;
                self.state = State::LayOut(Box::new(corrected));
                Ok(Advanced::by(1))
            }
            State::LayOut(corrected) => self.lay_out(*corrected),
            State::Grow(mut growth, again) => {
                let advanced = growth.advance(budget, &self.setting)?;
                if !advanced.done {
                    self.state = State::Grow(growth, again);
                    return Ok(advanced);
                }
                self.go_on(*growth, again, advanced)
            }
            State::Roughen(mut search) => {
                let cells = search.cells();
                if during(Phase::Measure, || search.advance()) {
                    self.state = State::Roughen(search);
                    return Ok(Advanced::by(cells));
                }
                let layer = during(Phase::Measure, || search.complete());
                self.state = State::Grown(Box::new(layer));
                Ok(Advanced::done(cells))
            }
            State::Grown(layer) => {
                self.state = State::Grown(layer);
                Ok(Advanced::done(0))
            }
            State::Failed => Err(LayerError::NoPattern),
        }
    }

    fn lay_out(&mut self, corrected: Corrected) -> Result<Advanced, LayerError> {
        let obstacles = std::mem::take(&mut self.obstacles);
        let surroundings = Surroundings { obstacles, spots: &self.spots };
        let plan = during(Phase::LayOut, || corrected.lay_out(surroundings, self.setting.seed));
        let plan = plan?;
        let cells = plan.lookup.grid.cells();
        let growth = CorrectedGrowth::new(plan, &self.setting)?;
        self.state = State::Grow(Box::new(growth), false);
        Ok(Advanced::by(cells))
    }

    /// What follows once the layer has grown.
    fn go_on(
        &mut self,
        growth: CorrectedGrowth,
        again: bool,
        advanced: Advanced,
    ) -> Result<Advanced, LayerError> {
        let layer = growth.complete().ok_or(LayerError::NoPattern)?;
        if let Some(bias) = self.bias(&layer).filter(|_| !again) {
            let plan = layer.plan.less(self.setting.training, &bias)?;
            self.state = State::Grow(Box::new(CorrectedGrowth::new(plan, &self.setting)?), true);
            return Ok(Advanced { done: false, ..advanced });
        }
        match asked_raggedness(&layer.plan.lookup.map, &self.options) {
            None => {
                self.state = State::Grown(Box::new(layer));
                Ok(advanced)
            }
            Some(asked) => {
                let search = during(Phase::Measure, || RaggedSearch::new(layer, asked, self.setting.seed));
                self.state = State::Roughen(Box::new(search));
                Ok(Advanced { done: false, ..advanced })
            }
        }
    }

    /// How the layers beneath have turned and stretched the spots of `layer`, where that is corrected.
    fn bias(&self, layer: &GrownMarks) -> Option<Vec<Offset>> {
        let correctable = self.setting.corrects && layer.plan.places().is_none();
        if correctable { bias(&layer.plan, &layer.measured) } else { None }
    }

    /// What is being done, and the share of it that is done.
    #[must_use]
    pub fn progress(&self) -> (Stage, f64) {
        match &self.state {
            State::Probe(..) => (Stage::Plan, 0.1),
            State::LayOut(_) => (Stage::Plan, 0.5),
            State::Grow(growth, _) => growth.progress(),
            State::Roughen(search) => (Stage::Refine, search.progress()),
            State::Grown(_) | State::Failed => (Stage::Refine, 1.0),
        }
    }

    /// Cell updates of `time` of normalised time; the least part of the work while it is not growing.
    #[must_use]
    pub fn updates_in(&self, time: f64) -> u64 {
        if let State::Grow(growth, _) = &self.state { growth.updates_in(time) } else { 1 }
    }

    /// The layer as it is now; `None` while it does not grow.
    #[must_use]
    pub fn seen(&self) -> Option<Seen<'_>> {
        let State::Grow(growth, _) = &self.state else { return None };
        if !growth.grows() {
            return None;
        }
        let CorrectedGrowth { plan, engine, .. } = &**growth;
        let pattern = || Pattern::new(&plan.lookup, &plan.levelled(engine.marks()));
        Some(Seen {
            steps: engine.steps(),
            grid: engine.grid(),
            canvas: plan.lookup.grid.bounds_px().size,
            pattern: Box::new(move || Box::new(pattern())),
        })
    }

    /// The plan that grows.
    #[must_use]
    pub fn plan(&self) -> Option<&Plan> {
        if let State::Grow(growth, _) = &self.state { Some(&growth.plan) } else { None }
    }

    /// What has grown.
    #[must_use]
    pub fn complete(self) -> Option<GrownMarks> {
        let State::Grown(layer) = self.state else { return None };
        Some(GrownMarks { crossed: self.crossed, ..*layer })
    }
}

/// What is done first: probes, where these are asked for and may help.
fn first_state(lookup: Lookup, setting: &Setting) -> Result<State, LayerError> {
    if setting.corrects && lookup.seeding == Seeding::Noise && !is_corrected_spot_by_spot(&lookup) {
        let probes = during(Phase::Probe, || Probes::of(&lookup, setting.training, When::Unsure))?;
        if let Some(probes) = probes {
            return Ok(State::Probe(Box::new(lookup), probes));
        }
    }
    Ok(State::LayOut(Box::new(lookup.uncorrected())))
}

/// Whether wanted attributes differ from place to place, and drawn spots are measured and corrected one by one, or maps vary them: a probe of
/// the mean would tell little, and can cost more than the canvas.
fn is_corrected_spot_by_spot(lookup: &Lookup) -> bool {
    let has_drawn_spots = matches!(&lookup.start, Start::Free { spots, .. } if !spots.is_empty());
    lookup.map.is_free() && has_drawn_spots || lookup.map.is_modulated()
}
