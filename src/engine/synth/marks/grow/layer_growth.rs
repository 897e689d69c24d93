//! The growth of a layer of spots or stripes, from the lookup to the grown layer.
//!
//! ```text
//!  probe ─▶ lay out ─▶ the passes: grow, correct, …
//! ```

use std::sync::Arc;

use crate::document::LayerOptions;
use crate::grid::{Domain, Field};
use crate::measure::Spot;
use crate::rd::Seeding;
use crate::synth::error::LayerError;
use crate::synth::kind::{Advanced, Beneath, Seen, Setting};
use crate::synth::marks::GrownMarks;
use crate::synth::marks::grow::marks_layer::MarksLayer;
use crate::synth::marks::grow::obstacles::obstacles;
use crate::synth::marks::grow::passing::{crossed_marks, crosses};
use crate::synth::marks::grow::pattern::Pattern;
use crate::synth::marks::grow::probe::{Probes, When};
use crate::synth::marks::plan::pinned_marks::LeftOut;
use crate::synth::marks::plan::{Corrected, Lookup, Start, Surroundings};
use crate::synth::passes::{Pass, Passes, Step};
use crate::synth::profile::{Section, during};
use crate::synth::watch::Stage;

/// A layer of spots or stripes that grows.
pub struct MarksGrowth<'a> {
    setting: Setting<'a>,
    options: LayerOptions,
    /// The pattern of the stripes beneath under which its own stripes pass, if they cross any.
    crossed: Option<Arc<Field>>,
    /// Cells that marks beneath have taken; empty = none.
    obstacles: Vec<bool>,
    /// The spots of the next layer beneath.
    spots: Vec<Spot>,
    state: State<'a>,
}

/// The current part of the work.
enum State<'a> {
    /// Probe patches grow, to correct the lookup.
    Probe(Box<Lookup>, Probes),
    /// Places of marks are found.
    LayOut(Box<Corrected>),
    /// The layer grows and is corrected.
    Correct(Box<(MarksLayer<'a>, Passes)>),
    /// The layer has grown.
    Grown(Box<GrownMarks>),
    /// A step of the work has failed.
    Failed,
}

impl<'a> MarksGrowth<'a> {
    /// Begins the growth of a lookup, above the layers `beneath`.
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
        let (obstacles, crossed) = during(Section::LayOut, || {
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
                if let Some(updates) = during(Section::Probe, || probes.advance(training, budget))? {
                    self.state = State::Probe(lookup, probes);
                    return Ok(Advanced::by(updates as usize));
                }
                let corrected = during(Section::Probe, || lookup.corrected(training, probes.found()))?;
                self.state = State::LayOut(Box::new(corrected));
                Ok(Advanced::by(1))
            }
            State::LayOut(corrected) => self.lay_out(*corrected),
            State::Correct(mut correct) => {
                let (layer, passes) = &mut *correct;
                let Step { updates, seen, done } = passes.advance(layer, budget)?;
                let advanced = Advanced { updates, seen, done };
                if !done {
                    self.state = State::Correct(correct);
                    return Ok(advanced);
                }
                let (layer, passes) = *correct;
                let grown = layer.complete().ok_or(LayerError::NoPattern)?;
                let trace = passes.trace().clone();
                self.state = State::Grown(Box::new(GrownMarks { trace, ..grown }));
                Ok(advanced)
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
        let plan = during(Section::LayOut, || {
            let seed = self.setting.seed;
            Ok::<_, LayerError>(corrected.lay_out(surroundings, seed)?.begin(seed))
        });
        let begun = plan?;
        let cells = begun.plan.lookup.grid.cells();
        let layer = MarksLayer::new(begun, self.options, self.setting)?;
        let passes = Passes::new(self.setting.corrects, self.setting.without);
        self.state = State::Correct(Box::new((layer, passes)));
        Ok(Advanced::by(cells))
    }

    /// The current stage of the work, and the share of it that is done.
    #[must_use]
    pub fn progress(&self) -> (Stage, f64) {
        match &self.state {
            State::Probe(..) => (Stage::Plan, 0.1),
            State::LayOut(_) => (Stage::Plan, 0.5),
            State::Correct(correct) => {
                let (layer, passes) = &**correct;
                let roughened = layer.roughened().map(|share| (Stage::Refine, share));
                roughened.unwrap_or_else(|| passes.progress(layer.engine.progress()))
            }
            State::Grown(_) | State::Failed => (Stage::Refine, 1.0),
        }
    }

    /// Cell updates of `time` of normalised time; the least part of the work while it is not growing.
    #[must_use]
    pub fn updates_in(&self, time: f64) -> u64 {
        match &self.state {
            State::Correct(correct) if correct.1.grows() => correct.0.engine.updates_in(time),
            _ => 1,
        }
    }

    /// The current state of the layer; `None` while it does not grow.
    #[must_use]
    pub fn seen(&self) -> Option<Seen<'_>> {
        let State::Correct(correct) = &self.state else { return None };
        let (MarksLayer { plan, engine, .. }, passes) = &**correct;
        if !passes.grows() || engine.updates() == 0 {
            return None;
        }
        let pattern = || Pattern::new(&plan.lookup, &plan.levelled(engine.marks()));
        Some(Seen {
            steps: engine.steps(),
            grid: engine.grid(),
            canvas: plan.lookup.grid.bounds_px().size,
            pattern: Box::new(move || Box::new(pattern())),
        })
    }

    /// The drawn spots that are left out of the growth.
    #[must_use]
    pub fn left_out(&self) -> &[LeftOut] {
        if let State::Correct(correct) = &self.state { correct.0.corrections.left_out() } else { &[] }
    }

    /// The grown marks; `None` before the end.
    #[must_use]
    pub fn complete(self) -> Option<GrownMarks> {
        let State::Grown(layer) = self.state else { return None };
        Some(GrownMarks { crossed: self.crossed, ..*layer })
    }
}

/// The first part of the work: probes, if they are asked for and may help.
fn first_state<'a>(lookup: Lookup, setting: &Setting) -> Result<State<'a>, LayerError> {
    let probes = setting.corrects && !setting.without.has(Pass::Probes);
    if probes && lookup.seeding == Seeding::Noise && !is_corrected_spot_by_spot(&lookup) {
        let probes = during(Section::Probe, || Probes::of(&lookup, setting.training, When::Unsure))?;
        if let Some(probes) = probes {
            return Ok(State::Probe(Box::new(lookup), probes));
        }
    }
    Ok(State::LayOut(Box::new(lookup.uncorrected())))
}

/// Whether wanted attributes differ from place to place and drawn spots are measured and corrected one by one, or maps vary them. A
/// probe of the mean would then tell little, and can cost more than the canvas.
fn is_corrected_spot_by_spot(lookup: &Lookup) -> bool {
    let has_drawn_spots = matches!(&lookup.start, Start::Free { spots, .. } if !spots.is_empty());
    lookup.map.is_free() && has_drawn_spots || lookup.map.is_modulated()
}
