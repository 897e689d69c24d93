//! Documents: what is read is written and read back unchanged, and can be planned or is refused.

use dapple::document::{Document, LineKind, Points};
use dapple_engine::synth::areas::plan::{AreaPlan, rows_of_cells};
use dapple_engine::synth::lines::plan::LinePlan;
use dapple_engine::synth::marks::plan::Targets;
use dapple_engine::synth::pairs::plan::PairPlan;
use dapple_engine::synth::points::plan::FieldPlan;
use dapple_engine::synth::tone::plan::{TonePlan, TonePlanError};
use dapple_engine::synth::{Training, memory};
use std::sync::LazyLock;

use crate::kept::comes_back;
use crate::refusal::assert_readable;

const FILE: &str = "bad.dapple";
/// Bytes of memory that plans are checked against.
const MEMORY: Option<f64> = Some(8e9);

static TRAINING: LazyLock<Training> = LazyLock::new(Training::default);

/// Whatever `bytes` are, they are a document or no document.
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

/// Plans streaks or cracks; false where that is refused, with a message that can be read.
fn is_line_planned(document: &Document, index: usize, kind: LineKind) -> bool {
    let size = document.size.map(f64::from);
    match LinePlan::read(document, index, kind, FILE, size) {
        Ok(plan) => {
            assert!(plan.px_a_cell().is_finite() && plan.px_a_cell() > 0.0);
            let wanted = plan.wanted(size.map(|side| 0.4 * side));
            assert!(wanted.width > 0.0 && (0.0..1.0).contains(&wanted.share), "{wanted:?}");
            if let Err(error) = memory::check_lines(size, plan.grid.size, MEMORY) {
                assert!(error.needed.is_finite());
            }
            true
        }
        Err(error) => {
            assert_readable(&error.to_string(), FILE);
            false
        }
    }
}

/// Plans a field of points; false where that is refused, with a message that can be read.
fn is_field_planned(document: &Document, index: usize, points: Points) -> bool {
    let size = document.size.map(f64::from);
    match FieldPlan::read(document, index, points, FILE, size) {
        Ok(plan) => {
            assert!(plan.px_a_cell().is_finite() && plan.px_a_cell() > 0.0);
            let at = size.map(|side| 0.4 * side);
            assert!(plan.distance(at) > 0.0 && (0.0..=1.0).contains(&plan.dark(at)));
            assert!(plan.expected_points().is_finite() && plan.share.is_none_or(f64::is_finite));
            if let Err(error) = memory::check_lines(size, plan.grid.size, MEMORY) {
                assert!(error.needed.is_finite());
            }
            true
        }
        Err(error) => {
            assert_readable(&error.to_string(), FILE);
            false
        }
    }
}

/// Plans patches or cells; false where that is refused, with a message that can be read.
fn is_area_planned(document: &Document, index: usize) -> bool {
    let size = document.size.map(f64::from);
    let rows = rows_of_cells(document, index, &TRAINING).expect("the built-in rows");
    match AreaPlan::read(document, index, FILE, size, rows) {
        Ok(plan) => {
            assert!(plan.px_a_cell().is_finite() && plan.px_a_cell() > 0.0);
            let wanted = plan.wanted(size.map(|side| 0.4 * side));
            assert!(wanted.area > 0.0 && wanted.spacing > 0.0 && wanted.raggedness >= 1.0, "{wanted:?}");
            if let Err(error) = memory::check_areas(plan.kind(), size, plan.grid.size, MEMORY) {
                assert!(error.needed.is_finite());
            }
            true
        }
        Err(error) => {
            assert_readable(&error.to_string(), FILE);
            false
        }
    }
}

/// Plans what scattered points make; false where that is refused, with a message that can be read.
fn is_of_points_planned(document: &Document, index: usize) -> bool {
    let layer = &document.layers[index];
    match (layer.point_lines(), layer.point_field()) {
        (Some(kind), _) => is_line_planned(document, index, kind),
        (None, Some(points)) => is_field_planned(document, index, points),
        (None, None) => is_area_planned(document, index),
    }
}

/// Each layer can be planned, or it is said why not: as `dapple check` does it, without growing.
fn is_planned(document: &Document) {
    let strokes: usize = document.layers.iter().map(|layer| layer.strokes.len()).sum();
    let regions = document.region_grid().iter().product::<usize>() * document.layers.len();
    if strokes > 64 || regions > 64 {
        // Sound, and too slow to be tried thousands of times.
        return;
    }
    let mut beneath = None;
    for index in 0..document.layers.len() {
        let size = document.size.map(f64::from);
        if document.layers[index].is_driven() {
            if !is_driven(document, index) {
                return;
            }
            beneath = None;
            continue;
        }
        if let Some(kind) = document.pairs(index) {
            let rows = TRAINING.pairs(kind.description()).expect("the built-in rows");
            match PairPlan::read(document, index, FILE, size, rows) {
                Ok(plan) => assert!(plan.px_a_cell().is_finite() && plan.px_a_cell() > 0.0),
                Err(error) => return assert_readable(&error.to_string(), FILE),
            }
            beneath = None;
            continue;
        }
        if document.layers[index].is_of_points() {
            if !is_of_points_planned(document, index) {
                return;
            }
            beneath = None;
            continue;
        }
        let targets = match Targets::read(document, index, FILE, size, beneath.as_ref()) {
            Ok(targets) => targets,
            Err(error) => return assert_readable(&error.to_string(), FILE),
        };
        let plan = match targets.look_up(&TRAINING) {
            Ok(plan) => plan,
            Err(error) => return assert!(!error.to_string().is_empty()),
        };
        assert!(plan.grid.size.iter().all(|cells| *cells > 0), "{:?}", plan.grid.size);
        assert!(plan.px_a_cell().is_finite() && plan.px_a_cell() > 0.0);
        for answer in &plan.answers {
            assert!(answer.parameters.named().iter().all(|(_, value)| value.is_finite()), "{answer:?}");
        }
        if let Err(error) = memory::check(plan.system, document.size.map(f64::from), plan.grid.size, MEMORY) {
            assert!(error.needed.is_finite());
        }
        beneath = Some(plan);
    }
}

/// Layer `index`, which a picture or a growth drives, can be planned, or it is said why not; returns whether it can.
fn is_driven(document: &Document, index: usize) -> bool {
    let size = document.size.map(f64::from);
    match TonePlan::read(document, index, FILE, size, (&TRAINING, MEMORY)) {
        Ok(plan) => {
            assert!(plan.px_a_cell().is_finite() && plan.px_a_cell() > 0.0);
            assert!(plan.tone.iter().all(|share| (-0.01..=1.01).contains(share)));
            assert!(plan.directions.iter().all(|(angle, _)| angle.is_finite()));
            true
        }
        Err(TonePlanError::Document(error)) => {
            assert_readable(&error.to_string(), FILE);
            false
        }
        Err(error) => {
            assert!(!error.to_string().is_empty());
            false
        }
    }
}
