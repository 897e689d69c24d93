//! A layer of spots or stripes on a canvas, in the form that passes correct.

use std::sync::Arc;

use crate::attributes::Attributes;
use crate::document::LayerOptions;
use crate::grid::Field;
use crate::measure::{MERGED_FILL, Spot};
use crate::synth::error::LayerError;
use crate::synth::kind::Setting;
use crate::synth::marks::GrownMarks;
use crate::synth::marks::grow::blank::blank;
use crate::synth::marks::grow::corrections::Corrections;
use crate::synth::marks::grow::engine::Engine;
use crate::synth::marks::grow::half_grown::HalfGrown;
use crate::synth::marks::grow::levelled::Levelled;
use crate::synth::marks::grow::local_separation::{Part, Separation, remeasured};
use crate::synth::marks::grow::measured::Measured;
use crate::synth::marks::grow::obstacles::bias;
use crate::synth::marks::grow::own_levels::own_levels;
use crate::synth::marks::grow::pattern::{Levels, Pattern};
use crate::synth::marks::grow::pinned_correction::{compared, matches};
use crate::synth::marks::grow::ragged::RaggedSearch;
use crate::synth::marks::plan::lattice::NodeOffset;
use crate::synth::marks::plan::pinned_marks::PinnedMark;
use crate::synth::marks::plan::raggedness::asked_raggedness;
use crate::synth::marks::plan::{Begun, Plan};
use crate::synth::passes::{
    Correctable, DrawnSpots, Grown, MergedSpots, OwnThresholds, Restart, SpotArea, Thresholds, Trace,
};
use crate::synth::profile::{Section, during};

/// Least number of spots with a mean that is corrected.
const OTHERS: f64 = 3.0;

/// A layer that grows and is corrected.
pub struct MarksLayer<'a> {
    setting: Setting<'a>,
    options: LayerOptions,
    /// The plan.
    pub plan: Arc<Plan>,
    /// The corrections of the plan.
    pub corrections: Corrections,
    /// The pattern that grows.
    pub engine: Engine,
    settled: bool,
    shown: Shown,
    /// The thresholds of the last round: a pattern that has grown on needs hardly other ones.
    factors: Option<Vec<f64>>,
    merged: MergedSpots,
    drawn: DrawnSpots,
    /// The corrections of the parameters of the drawn spots.
    added: Vec<NodeOffset>,
    half: HalfGrown,
    parts: Option<Vec<Part>>,
    separation: Option<Separation>,
    /// The content of the layer instead of a pattern.
    blank: Option<&'static str>,
    best: Option<(f64, GrownMarks)>,
    ragged: Option<Box<RaggedSearch>>,
}

/// The pattern that has grown.
enum Shown {
    /// The layer still grows, or keeps its pattern.
    Nothing,
    /// Its thresholds are moved.
    Levelled(Field, Box<Levelled>),
    /// The thresholds do not change any more.
    Measured(Field, Levels, Measured),
}

impl<'a> MarksLayer<'a> {
    /// The growth of a finished plan.
    ///
    /// # Errors
    /// There is no room for any mark.
    pub fn new(begun: Begun, options: LayerOptions, setting: Setting<'a>) -> Result<Self, LayerError> {
        let engine = during(Section::LayOut, || Engine::new(&begun, setting.seed));
        if !engine.can_start() {
            return Err(LayerError::NoRoom);
        }
        let plan = Arc::new(begun.plan);
        Ok(Self {
            setting,
            options,
            corrections: Corrections::none(&plan),
            plan,
            engine,
            settled: false,
            shown: Shown::Nothing,
            factors: None,
            merged: MergedSpots::default(),
            drawn: DrawnSpots::default(),
            added: Vec::new(),
            half: HalfGrown::default(),
            parts: None,
            separation: None,
            blank: None,
            best: None,
            ragged: None,
        })
    }

    /// The share of the search for ragged edges that is done, 0..1; `None` while there is none.
    #[must_use]
    pub fn roughened(&self) -> Option<f64> {
        self.ragged.as_ref().map(|search| search.progress())
    }

    /// The best grown pattern.
    #[must_use]
    pub fn complete(self) -> Option<GrownMarks> {
        let steps = self.engine.steps();
        self.best.map(|(_, grown)| GrownMarks { steps, ..grown })
    }

    fn levelled(&self) -> Option<&Levelled> {
        if let Shown::Levelled(_, levelled) = &self.shown { Some(levelled) } else { None }
    }

    /// The grown spots of the last measurement, and the spot that belongs to each drawn one.
    fn own_spots(&self) -> (&[Spot], Vec<Option<usize>>) {
        let spots = self.levelled().map_or(&[][..], Levelled::spots);
        (spots, matches(self.corrections.pinned_spots(), self.plan.lookup.map.layout(), spots))
    }

    fn region(&self, spot: &Spot) -> usize {
        let layout = self.plan.lookup.map.layout();
        layout.index(layout.region_of(spot.ellipse.center))
    }

    /// Difference between the `measured` layer and the sketch. A missing mark is worse than any difference of a mark, and counts
    /// twice. A lost mark is contained in the error already once. A half-grown mark counts half.
    fn error(&self, measured: &Measured) -> f64 {
        let told = measured.merged_spots(&self.plan).count();
        let merged = told.max(self.merged.surplus.len() + self.merged.crowded.len());
        let missing = self.drawn.lost.len() + 2 * (self.corrections.left_out().len() + merged);
        self.drawn.error + missing as f64 + 0.5 * self.half.len() as f64
    }
}

impl Thresholds for MarksLayer<'_> {
    fn thresholds(&self) -> &[f64] {
        self.levelled().map_or(&[], Levelled::thresholds)
    }

    fn range(&self) -> [f64; 2] {
        self.levelled().map_or([1.0; 2], Levelled::range)
    }

    fn slopes(&self) -> Vec<f64> {
        self.levelled().map_or(Vec::new(), Levelled::slopes)
    }

    fn size_errors(&self) -> &[Option<f64>] {
        self.levelled().map_or(&[], Levelled::size_errors)
    }

    fn step(&mut self, wanted: &[Option<f64>]) -> Vec<f64> {
        let Shown::Levelled(_, levelled) = &mut self.shown else { return Vec::new() };
        during(Section::Measure, || levelled.step(wanted))
    }
}

impl OwnThresholds for MarksLayer<'_> {
    fn drawn_count(&self) -> usize {
        self.corrections.pinned_spots().len()
    }

    fn drawn_areas(&self) -> Vec<Option<SpotArea>> {
        let (spots, own) = self.own_spots();
        let area = |(mark, spot): (&PinnedMark, Option<usize>)| {
            let got = &spots[spot?];
            let error = libm::log(got.ellipse.area() / mark.visible.area);
            Some(SpotArea { error, alone: got.fill >= MERGED_FILL })
        };
        self.corrections.pinned_spots().iter().zip(own).map(area).collect()
    }

    fn other_areas(&self) -> Vec<Option<f64>> {
        let (spots, own) = self.own_spots();
        let mut is_own = vec![false; spots.len()];
        own.iter().flatten().for_each(|spot| is_own[*spot] = true);
        let mut sums = vec![[0.0; 3]; self.plan.lookup.map.layout().len()];
        for (spot, _) in spots.iter().zip(is_own).filter(|(spot, is_own)| !is_own && spot.whole) {
            if let Attributes::Spots(wanted) = self.plan.lookup.map.at(spot.ellipse.center) {
                let [count, got, asked] = &mut sums[self.region(spot)];
                *count += 1.0;
                *got += spot.ellipse.area();
                *asked += wanted.area;
            }
        }
        let error = |[count, got, asked]: [f64; 3]| (count >= OTHERS).then(|| libm::log(got / asked));
        sums.into_iter().map(error).collect()
    }

    fn own_slope(&self) -> f64 {
        self.plan.lookup.system.definition().level_slope
    }

    fn set_own(&mut self, drawn: &[f64], others: &[f64]) {
        let factors = during(Section::Measure, || {
            let (spots, own) = self.own_spots();
            let mut factors: Vec<(&Spot, f64)> =
                spots.iter().map(|spot| (spot, others[self.region(spot)])).collect();
            for (spot, factor) in own.iter().zip(drawn) {
                if let Some(spot) = spot {
                    factors[*spot].1 = *factor;
                }
            }
            own_levels(&self.plan.lookup.grid, &factors)
        });
        if let Shown::Levelled(_, levelled) = &mut self.shown {
            during(Section::Measure, || levelled.set_own(factors));
        }
    }
}

impl Correctable for MarksLayer<'_> {
    fn grow(&mut self, budget: u64) -> Result<Grown, LayerError> {
        let before = self.engine.updates();
        if self.engine.advance(budget) {
            return Ok(Grown { updates: self.engine.updates() - before, settled: false });
        }
        self.settled = self.engine.settled();
        let marks = self.plan.levelled(self.engine.marks());
        if !marks.values.iter().all(|value| value.is_finite()) {
            return Err(LayerError::NoPattern);
        }
        let least_area = self.corrections.least_area();
        let levelled =
            during(Section::Measure, || Levelled::new(&self.plan, &marks, self.factors.take(), least_area));
        self.shown = Shown::Levelled(marks, Box::new(levelled));
        Ok(Grown { updates: self.engine.updates() - before, settled: true })
    }

    fn measured(&self) -> u64 {
        self.levelled().map_or_else(|| self.engine.cells(), Levelled::px) as u64
    }

    fn compare(&mut self) {
        self.shown = match std::mem::replace(&mut self.shown, Shown::Nothing) {
            Shown::Levelled(marks, levelled) => {
                let (levels, measured) = during(Section::Measure, || levelled.complete());
                Shown::Measured(marks, levels, measured)
            }
            shown => shown,
        };
        if let Shown::Measured(_, _, measured) = &self.shown {
            let pinned = self.corrections.pinned_spots().len();
            self.merged =
                during(Section::Measure, || self.engine.merged(&self.plan, pinned, measured.spots()));
        }
    }

    fn merged(&self) -> &MergedSpots {
        &self.merged
    }

    fn keep(&mut self) {
        let Shown::Measured(marks, levels, measured) = std::mem::replace(&mut self.shown, Shown::Nothing)
        else {
            return;
        };
        let pinned = self.corrections.pinned_spots();
        let pattern = Pattern::of_levels(&self.plan.lookup, levels);
        self.blank = during(Section::Measure, || blank(&self.plan, &pattern));
        self.half = during(Section::Measure, || HalfGrown::new(&self.plan, pinned, &pattern, &measured));
        let layout = self.plan.lookup.map.layout();
        (self.drawn, self.added) = during(Section::Measure, || compared(pinned, layout, measured.spots()));
        let Levels { correction, own: own_levels, .. } = pattern.into_levels();
        self.factors = Some(correction.clone());
        let error = if self.blank.is_some() { f64::INFINITY } else { self.error(&measured) };
        if self.best.as_ref().is_some_and(|(least, _)| error >= *least) {
            return;
        }
        let concentrations =
            if self.setting.concentrations { self.engine.concentrations() } else { Vec::new() };
        let grown = GrownMarks {
            plan: Arc::clone(&self.plan),
            corrections: self.corrections.clone(),
            steps: self.engine.steps(),
            settled: self.settled,
            correction,
            own_levels,
            measured,
            half_grown: self.half.places(),
            marks,
            concentrations,
            trace: Trace::default(),
            ragged: None,
            crossed: None,
        };
        self.best = Some((error, grown));
    }

    fn drawn(&self) -> &DrawnSpots {
        &self.drawn
    }

    fn half_grown(&self) -> usize {
        self.half.len()
    }

    fn beside(&self, spot: usize) -> [Option<usize>; 2] {
        self.engine.beside(spot, self.drawn_count())
    }

    fn restart(&mut self, restart: &Restart) {
        if restart.correct {
            self.corrections.add(&self.added);
        }
        self.corrections.undo(&restart.undo);
        if restart.leave_out {
            self.corrections.leave_out(&restart.away);
        }
        self.engine.restart(&self.plan, &self.corrections, restart);
    }

    fn restart_half_grown(&mut self) -> usize {
        self.engine.grow_on_mended(&self.plan, &self.half)
    }

    fn has_parts(&mut self) -> bool {
        self.parts = self.engine.parts_about(&self.merged);
        self.parts.is_some()
    }

    fn begin_parts(&mut self) {
        let Some(parts) = self.parts.take() else { return };
        self.separation = Some(self.engine.begin_separation(parts, &self.plan, &self.merged));
    }

    fn grow_parts(&mut self) -> Option<u64> {
        let mut separation = self.separation.take()?;
        if let Some(updates) = separation.advance() {
            self.separation = Some(separation);
            return Some(updates);
        }
        let parts = self.engine.end_separation(separation);
        if let Shown::Measured(mut marks, levels, measured) =
            std::mem::replace(&mut self.shown, Shown::Nothing)
        {
            let least_area = self.corrections.least_area();
            let pattern = Pattern::of_levels(&self.plan.lookup, levels);
            let measured = during(Section::Measure, || {
                remeasured(&self.plan, least_area, &pattern, &parts, &self.engine, &mut marks, measured)
            });
            self.shown = Shown::Measured(marks, pattern.into_levels(), measured);
        }
        None
    }

    fn check(&self) -> Result<(), LayerError> {
        match &self.best {
            _ if self.ragged.is_some() => Ok(()),
            Some((error, _)) if error.is_finite() => Ok(()),
            _ => Err(LayerError::Blank { what: self.blank.unwrap_or("no marks"), advice: LayerError::MARKS }),
        }
    }

    fn begin_unbiased(&mut self) -> Result<bool, LayerError> {
        let best = self.best.as_ref().map(|(_, best)| best).filter(|best| best.plan.places().is_none());
        let bias = best.and_then(|best| Some((&best.plan, bias(&best.plan, &best.measured)?)));
        let Some((plan, bias)) = bias else { return Ok(false) };
        let plan = plan.less(self.setting.training, &bias)?;
        let begun = during(Section::LayOut, || plan.begin(self.setting.seed));
        *self = Self::new(begun, self.options, self.setting)?;
        Ok(true)
    }

    fn roughen(&mut self) -> Option<u64> {
        if self.ragged.is_none() {
            let asked = asked_raggedness(&self.plan.lookup.map, &self.options)?;
            let (_, best) = self.best.take_if(|(_, best)| best.ragged.is_none())?;
            let search = during(Section::Measure, || RaggedSearch::new(best, asked, self.setting.seed));
            self.ragged = Some(Box::new(search));
        }
        let mut search = self.ragged.take()?;
        let cells = search.cells() as u64;
        if during(Section::Measure, || search.advance()) {
            self.ragged = Some(search);
        } else {
            self.best = Some((0.0, during(Section::Measure, || search.complete())));
        }
        Some(cells)
    }
}
