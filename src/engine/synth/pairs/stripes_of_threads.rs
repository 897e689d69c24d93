//! Stripes with the directions and distances of threads. Threads that follow no phase begin along such stripes.

use crate::document::{Document, Layer, LayerOptions, Stroke, SystemChoice};
use crate::marks::Path;
use crate::synth::error::LayerError;
use crate::synth::kind::{Kind, Request};
use crate::synth::marks::Marks;
use crate::synth::pairs::grown::ThreadPhase;
use crate::synth::pairs::plan::PairPlan;
use crate::synth::pairs::plan::thread_map::ThreadMap;

/// The needs of the stripes along which threads begin: bytes of memory for the largest of them, and seconds on one core for all.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StripesNeed {
    /// Bytes of memory.
    pub bytes: f64,
    /// Seconds that growing them takes.
    pub seconds: f64,
}

/// Needs up to which it is not tested whether the stripes are grown at all, since the test takes about as long as growing them.
const LITTLE: StripesNeed = StripesNeed { bytes: 2e8, seconds: 1.0 };

/// The needs of the stripes that have to be grown for the threads of `plan`, which belongs to `request`; nothing if all threads
/// follow phases.
///
/// # Errors
/// They cannot be planned.
pub(super) fn needed_by_stripes(request: &Request, plan: &PairPlan) -> Result<StripesNeed, LayerError> {
    let mut all = StripesNeed::default();
    let seed = request.document.layer_seed(request.index);
    for threads in plan.threads.iter().filter(|_| plan.crosses()) {
        let document = stripes_of(request.document, threads, seed, request.index);
        let stripes = Marks::read(&Request { document: &document, index: 0, beneath: None, ..*request });
        let need = stripes.map(|stripes| StripesNeed {
            bytes: Marks::bytes(&stripes, request.size, Marks::planned(&stripes).grid.size),
            seconds: Marks::seconds(&stripes),
        });
        let is_little = |need: &StripesNeed| need.bytes < LITTLE.bytes && need.seconds < LITTLE.seconds;
        if need.as_ref().is_ok_and(is_little) || ThreadPhase::new(threads, &plan.canvas()).is_some() {
            continue;
        }
        let need = need?;
        all = StripesNeed { bytes: all.bytes.max(need.bytes), seconds: all.seconds + need.seconds };
    }
    Ok(all)
}

/// A document of stripes at the distance of these threads, half as wide as their period, which all begin at drawn lines.
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
    // The system of stripes that are as wide as their gaps.
    let striped = SystemChoice::system_of_stripes(false);
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
