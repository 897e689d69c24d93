//! The growth of a document as a value, layer by layer: the marks of earlier layers are frozen, and each later layer grows into the
//! space between them.
//!
//! ```text
//!  begin ─▶ plan every layer ─▶ the lowest one grows ─▶ frozen ─▶ the next one … ─▶ complete
//!           refused before any    advanced by a budget of cell updates; seen in between
//! ```
//!
//! It has no threads, no clock and no callbacks of its own: its caller decides how much is done in one call. To pause, do not
//! advance; to cancel, drop it. The result does not depend on how the growth was advanced, nor on whether it was read in between.

use crate::document::{After, Document, Layer};
use crate::grid::Field;
use crate::synth::drawn::is_replaced;
use crate::synth::error::{GrowError, LayerError};
use crate::synth::kind::{Beneath, GrownBeneath, Request, Seen, Setting};
use crate::synth::layer::{GrownLayer, LayerGrowth, LayerPlan};
use crate::synth::marks::grow::UPDATES;
use crate::synth::options::{Options, Settings};
use crate::synth::passes::PassSet;
use crate::synth::profile::{Section, during};
use crate::synth::report::DrawnMark;
use crate::synth::shaped::Shapes;
use crate::synth::thinned::Thinning;
use crate::synth::watch::Stage;

/// A grown texture.
pub struct Grown {
    /// Canvas, px.
    pub size: [u32; 2],
    /// Its layers, the lowest first.
    pub layers: Vec<GrownLayer>,
    /// The document that was grown.
    pub document: Document,
    /// The options that it was grown with.
    pub settings: Settings,
}

/// The result of a call of [`Growth::advance`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Progress {
    /// The layers still grow.
    Growing {
        /// Whether the picture has changed.
        seen: bool,
    },
    /// All layers have grown.
    Done,
}

/// A document at one moment of its growth.
pub struct Snapshot<'a> {
    /// The layers that have grown.
    pub beneath: &'a [GrownLayer],
    /// The layer that grows on top of them.
    pub growing: Seen<'a>,
}

/// The growth of a document.
pub struct Growth<'a> {
    document: &'a Document,
    options: Options<'a>,
    filmed: bool,
    without: PassSet,
    /// The layers that have grown.
    layers: Vec<GrownLayer>,
    /// Plans of the layers above, if they do not depend on the growth of those beneath.
    plans: Vec<Option<LayerPlan>>,
    /// Seconds of one core that these plans take, by laws.
    seconds: f64,
    state: State<'a>,
}

/// The next part of the work.
enum State<'a> {
    /// Every layer is planned, so that one that cannot be grown is refused before the first one grows. Holds the index of the next
    /// layer to plan.
    Plan(usize),
    /// The next layer begins.
    Begin,
    /// A layer grows. Holds whether it can be completed.
    Grow(LayerGrowth<'a>, bool),
    /// All layers have grown.
    Done,
    /// The document cannot be grown.
    Failed,
}

impl<'a> Growth<'a> {
    /// Begins to grow `document`. The lowest layers that have not changed are taken from `before`, which must have been grown from
    /// these training sets; the result does not depend on it.
    #[must_use]
    pub fn begin(document: &'a Document, options: &Options<'a>, before: Option<&Grown>) -> Self {
        let frozen = before.map_or(0, |before| unchanged(document, options.settings(), before));
        let layers: Vec<GrownLayer> =
            before.iter().flat_map(|before| &before.layers[..frozen]).cloned().collect();
        let several = frozen == 0 && document.layers.len() > 1;
        let state = if several { State::Plan(0) } else { State::Begin };
        let plans = document.layers.iter().map(|_| None).collect();
        Self {
            document,
            options: *options,
            filmed: false,
            without: PassSet::NONE,
            layers,
            plans,
            seconds: 0.0,
            state,
        }
    }

    /// This growth, prepared for a film: the points of layers that are made from points appear one after the other.
    #[must_use]
    pub fn filmed(self) -> Self {
        Self { filmed: true, ..self }
    }

    /// This growth with the plan of the lowest layer to be grown, if that is known already.
    #[must_use]
    pub fn planned(mut self, plan: LayerPlan) -> Self {
        let index = self.layers.len();
        if let Some(slot) = self.plans.get_mut(index) {
            *slot = Some(plan);
        }
        self
    }

    /// Leaves out some passes, to measure what they contribute.
    #[must_use]
    pub fn without(self, without: PassSet) -> Self {
        Self { without, ..self }
    }

    /// Does about `budget` cell updates of work, at least the smallest part of it: planning, measuring and correcting count about
    /// as much as they take. Returns earlier if the picture has changed.
    ///
    /// # Errors
    /// Why the document does not grow. The growth has then ended: its later calls return [`Progress::Done`], and [`Self::complete`]
    /// returns nothing.
    pub fn advance(&mut self, budget: u64) -> Result<Progress, GrowError> {
        let mut left = budget;
        loop {
            let (updates, seen) = match std::mem::replace(&mut self.state, State::Failed) {
                State::Plan(index) => (self.plan_next(index)?, false),
                State::Begin => (self.begin_layer()?, false),
                State::Grow(growth, true) => (self.freeze(growth), false),
                State::Grow(mut growth, false) => {
                    let advanced = growth.advance(left.max(1)).map_err(|error| self.refused(error))?;
                    self.state = State::Grow(growth, advanced.done);
                    (advanced.updates, advanced.seen)
                }
                ended @ (State::Done | State::Failed) => {
                    self.state = ended;
                    return Ok(Progress::Done);
                }
            };
            left = left.saturating_sub(updates);
            if seen || left == 0 {
                let done = matches!(self.state, State::Done);
                return Ok(if done { Progress::Done } else { Progress::Growing { seen } });
            }
        }
    }

    /// Plans layer `index`. Returns the work.
    fn plan_next(&mut self, index: usize) -> Result<u64, GrowError> {
        if index == self.document.layers.len() {
            self.plans.iter_mut().for_each(|plan| {
                plan.take_if(|plan| !plan.is_final());
            });
            self.state = State::Begin;
            return Ok(1);
        }
        let known = self.plans[index].take();
        let below = index.checked_sub(1).and_then(|below| self.plans[below].as_ref());
        let request = self.request(index, below.map(LayerPlan::own));
        let (plan, seconds) = self.checked(known, &request, self.seconds)?;
        self.seconds += seconds;
        let cells = plan.planned().grid.size;
        self.plans[index] = Some(plan);
        self.state = State::Plan(index + 1);
        Ok((cells[0] * cells[1]) as u64)
    }

    /// The canvas, px.
    fn size(&self) -> [u32; 2] {
        self.options.size.unwrap_or(self.document.size)
    }

    fn request<'s>(&'s self, index: usize, beneath: Option<&'s dyn std::any::Any>) -> Request<'s> {
        let Options { source, training, memory, .. } = self.options;
        let size = self.size().map(f64::from);
        Request { document: self.document, index, source, size, training, memory, beneath }
    }

    /// The plan of a layer, unless it is `known`, and its seconds; an error if it does not fit into memory, or takes too long above
    /// others that take `beneath` seconds.
    fn checked(
        &self,
        known: Option<LayerPlan>,
        request: &Request,
        beneath: f64,
    ) -> Result<(LayerPlan, f64), GrowError> {
        if let Some(plan) = known {
            return Ok((plan, 0.0));
        }
        let cannot = |error: LayerError| error.in_layer(request.source, request.index + 1);
        let plan = during(Section::LookUp, || LayerPlan::read(request)).map_err(cannot)?;
        plan.fits(request).map_err(|error| cannot(error.into()))?;
        let seconds = plan.seconds();
        let allowed = self.options.time.allows(beneath + seconds, request.size);
        allowed.map_err(|error| cannot(error.into()))?;
        Ok((plan, seconds))
    }

    /// The error of the layer that grows at present.
    fn refused(&self, error: LayerError) -> GrowError {
        error.in_layer(self.options.source, self.layers.len() + 1)
    }

    /// Begins the next layer, or ends if there is none. Returns the work.
    fn begin_layer(&mut self) -> Result<u64, GrowError> {
        let index = self.layers.len();
        let Some(known) = self.plans.get_mut(index).map(Option::take) else {
            self.state = State::Done;
            return Ok(0);
        };
        let request = self.request(index, self.layers.last().map(GrownLayer::own));
        let (plan, _) = self.checked(known, &request, 0.0)?;
        let [nx, ny] = plan.planned().grid.size;
        let Options { source, training, memory, concentrations, refine, .. } = self.options;
        let setting = Setting {
            seed: self.document.layer_seed(index),
            source,
            training,
            memory,
            corrects: refine.unwrap_or(self.document.growth.refine),
            without: self.without,
            concentrations,
            filmed: self.filmed,
        };
        let growth = plan.begin(&beneath(self.document, &self.layers), setting);
        let growth = growth.map_err(|error| self.refused(error))?;
        self.state = State::Grow(growth, false);
        Ok((nx * ny) as u64)
    }

    /// Freezes a layer that has grown. Returns the work.
    fn freeze(&mut self, growth: LayerGrowth<'a>) -> u64 {
        let index = self.layers.len();
        if let Some(mut layer) = growth.complete() {
            if let Some(shapes) =
                Shapes::of(&self.document.layers[index].options, layer.is_made_ragged_later())
            {
                let seed = self.document.layer_seed(index);
                let shaped = during(Section::Steps, || shapes.applied(&*layer.pattern(), seed));
                layer.show(shaped);
            }
            if let Some(thinned) = during(Section::Steps, || self.thinned(&layer)) {
                layer.show(thinned);
            }
            self.layers.push(layer);
        }
        self.state = if self.layers.len() < self.document.layers.len() { State::Begin } else { State::Done };
        1
    }

    /// The pattern of a layer `near` the marks beneath without those that are removed; `None` of other layers.
    fn thinned(&self, layer: &GrownLayer) -> Option<Field> {
        let index = self.layers.len();
        let Layer { after, options, .. } = &self.document.layers[index];
        if *after != After::Near || index == 0 {
            return None;
        }
        let shown = (0..index).filter(|beneath| !is_replaced(self.document, *beneath));
        let beneath: Vec<_> = shown.map(|beneath| self.layers[beneath].pattern()).collect();
        let drawn: Vec<[f64; 2]> =
            layer.drawn().iter().filter(|mark| mark.there).map(|mark| mark.place).collect();
        let thinning = Thinning { near: options.near, seed: self.document.layer_seed(index) };
        thinning.applied(&*layer.pattern(), &beneath, &drawn)
    }

    /// The current stage of the work, and the share of it that is done, 0..1.
    #[must_use]
    pub fn progress(&self) -> (Stage, f64) {
        match &self.state {
            State::Plan(_) | State::Begin => (Stage::Plan, 0.0),
            State::Grow(growth, _) => growth.progress(),
            State::Done | State::Failed => (Stage::Refine, 1.0),
        }
    }

    /// Cell updates of `time` of normalised time on the current grid: equal on all machines.
    #[must_use]
    pub fn updates_in(&self, time: f64) -> u64 {
        if let State::Grow(growth, _) = &self.state { growth.updates_in(time) } else { 1 }
    }

    /// The layers that have grown.
    #[must_use]
    pub fn layers(&self) -> &[GrownLayer] {
        &self.layers
    }

    /// The current state of the document; `None` while a layer is planned or measured.
    #[must_use]
    pub fn snapshot(&self) -> Option<Snapshot<'_>> {
        let State::Grow(growth, _) = &self.state else { return None };
        Some(Snapshot { beneath: &self.layers, growing: growth.seen()? })
    }

    /// The drawn marks without room, by layer, as far as they are known.
    #[must_use]
    pub fn left_out(&self) -> Vec<Vec<DrawnMark>> {
        let growing = if let State::Grow(growth, _) = &self.state { Some(growth.left_out()) } else { None };
        self.layers.iter().map(GrownLayer::left_out).chain(growing).collect()
    }

    /// The grown texture; `None` while it still grows, and if it does not grow.
    #[must_use]
    pub fn complete(self) -> Option<Grown> {
        let (size, settings) = (self.size(), self.options.settings());
        let Self { document, layers, state, .. } = self;
        matches!(state, State::Done).then(|| Grown { size, layers, document: document.clone(), settings })
    }

    /// Grows until everything is done, and reports to the watch of the options in between.
    ///
    /// ```
    /// use dapple_engine::document::{Document, Layer, Stroke};
    /// use dapple_engine::synth::{Growth, Options};
    ///
    /// let spots = [[20.0, 20.0], [44.0, 22.0]].map(|center| Stroke::ellipse(center, [6.0, 4.0], 30.0));
    /// let document = Document::new([64, 64]).with_layer(Layer::new(spots));
    /// let grown = Growth::begin(&document, &Options::default(), None).run()?;
    /// assert_eq!(grown.rgb().len(), 3 * 64 * 64);
    /// # Ok::<(), dapple_engine::synth::GrowError>(())
    /// ```
    ///
    /// # Errors
    /// Why the document does not grow; or it was cancelled.
    pub fn run(self) -> Result<Grown, GrowError> {
        // On a thread of the pool: from outside, each parallel part would wake two threads while this one waits.
        rayon::scope(|_| self.run_here())
    }

    fn run_here(mut self) -> Result<Grown, GrowError> {
        let watch = self.options.watch;
        loop {
            let (stage, share) = self.progress();
            watch.step(stage, share)?;
            if self.advance(UPDATES)? == Progress::Done {
                break;
            }
        }
        Ok(self.complete().expect("all layers have grown"))
    }
}

/// The grown `layers` of `document`, for the layer above them.
#[must_use]
pub fn beneath<'s>(document: &'s Document, layers: &'s [GrownLayer]) -> Beneath<'s> {
    let layers = layers.iter().map(|layer| layer as &dyn GrownBeneath).collect();
    Beneath { document, layers }
}

/// Number of the lowest layers of `document` that would grow as in `before`, and are taken from there. Names and colours do not
/// matter.
#[must_use]
pub fn unchanged(document: &Document, settings: Settings, before: &Grown) -> usize {
    let canvas = |of: &Document, settings: Settings| {
        (of.size, of.regions, of.edges, settings.size, settings.refine.unwrap_or(of.growth.refine))
    };
    let lacks_concentrations = settings.concentrations && !before.settings.concentrations;
    if lacks_concentrations || canvas(document, settings) != canvas(&before.document, before.settings) {
        return 0;
    }
    let pairs = document.layers.iter().zip(&before.document.layers).enumerate();
    let pairs = pairs.take(before.layers.len());
    let same = pairs.take_while(|(index, (new, old))| {
        let seed = document.layer_seed(*index) == before.document.layer_seed(*index);
        let marks = (new.system, new.after, &new.options, &new.strokes, &new.tone, &new.points)
            == (old.system, old.after, &old.options, &old.strokes, &old.tone, &old.points);
        let marks = marks && new.far_spacing == old.far_spacing;
        seed && marks && new.maps.growing().eq(old.maps.growing())
    });
    same.count()
}

#[cfg(test)]
mod tests;
