//! Checks of a document before it is grown: everything that growing refuses at once, and, for small documents, everything else that
//! it refuses.
//!
//! Some refusals show only during the growth: a mark that finds no room between those beneath, or a canvas with few marks on which
//! only ground grows. Such a canvas has few cells, because cells follow the marks. So small documents are grown to be checked.

use crate::document::Document;
use crate::grid::Domain;
use crate::synth::error::{GrowError, LayerError};
use crate::synth::growth::{Growth, Progress};
use crate::synth::kind::{Described, Request};
use crate::synth::layer::LayerPlan;
use crate::synth::options::Options;
use crate::synth::time::TimeLimit;

/// Most cells, over all layers, of a document that is grown to be checked. Not tuned: a document of 400 × 100 px with spots of 8 to
/// 50 px took 2 s.
const SMALL: usize = 150_000;
/// Larger documents are grown, too, if the laws of their kinds give fewer seconds of one core: points and patches have many cells
/// and no steps. Of 821 random documents, 8 were refused only during the growth with the first limit alone, 4 with both.
const SHORT: f64 = 1.0;
/// Cell updates after which this growth is given up.
const MOST_UPDATES: u64 = 400_000_000;
/// Cell updates between two looks at how many are left.
const UPDATES: u64 = 2_000_000;

/// Results of checking a document before it is grown.
#[derive(Debug)]
pub struct Checked {
    /// The description of each layer, the lowest first.
    pub layers: Vec<Described>,
    /// The reason why growing the document is refused; `None` if it is not known to be refused.
    pub refusal: Option<GrowError>,
}

/// Plans every layer of `document`, and grows it where that is little work.
///
/// ```
/// use dapple_engine::document::{Document, Layer, Stroke};
/// use dapple_engine::synth::{Options, check::check};
///
/// let spots = [[20.0, 20.0], [44.0, 22.0]].map(|center| Stroke::ellipse(center, [6.0, 4.0], 30.0));
/// let checked = check(&Document::new([64, 64]).with_layer(Layer::new(spots)), &Options::default())?;
/// assert_eq!(checked.layers.len(), 1);
/// assert!(checked.refusal.is_none());
/// # Ok::<(), dapple_engine::synth::GrowError>(())
/// ```
///
/// # Errors
/// A layer cannot be planned.
pub fn check(document: &Document, options: &Options) -> Result<Checked, GrowError> {
    let mut checked = Checked { layers: Vec::new(), refusal: None };
    let (mut beneath, mut cells, mut seconds) = (None, 0, 0.0);
    for index in 0..document.layers.len() {
        let size = options.size.unwrap_or(document.size).map(f64::from);
        let Options { source, training, memory, .. } = *options;
        let below = beneath.as_ref().map(LayerPlan::own);
        let request = Request { document, index, source, size, training, memory, beneath: below };
        let (plan, described, refusal) = planned(&request, options.time, seconds)?;
        seconds += plan.as_ref().map_or(0.0, LayerPlan::seconds);
        cells += plan.as_ref().map_or(0, |plan| plan.planned().grid.cells());
        checked.layers.push(described);
        checked.refusal = checked.refusal.or(refusal);
        beneath = plan;
    }
    if checked.refusal.is_none() && (cells <= SMALL || seconds <= SHORT) {
        checked.refusal = tried(document, options).err();
    }
    Ok(checked)
}

/// The plan of a layer above others that take `beneath` seconds, its description, and the reason if it is refused. There is no plan
/// if the layer is too large to be planned.
fn planned(
    request: &Request,
    time: TimeLimit,
    beneath: f64,
) -> Result<(Option<LayerPlan>, Described, Option<GrowError>), GrowError> {
    let in_layer = |error: LayerError| error.in_layer(request.source, request.index + 1);
    let plan = match LayerPlan::read(request) {
        Ok(plan) => plan,
        Err(LayerError::TooLarge(error)) => {
            let (layer, grid) = (request.index + 1, error.grid);
            let error = LayerError::TooLarge(error);
            let text = format!("layer {layer} {error}\n");
            let json = serde_json::json!({"grid": grid, "notes": [error.to_string()]});
            return Ok((None, Described::new(text, Vec::new(), json), Some(in_layer(error))));
        }
        Err(error) => return Err(in_layer(error)),
    };
    let too_large = plan.fits(request).err().map(LayerError::TooLarge);
    let too_long = || time.allows(beneath + plan.seconds(), request.size).err().map(LayerError::TooLong);
    let refused = too_large.or_else(too_long);
    let described = plan.describe(request, refused.iter().map(LayerError::to_string).collect());
    Ok((Some(plan), described, refused.map(in_layer)))
}

/// Grows a small document, until it is done or has taken too much work.
fn tried(document: &Document, options: &Options) -> Result<(), GrowError> {
    let mut growth = Growth::begin(document, options, None);
    let mut left = MOST_UPDATES;
    // On a thread of the pool, as growing does it.
    rayon::scope(|_| {
        while left > 0 && growth.advance(UPDATES)? != Progress::Done {
            left = left.saturating_sub(UPDATES);
        }
        Ok(())
    })
}
