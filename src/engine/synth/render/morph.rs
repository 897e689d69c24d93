//! Morphing: one document becomes another.
//!
//! A(p) are the attributes that a document asks for at p. The simulation continues from the grown state of the first document,
//! while its attributes change from A₀ to A₁ (`RegionMap::blended`) along the smooth step s = t²(3 − 2t), frame by frame:
//!
//! ```text
//!  state ──▶ parameters of A₀ + s·(A₁ − A₀) ──▶ some steps ──▶ a frame, and the next state
//! ```
//!
//! Marks are not placed again: they grow, rotate, move, split and vanish by themselves.

use crate::attributes::{AttributeMap, Polarity};
use crate::document::{After, Document};
use crate::export::Stopped;
use crate::grid::Field;
use crate::rd::{Growth, System, with_obstacle_state};

use crate::synth::drawn::sketch_targets::region_map;
use crate::synth::error::{GrowError, LayerError};
use crate::synth::layer::LayerKind;
use crate::synth::marks::grow::engine::Engine;
use crate::synth::marks::plan::{Plan, finest_cell, free_spacing, look_up, look_up_on};
use crate::synth::memory;
use crate::synth::options::Machine;
use crate::synth::render::film::FilmError;
use crate::synth::render::film::{Show, mixed, painted};
use crate::synth::render::painting::Painting;
use crate::synth::training::Training;
use crate::synth::watch::{Stage, Watch};

/// Normalised time of the morph: spots need 100 to 300 to drift to new places.
const TIME: f64 = 400.0;
/// The share of the frames in which the attributes change; in the rest the pattern settles.
const CHANGING: f64 = 0.8;

/// The reason why one document cannot become another.
#[derive(Debug, thiserror::Error)]
pub enum MorphError {
    /// The two documents do not fit.
    #[error("{from} cannot become {to}: {what}")]
    Unlike {
        /// The first document.
        from: String,
        /// The other.
        to: String,
        /// The difference, and the remedy.
        what: String,
    },
    /// The first document does not grow, or the other cannot be planned.
    #[error(transparent)]
    Grow(#[from] GrowError),
}

/// The state of a morph.
#[derive(Clone)]
pub struct Morph<'a> {
    documents: [&'a Document; 2],
    /// The name of the first document in messages.
    file: &'a str,
    training: &'a Training,
    machine: Machine,
    system: System,
    /// The polarity of the stripes of both documents.
    polarity: Polarity,
    maps: [AttributeMap; 2],
    cell: f64,
    state: Vec<Vec<f32>>,
    /// Seconds of a unit of normalised time, measured while the first document grew.
    pace: f64,
}

/// A document and its name in messages.
pub type Named<'a> = (&'a Document, &'a str);

impl<'a> Morph<'a> {
    /// Grows the first document, whose state is the start of the morph to `to`.
    ///
    /// # Errors
    /// [`MorphError`]; documents of several layers, of other sizes or edges, of ellipses and lines are refused.
    pub fn new(
        from: Named<'a>,
        to: Named<'a>,
        (training, machine): (&'a Training, Machine),
        watch: &Watch,
    ) -> Result<Self, MorphError> {
        watch.step(Stage::Plan, 0.0).map_err(GrowError::from)?;
        let unlike = |what: String| MorphError::Unlike { from: from.1.into(), to: to.1.into(), what };
        if let Some(what) = difference(from.0, to.0) {
            return Err(unlike(what));
        }
        let map = |(document, source): Named| region_map(document, 0, source).map_err(GrowError::from);
        let mut maps = [map(from)?, map(to)?];
        if maps[0].blended(&maps[1], 0.5).is_none() {
            return Err(unlike(
                "one has spots and the other stripes: they cannot be blended; draw ellipses in both, or lines in both"
                    .to_owned(),
            ));
        }
        let choices = [from, to].map(|(document, _)| document.layers[0].wanted_system());
        let system = |choice, map: &AttributeMap, file| match look_up(training, choice, map) {
            Ok(found) => Ok(found.system),
            Err(error) => Err(LayerError::from(error).in_layer(file, 1)),
        };
        let systems = [system(choices[0], &maps[0], from.1)?, system(choices[1], &maps[1], to.1)?];
        // If one document names a system and the other is "auto", the named system is taken for both.
        let auto = choices.map(|choice| choice == crate::document::SystemChoice::Auto);
        let system = match (systems[0] == systems[1], auto) {
            (true, _) | (false, [false, true]) => systems[0],
            (false, [true, false]) => systems[1],
            // For two kinds of spots, the system whose spacing follows from the size: its spots change steadily.
            (false, [true, true]) if let Some(system) = systems.into_iter().find(|s| is_packed(*s)) => system,
            _ => {
                let [a, b] = systems.map(System::name);
                return Err(unlike(format!(
                    "one is grown by {a}, the other by {b}, with other chemicals; name the same system in both"
                )));
            }
        };
        for map in &mut maps {
            map.fill_free_spacing(|spots| free_spacing(training, system, spots));
        }
        let polarity = common_polarity(&maps).ok_or_else(|| {
            unlike(
                "the stripes of one cover more than half of their period and those of the other less: one grows the gaps \
                 between stripes, the other the stripes; give both a duty up to 0.5, or both from 0.5 on"
                    .to_owned(),
            )
        })?;
        let cell = maps.iter().map(|map| finest_cell((system, polarity), map)).fold(f64::INFINITY, f64::min);
        let documents = [from.0, to.0];
        let mut morph = Self {
            documents,
            file: from.1,
            training,
            machine,
            system,
            polarity,
            maps,
            cell,
            state: Vec::new(),
            pace: 0.0,
        };
        morph.begin(watch)?;
        Ok(morph)
    }

    /// The plan at `share` of the morph, 0..1.
    fn plan(&self, share: f64) -> Result<Plan, GrowError> {
        let [from, to] = &self.maps;
        let map = from.blended(to, share).expect("of one kind, as was checked");
        let grown = (self.system, self.polarity);
        let found = look_up_on(self.training, grown, &map, self.cell);
        Ok(found.map_err(|error| self.refused(error.into()))?.rough(Vec::new()))
    }

    /// The error of its layer.
    fn refused(&self, error: LayerError) -> GrowError {
        error.in_layer(self.file, 1)
    }

    fn begin(&mut self, watch: &Watch) -> Result<(), GrowError> {
        let plan = self.plan(0.0)?;
        let lookup = &plan.lookup;
        let (size, grid) = (lookup.map.layout().size, lookup.grid.size);
        let fits = memory::fits(memory::needed(lookup.system, size, grid), size, grid, self.machine.memory);
        fits.map_err(|error| self.refused(error.into()))?;
        let seed = self.documents[0].layer_seed(0);
        let mut engine = Engine::new(&plan.begin(seed), seed);
        let started = (self.machine.clock)();
        engine.settle(watch).map_err(GrowError::from)?;
        let time = engine.steps() as f64 / engine.steps_in_unit();
        self.pace = ((self.machine.clock)() - started).as_secs_f64() / time.max(1.0);
        self.state = engine.concentrations();
        Ok(())
    }

    /// Estimated seconds of the morph on this machine.
    #[must_use]
    pub fn seconds(&self) -> f64 {
        TIME * self.pace
    }

    /// Shows `frames` frames of `size` px, from the first document to the other.
    ///
    /// # Errors
    /// [`FilmError`].
    pub fn play(
        mut self,
        frames: usize,
        size: [usize; 2],
        watch: &Watch,
        show: Show,
    ) -> Result<(), FilmError> {
        let moving = ((frames as f64 * CHANGING).ceil() - 1.0).max(1.0);
        for frame in 0..frames {
            if (watch.cancelled)() {
                return Err(Stopped::Cancelled.into());
            }
            let way = (frame as f64 / moving).min(1.0);
            let share = way * way * (3.0 - 2.0 * way);
            let plan = self.plan(share)?;
            let time = if frame == 0 { 0.0 } else { TIME / frames as f64 };
            let marks = self.advance(&plan, time)?;
            show(&self.paint(&plan, &marks, share, size))?;
            (watch.progress)(Stage::Write, (frame + 1) as f64 / frames as f64);
        }
        Ok(())
    }

    /// Continues the simulation with the parameters of `plan` for `time` in normalised time.
    fn advance(&mut self, plan: &Plan, time: f64) -> Result<Field, GrowError> {
        let maps = plan.unpitched_maps();
        let state = with_obstacle_state(self.system, &maps, std::mem::take(&mut self.state));
        let mut growth = Growth::resumed(self.system, &maps, state).expect("one grid for all frames");
        if time > 0.0 {
            growth.advance(growth.steps_in(time));
        }
        self.state = growth.concentrations();
        let marks = growth.marks();
        if marks.values.iter().all(|value| value.is_finite()) {
            Ok(marks)
        } else {
            Err(self.refused(LayerError::NoPattern))
        }
    }

    fn paint(&self, plan: &Plan, marks: &Field, share: f64, size: [usize; 2]) -> Vec<u8> {
        let canvas = self.documents[0].size;
        let [mut from, to] = self.documents.map(|document| {
            let paint =
                |size| Painting::from_marks(document, plan, marks.clone(), size).with_finish(document);
            painted(&paint, canvas, size)
        });
        for (a, b) in from.chunks_exact_mut(3).zip(to.chunks_exact(3)) {
            a.copy_from_slice(&mixed([a[0], a[1], a[2]], [b[0], b[1], b[2]], share));
        }
        from
    }
}

/// The polarity in which the stripes of both maps can grow; `None` if there is none. Stripes half as wide as their period can grow
/// in either.
fn common_polarity(maps: &[AttributeMap; 2]) -> Option<Polarity> {
    let all = |polarity: Polarity| maps.iter().all(|map| !polarity.excludes(map.mean_duty()));
    [Polarity::Positive, Polarity::Negative].into_iter().find(|polarity| all(*polarity))
}

/// The difference that prevents one document from becoming another, whatever its marks.
fn difference(from: &Document, to: &Document) -> Option<String> {
    for document in [from, to] {
        let [layer] = &document.layers[..] else {
            let n = document.layers.len();
            return Some(format!(
                "found {n} layers; allowed: one in each, as frozen marks cannot move under those that grew between them"
            ));
        };
        if let Some(what) = LayerKind::of(document, 0).no_morph(document, 0) {
            return Some(what);
        }
        if !layer.maps.is_empty() {
            return Some("maps vary its layer; allowed: layers without maps".to_owned());
        }
        if layer.after != After::Between {
            return Some(format!("its layer has `after` {:?}; allowed: between", layer.after.name()));
        }
    }
    if from.size != to.size {
        let [a, b] = [from.size, to.size].map(|[w, h]| format!("{w}x{h}"));
        return Some(format!("sizes {a} and {b}; allowed: one size, px"));
    }
    (from.edges != to.edges).then(|| "one wraps and the other is closed; allowed: the same edges".to_owned())
}

/// Whether the system grows spots whose spacing follows from their size.
fn is_packed(system: System) -> bool {
    !system.is_striped() && !system.description().free_spacing
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;
    use crate::marks::{Line, Mark};

    #[test]
    fn stripes_half_as_wide_as_their_period_morph_into_thinner_and_wider_ones_but_these_not_into_each_other()
    {
        let map = |duty: f64| {
            let line = Mark::Line(Line { from: [5.0, 20.0], to: [40.0, 20.0], width: 6.0 });
            let map = AttributeMap::from_marks(&[line], [64.0, 48.0], None, Edges::Closed);
            map.expect("a line").with_duty(duty)
        };
        let common = |from: f64, to: f64| common_polarity(&[map(from), map(to)]);
        assert_eq!(common(0.5, 0.3), Some(Polarity::Positive));
        assert_eq!(common(0.7, 0.5), Some(Polarity::Negative));
        assert_eq!([common(0.3, 0.7), common(0.7, 0.3)], [None, None]);
    }
}
