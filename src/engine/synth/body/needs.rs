//! What a growth on a model needs, known before the model is remeshed.

use crate::finish::Finish;
use crate::synth::error::{LayerError, TooFine};
use crate::synth::memory;
use crate::synth::options::Options;
use crate::synth::time::TimeLimit;

/// Bytes of a vertex: the surface with its tree, frames and neighbours, the operator in rows and in slices, concentrations. Surfaces
/// of 36,000 to 126,000 vertices took 1,700 to 2,100.
const VERTEX: f64 = 2_500.0;
/// Seconds of one core that a vertex takes: the same surfaces took .11 to .25 ms.
const SECONDS: f64 = 2.5e-4;
/// Seconds that any surface may take.
const LEAST: f64 = 120.0;

/// Vertices of all surfaces of `area` px², one with cells of each of these px.
#[must_use]
pub fn vertices(area: f64, cells: &[f64]) -> f64 {
    cells.iter().map(|cell| area / (cell * cell)).sum()
}

/// Seconds of one core that a growth on so many vertices takes, about.
#[must_use]
pub fn seconds(vertices: f64) -> f64 {
    SECONDS * vertices
}

/// Checks that a growth on surfaces of `area` px², one a layer with cells of these px, fits into memory and time. A surface may take as long as a
/// canvas of its area, and any one two minutes: cells follow the finest marks, whatever the area. A finish that is drawn later counts.
///
/// # Errors
/// It does not: the numbers, and what to change.
pub fn check(area: f64, cells: &[f64], finish: Option<Finish>, options: &Options) -> Result<(), LayerError> {
    let vertices = vertices(area, cells);
    let needed = memory::BASE + VERTEX * vertices;
    if let Some(free) = options.memory.filter(|free| needed > *free) {
        return Err(TooFine::Memory { vertices, needed, free }.into());
    }
    let needed = needed + finish.map_or(0.0, |finish| area * finish.bytes_of_surface());
    if let Some(free) = options.memory.filter(|free| needed > *free) {
        return Err(TooFine::Finish { needed, free }.into());
    }
    let canvas = options.time.seconds([area.sqrt(); 2]);
    let allowed = if options.time == TimeLimit::Usual { canvas.max(LEAST) } else { canvas };
    let needed = seconds(vertices);
    if needed > allowed { Err(TooFine::Time { vertices, needed, allowed }.into()) } else { Ok(()) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::finish::Kind;

    #[test]
    fn a_surface_with_too_many_vertices_is_refused_before_it_is_made() {
        let options = Options { memory: Some(1e9), time: TimeLimit::Usual, ..Options::default() };
        assert!(check(1e6, &[6.0], None, &options).is_ok());
        let fur = Finish { size: 2.0, ..Finish::new(Kind::Fur) };
        let error = check(1e6, &[6.0], Some(fur), &options).unwrap_err().to_string();
        assert!(error.contains("the finish needs about"), "{error}");
        let error = check(1e6, &[0.5], None, &options).unwrap_err().to_string();
        assert!(error.contains("about 4000000 vertices need about 10.1 GB of memory, 1.0 GB"), "{error}");
        let error = check(1e6, &[0.5], None, &Options { memory: None, ..options }).unwrap_err().to_string();
        assert!(
            error.contains("vertices take about 15 min of one core") && error.ends_with("--minutes 17"),
            "{error}"
        );
    }
}
