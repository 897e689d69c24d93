//! The concentrations of all chemicals → OpenEXR.

use std::io::{Seek, Write};

use crate::export::{self, Stopped, exr};
use crate::grid::resample::Spline;
use crate::synth::growth::Grown;
use crate::synth::watch::{Stage, Watch};

/// Writes the concentrations of `grown` as OpenEXR (grown with [`crate::synth::Options::concentrations`]) at `size` px: a channel a
/// chemical, called `LAYER.CHEMICAL` by the layer's name and its letter in the equations; of pairs, `C1+`, `C1-`, `C2+` and so on.
/// Values are the solver's own, interpolated by cubic splines.
///
/// # Errors
/// `out` cannot be written to; or it was cancelled.
pub fn concentrations(
    grown: &Grown,
    out: impl Write + Seek,
    size: [usize; 2],
    dpi: f64,
    watch: &Watch,
) -> Result<(), Stopped> {
    let mut names: Vec<String> = Vec::new();
    let mut splines = Vec::new();
    for (index, layer) in grown.layers.iter().enumerate() {
        let named = grown.document.layers.get(index).map_or("", |layer| &layer.name);
        let plain = export::material::name(named);
        let taken = |name: &str| names.iter().any(|other| other.starts_with(&format!("{name}.")));
        let name = if named.is_empty() || taken(&plain) { format!("layer-{}", index + 1) } else { plain };
        for (letter, values) in layer.chemicals() {
            names.push(format!("{name}.{letter}"));
            splines.push(Spline::new(&values));
        }
    }
    exr::write(out, size, &names, Some(dpi), |rows, planes| {
        let done = rows.start as f64 / size[1] as f64;
        watch.step(Stage::Write, done).map_err(|_| Stopped::Cancelled)?;
        for (plane, spline) in planes.iter_mut().zip(&splines) {
            *plane = spline.rows(rows.clone(), size[0], size[1]);
        }
        Ok(())
    })
}
