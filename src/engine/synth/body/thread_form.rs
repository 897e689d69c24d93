//! What is particular to threads of pairs on a surface: the directions of a weave, and the sizes of their pairs.

use crate::attributes::{Attributes, Stripes};
use crate::document::{After, Document, LayerMaps, Problem};
use crate::marks::turn;
use crate::rd::pairs::{PairKind, Threads};
use crate::synth::error::{LayerError, PlanError};
use crate::synth::pairs::plan::thread_map::ThreadMap;
use crate::synth::pairs::plan::{PairForm, PairPlan};
use crate::synth::training::Training;

/// Vertices along the smallest size s of a pair. With fewer than 1.5, edges stick to the grid (`facts.md` T).
const FINENESS: f64 = 1.75;

/// The threads of a layer on a surface.
#[derive(Clone, Debug)]
pub struct ThreadForm {
    /// The kind of pattern.
    pub form: PairForm,
    /// The second direction of a weave; `None` of stripes.
    pub second: Option<Second>,
    /// How many lines are drawn in each direction.
    pub lines: Vec<usize>,
    /// Factors between the sizes of pairs and their laws, from training rows, by direction.
    learnt: Vec<f64>,
    /// What cannot be reached.
    pub notes: Vec<String>,
}

/// The second direction of a weave, relative to the first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Second {
    /// The angle from the first to the second direction, degrees.
    pub turn: f64,
    /// The width of its threads ÷ that of the first ones.
    pub width: f64,
    /// Their distance ÷ that of the first ones.
    pub period: f64,
}

impl Second {
    fn new(first: &Stripes, own: &Stripes) -> Self {
        let period = |threads: &Stripes| threads.width / threads.duty();
        Self {
            turn: turn(own.angle, first.angle),
            width: own.width / first.width,
            period: period(own) / period(first),
        }
    }
}

impl ThreadForm {
    /// Reads the threads of layer `index` of a document, and what the regions of its sketch ask of the first direction. `None` of layers
    /// without threads.
    ///
    /// # Errors
    /// Its marks make no threads that grow on a model: file, place, value, what is allowed.
    pub fn read(
        document: &Document,
        index: usize,
        source: &str,
        training: &Training,
    ) -> Result<Option<(Self, Vec<Attributes>)>, LayerError> {
        let layer = &document.layers[index];
        // On surfaces weaves lose threads where lines end: they are refused until that is solved.
        let kind = match document.pairs(index).filter(|_| layer.after == After::Between) {
            Some(kind @ PairKind::Stripes) => kind,
            Some(PairKind::Weave | PairKind::Maze | PairKind::Stucco) | None => return Ok(None),
        };
        if layer.strokes.is_empty() {
            let (form, lines) = (PairForm::Stripes, vec![layer.on_model.len()]);
            let form = Self { form, second: None, lines, learnt: vec![1.0], notes: Vec::new() };
            return Ok((kind == PairKind::Stripes).then_some((form, Vec::new())));
        }
        let rows = training.pairs(kind.description()).map_err(PlanError::Training)?;
        // Maps vary what is wanted on the model, not on the canvas.
        let mut sketch = document.clone();
        sketch.layers[index].maps = LayerMaps::default();
        let plan = PairPlan::read(&sketch, index, source, document.size.map(f64::from), rows)?;
        if plan.threads.len() > 2 {
            let found = format!("lines of {} directions on a model", plan.threads.len());
            let allowed = "lines of two directions that cross";
            return Err(Problem::new(format!("layers[{index}].strokes"), found, allowed)
                .in_file(source)
                .into());
        }
        let all: Vec<Stripes> = plan.threads.iter().map(ThreadMap::mean).collect();
        let learnt = match rows {
            Some(rows) => plan.answers(rows).iter().map(|answer| answer.values[0]).collect(),
            None => vec![1.0; all.len()],
        };
        let regions = plan.threads.first().map_or_else(Vec::new, ThreadMap::of_regions);
        let form = Self {
            second: all.get(1).map(|own| Second::new(&all[0], own)),
            lines: plan.threads.iter().map(|threads| threads.lines.len()).collect(),
            learnt,
            notes: plan.notes,
            form: plan.form,
        };
        Ok(Some((form, regions.into_iter().map(Attributes::Stripes).collect())))
    }

    /// The kind of pattern.
    #[must_use]
    pub fn kind(&self) -> PairKind {
        if self.second.is_some() { PairKind::Weave } else { PairKind::Stripes }
    }

    /// What is wanted of each direction where this is wanted of the first.
    #[must_use]
    pub fn directions(&self, first: &Stripes) -> Vec<Stripes> {
        let period = first.wavelength.unwrap_or_else(|| first.width / first.duty());
        let first = Stripes { wavelength: Some(period), ..*first };
        let second = self.second.map(|second| Stripes {
            width: second.width * first.width,
            angle: first.angle + second.turn,
            wavelength: Some(second.period * period),
        });
        [first].into_iter().chain(second).collect()
    }

    /// The size s of the pair of each direction, px, where this is wanted of the first, with `factors` times the wanted widths, or for
    /// stripes periods.
    #[must_use]
    pub fn sizes(&self, first: &Stripes, factors: &[f64]) -> Vec<f64> {
        let all: Vec<Threads> = self
            .directions(first)
            .iter()
            .map(|own| Threads { width: own.width, period: own.width / own.duty() })
            .collect();
        let by_law = self.form.sizes(&all, factors);
        by_law.into_iter().zip(&self.learnt).map(|(size, learnt)| learnt * size).collect()
    }

    /// px a cell of the surface that suits these threads.
    #[must_use]
    pub fn cell(&self, wanted: &Attributes) -> f64 {
        let Attributes::Stripes(first) = wanted else { return f64::INFINITY };
        let sizes = self.sizes(first, &vec![1.0; self.lines.len()]);
        sizes.into_iter().fold(f64::INFINITY, f64::min) / FINENESS
    }
}
