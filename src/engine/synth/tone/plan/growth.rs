//! Plans of Turing's growth: its parameter G follows the tone of a picture, or a map.

use crate::document::Document;
use crate::grid::Domain;
use crate::learn::Parameters;
use crate::rd::System;
use crate::synth::drawn::maps::growth_by_map;
use crate::synth::marks::plan::setting::Setting;
use crate::synth::tone::plan::TonePlan;

/// G for no ink and for full ink (`facts.md` V): the share of b > 3 increases with G, but does not reach 0 and 1.
const BY_TONE: [f32; 2] = [18.3, 27.3];

/// The parameters with which `system` grows marks `wavelength` cells apart.
pub(super) fn setting(system: System, wavelength: f64) -> Setting {
    let root = (system.definition().laws.spacing)(1.0) / wavelength;
    let parameters = Parameters { rate: root * root, ratio: None, stretch: 1.0, direction: 0.0, level: None };
    Setting { parameters, pitch: 1.0 }
}

/// The parameter G of each cell of `plan`, of layer `index`: `usual` where neither a picture nor a map changes it.
pub(super) fn growth(plan: &TonePlan, document: &Document, index: usize, usual: f32) -> Vec<f32> {
    if plan.tone.is_empty() {
        return growth_by_map(document, index, &plan.grid, usual)
            .unwrap_or_else(|| vec![usual; plan.grid.cells()]);
    }
    let [none, all] = BY_TONE;
    let [columns, rows] = plan.grid.size;
    let cell = |at: usize, cells: usize, px: usize| ((at as f64 + 0.5) * px as f64 / cells as f64) as usize;
    let of_cell = |index: usize| {
        let [x, y] =
            [cell(index % columns, columns, plan.fine[0]), cell(index / columns, rows, plan.fine[1])];
        none + (all - none) * plan.tone[y * plan.fine[0] + x].clamp(0.0, 1.0)
    };
    (0..plan.grid.cells()).map(of_cell).collect()
}
