//! Fuzz body for documents: a document that is read is written and read back unchanged, and can be planned or is
//! refused.

use dapple::document::Document;
use dapple_engine::synth::areas::plan::AreaPlan;
use dapple_engine::synth::kind::Request;
use dapple_engine::synth::lines::plan::LinePlan;
use dapple_engine::synth::marks::MarksPlan;
use dapple_engine::synth::points::plan::FieldPlan;
use dapple_engine::synth::tone::plan::TonePlan;
use dapple_engine::synth::{LayerError, LayerPlan, Training};
use std::sync::LazyLock;

use crate::kept::comes_back;
use crate::refusal::assert_readable;

const FILE: &str = "bad.dapple";
/// Bytes of memory that plans are checked against.
const MEMORY: Option<f64> = Some(8e9);

static TRAINING: LazyLock<Training> = LazyLock::new(Training::default);

/// `bytes` are a document, or are refused.
pub fn holds(bytes: &[u8]) {
    // The file's bytes are UTF-8 or refused before anything else.
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    match Document::parse(text, FILE) {
        Ok(document) => {
            comes_back(&document);
            is_planned(&document);
        }
        Err(error) => assert_readable(&error.to_string(), FILE),
    }
}

/// Each layer can be planned, or the reason is given: as `dapple check` does, without growing.
fn is_planned(document: &Document) {
    let strokes: usize = document.layers.iter().map(|layer| layer.strokes.len()).sum();
    let regions = document.region_grid().iter().product::<usize>() * document.layers.len();
    if strokes > 64 || regions > 64 {
        // Valid, but too slow to be tried thousands of times.
        return;
    }
    let (size, training) = (document.size.map(f64::from), &*TRAINING);
    let mut beneath: Option<LayerPlan> = None;
    for index in 0..document.layers.len() {
        let below = beneath.as_ref().map(LayerPlan::own);
        let request =
            Request { document, index, source: FILE, size, training, memory: MEMORY, beneath: below };
        let plan = match LayerPlan::read(&request) {
            Ok(plan) => plan,
            Err(LayerError::Document(error)) => return assert_readable(&error.to_string(), FILE),
            Err(error) => return assert!(!error.to_string().is_empty()),
        };
        let grid = plan.planned().grid;
        assert!(grid.size.iter().all(|cells| *cells > 0), "{:?}", grid.size);
        assert!(grid.px_a_cell().is_finite() && grid.px_a_cell() > 0.0);
        assert!(plan.bytes(size, grid.size).is_finite());
        assert!(plan.seconds() >= 0.0 && plan.seconds().is_finite());
        if let Err(error) = plan.fits(&request) {
            assert!(error.needed.is_finite());
        }
        is_sound(&plan, size.map(|side| 0.4 * side));
        beneath = Some(plan);
    }
}

/// The attributes that a plan asks for at a place can be grown.
fn is_sound(plan: &LayerPlan, at: [f64; 2]) {
    let own = plan.own();
    if let Some(plan) = own.downcast_ref::<LinePlan>() {
        let wanted = plan.wanted(at);
        assert!(wanted.width > 0.0 && (0.0..1.0).contains(&wanted.share), "{wanted:?}");
    } else if let Some(plan) = own.downcast_ref::<FieldPlan>() {
        assert!(plan.distance(at) > 0.0 && (0.0..=1.0).contains(&plan.dark(at)));
        assert!(plan.expected_points().is_finite() && plan.share.is_none_or(f64::is_finite));
    } else if let Some(plan) = own.downcast_ref::<AreaPlan>() {
        let wanted = plan.wanted(at);
        assert!(wanted.area > 0.0 && wanted.spacing > 0.0 && wanted.raggedness >= 1.0, "{wanted:?}");
    } else if let Some(plan) = own.downcast_ref::<TonePlan>() {
        assert!(plan.tone.iter().all(|share| (-0.01..=1.01).contains(share)));
        assert!(plan.directions.iter().all(|(angle, _)| angle.is_finite()));
    } else if let Some(plan) = own.downcast_ref::<MarksPlan>() {
        for answer in &plan.lookup.answers {
            assert!(answer.parameters.named().iter().all(|(_, value)| value.is_finite()), "{answer:?}");
        }
    }
}
