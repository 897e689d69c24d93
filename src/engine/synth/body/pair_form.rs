//! What is particular to stripes with tips on a surface: the size of their pair, and the cells that it needs.

use crate::attributes::Attributes;
use crate::document::{Document, LayerMaps};
use crate::rd::pairs::PairKind;
use crate::synth::error::{LayerError, PlanError};
use crate::synth::pairs::plan::PairPlan;
use crate::synth::pairs::plan::stripes::size_of_period;
use crate::synth::pairs::plan::thread_map::ThreadMap;
use crate::synth::training::Training;

/// Vertices along the smallest size s of a pair, as many as cells on a canvas. With fewer than 1.5, edges stick to the grid
/// (`facts.md` T).
const FINENESS: f64 = 1.75;

/// The pair of the stripes of a layer on a surface.
#[derive(Clone, Debug)]
pub struct PairForm {
    /// The factor between the size of the pair and its law, from training rows.
    learnt: f64,
    /// What cannot be reached.
    pub notes: Vec<String>,
}

impl PairForm {
    /// Reads the stripes with tips of layer `index` of a document, and what the regions of its sketch ask for. `None` of layers of another
    /// kind.
    ///
    /// # Errors
    /// Its marks make no such stripes: file, place, value, what is allowed. Or the training set cannot be read.
    pub fn read(
        document: &Document,
        index: usize,
        source: &str,
        training: &Training,
    ) -> Result<Option<(Self, Vec<Attributes>)>, LayerError> {
        let layer = &document.layers[index];
        let kind = PairKind::Stripes;
        if layer.system.pairs() != Some(kind) {
            return Ok(None);
        }
        if layer.strokes.is_empty() {
            return Ok(Some((Self { learnt: 1.0, notes: Vec::new() }, Vec::new())));
        }
        let rows = training.pairs(kind.description()).map_err(PlanError::Training)?;
        // Maps vary what is wanted on the model, not on the canvas.
        let mut sketch = document.clone();
        sketch.layers[index].maps = LayerMaps::default();
        let plan = PairPlan::read(&sketch, index, source, document.size.map(f64::from), rows)?;
        let learnt = rows.and_then(|rows| Some(plan.answers(rows).first()?.values[0]));
        let regions = plan.threads.first().map_or_else(Vec::new, ThreadMap::of_regions);
        let form = Self { learnt: learnt.unwrap_or(1.0), notes: plan.notes };
        Ok(Some((form, regions.into_iter().map(Attributes::Stripes).collect())))
    }

    /// The size s of the pair, px, of stripes with `factor` times the period that is wanted.
    #[must_use]
    pub fn size(&self, wanted: &Attributes, factor: f64) -> f64 {
        self.learnt * size_of_period(factor * period(wanted))
    }

    /// px a cell of the surface that suits these stripes.
    #[must_use]
    pub fn cell(&self, wanted: &Attributes) -> f64 {
        self.size(wanted, 1.0) / FINENESS
    }
}

/// The period of stripes, px: twice their width where none is given. That of spots is their spacing.
#[must_use]
pub fn period(wanted: &Attributes) -> f64 {
    match wanted {
        Attributes::Stripes(stripes) => stripes.width / stripes.duty(),
        Attributes::Spots(spots) => spots.spacing.unwrap_or(spots.area.sqrt()),
    }
}
