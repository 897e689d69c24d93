//! Grown layers → the outlines of their marks.

use std::ops::Range;

use crate::document::Document;
use crate::export::Stopped;
use crate::export::outline::{Group, Shape, Smallest, Source, Style, Travel, draw, outline};
use crate::grid::Edges;
use crate::synth::drawn::is_replaced;
use crate::synth::growth::Grown;
use crate::synth::layer::GrownLayer;
use crate::synth::pattern::LayerPattern;
use crate::synth::render::painting::gradient_of;
use crate::synth::warped::warped;
use crate::synth::watch::{Stage, Watch};

/// The pattern value at which a layer's colour is read: well inside a mark, but not at its centre.
const COLOUR_AT: f32 = 0.75;

/// Least number of traced values per cell of the grid along each side: with fewer, the smallest spots lose half a per cent of their
/// area.
const A_CELL: f64 = 2.0;
/// Least number of traced values per cell of the grid along each side, for pairs, areas and tones. The outlines of pairs and areas
/// have corners where threads cross and cells meet; each corner loses the part of a step that is cut off. With two values the holes
/// of a basket lost 0.7 % of their area, and a px at the edge of a small space giraffe had a relative error of 31 % (17 % with
/// four). The marks of tones are a few cells wide, and end where the thresholds of neighbouring px differ much: with two values the
/// dots of a portrait by Turing's growth lost 0.6 % of their area.
const A_CELL_WITH_CORNERS: f64 = 4.0;

/// The marks to be outlined, and the style.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outlining {
    /// The canvas, px.
    pub size: [usize; 2],
    /// The pattern value that the outlines follow: ½ = the marks' edges.
    pub level: f64,
    /// The only layer that is outlined; `None` = all that are visible.
    pub only: Option<usize>,
    /// Marks that are left out.
    pub smallest: Smallest,
    /// Style of the drawing.
    pub style: Style,
}

/// The outlines of the `grown` layers of `document`, a group for each visible layer.
///
/// A layer's marks end at those of the layers beneath, as in its picture. For a seamless document the nearest seamless hatch is
/// used.
///
/// # Errors
/// [`Stopped::Cancelled`].
pub fn outlines(
    document: &Document,
    grown: &Grown,
    wanted: &Outlining,
    watch: &Watch,
) -> Result<(Vec<Group>, Travel), Stopped> {
    let patterns = grown.layers.iter().map(GrownLayer::pattern).collect();
    let patterns: Vec<LayerPattern> = warped(document, grown.size.map(f64::from), patterns);
    let shown = |index: usize| match wanted.only {
        Some(only) => index == only,
        None => document.layers[index].visible && !is_replaced(document, index),
    };
    let mut layers = Vec::new();
    for index in (0..patterns.len()).filter(|index| shown(*index)) {
        let beneath: Vec<&LayerPattern> = (0..index)
            .filter(|beneath| wanted.only.is_none() && !is_replaced(document, *beneath))
            .map(|beneath| &patterns[beneath])
            .collect();
        let done = |share: f64| (index as f64 + share) / patterns.len() as f64;
        let step = |share: f64| watch.step(Stage::Write, done(share)).map_err(|_| Stopped::Cancelled);
        let shapes = layer_shapes(document, &patterns[index], &beneath, wanted, &step)?;
        let layer = &document.layers[index];
        let name = if layer.name.is_empty() { format!("layer {}", index + 1) } else { layer.name.clone() };
        layers.push((name, gradient_of(layer, index).colour(COLOUR_AT), shapes));
    }
    let size = wanted.size.map(|side| side as f64);
    let mut style = wanted.style;
    if document.edges == Edges::Wrap {
        style.hatch = style.hatch.map(|hatch| hatch.seamless(size));
    }
    let drawn = draw(layers, size, &style);
    // Sorting a million strokes takes seconds, during which it may be cancelled.
    watch.step(Stage::Write, 1.0).map_err(|_| Stopped::Cancelled)?;
    Ok(drawn)
}

/// The colour of the ground: that of the topmost visible layer, as in its picture; white without layers.
#[must_use]
pub fn ground(document: &Document) -> [u8; 3] {
    let shown = document
        .layers
        .iter()
        .enumerate()
        .rfind(|(index, layer)| layer.visible && !is_replaced(document, *index));
    let shown = shown.or(document.layers.iter().enumerate().next_back());
    shown.map_or([255; 3], |(index, layer)| gradient_of(layer, index).colour(0.0))
}

/// Number of values that are traced per cell of its grid, along each side.
fn a_cell(pattern: &LayerPattern) -> f64 {
    if pattern.has_corners() { A_CELL_WITH_CORNERS } else { A_CELL }
}

fn layer_shapes(
    document: &Document,
    pattern: &LayerPattern,
    beneath: &[&LayerPattern],
    wanted: &Outlining,
    step: &dyn Fn(f64) -> Result<(), Stopped>,
) -> Result<Vec<Shape>, Stopped> {
    let finest = |axis: usize| {
        let needed = beneath.iter().chain([&pattern]).map(|layer| a_cell(layer) * layer.grid()[axis] as f64);
        needed.map(|values| values as usize).fold(wanted.size[axis], usize::max)
    };
    let [width, height] = [finest(0), finest(1)];
    let level = wanted.level as f32;
    let mut rows = |rows: Range<usize>| {
        step(rows.start as f64 / height as f64)?;
        let mut values = pattern.rows(rows.clone(), width, height);
        for value in &mut values {
            *value -= level;
        }
        for layer in beneath {
            // Outside the mark, or inside a mark beneath.
            for (value, taken) in values.iter_mut().zip(layer.rows(rows.clone(), width, height)) {
                *value = value.min(level - taken);
            }
        }
        Ok(values)
    };
    let extent = wanted.size.map(|side| side as f64);
    let mut source = Source { size: [width, height], extent, edges: document.edges, rows: &mut rows };
    outline(&mut source, 0.0, wanted.smallest)
}
