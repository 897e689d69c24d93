//! Stripes that have the directions and distances of threads: the lines that these begin along where no phase has them.

use crate::document::{Document, Layer, LayerOptions, Stroke, SystemChoice};
use crate::marks::Path;
use crate::rd::System;
use crate::synth::pairs::plan::thread_map::ThreadMap;

/// A document of stripes as far apart as these threads, half as wide as they are apart, which all begin where lines are drawn.
pub(super) fn stripes_of(document: &Document, threads: &ThreadMap, seed: u64, index: usize) -> Document {
    let own = &document.layers[index].strokes;
    let stroke = |(mark, line): &(usize, Path)| {
        let here = threads.threads_at(line.center());
        let width = 0.5 * here.period;
        match own[*mark].mark().and_then(|mark| mark.path()) {
            Some(path) => Stroke::Path(Path { width, ..path }),
            None => Stroke::Path(Path { width, ..line.clone() }),
        }
    };
    // Those that are as wide as their gaps.
    let striped = System::first(|system| system.is_striped() && !system.free_spacing);
    let layer = Layer {
        system: striped.map_or(SystemChoice::Auto, |system| SystemChoice::Of(system.description())),
        seed: Some(seed),
        strokes: threads.lines.iter().map(stroke).collect(),
        options: LayerOptions::default(),
        ..Layer::default()
    };
    Document {
        size: document.size,
        regions: document.regions,
        edges: document.edges,
        seed: document.seed,
        layers: vec![layer],
        ..Document::default()
    }
}
