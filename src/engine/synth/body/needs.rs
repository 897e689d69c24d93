//! What a growth on a model needs, known before the model is remeshed.

use crate::synth::error::LayerError;
use crate::synth::memory;
use crate::synth::options::Options;

/// Bytes of a vertex: the surface with its tree, frames and neighbours, the operator in rows and in slices, concentrations.
const VERTEX: f64 = 2_500.0;
/// Seconds of one core that a vertex takes: remeshing, frames, operators, and 3,400 steps of 10 ns.
const SECONDS: f64 = 1.4e-4;

/// Vertices of a surface of `area` px² with cells of `cell` px.
#[must_use]
pub fn vertices(area: f64, cell: f64) -> f64 {
    area / (cell * cell)
}

/// Bytes that a growth on so many vertices needs.
#[must_use]
pub fn bytes(vertices: f64) -> f64 {
    memory::of_cells(VERTEX, [0.0; 2], [vertices.min(1e15) as usize, 1])
}

/// Seconds of one core that it takes.
#[must_use]
pub fn seconds(vertices: f64) -> f64 {
    vertices * SECONDS
}

/// Checks that a growth on a surface of `area` px² with cells of `cell` px fits into memory and time.
///
/// # Errors
/// It does not: the numbers, and what to change.
pub fn check(area: f64, cell: f64, options: &Options) -> Result<(), LayerError> {
    let count = vertices(area, cell);
    let side = area.sqrt();
    let grid = [count.sqrt().min(1e9) as usize; 2];
    memory::fits(bytes(count), [side; 2], grid, options.memory)?;
    options.time.allows(seconds(count), [side; 2])?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synth::time::TimeLimit;

    #[test]
    fn a_surface_with_too_many_vertices_is_refused_before_it_is_made() {
        let options = Options { memory: Some(1e9), time: TimeLimit::Usual, ..Options::default() };
        assert!(check(1e6, 6.0, &options).is_ok());
        let error = check(1e6, 0.5, &options).unwrap_err().to_string();
        assert!(error.contains("GB of memory"), "{error}");
        let error = check(1e6, 0.1, &Options { memory: None, ..options }).unwrap_err().to_string();
        assert!(error.contains("takes too long"), "{error}");
    }
}
